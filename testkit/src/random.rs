//! A small seeded generator: the same rays on every machine, in every version of every dependency. With
//! `SCANCSG_SEED`, which `cargo xtask search` sets, they are others.

use std::env;
use std::f64::consts::TAU;

/// SplitMix64 (Steele, Lea, Flood 2014).
pub struct Random(u64);

impl Random {
    /// A stream of its own for every name, so that one set's rays don't depend on another's.
    pub fn named(name: &str) -> Self {
        let fnv = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        Self::seeded(name.bytes().fold(0xcbf2_9ce4_8422_2325, fnv))
    }

    pub fn seeded(seed: u64) -> Self {
        let other = env::var("SCANCSG_SEED").ok().map_or(0, |text| text.parse::<u32>().unwrap());
        Self(seed ^ (u64::from(other) << 32))
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in [low, high).
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        let unit = (self.next() >> 11) as f64 / (1u64 << 53) as f64;
        low + (high - low) * unit
    }

    pub fn chance(&mut self, probability: f64) -> bool {
        self.between(0.0, 1.0) < probability
    }

    pub fn sign(&mut self) -> f64 {
        if self.chance(0.5) { 1.0 } else { -1.0 }
    }

    pub fn below(&mut self, n: usize) -> usize {
        self.between(0.0, n as f64) as usize
    }

    /// A point of the cube whose sides are `2·size` long.
    pub fn point(&mut self, size: f64) -> [f64; 3] {
        [(); 3].map(|()| self.between(-size, size))
    }

    /// A uniform unit vector across the x axis: (0, y, z).
    pub fn across(&mut self) -> [f64; 3] {
        let (sin, cos) = self.between(0.0, TAU).sin_cos();
        [0.0, cos, sin]
    }

    /// A uniform unit vector: by Archimedes, its x is uniform.
    pub fn direction(&mut self) -> [f64; 3] {
        let x = self.between(-1.0, 1.0);
        let [_, y, z] = self.across();
        let rest = (1.0 - x * x).sqrt();
        [x, rest * y, rest * z]
    }
}

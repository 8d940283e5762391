//! Numbers without a pattern, the same on every machine.

/// SplitMix64 (G. Steele, D. Lea, C. Flood, OOPSLA 2014).
#[derive(Debug)]
pub(super) struct Random(pub(super) u64);

impl Random {
    /// 32 even bits.
    fn next(&mut self) -> u32 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((mixed ^ (mixed >> 31)) >> 32) as u32
    }

    /// A number less than `n`, and 0 for 0.
    pub(super) fn below(&mut self, n: u32) -> u32 {
        ((u64::from(self.next()) * u64::from(n)) >> 32) as u32
    }

    /// True in this share of times. A rate of 0 or less, or NaN, is never; a rate of 1 or more is always.
    pub(super) fn chance(&mut self, share: f32) -> bool {
        const TWO_TO_THE_32: f32 = 4_294_967_296.0;
        // Nothing is drawn for what never happens, so that one fault does not change another one's places.
        share > 0.0 && u64::from(self.next()) < (share * TWO_TO_THE_32) as u64
    }
}

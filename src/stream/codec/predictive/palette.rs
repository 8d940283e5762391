//! Symbols of colours: the chains of pixels that a scene's base colours have.
//!
//! A base colour's chain are the different pixels that it has at the levels 0 to 255, from dark to light. The
//! symbol of a pixel is its index in all chains, one after the other. So a shaded surface is a smooth
//! landscape of symbols, whatever its colour.

use super::alphabet::{Alphabet, Channels};
use crate::render::{Rgb, Rgb565, Rgb888};

impl Channels for Rgb565 {
    type Bytes = [u8; 2];

    fn channels(self) -> [i32; 3] {
        [self.0 >> 11, self.0 >> 5 & 63, self.0 & 31].map(i32::from)
    }

    fn with_channels([r, g, b]: [i32; 3]) -> Self {
        let [r, g, b] = [(r, 31), (g, 63), (b, 31)].map(|(c, most)| c.clamp(0, most) as u16);
        Self(r << 11 | g << 5 | b)
    }

    fn bytes(self) -> [u8; 2] {
        self.0.to_le_bytes()
    }
}

impl Channels for Rgb888 {
    type Bytes = [u8; 3];

    fn channels(self) -> [i32; 3] {
        self.0.map(i32::from)
    }

    fn with_channels(channels: [i32; 3]) -> Self {
        Self(channels.map(|channel| channel.clamp(0, u8::MAX.into()) as u8))
    }

    fn bytes(self) -> [u8; 3] {
        self.0
    }
}

/// One base colour's chain.
#[derive(Debug, Clone, Copy)]
struct Chain {
    color: Rgb,
    /// The symbol of its first pixel.
    first: u16,
    /// A bit for each level: whether its pixel differs from the one before.
    steps: [u32; 8],
}

impl Chain {
    const EMPTY: Self = Self { color: Rgb::new(0, 0, 0), first: 0, steps: [0; 8] };

    /// The pixel at a level. Not inlined: it is asked for in many places, and long.
    #[inline(never)]
    fn pixel<P: Channels>(&self, level: u8) -> P {
        P::shaded(self.color, level)
    }

    fn of<P: Channels>(color: Rgb, first: u16) -> Self {
        let mut new = Self { color, first, steps: [0; 8] };
        let mut steps = [0; 8];
        let mut last: Option<P> = None;
        for (word, levels) in steps.iter_mut().zip((0..=u8::MAX).step_by(32)) {
            for bit in 0..32 {
                let pixel = new.pixel(levels + bit);
                *word |= u32::from(last != Some(pixel)) << bit;
                last = Some(pixel);
            }
        }
        new.steps = steps;
        new
    }

    fn len(&self) -> u16 {
        self.steps.iter().map(|word| ones(*word) as u16).sum()
    }

    /// The symbol of the pixel at a level.
    fn symbol(&self, level: u8) -> u16 {
        let (words, bits) = (usize::from(level / 32), u32::from(level % 32));
        let before: u32 = self.steps.iter().take(words).map(|word| ones(*word)).sum();
        let word = self.steps.get(words).copied().unwrap_or(0);
        self.first + (before + ones(word & (u32::MAX >> (31 - bits)))) as u16 - 1
    }

    /// A level at which the pixel has this symbol: the darkest one.
    fn level(&self, symbol: u16) -> u8 {
        let mut left = u32::from(symbol.saturating_sub(self.first));
        let mut level = 0;
        for word in self.steps {
            let mut word = word;
            let count = ones(word);
            if left < count {
                (0..left).for_each(|_| word &= word - 1);
                return (level + word.trailing_zeros()) as u8;
            }
            left -= count;
            level += 32;
        }
        u8::MAX
    }
}

/// How many pixels an encoder remembers the symbols of.
const CACHE: usize = 64;

/// In a remembered symbol: the pixel isn't in the chains, and the symbol is that of a near one.
const IS_NEAR: u16 = 0x8000;

/// The symbols of all pixels that up to `N` base colours have.
#[derive(Debug, Clone)]
pub struct Palette<P, const N: usize> {
    chains: [Chain; N],
    colors: usize,
    top: u16,
    /// Pixels whose symbols were looked for last, by the sum of their channels.
    pixels: [P; CACHE],
    symbols: [u16; CACHE],
}

impl<P: Channels, const N: usize> Palette<P, N> {
    /// The chains of these base colours, or white's if there are none. Of more than `N`, the others are
    /// ignored: their pixels are escapes.
    pub(crate) fn new(colors: &[Rgb]) -> Self {
        // Symbols have 15 bits.
        const { assert!(0 < N && N < 128) };
        let white = [Rgb::new(255, 255, 255)];
        let colors = if colors.is_empty() { &white } else { colors };
        let mut chains = [Chain::EMPTY; N];
        let mut first = 0;
        for (chain, color) in chains.iter_mut().zip(colors) {
            *chain = Chain::of::<P>(*color, first);
            first += chain.len();
        }
        // Every chain begins with black.
        let black = P::shaded(Rgb::new(0, 0, 0), 0);
        Self {
            chains,
            colors: colors.len().min(N),
            top: first.saturating_sub(1),
            pixels: [black; CACHE],
            symbols: [0; CACHE],
        }
    }

    /// No chains, for constants: with this pixel for all.
    pub(crate) const fn empty(pixel: P) -> Self {
        let (chains, pixels) = ([Chain::EMPTY; N], [pixel; CACHE]);
        Self { chains, colors: 0, top: 0, pixels, symbols: [0; CACHE] }
    }

    fn chains(&self) -> &[Chain] {
        self.chains.get(..self.colors).unwrap_or_default()
    }
}

/// How many bits are set: code that small cores have no instruction for, once.
#[inline(never)]
fn ones(word: u32) -> u32 {
    word.count_ones()
}

fn sum<P: Channels>(pixel: P) -> i32 {
    pixel.channels().iter().sum()
}

fn distance<P: Channels>(a: P, b: P) -> u32 {
    a.channels().iter().zip(b.channels()).map(|(a, b)| a.abs_diff(b)).sum()
}

/// The symbol of the pixel that is nearest, of the chains' pixels next to it by the sum of channels; and
/// whether it is the pixel itself. The first of several wins.
#[cold]
#[inline(never)]
fn nearest<P: Channels>(chains: &[Chain], pixel: P) -> u16 {
    let wanted = sum(pixel);
    let (mut symbol, mut least) = (IS_NEAR, u32::MAX);
    for chain in chains {
        // Along a chain, the sum grows from each pixel to the next.
        let darker = |level: u8| sum(chain.pixel::<P>(level)) < wanted;
        let level = (0..8).rev().fold(0, |level: u8, bit| {
            let half = 1 << bit;
            if darker(level + (half - 1)) { level + half } else { level }
        });
        for level in [level, level.saturating_sub(1)] {
            let off = distance(chain.pixel(level), pixel);
            if off < least {
                symbol = chain.symbol(level) | if off == 0 { 0 } else { IS_NEAR };
                least = off;
            }
        }
        if least == 0 {
            break;
        }
    }
    symbol
}

#[cold]
#[inline(never)]
fn pixel<P: Channels>(chains: &[Chain], symbol: u16) -> P {
    let of = chains.iter().rev().find(|chain| chain.first <= symbol);
    of.map_or(P::shaded(Rgb::new(0, 0, 0), 0), |chain| chain.pixel(chain.level(symbol)))
}

impl<P: Channels, const N: usize> Alphabet for Palette<P, N> {
    type Pixel = P;
    type Symbol = u16;
    const ESCAPES: bool = true;

    fn top(&self) -> i32 {
        self.top.into()
    }

    fn symbol(&mut self, pixel: P) -> (i32, bool) {
        let place = sum(pixel) as usize % CACHE;
        let symbol = match (self.pixels.get(place), self.symbols.get(place)) {
            (Some(known), Some(symbol)) if *known == pixel => *symbol,
            _ => {
                let symbol = nearest(self.chains(), pixel);
                self.pixels.iter_mut().skip(place).take(1).for_each(|place| *place = pixel);
                self.symbols.iter_mut().skip(place).take(1).for_each(|place| *place = symbol);
                symbol
            }
        };
        (i32::from(symbol & !IS_NEAR), symbol & IS_NEAR == 0)
    }

    fn pixel(&self, symbol: i32) -> P {
        pixel(self.chains(), symbol as u16)
    }

    fn kept(symbol: i32) -> u16 {
        symbol as u16
    }
}

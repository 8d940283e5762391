//! Pixels as the coder sees them: numbers whose neighbours look alike.

use crate::render::{Gray8, Pixel};
use core::marker::PhantomData;

/// A pixel made of three channels.
pub trait Channels: Pixel + PartialEq {
    /// Its bytes on the link.
    type Bytes: AsRef<[u8]>;

    /// The channels.
    fn channels(self) -> [i32; 3];

    /// The pixel with the nearest channels that there are.
    fn with_channels(channels: [i32; 3]) -> Self;

    /// Its bytes on the link.
    fn bytes(self) -> Self::Bytes;
}

/// What symbols a frame's pixels have.
pub trait Alphabet {
    /// The pixels.
    type Pixel: Channels;
    /// A symbol as it is kept of the row above.
    type Symbol: Copy + Into<i32>;
    /// Whether there are pixels without a symbol of their own.
    const ESCAPES: bool;

    /// The largest symbol.
    fn top(&self) -> i32;

    /// The symbol of a pixel, and whether it is just this pixel's and not that of a near one.
    fn symbol(&mut self, pixel: Self::Pixel) -> (i32, bool);

    /// The pixel of a symbol.
    fn pixel(&self, symbol: i32) -> Self::Pixel;

    /// A symbol for the memory of the row above.
    fn kept(symbol: i32) -> Self::Symbol;
}

impl Channels for Gray8 {
    type Bytes = [u8; 1];

    fn channels(self) -> [i32; 3] {
        [self.0.into(); 3]
    }

    fn with_channels([level, _, _]: [i32; 3]) -> Self {
        Self(level.clamp(0, u8::MAX.into()) as u8)
    }

    fn bytes(self) -> [u8; 1] {
        [self.0]
    }
}

/// Grey levels: each is its own symbol, kept as a `T`.
#[derive(Debug, Clone, Copy)]
pub struct Levels<T = u8>(pub(crate) PhantomData<T>);

impl<T: Copy + From<u8> + Into<i32>> Alphabet for Levels<T> {
    type Pixel = Gray8;
    type Symbol = T;
    const ESCAPES: bool = false;

    fn top(&self) -> i32 {
        u8::MAX.into()
    }

    fn symbol(&mut self, pixel: Gray8) -> (i32, bool) {
        (pixel.0.into(), true)
    }

    fn pixel(&self, symbol: i32) -> Gray8 {
        Gray8(symbol as u8)
    }

    fn kept(symbol: i32) -> T {
        (symbol as u8).into()
    }
}

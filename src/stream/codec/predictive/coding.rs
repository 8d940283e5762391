//! Prediction as a sender's way to code rows.

use core::marker::PhantomData;

use super::alphabet::{Alphabet, Levels};
use super::palette::Palette;
use super::{BilevelEncoder, RowsEncoder};
use crate::render::{self, Gray8, Mono, Rgb565, Rgb888};
use crate::stream::codec::coding::{Coding, RowCoding};
use crate::stream::pixel::{Wire, WirePixel};

/// Several rows in a packet, each pixel predicted from its neighbours: a quarter of the bytes of
/// [`Plain`](crate::stream::Plain), for rows of up to `W` pixels.
///
/// `P` is the pixel of the link: [`Gray8`], [`Rgb565`] or [`Rgb888`]. For [`Mono`], there is
/// [`PredictiveMono`]. A row that is wider than `W`, or too long for a packet of several rows, is sent by
/// itself.
///
/// | for | memory, besides the sender's packet of 256 bytes |
/// |---|---|
/// | [`Gray8`] | 772 + W bytes |
/// | [`Rgb565`] | 1,170 + 2 W bytes |
///
/// ```
/// use scancsg::render::Gray8;
/// use scancsg::stream::{Patience, Predictive, Sender};
///
/// let patience = Patience { ticks: 500_000, silences: 3 };
/// let sender = Sender::<_, 256>::new(Predictive::<Gray8, 160>::new(), patience);
/// assert!(size_of_val(&sender) < 1400);
/// ```
pub struct Predictive<P: Predictable, const W: usize> {
    encoder: RowsEncoder<P>,
    alphabet: P::Alphabet,
    above: [<P::Alphabet as Alphabet>::Symbol; W],
}

/// A pixel of the link whose rows can be predicted: [`Gray8`], [`Rgb565`] or [`Rgb888`].
pub trait Predictable: Wire {
    #[doc(hidden)]
    type Alphabet: Alphabet<Pixel = Self>;
    #[doc(hidden)]
    const UNKNOWN: Self::Alphabet;
    #[doc(hidden)]
    const NONE: <Self::Alphabet as Alphabet>::Symbol;

    #[doc(hidden)]
    fn alphabet(palette: &render::Palette) -> Self::Alphabet;
}

impl Predictable for Gray8 {
    type Alphabet = Levels;
    const UNKNOWN: Levels = Levels(PhantomData);
    const NONE: u8 = 0;

    fn alphabet(_: &render::Palette) -> Levels {
        Self::UNKNOWN
    }
}

macro_rules! colored {
    ($pixel:ident, $black:expr) => {
        impl Predictable for $pixel {
            type Alphabet = Palette<$pixel, { render::Palette::CAPACITY }>;
            const UNKNOWN: Self::Alphabet = Palette::empty($black);
            const NONE: u16 = 0;

            fn alphabet(palette: &render::Palette) -> Self::Alphabet {
                Palette::new(palette)
            }
        }
    };
}

colored!(Rgb565, Rgb565(0));
colored!(Rgb888, Rgb888([0; 3]));

impl<P: Predictable, const W: usize> Predictive<P, W> {
    /// Ready for a first frame.
    #[must_use]
    pub const fn new() -> Self {
        Self { encoder: RowsEncoder::new(), alphabet: P::UNKNOWN, above: [P::NONE; W] }
    }
}

impl<P: Predictable, const W: usize> Default for Predictive<P, W> {
    fn default() -> Self {
        Self::new()
    }
}

impl<P: Predictable, const W: usize> Coding for Predictive<P, W> {
    fn begin_frame(&mut self, palette: &render::Palette) {
        self.alphabet = P::alphabet(palette);
    }

    fn begin(&mut self) {
        self.encoder.begin();
    }

    fn finish(&mut self, payload: &mut [u8]) -> usize {
        self.encoder.finish(payload)
    }
}

impl<P: Predictable, const W: usize, T: WirePixel<Wire = P>> RowCoding<T> for Predictive<P, W> {
    fn push(&mut self, pixels: &[T], payload: &mut [u8]) -> bool {
        self.encoder.push(&mut self.alphabet, &mut self.above, pixels, payload)
    }
}

/// As [`Predictive`], for pixels of one bit ([`Mono`]). `B` is the number of bytes of a row: an eighth of
/// its width, rounded up.
///
/// It takes 1,024 + B bytes of memory.
pub struct PredictiveMono<const B: usize> {
    encoder: BilevelEncoder,
    above: [u8; B],
}

impl<const B: usize> PredictiveMono<B> {
    /// Ready for a first frame.
    #[must_use]
    pub const fn new() -> Self {
        Self { encoder: BilevelEncoder::new(), above: [0; B] }
    }
}

impl<const B: usize> Default for PredictiveMono<B> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const B: usize> Coding for PredictiveMono<B> {
    fn begin_frame(&mut self, _: &render::Palette) {}

    fn begin(&mut self) {
        self.encoder.begin(&mut self.above);
    }

    fn finish(&mut self, payload: &mut [u8]) -> usize {
        self.encoder.finish(payload)
    }
}

impl<const B: usize, T: WirePixel<Wire = Mono>> RowCoding<T> for PredictiveMono<B> {
    fn push(&mut self, pixels: &[T], payload: &mut [u8]) -> bool {
        let is_lit = |x: usize| pixels.get(x).is_some_and(|pixel| pixel.to_wire().0);
        self.encoder.push(&mut self.above, pixels.len(), is_lit, payload)
    }
}

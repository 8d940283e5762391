//! Prediction as a sender's way to code rows.

use core::marker::PhantomData;

use super::alphabet::{Alphabet, Levels};
use super::bilevel;
use super::model::{Model, SLOTS};
use super::palette::Palette;
use super::range::{Encoder, Interval};
use super::rows::{self, Line, Start};
use super::start::START;
use crate::render::{self, Gray8, Mono, Rgb565, Rgb888};
use crate::stream::codec::coding::{Coding, RowCoding};
use crate::stream::pixel::{Wire, WirePixel};

/// A payload in the making: probabilities, and how far it is.
struct Payload<const N: usize> {
    model: Model<N>,
    interval: Interval,
}

impl<const N: usize> Payload<N> {
    /// Memory only.
    const EMPTY: Self = Self { model: Model::EMPTY, interval: Interval::EMPTY };

    /// Begins a payload in the place of the last one: a copy of a model costs its size in stack.
    fn restart(&mut self, start: &[u8; N]) {
        self.model.restart(start);
        self.interval = Interval::ALL;
    }

    /// Adds a row, or leaves the payload as it is. Returns whether the row fits.
    fn add(&mut self, out: &mut [u8], code: impl FnOnce(&mut Encoder<'_, N>)) -> bool {
        let mut coder = Encoder::resume(&mut self.model, self.interval, out);
        code(&mut coder);
        let end = coder.fits();
        self.interval = end.unwrap_or(self.interval);
        end.is_some()
    }
}

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
    payload: Payload<SLOTS>,
    /// The first pixel of the row before, if there is one in the payload.
    left: Option<P>,
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
        Self { payload: Payload::EMPTY, left: None, alphabet: P::UNKNOWN, above: [P::NONE; W] }
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
        self.payload.restart(&START);
        self.left = None;
    }

    fn finish(&mut self, payload: &mut [u8]) -> usize {
        self.payload.interval.finish(payload)
    }
}

impl<P: Predictable, const W: usize, T: WirePixel<Wire = P>> RowCoding<T> for Predictive<P, W> {
    fn push(&mut self, pixels: &[T], payload: &mut [u8]) -> bool {
        let Self { alphabet, left, .. } = self;
        let Some(above) = self.above.get_mut(..pixels.len()) else { return false };
        let start =
            Start { left: left.unwrap_or_else(|| alphabet.pixel(0)), is_first: left.is_none() };
        *left = pixels.first().map(|left| left.to_wire());
        let line = &mut Source(pixels);
        self.payload.add(payload, |coder| rows::code(coder, alphabet, above, line, start))
    }
}

/// A row that is read.
struct Source<'a, P>(&'a [P]);

impl<P: WirePixel> Line<P::Wire> for Source<'_, P> {
    #[inline(always)]
    fn get(&self, x: usize) -> Option<P::Wire> {
        self.0.get(x).map(|pixel| pixel.to_wire())
    }

    #[inline(always)]
    fn holds(&self, from: usize, to: usize, pixel: P::Wire) -> bool {
        let pixels = self.0.get(from..to).unwrap_or_default();
        pixels.iter().all(|held| held.to_wire() == pixel)
    }

    #[inline(always)]
    fn fill(&mut self, _: usize, _: usize, _: P::Wire) {}
}

/// As [`Predictive`], for pixels of one bit ([`Mono`]). `B` is the number of bytes of a row: an eighth of
/// its width, rounded up.
///
/// It takes 1,024 + B bytes of memory.
pub struct PredictiveMono<const B: usize> {
    payload: Payload<{ bilevel::CONTEXTS }>,
    /// The row above: 8 pixels a byte.
    above: [u8; B],
}

impl<const B: usize> PredictiveMono<B> {
    /// Ready for a first frame.
    #[must_use]
    pub const fn new() -> Self {
        Self { payload: Payload::EMPTY, above: [0; B] }
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
        self.payload.restart(&bilevel::START);
        self.above.fill(0);
    }

    fn finish(&mut self, payload: &mut [u8]) -> usize {
        self.payload.interval.finish(payload)
    }
}

impl<const B: usize, T: WirePixel<Wire = Mono>> RowCoding<T> for PredictiveMono<B> {
    fn push(&mut self, pixels: &[T], payload: &mut [u8]) -> bool {
        let width = pixels.len();
        let Some(above) = self.above.get_mut(..width.div_ceil(8)) else { return false };
        let is_lit = |x: usize| pixels.get(x).is_some_and(|pixel| pixel.to_wire().0);
        self.payload.add(payload, |coder| bilevel::code(coder, above, width, is_lit))
    }
}

//! Rows by prediction: several rows in one payload, of a fourth or less of what PackBits takes.
//!
//! A pixel becomes a symbol (`alphabet.rs`, `palette.rs`), a symbol decisions about how far it is from its
//! prediction (`rows.rs`), and a decision with its adaptive probability (`model.rs`, `start.rs`) a part of
//! the payload (`range.rs`). Pixels of one bit have decisions of their own (`bilevel.rs`). Every payload is
//! decoded alone. The repository's `docs/link.md` says all of it byte by byte.

mod alphabet;
mod bilevel;
mod coding;
mod model;
mod palette;
mod range;
mod rows;
mod start;
mod unpack;

use crate::stream::pixel::{Wire, WirePixel};
use alphabet::Alphabet;
pub use coding::{Predictable, Predictive, PredictiveMono};
use model::{Model, SLOTS};
use range::{Decoder, Encoder, Interval};
use rows::{Line, Start};
use start::START;
pub(in crate::stream) use unpack::unpack;

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

/// Rows on their way into a payload. The memory for symbols, as wide as a row, is the caller's.
pub(crate) struct RowsEncoder<P> {
    payload: Payload<SLOTS>,
    /// The first pixel of the row before, if there is one in the payload.
    left: Option<P>,
}

impl<P: Wire> RowsEncoder<P> {
    /// Before its first payload.
    pub(crate) const fn new() -> Self {
        Self { payload: Payload::EMPTY, left: None }
    }

    /// Begins a payload.
    pub(crate) fn begin(&mut self) {
        self.payload.restart(&START);
        self.left = None;
    }

    /// Adds a row to the payload in `out`. Returns whether it fits; if not, the payload can be finished
    /// without it, and nothing else.
    pub(crate) fn push<A: Alphabet<Pixel = P>>(
        &mut self,
        alphabet: &mut A,
        above: &mut [A::Symbol],
        row: &[impl WirePixel<Wire = P>],
        out: &mut [u8],
    ) -> bool {
        let Some(above) = above.get_mut(..row.len()) else { return false };
        let is_first = self.left.is_none();
        let start = Start { left: self.left.unwrap_or_else(|| alphabet.pixel(0)), is_first };
        self.left = row.first().map(|left| left.to_wire());
        self.payload.add(out, |coder| rows::code(coder, alphabet, above, &mut Source(row), start))
    }

    /// Ends the payload in `out` with the rows that fit. Returns its length.
    pub(crate) fn finish(&self, out: &mut [u8]) -> usize {
        self.payload.interval.finish(out)
    }
}

/// Rows of pixels of one bit on their way into a payload.
pub(crate) struct BilevelEncoder(Payload<{ bilevel::CONTEXTS }>);

impl BilevelEncoder {
    /// Before its first payload.
    pub(crate) const fn new() -> Self {
        Self(Payload::EMPTY)
    }

    /// Begins a payload. `above` is the memory of the row above: 8 pixels a byte.
    pub(crate) fn begin(&mut self, above: &mut [u8]) {
        self.0.restart(&bilevel::START);
        above.fill(0);
    }

    /// Adds a row to the payload in `out`, as [`RowsEncoder::push`] does.
    pub(crate) fn push(
        &mut self,
        above: &mut [u8],
        width: usize,
        pixel: impl Fn(usize) -> bool,
        out: &mut [u8],
    ) -> bool {
        let Some(above) = above.get_mut(..width.div_ceil(8)) else { return false };
        self.0.add(out, |coder| bilevel::code(coder, above, width, pixel))
    }

    /// Ends the payload in `out` with the rows that fit. Returns its length.
    pub(crate) fn finish(&self, out: &mut [u8]) -> usize {
        self.0.interval.finish(out)
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

/// Rows out of a payload. Any payload gives some rows.
pub(crate) struct RowsDecoder<'a, P> {
    coder: Decoder<'a>,
    start: Option<Start<P>>,
}

impl<'a, P: Copy + PartialEq> RowsDecoder<'a, P> {
    /// At the first row of a payload. The model is memory only.
    pub(crate) fn new(model: &'a mut Model, payload: &'a [u8]) -> Self {
        model.restart(&START);
        Self { coder: Decoder::new(model, payload), start: None }
    }

    /// Decodes the next row into the bytes of its pixels. `above` is the memory for symbols, as wide as the
    /// row.
    pub(crate) fn row<A: Alphabet<Pixel = P>>(
        &mut self,
        alphabet: &mut A,
        above: &mut [A::Symbol],
        row: &mut [u8],
    ) {
        let start = self.start.unwrap_or(Start { left: alphabet.pixel(0), is_first: true });
        let mut line = Sink { row, bytes: A::bytes, first: start.left };
        rows::code(&mut self.coder, alphabet, above, &mut line, start);
        self.start = Some(Start { left: line.first, is_first: false });
    }

    /// Whether the payload has just the bytes that its rows need.
    pub(crate) fn is_exact(&self) -> bool {
        self.coder.is_exact()
    }
}

/// Rows of pixels of one bit out of a payload. Any payload gives some rows.
pub(crate) struct BilevelDecoder<'a>(Decoder<'a, { bilevel::CONTEXTS }>);

impl<'a> BilevelDecoder<'a> {
    /// At the first row of a payload. The model is memory only, and so is what is `above`.
    pub(crate) fn new(
        model: &'a mut Model<{ bilevel::CONTEXTS }>,
        above: &mut [u16],
        payload: &'a [u8],
    ) -> Self {
        model.restart(&bilevel::START);
        above.fill(0);
        Self(Decoder::new(model, payload))
    }

    /// Decodes the next row: `above` holds its bytes then.
    pub(crate) fn row(&mut self, above: &mut [u16], width: usize) {
        bilevel::code(&mut self.0, above, width, |_| false);
    }

    /// Whether the payload has just the bytes that its rows need.
    pub(crate) fn is_exact(&self) -> bool {
        self.0.is_exact()
    }
}

/// A row that is written, as bytes.
struct Sink<'a, P, F> {
    row: &'a mut [u8],
    bytes: F,
    /// The pixel in the first column.
    first: P,
}

impl<P: Copy, B: AsRef<[u8]>, F: Fn(P) -> B> Line<P> for Sink<'_, P, F> {
    fn get(&self, _: usize) -> Option<P> {
        None
    }

    fn holds(&self, _: usize, _: usize, _: P) -> bool {
        false
    }

    fn fill(&mut self, from: usize, to: usize, pixel: P) {
        if from == 0 {
            self.first = pixel;
        }
        let bytes = (self.bytes)(pixel);
        let bytes = bytes.as_ref();
        let (from, to) = (from * bytes.len(), to * bytes.len());
        let places = self.row.get_mut(from..to).unwrap_or_default();
        for (to, byte) in places.iter_mut().zip(bytes.iter().cycle()) {
            *to = *byte;
        }
    }
}

#[cfg(test)]
mod reference;
#[cfg(test)]
mod tests;

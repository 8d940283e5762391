//! Rows of any format out of a payload, into a frame's memory.

use core::marker::PhantomData;

use super::alphabet::{Alphabet, Channels, Levels};
use super::bilevel;
use super::model::{Model, SLOTS};
use super::palette::Palette;
use super::range::Decoder;
use super::rows::{self, Line, Start};
use super::start::START;
use crate::render::{self, Rgb565, Rgb888};
use crate::stream::error::UnpackError;
use crate::stream::pixel::PixelFormat;

/// Decodes rows of `width` pixels into `rows`, one behind the other; those that are `here` already stay as
/// they are. `above` is memory only.
///
/// # Errors
///
/// [`UnpackError::NoMemory`] if `above` is not as wide as a row; nothing is written then.
/// [`UnpackError::TooLong`] if the payload has more bytes than the rows.
pub(in crate::stream) fn unpack(
    format: PixelFormat,
    palette: &render::Palette,
    width: u16,
    payload: &[u8],
    rows: &mut [u8],
    here: &[bool],
    above: &mut [u16],
) -> Result<(), UnpackError> {
    let above = above.get_mut(..width.into()).ok_or(UnpackError::NoMemory)?;
    let rows = rows
        .chunks_mut(format.row_bytes(width).max(1))
        .zip(here)
        .map(|(row, here)| if *here { &mut [] } else { row });
    let is_exact = match format {
        PixelFormat::Gray8 => symbols(&mut Levels(PhantomData), payload, rows, above),
        PixelFormat::Rgb565 => colors::<Rgb565>(palette, payload, rows, above),
        PixelFormat::Rgb888 => colors::<Rgb888>(palette, payload, rows, above),
        PixelFormat::Mono => bits(width, payload, rows, above),
    };
    if is_exact { Ok(()) } else { Err(UnpackError::TooLong) }
}

fn colors<'r, P: Channels>(
    palette: &render::Palette,
    payload: &[u8],
    rows: impl Iterator<Item = &'r mut [u8]>,
    above: &mut [u16],
) -> bool {
    let mut palette = Palette::<P, { render::Palette::CAPACITY }>::new(palette);
    symbols(&mut palette, payload, rows, above)
}

fn symbols<'r, A: Alphabet<Symbol = u16>>(
    alphabet: &mut A,
    payload: &[u8],
    rows: impl Iterator<Item = &'r mut [u8]>,
    above: &mut [u16],
) -> bool {
    let mut model = Model::<SLOTS>::EMPTY;
    model.restart(&START);
    let mut coder = Decoder::new(&mut model, payload);
    let mut start = Start { left: alphabet.pixel(0), is_first: true };
    for row in rows {
        let mut line = Sink { row, first: start.left };
        rows::code(&mut coder, alphabet, above, &mut line, start);
        start = Start { left: line.first, is_first: false };
    }
    coder.is_exact()
}

fn bits<'r>(
    width: u16,
    payload: &[u8],
    rows: impl Iterator<Item = &'r mut [u8]>,
    above: &mut [u16],
) -> bool {
    let above = above.get_mut(..PixelFormat::Mono.row_bytes(width)).unwrap_or_default();
    let mut model = Model::<{ bilevel::CONTEXTS }>::EMPTY;
    model.restart(&bilevel::START);
    above.fill(0);
    let mut coder = Decoder::new(&mut model, payload);
    for row in rows {
        bilevel::code(&mut coder, above, width.into(), |_| false);
        row.iter_mut().zip(&*above).for_each(|(to, from)| *to = *from as u8);
    }
    coder.is_exact()
}

/// A row that is written, as bytes.
struct Sink<'a, P> {
    row: &'a mut [u8],
    /// The pixel in the first column.
    first: P,
}

impl<P: Channels> Line<P> for Sink<'_, P> {
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
        let bytes = pixel.bytes();
        let bytes = bytes.as_ref();
        let (from, to) = (from * bytes.len(), to * bytes.len());
        let places = self.row.get_mut(from..to).unwrap_or_default();
        for (to, byte) in places.iter_mut().zip(bytes.iter().cycle()) {
            *to = *byte;
        }
    }
}

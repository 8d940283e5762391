//! Rows of any format out of a payload, into a frame's memory.

use core::marker::PhantomData;

use super::alphabet::{Alphabet, Levels};
use super::model::{Model, SLOTS};
use super::palette::{Channels, Palette};
use super::{BilevelDecoder, RowsDecoder, bilevel};
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
    let mut decoder = RowsDecoder::new(&mut model, payload);
    rows.for_each(|row| decoder.row(alphabet, above, row));
    decoder.is_exact()
}

fn bits<'r>(
    width: u16,
    payload: &[u8],
    rows: impl Iterator<Item = &'r mut [u8]>,
    above: &mut [u16],
) -> bool {
    let above = above.get_mut(..PixelFormat::Mono.row_bytes(width)).unwrap_or_default();
    let mut model = Model::<{ bilevel::CONTEXTS }>::EMPTY;
    let mut decoder = BilevelDecoder::new(&mut model, above, payload);
    for row in rows {
        decoder.row(above, width.into());
        row.iter_mut().zip(&*above).for_each(|(to, from)| *to = *from as u8);
    }
    decoder.is_exact()
}

//! PackBits run-length coding in units of pixels.
//!
//! Apple Technical Note TN1023, "Understanding PackBits"; TIFF 6.0, section 9. There the unit is a byte;
//! here it is a pixel of one or two bytes, so that an even area of RGB565 is a run too. A control byte
//! `n`, read as signed, goes before each chunk:
//!
//! - 0..=127: n + 1 pixels follow as they are;
//! - -127..=-1: one pixel follows, to be repeated 1 - n times;
//! - -128: nothing follows (never written here, skipped when read).

use super::raw;
use crate::stream::error::UnpackError;
use crate::stream::pixel::{PixelFormat, WirePixel};

/// The most pixels that one control byte can stand for.
const MAX_CHUNK: usize = 128;

/// The control byte that stands for nothing: -128.
const NO_OP: u8 = 0x80;

/// One control byte's worth of pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Chunk<'a, P> {
    /// 1..=128 pixels as they are.
    Literal(&'a [P]),
    /// One pixel, 2..=128 times.
    Repeat(P, u8),
}

impl<P> Chunk<'_, P> {
    /// The control byte before the chunk's pixels.
    const fn control(&self) -> u8 {
        match *self {
            Self::Literal(pixels) => (pixels.len() as u8).wrapping_sub(1),
            Self::Repeat(_, count) => 1_u8.wrapping_sub(count),
        }
    }

    /// The pixels after the control byte.
    const fn pixels(&self) -> &[P] {
        match self {
            Self::Literal(pixels) => pixels,
            Self::Repeat(pixel, _) => core::slice::from_ref(pixel),
        }
    }
}

/// Cuts a row into chunks. Walking it costs no memory, so an encoder walks it twice: once for the
/// length, once for the bytes.
fn chunks<P: WirePixel>(mut rest: &[P]) -> impl Iterator<Item = Chunk<'_, P>> {
    core::iter::from_fn(move || {
        let (chunk, others) = first_chunk(rest)?;
        rest = others;
        Some(chunk)
    })
}

/// The chunk at the start of a row, and the pixels behind it.
fn first_chunk<P: WirePixel>(pixels: &[P]) -> Option<(Chunk<'_, P>, &[P])> {
    // With no literal open, a run of two is never longer than the literal that it replaces.
    let run = run_length(pixels, MAX_CHUNK);
    if run >= 2 {
        return Some((Chunk::Repeat(*pixels.first()?, run as u8), pixels.get(run..)?));
    }
    // A run that breaks a literal in two costs a control byte more. Two pixels of two bytes pay for
    // it (4 bytes against 1 + 2 + 1), one-byte pixels only from three on (3 bytes against 1 + 1 + 1).
    let worthwhile = if P::FORMAT.bytes_per_pixel() == 1 { 3 } else { 2 };
    let mut len = run;
    while len < MAX_CHUNK {
        let run = run_length(pixels.get(len..)?, worthwhile);
        if run == 0 || run >= worthwhile {
            break;
        }
        len += run;
    }
    let (literal, rest) = pixels.split_at_checked(len.min(MAX_CHUNK))?;
    (!literal.is_empty()).then_some((Chunk::Literal(literal), rest))
}

/// The size of the packed pixels in bytes.
pub(super) fn len<P: WirePixel>(pixels: &[P]) -> usize {
    chunks(pixels)
        .fold(0, |sum: usize, chunk| sum.saturating_add(raw::len(chunk.pixels())).saturating_add(1))
}

/// Gives the packed pixels to `put`, some bytes at a time.
pub(super) fn pack<P: WirePixel, E>(
    pixels: &[P],
    put: &mut impl FnMut(&[u8]) -> Result<(), E>,
) -> Result<(), E> {
    chunks(pixels).try_for_each(|chunk| {
        put(&[chunk.control()])?;
        raw::pack(chunk.pixels(), put)
    })
}

/// How many pixels at the start are alike, at most `cap`.
fn run_length<P: WirePixel>(pixels: &[P], cap: usize) -> usize {
    let first = pixels.first();
    pixels.iter().take(cap).take_while(|pixel| Some(*pixel) == first).count()
}

/// Takes the next run off `packed`: its bytes, and how often they stand in the row.
pub(super) fn take_run<'a>(
    packed: &mut &'a [u8],
    format: PixelFormat,
) -> Result<Option<(&'a [u8], usize)>, UnpackError> {
    loop {
        let Some((&control, rest)) = packed.split_first() else {
            return Ok(None);
        };
        if control == NO_OP {
            *packed = rest;
            continue;
        }
        let (pixels, count) = if control < NO_OP {
            (usize::from(control) + 1, 1)
        } else {
            (1, 257 - usize::from(control))
        };
        let size = pixels.saturating_mul(format.bytes_per_pixel());
        let (bytes, rest) = rest.split_at_checked(size).ok_or(UnpackError::Truncated)?;
        *packed = rest;
        return Ok(Some((bytes, count)));
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use proptest::prelude::*;
    use std::vec::Vec;

    use super::*;
    use crate::render::{Gray8, Rgb565};
    use crate::stream::{Encoding, RowPayload};

    fn packed<P: WirePixel>(pixels: &[P]) -> Vec<u8> {
        let mut bytes = Vec::new();
        let mut put = |more: &[u8]| {
            bytes.extend_from_slice(more);
            Ok::<_, ()>(())
        };
        assert_eq!(pack(pixels, &mut put), Ok(()));
        bytes
    }

    /// The least size of any packing, by dynamic programming over all ways to cut the row.
    fn shortest<P: WirePixel>(pixels: &[P]) -> usize {
        let bpp = P::FORMAT.bytes_per_pixel();
        let mut best = std::vec![0_usize; pixels.len() + 1];
        for end in 1..=pixels.len() {
            let mut alike = true;
            best[end] = usize::MAX;
            for start in (end.saturating_sub(MAX_CHUNK)..end).rev() {
                alike &= pixels[start] == pixels[end - 1];
                let len = end - start;
                let stored = if alike && len > 1 { 1 } else { len };
                best[end] = best[end].min(best[start] + 1 + stored * bpp);
            }
        }
        best[pixels.len()]
    }

    /// Rows made of runs, with few values, so that neighbouring runs may join: rows of one chunk's
    /// length at most, and rows with runs and literals beyond it.
    fn row() -> impl Strategy<Value = Vec<u8>> {
        let short = proptest::collection::vec((0..4_u8, 1..5_usize), 0..31);
        let long = proptest::collection::vec((0..4_u8, 1..300_usize), 0..10);
        prop_oneof![3 => short, 1 => long].prop_map(|runs| {
            let pixels = runs.into_iter();
            pixels.flat_map(|(value, count)| std::iter::repeat_n(value, count)).collect()
        })
    }

    #[test]
    fn chunks_of_a_row() {
        let row: Vec<_> = [1, 2, 2, 3, 3, 3, 3, 4].map(Gray8).into();
        let cut: Vec<_> = chunks(&row).collect();
        assert_eq!(
            cut,
            [Chunk::Literal(&row[..3]), Chunk::Repeat(Gray8(3), 4), Chunk::Literal(&row[7..])]
        );
        assert_eq!(packed(&row), [2, 1, 2, 2, 0xFD, 3, 0, 4]);
    }

    #[test]
    fn longest_chunks() {
        let run = [Rgb565(0x1234); 129];
        assert_eq!(packed(&run), [0x81, 0x34, 0x12, 0, 0x34, 0x12]);
        let literal: Vec<_> = (0..=128).map(Gray8).collect();
        let packed = packed(&literal);
        assert_eq!((packed[0], packed[129], packed.len()), (127, 0, 131));
    }

    proptest! {
        #[test]
        fn packs_shortest_and_unpacks(values in row()) {
            let gray: Vec<_> = values.iter().copied().map(Gray8).collect();
            let rgb: Vec<_> = values.iter().map(|&v| Rgb565(0x0100 * u16::from(v) + 7)).collect();
            check(&gray)?;
            check(&rgb)?;
        }
    }

    fn check<P: WirePixel>(pixels: &[P]) -> Result<(), TestCaseError> {
        let packed = packed(pixels);
        prop_assert_eq!(packed.len(), len(pixels));
        // Exactly, until the limit of 128 pixels cuts a chunk where a cleverer cut would save a byte.
        let excess = packed.len() - shortest(pixels);
        prop_assert!(excess <= pixels.len() / MAX_CHUNK, "{} bytes too long", excess);
        let raw: Vec<u8> =
            pixels.iter().flat_map(|p| Vec::from(p.to_le_bytes().as_ref())).collect();
        let mut row = std::vec![0; raw.len()];
        let payload = RowPayload { encoding: Encoding::PackBits, bytes: &packed };
        prop_assert_eq!(payload.unpack(P::FORMAT, &mut row), Ok(()));
        prop_assert_eq!(row, raw);
        Ok(())
    }
}

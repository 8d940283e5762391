//! PackBits run-length coding in units of pixels.
//!
//! Apple Technical Note TN1023, "Understanding PackBits"; TIFF 6.0, section 9. There the unit is a byte;
//! here it is a pixel of one to three bytes, so that an even area of RGB565 is a run too, or eight pixels
//! of one bit. A control byte `n`, read as signed, goes before each chunk:
//!
//! - 0..=127: n + 1 units follow as they are;
//! - -127..=-1: one unit follows, to be repeated 1 - n times;
//! - -128: nothing follows (never written here, skipped when read).

use super::raw;
use crate::stream::error::UnpackError;
use crate::stream::pixel::{PixelFormat, Units, Wire, WirePixel};

/// The most units that one control byte can stand for.
const MAX_CHUNK: usize = 128;

/// The control byte that stands for nothing: -128.
const NO_OP: u8 = 0x80;

/// One control byte's worth of units.
#[derive(Clone, Copy)]
struct Chunk<'a, P> {
    control: u8,
    /// 1..=128 units as they are, or one that is repeated.
    units: Units<'a, P>,
}

/// Cuts a row into chunks. Walking it costs no memory, so an encoder walks it twice: once for the
/// length, once for the bytes.
fn chunks<P: WirePixel>(mut rest: Units<'_, P>) -> impl Iterator<Item = Chunk<'_, P>> {
    core::iter::from_fn(move || {
        let (chunk, count) = first_chunk(rest)?;
        rest = rest.skip(count);
        Some(chunk)
    })
}

/// The chunk at the start of a row, and how many units it stands for.
fn first_chunk<P: WirePixel>(units: Units<'_, P>) -> Option<(Chunk<'_, P>, usize)> {
    // With no literal open, a run of two is never longer than the literal that it replaces.
    let run = run_length(units, MAX_CHUNK);
    if run >= 2 {
        let control = 1_u8.wrapping_sub(run as u8);
        return Some((Chunk { control, units: units.take(1) }, run));
    }
    // A run that breaks a literal in two costs a control byte more. Two units of two bytes pay for
    // it (4 bytes against 1 + 2 + 1), one-byte units only from three on (3 bytes against 1 + 1 + 1).
    let worthwhile = if P::Wire::FORMAT.unit_bytes() == 1 { 3 } else { 2 };
    let mut len = run;
    while len < MAX_CHUNK {
        let run = run_length(units.skip(len), worthwhile);
        if run == 0 || run >= worthwhile {
            break;
        }
        len += run;
    }
    let len = len.min(MAX_CHUNK);
    let control = (len as u8).checked_sub(1)?;
    Some((Chunk { control, units: units.take(len) }, len))
}

/// The size of the packed units in bytes.
pub(super) fn len<P: WirePixel>(units: Units<'_, P>) -> usize {
    chunks(units)
        .fold(0, |sum: usize, chunk| sum.saturating_add(chunk.units.bytes()).saturating_add(1))
}

/// Gives the packed units to `put`, some bytes at a time.
pub(super) fn pack<P: WirePixel, E>(
    units: Units<'_, P>,
    put: &mut impl FnMut(&[u8]) -> Result<(), E>,
) -> Result<(), E> {
    chunks(units).try_for_each(|chunk| {
        put(&[chunk.control])?;
        raw::pack(chunk.units, put)
    })
}

/// How many units at the start are alike, at most `cap`.
fn run_length<P: WirePixel>(units: Units<'_, P>, cap: usize) -> usize {
    let mut units = units.iter().take(cap);
    match units.next() {
        Some(first) => 1 + units.take_while(|unit| *unit == first).count(),
        None => 0,
    }
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
        let size = pixels.saturating_mul(format.unit_bytes());
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
        assert_eq!(pack(Units(pixels), &mut put), Ok(()));
        bytes
    }

    /// The least size of any packing, by dynamic programming over all ways to cut the row.
    fn shortest<P: WirePixel>(pixels: &[P]) -> usize {
        let bpp = P::Wire::FORMAT.unit_bytes();
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
        let cut: Vec<_> = chunks(Units(&row)).map(|cut| (cut.control, cut.units.0)).collect();
        assert_eq!(cut, [(2, &row[..3]), (0xFD, &row[3..4]), (0, &row[7..])]);
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
        prop_assert_eq!(packed.len(), len(Units(pixels)));
        // Exactly, until the limit of 128 pixels cuts a chunk where a cleverer cut would save a byte.
        let excess = packed.len() - shortest(pixels);
        prop_assert!(excess <= pixels.len() / MAX_CHUNK, "{} bytes too long", excess);
        let raw: Vec<u8> = Units(pixels).iter().flat_map(|unit| Vec::from(unit.as_ref())).collect();
        let mut row = std::vec![0; raw.len()];
        let payload = RowPayload { encoding: Encoding::PackBits, bytes: &packed };
        prop_assert_eq!(payload.unpack(P::Wire::FORMAT, &mut row), Ok(()));
        prop_assert_eq!(row, raw);
        Ok(())
    }
}

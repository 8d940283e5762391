//! How a sender codes rows.

use crate::render::Palette;
use crate::stream::pixel::WirePixel;

/// How a sender codes rows: [`Plain`] or [`Predictive`](super::Predictive).
pub trait Coding {
    /// Begins a frame whose surfaces have these colours.
    fn begin_frame(&mut self, palette: &Palette);

    /// Begins a packet of rows.
    fn begin(&mut self);

    /// Ends the packet: the size of its payload, whose beginning is in `payload` already.
    fn finish(&mut self, payload: &mut [u8]) -> usize;
}

/// A [`Coding`] that can code rows of these pixels.
pub trait RowCoding<P>: Coding {
    /// Adds a row to the packet, if it fits into `payload` behind the rows before it.
    fn push(&mut self, pixels: &[P], payload: &mut [u8]) -> bool;
}

/// Each row is coded for itself, as it is or in runs, and has a packet of its own.
///
/// It needs the least memory, flash and time, and the most bytes on the line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Plain;

impl Coding for Plain {
    fn begin_frame(&mut self, _: &Palette) {}

    fn begin(&mut self) {}

    fn finish(&mut self, _: &mut [u8]) -> usize {
        0
    }
}

impl<P: WirePixel> RowCoding<P> for Plain {
    fn push(&mut self, _: &[P], _: &mut [u8]) -> bool {
        false
    }
}

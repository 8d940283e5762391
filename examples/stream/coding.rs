//! How rows are coded: chosen on the command line.

use scancsg::render::Palette;
use scancsg::stream::{Coding, Plain, Predictable, Predictive, RowCoding, WirePixel};

/// The widest row.
const WIDTH: usize = 4096;

/// One of the library's codings, for pixels of the link.
pub enum Chosen<P: Predictable> {
    Plain(Plain),
    Predictive(Box<Predictive<P, WIDTH>>),
}

impl<P: Predictable> Chosen<P> {
    pub fn plain() -> Self {
        Self::Plain(Plain)
    }

    pub fn predictive() -> Self {
        Self::Predictive(Box::default())
    }
}

impl<P: Predictable> Coding for Chosen<P> {
    fn begin_frame(&mut self, palette: &Palette) {
        match self {
            Self::Plain(coding) => coding.begin_frame(palette),
            Self::Predictive(coding) => coding.begin_frame(palette),
        }
    }

    fn begin(&mut self) {
        match self {
            Self::Plain(coding) => coding.begin(),
            Self::Predictive(coding) => coding.begin(),
        }
    }

    fn finish(&mut self, payload: &mut [u8]) -> usize {
        match self {
            Self::Plain(coding) => coding.finish(payload),
            Self::Predictive(coding) => coding.finish(payload),
        }
    }
}

impl<P: Predictable, T: WirePixel<Wire = P>> RowCoding<T> for Chosen<P> {
    fn push(&mut self, pixels: &[T], payload: &mut [u8]) -> bool {
        match self {
            Self::Plain(coding) => coding.push(pixels, payload),
            Self::Predictive(coding) => coding.push(pixels, payload),
        }
    }
}

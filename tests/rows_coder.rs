//! What pictures take as rows by prediction: every byte on the line, packets and all. The coder's own tests,
//! there and back, are beside it.

#[path = "../examples/scene/mod.rs"]
mod scene;

#[path = "../src/stream/codec/predictive/alphabet.rs"]
#[allow(dead_code)] // this only encodes
mod alphabet;
#[path = "../src/stream/codec/predictive/model.rs"]
mod model;
#[path = "../src/stream/codec/predictive/palette.rs"]
#[allow(dead_code)]
mod palette;
#[path = "../src/stream/codec/predictive/range.rs"]
#[allow(dead_code)]
mod range;
#[path = "../src/stream/codec/predictive/rows.rs"]
mod rows;
#[path = "../src/stream/codec/predictive/start.rs"]
mod start;

use alphabet::{Alphabet, Levels};
use model::Model;
use palette::Palette;
use range::{Encoder, Interval};
use rows::{Line, Start};
use scancsg::render::{
    self, Blend, Gray8, Lambert, Picture, Rgb, Rgb565, Size, SmoothColumn, SmoothPicture, Smoothing,
};
use scancsg::solid::{Scan, Solid};
use scene::Scene;
use scene::pipe::PipeScene;
use std::error::Error;

/// The longest payload: with the 6 bytes before it and the checksum it is one block of COBS.
const PAYLOAD: usize = 254 - 6 - 4;
/// What is around a payload: these ten bytes, COBS's code byte, and the terminator.
const AROUND: usize = 6 + 4 + 2;
/// A frame's header without colours, and its end.
const ENDS: usize = 17 + 13;

struct Source<'a, P>(&'a [P]);

impl<P: Copy + PartialEq> Line<P> for Source<'_, P> {
    fn get(&self, x: usize) -> Option<P> {
        self.0.get(x).copied()
    }

    fn holds(&self, from: usize, to: usize, pixel: P) -> bool {
        self.0[from..to].iter().all(|held| *held == pixel)
    }

    fn fill(&mut self, _: usize, _: usize, _: P) {}
}

fn bytes<A: Alphabet>(mut alphabet: A, width: usize, pixels: &[A::Pixel]) -> usize {
    let mut above = vec![A::kept(0); width];
    let mut rows = pixels.chunks_exact(width).peekable();
    let mut bytes = ENDS;
    while rows.peek().is_some() {
        let (mut model, mut interval) = (Model::starting(&start::START), Interval::ALL);
        let mut from = Start { left: alphabet.pixel(0), is_first: true };
        let mut out = [0; PAYLOAD];
        for count in 0..256 {
            let Some(row) = rows.peek().filter(|_| count < 255) else { break };
            let mut coder = Encoder::resume(&mut model, interval, &mut out);
            rows::code(&mut coder, &mut alphabet, &mut above, &mut Source(row), from);
            let Some(end) = coder.fits() else {
                assert!(count > 0, "a row that is longer than a packet");
                break;
            };
            (interval, from) = (end, Start { left: row[0], is_first: false });
            rows.next();
        }
        bytes += AROUND + interval.finish(&mut out);
    }
    bytes
}

/// A picture by the camera and the light of all measurements, with black around the part.
fn rendered<T, P>(
    part: &T,
    size: [u16; 2],
    samples: u16,
    black: P,
) -> Result<Vec<P>, Box<dyn Error>>
where
    T: Solid<Scalar = f32> + Scan<scancsg::geom::OrthographicRays<f32>>,
    P: Blend,
{
    let camera = f32::orthographic()?;
    let light = Lambert::new(f32::TO_LIGHT, 0.15)?;
    let [width, height] = size.map(usize::from);
    let size = Size::new(size[0], size[1])?;
    let mut pixels = vec![black; width * height];
    let rows = (0..).zip(pixels.chunks_exact_mut(width));
    if samples > 1 {
        let mut columns = vec![SmoothColumn::EMPTY; width + 1];
        let smoothing = Smoothing::new(size, samples, &mut columns)?;
        let mut picture = SmoothPicture::new(part, &camera, smoothing, light, black);
        for (y, row) in rows {
            picture.render(y, row)?;
        }
    } else {
        let mut picture = Picture::new(part, &camera, size, light, black);
        for (y, row) in rows {
            picture.scanline(y)?.render(row)?;
        }
    }
    Ok(pixels)
}

#[test]
fn grey_pictures() -> Result<(), Box<dyn Error>> {
    let tee = rendered(&f32::TEE, [160, 120], 1, Gray8(0))?;
    let tee = bytes(Levels, 160, &tee);
    assert!(tee <= 2150, "tee takes {tee} bytes");
    let pipe = f32::pipe(f32::hundredths(1))?;
    let pipe = bytes(Levels, 160, &rendered(&pipe, [160, 120], 1, Gray8(0))?);
    assert!(pipe <= 3600, "the pipe takes {pipe} bytes");
    Ok(())
}

#[test]
fn colour_pictures() -> Result<(), Box<dyn Error>> {
    let colors = [Rgb::new(150, 175, 200), Rgb::new(235, 175, 70)];
    let of = |samples| {
        let pixels = rendered(&f32::PAINTED_TEE, [320, 240], samples, Rgb565(0))?;
        let palette = Palette::<_, 2>::new(&colors);
        Ok::<_, Box<dyn Error>>(3 * colors.len() + bytes(palette, 320, &pixels))
    };
    let (plain, smooth) = (of(1)?, of(4)?);
    assert!(plain <= 4100, "tee takes {plain} bytes");
    assert!(smooth <= 7600, "the smooth tee takes {smooth} bytes");
    Ok(())
}

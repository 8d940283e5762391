//! How long frames are on the link, and that they arrive.

#![allow(clippy::unwrap_used, clippy::panic)]

use scancsg::render::{
    Gray8, Lambert, Mono, Picture, Rgb, Rgb565, Rgb888, RowError, RowSource, Size, SmoothColumn,
    SmoothPicture, Smoothing,
};
use scancsg::stream::{
    Event, FrameHeader, Memory, Patience, Plain, Predictive, PredictiveMono, Receiver, RowCoding,
    RowHash, Sender, Task, Timing, Wire, WirePixel,
};
use scene::Scene;
use scene::pipe::PipeScene;

use crate::scene;

/// All bytes of a frame on a clean line, which are checked against the rows.
fn bytes<P: WirePixel>(source: &mut dyn RowSource<Pixel = P>, coding: impl RowCoding<P>) -> u64 {
    let size = source.size();
    let format = P::Wire::FORMAT;
    let (width, height) = (size.width(), size.height());
    let mut row = vec![P::shaded(Rgb::WHITE, 0); usize::from(width)];
    let row_bytes = format.row_bytes(width);
    let mut pixels = vec![0; row_bytes * usize::from(height)];
    let mut rows = vec![false; usize::from(height)];
    let mut above = vec![0; usize::from(width)];
    let memory = Memory { pixels: &mut pixels, rows: &mut rows, above: &mut above };
    let mut receiver = Receiver::<4096>::new(memory, Timing { ask: 100, give_up: 1000 });
    let mut sender = Sender::<_, 4096>::new(coding, Patience { ticks: 100, silences: 1 });
    let palette = source.palette();
    sender.begin(FrameHeader { frame: 1, width, height, format, palette }).unwrap();
    let mut sent = Vec::new();
    loop {
        match sender.poll(0) {
            Task::Send(mut packet) => {
                while let Some(event) = receiver.receive(&mut packet, 0) {
                    assert!(
                        !matches!(event, Event::Refused(_) | Event::Incomplete { .. }),
                        "{event:?}"
                    );
                }
                sender.sent(0);
            }
            Task::Row(y) => {
                source.render(y, &mut row).unwrap();
                if sent.len() == usize::from(y) {
                    sent.push(row.clone());
                }
                sender.row(y, &row).unwrap();
            }
            Task::Listen(_) => {
                let answer = receiver.answer().unwrap();
                answer.iter().for_each(|byte| sender.receive(*byte, 0));
            }
            Task::Done(_) => break,
        }
    }
    assert!(receiver.frame().is_complete());
    for (y, row) in (0..).zip(&sent) {
        let mut hash = RowHash::new(y);
        hash.update(receiver.frame().row(y).unwrap());
        assert_eq!(hash.finish(), RowHash::of(y, row));
    }
    sender.bytes_sent()
}

/// Bytes of a frame of `tee` and of `pipe`, all packets included.
#[test]
fn frames_are_short() {
    let camera = f32::orthographic().unwrap();
    let light = Lambert::new(f32::TO_LIGHT, 0.15).unwrap();
    let (small, large) = (Size::new(160, 120).unwrap(), Size::new(320, 240).unwrap());
    let (tee, painted) = (f32::TEE, f32::PAINTED_TEE);

    let mut gray = Picture::new(&tee, &camera, small, light, Gray8(0));
    assert!(bytes(&mut gray, Predictive::<Gray8, 160>::new()) <= 2_150);
    assert!(bytes(&mut gray, Plain) <= 8_910);
    let mut rgb = Picture::new(&painted, &camera, large, light, Rgb565(0));
    assert!(bytes(&mut rgb, Predictive::<Rgb565, 320>::new()) <= 4_100);
    let mut rgb = Picture::new(&painted, &camera, large, light, Rgb888([0; 3]));
    assert!(bytes(&mut rgb, Predictive::<Rgb888, 320>::new()) <= 5_500);
    let mut columns = vec![SmoothColumn::EMPTY; 321];
    let smoothing = Smoothing::new(large, 4, &mut columns).unwrap();
    let mut smooth = SmoothPicture::new(&painted, &camera, smoothing, light, Rgb565(0));
    assert!(bytes(&mut smooth, Predictive::<Rgb565, 320>::new()) <= 7_600);

    let pipe = <f32 as PipeScene>::pipe(0.25 * 3.7 / 120.0).unwrap();
    let mut gray = Picture::new(&pipe, &camera, small, light, Gray8(0));
    assert!(bytes(&mut gray, Predictive::<Gray8, 160>::new()) <= 3_600);
}

/// Rows that are wider than the coder's memory, or too long for a packet, are sent each for itself.
#[test]
fn rows_that_cannot_be_coded_together_arrive() {
    let camera = f32::orthographic().unwrap();
    let light = Lambert::new(f32::TO_LIGHT, 0.15).unwrap();
    let tee = f32::TEE;
    let mut gray = Picture::new(&tee, &camera, Size::new(160, 120).unwrap(), light, Gray8(0));
    assert!(bytes(&mut gray, Predictive::<Gray8, 159>::new()) <= 8_910);
    let mut noise = Noise(Size::new(600, 9).unwrap());
    assert!(bytes(&mut noise, Predictive::<Gray8, 600>::new()) >= 5_400);
    assert!(bytes(&mut Bits(noise), PredictiveMono::<75>::new()) >= 600);
}

/// Rows without any order.
struct Noise(Size);

impl RowSource for Noise {
    type Pixel = Gray8;

    fn size(&self) -> Size {
        self.0
    }

    fn render(&mut self, y: u16, pixels: &mut [Gray8]) -> Result<(), RowError> {
        let mut state = u32::from(y) * 65_539 + 1;
        for pixel in pixels {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            *pixel = Gray8((state >> 24) as u8);
        }
        Ok(())
    }
}

/// The same in black and white.
struct Bits(Noise);

impl RowSource for Bits {
    type Pixel = Mono;

    fn size(&self) -> Size {
        self.0.size()
    }

    fn render(&mut self, y: u16, pixels: &mut [Mono]) -> Result<(), RowError> {
        let mut gray = vec![Gray8(0); pixels.len()];
        self.0.render(y, &mut gray)?;
        pixels.iter_mut().zip(gray).for_each(|(to, from)| *to = Mono(from.0 > 127));
        Ok(())
    }
}

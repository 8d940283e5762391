//! What the tests send, and what a canvas must then show.

#![allow(dead_code)] // every test takes what it needs

use scancsg::geom::vec3;
use scancsg::render::{
    Gray8, Lambert, Mono, Orthographic, Palette, Picture, Rgb, Rgb565, Rgb888, RowSource, Size,
};
use scancsg::solid::{Cylinder, Painted, Sphere};
use scancsg::stream::{
    Delivery, FrameHeader, Patience, PixelFormat, Plain, Predictive, PredictiveMono, RowCoding,
    Sender, Task, Wire, WirePixel, packet_capacity,
};
use std::time::{Duration, Instant};

pub const SIZE: [u16; 2] = [70, 40];

const CAPACITY: usize = packet_capacity(SIZE[0], PixelFormat::Rgb888);

/// A pixel whose colour on a canvas is known.
pub trait Shown: WirePixel<Wire = Self> + Wire + 'static {
    const DARK: Self;
    /// Its rows by prediction.
    type Short: RowCoding<Self>;
    fn color(self) -> [u8; 3];
    fn short() -> Self::Short;
}

const WIDTH: usize = SIZE[0] as usize;

impl Shown for Gray8 {
    const DARK: Self = Self(0);
    type Short = Predictive<Self, WIDTH>;
    fn color(self) -> [u8; 3] {
        [self.0; 3]
    }
    fn short() -> Self::Short {
        Predictive::new()
    }
}

impl Shown for Rgb565 {
    const DARK: Self = Self(0);
    type Short = Predictive<Self, WIDTH>;
    fn color(self) -> [u8; 3] {
        let eight =
            |bits: u16, most: u16| (f32::from(bits) / f32::from(most) * 255.0).round() as u8;
        [eight(self.0 >> 11, 31), eight(self.0 >> 5 & 63, 63), eight(self.0 & 31, 31)]
    }
    fn short() -> Self::Short {
        Predictive::new()
    }
}

impl Shown for Rgb888 {
    const DARK: Self = Self([0; 3]);
    type Short = Predictive<Self, WIDTH>;
    fn color(self) -> [u8; 3] {
        self.0
    }
    fn short() -> Self::Short {
        Predictive::new()
    }
}

impl Shown for Mono {
    const DARK: Self = Self(false);
    type Short = PredictiveMono<{ WIDTH.div_ceil(8) }>;
    fn color(self) -> [u8; 3] {
        [if self.0 { 255 } else { 0 }; 3]
    }
    fn short() -> Self::Short {
        PredictiveMono::new()
    }
}

/// The rows of a frame, and the colours of what is seen: a ball with a bore, from a little to the right in
/// each frame.
pub fn rows<P: Shown>(frame: u16) -> (Vec<Vec<P>>, Palette) {
    let ball =
        Painted::new(Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0).unwrap(), Rgb::new(230, 90, 60));
    let bore = Cylinder::<f32>::along_z(0.0, 0.0, 0.4, -2.0, 2.0).unwrap();
    let part = ball - Painted::new(bore, Rgb::new(80, 140, 230));
    let eye = vec3(1.0 + f32::from(frame), 0.8, 4.0);
    let camera = Orthographic::look_at(eye, vec3(0.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), 2.2).unwrap();
    let light = Lambert::new(vec3(0.3, 0.5, 0.8), 0.2).unwrap();
    let size = Size::new(SIZE[0], SIZE[1]).unwrap();
    let mut picture = Picture::new(&part, &camera, size, light, P::DARK);
    let mut row = vec![P::DARK; SIZE[0].into()];
    let rows = (0..SIZE[1]).map(|y| {
        picture.render(y, &mut row).unwrap();
        row.clone()
    });
    let rows = rows.collect();
    (rows, picture.palette())
}

/// The colours of a frame's pixels.
pub fn colors<P: Shown>(frame: u16) -> impl Iterator<Item = [u8; 3]> {
    rows::<P>(frame).0.into_iter().flatten().map(Shown::color)
}

/// The frame on a canvas.
pub fn canvas<P: Shown>(frame: u16) -> Vec<u8> {
    colors::<P>(frame).flat_map(|color| color.into_iter().chain([255])).collect()
}

/// Sends a frame as a device would, odd ones by prediction. `write` gets each packet; `listen` waits for that
/// long, and returns what the other end has said.
pub fn send<P: Shown>(
    frame: u16,
    silences: u16,
    write: impl FnMut(&[u8]),
    listen: impl FnMut(Duration) -> Vec<u8>,
) -> Delivery {
    let patience = Patience { ticks: 300, silences };
    if frame % 2 == 1 {
        send_with(Sender::new(P::short(), patience), frame, write, listen)
    } else {
        send_with::<P, _>(Sender::new(Plain, patience), frame, write, listen)
    }
}

fn send_with<P: Shown, C: RowCoding<P>>(
    mut sender: Sender<C, CAPACITY>,
    frame: u16,
    mut write: impl FnMut(&[u8]),
    mut listen: impl FnMut(Duration) -> Vec<u8>,
) -> Delivery {
    let (rows, palette) = rows::<P>(frame);
    let [width, height] = SIZE;
    sender.begin(FrameHeader { frame, width, height, format: P::FORMAT, palette }).unwrap();
    let start = Instant::now();
    let now = || start.elapsed().as_millis() as u32;
    loop {
        let wait = match sender.poll(now()) {
            Task::Send(packet) => {
                write(packet);
                sender.sent(now());
                Duration::ZERO
            }
            Task::Row(y) => {
                sender.row(y, &rows[usize::from(y)]).unwrap();
                continue;
            }
            Task::Listen(ticks) => Duration::from_millis(ticks.into()),
            Task::Done(delivery) => return delivery,
        };
        listen(wait).iter().for_each(|byte| sender.receive(*byte, now()));
    }
}

/// The bytes of frames that nobody has answered: a recording.
pub fn recording<P: Shown>(frames: std::ops::Range<u16>) -> Vec<u8> {
    let mut line = Vec::new();
    for frame in frames {
        send::<P>(frame, 0, |packet| line.extend_from_slice(packet), |_| Vec::new());
    }
    line
}

/// Flips one bit in about every 512th byte.
#[derive(Default)]
pub struct Noise(u32);

impl Noise {
    pub fn on(&mut self, bytes: &[u8]) -> Vec<u8> {
        bytes
            .iter()
            .map(|byte| {
                // Knuth, TAOCP 2, 3.3.4, of 32 bits.
                self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                if self.0 >> 23 == 0 { byte ^ 1 << (self.0 >> 10 & 7) } else { *byte }
            })
            .collect()
    }
}

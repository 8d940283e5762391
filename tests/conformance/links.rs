//! A small picture over the line: what arrives is what was rendered, whatever it was rendered in.

use crate::number::{Tested, ball, rod, vector};
use scancsg::geom::Vec3;
use scancsg::render::{Depth, Gray8, Lambert, Orthographic, Picture, Rgb565, Shader, Size};
use scancsg::solid::{Painted, Rgb, Solid};
use scancsg::stream::{
    Event, FrameHeader, Memory, Patience, PixelFormat, Plain, Receiver, Sender, Task, Timing,
    packet_capacity,
};
use testkit::link::Bytes;

for_every_number!(grey, colours);

const WIDTH: u16 = 24;
const HEIGHT: u16 = 17;
const CAPACITY: usize = packet_capacity(WIDTH, PixelFormat::Rgb565);

/// Renders a part row by row into a sender, and returns the pixels that a receiver got; every one
/// of them must be what the row had. Nothing but the sender's bytes goes from one to the other.
fn over_the_line<S: Tested, P: Bytes>(
    shader: impl Shader<S> + Copy,
    format: PixelFormat,
) -> Vec<u8> {
    let ball = Painted::new(ball::<S>([0.25, 0.0, 0.0], 1.0), Rgb::new(200, 100, 50));
    let part = ball - rod::<S>(0.5, -2.0, 2.0);
    let [eye, up] = [[3.0, 2.0, 4.0], [0.0, 1.0, 0.0]].map(vector);
    let camera = Orthographic::look_at(eye, Vec3::ZERO, up, S::near(2.5)).unwrap();
    let size = Size::new(WIDTH, HEIGHT).unwrap();
    let black = P::shaded(Rgb::WHITE, 0);
    let mut picture = Picture::new(&part, &camera, size, shader, black);
    let mut row = [black; WIDTH as usize];
    let mut rendered = Vec::new();

    let mut line = Vec::new();
    let mut sender = Sender::<Plain, CAPACITY>::new(Plain, Patience { ticks: 0, silences: 0 });
    let palette = picture.palette();
    assert_eq!(palette.first(), Some(&Rgb::new(200, 100, 50)));
    let header = FrameHeader { frame: 3, width: WIDTH, height: HEIGHT, format, palette };
    sender.begin(header).unwrap();
    loop {
        let y = match sender.poll(0) {
            Task::Send(packet) => {
                line.extend_from_slice(packet);
                sender.sent(0);
                continue;
            }
            Task::Row(y) => y,
            Task::Listen(_) | Task::Done(_) => break,
        };
        let mut scanline = picture.scanline(y).unwrap();
        scanline.render(&mut row).unwrap();
        sender.row(scanline.y(), &row).unwrap();
        rendered.extend(P::bytes(&row));
        let sees = |x| scanline.seen(x).is_some();
        let is_black: Vec<bool> = row.iter().map(|pixel| *pixel == black).collect();
        assert!((0..WIDTH).map(sees).zip(is_black).all(|(sees, black)| sees || black));
    }

    let mut pixels = vec![0xAA; rendered.len()];
    let mut rows = [false; HEIGHT as usize];
    let memory = Memory { pixels: &mut pixels, rows: &mut rows, above: &mut [] };
    let mut receiver = Receiver::<CAPACITY>::new(memory, Timing { ask: 1, give_up: 9 });
    let mut bytes = &line[..];
    let mut last = None;
    while let Some(event) = receiver.receive(&mut bytes, 0) {
        last = Some(event);
    }
    assert_eq!(last, Some(Event::Complete));
    assert_eq!(receiver.frame().pixels(), rendered);
    assert_eq!(receiver.frame().header(), Some(header));
    assert!(part.color(scancsg::span::Face(0)).is_some());
    rendered
}

fn count(bytes: &[u8], is_one: impl Fn(u8) -> bool) -> usize {
    bytes.iter().filter(|&&byte| is_one(byte)).count()
}

fn grey<S: Tested>() {
    let light = Lambert::new(vector([0.25, 1.0, 0.5]), S::near(0.25)).unwrap();
    let pixels = over_the_line::<S, Gray8>(light, PixelFormat::Gray8);
    // The ball covers an area of π in a frame of 2.5 × 3.5 units.
    let covered = count(&pixels, |level| level > 0);
    assert!((130..160).contains(&covered), "{covered} of {}", pixels.len());
    assert!(count(&pixels, |level| level > 100) > 20);
}

fn colours<S: Tested>() {
    let depth = Depth::new(S::near(-1.5), S::near(1.5)).unwrap();
    let pixels = over_the_line::<S, Rgb565>(depth, PixelFormat::Rgb565);
    assert_eq!(pixels.len(), 2 * usize::from(WIDTH * HEIGHT));
    assert!(count(&pixels, |byte| byte > 0) > 130);
}

//! The loop of firmware over a line in memory: what it sends, what it answers, and when it gives up.

#![allow(clippy::unwrap_used, clippy::panic)]

use embedded_io::{ErrorKind, ErrorType, Read, ReadReady, Write};
use scancsg::render::{Gray8, RowError, RowSource, Size};
use scancsg::stream::{
    CONTROL_CAPACITY, Decoder, Delivery, EncodeError, FrameHeader, Part, Patience, PixelFormat,
    Receiver, Request, SendError, Sender, encode_ack, encode_request, packet_capacity, serve,
};
use std::collections::VecDeque;

const WIDTH: u16 = 6;
const HEIGHT: u16 = 5;
const FRAME: u16 = 7;
const CAPACITY: usize = packet_capacity(WIDTH, PixelFormat::Gray8);
const PATIENCE: Patience = Patience { looks: 4, silences: 3 };

/// Rows that are different from each other. It counts how many were rendered.
struct Scene {
    rendered: usize,
    breaks_at: u16,
}

impl Scene {
    fn new() -> Self {
        Self { rendered: 0, breaks_at: u16::MAX }
    }
}

fn row(y: u16) -> [Gray8; WIDTH as usize] {
    std::array::from_fn(|x| Gray8((40 * y + 3 * x as u16) as u8))
}

impl RowSource for Scene {
    type Pixel = Gray8;

    fn size(&self) -> Size {
        Size::new(WIDTH, HEIGHT).unwrap()
    }

    fn render(&mut self, y: u16, pixels: &mut [Gray8]) -> Result<(), RowError> {
        if y == self.breaks_at {
            return Err(RowError::Range);
        }
        if pixels.len() != usize::from(WIDTH) {
            return Err(RowError::Length);
        }
        self.rendered += 1;
        pixels.copy_from_slice(&row(y));
        Ok(())
    }
}

/// A line to another end that answers what has been flushed, and sees nothing of what has not.
struct Line<F> {
    /// Written, and not flushed yet.
    buffered: Vec<u8>,
    /// All that was flushed.
    sent: Vec<u8>,
    incoming: VecDeque<u8>,
    /// What the other end answers to these bytes.
    answer: F,
    looks: u32,
    room: usize,
    is_closed: bool,
}

impl<F: FnMut(&[u8]) -> Vec<u8>> Line<F> {
    fn new(answer: F) -> Self {
        Self {
            buffered: Vec::new(),
            sent: Vec::new(),
            incoming: VecDeque::new(),
            answer,
            looks: 0,
            room: usize::MAX,
            is_closed: false,
        }
    }
}

impl<F> ErrorType for Line<F> {
    type Error = ErrorKind;
}

impl<F: FnMut(&[u8]) -> Vec<u8>> Write for Line<F> {
    fn write(&mut self, bytes: &[u8]) -> Result<usize, ErrorKind> {
        self.room = self.room.checked_sub(bytes.len()).ok_or(ErrorKind::TimedOut)?;
        self.buffered.extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> Result<(), ErrorKind> {
        self.incoming.extend((self.answer)(&self.buffered));
        self.sent.append(&mut self.buffered);
        Ok(())
    }
}

impl<F> ReadReady for Line<F> {
    fn read_ready(&mut self) -> Result<bool, ErrorKind> {
        self.looks += u32::from(self.incoming.is_empty());
        Ok(self.is_closed || !self.incoming.is_empty())
    }
}

impl<F> Read for Line<F> {
    fn read(&mut self, bytes: &mut [u8]) -> Result<usize, ErrorKind> {
        self.incoming.read(bytes).map_err(|never| match never {})
    }
}

fn request(frame: u16, part: Part) -> Vec<u8> {
    let mut packet = [0; CONTROL_CAPACITY];
    let len = encode_request(Request { frame, part }, &mut packet).unwrap();
    packet[..len].to_vec()
}

fn ack(frame: u16) -> Vec<u8> {
    let mut packet = [0; CONTROL_CAPACITY];
    let len = encode_ack(frame, &mut packet).unwrap();
    packet[..len].to_vec()
}

/// The frame as a sender alone sends it, and its end once more.
fn plain() -> (Vec<u8>, Vec<u8>) {
    let mut bytes = Vec::new();
    let mut sender = Sender::<_, CAPACITY>::new(&mut bytes);
    let format = PixelFormat::Gray8;
    sender.begin(FrameHeader { frame: FRAME, width: WIDTH, height: HEIGHT, format }).unwrap();
    (0..HEIGHT).for_each(|y| sender.row(y, &row(y)).unwrap());
    sender.end().unwrap();
    let before = sender.bytes_sent() as usize;
    sender.end_again().unwrap();
    let end = bytes.split_off(before);
    (bytes, end)
}

type Served<F> = (Result<Delivery, SendError<ErrorKind>>, Line<F>, Scene);

fn served<F: FnMut(&[u8]) -> Vec<u8>>(answer: F) -> Served<F> {
    let mut scene = Scene::new();
    let mut sender = Sender::<_, CAPACITY>::new(Line::new(answer));
    let delivery = serve(&mut scene, FRAME, &mut sender, &mut [Gray8(0); WIDTH as usize], PATIENCE);
    (delivery, sender.into_inner(), scene)
}

#[test]
fn a_frame_that_arrives_is_sent_once() {
    let (delivery, line, scene) = served(|_| ack(FRAME));
    assert_eq!(delivery, Ok(Delivery::Acknowledged { repairs: 0 }));
    assert_eq!(line.sent, plain().0);
    assert_eq!(scene.rendered, usize::from(HEIGHT));
    assert_eq!(line.looks, 0);
}

#[test]
fn every_part_is_sent_again_that_is_asked_for() {
    // The other end answers once to the frame, and acknowledges when all it asked for has come: each
    // part is as it was the first time.
    let (frame, end) = plain();
    let zeros: Vec<usize> = (0..frame.len()).filter(|at| frame[*at] == 0).collect();
    let header = frame[..=zeros[1]].to_vec();
    let third = frame[zeros[3] + 1..=zeros[4]].to_vec();
    let mut asked = false;
    let (delivery, line, scene) = served(|_| {
        let first = !std::mem::replace(&mut asked, true);
        if first {
            let parts = [Part::Header, Part::Row(2), Part::End, Part::Row(2)];
            return parts.map(|part| request(FRAME, part)).concat();
        }
        Vec::new()
    });
    assert_eq!(delivery, Ok(Delivery::Unheard));
    let repairs = [&header[..], &third, &end, &third].concat();
    assert_eq!(line.sent, [&frame[..], &repairs, &end, &end, &end].concat());
    assert_eq!(scene.rendered, usize::from(HEIGHT) + 2);
}

/// A receiver at the other end, behind a line that loses the first copy of some packets and puts
/// garbage before each answer.
#[test]
fn a_frame_with_losses_is_repaired_through_garbage() {
    for lost in 0..1_u32 << 7 {
        let (mut pixels, mut flags) = ([0; 30], [false; HEIGHT as usize]);
        let mut receiver = Receiver::new(&mut pixels, &mut flags);
        let mut decoder = Decoder::<CAPACITY>::new();
        let mut count = 0;
        let (delivery, line, _) = served(|mut bytes| {
            while let Some(packet) = decoder.feed(&mut bytes) {
                if lost >> count & 1 == 0 {
                    let _ = receiver.accept(&packet.unwrap());
                }
                count += 1;
            }
            let mut answer: Vec<u8> = (0..60_u8).map(|i| i.wrapping_mul(151)).collect();
            answer.push(0);
            receiver.requests().for_each(|r| answer.extend(request(r.frame, r.part)));
            if receiver.is_complete() {
                answer.extend(ack(FRAME));
            }
            answer
        });
        assert!(line.buffered.is_empty());
        drop(line);
        let repairs = match delivery {
            Ok(Delivery::Acknowledged { repairs }) => u32::from(repairs),
            other => panic!("{lost:07b}: {other:?}"),
        };
        // Of a lost end the sender itself says that it must be sent again.
        assert!(repairs >= (lost & 0b011_1111).count_ones(), "{lost:07b}: {repairs}");
        assert!(receiver.is_complete());
        let expected: Vec<u8> = (0..HEIGHT).flat_map(|y| row(y).map(|pixel| pixel.0)).collect();
        assert_eq!(receiver.pixels(), expected, "{lost:07b}");
    }
}

#[test]
fn silence_ends_after_so_many_looks() {
    let (frame, end) = plain();
    let (delivery, line, _) = served(|_| Vec::new());
    assert_eq!(delivery, Ok(Delivery::Unheard));
    assert_eq!(line.looks, PATIENCE.looks * PATIENCE.silences);
    assert_eq!(line.sent, [&frame[..], &end, &end, &end].concat());

    // Bytes that mean nothing don't break it: neither noise, nor packets of another frame's receiver.
    let (delivery, line, _) = served(|_| vec![0x5A, 0, 0xFF]);
    assert_eq!(delivery, Ok(Delivery::Unheard));
    assert_eq!(line.sent, [&frame[..], &end, &end, &end].concat());
    let mut count = 0;
    let (delivery, line, scene) = served(|_| {
        count += 1;
        match count {
            1 => [
                ack(FRAME + 1),
                request(FRAME + 1, Part::Row(0)),
                request(FRAME, Part::Row(HEIGHT)),
            ]
            .concat(),
            _ => Vec::new(),
        }
    });
    assert_eq!(delivery, Ok(Delivery::Unheard));
    assert_eq!(line.sent, [&frame[..], &end, &end, &end].concat());
    assert_eq!(scene.rendered, usize::from(HEIGHT));

    // No patience: the frame is sent, and that is all.
    for none in [Patience { looks: 0, silences: 0 }, Patience { looks: 9, silences: 0 }] {
        let mut sender = Sender::<_, CAPACITY>::new(Line::new(|_: &[u8]| Vec::new()));
        let mut pixels = [Gray8(0); WIDTH as usize];
        let delivery = serve(&mut Scene::new(), FRAME, &mut sender, &mut pixels, none);
        assert_eq!(delivery, Ok(Delivery::Unheard));
        assert_eq!(sender.into_inner().sent, frame);
    }
}

#[test]
fn what_fails_is_said() {
    let mut pixels = [Gray8(0); WIDTH as usize];
    let line = || Line::new(|_: &[u8]| Vec::new());

    let mut scene = Scene { breaks_at: 3, ..Scene::new() };
    let mut sender = Sender::<_, CAPACITY>::new(line());
    let result = serve(&mut scene, FRAME, &mut sender, &mut pixels, PATIENCE);
    assert_eq!(result, Err(SendError::Render(RowError::Range)));
    // Behind a `dyn`, and with memory for no row.
    let scene: &mut dyn RowSource<Pixel = Gray8> = &mut Scene::new();
    let result = serve(scene, FRAME, &mut sender, &mut pixels[1..], PATIENCE);
    assert_eq!(result, Err(SendError::Render(RowError::Length)));

    let mut small = Sender::<_, CONTROL_CAPACITY>::new(line());
    let result = serve(scene, FRAME, &mut small, &mut pixels, PATIENCE);
    assert_eq!(result, Err(SendError::Encode(EncodeError::BufferTooSmall)));

    for room in 0..plain().0.len() {
        sender.writer_mut().room = room;
        let result = serve(scene, FRAME, &mut sender, &mut pixels, PATIENCE);
        assert_eq!(result, Err(SendError::Io(ErrorKind::TimedOut)), "{room}");
    }
    sender.writer_mut().room = usize::MAX;
    sender.writer_mut().is_closed = true;
    let result = serve(scene, FRAME, &mut sender, &mut pixels, PATIENCE);
    assert_eq!(result, Err(SendError::Closed));
    assert_eq!(SendError::<ErrorKind>::Closed.as_str(), "line is closed at its other end");
}

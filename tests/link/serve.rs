//! The loop of firmware over a line in memory: what it sends, what it answers, and when it gives up.

#![allow(clippy::unwrap_used, clippy::panic)]

use embedded_io::{ErrorKind, ErrorType, Read, ReadReady, Write};
use scancsg::render::Palette;
use scancsg::render::{Gray8, RowError, RowSource, Size};
use scancsg::stream::Clock;
use scancsg::stream::{
    CONTROL_CAPACITY, Delivery, EncodeError, Event, FrameHeader, Looks, Memory, Part, Patience,
    PixelFormat, Plain, Receiver, Request, Sender, ServeError, Task, Timing, encode_ack,
    encode_request, packet_capacity, receive, row_capacity, serve,
};
use std::collections::VecDeque;

const WIDTH: u16 = 6;
const HEIGHT: u16 = 5;
const FRAME: u16 = 7;
const CAPACITY: usize = packet_capacity(WIDTH, PixelFormat::Gray8);
const PATIENCE: Patience = Patience { ticks: 4, silences: 3 };
const TIMING: Timing = Timing { ask: 50, give_up: 1000 };

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
    room: usize,
    is_closed: bool,
    is_broken: bool,
}

impl<F: FnMut(&[u8]) -> Vec<u8>> Line<F> {
    fn new(answer: F) -> Self {
        Self {
            buffered: Vec::new(),
            sent: Vec::new(),
            incoming: VecDeque::new(),
            answer,
            room: usize::MAX,
            is_closed: false,
            is_broken: false,
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
        if self.is_broken {
            return Err(ErrorKind::NotConnected);
        }
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

fn rows(y: u16, count: u16) -> Part {
    Part::Rows { y, count, limit: 127 }
}

fn header() -> FrameHeader {
    let (format, palette) = (PixelFormat::Gray8, Palette::EMPTY);
    FrameHeader { frame: FRAME, width: WIDTH, height: HEIGHT, format, palette }
}

/// The packets of a frame, as a sender alone sends them.
fn packets() -> Vec<Vec<u8>> {
    let mut packets = Vec::new();
    let mut sender = Sender::<_, CAPACITY>::new(Plain, PATIENCE);
    sender.begin(header()).unwrap();
    loop {
        match sender.poll(0) {
            Task::Send(packet) => {
                packets.push(packet.to_vec());
                sender.sent(0);
            }
            Task::Row(y) => sender.row(y, &row(y)).unwrap(),
            Task::Listen(_) | Task::Done(_) => return packets,
        }
    }
}

struct Served<F> {
    delivery: Result<Delivery, ServeError<ErrorKind>>,
    line: Line<F>,
    scene: Scene,
    looks: u32,
}

fn served_with<F: FnMut(&[u8]) -> Vec<u8>>(patience: Patience, answer: F) -> Served<F> {
    let mut scene = Scene::new();
    let mut sender = Sender::<_, CAPACITY>::new(Plain, patience);
    let mut line = Line::new(answer);
    let mut pixels = [Gray8(0); WIDTH as usize];
    let mut clock = Looks::new();
    let delivery = serve(&mut scene, FRAME, &mut sender, &mut line, &mut pixels, &mut clock);
    // Whatever happened, nothing waits in the device.
    assert!(line.buffered.is_empty());
    Served { delivery, line, scene, looks: clock.now() }
}

fn served<F: FnMut(&[u8]) -> Vec<u8>>(answer: F) -> Served<F> {
    served_with(PATIENCE, answer)
}

#[test]
fn a_frame_that_arrives_is_sent_once() {
    let served = served(|_| ack(FRAME));
    assert_eq!(served.delivery, Ok(Delivery::Acknowledged { repairs: 0 }));
    assert_eq!(served.line.sent, packets().concat());
    assert_eq!(served.scene.rendered, usize::from(HEIGHT));
    assert_eq!(served.looks, 0);
}

/// Everything that is asked for is sent, and flushed before the device listens: a part that is asked for
/// comes without a look in between.
#[test]
fn every_part_is_sent_again_that_is_asked_for() {
    let packets = packets();
    let (header, third, end) = (&packets[0], &packets[3], packets.last().unwrap());
    // The other end asks for one thing after the other, and acknowledges when all has come: each part is
    // as it was the first time, and the end is behind each.
    let parts = [Part::Header, rows(2, 1), Part::End, rows(2, 1), rows(1, 4)];
    let mut asked = parts.into_iter();
    let served = served(|_| asked.next().map_or_else(|| ack(FRAME), |part| request(FRAME, part)));
    assert_eq!(served.delivery, Ok(Delivery::Acknowledged { repairs: 5 }));
    let repairs = [header, end, third, end, end, third, end].map(Clone::clone).concat();
    let range = packets[2..].concat();
    assert_eq!(served.line.sent, [packets.concat(), repairs, range].concat());
    // A row that is wanted twice running is rendered once.
    assert_eq!(served.scene.rendered, usize::from(HEIGHT) + 1 + 4);
    assert_eq!(served.looks, 0);

    // All at once, and rows in whatever order.
    let mut asked = false;
    let served = self::served(|_| {
        let parts = [Part::Header, rows(4, 1), Part::End, rows(2, 1)];
        match std::mem::replace(&mut asked, true) {
            false => parts.map(|part| request(FRAME, part)).concat(),
            true => ack(FRAME),
        }
    });
    assert_eq!(served.delivery, Ok(Delivery::Acknowledged { repairs: 4 }));
    let last = &packets[5];
    let sent = |rows: [&Vec<u8>; 2]| {
        let repairs = [header, rows[0], rows[1], end].map(Clone::clone).concat();
        served.line.sent == [packets.concat(), repairs].concat()
    };
    assert!(sent([third, last]) || sent([last, third]), "{:?}", served.line.sent);
    assert!(served.scene.rendered <= usize::from(HEIGHT) + 2);
}

/// A receiver at the other end, behind a line that loses the first copy of some packets and puts
/// garbage before each answer.
#[test]
fn a_frame_with_losses_is_repaired_through_garbage() {
    for lost in 0..1_u32 << 7 {
        let (mut pixels, mut flags) = ([0; 30], [false; HEIGHT as usize]);
        let memory = Memory { pixels: &mut pixels, rows: &mut flags, above: &mut [] };
        let mut receiver = Receiver::<CAPACITY>::new(memory, TIMING);
        let mut count = 0;
        let mut now = 0;
        let patience = Patience { ticks: 4, silences: 20 };
        let served = served_with(patience, |bytes| {
            now += 10;
            for packet in bytes.split_inclusive(|byte| *byte == 0).filter(|packet| packet.len() > 1)
            {
                let mut packet = packet;
                while lost >> count & 1 == 0 && receiver.receive(&mut packet, now).is_some() {}
                count += 1;
            }
            receiver.poll(now);
            let mut answer: Vec<u8> = (0..60_u8).map(|i| i.wrapping_mul(151)).collect();
            while let Some(bytes) = receiver.answer() {
                answer.extend_from_slice(bytes);
            }
            answer
        });
        let repairs = match served.delivery {
            Ok(Delivery::Acknowledged { repairs }) => u32::from(repairs),
            other => panic!("{lost:07b}: {other:?}"),
        };
        drop(served.line);
        // Rows that are missing one below the other are one request, all of them where the header was lost.
        // Of a lost end the sender itself says that it must be sent again.
        let rows = lost >> 1 & 0b1_1111;
        let ranges = (rows & !(rows << 1)).count_ones();
        let least = if lost & 1 == 1 { 2 } else { ranges };
        assert!(repairs >= least, "{lost:07b}: {repairs}");
        assert!(receiver.frame().is_complete());
        let expected: Vec<u8> = (0..HEIGHT).flat_map(|y| row(y).map(|pixel| pixel.0)).collect();
        assert_eq!(receiver.frame().pixels(), expected, "{lost:07b}");
    }
}

#[test]
fn silence_ends_after_so_many_looks() {
    let frame = packets().concat();
    let end = packets().pop().unwrap();
    let silence = [&frame[..], &end, &end].concat();
    let is_silence = |delivery, sent: &[u8], looks| {
        assert_eq!(delivery, Ok(Delivery::Unheard));
        assert_eq!(sent, silence);
        assert_eq!(looks, PATIENCE.ticks * u32::from(PATIENCE.silences));
    };
    let Served { delivery, line, looks, .. } = served(|_| Vec::new());
    is_silence(delivery, &line.sent, looks);

    // Bytes that mean nothing don't break it: neither noise, nor packets of another frame's receiver.
    let Served { delivery, line, looks, .. } = served(|_| vec![0x5A, 0, 0xFF]);
    is_silence(delivery, &line.sent, looks);
    let mut count = 0;
    let Served { delivery, line, looks, scene } = served(|_| {
        count += 1;
        match count {
            1 => [ack(FRAME + 1), request(FRAME + 1, rows(0, 1))].concat(),
            _ => Vec::new(),
        }
    });
    is_silence(delivery, &line.sent, looks);
    assert_eq!(scene.rendered, usize::from(HEIGHT));

    // Nor does a request of the frame's own for rows that it hasn't: it shows that somebody is there, with another
    // header.
    let mut count = 0;
    let Served { delivery, line, scene, .. } = served(|_| {
        count += 1;
        let no_row = [rows(HEIGHT, 1), rows(u16::MAX, u16::MAX), rows(0, 0)];
        no_row.map(|part| request(FRAME, part)).concat().repeat(usize::from(count == 1))
    });
    assert_eq!(delivery, Ok(Delivery::Unheard));
    let again = [&frame[..], &packets()[0]].concat();
    assert!(line.sent.starts_with(&again));
    assert!(line.sent[again.len()..].chunks(end.len()).all(|packet| packet == end));
    assert!(line.sent.len() < frame.len() + 9 * end.len());
    assert_eq!(scene.rendered, usize::from(HEIGHT));

    // No patience: the frame is sent, and that is all.
    for none in [Patience { ticks: 0, silences: 0 }, Patience { ticks: 9, silences: 0 }] {
        let Served { delivery, line, looks, .. } = served_with(none, |_| Vec::new());
        assert_eq!(delivery, Ok(Delivery::Unheard));
        assert_eq!(line.sent, frame);
        assert_eq!(looks, 0);
    }
    let instant = Patience { ticks: 0, silences: 9 };
    assert_eq!(served_with(instant, |_| Vec::new()).delivery, Ok(Delivery::Unheard));
}

#[test]
fn what_fails_is_said() {
    let mut pixels = [Gray8(0); WIDTH as usize];
    let mut line = Line::new(|_: &[u8]| Vec::new());
    let mut sender = Sender::<_, CAPACITY>::new(Plain, PATIENCE);
    let mut clock = Looks::new();

    let mut scene = Scene { breaks_at: 3, ..Scene::new() };
    let result = serve(&mut scene, FRAME, &mut sender, &mut line, &mut pixels, &mut clock);
    assert_eq!(result, Err(ServeError::Render(RowError::Range)));
    // Behind a `dyn`, and with memory for no row.
    let scene: &mut dyn RowSource<Pixel = Gray8> = &mut Scene::new();
    let result = serve(scene, FRAME, &mut sender, &mut line, &mut pixels[1..], &mut clock);
    assert_eq!(result, Err(ServeError::Render(RowError::Length)));

    let mut small =
        Sender::<_, { row_capacity(WIDTH, PixelFormat::Gray8) - 1 }>::new(Plain, PATIENCE);
    let result = serve(scene, FRAME, &mut small, &mut line, &mut pixels, &mut clock);
    assert_eq!(result, Err(ServeError::Encode(EncodeError::BufferTooSmall)));

    for room in 0..packets().concat().len() {
        line.room = room;
        let result = serve(scene, FRAME, &mut sender, &mut line, &mut pixels, &mut clock);
        assert_eq!(result, Err(ServeError::Write(ErrorKind::TimedOut)), "{room}");
    }
    line.room = usize::MAX;
    line.is_closed = true;
    let result = serve(scene, FRAME, &mut sender, &mut line, &mut pixels, &mut clock);
    assert_eq!(result, Err(ServeError::Closed));
    assert_eq!(ServeError::<ErrorKind>::Closed.as_str(), "line is closed at its other end");
    line.is_broken = true;
    let result = serve(scene, FRAME, &mut sender, &mut line, &mut pixels, &mut clock);
    assert_eq!(result, Err(ServeError::Read(ErrorKind::NotConnected)));
    // And then it works again.
    let mut line = Line::new(|_: &[u8]| ack(FRAME));
    let result = serve(scene, FRAME, &mut sender, &mut line, &mut pixels, &mut clock);
    assert_eq!(result, Ok(Delivery::Acknowledged { repairs: 0 }));
    assert_eq!(line.sent, packets().concat());
}

/// The receiver's loop: events one by one, the answer on the line, and silence when nothing comes.
#[test]
fn a_receiver_listens_and_answers() {
    let mut line = Line::new(|_: &[u8]| Vec::new());
    let (mut pixels, mut flags) = ([0; 30], [false; HEIGHT as usize]);
    let memory = Memory { pixels: &mut pixels, rows: &mut flags, above: &mut [] };
    let mut receiver = Receiver::<CAPACITY>::new(memory, TIMING);
    let mut clock = Looks::new();

    line.incoming.extend(packets().concat());
    let mut events = Vec::new();
    while events.last() != Some(&Event::Complete) {
        events.push(receive(&mut receiver, &mut line, &mut clock).unwrap());
    }
    assert_eq!(events.len(), usize::from(HEIGHT) + 2);
    assert_eq!(line.sent, ack(FRAME));

    // A frame that breaks off: it asks, each time later, and gives up.
    line.sent.clear();
    let next = FrameHeader { frame: FRAME + 1, ..header() };
    let mut packet = [0; CONTROL_CAPACITY];
    let len = scancsg::stream::encode_header(next, &mut packet).unwrap();
    line.incoming.extend(&packet[..len]);
    let event = receive(&mut receiver, &mut line, &mut clock);
    assert!(matches!(event, Ok(Event::Started { lost: None, .. })));
    let before = clock.now();
    let event = receive(&mut receiver, &mut line, &mut clock);
    assert_eq!(event, Ok(Event::Silent { frame: FRAME + 1 }));
    assert_eq!(clock.now() - before, TIMING.give_up);
    let asks = line.sent.split(|byte| *byte == 0).filter(|packet| !packet.is_empty()).count();
    assert!((2..10).contains(&asks), "{asks}");

    line.is_closed = true;
    let result = receive(&mut receiver, &mut line, &mut clock);
    assert_eq!(result, Err(ServeError::Closed));
    line.is_broken = true;
    let result = receive(&mut receiver, &mut line, &mut clock);
    assert_eq!(result, Err(ServeError::Read(ErrorKind::NotConnected)));
}

/// Where no answer can be written, every event comes all the same, and the error when there is none.
#[test]
fn an_answer_that_cannot_be_written_costs_no_event() {
    let mut line = Line { room: 0, ..Line::new(|_: &[u8]| Vec::new()) };
    let (mut pixels, mut flags) = ([0; 30], [false; HEIGHT as usize]);
    let memory = Memory { pixels: &mut pixels, rows: &mut flags, above: &mut [] };
    let mut receiver = Receiver::<CAPACITY>::new(memory, TIMING);
    let mut clock = Looks::new();

    line.incoming.extend(packets().concat());
    let mut events = Vec::new();
    while !line.incoming.is_empty() {
        events.push(receive(&mut receiver, &mut line, &mut clock).unwrap());
    }
    assert_eq!(events.last(), Some(&Event::Complete));
    // A frame that breaks off: nothing but the question fails.
    line.incoming.extend(&packets()[..1].concat());
    assert_eq!(receive(&mut receiver, &mut line, &mut clock), Ok(Event::Repeated));
    let next = FrameHeader { frame: FRAME + 1, ..header() };
    let mut packet = [0; CONTROL_CAPACITY];
    let len = scancsg::stream::encode_header(next, &mut packet).unwrap();
    line.incoming.extend(&packet[..len]);
    let event = receive(&mut receiver, &mut line, &mut clock);
    assert!(matches!(event, Ok(Event::Started { .. })));
    let result = receive(&mut receiver, &mut line, &mut clock);
    assert!(matches!(result, Err(ServeError::Write(_))), "{result:?}");
}

/// A complete frame and a silent line: the clock goes on, so that the caller's own patience can end.
#[test]
fn noise_that_never_stops_does_not_hold_a_frame() {
    /// Noise without end, and a clock that ticks at each byte.
    struct Noise(u32);
    impl ErrorType for Noise {
        type Error = ErrorKind;
    }
    impl ReadReady for Noise {
        fn read_ready(&mut self) -> Result<bool, ErrorKind> {
            Ok(true)
        }
    }
    impl Read for Noise {
        fn read(&mut self, bytes: &mut [u8]) -> Result<usize, ErrorKind> {
            for byte in bytes.iter_mut() {
                self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                *byte = (self.0 >> 24) as u8;
            }
            Ok(bytes.len())
        }
    }
    impl Write for Noise {
        fn write(&mut self, bytes: &[u8]) -> Result<usize, ErrorKind> {
            Ok(bytes.len())
        }
        fn flush(&mut self) -> Result<(), ErrorKind> {
            Ok(())
        }
    }
    struct Ticks(u32);
    impl Clock for Ticks {
        fn now(&mut self) -> u32 {
            self.0 = self.0.wrapping_add(1);
            self.0
        }
        fn idle(&mut self, _: u32) {}
    }

    let (mut pixels, mut flags) = ([0; 30], [false; HEIGHT as usize]);
    let memory = Memory { pixels: &mut pixels, rows: &mut flags, above: &mut [] };
    let mut receiver = Receiver::<CAPACITY>::new(memory, TIMING);
    let begin = packets()[0].clone();
    assert!(receiver.receive(&mut &begin[..], 0).is_some());
    let event = receive(&mut receiver, &mut Noise(1), &mut Ticks(0));
    assert_eq!(event, Ok(Event::Silent { frame: FRAME }));

    let mut sender = Sender::<_, CAPACITY>::new(Plain, PATIENCE);
    let mut pixels = [Gray8(0); WIDTH as usize];
    let result =
        serve(&mut Scene::new(), FRAME, &mut sender, &mut Noise(2), &mut pixels, &mut Ticks(0));
    assert_eq!(result, Ok(Delivery::Unheard));
}

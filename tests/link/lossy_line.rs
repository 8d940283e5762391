//! Frames over lossy lines in simulated time: every one arrives, whole and right, and in good time.
//!
//! `SCANCSG_FRAMES=1000 cargo test --release --test link lossy_line -- --nocapture` runs so many frames each, and
//! shows the figures.

#![allow(clippy::unwrap_used, clippy::panic)]

use crate::scene;

use scene::Scene;

use scancsg::render::{Gray8, Lambert, Palette, Picture, RowSource, Size};
use scancsg::stream::faults::{Counts, Faults, Line};
use scancsg::stream::{
    Delivery, Event, FrameHeader, Memory, Patience, PixelFormat, Plain, Predictive, Receiver,
    RowCoding, Sender, Task, Timing, packet_capacity,
};
use std::collections::VecDeque;

const WIDTH: u16 = 80;
const HEIGHT: u16 = 60;
const CAPACITY: usize = packet_capacity(WIDTH, PixelFormat::Gray8);

type Row = [Gray8; WIDTH as usize];

/// The rows of a picture that is different in every frame.
struct Film(Vec<Row>);

impl Film {
    fn new() -> Self {
        let tee = f32::TEE;
        let camera = f32::orthographic().unwrap();
        let light = Lambert::new(f32::TO_LIGHT, 0.125).unwrap();
        let size = Size::new(WIDTH, HEIGHT).unwrap();
        let mut picture = Picture::new(&tee, &camera, size, light, Gray8(0));
        let render = |y| {
            let mut row = [Gray8(0); WIDTH as usize];
            picture.render(y, &mut row).unwrap();
            row
        };
        Self((0..HEIGHT).map(render).collect())
    }

    /// The picture, pushed up and aside a bit more each time.
    fn row(&self, frame: u16, y: u16) -> Row {
        let mut row = self.0[usize::from((y + frame) % HEIGHT)];
        row.rotate_left(usize::from(frame / HEIGHT) % usize::from(WIDTH));
        row
    }

    fn is_row(&self, frame: u16, y: u16, bytes: &[u8]) -> bool {
        self.row(frame, y).iter().map(|pixel| pixel.0).eq(bytes.iter().copied())
    }
}

/// A line and its two ends. A tick is the time of a byte at 115,200 baud; a fast line carries more.
#[derive(Clone, Copy)]
struct Setup {
    frames: u16,
    /// Bytes a tick, and ticks that a row takes to be rendered.
    speed: usize,
    rendering: u32,
    /// Ticks that a byte is under way, each way.
    latency: u32,
    patience: Patience,
    timing: Timing,
    there: Faults,
    back: Faults,
    seed: u64,
}

/// What came of it.
#[derive(Debug)]
struct Outcome {
    complete: usize,
    wrong_rows: usize,
    unheard: usize,
    silent: usize,
    ticks: u32,
    bytes: u64,
    there: Counts,
    back: Counts,
}

/// Sends frames through a line whose sending end has a receive buffer of `BACK` bytes, which is emptied
/// between packets and rows and while the sender listens, as `serve` does.
fn run<C: RowCoding<Gray8>, const BACK: usize>(coding: C, film: &Film, setup: Setup) -> Outcome {
    let Setup { frames, speed, rendering, latency, .. } = setup;
    let mut there = Line::<65_536>::new(setup.there, setup.seed);
    let mut back = Line::<BACK>::new(setup.back, setup.seed + 1);
    let mut sender = Sender::<C, CAPACITY>::new(coding, setup.patience);
    let mut pixels = [0; WIDTH as usize * HEIGHT as usize];
    let mut rows = [false; HEIGHT as usize];
    let mut above = [0; WIDTH as usize + 2];
    let memory = Memory { pixels: &mut pixels, rows: &mut rows, above: &mut above };
    let mut receiver = Receiver::<CAPACITY>::new(memory, setup.timing);

    let (mut complete, mut wrong_rows, mut unheard, mut silent) = (vec![false; 65_536], 0, 0, 0);
    let (mut writing, mut answering) = (VecDeque::<u8>::new(), VecDeque::<u8>::new());
    // Bytes, and when they arrive.
    let mut under_way = [VecDeque::<(u32, u8)>::new(), VecDeque::new()];
    let (mut frame, mut now, mut busy) = (0, 0_u32, 0);
    let (mut wanted, mut rendered) = (None, None);
    let (format, palette) = (PixelFormat::Gray8, Palette::EMPTY);
    let header = |frame| FrameHeader { frame, width: WIDTH, height: HEIGHT, format, palette };
    sender.begin(header(0)).unwrap();
    let most = 4_000_000 + u32::from(frames) * 1_000_000;
    while frame < frames {
        now += 1;
        assert!(now < most, "stuck in frame {frame}");
        // The sender, for a tick.
        let mut room = speed;
        while room > 0 && busy <= now {
            if !writing.is_empty() {
                let count = room.min(writing.len());
                under_way[0].extend(writing.drain(..count).map(|byte| (now + latency, byte)));
                room -= count;
                if writing.is_empty() {
                    sender.sent(now);
                }
                continue;
            }
            if let Some(y) = wanted.take() {
                sender.row(y, &film.row(frame, y)).unwrap();
            }
            while let Some(byte) = back.pop(now) {
                sender.receive(byte, now);
            }
            match sender.poll(now) {
                Task::Send(packet) => writing.extend(packet),
                Task::Row(y) => {
                    wanted = Some(y);
                    if rendered != Some((frame, y)) {
                        rendered = Some((frame, y));
                        busy = now + rendering;
                    }
                }
                Task::Listen(ticks) => {
                    assert!(ticks > 0);
                    break;
                }
                Task::Done(delivery) => {
                    unheard += usize::from(delivery == Delivery::Unheard);
                    frame += 1;
                    sender.begin(header(frame)).unwrap();
                    // Until the next picture is asked for.
                    if frame == frames {
                        break;
                    }
                }
            }
        }
        while let Some((_, byte)) = under_way[0].pop_front_if(|(at, _)| *at <= now) {
            there.push(byte, now);
        }
        // The receiver.
        while let Some(byte) = there.pop(now) {
            let Some(event) = receiver.receive(&mut &[byte][..], now) else { continue };
            let taken = receiver.frame();
            let id = taken.header().map_or(0, |header| header.frame);
            let mut check = |y| {
                let is_wrong = taken.row(y).is_none_or(|bytes| !film.is_row(id, y, bytes));
                wrong_rows += usize::from(is_wrong);
            };
            match event {
                Event::Rows { y, count } => (y..y + u16::from(count)).for_each(check),
                Event::Complete => {
                    (0..HEIGHT).for_each(&mut check);
                    assert!(!std::mem::replace(&mut complete[usize::from(id)], true));
                }
                _ => {}
            }
        }
        silent += usize::from(receiver.poll(now).is_some());
        while let Some(answer) = receiver.answer() {
            answering.extend(answer);
        }
        let count = speed.min(answering.len());
        under_way[1].extend(answering.drain(..count).map(|byte| (now + latency, byte)));
        while let Some((_, byte)) = under_way[1].pop_front_if(|(at, _)| *at <= now) {
            back.push(byte, now);
        }
    }
    let complete = complete.iter().filter(|complete| **complete).count();
    let (bytes, there, back) = (sender.bytes_sent(), *there.counts(), *back.counts());
    Outcome { complete, wrong_rows, unheard, silent, ticks: now, bytes, there, back }
}

fn predictive() -> Predictive<Gray8, { WIDTH as usize }> {
    Predictive::new()
}

fn frames(few: u16) -> u16 {
    std::env::var("SCANCSG_FRAMES").ok().map_or(few, |frames| frames.parse().unwrap())
}

/// Every frame arrives and is acknowledged.
#[track_caller]
fn all_arrive<const BACK: usize>(name: &str, film: &Film, setup: Setup) {
    let plain = run::<_, BACK>(Plain, film, setup);
    is_whole(name, "plain", setup, &plain);
    let predictive = run::<_, BACK>(predictive(), film, setup);
    is_whole(name, "predictive", setup, &predictive);
}

#[track_caller]
fn is_whole(name: &str, coding: &str, setup: Setup, outcome: &Outcome) {
    let frames = usize::from(setup.frames);
    println!(
        "{name:24} {coding:10} {:4} of {frames}, {:6} bytes and {:7} ticks a frame",
        outcome.complete,
        outcome.bytes / frames as u64,
        outcome.ticks / frames as u32,
    );
    assert_eq!(outcome.complete, frames, "{name}, {coding}: {outcome:?}");
    assert_eq!(outcome.wrong_rows, 0, "{name}, {coding}: {outcome:?}");
    assert_eq!((outcome.unheard, outcome.silent), (0, 0), "{name}, {coding}: {outcome:?}");
}

const BYTES: Faults = Faults { flipped: 0.001, ..Faults::NONE };

fn both_ways(frames: u16, faults: Faults) -> Setup {
    let patience = Patience { ticks: 10_000, silences: 60 };
    let timing = Timing { ask: 1_000, give_up: 400_000 };
    let (there, back) = (faults, faults);
    Setup { frames, speed: 1, rendering: 30, latency: 0, patience, timing, there, back, seed: 1 }
}

#[test]
fn clean() {
    let setup = both_ways(frames(12), Faults::NONE);
    let film = Film::new();
    all_arrive::<64>("clean", &film, setup);
    // Nothing is asked for that isn't missing.
    let outcome = run::<_, 64>(Plain, &film, setup);
    assert_eq!(outcome.there.packets, u64::from(setup.frames) * (u64::from(HEIGHT) + 2));
    assert_eq!(outcome.back.packets, u64::from(setup.frames));
}

/// A picture that takes its time: the receiver asks before a packet of several rows is full, and rows that
/// are still to come are not sent twice for that.
#[test]
fn a_slow_picture() {
    let film = Film::new();
    let quick = both_ways(3, Faults::NONE);
    for rendering in [500, 2_500, 6_000] {
        let slow = Setup { rendering, ..quick };
        let packets = |setup| {
            let plain = run::<_, 64>(Plain, &film, setup);
            let predictive = run::<_, 64>(predictive(), &film, setup);
            [plain, predictive].map(|outcome| outcome.there.packets)
        };
        let [quick, slow] = [quick, slow].map(packets);
        assert_eq!(slow, quick, "{rendering}");
        println!("a slow picture: {slow:?} packets, {quick:?} of a quick one");
    }
}

#[test]
fn flipped_bits() {
    let film = Film::new();
    for (name, flipped) in [("flipped 0.001", 0.001), ("flipped 0.01", 0.01)] {
        let faults = Faults { flipped, ..Faults::NONE };
        all_arrive::<64>(name, &film, both_ways(frames(12), faults));
    }
}

#[test]
fn lost_bytes() {
    let film = Film::new();
    for (name, dropped) in [("lost bytes 0.001", 0.001), ("lost bytes 0.01", 0.01)] {
        let faults = Faults { dropped, ..Faults::NONE };
        all_arrive::<64>(name, &film, both_ways(frames(12), faults));
    }
}

/// Requests are still under way when the sender is done: what is asked for twice is not a storm.
#[test]
fn a_slow_way_back() {
    let film = Film::new();
    for (name, faults) in [
        ("16 ms, flipped 0.01", Faults { flipped: 0.01, ..Faults::NONE }),
        ("16 ms, lost 0.2", Faults { packets_dropped: 0.2, ..Faults::NONE }),
        ("16 ms, everything", EVERYTHING),
    ] {
        let setup = Setup { latency: 184, ..both_ways(frames(12), faults) };
        all_arrive::<64>(name, &film, setup);
        all_arrive::<1>(name, &film, setup);
    }
}

#[test]
fn lost_packets() {
    let film = Film::new();
    for (name, packets_dropped) in [("lost packets 0.05", 0.05), ("lost packets 0.2", 0.2)] {
        let faults = Faults { packets_dropped, ..Faults::NONE };
        all_arrive::<64>(name, &film, both_ways(frames(12), faults));
    }
}

/// A serial port without a FIFO: what comes while the sender renders or writes is lost.
#[test]
fn a_receive_buffer_of_one_byte() {
    let film = Film::new();
    all_arrive::<1>("one byte, flipped 0.001", &film, both_ways(frames(12), BYTES));
    let faults = Faults { packets_dropped: 0.05, ..Faults::NONE };
    all_arrive::<1>("one byte, lost 0.05", &film, both_ways(frames(12), faults));
}

#[test]
fn bursts() {
    let film = Film::new();
    let faults = Faults { bursts: 1.0 / 4096.0, burst_bytes: 512, ..Faults::NONE };
    all_arrive::<64>("bursts", &film, both_ways(frames(12), faults));
}

/// A copy that comes late must not be taken for a part of another frame.
#[test]
fn late_copies() {
    let film = Film::new();
    let faults = Faults { packets_repeated: 0.2, ..Faults::NONE };
    all_arrive::<64>("late copies", &film, both_ways(frames(12), faults));
    let faults = Faults { packets_dropped: 0.1, ..faults };
    all_arrive::<64>("late copies, lost 0.1", &film, both_ways(frames(12), faults));
}

#[test]
fn stalls() {
    let film = Film::new();
    let faults = Faults { stalls: 0.001, stall_ticks: 3_000, ..BYTES };
    all_arrive::<64>("stalls", &film, both_ways(frames(12), faults));
}

const EVERYTHING: Faults = Faults {
    flipped: 0.001,
    dropped: 0.001,
    packets_dropped: 0.05,
    packets_repeated: 0.05,
    bursts: 1.0 / 4096.0,
    burst_bytes: 512,
    stalls: 0.0005,
    stall_ticks: 1_000,
    cut: None,
};

#[test]
fn everything_at_once() {
    let film = Film::new();
    for seed in [1, 100] {
        let setup = Setup { seed, ..both_ways(frames(12), EVERYTHING) };
        all_arrive::<64>("everything", &film, setup);
        all_arrive::<1>("everything, one byte", &film, setup);
    }
}

/// One byte in a thousand costs less than the time of the frames once more: on a serial port, and on a
/// line that is so fast that only waiting costs time.
#[test]
fn repair_does_not_wait() {
    let film = Film::new();
    for (name, speed, rendering, latency) in [
        ("serial", 1, 30, 0),
        ("serial, 5 ms under way", 1, 30, 58),
        ("fast", 200, 0, 0),
        ("fast, under way", 200, 0, 5),
        ("fast, slow device", 200, 5, 0),
    ] {
        let clean = Setup { speed, rendering, latency, ..both_ways(frames(16), Faults::NONE) };
        let noisy = Setup { there: BYTES, back: BYTES, ..clean };
        let in_time = |coding, [clean, noisy]: [u32; 2]| {
            let ratio = f64::from(noisy) / f64::from(clean);
            println!(
                "{name}, {coding}: {clean} ticks, with one byte in 1000 {noisy}, × {ratio:.2}"
            );
            assert!(noisy <= 2 * clean, "{name}, {coding}: {noisy} > 2 · {clean}");
        };
        let setups = [clean, noisy];
        in_time("plain", setups.map(|setup| run::<_, 64>(Plain, &film, setup).ticks));
        in_time("predictive", setups.map(|setup| run::<_, 64>(predictive(), &film, setup).ticks));
    }
}

/// The receiver vanishes, or its way back does: the sender is done in bounded time, with every frame.
#[test]
fn nobody_answers() {
    let film = Film::new();
    let impatient = Setup {
        patience: Patience { ticks: 1_000, silences: 5 },
        timing: Timing { ask: 1_000, give_up: 10_000 },
        ..both_ways(3, Faults::NONE)
    };
    for cut in [0, 5, 15] {
        let back = Faults { cut: Some(cut), ..BYTES };
        let setup = Setup { back, there: BYTES, ..impatient };
        let outcome = run::<_, 64>(Plain, &film, setup);
        assert!(outcome.unheard > 0, "{cut}: {outcome:?}");
        assert!(outcome.ticks < 3 * 15_000, "{cut}: {outcome:?}");
        assert_eq!(outcome.wrong_rows, 0);
    }
    // The line itself: the receiver notices too.
    let there = Faults { cut: Some(2_000), ..Faults::NONE };
    let setup = Setup { there, ..impatient };
    let outcome = run::<_, 64>(Plain, &film, setup);
    assert_eq!((outcome.unheard, outcome.silent, outcome.complete), (3, 1, 0), "{outcome:?}");
}

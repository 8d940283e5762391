//! Uploads: a part goes to a device, and a picture comes back, whatever the line does in between.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

use crc::Crc;
use embedded_io::{ErrorKind, ErrorType, Read, ReadReady, Write};
use scancsg::program::BytesError;
use scancsg::render::{Gray8, Palette};
use scancsg::stream::faults::{Faults, Line};
use scancsg::stream::{
    Delivery, Device, Event, FrameHeader, Inbox, Looks, Memory, Outcome, Patience, PixelFormat,
    Plain, Receiver, Refusal, Sender, ServeError, Task, Timing, Upload, UploadTask, encode_ack,
    packet_capacity, take,
};
use std::collections::VecDeque;
use testkit::random::Random;

const WIDTH: u16 = 40;
const HEIGHT: u16 = 30;
const CAPACITY: usize = packet_capacity(WIDTH, PixelFormat::Gray8);
/// A device's memory for an upload.
const ROOM: usize = 2000;
/// A tick is the time of a byte.
const HOST: Patience = Patience { ticks: 1_000, silences: 120 };
const DEVICE: Patience = Patience { ticks: 2_000, silences: 8 };
const TIMING: Timing = Timing { ask: 1_000, give_up: 20_000 };

/// Any bytes, with many zeros.
fn part(seed: u64, length: usize) -> Vec<u8> {
    let mut random = Random::seeded(seed);
    (0..length).map(|_| if random.chance(0.3) { 0 } else { random.below(256) as u8 }).collect()
}

/// The picture of a part: any other part has another one.
fn row(part: &[u8], y: u16) -> [Gray8; WIDTH as usize] {
    std::array::from_fn(|x| {
        let at = usize::from(y) * usize::from(WIDTH) + x;
        Gray8(part[at % part.len()] ^ (part.len() % 251) as u8)
    })
}

/// A device: it waits for a part, sends its picture, and waits for the next.
struct Machine<'m> {
    inbox: Inbox<'m>,
    sender: Sender<Plain, CAPACITY>,
    part: Option<Vec<u8>>,
    frame: u16,
    writing: VecDeque<u8>,
    is_packet: bool,
    delivered: usize,
}

impl<'m> Machine<'m> {
    fn new(memory: &'m mut [u8]) -> Self {
        let sender = Sender::new(Plain, DEVICE);
        let (inbox, writing) = (Inbox::new(memory, 32), VecDeque::new());
        Self { inbox, sender, part: None, frame: 0, writing, is_packet: false, delivered: 0 }
    }

    /// What the device does in a tick.
    fn step<const N: usize>(
        &mut self,
        heard: &mut Line<N>,
        now: u32,
        refuses: impl Fn(&[u8]) -> Option<Refusal>,
    ) -> Option<u8> {
        if self.writing.is_empty() && std::mem::take(&mut self.is_packet) {
            self.sender.sent(now);
        }
        while self.writing.is_empty() {
            if self.part.is_none() {
                self.writing.extend(self.inbox.answer().unwrap_or_default());
                let Some(byte) = heard.pop(now).filter(|_| self.writing.is_empty()) else { break };
                if self.inbox.receive(byte) {
                    let bytes = self.inbox.bytes().to_vec();
                    if let Some(why) = refuses(&bytes) {
                        self.inbox.refuse(why);
                        continue;
                    }
                    let (frame, format) = (self.frame, PixelFormat::Gray8);
                    let palette = Palette::EMPTY;
                    let header =
                        FrameHeader { frame, width: WIDTH, height: HEIGHT, format, palette };
                    self.sender.begin(header).unwrap();
                    (self.part, self.frame) = (Some(bytes), frame + 1);
                }
                continue;
            }
            while let Some(byte) = heard.pop(now) {
                self.sender.receive(byte, now);
            }
            let part = self.part.as_deref().unwrap_or_default();
            match self.sender.poll(now) {
                Task::Send(packet) => {
                    self.writing.extend(packet);
                    self.is_packet = true;
                }
                Task::Row(y) => self.sender.row(y, &row(part, y)).unwrap(),
                Task::Listen(_) => break,
                Task::Done(delivery) => {
                    self.part = None;
                    self.delivered += usize::from(delivery != Delivery::Unheard);
                }
            }
        }
        self.writing.pop_front()
    }
}

/// What it took to get the picture of a part.
#[derive(Debug, Default)]
struct Figures {
    ticks: u32,
    uploads: u32,
}

/// A line with faults, both ways, and the device at its other end.
struct World {
    there: Line<64>,
    back: Line<65_536>,
    now: u32,
    /// The device is switched off and on again after so many ticks, each time.
    reset: Option<u32>,
}

impl World {
    fn new(faults: Faults, seed: u64) -> Self {
        let (there, back) = (Line::new(faults, seed), Line::new(faults, seed + 1));
        Self { there, back, now: 0, reset: None }
    }

    /// A tick in which the host says this byte. What it hears.
    fn tick(&mut self, machine: &mut Machine<'_>, said: Option<u8>) -> Vec<u8> {
        self.now += 1;
        if self.reset.is_some_and(|every| self.now.is_multiple_of(every)) {
            let reset = Sender::new(Plain, DEVICE);
            (machine.sender, machine.part, machine.frame) = (reset, None, 0);
            machine.writing.clear();
            machine.is_packet = false;
            machine.inbox = Inbox::new(Vec::leak(vec![0; ROOM]), 32);
        }
        if let Some(byte) = said {
            self.there.push(byte, self.now);
        }
        if let Some(byte) = machine.step(&mut self.there, self.now, |_| None) {
            self.back.push(byte, self.now);
        }
        std::iter::from_fn(|| self.back.pop(self.now)).collect()
    }

    /// Sends a part, and receives its picture; again, if the device falls silent.
    fn picture(&mut self, machine: &mut Machine<'_>, part: &[u8]) -> Figures {
        let begin = self.now;
        let mut figures = Figures::default();
        loop {
            figures.uploads += 1;
            assert!(figures.uploads < 40, "no picture");
            if self.upload_and_receive(machine, part) {
                figures.ticks = self.now - begin;
                return figures;
            }
        }
    }

    fn upload_and_receive(&mut self, machine: &mut Machine<'_>, part: &[u8]) -> bool {
        let mut upload = Upload::new(part, HOST);
        let (mut saying, mut kept) = (VecDeque::new(), Vec::new());
        loop {
            if saying.is_empty() {
                match upload.poll(self.now) {
                    UploadTask::Send(bytes) => {
                        saying.extend(bytes);
                        kept.clear();
                    }
                    UploadTask::Listen(ticks) => assert!(ticks > 0 && ticks <= HOST.ticks),
                    UploadTask::Done(outcome) => {
                        assert_eq!(outcome, Outcome::Taken);
                        break;
                    }
                }
            }
            let said = saying.pop_front();
            let is_last = said.is_some() && saying.is_empty();
            let heard = self.tick(machine, said);
            if is_last {
                upload.sent(self.now);
            }
            heard.iter().for_each(|byte| upload.receive(*byte, self.now));
            kept.extend(heard);
        }
        let device = Device { capacity: ROOM as u16, number: 32 };
        assert_eq!((upload.device(), upload.delivered()), (Some(device), part.len()));

        let mut pixels = [0; WIDTH as usize * HEIGHT as usize];
        let mut rows = [false; HEIGHT as usize];
        let memory = Memory { pixels: &mut pixels, rows: &mut rows, above: &mut [] };
        let mut receiver = Receiver::<CAPACITY>::new(memory, TIMING);
        let since = self.now;
        let mut is_here = false;
        loop {
            let mut bytes = &kept[..];
            while let Some(event) = receiver.receive(&mut bytes, self.now) {
                is_here |= event == Event::Complete;
            }
            let is_silent = receiver.poll(self.now).is_some();
            while let Some(answer) = receiver.answer() {
                saying.extend(answer);
            }
            if is_here && saying.is_empty() {
                let wanted = (0..HEIGHT).flat_map(|y| row(part, y).map(|pixel| pixel.0));
                assert!(receiver.frame().pixels().iter().copied().eq(wanted));
                return true;
            }
            if is_silent || self.now - since > 40 * TIMING.give_up {
                return false;
            }
            kept = self.tick(machine, saying.pop_front());
        }
    }
}

const LENGTHS: [usize; 8] = [1, 14, 239, 240, 241, 480, 1234, ROOM];

/// A picture of each length of parts, over a line with faults.
#[track_caller]
fn pictures(name: &str, faults: Faults, reset: Option<u32>) {
    for seed in 0..3 {
        let mut memory = [0; ROOM];
        let mut machine = Machine::new(&mut memory);
        let mut world = World { reset, ..World::new(faults, 10 * seed) };
        for length in LENGTHS {
            let figures = world.picture(&mut machine, &part(seed, length));
            println!("{name}: {length} bytes, {figures:?}");
        }
    }
}

#[test]
fn a_part_goes_there_and_its_picture_comes_back() {
    let mut memory = [0; ROOM];
    let mut machine = Machine::new(&mut memory);
    let mut world = World::new(Faults::NONE, 1);
    for length in LENGTHS {
        // A chunk for each 240 bytes, one that hands over, and the acknowledgement: nothing is sent twice.
        let before = world.there.counts().packets;
        let figures = world.picture(&mut machine, &part(1, length));
        assert_eq!(figures.uploads, 1);
        let packets = world.there.counts().packets - before;
        assert_eq!(packets, length.div_ceil(240) as u64 + 2, "{length}");
    }
    assert_eq!(machine.frame, LENGTHS.len() as u16);
    // What the device handed over is gone: the same part again is sent again, and pictured again.
    let same = part(1, ROOM);
    let before = world.there.counts().packets;
    world.picture(&mut machine, &same);
    assert_eq!(world.there.counts().packets - before, ROOM.div_ceil(240) as u64 + 2);
    assert_eq!(machine.frame, LENGTHS.len() as u16 + 1);
}

#[test]
fn over_a_line_that_loses_and_damages() {
    pictures("flipped 0.001", Faults { flipped: 0.001, ..Faults::NONE }, None);
    pictures("flipped 0.01", Faults { flipped: 0.01, ..Faults::NONE }, None);
    pictures("lost bytes 0.01", Faults { dropped: 0.01, ..Faults::NONE }, None);
    pictures("lost packets 0.2", Faults { packets_dropped: 0.2, ..Faults::NONE }, None);
}

#[test]
fn over_a_line_that_repeats_and_delays() {
    let repeated = Faults { packets_repeated: 0.3, ..Faults::NONE };
    pictures("twice 0.3", repeated, None);
    pictures("twice 0.3, lost 0.1", Faults { packets_dropped: 0.1, ..repeated }, None);
    pictures("stalls", Faults { stalls: 0.001, stall_ticks: 3_000, ..repeated }, None);
}

#[test]
fn over_a_line_with_everything() {
    let everything = Faults {
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
    pictures("everything", everything, None);
}

/// Whatever the device did when it was reset, it gets the part anew.
#[test]
fn to_a_device_that_is_reset() {
    for every in [9_001, 17_011] {
        pictures("resets", Faults::NONE, Some(every));
        pictures("resets, flipped 0.001", Faults { flipped: 0.001, ..Faults::NONE }, Some(every));
    }
}

/// What both ends say to each other until the upload is over.
fn outcome(inbox: &mut Inbox<'_>, upload: &mut Upload<'_>, refuse: Option<Refusal>) -> Outcome {
    let mut now = 0;
    loop {
        match upload.poll(now) {
            UploadTask::Send(bytes) => {
                for byte in bytes {
                    if inbox.receive(*byte) {
                        inbox.refuse(refuse.unwrap());
                    }
                }
                upload.sent(now);
                let answer = inbox.answer().unwrap_or_default();
                answer.iter().for_each(|byte| upload.receive(*byte, now));
            }
            UploadTask::Listen(ticks) => now += ticks,
            UploadTask::Done(outcome) => return outcome,
        }
    }
}

#[test]
fn a_device_says_what_it_takes_and_why_it_does_not() {
    let mut memory = [0; 100];
    let mut inbox = Inbox::new(&mut memory, 16);
    let device = Some(Device { capacity: 100, number: 16 });
    let mut question = Upload::new(&[], HOST);
    assert_eq!(outcome(&mut inbox, &mut question, None), Outcome::Taken);
    assert_eq!(question.device(), device);

    // At its first packet, and not after all bytes.
    let long = part(1, 101);
    let mut upload = Upload::new(&long, HOST);
    assert_eq!(outcome(&mut inbox, &mut upload, None), Outcome::Refused(Refusal::TooLong));
    assert_eq!((upload.delivered(), upload.device()), (0, device));

    for why in [Refusal::Number, Refusal::Kind, Refusal::TooLarge, Refusal::Invalid] {
        let bad = part(why as u64, 100);
        let mut upload = Upload::new(&bad, HOST);
        assert_eq!(outcome(&mut inbox, &mut upload, Some(why)), Outcome::Refused(why));
        assert_eq!(upload.delivered(), 100);
        // The same bytes are refused at once, and others are asked for.
        let mut again = Upload::new(&bad, HOST);
        assert_eq!(outcome(&mut inbox, &mut again, None), Outcome::Refused(why));
        assert_eq!(again.delivered(), 0);
    }

    // More than a packet can say.
    let beyond = vec![0; 65_536];
    assert_eq!(
        Upload::new(&beyond, HOST).poll(0),
        UploadTask::Done(Outcome::Refused(Refusal::TooLong))
    );
}

#[test]
fn what_is_wrong_with_a_program_is_what_the_device_says() {
    for (error, refusal) in [
        (BytesError::Number, Refusal::Number),
        (BytesError::Kind, Refusal::Kind),
        (BytesError::Tree, Refusal::TooLarge),
        (BytesError::Magic, Refusal::Invalid),
        (BytesError::Solid, Refusal::Invalid),
    ] {
        assert_eq!(Refusal::from(error), refusal);
    }
}

/// The packet that an upload sends now.
fn packet(upload: &mut Upload<'_>) -> Vec<u8> {
    match upload.poll(0) {
        UploadTask::Send(bytes) => {
            let bytes = bytes.to_vec();
            upload.sent(0);
            bytes
        }
        other => panic!("{other:?}"),
    }
}

/// The inbox gets a packet. Its answer, and how often it hands something over.
fn answer(inbox: &mut Inbox<'_>, packet: &[u8]) -> (Vec<u8>, usize) {
    let given = packet.iter().filter(|byte| inbox.receive(**byte)).count();
    (inbox.answer().unwrap_or_default().to_vec(), given)
}

fn hear(upload: &mut Upload<'_>, answer: &[u8]) {
    answer.iter().for_each(|byte| upload.receive(*byte, 0));
}

/// All packets of an upload, from an inbox of its own.
fn packets(part: &[u8]) -> Vec<Vec<u8>> {
    let mut memory = [0; ROOM];
    let (mut inbox, mut upload) = (Inbox::new(&mut memory, 0), Upload::new(part, HOST));
    let mut packets = Vec::new();
    loop {
        let next = packet(&mut upload);
        let (said, given) = answer(&mut inbox, &next);
        packets.push(next);
        if given > 0 {
            return packets;
        }
        hear(&mut upload, &said);
    }
}

#[test]
fn chunks_in_any_order_and_of_other_uploads_do_no_harm() {
    let (ours, other) = (part(1, 700), part(2, 700));
    let [first, second, third, last] = &packets(&ours)[..] else { panic!("not four packets") };
    let others = packets(&other);
    let mut memory = [0; ROOM];
    let mut inbox = Inbox::new(&mut memory, 0);
    let mut take = |packet: &[u8]| answer(&mut inbox, packet).1;
    // Late ones of another upload, those that come too early, and those that come again.
    for packet in [first, &others[1], third, second, last, first, &others[2], &others[3], second] {
        assert_eq!(take(packet), 0);
    }
    assert_eq!((take(third), take(last)), (0, 1));
    // It is handed over once.
    assert_eq!((take(last), take(third), take(last)), (0, 0, 0));
    assert_eq!(inbox.bytes(), ours);
    // The start of another one ends what was there.
    assert_eq!(others.iter().map(|packet| answer(&mut inbox, packet).1).sum::<usize>(), 1);
    assert_eq!(inbox.bytes(), other);
}

#[test]
fn an_answer_that_comes_twice_is_heard_once() {
    let part = part(1, 700);
    let mut memory = [0; ROOM];
    let (mut inbox, mut upload) = (Inbox::new(&mut memory, 0), Upload::new(&part, HOST));
    let (first, _) = answer(&mut inbox, &packet(&mut upload));
    hear(&mut upload, &first);
    let (second, _) = answer(&mut inbox, &packet(&mut upload));
    hear(&mut upload, &first);
    assert_eq!(upload.poll(0), UploadTask::Listen(HOST.ticks));
    hear(&mut upload, &second);
    let third = packet(&mut upload);
    assert_eq!(upload.delivered(), 480);
    for _ in 0..9 {
        hear(&mut upload, &second);
        assert_eq!(upload.poll(0), UploadTask::Listen(HOST.ticks));
    }
    // An earlier one is heard: the device may have been reset. It costs a packet, and no more.
    hear(&mut upload, &first);
    let (again, _) = answer(&mut inbox, &packet(&mut upload));
    assert_eq!(again, second);
    hear(&mut upload, &again);
    assert_eq!(packet(&mut upload), third);
}

#[test]
fn a_frame_is_the_answer_to_a_whole_upload_only() {
    let part = part(1, 300);
    let (format, palette) = (PixelFormat::Gray8, Palette::EMPTY);
    let header = FrameHeader { frame: 3, width: WIDTH, height: HEIGHT, format, palette };
    let mut frame = [0; 64];
    let length = scancsg::stream::encode_header(header, &mut frame).unwrap();
    let frame = &frame[..length];
    let mut memory = [0; ROOM];
    let (mut inbox, mut upload) = (Inbox::new(&mut memory, 0), Upload::new(&part, HOST));
    // Until all bytes are there, frames are earlier ones.
    let (first, _) = answer(&mut inbox, &packet(&mut upload));
    hear(&mut upload, frame);
    hear(&mut upload, &first);
    let (second, _) = answer(&mut inbox, &packet(&mut upload));
    hear(&mut upload, frame);
    hear(&mut upload, &second);
    hear(&mut upload, frame);
    assert_eq!(answer(&mut inbox, &packet(&mut upload)).1, 1);
    // A late answer comes before the frame.
    hear(&mut upload, &first);
    packet(&mut upload);
    // What this end says itself, as an echo, is no frame.
    let mut ack = [0; 16];
    let length = encode_ack(3, &mut ack).unwrap();
    hear(&mut upload, &ack[..length]);
    assert_eq!(upload.poll(0), UploadTask::Listen(HOST.ticks));
    hear(&mut upload, frame);
    assert_eq!(upload.poll(0), UploadTask::Done(Outcome::Taken));
    assert_eq!(upload.delivered(), 300);
    hear(&mut upload, &first);
    assert_eq!(upload.poll(0), UploadTask::Done(Outcome::Taken));
    assert_eq!(upload.delivered(), 300);
}

/// Another upload begins, even if by no bytes, before the device has looked at the last one.
#[test]
fn what_is_refused_is_what_was_handed_over() {
    let [first, second] = [part(1, 300), part(2, 400)];
    let mut memory = [0; ROOM];
    let mut inbox = Inbox::new(&mut memory, 32);
    let handed_over = |inbox: &mut Inbox<'_>, part: &[u8]| {
        packets(part).iter().map(|packet| answer(inbox, packet).1).sum::<usize>()
    };
    assert_eq!(handed_over(&mut inbox, &first), 1);
    assert_eq!(inbox.bytes(), first);
    // Length 400, the CRC-32, offset 0.
    let crc = Crc::<u32>::new(&crc::CRC_32_ISO_HDLC);
    let mut begin =
        [&[0x83, 0x90, 0x01][..], &crc.checksum(&second).to_le_bytes(), &[0, 0]].concat();
    begin.extend(crc.checksum(&begin).to_le_bytes());
    let mut line = [0; 32];
    let length = cobs::encode(&begin, &mut line);
    assert_eq!(answer(&mut inbox, &line[..=length]).1, 0);
    assert!(inbox.bytes().is_empty());
    inbox.refuse(Refusal::Invalid);
    assert_eq!(handed_over(&mut inbox, &second), 1);
    assert_eq!(inbox.bytes(), second);
}

/// A serial port in memory, which says what it gets. It closes, or fails, behind the last byte.
struct Port {
    incoming: VecDeque<u8>,
    written: Vec<u8>,
    flushed: usize,
    end: Result<(), ErrorKind>,
}

impl ErrorType for Port {
    type Error = ErrorKind;
}

impl Read for Port {
    fn read(&mut self, bytes: &mut [u8]) -> Result<usize, ErrorKind> {
        match self.incoming.pop_front() {
            Some(byte) => {
                bytes[0] = byte;
                Ok(1)
            }
            None => self.end.map(|()| 0),
        }
    }
}

impl ReadReady for Port {
    fn read_ready(&mut self) -> Result<bool, ErrorKind> {
        Ok(true)
    }
}

impl Write for Port {
    fn write(&mut self, bytes: &[u8]) -> Result<usize, ErrorKind> {
        // A byte at a time, as a serial port takes them.
        self.written.push(bytes[0]);
        Ok(1)
    }

    fn flush(&mut self) -> Result<(), ErrorKind> {
        self.flushed = self.written.len();
        Ok(())
    }
}

#[test]
fn the_loop_of_a_device_answers_and_returns_what_is_whole() {
    let part = part(1, 300);
    let mut memory = [0; ROOM];
    let mut wanted = Vec::new();
    let mut inbox = Inbox::new(&mut memory, 0);
    let packets = packets(&part);
    packets.iter().for_each(|packet| wanted.extend(answer(&mut inbox, packet).0));
    assert!(!wanted.is_empty());

    let incoming = packets.concat().into();
    let mut port = Port { incoming, written: Vec::new(), flushed: 0, end: Ok(()) };
    let mut memory = [0; ROOM];
    let mut inbox = Inbox::new(&mut memory, 0);
    assert_eq!(take(&mut inbox, &mut port, &mut Looks::new()).unwrap(), part);
    assert_eq!((port.flushed, &port.written), (wanted.len(), &wanted));
    // A refusal is said by the next call. Then the line has no more.
    inbox.refuse(Refusal::Kind);
    assert_eq!(take(&mut inbox, &mut port, &mut Looks::new()), Err(ServeError::Closed));
    let mut upload = Upload::new(&part, HOST);
    hear(&mut upload, &port.written[wanted.len()..]);
    assert_eq!(upload.poll(0), UploadTask::Done(Outcome::Refused(Refusal::Kind)));
    port.end = Err(ErrorKind::TimedOut);
    let failure = ServeError::Read(ErrorKind::TimedOut);
    assert_eq!(take(&mut inbox, &mut port, &mut Looks::new()), Err(failure));
}

/// Nobody is there: so many times is a chunk sent, each time shorter, and no more.
#[test]
fn nobody_answers() {
    let part = part(1, 1000);
    let patience = Patience { ticks: 50, silences: 6 };
    let mut upload = Upload::new(&part, patience);
    let (mut now, mut lengths) = (u32::MAX - 70, Vec::new());
    let outcome = loop {
        match upload.poll(now) {
            UploadTask::Send(bytes) => {
                lengths.push(bytes.len());
                upload.sent(now);
            }
            UploadTask::Listen(ticks) => now = now.wrapping_add(ticks),
            UploadTask::Done(outcome) => break outcome,
        }
    };
    assert_eq!((outcome, upload.device()), (Outcome::Unheard, None));
    assert_eq!(lengths.len(), 6);
    assert!(lengths.windows(2).all(|pair| pair[0] >= pair[1]) && lengths[5] < 40, "{lengths:?}");
}

/// A device that loses what it has, again and again, isn't tried for ever.
#[test]
fn a_device_that_forgets_is_given_up() {
    let part = part(1, 500);
    let mut upload = Upload::new(&part, Patience { ticks: 50, silences: 6 });
    let mut sent = 0;
    let outcome = loop {
        match upload.poll(0) {
            UploadTask::Send(bytes) => {
                sent += 1;
                assert!(sent < 100, "no end");
                let mut memory = [0; ROOM];
                let mut inbox = Inbox::new(&mut memory, 32);
                bytes.iter().for_each(|byte| assert!(!inbox.receive(*byte)));
                let answer = inbox.answer().unwrap().to_vec();
                upload.sent(0);
                answer.iter().for_each(|byte| upload.receive(*byte, 0));
            }
            UploadTask::Listen(_) => panic!("each chunk is answered"),
            UploadTask::Done(outcome) => break outcome,
        }
    };
    assert_eq!(outcome, Outcome::Unheard);
}

/// A device is reset once, and a tenth of all packets gets lost: an upload is given up only if nothing was heard as
/// often in a row as there is patience. What was lost before the reset doesn't count behind it.
#[test]
fn a_reset_does_not_use_up_patience() {
    const PATIENCE: Patience = Patience { ticks: 50, silences: 4 };
    let (mut random, mut unheard) = (Random::seeded(19), 0);
    for seed in 0..1_000 {
        let part = part(seed, ROOM);
        let mut upload = Upload::new(&part, PATIENCE);
        let mut memories = [[0; ROOM]; 2];
        let [before, after] = &mut memories;
        let (mut inbox, mut after) = (Inbox::new(before, 32), Some(after));
        let reset = random.below(10);
        let (mut now, mut sent, mut lost_in_a_row) = (0, 0, 0);
        loop {
            match upload.poll(now) {
                UploadTask::Send(bytes) => {
                    sent += 1;
                    if let Some(after) = after.take_if(|_| sent > reset) {
                        inbox = Inbox::new(after, 32);
                    }
                    let is_there = !random.chance(0.1);
                    let is_whole = is_there && bytes.iter().any(|byte| inbox.receive(*byte));
                    upload.sent(now);
                    if is_whole {
                        assert_eq!(inbox.bytes(), part);
                        break;
                    }
                    let answer = inbox.answer().filter(|_| !random.chance(0.1)).unwrap_or_default();
                    hear(&mut upload, answer);
                    lost_in_a_row = if answer.is_empty() { lost_in_a_row + 1 } else { 0 };
                }
                UploadTask::Listen(ticks) => now += ticks,
                UploadTask::Done(outcome) => {
                    assert_eq!((outcome, lost_in_a_row), (Outcome::Unheard, PATIENCE.silences));
                    unheard += 1;
                    break;
                }
            }
        }
    }
    // A packet and its answer come through with 0.81: four times in a row they don't, once in 770.
    assert!((1..=40).contains(&unheard), "{unheard} of 1,000");
}

//! What must hold of the link and of programs whatever the bytes are. A function fails by a panic.
//!
//! `tests/programs/hostile.rs` runs these with some bytes of its own at every test.

mod program;

pub use program::program;

use scancsg::render::{Gray8, Mono, Palette, Rgb, Rgb565, Rgb888};
use scancsg::stream::{
    Assembler, Decoder, Event, FrameHash, FrameHeader, Inbox, Memory, Outcome, Packet, Part,
    Patience, PixelFormat, Plain, Predictive, PredictiveMono, Receiver, Refusal, Request,
    RowCoding, RowHash, Sender, Task, Timing, Upload, UploadTask, Wire, encode_ack, encode_request,
    packet_capacity,
};

/// The largest frame's width and height here.
const WIDTH: u16 = 48;
const HEIGHT: u16 = 24;
const CAPACITY: usize = packet_capacity(WIDTH, PixelFormat::Rgb888);
const PATIENCE: Patience = Patience { ticks: 100, silences: 3 };
const TIMING: Timing = Timing { ask: 50, give_up: 1000 };

/// Bytes as a script. Behind its end, it reads zeros.
struct Script<'a>(&'a [u8]);

impl<'a> Script<'a> {
    fn byte(&mut self) -> u8 {
        self.take(1).first().copied().unwrap_or(0)
    }

    fn word(&mut self) -> u16 {
        u16::from_le_bytes([self.byte(), self.byte()])
    }

    fn take(&mut self, count: usize) -> &'a [u8] {
        let (taken, rest) = self.0.split_at(count.min(self.0.len()));
        self.0 = rest;
        taken
    }

    /// A header of a frame, most often one that fits.
    fn header(&mut self) -> FrameHeader {
        let format = PixelFormat::from_code(self.byte() % 4).expect("there are four");
        let (width, height) = match self.byte() {
            255 => (self.word(), self.word()),
            width => (u16::from(width) % WIDTH + 1, u16::from(self.byte()) % HEIGHT + 1),
        };
        let colors = self.byte() % 9;
        let palette = (0..colors).map(|_| Rgb::new(self.byte(), self.byte(), self.byte()));
        let palette: Palette = palette.collect();
        FrameHeader { frame: u16::from(self.byte() % 4), width, height, format, palette }
    }
}

/// The CRC-32 of any bytes.
fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0_u32, |crc, byte| {
        (0..8).fold(crc ^ u32::from(*byte), |crc, _| {
            (crc >> 1) ^ (0xEDB8_8320 & (crc & 1).wrapping_neg())
        })
    })
}

/// A packet with a right checksum around any contents.
fn sealed(content: &[u8]) -> Vec<u8> {
    let crc = crc(content);
    let mut packet = vec![0];
    let mut code = 0;
    for byte in content.iter().copied().chain(crc.to_le_bytes()) {
        if packet.len() - code == 255 {
            packet[code] = 255;
            code = packet.len();
            packet.push(0);
        }
        if byte == 0 {
            packet[code] = (packet.len() - code) as u8;
            code = packet.len();
        }
        packet.push(byte);
    }
    packet[code] = (packet.len() - code) as u8;
    packet.push(0);
    packet
}

/// Any bytes: fed at once or one by one they give the same, there is no more than one result for each
/// zero and each packet that is too long, and a good packet behind them is found.
pub fn decoder(bytes: &[u8]) {
    fn check<const N: usize>(bytes: &[u8]) {
        let mut ack = [0; 16];
        let len = encode_ack(7, &mut ack).expect("there is room");
        let line = [bytes, &ack[..len]].concat();
        let mut fed = Vec::new();
        let mut decoder = Decoder::<N>::new();
        let mut rest = &line[..];
        while let Some(result) = decoder.feed(&mut rest) {
            if let Ok(Packet::Row { payload, .. }) = result {
                for code in 0..4 {
                    let format = PixelFormat::from_code(code).expect("there are four");
                    let mut row = [0xA5; 96];
                    for len in [0, 1, 7, 96] {
                        if payload.unpack(format, &mut row[..len]).is_err() {
                            assert!(row.iter().all(|byte| *byte == 0xA5));
                        }
                        row.fill(0xA5);
                    }
                }
            }
            fed.push(format!("{result:?}"));
        }
        let mut decoder = Decoder::<N>::new();
        let pushed = line.iter().filter_map(|byte| decoder.push(*byte).map(|r| format!("{r:?}")));
        assert!(pushed.eq(fed.iter().cloned()));
        let zeros = line.iter().filter(|byte| **byte == 0).count();
        assert!(fed.len() <= zeros + 1);
        assert!(N < 16 || fed.last().is_some_and(|last| last == "Ok(Ack { frame: 7 })"));
    }
    check::<0>(bytes);
    check::<5>(bytes);
    check::<32>(bytes);
    check::<CAPACITY>(bytes);
    // And with a right checksum, so that all of it is read.
    check::<CAPACITY>(&sealed(bytes));
}

/// Any payload is rows or is refused, and rows that are here stay as they are; any pixels arrive.
pub fn rows(bytes: &[u8]) {
    let mut script = Script(bytes);
    let header = script.header();
    let mut store = Store::new();
    let mut frame = Assembler::new(store.memory());
    if frame.accept(&Packet::Header(header)).is_ok() {
        let id = header.frame;
        for _ in 0..2 {
            let (y, count) = (script.word() % (HEIGHT + 2), script.byte() % 8);
            let taken = usize::from(script.byte());
            let payload = script.take(taken);
            let before = rows_here(&frame);
            let result = frame.accept(&Packet::Rows { frame: id, y, count, payload });
            let after = rows_here(&frame);
            assert!(before.iter().all(|row| after.contains(row)));
            assert!(result.is_ok() || before == after);
            is_consistent(&frame);
        }
    }
    let header = FrameHeader { width: header.width % WIDTH + 1, height: 3, ..header };
    let pixels = script.0;
    let at = |y: u16, x: u16| {
        let i = usize::from(y) * usize::from(header.width) + usize::from(x);
        [0, 1, 2].map(|channel| *pixels.get((3 * i + channel) % pixels.len().max(1)).unwrap_or(&0))
    };
    const W: usize = WIDTH as usize;
    match header.format {
        PixelFormat::Gray8 => {
            arrives(Predictive::<Gray8, W>::new(), header, |y, x| Gray8(at(y, x)[0]))
        }
        PixelFormat::Rgb565 => arrives(Predictive::<Rgb565, W>::new(), header, |y, x| {
            let [low, high, _] = at(y, x);
            Rgb565(u16::from_le_bytes([low, high]))
        }),
        PixelFormat::Rgb888 => {
            arrives(Predictive::<Rgb888, W>::new(), header, |y, x| Rgb888(at(y, x)));
        }
        _ => arrives(PredictiveMono::<W>::new(), header, |y, x| Mono(at(y, x)[0] & 1 == 1)),
    }
}

/// The memory of a receiver.
struct Store {
    pixels: Vec<u8>,
    rows: Vec<bool>,
    above: Vec<u16>,
}

impl Store {
    fn new() -> Self {
        let pixels = vec![0; 3 * usize::from(WIDTH) * usize::from(HEIGHT)];
        let above = vec![0; usize::from(WIDTH) + 2];
        Self { pixels, rows: vec![false; HEIGHT.into()], above }
    }

    fn memory(&mut self) -> Memory<'_> {
        Memory { pixels: &mut self.pixels, rows: &mut self.rows, above: &mut self.above }
    }
}

fn rows_here(frame: &Assembler<'_>) -> Vec<(u16, Vec<u8>)> {
    (0..HEIGHT).filter_map(|y| frame.row(y).map(|row| (y, row.to_vec()))).collect()
}

/// What a frame says of itself is the same, whichever way it is asked.
fn is_consistent(frame: &Assembler<'_>) {
    let height = frame.header().map_or(0, |header| header.height);
    assert_eq!(frame.missing().count(), usize::from(height - frame.rows_received()));
    assert!(frame.gaps().flat_map(|(y, count)| y..y + count).eq(frame.missing()));
    let here = (0..height).filter(|y| frame.row(*y).is_some()).count();
    assert_eq!(here, usize::from(frame.rows_received()));
    assert!((height..=height + 3).all(|y| frame.row(y).is_none()));
    let bytes = frame.header().and_then(|header| header.frame_bytes());
    assert_eq!(frame.pixels().len(), bytes.unwrap_or(0));
    assert!(!frame.is_complete() || frame.rows_received() == height && height > 0);
}

/// A frame goes from a sender to a receiver.
fn arrives<P: Wire + scancsg::stream::WirePixel<Wire = P>, C: RowCoding<P>>(
    coding: C,
    header: FrameHeader,
    pixel: impl Fn(u16, u16) -> P,
) {
    let mut sender = Sender::<C, CAPACITY>::new(coding, PATIENCE);
    let mut store = Store::new();
    let mut receiver = Receiver::<CAPACITY>::new(store.memory(), TIMING);
    sender.begin(header).expect("the buffer is large enough");
    let mut hash = FrameHash::new();
    let mut hashed = 0;
    let mut last = None;
    loop {
        match sender.poll(0) {
            Task::Send(packet) => {
                let mut packet = packet;
                while let Some(event) = receiver.receive(&mut packet, 0) {
                    last = Some(event);
                }
                sender.sent(0);
            }
            Task::Row(y) => {
                let row: Vec<P> = (0..header.width).map(|x| pixel(y, x)).collect();
                if y == hashed {
                    hash.add(RowHash::of(y, &row));
                    hashed += 1;
                }
                sender.row(y, &row).expect("this row was wanted");
            }
            Task::Listen(_) | Task::Done(_) => break,
        }
    }
    assert_eq!(last, Some(Event::Complete));
    assert_eq!(receiver.frame().header(), Some(header));
    assert_eq!(hash_of(receiver.frame()), hash);
}

fn hash_of(frame: &Assembler<'_>) -> FrameHash {
    let mut hash = FrameHash::new();
    for (y, row) in rows_here(frame) {
        let mut row_hash = RowHash::new(y);
        row_hash.update(&row);
        hash.add(row_hash.finish());
    }
    hash
}

/// A receiver that gets any bytes, and packets with right checksums among them, at any times: it keeps
/// what it has, says little, gives up in time, and takes in a clean frame after all that.
pub fn receiver(bytes: &[u8]) {
    let mut script = Script(bytes);
    let mut store = Store::new();
    let mut receiver = Receiver::<CAPACITY>::new(store.memory(), TIMING);
    let mut now = u32::from(script.byte()).wrapping_sub(100);
    // The hash that the sender would have said.
    while !script.0.is_empty() {
        let packet = match script.byte() % 8 {
            0 => {
                let count = script.byte().into();
                script.take(count).to_vec()
            }
            1 => {
                now = now.wrapping_add(script.word().into());
                Vec::new()
            }
            2 => {
                let mut packet = [0; 64];
                let header = script.header();
                let len = scancsg::stream::encode_header(header, &mut packet);
                packet[..len.unwrap_or(0)].to_vec()
            }
            3 => {
                let mut hash = hash_of(receiver.frame());
                hash.add(u32::from(script.byte() / 200));
                let frame = receiver.frame().header().map_or(0, |header| header.frame);
                let mut packet = [0; 64];
                let len = scancsg::stream::encode_end(frame, hash, &mut packet);
                packet[..len.unwrap_or(0)].to_vec()
            }
            4 => {
                let kind = script.byte();
                let count = script.byte().into();
                sealed(&[&[kind], script.take(count)].concat())
            }
            kind => {
                let [frame, y] = [script.byte() % 4, script.byte() % 32];
                let count = script.byte().into();
                let start = [2 + kind / 6 * 2, frame, 0, y, 0, script.byte() % 5];
                sealed(&[&start, script.take(count)].concat())
            }
        };
        let mut rest = &packet[..];
        while let Some(event) = receiver.receive(&mut rest, now) {
            is_consistent(receiver.frame());
            let is_complete = matches!(event, Event::Complete | Event::CompleteAgain);
            assert!(!is_complete || receiver.frame().is_complete());
        }
        receiver.poll(now);
        let mut answers = 0;
        while let Some(mut answer) = receiver.answer() {
            answers += 1;
            let packet = Decoder::<32>::new().feed(&mut answer).map(|packet| packet.is_ok());
            assert_eq!(packet, Some(true));
        }
        assert!(answers <= 8, "{answers} answers");
    }
    // Silence has an end.
    let mut events = 0;
    for _ in 0..=TIMING.give_up {
        now = now.wrapping_add(1);
        events += u32::from(receiver.poll(now).is_some());
        while receiver.answer().is_some() {}
    }
    assert!(events <= 1);
    now = now.wrapping_add(1);
    assert_eq!(receiver.poll(now), None);
    assert!(receiver.answer().is_none());

    let header = FrameHeader {
        frame: 9,
        width: 5,
        height: 7,
        format: PixelFormat::Gray8,
        palette: Palette::EMPTY,
    };
    let row = |y: u16| [y as u8, 1, 2, 3, 3].map(Gray8);
    let mut sender = Sender::<_, CAPACITY>::new(Plain, PATIENCE);
    sender.begin(header).expect("the buffer is large enough");
    let mut last = None;
    loop {
        match sender.poll(0) {
            Task::Send(mut packet) => {
                while let Some(event) = receiver.receive(&mut packet, now) {
                    last = Some(event);
                }
                sender.sent(0);
            }
            Task::Row(y) => sender.row(y, &row(y)).expect("this row was wanted"),
            Task::Listen(_) | Task::Done(_) => break,
        }
    }
    assert_eq!(last, Some(Event::Complete));
    assert!((0..7).all(|y| receiver.frame().row(y) == Some(&row(y).map(|pixel| pixel.0)[..])));
}

/// A sender that hears any bytes, and packets with right checksums among them, at any times: it wants rows
/// that there are, and is done in bounded time when nobody says more.
pub fn sender(bytes: &[u8]) {
    let mut script = Script(bytes);
    let header = FrameHeader {
        frame: 1,
        width: u16::from(script.byte()) % WIDTH + 1,
        height: u16::from(script.byte()) % HEIGHT + 1,
        format: PixelFormat::Gray8,
        palette: Palette::EMPTY,
    };
    let mut sender =
        Sender::<_, CAPACITY>::new(Predictive::<Gray8, { WIDTH as usize }>::new(), PATIENCE);
    sender.begin(header).expect("the buffer is large enough");
    let mut store = Store::new();
    let mut receiver = Receiver::<CAPACITY>::new(store.memory(), TIMING);
    let pixels = script.byte();
    let mut now = u32::from(script.byte()).wrapping_sub(100);
    let mut after = 0;
    let mut is_complete = false;
    loop {
        let packet = match script.byte() % 6 {
            _ if script.0.is_empty() => {
                after += 1;
                Vec::new()
            }
            0 => {
                let count = script.byte() % 32;
                script.take(count.into()).to_vec()
            }
            1 => {
                now = now.wrapping_add(u32::from(script.byte()) % 64);
                Vec::new()
            }
            2 => {
                let part = match script.byte() % 4 {
                    0 => Part::Header,
                    1 => Part::End,
                    _ => {
                        let (y, count) = (script.word() % (HEIGHT + 2), script.byte().into());
                        Part::Rows { y, count, limit: script.byte() }
                    }
                };
                let mut packet = [0; 32];
                let request = Request { frame: u16::from(script.byte() % 8 != 0), part };
                let len = encode_request(request, &mut packet).unwrap_or(0);
                packet[..len].to_vec()
            }
            3 => {
                let kind = script.byte();
                let count = script.byte() % 16;
                sealed(&[&[kind], script.take(count.into())].concat())
            }
            _ => Vec::new(),
        };
        packet.iter().for_each(|byte| sender.receive(*byte, now));
        // Rows, repairs, silences: each has a bound.
        assert!(after < 2_000, "no end");
        let mut is_done = false;
        for _ in 0..3 {
            match sender.poll(now) {
                Task::Send(packet) => {
                    let mut packet = packet;
                    assert!(!packet.is_empty() && packet.ends_with(&[0]));
                    while let Some(event) = receiver.receive(&mut packet, now) {
                        assert!(!matches!(event, Event::Refused(_) | Event::HashMismatch));
                        is_complete |= event == Event::Complete;
                    }
                    sender.sent(now);
                }
                Task::Row(y) => {
                    assert!(y < header.height);
                    let level = |x: u16| Gray8((x * y) as u8 & pixels);
                    let row: Vec<Gray8> = (0..header.width).map(level).collect();
                    sender.row(y, &row).expect("this row was wanted");
                }
                Task::Listen(ticks) => {
                    assert!(ticks > 0 && ticks <= PATIENCE.ticks);
                    now = now.wrapping_add(if script.0.is_empty() { ticks } else { 1 });
                }
                Task::Done(_) => {
                    is_done = true;
                    break;
                }
            }
        }
        if is_done && script.0.is_empty() {
            break;
        }
    }
    // Nothing was lost on this line, whatever was asked for.
    assert!(is_complete);
}

/// A device's inbox that gets any bytes, and chunks of some uploads among them: what it hands over is whole, it says
/// one thing at a time, and it takes a clean upload after all that.
pub fn inbox(bytes: &[u8]) {
    let mut script = Script(bytes);
    let mut memory = [0; 300];
    let room = script.word() as usize % 301;
    let mut inbox = Inbox::new(&mut memory[..room], 32);
    let uploads =
        [1, 5, 40, 290].map(|length: u16| (0..length).map(|i| (i / 3) as u8).collect::<Vec<_>>());
    while !script.0.is_empty() {
        let content = match script.byte() % 8 {
            0 => {
                let count = script.byte().into();
                let noise = script.take(count);
                assert!(noise.iter().all(|byte| !inbox.receive(*byte)));
                continue;
            }
            1 => {
                let kind = script.byte();
                let count = script.byte().into();
                [&[kind], script.take(count)].concat()
            }
            // A chunk that says anything of itself.
            2 => {
                let count = script.byte().into();
                [&[0x83], script.take(8), script.take(count)].concat()
            }
            which => {
                let upload = &uploads[usize::from(which) % 4];
                let start = usize::from(script.word()) % (upload.len() + 1);
                let end = (start + usize::from(script.byte())).min(upload.len());
                let wrong = u32::from(script.byte() % 4 == 0);
                let (length, hash) = (upload.len() as u16, crc(upload) ^ wrong);
                let mut content = vec![0x83];
                content.extend(length.to_le_bytes());
                content.extend(hash.to_le_bytes());
                content.extend((start as u16).to_le_bytes());
                content.extend(&upload[start..end]);
                content
            }
        };
        for byte in sealed(&content) {
            if inbox.receive(byte) {
                let given = inbox.bytes();
                assert!(!given.is_empty() && given.len() <= room && content.len() == 9);
                // Length, hash and offset.
                assert_eq!(content[1..3], (given.len() as u16).to_le_bytes());
                assert_eq!(content[3..7], crc(given).to_le_bytes());
                assert_eq!(content[7..9], content[1..3]);
                if script.byte() % 2 == 0 {
                    inbox.refuse(Refusal::Invalid);
                }
            }
        }
        if let Some(answer) = inbox.answer() {
            assert!(answer.len() <= 20 && answer.ends_with(&[0]), "{answer:?}");
            assert!(!answer[1..answer.len() - 1].contains(&0));
        }
        assert_eq!(inbox.answer(), None);
    }
    let clean: Vec<u8> = (0..room as u16).map(|i| (7 * i + 3) as u8).collect();
    let mut given = Vec::new();
    let outcome = talk(&mut inbox, &clean, &mut given);
    let wanted = if room == 0 { Outcome::Taken } else { Outcome::Refused(Refusal::Kind) };
    assert_eq!(outcome, wanted);
    assert!(given == clean);
}

/// A clean line between both ends of an upload, which is refused at last.
fn talk(inbox: &mut Inbox<'_>, bytes: &[u8], given: &mut Vec<u8>) -> Outcome {
    let mut upload = Upload::new(bytes, PATIENCE);
    // What is left of a packet is behind this.
    inbox.receive(0);
    loop {
        match upload.poll(0) {
            UploadTask::Send(packet) => {
                for byte in packet {
                    if inbox.receive(*byte) {
                        given.extend_from_slice(inbox.bytes());
                        inbox.refuse(Refusal::Kind);
                    }
                }
                upload.sent(0);
                let answer = inbox.answer().expect("each chunk is answered");
                answer.iter().for_each(|byte| upload.receive(*byte, 0));
            }
            // Nothing was lost: there is no need to.
            UploadTask::Listen(_) => return Outcome::Unheard,
            UploadTask::Done(outcome) => return outcome,
        }
    }
}

/// An upload that hears any bytes, statuses and frames among them, at any times: it sends what it should, and is
/// done in bounded time when nobody says more.
pub fn upload(bytes: &[u8]) {
    let mut script = Script(bytes);
    let part: Vec<u8> = (0..script.word() % 1000).map(|i| (i / 2) as u8).collect();
    let hash = crc(&part);
    let mut upload = Upload::new(&part, PATIENCE);
    let mut memory = [0; 1000];
    let mut inbox = Inbox::new(&mut memory, 32);
    let mut now = u32::from(script.byte()).wrapping_sub(100);
    let mut after = 0;
    loop {
        let heard = match script.byte() % 8 {
            _ if script.0.is_empty() => {
                after += 1;
                Vec::new()
            }
            0 => {
                let count = script.byte() % 32;
                script.take(count.into()).to_vec()
            }
            1 => {
                now = now.wrapping_add(u32::from(script.byte()));
                Vec::new()
            }
            2 => {
                let kind = script.byte() % 8;
                let count = script.byte() % 16;
                sealed(&[&[kind], script.take(count.into())].concat())
            }
            3 => {
                let have = script.word() % 1001;
                let fields = [&hash.to_le_bytes()[..], &have.to_le_bytes()];
                sealed(&[&[5], &fields.concat()[..], &[script.byte() / 250, 0, 4, 32]].concat())
            }
            _ => inbox.answer().unwrap_or_default().to_vec(),
        };
        heard.iter().for_each(|byte| upload.receive(*byte, now));
        assert!(after < 100, "no end");
        assert!(upload.delivered() <= part.len());
        match upload.poll(now) {
            UploadTask::Send(packet) => {
                assert!(packet.starts_with(&[0]) && packet.ends_with(&[0]) && packet.len() <= 258);
                for byte in packet {
                    if inbox.receive(*byte) {
                        assert!(inbox.bytes() == part);
                    }
                }
                upload.sent(now);
            }
            UploadTask::Listen(ticks) => {
                assert!(ticks > 0 && ticks <= PATIENCE.ticks);
                now = now.wrapping_add(if script.0.is_empty() { ticks } else { 1 });
            }
            UploadTask::Done(_) if script.0.is_empty() => break,
            UploadTask::Done(_) => {}
        }
    }
}

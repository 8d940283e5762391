//! The link frame by frame: whole frames, interrupted ones, and repairs over a line that loses bytes.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::error::Error;

use embedded_io::{ErrorKind, ErrorType, Write};
use proptest::prelude::*;
use scancsg::render::{Gray8, Rgb565};
use scancsg::stream::{
    CONTROL_CAPACITY, Decoder, EncodeError, Encoding, Event, FrameHash, FrameHeader, Packet, Part,
    PixelFormat, ReceiveError, Receiver, Request, RowHash, RowPayload, SendError, Sender,
    UnpackError, WirePixel, encode_ack, encode_request, packet_capacity,
};

/// A writer that keeps all it is given, up to `room` bytes.
struct Line {
    bytes: Vec<u8>,
    room: usize,
    /// The size of each `write`.
    writes: Vec<usize>,
    flushes: usize,
}

impl Line {
    fn new() -> Self {
        Self { bytes: Vec::new(), room: usize::MAX, writes: Vec::new(), flushes: 0 }
    }

    fn take(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.bytes)
    }
}

impl ErrorType for Line {
    type Error = ErrorKind;
}

impl Write for Line {
    fn write(&mut self, bytes: &[u8]) -> Result<usize, ErrorKind> {
        let len = bytes.len().min(self.room - self.bytes.len());
        self.bytes.extend_from_slice(&bytes[..len]);
        self.writes.push(len);
        if len == 0 && !bytes.is_empty() {
            return Err(ErrorKind::BrokenPipe);
        }
        Ok(len)
    }

    fn flush(&mut self) -> Result<(), ErrorKind> {
        self.flushes += 1;
        Ok(())
    }
}

const CAPACITY: usize = packet_capacity(64, PixelFormat::Rgb565);
type TestSender = Sender<Line, CAPACITY>;
type TestDecoder = Decoder<CAPACITY>;

fn sender() -> TestSender {
    Sender::new(Line::new())
}

fn header(frame: u16) -> FrameHeader {
    FrameHeader { frame, width: 4, height: 3, format: PixelFormat::Gray8 }
}

/// Row `y` of a small grey frame whose pixels are different in every frame and row.
fn gray_row(frame: u16, y: u16) -> [Gray8; 4] {
    std::array::from_fn(|x| Gray8((frame * 50 + y * 10 + x as u16) as u8))
}

fn gray_frame(frame: u16) -> Vec<u8> {
    (0..3).flat_map(|y| gray_row(frame, y).map(|p| p.0)).collect()
}

/// The bytes of each packet of a small grey frame: header, three rows, end.
fn packets(frame: u16) -> [Vec<u8>; 5] {
    let mut sender = sender();
    sender.begin(header(frame)).unwrap();
    let begin = sender.writer_mut().take();
    let rows = [0, 1, 2].map(|y| {
        sender.row(y, &gray_row(frame, y)).unwrap();
        sender.writer_mut().take()
    });
    sender.end().unwrap();
    let [a, b, c] = rows;
    [begin, a, b, c, sender.writer_mut().take()]
}

/// Gives all packets in `bytes` to the receiver; damaged ones are left out, as in a real one.
fn receive(
    receiver: &mut Receiver<'_>,
    decoder: &mut TestDecoder,
    mut bytes: &[u8],
) -> Vec<Result<Event, ReceiveError>> {
    let mut events = Vec::new();
    while let Some(result) = decoder.feed(&mut bytes) {
        if let Ok(packet) = result {
            events.push(receiver.accept(&packet));
        }
    }
    events
}

fn started(frame: u16, lost: Option<u16>) -> Event {
    Event::Started { header: header(frame), lost }
}

fn row_bytes<P: WirePixel>(row: &[P]) -> Vec<u8> {
    row.iter().flat_map(|p| p.to_le_bytes().as_ref().to_vec()).collect()
}

fn check_frame<P: WirePixel>(frame: u16, width: u16, pixels: &[P]) -> Result<(), TestCaseError> {
    let header = FrameHeader {
        frame,
        width,
        height: (pixels.len() / usize::from(width)) as u16,
        format: P::FORMAT,
    };
    let mut sender = sender();
    sender.begin(header).unwrap();
    for (y, row) in (0..).zip(pixels.chunks(usize::from(width))) {
        sender.row(y, row).unwrap();
    }
    sender.end().unwrap();
    let sent = sender.bytes_sent();
    let line = sender.into_inner();
    prop_assert_eq!(sent, line.bytes.len() as u64);
    // One write per packet, none of them empty, and one flush.
    prop_assert_eq!(line.writes.len(), usize::from(header.height) + 2);
    prop_assert_eq!(line.flushes, 1);

    let expected = row_bytes(pixels);
    let mut memory = vec![0xAA; expected.len() + 1];
    let mut flags = vec![true; usize::from(header.height)];
    let mut receiver = Receiver::new(&mut memory, &mut flags);
    let mut decoder = TestDecoder::new();
    let events = receive(&mut receiver, &mut decoder, &line.bytes);
    let mut wanted = vec![Ok(Event::Started { header, lost: None })];
    wanted.extend((0..header.height).map(|y| Ok(Event::Row { y })));
    wanted.push(Ok(Event::Complete));
    prop_assert_eq!(events, wanted);
    prop_assert!(receiver.is_complete());
    prop_assert_eq!(receiver.pixels(), &expected);
    for (y, row) in (0..).zip(pixels.chunks(usize::from(width))) {
        prop_assert_eq!(receiver.row(y), Some(&row_bytes(row)[..]));
    }
    prop_assert_eq!(receiver.row(header.height), None);
    prop_assert_eq!(receiver.requests().count(), 0);
    prop_assert_eq!(memory.last(), Some(&0xAA));
    Ok(())
}

proptest! {
    #[test]
    fn frames_round_trip(
        frame in any::<u16>(),
        width in 1..=64_u16,
        height in 1..12_u16,
        noise in proptest::collection::vec(any::<u16>(), 64 * 12),
        levels in 1..=u16::MAX,
    ) {
        // Few levels give long runs, many none.
        let size = usize::from(width * height);
        let values = || noise.iter().take(size).map(|v| v % levels);
        check_frame(frame, width, &values().map(|v| Gray8(v as u8)).collect::<Vec<_>>())?;
        check_frame(frame, width, &values().map(Rgb565).collect::<Vec<_>>())?;
    }

    /// Packets of a few frames in any order, some of them nonsense: no panic, and whenever the receiver
    /// says that the frame is complete, it is.
    #[test]
    fn any_packets_in_any_order(
        order in proptest::collection::vec((0..3_u16, 0..7_usize), 0..60)
    ) {
        let (mut memory, mut flags) = ([0; 12], [false; 3]);
        let mut receiver = Receiver::new(&mut memory, &mut flags);
        for (frame, what) in order {
            let bytes = packets(frame);
            let mut decoder = TestDecoder::new();
            if let Some(bytes) = bytes.get(what) {
                let _ = receive(&mut receiver, &mut decoder, bytes);
            } else {
                let payload = RowPayload { encoding: Encoding::PackBits, bytes: &[0xF0, 1] };
                let y = what as u16 - 4;
                let result = receiver.accept(&Packet::Row { frame, y, payload });
                prop_assert!(matches!(result, Err(_) | Ok(Event::Repeated)));
            }
            let here = receiver.rows_received();
            prop_assert_eq!(receiver.missing().count(), match receiver.header() {
                Some(_) => 3 - usize::from(here),
                None => 0,
            });
            if let Some(header) = receiver.header() {
                let all = gray_frame(header.frame);
                for y in 0..3_u16 {
                    let row = usize::from(y) * 4;
                    prop_assert!(receiver.row(y).is_none_or(|r| r == &all[row..row + 4]));
                }
                prop_assert!(!receiver.is_complete() || receiver.pixels() == all);
            }
        }
    }
}

#[test]
fn a_lost_header_a_lost_row_and_a_lost_end_are_asked_for() {
    let (mut memory, mut flags) = ([0; 12], [false; 3]);
    let mut receiver = Receiver::new(&mut memory, &mut flags);
    let mut decoder = TestDecoder::new();
    let [begin, a, b, c, end] = packets(5);
    let ask = |receiver: &Receiver<'_>| receiver.requests().collect::<Vec<_>>();
    let want = |part| Request { frame: 5, part };

    assert_eq!(ask(&receiver), []);
    let events = receive(&mut receiver, &mut decoder, &a);
    assert_eq!(events, [Err(ReceiveError::UnknownFrame)]);
    assert_eq!(ask(&receiver), [want(Part::Header)]);
    assert!(receiver.pixels().is_empty());

    let line = [&begin[..], &b].concat();
    let events = receive(&mut receiver, &mut decoder, &line);
    assert_eq!(events, [Ok(started(5, None)), Ok(Event::Row { y: 1 })]);
    assert_eq!(ask(&receiver), [want(Part::Row(0)), want(Part::Row(2))]);
    assert_eq!(receiver.row(0), None);

    // The header once more: what is here stays.
    let events = receive(&mut receiver, &mut decoder, &[&begin[..], &b].concat());
    assert_eq!(events, [Ok(Event::Repeated); 2]);
    assert_eq!(receiver.rows_received(), 1);

    let events = receive(&mut receiver, &mut decoder, &[&c[..], &a].concat());
    assert_eq!(events, [Ok(Event::Row { y: 2 }), Ok(Event::Row { y: 0 })]);
    assert!(!receiver.is_complete());
    assert_eq!(ask(&receiver), [want(Part::End)]);

    // The end, and once more because the acknowledgement was lost.
    let events = receive(&mut receiver, &mut decoder, &[&end[..], &end].concat());
    assert_eq!(events, [Ok(Event::Complete); 2]);
    assert!(receiver.is_complete());
    assert_eq!(ask(&receiver), []);
    assert_eq!(receiver.pixels(), gray_frame(5));
}

#[test]
fn a_row_after_the_end_completes_the_frame() {
    let (mut memory, mut flags) = ([0; 12], [false; 3]);
    let mut receiver = Receiver::new(&mut memory, &mut flags);
    let mut decoder = TestDecoder::new();
    let [begin, a, b, c, end] = packets(5);
    let line = [begin, a, c, end].concat();
    let events = receive(&mut receiver, &mut decoder, &line);
    assert_eq!(events[3], Ok(Event::Incomplete { missing: 1 }));
    let asked: Vec<_> = receiver.requests().collect();
    let frame = 5;
    let part = Part::Row(1);
    assert_eq!(asked, [Request { frame, part }]);
    let events = receive(&mut receiver, &mut decoder, &b);
    assert_eq!(events, [Ok(Event::Complete)]);
    assert_eq!(receiver.pixels(), gray_frame(5));
}

#[test]
fn an_interrupted_frame_is_lost_and_the_next_one_is_not() {
    let (mut memory, mut flags) = ([0; 12], [false; 3]);
    let mut receiver = Receiver::new(&mut memory, &mut flags);
    let mut decoder = TestDecoder::new();
    let first = packets(1).concat();
    // The sender restarts in the middle of a row: the zero before the header cuts the row off.
    let cut = packets(1)[..3].iter().map(Vec::len).sum::<usize>() - 5;
    let line = [&first[..cut], &packets(2).concat()].concat();
    let events = receive(&mut receiver, &mut decoder, &line);
    let mut expected = vec![Ok(started(1, None)), Ok(Event::Row { y: 0 })];
    expected.push(Ok(started(2, Some(1))));
    expected.extend([0, 1, 2].map(|y| Ok(Event::Row { y })));
    expected.push(Ok(Event::Complete));
    assert_eq!(events, expected);
    assert_eq!(receiver.pixels(), gray_frame(2));

    // A complete frame is not lost; a stray row of an older one changes nothing but what is asked for.
    let [begin, a, ..] = packets(3);
    assert_eq!(
        receive(&mut receiver, &mut decoder, &packets(1)[1]),
        [Err(ReceiveError::UnknownFrame)]
    );
    assert!(receiver.is_complete());
    assert_eq!(receiver.pixels(), gray_frame(2));
    assert_eq!(receiver.requests().count(), 1);
    let events = receive(&mut receiver, &mut decoder, &[begin, a].concat());
    assert_eq!(events, [Ok(started(3, None)), Ok(Event::Row { y: 0 })]);
    assert_eq!(receiver.rows_received(), 1);
    assert_eq!(receiver.row(0), Some(&gray_frame(3)[..4]));
    let missing: Vec<_> = receiver.missing().collect();
    assert_eq!(missing, [1, 2]);
}

#[test]
fn packets_that_do_not_fit_leave_the_frame_alone() {
    let (mut memory, mut flags) = ([0; 12], [false; 3]);
    let mut receiver = Receiver::new(&mut memory, &mut flags);
    let mut decoder = TestDecoder::new();
    let line = packets(5)[..3].concat();
    receive(&mut receiver, &mut decoder, &line);

    let mut refuse = |packet: Packet<'_>, expected| {
        assert_eq!(receiver.accept(&packet), Err(expected));
        assert_eq!(receiver.header(), Some(header(5)));
        assert_eq!(receiver.rows_received(), 2);
        assert_eq!(receiver.pixels()[..8], gray_frame(5)[..8]);
        assert_eq!(receiver.row(2), None);
        receiver.requests().collect::<Vec<_>>()
    };
    let resized =
        |width, height, format| Packet::Header(FrameHeader { frame: 6, width, height, format });
    let gray = PixelFormat::Gray8;
    refuse(resized(4, 4, gray), ReceiveError::TooLarge);
    refuse(resized(5, 3, gray), ReceiveError::TooLarge);
    refuse(resized(3, 4, gray), ReceiveError::TooLarge);
    refuse(resized(4, 3, PixelFormat::Rgb565), ReceiveError::TooLarge);
    refuse(resized(u16::MAX, u16::MAX, PixelFormat::Rgb565), ReceiveError::TooLarge);
    refuse(resized(0, 3, gray), ReceiveError::Size);
    refuse(resized(4, 0, gray), ReceiveError::Size);

    let row = |frame, y, bytes| Packet::Row {
        frame,
        y,
        payload: RowPayload { encoding: Encoding::Raw, bytes },
    };
    let pixels = [7; 5];
    refuse(row(5, 3, &pixels[..4]), ReceiveError::Row);
    refuse(row(5, u16::MAX, &pixels[..4]), ReceiveError::Row);
    let (short, long) = (UnpackError::TooShort, UnpackError::TooLong);
    refuse(row(5, 2, &pixels[..3]), ReceiveError::Payload(short));
    refuse(row(5, 2, &pixels), ReceiveError::Payload(long));
    // The header of frame 6 was refused; asking for it again would never end.
    let asked = refuse(row(6, 0, &pixels[..4]), ReceiveError::UnknownFrame);
    let part = Part::Row(2);
    assert_eq!(asked, [Request { frame: 5, part }]);
    // That of frame 7 was not.
    let asked = refuse(row(7, 0, &pixels[..4]), ReceiveError::UnknownFrame);
    let part = Part::Header;
    assert_eq!(asked, [Request { frame: 7, part }]);

    // The header or a row of the current frame shows that the sender is still there.
    for packet in [Packet::Header(header(5)), row(5, 0, &pixels[..4])] {
        assert!(receiver.accept(&row(7, 0, &pixels[..4])).is_err());
        assert_eq!(receiver.accept(&packet), Ok(Event::Repeated));
        let part = Part::Row(2);
        assert!(receiver.requests().eq([Request { frame: 5, part }]));
    }

    // A smaller frame fits.
    let event = receiver.accept(&resized(3, 2, gray));
    assert!(matches!(event, Ok(Event::Started { lost: Some(5), .. })));
    assert_eq!(receiver.pixels().len(), 6);
    let ack = Packet::Ack { frame: 6 };
    assert_eq!(receiver.accept(&ack), Ok(Event::Ignored));
}

/// A sender that restarted with the same frame id but sees another scene: the hash tells, and all rows
/// are fetched again.
#[test]
fn a_wrong_hash_makes_all_rows_missing() {
    for end_first in [false, true] {
        let (mut memory, mut flags) = ([0; 12], [false; 3]);
        let mut receiver = Receiver::new(&mut memory, &mut flags);
        let mut accept = |packet: Packet<'_>| receiver.accept(&packet).unwrap();
        let row = |y, value: &'static [u8; 4]| Packet::Row {
            frame: 1,
            y,
            payload: RowPayload { encoding: Encoding::Raw, bytes: value },
        };
        let mut hash = FrameHash::new();
        for y in 0..3 {
            hash.add(RowHash::of(y, &[Gray8(9); 4]));
        }
        let end = Packet::End { frame: 1, hash };
        accept(Packet::Header(header(1)));
        accept(row(0, &[8; 4]));
        accept(row(1, &[9; 4]));
        let last = if end_first {
            assert_eq!(accept(end), Event::Incomplete { missing: 1 });
            accept(row(2, &[9; 4]))
        } else {
            accept(row(2, &[9; 4]));
            accept(end)
        };
        assert_eq!(last, Event::HashMismatch);
        for y in 0..3 {
            assert_eq!(accept(row(y, &[9; 4])), Event::Row { y });
        }
        assert_eq!(accept(end), Event::Complete);
        // And from a complete frame back, if its end comes again with another hash.
        let hash = FrameHash::from_value(1);
        assert_eq!(accept(Packet::End { frame: 1, hash }), Event::HashMismatch);
        assert!(!receiver.is_complete());
        assert_eq!(receiver.missing().count(), 3);
        assert_eq!(receiver.requests().count(), 3);
    }
}

#[test]
fn a_sender_refuses_what_is_not_its_frame() {
    let mut sender = sender();
    let row = gray_row(1, 0);
    assert_eq!(sender.row(0, &row), Err(SendError::NoFrame));
    assert_eq!(sender.resend_row(0, &row), Err(SendError::NoFrame));
    assert_eq!(sender.header_again(), Err(SendError::NoFrame));
    assert_eq!(sender.end(), Err(SendError::NoFrame));
    assert_eq!(sender.end_again(), Err(SendError::NoFrame));
    let wide = FrameHeader { width: 65, format: PixelFormat::Rgb565, ..header(1) };
    let too_small = SendError::Encode(EncodeError::BufferTooSmall);
    assert_eq!(sender.begin(wide), Err(too_small));
    let empty = FrameHeader { height: 0, ..header(1) };
    let no_pixels = SendError::Encode(EncodeError::Size);
    assert_eq!(sender.begin(empty), Err(no_pixels));
    assert_eq!(sender.header(), None);
    assert_eq!(sender.bytes_sent(), 0);

    sender.begin(header(1)).unwrap();
    let before = sender.bytes_sent();
    assert_eq!(sender.row(0, &row[..3]), Err(SendError::Width));
    assert_eq!(sender.row(0, &[Rgb565(0); 4]), Err(SendError::Format));
    assert_eq!(sender.row(3, &row), Err(SendError::Row));
    assert_eq!(sender.resend_row(3, &row), Err(SendError::Row));
    assert_eq!(sender.row(1, &row), Err(SendError::Order));
    assert_eq!(sender.end(), Err(SendError::RowsLeft));
    assert_eq!(sender.bytes_sent(), before);
    for y in 0..3 {
        sender.row(y, &gray_row(1, y)).unwrap();
        // Repairs do not count in the hash, whenever they come.
        sender.resend_row(2, &gray_row(1, 2)).unwrap();
        assert_eq!(sender.row(y, &row), Err(SendError::Order));
        assert_eq!(sender.end_again(), Err(SendError::NotEnded));
    }
    sender.writer_mut().take();
    sender.end().unwrap();
    let end = sender.writer_mut().take();
    assert_eq!(end, packets(1)[4]);
    sender.end_again().unwrap();
    assert_eq!(sender.writer_mut().take(), end);
    sender.header_again().unwrap();
    assert_eq!(sender.writer_mut().take(), packets(1)[0]);
}

#[test]
fn a_writer_that_fails_in_the_middle_of_a_frame() {
    let whole = packets(1);
    // The line breaks after every possible number of bytes, then works again.
    let total = whole.concat().len();
    for room in 0..total {
        let mut sender = sender();
        sender.writer_mut().room = room;
        let mut failures = 0;
        let mut retry =
            |sender: &mut TestSender,
             step: &dyn Fn(&mut TestSender) -> Result<(), SendError<ErrorKind>>| {
                if let Err(error) = step(sender) {
                    assert_eq!(error, SendError::Io(ErrorKind::BrokenPipe));
                    assert!(error.source().is_some());
                    failures += 1;
                    sender.writer_mut().room = usize::MAX;
                    step(sender).unwrap();
                }
            };
        retry(&mut sender, &|s| s.begin(header(1)));
        for y in 0..3 {
            retry(&mut sender, &|s| s.row(y, &gray_row(1, y)));
        }
        retry(&mut sender, &|s| s.end());
        assert_eq!(failures, 1, "{room}");

        // Each step was repeated whole, so nothing is missing.
        let bytes = sender.into_inner().bytes;
        let (mut memory, mut flags) = ([0; 12], [false; 3]);
        let mut receiver = Receiver::new(&mut memory, &mut flags);
        let events = receive(&mut receiver, &mut TestDecoder::new(), &bytes);
        assert_eq!(events.last(), Some(&Ok(Event::Complete)), "{room}");
        assert_eq!(receiver.pixels(), gray_frame(1));
    }
}

#[test]
fn errors_are_errors() {
    fn check(error: &dyn Error, words: &str, has_source: bool) {
        assert_eq!(error.to_string(), words);
        assert_eq!(error.source().is_some(), has_source);
    }
    let io = SendError::Io(ErrorKind::BrokenPipe);
    check(&io, "writer failed", true);
    check(&SendError::<ErrorKind>::Order, SendError::<()>::Order.as_str(), false);
    check(&ReceiveError::Row, ReceiveError::Row.as_str(), false);
    check(&EncodeError::Size, EncodeError::Size.as_str(), false);
    check(&UnpackError::Truncated, UnpackError::Truncated.as_str(), false);
}

/// Knuth's MMIX generator; the upper bits are the good ones.
struct Lcg(u64);

impl Lcg {
    fn below(&mut self, n: u64) -> u64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % n
    }

    /// A line that drops, flips or invents a byte, each once in `one_in` bytes.
    fn carry(&mut self, bytes: &[u8], one_in: u64) -> Vec<u8> {
        let mut out = Vec::new();
        for &byte in bytes {
            match self.below(one_in) {
                0 => {}
                1 => out.push(byte ^ (1 << self.below(8))),
                2 => out.extend([byte, self.below(256) as u8]),
                _ => out.push(byte),
            }
        }
        out
    }
}

/// Row `y` of a frame of 40 pixels: runs and noise.
fn scene<P: WirePixel>(y: u16, pixel: fn(u16) -> P) -> Vec<P> {
    (0..40)
        .map(|x| {
            let inside = x > y && x < 35;
            pixel(if inside { x * 1237 + y * 77 } else { 9 })
        })
        .collect()
}

/// Sends one frame over a lossy line in both directions until the sender hears the acknowledgement.
/// Returns how many rounds it took.
fn repair<P: WirePixel>(seed: u64, one_in: u64, pixel: fn(u16) -> P) -> usize {
    let header = FrameHeader { frame: seed as u16, width: 40, height: 30, format: P::FORMAT };
    let expected: Vec<u8> = (0..30).flat_map(|y| row_bytes(&scene(y, pixel))).collect();
    let mut noise = Lcg(seed);
    let mut memory = vec![0; expected.len()];
    let mut flags = vec![false; 30];
    let mut receiver = Receiver::new(&mut memory, &mut flags);
    let mut forward = TestDecoder::new();
    let mut backward = Decoder::<CONTROL_CAPACITY>::new();
    let mut sender = sender();

    sender.begin(header).unwrap();
    for y in 0..30 {
        sender.row(y, &scene(y, pixel)).unwrap();
    }
    sender.end().unwrap();
    for round in 1..1000 {
        let bytes = noise.carry(&sender.writer_mut().take(), one_in);
        let events = receive(&mut receiver, &mut forward, &bytes);

        // The receiver answers once the line is quiet.
        let mut answer = Vec::new();
        let mut buffer = [0; CONTROL_CAPACITY];
        for request in receiver.requests() {
            let len = encode_request(request, &mut buffer).unwrap();
            answer.extend_from_slice(&buffer[..len]);
        }
        if events.contains(&Ok(Event::Complete)) {
            let len = encode_ack(header.frame, &mut buffer).unwrap();
            answer.extend_from_slice(&buffer[..len]);
        }

        let answer = noise.carry(&answer, one_in);
        let mut answer = &answer[..];
        let mut heard = false;
        while let Some(result) = backward.feed(&mut answer) {
            match result {
                Ok(Packet::Request(Request { frame, part })) if frame == header.frame => {
                    heard = true;
                    match part {
                        Part::Header => sender.header_again().unwrap(),
                        Part::Row(y) => sender.resend_row(y, &scene(y, pixel)).unwrap(),
                        Part::End => sender.end_again().unwrap(),
                        _ => {}
                    }
                }
                Ok(Packet::Ack { frame }) if frame == header.frame => {
                    assert!(receiver.is_complete());
                    assert_eq!(receiver.pixels(), expected);
                    return round;
                }
                Ok(packet) => panic!("{packet:?} was never sent"),
                Err(_) => {}
            }
        }
        if !heard {
            // Nothing heard for a while.
            sender.end_again().unwrap();
        }
    }
    panic!("seed {seed}, one in {one_in}: not repaired");
}

#[test]
fn a_lossy_line_is_repaired() {
    let mut repaired = 0;
    for seed in 1..=60 {
        for one_in in [60, 200, 2000] {
            let rounds = repair(seed, one_in, |v| Gray8(v as u8));
            repaired += usize::from(rounds > 1);
            let rounds = repair(seed, one_in, Rgb565);
            repaired += usize::from(rounds > 1);
        }
    }
    // A test of repairs on a line that loses nothing would be none.
    assert!(repaired > 250, "{repaired} of 360");
    assert_eq!(repair(1, u64::MAX, Rgb565), 1);
}

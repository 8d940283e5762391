//! The link frame by frame, packet by packet: whole frames, interrupted ones, and what each end makes of
//! what the other one sends.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::error::Error;

use proptest::prelude::*;
use scancsg::render::{Gray8, Mono, Palette, Rgb565, Rgb888};
use scancsg::stream::{
    Assembler, Decoder, Delivery, EncodeError, Encoding, Event, FrameHash, FrameHeader, Memory,
    Packet, Part, Patience, PixelFormat, Plain, ReceiveError, Receiver, Request, RowHash,
    RowPayload, Sender, ServeError, Task, Timing, UnpackError, encode_ack, encode_request,
    packet_capacity,
};
use testkit::link::Bytes;

const CAPACITY: usize = packet_capacity(64, PixelFormat::Rgb888);
const PATIENCE: Patience = Patience { ticks: 10, silences: 3 };
const TIMING: Timing = Timing { ask: 50, give_up: 1000 };
type TestSender = Sender<Plain, CAPACITY>;
type TestReceiver<'m> = Receiver<'m, CAPACITY>;
type TestDecoder = Decoder<CAPACITY>;

fn sender() -> TestSender {
    Sender::new(Plain, PATIENCE)
}

fn header(frame: u16) -> FrameHeader {
    let (format, palette) = (PixelFormat::Gray8, Palette::EMPTY);
    FrameHeader { frame, width: 4, height: 3, format, palette }
}

/// Row `y` of a small grey frame whose pixels are different in every frame and row.
fn gray_row(frame: u16, y: u16) -> [Gray8; 4] {
    std::array::from_fn(|x| Gray8((frame * 50 + y * 10 + x as u16) as u8))
}

fn gray_frame(frame: u16) -> Vec<u8> {
    (0..3).flat_map(|y| gray_row(frame, y).map(|p| p.0)).collect()
}

/// All that a sender wants until it listens or is done: its packets, one by one, and what it wants then.
fn run<P: Bytes>(
    sender: &mut TestSender,
    now: u32,
    row: impl Fn(u16) -> Vec<P>,
) -> (Vec<Vec<u8>>, Option<Delivery>) {
    let mut packets = Vec::new();
    loop {
        match sender.poll(now) {
            Task::Send(packet) => {
                packets.push(packet.to_vec());
                sender.sent(now);
            }
            Task::Row(y) => sender.row(y, &row(y)).unwrap(),
            Task::Listen(_) => return (packets, None),
            Task::Done(delivery) => return (packets, Some(delivery)),
        }
    }
}

/// The bytes of each packet of a small grey frame: header, three rows, end.
fn packets(frame: u16) -> [Vec<u8>; 5] {
    let mut sender = sender();
    sender.begin(header(frame)).unwrap();
    run(&mut sender, 0, |y| gray_row(frame, y).to_vec()).0.try_into().unwrap()
}

/// Memory of a receiver for a small grey frame.
struct Small {
    pixels: [u8; 12],
    rows: [bool; 3],
}

impl Small {
    fn new() -> Self {
        Self { pixels: [0; 12], rows: [false; 3] }
    }

    fn memory(&mut self) -> Memory<'_> {
        Memory { pixels: &mut self.pixels, rows: &mut self.rows, above: &mut [] }
    }
}

/// Gives all packets in `bytes` to the assembler; damaged ones are left out, as in a receiver.
fn accept(frame: &mut Assembler<'_>, mut bytes: &[u8]) -> Vec<Result<Event, ReceiveError>> {
    let mut decoder = TestDecoder::new();
    let mut events = Vec::new();
    while let Some(result) = decoder.feed(&mut bytes) {
        if let Ok(packet) = result {
            events.push(frame.accept(&packet));
        }
    }
    events
}

/// All events of a receiver that gets these bytes.
fn receive(receiver: &mut TestReceiver<'_>, mut bytes: &[u8], now: u32) -> Vec<Event> {
    std::iter::from_fn(|| receiver.receive(&mut bytes, now)).collect()
}

/// All answers of a receiver: what it asks for, and whether it acknowledges.
fn answers(receiver: &mut TestReceiver<'_>) -> (Vec<Request>, usize) {
    let (mut requests, mut acks) = (Vec::new(), 0);
    while let Some(mut bytes) = receiver.answer() {
        match Decoder::<32>::new().feed(&mut bytes) {
            Some(Ok(Packet::Request(request))) => requests.push(request),
            Some(Ok(Packet::Ack { .. })) => acks += 1,
            other => panic!("{other:?}"),
        }
    }
    (requests, acks)
}

fn asked(receiver: &mut TestReceiver<'_>) -> Vec<Part> {
    answers(receiver).0.into_iter().map(|request| request.part).collect()
}

/// A request for rows, whatever its limit.
fn rows_of(part: Part) -> Option<(u16, u16)> {
    match part {
        Part::Rows { y, count, .. } => Some((y, count)),
        _ => None,
    }
}

fn missing(frame: &Assembler<'_>) -> Vec<u16> {
    frame.missing().collect()
}

fn started(frame: u16, lost: Option<u16>) -> Event {
    Event::Started { header: header(frame), lost }
}

fn row_came(y: u16) -> Event {
    Event::Rows { y, count: 1 }
}

fn check_frame<P: Bytes>(
    frame: u16,
    width: u16,
    format: PixelFormat,
    pixels: &[P],
) -> Result<(), TestCaseError> {
    let height = (pixels.len() / usize::from(width)) as u16;
    let header = FrameHeader { frame, width, height, format, palette: Palette::EMPTY };
    let rows: Vec<&[P]> = pixels.chunks(usize::from(width)).collect();
    let mut sender = sender();
    sender.begin(header).unwrap();
    let (packets, delivery) = run(&mut sender, 0, |y| rows[usize::from(y)].to_vec());
    prop_assert_eq!(delivery, None);
    let line = packets.concat();
    prop_assert_eq!(sender.bytes_sent(), line.len() as u64);
    // One write per packet, none of them empty, and then it listens.
    prop_assert_eq!(packets.len(), usize::from(header.height) + 2);
    prop_assert!(packets.iter().all(|packet| !packet.is_empty()));

    let expected: Vec<u8> = rows.iter().flat_map(|row| P::bytes(row)).collect();
    let mut pixels = vec![0xAA; expected.len() + 1];
    let mut flags = vec![true; usize::from(header.height)];
    let memory = Memory { pixels: &mut pixels, rows: &mut flags, above: &mut [] };
    let mut receiver = TestReceiver::new(memory, TIMING);
    let events = receive(&mut receiver, &line, 0);
    let mut wanted = vec![Event::Started { header, lost: None }];
    wanted.extend((0..header.height).map(row_came));
    wanted.push(Event::Complete);
    prop_assert_eq!(events, wanted);
    prop_assert!(receiver.frame().is_complete());
    prop_assert_eq!(receiver.frame().pixels(), &expected);
    for (y, row) in (0..).zip(&rows) {
        prop_assert_eq!(receiver.frame().row(y), Some(&P::bytes(row)[..]));
    }
    prop_assert_eq!(receiver.frame().row(header.height), None);
    prop_assert_eq!(answers(&mut receiver), (vec![], 1));
    let traffic = receiver.traffic();
    prop_assert_eq!(traffic.bytes, line.len() as u64);
    prop_assert_eq!(traffic.packets, packets.len() as u64);
    prop_assert_eq!((traffic.bad_packets, traffic.requests), (0, 0));
    prop_assert_eq!(pixels.last(), Some(&0xAA));
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
        let gray = values().map(|v| Gray8(v as u8)).collect::<Vec<_>>();
        check_frame(frame, width, PixelFormat::Gray8, &gray)?;
        check_frame(frame, width, PixelFormat::Rgb565, &values().map(Rgb565).collect::<Vec<_>>())?;
        let colors = values().map(|v| Rgb888([v as u8, (v >> 8) as u8, 7])).collect::<Vec<_>>();
        check_frame(frame, width, PixelFormat::Rgb888, &colors)?;
        let bits = values().map(|v| Mono(v > levels / 2)).collect::<Vec<_>>();
        check_frame(frame, width, PixelFormat::Mono, &bits)?;
    }

    /// Packets of a few frames in any order, some of them nonsense: no panic, and whenever the assembler
    /// says that the frame is complete, it is.
    #[test]
    fn any_packets_in_any_order(
        order in proptest::collection::vec((0..3_u16, 0..7_usize), 0..60)
    ) {
        let mut small = Small::new();
        let mut assembler = Assembler::new(small.memory());
        for (frame, what) in order {
            let bytes = packets(frame);
            if let Some(bytes) = bytes.get(what) {
                let _ = accept(&mut assembler, bytes);
            } else {
                let payload = RowPayload { encoding: Encoding::PackBits, bytes: &[0xF0, 1] };
                let y = what as u16 - 4;
                let result = assembler.accept(&Packet::Row { frame, y, payload });
                prop_assert!(matches!(result, Err(_) | Ok(Event::Repeated)));
            }
            let here = assembler.rows_received();
            prop_assert_eq!(assembler.missing().count(), match assembler.header() {
                Some(_) => 3 - usize::from(here),
                None => 0,
            });
            // Ranges are the rows, and no two of them touch.
            let gaps: Vec<_> = assembler.gaps().collect();
            let ranges = gaps.iter().flat_map(|(y, count)| *y..y + count);
            prop_assert!(ranges.eq(assembler.missing()));
            prop_assert!(gaps.iter().all(|(_, count)| *count > 0));
            prop_assert!(gaps.windows(2).all(|two| two[0].0 + two[0].1 < two[1].0));
            if let Some(header) = assembler.header() {
                let all = gray_frame(header.frame);
                for y in 0..3_u16 {
                    let row = usize::from(y) * 4;
                    prop_assert!(assembler.row(y).is_none_or(|r| r == &all[row..row + 4]));
                }
                prop_assert!(!assembler.is_complete() || assembler.pixels() == all);
            }
        }
    }
}

#[test]
fn a_lost_header_a_lost_row_and_a_lost_end_are_asked_for() {
    let mut small = Small::new();
    let mut receiver = TestReceiver::new(small.memory(), TIMING);
    let [begin, a, b, c, end] = packets(5);

    assert_eq!(receiver.poll(9), None);
    assert_eq!(asked(&mut receiver), []);
    // The first packet tells that a header is missing.
    assert_eq!(receive(&mut receiver, &a, 10), []);
    assert_eq!(asked(&mut receiver), [Part::Header]);
    assert!(receiver.frame().pixels().is_empty());

    // The second row tells that the first one is missing.
    let line = [&begin[..], &b].concat();
    assert_eq!(receive(&mut receiver, &line, 11), [started(5, None), row_came(1)]);
    let (requests, _) = answers(&mut receiver);
    assert!(requests.iter().all(|request| request.frame == 5));
    assert_eq!(requests.iter().map(|r| rows_of(r.part)).collect::<Vec<_>>(), [Some((0, 1))]);
    assert_eq!(receiver.frame().row(0), None);

    // The header once more: what is here stays.
    let events = receive(&mut receiver, &[&begin[..], &b].concat(), 12);
    assert_eq!(events, [Event::Repeated; 2]);
    assert_eq!(receiver.frame().rows_received(), 1);
    assert_eq!(asked(&mut receiver), []);

    let events = receive(&mut receiver, &[&c[..], &a].concat(), 13);
    assert_eq!(events, [row_came(2), row_came(0)]);
    assert!(!receiver.frame().is_complete());
    // Silence tells that the end is missing.
    assert_eq!(receiver.poll(13 + TIMING.ask - 1), None);
    assert_eq!(asked(&mut receiver), []);
    assert_eq!(receiver.poll(13 + TIMING.ask), None);
    assert_eq!(asked(&mut receiver), [Part::End]);

    // The end, and once more because the acknowledgement was lost.
    let events = receive(&mut receiver, &[&end[..], &end].concat(), 80);
    assert_eq!(events, [Event::Complete, Event::CompleteAgain]);
    assert!(receiver.frame().is_complete());
    assert_eq!(answers(&mut receiver), (vec![], 1));
    assert_eq!(receive(&mut receiver, &end, 90), [Event::CompleteAgain]);
    assert_eq!(answers(&mut receiver), (vec![], 1));
    assert_eq!(receiver.frame().pixels(), gray_frame(5));
    // A complete frame is not given up, however long nothing comes.
    assert_eq!(receiver.poll(90 + TIMING.give_up), None);
    assert_eq!(answers(&mut receiver), (vec![], 0));
}

#[test]
fn a_row_after_the_end_completes_the_frame() {
    let mut small = Small::new();
    let mut receiver = TestReceiver::new(small.memory(), TIMING);
    let [begin, a, b, c, end] = packets(5);
    let events = receive(&mut receiver, &[begin, a, c].concat(), 0);
    assert_eq!(events.len(), 3);
    // The gap is asked for at once, and at the end again.
    for _ in 0..2 {
        let requests = asked(&mut receiver).into_iter().map(rows_of).collect::<Vec<_>>();
        assert_eq!(requests, [Some((1, 1))]);
        let again = receive(&mut receiver, &end, 0);
        assert_eq!(again, [Event::Incomplete { missing: 1 }]);
    }
    assert_eq!(receive(&mut receiver, &b, 0), [Event::Complete]);
    assert_eq!(answers(&mut receiver), (vec![], 1));
    assert_eq!(receiver.frame().pixels(), gray_frame(5));
}

#[test]
fn an_interrupted_frame_is_lost_and_the_next_one_is_not() {
    let mut small = Small::new();
    let mut receiver = TestReceiver::new(small.memory(), TIMING);
    let first = packets(1).concat();
    // The sender restarts in the middle of a row: the zero before the header cuts the row off.
    let cut = packets(1)[..3].iter().map(Vec::len).sum::<usize>() - 5;
    let line = [&first[..cut], &packets(2).concat()].concat();
    let events = receive(&mut receiver, &line, 0);
    let mut expected = vec![started(1, None), row_came(0)];
    expected.push(started(2, Some(1)));
    expected.extend([0, 1, 2].map(row_came));
    expected.push(Event::Complete);
    assert_eq!(events, expected);
    assert_eq!(receiver.frame().pixels(), gray_frame(2));
    assert_eq!(answers(&mut receiver), (vec![], 1));

    // A complete frame is not lost; a stray row of an older one changes nothing but what is asked for.
    let [begin, a, ..] = packets(3);
    assert_eq!(receive(&mut receiver, &packets(1)[1], 1), []);
    assert!(receiver.frame().is_complete());
    assert_eq!(receiver.frame().pixels(), gray_frame(2));
    assert_eq!(asked(&mut receiver), [Part::Header]);
    let events = receive(&mut receiver, &[begin, a].concat(), 2);
    assert_eq!(events, [started(3, None), row_came(0)]);
    assert_eq!(receiver.frame().rows_received(), 1);
    assert_eq!(receiver.frame().row(0), Some(&gray_frame(3)[..4]));
    assert_eq!(missing(receiver.frame()), [1, 2]);
}

#[test]
fn packets_that_do_not_fit_leave_the_frame_alone() {
    let mut small = Small::new();
    let mut assembler = Assembler::new(small.memory());
    accept(&mut assembler, &packets(5)[..3].concat());

    let mut refuse = |packet: Packet<'_>, expected| {
        assert_eq!(assembler.accept(&packet), Err(expected));
        assert_eq!(assembler.header(), Some(header(5)));
        assert_eq!(assembler.rows_received(), 2);
        assert_eq!(assembler.pixels()[..8], gray_frame(5)[..8]);
        assert_eq!(assembler.row(2), None);
        assert_eq!(missing(&assembler), [2]);
        assembler.unknown()
    };
    let palette = Palette::EMPTY;
    let resized = |width, height, format| {
        Packet::Header(FrameHeader { frame: 6, width, height, format, palette })
    };
    let gray = PixelFormat::Gray8;
    refuse(resized(4, 4, gray), ReceiveError::TooLarge);
    refuse(resized(5, 3, gray), ReceiveError::TooLarge);
    refuse(resized(3, 4, gray), ReceiveError::TooLarge);
    refuse(resized(4, 3, PixelFormat::Rgb565), ReceiveError::TooLarge);
    refuse(resized(4, 3, PixelFormat::Rgb888), ReceiveError::TooLarge);
    refuse(resized(33, 3, PixelFormat::Mono), ReceiveError::TooLarge);
    refuse(resized(u16::MAX, u16::MAX, PixelFormat::Rgb888), ReceiveError::TooLarge);
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
    let rows = |y, count| Packet::Rows { frame: 5, y, count, payload: &pixels };
    refuse(rows(3, 1), ReceiveError::Row);
    refuse(rows(1, 3), ReceiveError::Row);
    refuse(rows(u16::MAX, 1), ReceiveError::Row);
    let (short, long) = (UnpackError::TooShort, UnpackError::TooLong);
    refuse(row(5, 2, &pixels[..3]), ReceiveError::Payload(short));
    refuse(row(5, 2, &pixels), ReceiveError::Payload(long));
    // The header of frame 6 was refused; asking for it again would never end.
    for _ in 0..3 {
        assert_eq!(refuse(row(6, 0, &pixels[..4]), ReceiveError::UnknownFrame), None);
    }
    // That of frame 7 was not. One packet may be late; two are a frame.
    assert_eq!(refuse(row(7, 0, &pixels[..4]), ReceiveError::UnknownFrame), None);
    assert_eq!(refuse(row(7, 0, &pixels[..4]), ReceiveError::UnknownFrame), Some(7));

    // The header or a row of the current frame shows that the sender is still there.
    for packet in [Packet::Header(header(5)), row(5, 0, &pixels[..4])] {
        for _ in 0..2 {
            assert!(assembler.accept(&row(7, 0, &pixels[..4])).is_err());
        }
        assert_eq!(assembler.unknown(), Some(7));
        assert_eq!(assembler.accept(&packet), Ok(Event::Repeated));
        assert_eq!(assembler.unknown(), None);
    }

    // A smaller frame fits.
    let event = assembler.accept(&resized(3, 2, gray));
    assert!(matches!(event, Ok(Event::Started { lost: Some(5), .. })));
    assert_eq!(assembler.pixels().len(), 6);
    let ack = Packet::Ack { frame: 6 };
    assert_eq!(assembler.accept(&ack), Ok(Event::Ignored));
}

/// A sender that restarted with the same frame id but sees another scene: the hash tells, and all rows
/// are fetched again.
#[test]
fn a_wrong_hash_makes_all_rows_missing() {
    for end_first in [false, true] {
        let mut small = Small::new();
        let mut assembler = Assembler::new(small.memory());
        let mut accept = |packet: Packet<'_>| assembler.accept(&packet).unwrap();
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
            assert_eq!(accept(row(y, &[9; 4])), row_came(y));
        }
        assert_eq!(accept(end), Event::Complete);
        // And from a complete frame back, if its end comes again with another hash.
        let hash = FrameHash::from_value(1);
        assert_eq!(accept(Packet::End { frame: 1, hash }), Event::HashMismatch);
        assert!(!assembler.is_complete());
        assert_eq!(assembler.gaps().collect::<Vec<_>>(), [(0, 3)]);
    }
}

/// A receiver asks for all of it in one request.
#[test]
fn a_wrong_hash_is_answered() {
    let mut small = Small::new();
    let mut receiver = TestReceiver::new(small.memory(), TIMING);
    let [begin, a, b, c, _] = packets(1);
    let mut end = [0; 32];
    let len = scancsg::stream::encode_end(1, FrameHash::from_value(1), &mut end).unwrap();
    receive(&mut receiver, &[begin, a, b, c].concat(), 0);
    assert_eq!(receive(&mut receiver, &end[..len], 0), [Event::HashMismatch]);
    assert_eq!(asked(&mut receiver).into_iter().map(rows_of).collect::<Vec<_>>(), [Some((0, 3))]);
}

#[test]
fn a_sender_refuses_what_is_not_its_frame() {
    let mut sender = sender();
    let row = gray_row(1, 0);
    assert_eq!(sender.row(0, &row), Err(EncodeError::NoFrame));
    assert_eq!(sender.poll(0), Task::Done(Delivery::Unheard));
    let wide = FrameHeader { width: 82, format: PixelFormat::Rgb888, ..header(1) };
    assert_eq!(sender.begin(wide), Err(EncodeError::BufferTooSmall));
    let empty = FrameHeader { height: 0, ..header(1) };
    assert_eq!(sender.begin(empty), Err(EncodeError::Size));
    assert_eq!(sender.header(), None);
    assert_eq!(sender.poll(0), Task::Done(Delivery::Unheard));
    assert_eq!(sender.bytes_sent(), 0);

    sender.begin(header(1)).unwrap();
    assert_eq!(sender.header(), Some(header(1)));
    let [begin, a, _, _, end] = packets(1);
    // No row is wanted before the header is on its way.
    assert_eq!(sender.poll(0), Task::Send(&begin));
    assert_eq!(sender.row(0, &row), Err(EncodeError::Order));
    sender.sent(0);
    let before = sender.bytes_sent();
    assert_eq!(before, begin.len() as u64);
    for y in 0..3 {
        // What fails changes nothing: the same row is wanted after it.
        let wrong = [y + 1, y + 2, 3, u16::MAX];
        assert_eq!(sender.poll(0), Task::Row(y));
        assert!(wrong.iter().all(|wrong| sender.row(*wrong, &row) == Err(EncodeError::Order)));
        assert_eq!(sender.row(y, &row[..3]), Err(EncodeError::Width));
        assert_eq!(sender.row(y, &[Rgb565(0); 4]), Err(EncodeError::Format));
        assert_eq!(sender.row(y, &[Mono(true); 4]), Err(EncodeError::Format));
        assert_eq!(sender.poll(0), Task::Row(y));
        sender.row(y, &gray_row(1, y)).unwrap();
        // One row at a time.
        assert_eq!(sender.row(y, &gray_row(1, y)), Err(EncodeError::Order));
        assert!(matches!(sender.poll(0), Task::Send(_)));
        sender.sent(0);
        if y == 0 {
            assert_eq!(sender.bytes_sent(), (begin.len() + a.len()) as u64);
        }
    }
    assert_eq!(sender.poll(0), Task::Send(&end));
    sender.sent(0);
    assert!(matches!(sender.poll(0), Task::Listen(_)));
    assert_eq!(sender.row(0, &row), Err(EncodeError::Order));
}

fn ask(sender: &mut TestSender, frame: u16, part: Part, now: u32) {
    let mut packet = [0; 32];
    let len = encode_request(Request { frame, part }, &mut packet).unwrap();
    packet[..len].iter().for_each(|byte| sender.receive(*byte, now));
}

fn acknowledge(sender: &mut TestSender, frame: u16, now: u32) {
    let mut packet = [0; 32];
    let len = encode_ack(frame, &mut packet).unwrap();
    packet[..len].iter().for_each(|byte| sender.receive(*byte, now));
}

fn some_rows(y: u16, count: u16) -> Part {
    Part::Rows { y, count, limit: 127 }
}

/// Every part is sent again as it was, whenever it is asked for, and the end follows it. Repairs do not
/// count in the hash.
#[test]
fn every_part_is_sent_again_that_is_asked_for() {
    let [begin, a, b, c, end] = packets(1);
    let parts = [
        (Part::Header, vec![&begin]),
        // There is no such row: the other end has another header.
        (some_rows(3, 1), vec![&begin]),
        (some_rows(1, 1), vec![&b]),
        (some_rows(0, 3), vec![&a, &b, &c]),
        (some_rows(1, u16::MAX), vec![&b, &c]),
        (Part::End, vec![]),
    ];
    for (part, packets) in parts {
        let mut sender = sender();
        sender.begin(header(1)).unwrap();
        let (sent, delivery) = run(&mut sender, 0, |y| gray_row(1, y).to_vec());
        assert_eq!((sent.len(), delivery), (5, None));
        // What isn't there, or isn't of this frame, is no reason to send anything.
        ask(&mut sender, 1, some_rows(0, 0), 1);
        ask(&mut sender, 2, Part::Header, 1);
        acknowledge(&mut sender, 2, 1);
        assert_eq!(run(&mut sender, 1, |y| gray_row(1, y).to_vec()), (vec![], None));

        ask(&mut sender, 1, part, 2);
        let (sent, _) = run(&mut sender, 2, |y| gray_row(1, y).to_vec());
        let expected: Vec<_> = packets.into_iter().chain([&end]).cloned().collect();
        assert_eq!(sent, expected, "{part:?}");
        acknowledge(&mut sender, 1, 3);
        let (sent, delivery) = run(&mut sender, 3, |y| gray_row(1, y).to_vec());
        assert_eq!(sent.len(), 0);
        assert!(matches!(delivery, Some(Delivery::Acknowledged { repairs }) if repairs > 0));
    }
}

/// An acknowledgement is one of this frame only behind the frame's end, however late that is.
#[test]
fn an_acknowledgement_before_the_end_is_none() {
    let [.., end] = packets(1);
    let mut sender = sender();
    sender.begin(header(1)).unwrap();
    loop {
        let is_end = match sender.poll(0) {
            Task::Send(packet) => packet == end,
            Task::Row(y) => {
                sender.row(y, &gray_row(1, y)).unwrap();
                continue;
            }
            other => panic!("{other:?}"),
        };
        acknowledge(&mut sender, 1, 0);
        sender.sent(0);
        if is_end {
            break;
        }
    }
    assert!(matches!(sender.poll(0), Task::Listen(_)));
    acknowledge(&mut sender, 1, 0);
    assert_eq!(sender.poll(0), Task::Done(Delivery::Acknowledged { repairs: 0 }));
}

/// Between two rows of the sweep, requests are served before the next row; rows that are still to come
/// are not lost.
#[test]
fn repairs_go_before_rows() {
    let [begin, a, b, c, end] = packets(1);
    let mut sender = sender();
    sender.begin(header(1)).unwrap();
    let mut sent = Vec::new();
    let mut is_asked = false;
    let delivery = loop {
        match sender.poll(0) {
            Task::Send(packet) => {
                sent.push(packet.to_vec());
                sender.sent(0);
            }
            Task::Row(y) => {
                if y == 2 && !is_asked {
                    is_asked = true;
                    ask(&mut sender, 1, some_rows(0, 1), 0);
                    ask(&mut sender, 1, some_rows(1, 9), 0);
                    ask(&mut sender, 1, some_rows(2, 1), 0);
                    ask(&mut sender, 1, Part::Header, 0);
                    ask(&mut sender, 1, Part::End, 0);
                    // Too early: not all rows have been sent.
                    acknowledge(&mut sender, 1, 0);
                } else {
                    sender.row(y, &gray_row(1, y)).unwrap();
                }
            }
            Task::Listen(_) => acknowledge(&mut sender, 1, 0),
            Task::Done(delivery) => break delivery,
        }
    };
    // In whatever order.
    sent[4..6].sort_unstable_by_key(|packet| packet != &a);
    assert_eq!(sent, [&begin, &a, &b, &begin, &a, &b, &c, &end].map(Clone::clone));
    assert_eq!(delivery, Delivery::Acknowledged { repairs: 5 });
}

/// A packet is wanted until all of it is written, so a line that fails in the middle of one costs nothing:
/// the packet is written once more, whole.
#[test]
fn a_packet_that_could_not_be_written_is_wanted_again() {
    let whole = packets(1).concat();
    // The line breaks after every possible number of bytes, then works again.
    for room in 0..whole.len() {
        let mut sender = sender();
        sender.begin(header(1)).unwrap();
        let (mut line, mut failures) = (Vec::new(), 0);
        loop {
            match sender.poll(0) {
                Task::Send(packet) if failures == 0 && line.len() + packet.len() > room => {
                    failures += 1;
                    let part = room - line.len();
                    line.extend_from_slice(&packet[..part]);
                }
                Task::Send(packet) => {
                    line.extend_from_slice(packet);
                    sender.sent(0);
                }
                Task::Row(y) => sender.row(y, &gray_row(1, y)).unwrap(),
                Task::Listen(_) | Task::Done(_) => break,
            }
        }
        assert_eq!(failures, 1, "{room}");
        // What was not written whole does not count.
        assert_eq!(sender.bytes_sent(), whole.len() as u64);

        let mut small = Small::new();
        let mut receiver = TestReceiver::new(small.memory(), TIMING);
        let events = receive(&mut receiver, &line, 0);
        // Half a row is cut off only by its repetition's terminator, so that one is lost as well.
        if events.last() != Some(&Event::Complete) {
            assert_eq!(receiver.poll(TIMING.ask), None);
            for part in asked(&mut receiver) {
                ask(&mut sender, 1, part, 0);
            }
            let repairs = run(&mut sender, 0, |y| gray_row(1, y).to_vec()).0.concat();
            let events = receive(&mut receiver, &repairs, 0);
            assert!(events.contains(&Event::Complete), "{room}: {events:?}");
        }
        assert_eq!(receiver.frame().pixels(), gray_frame(1), "{room}");
    }
}

#[test]
fn errors_are_errors() {
    fn check(error: &dyn Error, words: &str, has_source: bool) {
        assert_eq!(error.to_string(), words);
        assert_eq!(error.source().is_some(), has_source);
    }
    let pipe = embedded_io::ErrorKind::BrokenPipe;
    check(&ServeError::Write(pipe), "writing to the line failed", true);
    check(&ServeError::Read(pipe), "reading from the line failed", true);
    let closed = ServeError::<embedded_io::ErrorKind>::Closed;
    check(&closed, ServeError::<()>::Closed.as_str(), false);
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
fn scene<P>(y: u16, pixel: fn(u16) -> P) -> Vec<P> {
    (0..40)
        .map(|x| {
            let inside = x > y && x < 35;
            pixel(if inside { x * 1237 + y * 77 } else { 9 })
        })
        .collect()
}

/// Sends one frame over a lossy line in both directions until the sender hears the acknowledgement.
/// Returns how many rounds it took.
fn repair<P: Bytes>(seed: u64, one_in: u64, format: PixelFormat, pixel: fn(u16) -> P) -> usize {
    let palette = Palette::EMPTY;
    let header = FrameHeader { frame: seed as u16, width: 40, height: 30, format, palette };
    let expected: Vec<u8> = (0..30).flat_map(|y| P::bytes(&scene(y, pixel))).collect();
    let mut noise = Lcg(seed);
    let mut pixels = vec![0; expected.len()];
    let mut flags = vec![false; 30];
    let memory = Memory { pixels: &mut pixels, rows: &mut flags, above: &mut [] };
    let mut receiver = TestReceiver::new(memory, TIMING);
    let mut sender = TestSender::new(Plain, Patience { silences: 1000, ..PATIENCE });
    sender.begin(header).unwrap();
    // A round asks for eight gaps at most.
    for round in 1..5000 {
        let now = 10 * round as u32;
        let (packets, delivery) = run(&mut sender, now, |y| scene(y, pixel));
        match delivery {
            Some(Delivery::Acknowledged { .. }) => {
                assert!(receiver.frame().is_complete());
                assert_eq!(receiver.frame().pixels(), expected);
                return round - 1;
            }
            Some(other) => panic!("seed {seed}, one in {one_in}: {other:?}"),
            None => {}
        }
        let bytes = noise.carry(&packets.concat(), one_in);
        receive(&mut receiver, &bytes, now);
        assert_eq!(receiver.poll(now), None);
        let mut answer = Vec::new();
        while let Some(bytes) = receiver.answer() {
            answer.extend_from_slice(bytes);
        }
        noise.carry(&answer, one_in).iter().for_each(|byte| sender.receive(*byte, now));
    }
    panic!("seed {seed}, one in {one_in}: not repaired");
}

#[test]
fn a_lossy_line_is_repaired() {
    let mut repaired = 0;
    let gray = |v| Gray8(v as u8);
    for seed in 1..=60 {
        for one_in in [60, 200, 2000] {
            let rounds = repair(seed, one_in, PixelFormat::Gray8, gray);
            repaired += usize::from(rounds > 1);
            let rounds = repair(seed, one_in, PixelFormat::Rgb565, Rgb565);
            repaired += usize::from(rounds > 1);
        }
    }
    // A test of repairs on a line that loses nothing would be none.
    assert!(repaired > 250, "{repaired} of 360");
    assert_eq!(repair(1, u64::MAX, PixelFormat::Rgb565, Rgb565), 1);
}

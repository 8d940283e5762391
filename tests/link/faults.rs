//! What goes wrong on lines, one fault at a time: what a receiver and a sender make of it.

#![allow(clippy::unwrap_used, clippy::panic)]

use scancsg::render::{Gray8, Palette, Rgb, Rgb565};
use scancsg::stream::{
    Decoder, Delivery, Event, FrameHeader, Memory, Packet, Part, Patience, PixelFormat, Plain,
    Predictive, ReceiveError, Receiver, Request, Sender, Task, Timing, UnpackError, encode_ack,
    encode_request, packet_capacity,
};
use testkit::link::Bytes;
use testkit::random::Random;

const CAPACITY: usize = packet_capacity(80, PixelFormat::Rgb565);
const TIMING: Timing = Timing { ask: 50, give_up: 1000 };
const PATIENCE: Patience = Patience { ticks: 1000, silences: 3 };
type TestSender = Sender<Plain, CAPACITY>;
type TestReceiver = Receiver<'static, CAPACITY>;

fn header(frame: u16, width: u16, height: u16, format: PixelFormat) -> FrameHeader {
    FrameHeader { frame, width, height, format, palette: Palette::EMPTY }
}

fn small(frame: u16) -> FrameHeader {
    header(frame, 8, 12, PixelFormat::Gray8)
}

fn gray_row(header: FrameHeader, y: u16) -> Vec<Gray8> {
    let level = |x| (header.frame * 31 + y * 7 + x * (header.width % 5 + 1)) as u8;
    (0..header.width).map(|x| Gray8(level(x))).collect()
}

fn rgb_row(header: FrameHeader, y: u16) -> Vec<Rgb565> {
    (0..header.width).map(|x| Rgb565(header.frame * 31 + y * 700 + x)).collect()
}

/// All that a sender says until it listens or is done.
fn run<P: Bytes>(
    sender: &mut TestSender,
    now: u32,
    row: impl Fn(FrameHeader, u16) -> Vec<P>,
) -> (Vec<Vec<u8>>, Option<Delivery>) {
    let mut packets = Vec::new();
    let header = sender.header().unwrap();
    loop {
        match sender.poll(now) {
            Task::Send(packet) => {
                packets.push(packet.to_vec());
                sender.sent(now);
            }
            Task::Row(y) => sender.row(y, &row(header, y)).unwrap(),
            Task::Listen(_) => return (packets, None),
            Task::Done(delivery) => return (packets, Some(delivery)),
        }
    }
}

/// A frame's packets: header, rows, end.
fn packets(header: FrameHeader) -> Vec<Vec<u8>> {
    let mut sender = TestSender::new(Plain, PATIENCE);
    sender.begin(header).unwrap();
    match header.format {
        PixelFormat::Gray8 => run(&mut sender, 0, gray_row).0,
        _ => run(&mut sender, 0, rgb_row).0,
    }
}

fn frame_bytes(header: FrameHeader) -> Vec<u8> {
    (0..header.height)
        .flat_map(|y| match header.format {
            PixelFormat::Gray8 => Gray8::bytes(&gray_row(header, y)),
            _ => Rgb565::bytes(&rgb_row(header, y)),
        })
        .collect()
}

/// A receiver with memory for 80 × 60 grey pixels.
fn receiver() -> TestReceiver {
    let memory =
        Memory { pixels: vec![0; 4800].leak(), rows: vec![false; 60].leak(), above: &mut [] };
    TestReceiver::new(memory, TIMING)
}

fn receive(receiver: &mut TestReceiver, mut bytes: &[u8], now: u32) -> Vec<Event> {
    std::iter::from_fn(|| receiver.receive(&mut bytes, now)).collect()
}

/// What a receiver asks for and acknowledges.
fn answers(receiver: &mut TestReceiver) -> (Vec<(u16, Part)>, Vec<u16>) {
    let (mut parts, mut acks) = (Vec::new(), Vec::new());
    while let Some(mut bytes) = receiver.answer() {
        match Decoder::<32>::new().feed(&mut bytes) {
            Some(Ok(Packet::Request(Request { frame, part }))) => parts.push((frame, part)),
            Some(Ok(Packet::Ack { frame })) => acks.push(frame),
            other => panic!("{other:?}"),
        }
    }
    (parts, acks)
}

/// The ranges of a frame's rows that are asked for.
fn ranges(parts: &[(u16, Part)], of: u16) -> Vec<(u16, u16)> {
    let range = |(frame, part): &(u16, Part)| match *part {
        Part::Rows { y, count, .. } if *frame == of => Some((y, count)),
        _ => None,
    };
    let mut ranges: Vec<_> = parts.iter().filter_map(range).collect();
    ranges.sort_unstable();
    ranges
}

/// Late packets of the frame before, however many and of whatever kind but a header, change nothing of the
/// frame that has begun: no row is forgotten, none is asked for twice, and in silence what is missing is
/// asked for.
#[test]
fn late_packets_of_the_frame_before() {
    let (old, new) = (packets(small(4)), packets(small(5)));
    for late in [vec![1], vec![1, 2], vec![3; 9], vec![13], vec![1, 13], vec![13, 13, 2, 13]] {
        let mut receiver = receiver();
        receive(&mut receiver, &old.concat(), 0);
        assert_eq!(answers(&mut receiver).1, [4]);
        // The new frame as far as its sixth row; the third one is lost, and asked for.
        let line = [&new[..3], &new[4..7]].concat().concat();
        receive(&mut receiver, &line, 1);
        assert_eq!(ranges(&answers(&mut receiver).0, 5), [(2, 1)]);

        let line = late.iter().map(|i| old[*i].clone()).collect::<Vec<_>>().concat();
        assert_eq!(receive(&mut receiver, &line, 2), [], "{late:?}");
        assert_eq!(ranges(&answers(&mut receiver).0, 5), [], "{late:?}");
        // Silence: all of what is missing of the new frame is asked for, whatever else is.
        assert_eq!(receiver.poll(2 + TIMING.ask), None);
        assert_eq!(ranges(&answers(&mut receiver).0, 5), [(2, 1), (6, 6)], "{late:?}");
        // The next row is the next row.
        receive(&mut receiver, &line, 60);
        answers(&mut receiver);
        let row = Event::Rows { y: 6, count: 1 };
        assert_eq!(receive(&mut receiver, &new[7], 61), [row]);
        assert_eq!(ranges(&answers(&mut receiver).0, 5), [], "{late:?}");
        let rest = [&new[8..13], &new[3..4], &new[13..]].concat().concat();
        assert_eq!(receive(&mut receiver, &rest, 62).last(), Some(&Event::Complete));
        assert_eq!(receiver.frame().pixels(), frame_bytes(small(5)));
        assert_eq!(answers(&mut receiver).1, [5]);
    }
}

/// A device that is reset begins with the same frame's number: another size, format or palette is another
/// frame, and the same one with another scene is fetched anew.
#[test]
fn a_reset_device_with_the_same_frame_number() {
    let first = header(0, 80, 60, PixelFormat::Gray8);
    let colored = [Rgb::WHITE].into_iter().collect();
    let others = [
        header(0, 60, 60, PixelFormat::Gray8),
        header(0, 80, 20, PixelFormat::Gray8),
        header(0, 40, 60, PixelFormat::Rgb565),
        header(0, 80, 30, PixelFormat::Rgb565),
        FrameHeader { palette: colored, ..first },
    ];
    for other in others {
        for (before, after) in [(first, other), (other, first)] {
            // After any number of packets, the last one cut in two.
            let (old, new) = (packets(before), packets(after).concat());
            for count in [1, 2, 9, old.len() - 1, old.len()] {
                let mut receiver = receiver();
                let line = old[..count].concat();
                receive(&mut receiver, &line[..line.len() - 3], 0);
                let events = receive(&mut receiver, &new, 1);
                assert!(events.contains(&Event::Complete), "{count}");
                let started = events.iter().find(|event| matches!(event, Event::Started { .. }));
                assert!(matches!(started, Some(Event::Started { header, .. }) if *header == after));
                assert_eq!(receiver.frame().pixels(), frame_bytes(after));
                assert_eq!(answers(&mut receiver).1.last(), Some(&0));
            }
        }
    }

    // The same header, and rows of another scene behind it.
    let mut sender = TestSender::new(Plain, PATIENCE);
    sender.begin(first).unwrap();
    let other_row = |header: FrameHeader, y| gray_row(FrameHeader { frame: 77, ..header }, y);
    let again = run(&mut sender, 1, other_row).0.concat();
    let expected: Vec<u8> = (0..60).flat_map(|y| Gray8::bytes(&other_row(first, y))).collect();
    for count in [2, 30, 61, 62] {
        let mut receiver = receiver();
        receive(&mut receiver, &packets(first)[..count].concat(), 0);
        answers(&mut receiver);
        let events = receive(&mut receiver, &again, 1);
        assert_eq!(events.last(), Some(&Event::HashMismatch), "{count}");
        let parts = answers(&mut receiver).0;
        assert_eq!(ranges(&parts, 0), [(0, 60)], "{count}");
        say(&mut sender, parts[0].1, 0, 2);
        let repairs = run(&mut sender, 2, other_row).0.concat();
        assert!(receive(&mut receiver, &repairs, 3).contains(&Event::Complete), "{count}");
        assert_eq!(receiver.frame().pixels(), expected, "{count}");
    }
}

/// A device that is reset in the middle of a frame, or behind one, and whose new header gets lost, while it has
/// the same number: rows that don't fit the old header, rows that are never there, and a hash that stays wrong
/// are reasons to ask for the header. The other end hears one request at a time.
#[test]
fn a_reset_device_whose_header_is_lost() {
    let first = header(0, 80, 40, PixelFormat::Gray8);
    let others = [
        header(0, 60, 40, PixelFormat::Gray8),
        header(0, 80, 60, PixelFormat::Gray8),
        header(0, 80, 2, PixelFormat::Gray8),
        FrameHeader { palette: [Rgb::WHITE].into_iter().collect(), ..first },
    ];
    let colors = header(0, 40, 30, PixelFormat::Rgb565);
    for (before, after) in others.map(|other| (first, other)).into_iter().chain([(colors, first)]) {
        let old = packets(before);
        for count in [1, 9, old.len() - 1, old.len()] {
            let mut receiver = receiver();
            receive(&mut receiver, &old[..count].concat(), 0);
            answers(&mut receiver);
            let mut sender = TestSender::new(Plain, PATIENCE);
            sender.begin(after).unwrap();
            let (sent, _) = run(&mut sender, 0, gray_row);
            let mut line = sent[1..].concat();
            for now in 1..100 {
                receive(&mut receiver, &line, now);
                receiver.poll(now);
                let heard = receiver.answer().map(<[u8]>::to_vec).unwrap_or_default();
                answers(&mut receiver);
                heard.iter().for_each(|byte| sender.receive(*byte, now));
                let (sent, delivery) = run(&mut sender, now, gray_row);
                if delivery.is_some() {
                    break;
                }
                line = sent.concat();
            }
            assert!(receiver.frame().is_complete(), "{before:?} {after:?} {count}");
            assert_eq!(receiver.frame().pixels(), frame_bytes(after));
        }
    }
}

/// A row that is longer than the packets that are asked for is coded by prediction all the same: by itself, it
/// would be twice as long, and get lost more often.
#[test]
fn a_row_longer_than_the_limit_is_still_predicted() {
    let mut random = Random::seeded(1);
    let rows: Vec<Vec<_>> =
        (0..3).map(|_| (0..80).map(|_| Gray8(100 + random.below(8) as u8)).collect()).collect();
    let mut sender = Sender::<_, CAPACITY>::new(Predictive::<Gray8, 80>::new(), PATIENCE);
    sender.begin(header(1, 80, 3, PixelFormat::Gray8)).unwrap();
    let run = |sender: &mut Sender<_, CAPACITY>| {
        let mut packets = Vec::new();
        loop {
            match sender.poll(0) {
                Task::Send(packet) => {
                    packets.push(packet.to_vec());
                    sender.sent(0);
                }
                Task::Row(y) => sender.row(y, &rows[usize::from(y)]).unwrap(),
                _ => return packets,
            }
        }
    };
    assert_eq!(run(&mut sender).len(), 3);
    let mut packet = [0; 32];
    let part = Part::Rows { y: 0, count: 3, limit: 31 };
    let len = encode_request(Request { frame: 1, part }, &mut packet).unwrap();
    packet[..len].iter().for_each(|byte| sender.receive(*byte, 0));
    // Each row in a packet of its own, where its bytes alone are 80, and the end.
    let lengths: Vec<_> = run(&mut sender).iter().map(Vec::len).collect();
    assert!(lengths.len() == 4 && lengths.iter().all(|len| *len < 80), "{lengths:?}");
}

fn say(sender: &mut TestSender, part: Part, frame: u16, now: u32) {
    let mut packet = [0; 32];
    let len = encode_request(Request { frame, part }, &mut packet).unwrap();
    packet[..len].iter().for_each(|byte| sender.receive(*byte, now));
}

fn acknowledge(sender: &mut TestSender, frame: u16, now: u32) {
    let mut packet = [0; 32];
    let len = encode_ack(frame, &mut packet).unwrap();
    packet[..len].iter().for_each(|byte| sender.receive(*byte, now));
}

/// A frame that is too large is said to be, and nothing is asked of its sender, so that it goes on.
#[test]
fn a_frame_that_is_too_large() {
    let mut receiver = receiver();
    let too_large = header(0, 80, 61, PixelFormat::Gray8);
    let fits = header(0, 80, 60, PixelFormat::Gray8);
    receive(&mut receiver, &packets(fits)[..5].concat(), 0);
    answers(&mut receiver);
    let events =
        receive(&mut receiver, &packets(header(1, 81, 60, PixelFormat::Gray8)).concat(), 1);
    assert_eq!(events, [Event::Refused(ReceiveError::TooLarge)]);
    assert_eq!(answers(&mut receiver), (vec![], vec![]));
    let events = receive(&mut receiver, &packets(too_large)[..1].concat(), 1);
    assert_eq!(events, [Event::Refused(ReceiveError::TooLarge)]);
}

/// Rows that were coded together need memory. A receiver that lends none says so, and asks for nothing, so
/// that the sender goes on; rows that were sent each for itself are taken in.
#[test]
fn no_memory_for_rows_that_are_coded_together() {
    let mut receiver = receiver();
    let predictive = Predictive::<Gray8, 80>::new();
    let mut sender = Sender::<_, CAPACITY>::new(predictive, PATIENCE);
    let no_memory = ReceiveError::Payload(UnpackError::NoMemory);
    let mut now = 0;
    for frame in 1..4 {
        sender.begin(small(frame)).unwrap();
        let mut events = Vec::new();
        let delivery = loop {
            now += 1;
            assert!(now < 4 * 5000, "the frame has no end");
            match sender.poll(now) {
                Task::Send(packet) => {
                    events.extend(receive(&mut receiver, packet, now));
                    sender.sent(now);
                }
                Task::Row(y) => sender.row(y, &gray_row(small(frame), y)).unwrap(),
                Task::Listen(_) => {}
                Task::Done(delivery) => break delivery,
            }
            receiver.poll(now);
            while let Some(answer) = receiver.answer() {
                answer.iter().for_each(|byte| sender.receive(*byte, now));
            }
        };
        assert_eq!(delivery, Delivery::Unheard);
        assert!(matches!(events[0], Event::Started { .. }));
        assert_eq!(events[1], Event::Refused(no_memory));
        assert!(matches!(events[2], Event::Incomplete { missing: 12 }));
    }
    let events = receive(&mut receiver, &packets(small(4))[..5].concat(), now);
    assert_eq!(events.len(), 5);
    let events = receive(&mut receiver, &packets(small(4))[6..].concat(), now);
    assert_eq!(events.last(), Some(&Event::Incomplete { missing: 1 }));
    assert_eq!(ranges(&answers(&mut receiver).0, 4), [(4, 1)]);
}

/// With all acknowledgements lost, every frame is complete once, and every repeated end is acknowledged.
#[test]
fn lost_acknowledgements() {
    let mut receiver = receiver();
    let mut sender = TestSender::new(Plain, PATIENCE);
    let mut now = 0;
    let mut recorded = Vec::new();
    for frame in 1..=3 {
        sender.begin(small(frame)).unwrap();
        let mut acks = 0;
        loop {
            let (packets, delivery) = run(&mut sender, now, gray_row);
            for event in receive(&mut receiver, &packets.concat(), now) {
                if event == Event::Complete {
                    recorded.push((frame, receiver.frame().pixels().to_vec()));
                }
            }
            let (parts, acknowledged) = answers(&mut receiver);
            assert_eq!(parts, []);
            assert!(acknowledged.iter().all(|id| *id == frame));
            acks += acknowledged.len();
            assert!(packets.is_empty() || acknowledged.len() == 1);
            if let Some(delivery) = delivery {
                assert_eq!(delivery, Delivery::Unheard);
                break;
            }
            now += 100;
        }
        assert!(acks >= 3, "{acks}");
    }
    let expected = [1, 2, 3].map(|frame| (frame, frame_bytes(small(frame))));
    assert_eq!(recorded, expected);
}

/// A lost header is asked for at the frame's first packet, and while packets come until it is there; in
/// the end the frame is whole.
#[test]
fn lost_headers() {
    // So many copies of the header are lost.
    for lost in 0..6 {
        let mut receiver = receiver();
        let mut sender = TestSender::new(Plain, PATIENCE);
        receive(&mut receiver, &packets(small(1)).concat(), 0);
        answers(&mut receiver);
        sender.begin(small(2)).unwrap();
        let (mut headers, mut now) = (0, 0);
        let delivery = loop {
            now += 1;
            assert!(now < 9_000, "{lost}");
            receiver.poll(now);
            while let Some(answer) = receiver.answer() {
                answer.iter().for_each(|byte| sender.receive(*byte, now));
            }
            match sender.poll(now) {
                Task::Send(packet) => {
                    let is_header = packet[0] == 0;
                    headers += usize::from(is_header);
                    if !is_header || headers > lost {
                        receive(&mut receiver, packet, now);
                    }
                    sender.sent(now);
                }
                Task::Row(y) => sender.row(y, &gray_row(small(2), y)).unwrap(),
                Task::Listen(_) => {}
                Task::Done(delivery) => break delivery,
            }
        };
        assert!(matches!(delivery, Delivery::Acknowledged { .. }), "{lost}: {delivery:?}");
        assert_eq!(receiver.frame().pixels(), frame_bytes(small(2)));
        assert!(headers > lost && headers < lost + 3, "{lost}: {headers}");
        // Long before any silence.
        assert!(lost > 2 || now < TIMING.ask, "{lost}: {now}");
    }
}

/// A sender that falls silent is given up in good time, once, wherever it broke off; and what comes later is
/// taken in.
#[test]
fn a_sender_that_falls_silent() {
    let packets = packets(small(1));
    let is_given_up = |receiver: &mut TestReceiver, from: u32| {
        let mut asks = 0;
        for now in from..from + TIMING.give_up {
            assert_eq!(receiver.poll(now), None);
            asks += usize::from(!answers(receiver).0.is_empty());
        }
        assert!((2..10).contains(&asks), "{asks}");
        let now = from.wrapping_add(TIMING.give_up);
        assert_eq!(receiver.poll(now), Some(Event::Silent { frame: 1 }));
        for later in [0, 1, TIMING.give_up, 9 * TIMING.give_up] {
            assert_eq!(receiver.poll(now + later), None);
            assert_eq!(answers(receiver), (vec![], vec![]));
        }
    };
    for count in [1, 2, 9, packets.len() - 1] {
        for start in [0, 5] {
            let mut receiver = receiver();
            receive(&mut receiver, &packets[start.min(count - 1)..count].concat(), 7);
            answers(&mut receiver);
            is_given_up(&mut receiver, 7);
            let events = receive(&mut receiver, &packets.concat(), 90_000);
            assert_eq!(events.last(), Some(&Event::Complete), "{count}");
        }
    }
    // The line's echo of what the receiver says itself is not a sender.
    for start in [0, 1] {
        let mut receiver = receiver();
        receive(&mut receiver, &packets[start..3].concat(), 7);
        let echo = |receiver: &mut TestReceiver, now| {
            while let Some(answer) = receiver.answer() {
                let answer = answer.to_vec();
                assert_eq!(receive(receiver, &answer, now), []);
            }
        };
        echo(&mut receiver, 7);
        for now in 8..7 + TIMING.give_up {
            assert_eq!(receiver.poll(now), None);
            echo(&mut receiver, now);
        }
        let event = receiver.poll(7 + TIMING.give_up);
        assert_eq!(event, Some(Event::Silent { frame: 1 }), "{start}");
    }
}

/// Bytes at the wrong speed are no packets: there is no event and no answer, and the traffic tells.
#[test]
fn garbage_is_no_traffic() {
    let mut receiver = receiver();
    let mut random = Random::seeded(1);
    for now in 0..3000 {
        let bytes: Vec<u8> = (0..20).map(|_| random.below(256) as u8).collect();
        assert_eq!(receive(&mut receiver, &bytes, now), []);
        assert_eq!(receiver.poll(now), None);
        assert_eq!(answers(&mut receiver), (vec![], vec![]));
    }
    let traffic = receiver.traffic();
    assert_eq!((traffic.bytes, traffic.packets, traffic.requests), (60_000, 0, 0));
    assert!(traffic.bad_packets > 100);
    assert!(traffic.last_error.is_some());
}

/// What the other end takes to answer is measured at its first answer to an end: neither those that come
/// with it nor those to a repeated end make the sender impatient.
#[test]
fn a_slow_answer_is_waited_for() {
    let is_listening = |sender: &mut TestSender, now| match sender.poll(now) {
        Task::Listen(ticks) => ticks,
        other => panic!("{other:?}"),
    };
    let mut sender = TestSender::new(Plain, PATIENCE);
    sender.begin(small(1)).unwrap();
    run(&mut sender, 0, gray_row);
    assert_eq!(is_listening(&mut sender, 0), PATIENCE.ticks);
    // Eight requests, a tick after each other.
    for y in 0..8 {
        let now = 100 + u32::from(y);
        say(&mut sender, Part::Rows { y, count: 1, limit: 99 }, 1, now);
        run(&mut sender, now, gray_row);
    }
    let wait = is_listening(&mut sender, 107);
    assert!((100..=PATIENCE.ticks).contains(&wait), "{wait}");
    // The end is repeated after some times that time, and later each time.
    let (mut ends, mut now, mut waits) = (0, 107, Vec::new());
    let mut last = now;
    while ends < 3 {
        now += 1;
        let (sent, delivery) = run(&mut sender, now, gray_row);
        assert_eq!(delivery, None);
        if !sent.is_empty() {
            ends += 1;
            waits.push(now - last);
            last = now;
        }
    }
    assert!(waits.iter().all(|wait| (100..=PATIENCE.ticks).contains(wait)), "{waits:?}");
    assert!(waits.is_sorted(), "{waits:?}");
    // An answer right behind a repeated end was on its way before.
    acknowledge(&mut sender, 1, now + 1);
    assert!(matches!(run(&mut sender, now + 1, gray_row).1, Some(Delivery::Acknowledged { .. })));
    sender.begin(small(2)).unwrap();
    run(&mut sender, now + 2, gray_row);
    let wait = is_listening(&mut sender, now + 2);
    assert!((100..=PATIENCE.ticks).contains(&wait), "{wait}");
}

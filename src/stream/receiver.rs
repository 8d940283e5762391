//! The receiving end, without I/O: bytes in, events and answers out.

use heapless::Vec;

use super::assembler::{Assembler, Event, Memory, ReceiveError};
use super::decoder::Decoder;
use super::error::{PacketError, UnpackError};
use super::wire::{
    FrameHeader, Packet, Part, REQUEST_CAPACITY, Request, encode_ack, encode_request,
};

/// When a [`Receiver`] asks again, and when it gives up. A tick is what the caller counts, for example a
/// millisecond.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Timing {
    /// So long after the last packet in the middle of a frame, what is missing is asked for: longer than a
    /// row takes to be rendered and sent. Then twice as long, up to eight times.
    pub ask: u32,
    /// So long after the last packet in the middle of a frame, the frame is given up.
    pub give_up: u32,
}

/// What has come over the line so far.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Traffic {
    /// Bytes.
    pub bytes: u64,
    /// Packets that could be read. None among many bytes: the line's speed is likely to be wrong.
    pub packets: u64,
    /// Packets that were damaged, or not what was expected.
    pub bad_packets: u64,
    /// Requests that were queued for the sender.
    pub requests: u64,
    /// The last packet that could not be read: how it was wrong.
    pub last_error: Option<PacketError>,
}

/// So many answers can wait to be written. What doesn't fit is asked for later.
const ANSWERS: usize = 8;
/// The header of a frame is asked for again after so many of its packets.
const STRAYS: u8 = 4;
/// After so many wrong hashes, or after rows that don't fit the header, it is asked for until it comes.
const DOUBTS: u8 = 2;
/// The most contents of a packet of rows that is asked for first; half of it each time it fails.
const FIRST_LIMIT: u8 = 127;

/// Receives frame after frame, and asks for what is missing: a state machine without I/O or clock.
///
/// Give it what the line brings ([`receive`](Self::receive)), call [`poll`](Self::poll) now and then, and
/// write what [`answer`](Self::answer) returns. It asks for rows as soon as a gap shows, acknowledges each
/// complete frame, and gives up a frame that has fallen silent. Without a way back, don't call `answer`.
///
/// `N` is the size of the packet buffer: [`packet_capacity`](super::packet_capacity) of the frames to come.
///
/// ```
/// use scancsg::render::{Gray8, Palette};
/// use scancsg::stream::{
///     Event, FrameHeader, Memory, Patience, PixelFormat, Plain, Receiver, Sender, Task, Timing,
///     packet_capacity,
/// };
///
/// const CAPACITY: usize = packet_capacity(4, PixelFormat::Gray8);
/// let (mut pixels, mut rows) = ([0; 8], [false; 2]);
/// let memory = Memory { pixels: &mut pixels, rows: &mut rows, above: &mut [] };
/// let mut receiver = Receiver::<CAPACITY>::new(memory, Timing { ask: 400, give_up: 10_000 });
///
/// // The other end; see `Sender`.
/// let mut sender = Sender::<_, CAPACITY>::new(Plain, Patience { ticks: 100, silences: 3 });
/// let (format, palette) = (PixelFormat::Gray8, Palette::EMPTY);
/// sender.begin(FrameHeader { frame: 1, width: 4, height: 2, format, palette })?;
/// loop {
///     match sender.poll(0) {
///         Task::Row(y) => sender.row(y, &[Gray8(y as u8); 4])?,
///         Task::Send(mut bytes) => {
///             while let Some(event) = receiver.receive(&mut bytes, 0) {
///                 if event == Event::Complete {
///                     assert_eq!(receiver.frame().pixels(), [0, 0, 0, 0, 1, 1, 1, 1]);
///                 }
///             }
///             sender.sent(0);
///         }
///         Task::Listen(_) => {
///             let answer = receiver.answer().unwrap_or_default();
///             answer.iter().for_each(|byte| sender.receive(*byte, 0));
///         }
///         Task::Done(_) => break,
///     }
/// }
/// # Ok::<(), scancsg::stream::EncodeError>(())
/// ```
#[derive(Debug)]
pub struct Receiver<'m, const N: usize> {
    decoder: Decoder<N>,
    frame: Assembler<'m>,
    /// What the machine knows apart from buffers: this code exists once.
    policy: Policy,
    answer: [u8; REQUEST_CAPACITY],
}

#[derive(Debug, Clone, Copy)]
enum Answer {
    Ack(u16),
    Request(Request),
}

#[derive(Debug)]
struct Policy {
    timing: Timing,
    /// The last one is given first.
    answers: Vec<Answer, ANSWERS>,
    /// The row behind the last one of the sweep that has come.
    expected: u16,
    has_ended: bool,
    /// There is no memory for the frame's rows.
    is_beyond: bool,
    /// So often rows were not as the header says: the sender's frame may be another one with this number.
    doubts: u8,
    limit: u8,
    /// When the last packet came.
    since: u32,
    /// So long after that is asked next, and so long after that for the second time.
    next: u32,
    step: u32,
    /// Nothing came for so long that it was given up.
    is_silent: bool,
    /// Packets of a frame without a header since that was asked for.
    strays: u8,
    traffic: Traffic,
}

impl<'m, const N: usize> Receiver<'m, N> {
    /// A receiver that waits for its first frame.
    #[must_use]
    pub const fn new(memory: Memory<'m>, timing: Timing) -> Self {
        let policy = Policy {
            timing,
            answers: Vec::new(),
            expected: 0,
            has_ended: false,
            is_beyond: false,
            doubts: 0,
            limit: FIRST_LIMIT,
            since: 0,
            next: 0,
            step: 0,
            is_silent: false,
            strays: 0,
            traffic: Traffic {
                bytes: 0,
                packets: 0,
                bad_packets: 0,
                requests: 0,
                last_error: None,
            },
        };
        let frame = Assembler::new(memory);
        Self { decoder: Decoder::new(), frame, policy, answer: [0; REQUEST_CAPACITY] }
    }

    /// The frame that is put together, or the last one.
    #[must_use]
    pub const fn frame(&self) -> &Assembler<'m> {
        &self.frame
    }

    /// What has come over the line so far.
    #[must_use]
    pub const fn traffic(&self) -> &Traffic {
        &self.policy.traffic
    }

    /// Takes in bytes up to the first event, and leaves the rest in `bytes`. `None` when all have been taken
    /// in. Write the [`answer`](Self::answer)s soon: the sender can repair rows between others.
    pub fn receive(&mut self, bytes: &mut &[u8], now: u32) -> Option<Event> {
        let available = bytes.len();
        let event = loop {
            let Some(packet) = self.decoder.feed(bytes) else { break None };
            if let Some(event) = self.policy.take_in(packet, &mut self.frame, now) {
                break Some(event);
            }
        };
        let taken = available.saturating_sub(bytes.len());
        self.policy.traffic.bytes = self.policy.traffic.bytes.wrapping_add(taken as u64);
        event
    }

    /// Looks at the clock: asks again, or gives the frame up ([`Event::Silent`]).
    pub fn poll(&mut self, now: u32) -> Option<Event> {
        self.policy.look(&self.frame, now)
    }

    /// The bytes of the next answer to the sender, if there is one. Each is given once: if it gets lost,
    /// the sender's next end shows it.
    pub fn answer(&mut self) -> Option<&[u8]> {
        let len = match self.policy.answers.pop()? {
            Answer::Ack(frame) => encode_ack(frame, &mut self.answer),
            Answer::Request(request) => encode_request(request, &mut self.answer),
        };
        self.answer.get(..len.ok()?)
    }
}

impl Policy {
    fn take_in(
        &mut self,
        packet: Result<Packet<'_>, PacketError>,
        frame: &mut Assembler<'_>,
        now: u32,
    ) -> Option<Event> {
        let packet = match packet {
            Ok(packet) => packet,
            Err(error) => {
                self.traffic.bad_packets += 1;
                self.traffic.last_error = Some(error);
                return None;
            }
        };
        self.traffic.packets += 1;
        let event = match frame.accept(&packet) {
            // What this end has said itself, as an echo: nobody is there for that.
            Ok(Event::Ignored) => return None,
            Ok(event) => event,
            Err(ReceiveError::UnknownFrame) => {
                if let Some(unknown) = frame.unknown() {
                    self.stray(unknown, matches!(packet, Packet::End { .. }), now);
                }
                return None;
            }
            Err(error) => {
                self.traffic.bad_packets += 1;
                let is_beyond = error == ReceiveError::Payload(UnpackError::NoMemory);
                let is_of_rows = matches!(error, ReceiveError::Row | ReceiveError::Payload(_));
                self.is_beyond |= is_beyond;
                if is_of_rows && !is_beyond {
                    self.doubts = DOUBTS;
                }
                return Some(Event::Refused(error));
            }
        };
        self.heard(now);
        self.strays = 0;
        if let Event::Started { .. } = event {
            self.begin();
        }
        match packet {
            Packet::Header(_) => self.doubts = 0,
            Packet::Row { frame, y, .. } => self.rows(frame, y, 1),
            Packet::Rows { frame, y, count, .. } => self.rows(frame, y, count.into()),
            _ => {}
        }
        match event {
            Event::Complete | Event::CompleteAgain => {
                self.answers.clear();
                if let Some(header) = frame.header() {
                    self.put(Answer::Ack(header.frame));
                }
            }
            // The sender has done all that it was asked for: what is missing now was lost.
            Event::Incomplete { .. } | Event::HashMismatch => {
                self.answers.clear();
                if event == Event::HashMismatch {
                    self.doubts = self.doubts.saturating_add(1);
                }
                self.ask_for_rest(frame);
            }
            _ => {}
        }
        Some(event)
    }

    /// A packet of a frame without a header has come.
    fn stray(&mut self, frame: u16, is_end: bool, now: u32) {
        self.heard(now);
        // At its first packet, some packets later, and whenever the sender is done. What is known of the
        // current frame stays: these may be late packets of the one before it.
        if self.strays == 0 || is_end {
            self.answers.clear();
            self.ask(frame, Part::Header);
        }
        self.strays = (self.strays + 1) % STRAYS;
    }

    /// The sender is there.
    fn heard(&mut self, now: u32) {
        let Timing { ask, .. } = self.timing;
        (self.since, self.next, self.step, self.is_silent) = (now, ask, ask, false);
    }

    fn begin(&mut self) {
        self.answers.clear();
        (self.expected, self.has_ended, self.limit) = (0, false, FIRST_LIMIT);
        self.is_beyond = false;
    }

    /// Rows have come: if they are not the next ones, those between are lost.
    fn rows(&mut self, frame: u16, y: u16, count: u16) {
        if y > self.expected && !self.has_ended {
            let count = y - self.expected;
            self.ask(frame, Part::Rows { y: self.expected, count, limit: self.limit });
        }
        self.expected = self.expected.max(y.saturating_add(count));
    }

    /// Asks for what is missing, or, if that may not be of this frame, for the header.
    fn ask_for_rest(&mut self, frame: &Assembler<'_>) {
        // The first wrong hash is likely to be of rows that came before the sender was reset.
        match frame.header().filter(|_| self.doubts >= DOUBTS) {
            Some(header) => self.ask(header.frame, Part::Header),
            None => self.ask_for_gaps(frame),
        }
    }

    fn ask_for_gaps(&mut self, frame: &Assembler<'_>) {
        let Some(FrameHeader { frame: id, .. }) = frame.header() else { return };
        for (y, count) in frame.gaps().take(ANSWERS) {
            self.ask(id, Part::Rows { y, count, limit: self.limit });
        }
        if self.has_ended {
            self.limit /= 2;
        }
        self.has_ended = true;
    }

    fn ask(&mut self, frame: u16, part: Part) {
        // To ask for rows that can't be taken in would never end.
        if self.is_beyond && part != Part::Header {
            return;
        }
        self.put(Answer::Request(Request { frame, part }));
        self.traffic.requests += 1;
    }

    fn put(&mut self, answer: Answer) {
        // What finds no place is asked for at the frame's end.
        let _ = self.answers.push(answer);
    }

    fn look(&mut self, frame: &Assembler<'_>, now: u32) -> Option<Event> {
        let unknown = frame.unknown();
        let current = frame.header().filter(|_| !frame.is_complete());
        let id = unknown.or(current.map(|header| header.frame)).filter(|_| !self.is_silent)?;
        let quiet = now.wrapping_sub(self.since);
        if quiet >= self.timing.give_up {
            self.is_silent = true;
            return Some(Event::Silent { frame: id });
        }
        if quiet >= self.next {
            self.step = self.step.saturating_mul(2).min(self.timing.ask.saturating_mul(8));
            self.next = quiet.saturating_add(self.step);
            self.answers.clear();
            // Either may be the sender's frame now. The sender ignores requests for any other.
            if let Some(unknown) = unknown {
                self.ask(unknown, Part::Header);
            }
            match current {
                Some(_) if frame.missing().next().is_some() => self.ask_for_rest(frame),
                Some(header) => self.ask(header.frame, Part::End),
                None => {}
            }
        }
        None
    }
}

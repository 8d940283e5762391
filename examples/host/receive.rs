//! Receiving frames: the host's end of the link.

use super::port::{Heard, Port, is_wait, write_all};
use scancsg::stream::{
    Assembler, Event, FrameHeader, Memory, Outcome, PixelFormat, ReceiveError, Receiver, Timing,
    Traffic, Upload, UploadTask, packet_capacity,
};
use std::time::{Duration, Instant};

/// The widest picture that is received, in pixels.
pub const MAX_WIDTH: u16 = 4096;
/// The highest picture.
pub const MAX_HEIGHT: u16 = 4096;
/// A packet buffer for such pictures.
pub const CAPACITY: usize = packet_capacity(MAX_WIDTH, PixelFormat::Rgb888);

/// So long is waited for a byte before there is a look at the clock.
const LISTEN: Duration = Duration::from_millis(10);
/// So long an answer waits for room on the line. If it gets lost, it is given again.
const ANSWER_WAIT: Duration = Duration::from_millis(100);

/// So long a chunk of an upload waits for room. If it gets lost, it is sent again.
const SEND_WAIT: Duration = Duration::from_secs(1);

/// The times of a receiver in milliseconds, on a line of so many bits per second: a packet of some rows
/// must have the time to come.
pub fn timing(baud: Option<u32>) -> Timing {
    let packet = baud.map_or(0, |baud| 5_000_000 / baud.max(1));
    Timing { ask: 400 + packet, give_up: 10_000 + 10 * packet }
}

/// The memory of a session: as large as the largest frame. The system gives it as it is used.
pub struct Room {
    pixels: Vec<u8>,
    rows: Vec<bool>,
    above: Vec<u16>,
}

impl Room {
    pub fn new() -> Self {
        let pixels = PixelFormat::Rgb888.row_bytes(MAX_WIDTH) * usize::from(MAX_HEIGHT);
        Self {
            pixels: vec![0; pixels],
            rows: vec![false; usize::from(MAX_HEIGHT)],
            above: vec![0; usize::from(MAX_WIDTH) + 2],
        }
    }
}

/// A frame, or what arrived of it.
#[derive(Debug, Clone)]
pub struct Frame {
    pub header: FrameHeader,
    /// Top row first, little-endian pixels; missing rows are zero.
    pub pixels: Vec<u8>,
    /// Which rows are there.
    pub rows: Vec<bool>,
    pub ending: Ending,
    /// From its header to its end.
    pub took: Duration,
}

impl Frame {
    fn new(header: FrameHeader) -> Self {
        Self {
            header,
            pixels: vec![0; header.frame_bytes().unwrap_or(0)],
            rows: vec![false; usize::from(header.height)],
            ending: Ending::Silent,
            took: Duration::ZERO,
        }
    }

    /// Copies the rows that have come.
    fn copy(&mut self, from: &Assembler<'_>, y: u16, count: u16) {
        let bytes = self.header.row_bytes();
        for y in y..y.saturating_add(count) {
            let place = self.pixels.chunks_exact_mut(bytes).nth(y.into());
            if let (Some(to), Some(row)) = (place, from.row(y)) {
                to.copy_from_slice(row);
                if let Some(here) = self.rows.get_mut(usize::from(y)) {
                    *here = true;
                }
            }
        }
    }

    /// Whether it can be in one film with another.
    pub fn is_like(&self, other: &FrameHeader) -> bool {
        let FrameHeader { width, height, format, .. } = self.header;
        (width, height, format) == (other.width, other.height, other.format)
    }

    /// What is wrong with the frame: nothing if it is whole.
    pub fn problem(&self) -> Option<String> {
        let why = match self.ending {
            Ending::Complete => return None,
            Ending::Overtaken => "the next frame began before it was whole",
            Ending::Restarted => "the device began it again, in another way",
            Ending::Closed => "the line closed in the middle of it",
            Ending::Silent => "the sender fell silent",
            Ending::Stopped => "stopped in the middle of it",
        };
        let rows = self.missing().map_or_else(
            || "all rows are there, but not its end".to_string(),
            |rows| format!("missing rows: {rows}"),
        );
        Some(format!("frame {}: {why}; {rows}", self.header.frame))
    }

    /// The missing rows, as ranges for people: `3, 7-9`.
    fn missing(&self) -> Option<String> {
        let mut ranges: Vec<(usize, usize)> = Vec::new();
        for (y, _) in self.rows.iter().enumerate().filter(|(_, here)| !**here) {
            match ranges.last_mut() {
                Some((_, last)) if *last + 1 == y => *last = y,
                _ => ranges.push((y, y)),
            }
        }
        let texts: Vec<String> = ranges
            .into_iter()
            .map(|(first, last)| match first == last {
                true => first.to_string(),
                false => format!("{first}-{last}"),
            })
            .collect();
        (!texts.is_empty()).then(|| texts.join(", "))
    }
}

/// Why no more of a frame is to be expected.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ending {
    /// It is whole, and its hash is right.
    Complete,
    /// The sender began another frame.
    Overtaken,
    /// The sender began a frame of the same number, but of another size or format: it was reset.
    Restarted,
    /// The line was closed.
    Closed,
    /// Nothing came any more, whatever was asked for.
    Silent,
    /// The user wanted no more.
    Stopped,
}

/// What a session has to tell.
pub enum News {
    /// A frame has begun.
    Begun,
    /// Rows have come.
    Rows,
    /// No more is to be expected of this frame. If it is not whole, the next one may have begun.
    Frame(Frame),
    /// Something has come that can't be received.
    Refused(ReceiveError),
    /// Nothing that matters.
    Nothing,
    /// The other end of the line is gone.
    Closed,
}

/// Receives frame after frame from a port.
pub struct Session<'m, P: Port = Box<dyn Port>> {
    port: P,
    receiver: Box<Receiver<'m, CAPACITY>>,
    buffer: Vec<u8>,
    /// So many bytes of the buffer have been taken in.
    taken: usize,
    /// The frame under way, and when it began.
    frame: Option<(Frame, Instant)>,
    start: Instant,
}

impl<'m, P: Port> Session<'m, P> {
    pub fn new(port: P, room: &'m mut Room, timing: Timing) -> Self {
        let Room { pixels, rows, above } = room;
        let receiver = Box::new(Receiver::new(Memory { pixels, rows, above }, timing));
        let start = Instant::now();
        Self { port, receiver, buffer: Vec::new(), taken: 0, frame: None, start }
    }

    pub fn port(&mut self) -> &mut P {
        &mut self.port
    }

    pub fn traffic(&self) -> Traffic {
        *self.receiver.traffic()
    }

    /// What is there of the current frame, or of the last one.
    pub fn picture(&self) -> &Assembler<'m> {
        self.receiver.frame()
    }

    /// The frame under way is given up.
    pub fn unfinished(&mut self, ending: Ending) -> Option<Frame> {
        let (frame, since) = self.frame.take()?;
        Some(Frame { ending, took: since.elapsed(), ..frame })
    }

    /// Listens for a moment, or until something happens, and answers the sender.
    pub fn listen(&mut self) -> News {
        let now = self.start.elapsed().as_millis() as u32;
        let mut rest = self.buffer.get(self.taken..).unwrap_or_default();
        let before = rest.len();
        let event = self.receiver.receive(&mut rest, now);
        self.taken += before - rest.len();
        let event = event.or_else(|| self.receiver.poll(now));
        while let Some(answer) = self.receiver.answer() {
            let _ = write_all(&mut self.port, answer, ANSWER_WAIT);
        }
        if let Some(event) = event {
            return self.news(event);
        }
        self.buffer.resize(4096, 0);
        let heard = self.port.read(&mut self.buffer, LISTEN);
        let count = if let Heard::Bytes(count) = heard { count } else { 0 };
        self.buffer.truncate(count);
        self.taken = 0;
        if heard == Heard::Closed { News::Closed } else { News::Nothing }
    }

    fn news(&mut self, event: Event) -> News {
        match event {
            Event::Started { header, lost } => {
                let restarted = lost == Some(header.frame);
                let ending = if restarted { Ending::Restarted } else { Ending::Overtaken };
                let old = self.unfinished(ending).filter(|_| lost.is_some());
                self.frame = Some((Frame::new(header), Instant::now()));
                old.map_or(News::Begun, News::Frame)
            }
            Event::Rows { y, count } => {
                if let Some((frame, _)) = &mut self.frame {
                    frame.copy(self.receiver.frame(), y, count.into());
                }
                News::Rows
            }
            Event::Complete => match &mut self.frame {
                Some((frame, _)) => {
                    frame.copy(self.receiver.frame(), 0, frame.header.height);
                    self.unfinished(Ending::Complete).map_or(News::Nothing, News::Frame)
                }
                None => News::Nothing,
            },
            Event::HashMismatch => {
                if let Some((frame, _)) = &mut self.frame {
                    frame.rows.fill(false);
                }
                News::Nothing
            }
            // It may go on: the frame is still under way.
            Event::Silent { .. } => match &self.frame {
                Some((frame, since)) => News::Frame(Frame {
                    ending: Ending::Silent,
                    took: since.elapsed(),
                    ..frame.clone()
                }),
                None => News::Nothing,
            },
            Event::Refused(error) => News::Refused(error),
            _ => News::Nothing,
        }
    }

    /// Sends an upload. The frame that answers it comes next. `go_on` hears how many bytes are there, and says
    /// whether to go on.
    pub fn upload(
        &mut self,
        upload: &mut Upload<'_>,
        mut go_on: impl FnMut(usize) -> bool,
    ) -> Result<Outcome, String> {
        self.buffer.clear();
        self.taken = 0;
        while go_on(upload.delivered()) {
            let now = self.start.elapsed().as_millis() as u32;
            let wait = match upload.poll(now) {
                UploadTask::Send(packet) => {
                    // What came before it belongs to an earlier frame.
                    self.buffer.clear();
                    match write_all(&mut self.port, packet, SEND_WAIT) {
                        Err(error) if !is_wait(&error) => {
                            return Err(format!("sending failed: {error}"));
                        }
                        _ => upload.sent(self.start.elapsed().as_millis() as u32),
                    }
                    continue;
                }
                UploadTask::Listen(ticks) => Duration::from_millis(ticks.into()).min(LISTEN),
                UploadTask::Done(outcome) => return Ok(outcome),
            };
            let mut bytes = [0; 4096];
            match self.port.read(&mut bytes, wait) {
                Heard::Bytes(count) => {
                    let bytes = bytes.get(..count).unwrap_or_default();
                    let now = self.start.elapsed().as_millis() as u32;
                    bytes.iter().for_each(|byte| upload.receive(*byte, now));
                    self.buffer.extend_from_slice(bytes);
                }
                Heard::Silence => {}
                Heard::Closed => return Err("the line is closed at its other end".into()),
            }
        }
        Err("stopped before all was sent".into())
    }

    /// Receives the next frame; `watch` sees it grow. `None` if the line closes before one begins,
    /// or brings nothing for `patience`.
    pub fn frame(&mut self, patience: Duration, mut watch: impl FnMut(&Self)) -> Option<Frame> {
        let mut since = Instant::now();
        loop {
            match self.listen() {
                News::Frame(frame) => {
                    watch(self);
                    return Some(frame);
                }
                News::Begun | News::Rows => {
                    since = Instant::now();
                    watch(self);
                }
                News::Closed => return self.unfinished(Ending::Closed),
                News::Nothing | News::Refused(_) if since.elapsed() >= patience => {
                    return self.unfinished(Ending::Silent);
                }
                News::Nothing | News::Refused(_) => {}
            }
        }
    }
}

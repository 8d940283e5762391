//! A receiver whose frames become pixels of a canvas.

use crate::pixels::to_canvas;
use scancsg::stream::{
    Event, FrameHeader, Memory, PixelFormat, Receiver, Timing, Traffic, packet_capacity,
};

/// The widest and the highest picture that is received.
pub const MOST: u16 = 4096;

const CAPACITY: usize = packet_capacity(MOST, PixelFormat::Rgb888);

/// In milliseconds.
const TIMING: Timing = Timing { ask: 400, give_up: 10_000 };

/// What has happened, as far as a page cares.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum News {
    /// All bytes have been taken in.
    Nothing = 0,
    /// A frame has begun.
    Started = 1,
    /// A frame is complete.
    Complete = 2,
    /// The sender has fallen silent in the middle of a frame.
    Silent = 3,
}

/// Receives frames from a line, and keeps the last one as pixels of a canvas.
pub struct View {
    receiver: Receiver<'static, CAPACITY>,
    header: Option<FrameHeader>,
    canvas: Vec<u8>,
    complete: u64,
    lost: u64,
    answer: Vec<u8>,
}

impl View {
    /// A receiver at the beginning of a line. Its memory is never given back: a page makes a module for
    /// each line.
    #[must_use]
    pub fn new() -> Self {
        let most = usize::from(MOST);
        let pixels = vec![0; most * most * 3].leak();
        let memory =
            Memory { pixels, rows: vec![false; most].leak(), above: vec![0; most + 2].leak() };
        Self {
            receiver: Receiver::new(memory, TIMING),
            header: None,
            canvas: Vec::new(),
            complete: 0,
            lost: 0,
            answer: Vec::new(),
        }
    }

    /// Takes in bytes of the line up to the next news, and leaves the rest in `bytes`.
    pub fn receive(&mut self, bytes: &mut &[u8], now: u32) -> News {
        while let Some(event) = self.receiver.receive(bytes, now) {
            let news = self.take_in(event);
            if news != News::Nothing {
                return news;
            }
        }
        News::Nothing
    }

    /// Looks at the clock.
    pub fn tick(&mut self, now: u32) -> News {
        self.receiver.poll(now).map_or(News::Nothing, |event| self.take_in(event))
    }

    /// Prepares the next answer to the sender. `false` if there is none.
    pub fn next_answer(&mut self) -> bool {
        self.answer.clear();
        self.answer.extend_from_slice(self.receiver.answer().unwrap_or_default());
        !self.answer.is_empty()
    }

    /// The bytes of the answer.
    #[must_use]
    pub fn answer(&self) -> &[u8] {
        &self.answer
    }

    /// The frame's header.
    #[must_use]
    pub const fn header(&self) -> Option<FrameHeader> {
        self.header
    }

    /// The frame as pixels of a canvas. Rows that are missing show the frame before, half transparent.
    #[must_use]
    pub fn canvas(&self) -> &[u8] {
        &self.canvas
    }

    /// How many rows of the frame are here.
    #[must_use]
    pub const fn rows_received(&self) -> u16 {
        self.receiver.frame().rows_received()
    }

    /// How many frames were complete, and how many were not.
    #[must_use]
    pub const fn frames(&self) -> [u64; 2] {
        [self.complete, self.lost]
    }

    /// What has come over the line.
    #[must_use]
    pub const fn traffic(&self) -> &Traffic {
        self.receiver.traffic()
    }

    fn take_in(&mut self, event: Event) -> News {
        match event {
            Event::Started { header, lost } => {
                self.lost += u64::from(lost.is_some());
                self.begin(header);
                News::Started
            }
            Event::Rows { y, count } => {
                self.paint(y, count.into());
                News::Nothing
            }
            Event::Complete => {
                self.complete += 1;
                self.paint(0, u16::MAX);
                News::Complete
            }
            Event::Silent { .. } => News::Silent,
            _ => News::Nothing,
        }
    }

    fn begin(&mut self, header: FrameHeader) {
        let size = |header: FrameHeader| [header.width, header.height];
        if self.header.map(size) != Some(size(header)) {
            self.canvas.clear();
            self.canvas.resize(4 * usize::from(header.width) * usize::from(header.height), 0);
        }
        self.canvas.iter_mut().skip(3).step_by(4).for_each(|opacity| *opacity /= 2);
        self.header = Some(header);
    }

    fn paint(&mut self, y: u16, count: u16) {
        let Some(header) = self.header else { return };
        let rows = self.canvas.chunks_exact_mut(4 * usize::from(header.width));
        for (y, canvas) in (0..).zip(rows).skip(y.into()).take(count.into()) {
            if let Some(row) = self.receiver.frame().row(y) {
                to_canvas(header.format, row, canvas);
            }
        }
    }
}

impl Default for View {
    fn default() -> Self {
        Self::new()
    }
}

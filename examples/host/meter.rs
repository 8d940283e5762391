//! How the receiving goes, in figures.

use super::receive::Frame;
use scancsg::stream::{Assembler, Traffic};
use std::collections::VecDeque;
use std::time::{Duration, Instant};

/// The frame rate is the mean of so many frames.
const RATE_FRAMES: usize = 16;
/// After so many bytes without a packet, the line's speed is in question.
const SUSPICIOUS: u64 = 64;

/// Counts frames and times.
pub struct Meter {
    start: Instant,
    frames: u32,
    incomplete: u32,
    /// When the last ones were whole.
    times: VecDeque<Instant>,
    /// What the last one took, from its header on.
    took: Option<Duration>,
    /// The traffic when the last packet came.
    last: Traffic,
}

impl Meter {
    pub fn new() -> Self {
        Self {
            start: Instant::now(),
            frames: 0,
            incomplete: 0,
            times: VecDeque::new(),
            took: None,
            last: Traffic::default(),
        }
    }

    /// Whole frames so far.
    pub fn frames(&self) -> u32 {
        self.frames
    }

    /// Frames that were given up.
    pub fn incomplete(&self) -> u32 {
        self.incomplete
    }

    /// Counts a frame.
    pub fn count(&mut self, frame: &Frame) {
        if frame.problem().is_some() {
            self.incomplete += 1;
            return;
        }
        self.frames += 1;
        self.took = Some(frame.took);
        self.times.push_back(Instant::now());
        if self.times.len() > RATE_FRAMES + 1 {
            self.times.pop_front();
        }
    }

    /// Frames a second, from the second one on.
    fn rate(&self) -> Option<f64> {
        let (first, last) = (self.times.front()?, self.times.back()?);
        let seconds = last.duration_since(*first).as_secs_f64();
        (seconds > 0.0).then(|| (self.times.len() - 1) as f64 / seconds)
    }

    /// Whether bytes come that are no packets.
    pub fn is_garbage(&mut self, traffic: Traffic) -> bool {
        if traffic.packets != self.last.packets {
            self.last = traffic;
        }
        traffic.bytes - self.last.bytes >= SUSPICIOUS && traffic.bad_packets > self.last.bad_packets
    }

    /// Two lines: how far the frame is, and how it goes.
    pub fn lines(&self, picture: &Assembler<'_>, traffic: Traffic, of: Option<u32>) -> [String; 2] {
        let progress = match picture.header() {
            Some(header) => {
                let (here, all) =
                    (usize::from(picture.rows_received()), usize::from(header.height));
                let bar = "=".repeat(here * 24 / all.max(1));
                let number = self.frames + u32::from(!picture.is_complete());
                let number = of.map_or(number, |of| number.min(of));
                let of = of.map(|count| format!("/{count}")).unwrap_or_default();
                let size = format!("{}x{}", header.width, header.height);
                format!("frame {number}{of} [{bar:24}] {here}/{all} rows of {size}")
            }
            None => "no frame yet".into(),
        };
        let rate = self.rate().map(|rate| format!("{rate:.1} frames/s  ")).unwrap_or_default();
        let took = self.took.map(|took| format!("{} ms a frame  ", took.as_millis()));
        let incomplete = match self.incomplete {
            0 => String::new(),
            count => format!("  {count} incomplete"),
        };
        let figures = format!(
            "{rate}{}{}  {} damaged  {} asked again{incomplete}",
            took.unwrap_or_default(),
            bytes(traffic.bytes),
            traffic.bad_packets,
            traffic.requests,
        );
        [progress, figures]
    }

    /// How long it has been going.
    pub fn elapsed(&self) -> Duration {
        self.start.elapsed()
    }
}

/// A number of bytes for people.
fn bytes(count: u64) -> String {
    match count {
        0..10_000 => format!("{count} B"),
        10_000..10_000_000 => format!("{:.1} KB", count as f64 / 1e3),
        _ => format!("{:.1} MB", count as f64 / 1e6),
    }
}

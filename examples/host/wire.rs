//! A line that is slow, flips bits and breaks.

use super::port::{Heard, Port};
use scancsg::stream::faults::{Faults, Line};
use std::io::{self, ErrorKind};
use std::thread;
use std::time::{Duration, Instant};

/// Small pieces are written, so that a slow line is slow all the time and not packet by packet.
const PIECE: usize = 16;

/// The same faults in every run.
const SEED: u64 = 1;

/// What is wrong with a line.
#[derive(Debug, Clone, Copy, Default)]
pub struct Trouble {
    /// Bits per second, ten for a byte; as fast as it goes without.
    pub baud: Option<u32>,
    /// The share of bytes in which a bit is flipped.
    pub noise: f32,
    /// The line closes after so many bytes.
    pub cut_after: Option<u64>,
}

/// A port behind a line with faults.
pub struct Wire {
    port: Box<dyn Port>,
    trouble: Trouble,
    line: Line<PIECE>,
    /// What has come out of the line and waits for room in the port, and what went in for that.
    piece: Vec<u8>,
    taken: usize,
    free_at: Instant,
}

impl Wire {
    /// Puts a line between the writer and the port.
    pub fn new(port: Box<dyn Port>, trouble: Trouble) -> Self {
        let line = Line::new(Faults { flipped: trouble.noise, ..Faults::NONE }, SEED);
        Self { port, trouble, line, piece: Vec::new(), taken: 0, free_at: Instant::now() }
    }

    /// Brings the next piece through the line.
    fn carry(&mut self, bytes: &[u8]) -> io::Result<()> {
        let left =
            self.trouble.cut_after.map(|limit| limit.saturating_sub(self.line.counts().bytes));
        if left == Some(0) {
            // What is on the line arrives, though a pseudo-terminal that closes may throw away what
            // nobody has read yet.
            thread::sleep(Duration::from_millis(500));
            return Err(ErrorKind::BrokenPipe.into());
        }
        let most = left.and_then(|left| usize::try_from(left).ok()).unwrap_or(PIECE).min(PIECE);
        let bytes = bytes.get(..most).unwrap_or(bytes);
        for byte in bytes {
            self.line.push(*byte, 0);
            self.piece.extend(self.line.pop(0));
        }
        self.taken = bytes.len();
        if let Some(baud) = self.trouble.baud {
            let now = Instant::now();
            thread::sleep(self.free_at.saturating_duration_since(now));
            let busy = Duration::from_secs_f64(10.0 * bytes.len() as f64 / f64::from(baud));
            self.free_at = self.free_at.max(now) + busy;
        }
        Ok(())
    }
}

impl Port for Wire {
    fn read(&mut self, buffer: &mut [u8], wait: Duration) -> Heard {
        self.port.read(buffer, wait)
    }

    /// Takes in a piece. If there is no room for all of it, the same bytes are to be written again.
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.taken == 0 && !bytes.is_empty() {
            self.carry(bytes)?;
        }
        while !self.piece.is_empty() {
            let count = self.port.write(&self.piece)?;
            self.piece.drain(..count.min(self.piece.len()));
        }
        Ok(std::mem::take(&mut self.taken))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.port.flush()
    }
}

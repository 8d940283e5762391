//! A line that is slow, flips bits and breaks.

use super::port::{Heard, Port};
use std::io::{self, ErrorKind};
use std::thread;
use std::time::{Duration, Instant};

/// What a line does to the bytes that are written into it.
#[derive(Debug, Clone, Copy, Default)]
pub struct Faults {
    /// Bits per second, ten for a byte; as fast as it goes without.
    pub baud: Option<u32>,
    /// The share of bytes in which a bit is flipped.
    pub noise: f64,
    /// The line closes after so many bytes.
    pub cut_after: Option<u64>,
}

/// A port behind a line with faults.
pub struct Wire {
    port: Box<dyn Port>,
    faults: Faults,
    written: u64,
    free_at: Instant,
    random: u32,
}

impl Wire {
    /// Puts a line between the writer and the port.
    pub fn new(port: Box<dyn Port>, faults: Faults) -> Self {
        Self { port, faults, written: 0, free_at: Instant::now(), random: 0x2545_F491 }
    }

    /// Marsaglia's 32-bit xorshift: the same noise in every run.
    fn next_random(&mut self) -> u32 {
        self.random ^= self.random << 13;
        self.random ^= self.random >> 17;
        self.random ^= self.random << 5;
        self.random
    }
}

impl Port for Wire {
    fn read(&mut self, buffer: &mut [u8], wait: Duration) -> Heard {
        self.port.read(buffer, wait)
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        // Small pieces, so that a slow line is slow all the time and not packet by packet.
        let mut piece: Vec<u8> = bytes.iter().take(16).copied().collect();
        if let Some(limit) = self.faults.cut_after {
            let left = usize::try_from(limit - self.written.min(limit)).unwrap_or(usize::MAX);
            piece.truncate(left);
            if piece.is_empty() && !bytes.is_empty() {
                // What is on the line arrives, though a pseudo-terminal that closes may throw away what
                // nobody has read yet.
                thread::sleep(Duration::from_millis(500));
                return Err(ErrorKind::BrokenPipe.into());
            }
        }
        if self.faults.noise > 0.0 {
            for byte in &mut piece {
                let (chance, bit) = (self.next_random(), self.next_random());
                if f64::from(chance) < self.faults.noise * f64::from(u32::MAX) {
                    *byte ^= 1 << (bit >> 29);
                }
            }
        }
        if let Some(baud) = self.faults.baud {
            let now = Instant::now();
            thread::sleep(self.free_at.saturating_duration_since(now));
            let busy = Duration::from_secs_f64(10.0 * piece.len() as f64 / f64::from(baud));
            self.free_at = self.free_at.max(now) + busy;
        }
        let count = self.port.write(&piece)?;
        self.written += count as u64;
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.port.flush()
    }
}

//! The sending end of a line, on a host: what `serve` writes to, reads from and looks at for the time.

use crate::host::port::{Heard, Port, write_all};
use crate::host::wire::Wire;
use scancsg::stream::{Clock, Patience};
use std::cell::RefCell;
use std::collections::VecDeque;
use std::io::{self, ErrorKind};
use std::time::{Duration, Instant};

/// So many milliseconds for an answer, three times.
pub const fn patience(milliseconds: u32) -> Patience {
    Patience { ticks: milliseconds, silences: 3 }
}

/// On a line without a way back.
pub const ONE_WAY: Patience = Patience { ticks: 0, silences: 0 };

/// So long is waited for somebody who takes no bytes.
const STUCK: Duration = Duration::from_secs(5);

/// The longest time without a look at the clock.
const IDLE: u32 = 100;

/// A line and its clock: `serve` gets it twice.
pub struct Line {
    state: RefCell<State>,
    start: Instant,
}

struct State {
    wire: Wire,
    /// Bytes that have been read while waiting.
    ahead: VecDeque<u8>,
    is_closed: bool,
}

impl Line {
    pub fn new(wire: Wire) -> Self {
        let state = State { wire, ahead: VecDeque::new(), is_closed: false };
        Self { state: RefCell::new(state), start: Instant::now() }
    }
}

impl State {
    /// Waits so long for a byte.
    fn listen(&mut self, wait: Duration) {
        let mut buffer = [0; 256];
        match self.wire.read(&mut buffer, wait) {
            Heard::Bytes(count) => self.ahead.extend(buffer.iter().take(count)),
            Heard::Silence => {}
            Heard::Closed => self.is_closed = true,
        }
    }
}

impl embedded_io::ErrorType for &Line {
    type Error = io::Error;
}

impl embedded_io::Write for &Line {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let result = write_all(&mut self.state.borrow_mut().wire, bytes, STUCK);
        result.map(|()| bytes.len()).map_err(|error| match error.kind() {
            ErrorKind::TimedOut => io::Error::new(error.kind(), "nobody reads at the other end"),
            _ => error,
        })
    }

    fn flush(&mut self) -> io::Result<()> {
        self.state.borrow_mut().wire.flush()
    }
}

impl embedded_io::ReadReady for &Line {
    fn read_ready(&mut self) -> io::Result<bool> {
        let mut state = self.state.borrow_mut();
        if state.ahead.is_empty() {
            state.listen(Duration::ZERO);
        }
        match state.ahead.is_empty() {
            true if state.is_closed => {
                Err(io::Error::new(ErrorKind::BrokenPipe, "the line is closed at its other end"))
            }
            is_empty => Ok(!is_empty),
        }
    }
}

impl embedded_io::Read for &Line {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        while !embedded_io::ReadReady::read_ready(self)? {
            self.idle(IDLE);
        }
        let ahead = &mut self.state.borrow_mut().ahead;
        let count = bytes.len().min(ahead.len());
        bytes.iter_mut().zip(ahead.drain(..count)).for_each(|(place, byte)| *place = byte);
        Ok(count)
    }
}

impl Clock for &Line {
    fn now(&mut self) -> u32 {
        self.start.elapsed().as_millis() as u32
    }

    /// Until a byte comes, or for so long.
    fn idle(&mut self, ticks: u32) {
        let mut state = self.state.borrow_mut();
        if state.ahead.is_empty() {
            state.listen(Duration::from_millis(ticks.clamp(1, IDLE).into()));
        }
    }
}

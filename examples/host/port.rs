//! Serial ports of a host, and the loopback that stands in for one.

use std::io::{self, ErrorKind, Read, Write};
use std::thread;
use std::time::{Duration, Instant};

/// How long a read waits.
pub const READ_TIMEOUT: Duration = Duration::from_millis(100);

/// One end of a line.
pub trait Port: Read + Write + Send {}
impl<T: Read + Write + Send + ?Sized> Port for T {}

/// Two connected ends of a line.
pub type Ends = (Box<dyn Port>, Box<dyn Port>);

/// What a read brought.
pub enum Heard {
    /// So many bytes.
    Bytes(usize),
    /// Nothing yet.
    Silence,
    /// The other end is gone.
    Closed,
}

/// Reads what is there, waiting for [`READ_TIMEOUT`] at most.
pub fn listen(port: &mut dyn Port, buffer: &mut [u8]) -> Heard {
    match port.read(buffer) {
        Ok(0) => Heard::Closed,
        Ok(count) => Heard::Bytes(count),
        Err(error) => match error.kind() {
            ErrorKind::TimedOut | ErrorKind::WouldBlock | ErrorKind::Interrupted => Heard::Silence,
            // A pseudo-terminal whose other end is closed gives an input/output error.
            _ => Heard::Closed,
        },
    }
}

/// Opens a serial device: 8 data bits, no parity, one stop bit, no flow control.
pub fn open(device: &str, baud: u32) -> Result<Box<dyn Port>, String> {
    let port = serialport::new(device, baud)
        .timeout(READ_TIMEOUT)
        .open()
        .map_err(|error| format!("can't open the serial device {device}: {error}"))?;
    Ok(Box::new(port))
}

/// Two connected ends: a pseudo-terminal pair, which is a real serial device to both.
#[cfg(unix)]
pub fn loopback() -> Result<Ends, String> {
    use serialport::SerialPort;
    let (mut host, mut device) = serialport::TTYPort::pair()
        .map_err(|error| format!("can't make a pseudo-terminal: {error}"))?;
    for end in [&mut host, &mut device] {
        end.set_timeout(READ_TIMEOUT).map_err(|error| error.to_string())?;
    }
    Ok((Box::new(host), Box::new(device)))
}

/// Two connected ends: a pipe each way, where there are no pseudo-terminals.
#[cfg(not(unix))]
pub fn loopback() -> Result<Ends, String> {
    let pipe = || io::pipe().map_err(|error| format!("can't make a pipe: {error}"));
    let ((to_host, from_device), (to_device, from_host)) = (pipe()?, pipe()?);
    Ok((Box::new(Pipes::new(to_host, from_host)), Box::new(Pipes::new(to_device, from_device))))
}

/// Reads one pipe in a thread, so that reads can time out, and writes another.
#[cfg(not(unix))]
struct Pipes {
    incoming: std::sync::mpsc::Receiver<u8>,
    outgoing: io::PipeWriter,
}

#[cfg(not(unix))]
impl Pipes {
    fn new(mut reader: io::PipeReader, outgoing: io::PipeWriter) -> Self {
        let (sender, incoming) = std::sync::mpsc::channel();
        thread::spawn(move || {
            let mut buffer = [0; 1024];
            while let Ok(count @ 1..) = reader.read(&mut buffer) {
                if buffer.iter().take(count).any(|byte| sender.send(*byte).is_err()) {
                    return;
                }
            }
        });
        Self { incoming, outgoing }
    }
}

#[cfg(not(unix))]
impl Read for Pipes {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        use std::sync::mpsc::RecvTimeoutError;
        let first = match self.incoming.recv_timeout(READ_TIMEOUT) {
            Ok(byte) => byte,
            Err(RecvTimeoutError::Timeout) => return Err(ErrorKind::TimedOut.into()),
            Err(RecvTimeoutError::Disconnected) => return Ok(0),
        };
        let bytes = std::iter::once(first).chain(self.incoming.try_iter());
        Ok(buffer.iter_mut().zip(bytes).map(|(place, byte)| *place = byte).count())
    }
}

#[cfg(not(unix))]
impl Write for Pipes {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.outgoing.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.outgoing.flush()
    }
}

/// What a line does to the bytes that are written into it.
#[derive(Debug, Clone, Copy, Default)]
pub struct Faults {
    /// Bits per second, ten for a byte; as fast as it goes without.
    pub baud: Option<u32>,
    /// One bit is flipped in about every so many bytes.
    pub noise: Option<u32>,
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

impl Read for Wire {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.port.read(buffer)
    }
}

impl Write for Wire {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        // Small pieces, so that a slow line is slow all the time and not packet by packet.
        let mut piece: Vec<u8> = bytes.iter().take(16).copied().collect();
        if let Some(limit) = self.faults.cut_after {
            let left = usize::try_from(limit - self.written.min(limit)).unwrap_or(usize::MAX);
            piece.truncate(left);
            if piece.is_empty() && !bytes.is_empty() {
                // What is on the line arrives, though a pseudo-terminal that closes may throw away what
                // nobody has read yet.
                thread::sleep(5 * READ_TIMEOUT);
                return Err(ErrorKind::BrokenPipe.into());
            }
        }
        let count = piece.len();
        if let Some(every) = self.faults.noise {
            for byte in &mut piece {
                let random = self.next_random();
                if random.is_multiple_of(every) {
                    *byte ^= 1 << (random >> 29);
                }
            }
        }
        if let Some(baud) = self.faults.baud {
            let now = Instant::now();
            thread::sleep(self.free_at.saturating_duration_since(now));
            let busy = Duration::from_secs_f64(10.0 * count as f64 / f64::from(baud));
            self.free_at = self.free_at.max(now) + busy;
        }
        // A full line is no failure: the reader is slow.
        let mut rest = piece.as_slice();
        while !rest.is_empty() {
            match self.port.write(rest) {
                Ok(0) => return Err(ErrorKind::WriteZero.into()),
                Ok(done) => rest = rest.get(done..).unwrap_or_default(),
                Err(error) => match error.kind() {
                    ErrorKind::TimedOut | ErrorKind::WouldBlock | ErrorKind::Interrupted => {}
                    _ => return Err(error),
                },
            }
        }
        self.written += count as u64;
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.port.flush()
    }
}

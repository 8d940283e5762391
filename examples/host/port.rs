//! Serial ports of a host, and the loopback that stands in for one.

use std::io::{self, ErrorKind, Read, Write};
use std::time::{Duration, Instant};

/// How long one write waits for room on the line.
const WRITE_WAIT: Duration = Duration::from_millis(100);

/// So many bytes are written at a time: on a line with less room than that, a write would wait for ever.
const PIECE: usize = 64;

/// One end of a line.
pub trait Port: Send {
    /// Reads what is there, and waits so long for the first byte.
    fn read(&mut self, buffer: &mut [u8], wait: Duration) -> Heard;

    /// Writes at least one byte. It waits for a tenth of a second at most: `TimedOut` if the line is full.
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize>;

    /// Waits until all bytes have left.
    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Two connected ends of a line.
pub type Ends = (Box<dyn Port>, Box<dyn Port>);

/// What a read brought.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Heard {
    /// So many bytes.
    Bytes(usize),
    /// Nothing yet.
    Silence,
    /// The other end is gone.
    Closed,
}

impl Heard {
    /// What a blocking read with a time limit says.
    fn of(result: io::Result<usize>) -> Self {
        match result {
            Ok(0) => Self::Closed,
            Ok(count) => Self::Bytes(count),
            Err(error) if is_wait(&error) => Self::Silence,
            // A pseudo-terminal whose other end is closed gives an input/output error.
            Err(_) => Self::Closed,
        }
    }
}

/// Whether an error only says that nothing has happened yet.
pub fn is_wait(error: &io::Error) -> bool {
    matches!(error.kind(), ErrorKind::TimedOut | ErrorKind::WouldBlock | ErrorKind::Interrupted)
}

impl<P: Port + ?Sized> Port for Box<P> {
    fn read(&mut self, buffer: &mut [u8], wait: Duration) -> Heard {
        (**self).read(buffer, wait)
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        (**self).write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        (**self).flush()
    }
}

/// Writes all of the bytes. `TimedOut` if nobody takes any for so long.
pub fn write_all(port: &mut impl Port, mut bytes: &[u8], patience: Duration) -> io::Result<()> {
    let mut since = Instant::now();
    while !bytes.is_empty() {
        match port.write(bytes) {
            Ok(0) => return Err(ErrorKind::WriteZero.into()),
            Ok(count) => {
                bytes = bytes.get(count..).unwrap_or_default();
                since = Instant::now();
            }
            Err(error) if is_wait(&error) && since.elapsed() < patience => {}
            Err(error) => return Err(error),
        }
    }
    Ok(())
}

/// A serial device.
struct Serial(Box<dyn serialport::SerialPort>);

impl Port for Serial {
    fn read(&mut self, buffer: &mut [u8], wait: Duration) -> Heard {
        match self.0.set_timeout(wait) {
            Ok(()) => Heard::of(self.0.read(buffer)),
            Err(_) => Heard::Closed,
        }
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.set_timeout(WRITE_WAIT)?;
        self.0.write(bytes.get(..PIECE).unwrap_or(bytes))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

/// Opens a serial device: 8 data bits, no parity, one stop bit, no flow control.
pub fn open(device: &str, baud: u32) -> Result<Box<dyn Port>, String> {
    let port = serialport::new(device, baud)
        .timeout(WRITE_WAIT)
        .open()
        .map_err(|error| format!("can't open the serial device {device}: {error}"))?;
    Ok(Box::new(Serial(port)))
}

/// Two connected ends: a pseudo-terminal pair, which is a real serial device to both.
#[cfg(unix)]
pub fn loopback() -> Result<Ends, String> {
    let (host, device) = serialport::TTYPort::pair()
        .map_err(|error| format!("can't make a pseudo-terminal: {error}"))?;
    Ok((Box::new(Serial(Box::new(host))), Box::new(Serial(Box::new(device)))))
}

/// An emulator's serial line.
#[cfg(unix)]
impl Port for std::os::unix::net::UnixStream {
    fn read(&mut self, buffer: &mut [u8], wait: Duration) -> Heard {
        match self.set_read_timeout(Some(wait.max(Duration::from_millis(1)))) {
            Ok(()) => Heard::of(Read::read(self, buffer)),
            Err(_) => Heard::Closed,
        }
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.set_write_timeout(Some(WRITE_WAIT))?;
        Write::write(self, bytes)
    }
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
        std::thread::spawn(move || {
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
impl Port for Pipes {
    fn read(&mut self, buffer: &mut [u8], wait: Duration) -> Heard {
        use std::sync::mpsc::RecvTimeoutError;
        let first = match self.incoming.recv_timeout(wait) {
            Ok(byte) => byte,
            Err(RecvTimeoutError::Timeout) => return Heard::Silence,
            Err(RecvTimeoutError::Disconnected) => return Heard::Closed,
        };
        let bytes = std::iter::once(first).chain(self.incoming.try_iter());
        Heard::Bytes(buffer.iter_mut().zip(bytes).map(|(place, byte)| *place = byte).count())
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.outgoing.write(bytes)
    }
}

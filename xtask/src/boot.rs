//! Boots firmware in an emulator, with a socket for its serial port.

use crate::board::{Board, Number};
use crate::host::film::Film;
use crate::host::meter::Meter;
use crate::host::receive::{Ending, Frame, Room, Session, timing};
use crate::host::screen::Screen;
use crate::scene::{Scene, Tee};
use scancsg::geom::OrthographicRays;
use scancsg::render::{Gray8, Lambert, Picture, Size};
use scancsg::scalar::I16F16;
use scancsg::solid::Scan;
use scancsg::stream::Traffic;
use std::io::Read;
use std::os::unix::net::UnixStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};
use std::thread;
use std::time::{Duration, Instant};

/// How long a frame may take to begin.
const PATIENCE: Duration = Duration::from_secs(60);

/// An emulated board that runs.
pub struct Machine {
    emulator: Child,
    elf: PathBuf,
    socket: PathBuf,
    /// Read until the emulator ends.
    console: Option<thread::JoinHandle<Vec<u8>>>,
    log: Option<thread::JoinHandle<Vec<u8>>>,
}

impl Machine {
    /// Starts a firmware; it waits for the other end of its serial line.
    pub fn start(board: Board, elf: &Path) -> Result<(Self, UnixStream), String> {
        static COUNT: AtomicU32 = AtomicU32::new(0);
        let count = COUNT.fetch_add(1, Ordering::Relaxed);
        let name = format!("scancsg-{}-{count}.socket", std::process::id());
        let socket = std::env::temp_dir().join(name);
        let (program, machine) = board.machine();
        let serial = format!("unix:{},server=on,wait=on", socket.display());
        let mut command = Command::new(program);
        command
            .args(machine)
            .args(["-display", "none", "-monitor", "none", "-serial", &serial])
            .args(["-icount", "shift=7,align=off,sleep=off"])
            .args(["-semihosting-config", "enable=on,target=native", "-kernel"])
            .arg(elf)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        let mut emulator = command.spawn().map_err(|error| {
            format!(
                "can't start {program}: {error}. On Debian: apt-get install \
                 --no-install-recommends qemu-system-arm qemu-system-misc"
            )
        })?;
        let (console, log) = (emulator.stderr.take().map(read), emulator.stdout.take().map(read));
        let mut machine = Self { emulator, elf: elf.to_owned(), socket, console, log };
        let line = machine.connect()?;
        Ok((machine, line))
    }

    fn connect(&mut self) -> Result<UnixStream, String> {
        let deadline = Instant::now() + Duration::from_secs(20);
        loop {
            match UnixStream::connect(&self.socket) {
                Ok(line) => return Ok(line),
                Err(error) if Instant::now() > deadline => {
                    return Err(format!("the emulator opens no serial line: {error}"));
                }
                Err(_) => {
                    if let Ok(Some(status)) = self.emulator.try_wait() {
                        return Err(format!("the emulator ended: {status}\n{}", self.said()));
                    }
                    thread::sleep(Duration::from_millis(10));
                }
            }
        }
    }

    /// What the firmware has logged, and what it has said to the console.
    fn said(&mut self) -> String {
        let all = |stream: Option<thread::JoinHandle<Vec<u8>>>| {
            stream.and_then(|stream| stream.join().ok()).unwrap_or_default()
        };
        let (log, console) = (all(self.log.take()), all(self.console.take()));
        let log = match std::fs::read(&self.elf) {
            Ok(elf) if !log.is_empty() => crate::decode::decode(&elf, &log)
                .unwrap_or_else(|error| format!("the log can't be decoded: {error}\n")),
            _ => String::new(),
        };
        String::from_utf8_lossy(&console)
            .lines()
            // The emulator's own word that it waits for the other end of the line.
            .filter(|line| !line.contains("QEMU waiting"))
            .fold(log, |all, line| all + line + "\n")
    }

    /// Waits for the firmware to end; what it said, and whether it was content.
    pub fn finish(self, patience: Duration) -> (String, bool) {
        self.finish_after(patience, || thread::sleep(Duration::from_millis(10)))
    }

    /// As [`finish`](Self::finish), while its frames are received: a board that heard the
    /// acknowledgement of the first one too late sends a second.
    pub fn finish_receiving(self, patience: Duration, session: &mut Session<'_>) -> (String, bool) {
        self.finish_after(patience, || {
            let _ = session.frame(Duration::from_millis(300), |_| {});
        })
    }

    fn finish_after(mut self, patience: Duration, mut meanwhile: impl FnMut()) -> (String, bool) {
        let deadline = Instant::now() + patience;
        let is_good = loop {
            match self.emulator.try_wait() {
                Ok(Some(status)) => break status.success(),
                Ok(None) if Instant::now() < deadline => meanwhile(),
                _ => break false,
            }
        };
        let _ = self.emulator.kill();
        (self.said(), is_good)
    }
}

/// Reads to the end, meanwhile.
fn read(mut stream: impl Read + Send + 'static) -> thread::JoinHandle<Vec<u8>> {
    thread::spawn(move || {
        let mut bytes = Vec::new();
        let _ = stream.read_to_end(&mut bytes);
        bytes
    })
}

impl Drop for Machine {
    fn drop(&mut self) {
        let _ = self.emulator.kill();
        let _ = self.emulator.wait();
        let _ = std::fs::remove_file(&self.socket);
    }
}

/// What a firmware sent and said.
pub struct Outcome {
    pub frame: Frame,
    pub traffic: Traffic,
    pub said: String,
    /// The deepest that the stack has been.
    pub stack: Option<u32>,
    pub is_same_as_host: bool,
    pub problems: Vec<String>,
}

fn receive(
    board: Board,
    elf: &Path,
    is_shown: bool,
) -> Result<(Frame, Traffic, String, bool), String> {
    let (machine, line) = Machine::start(board, elf)?;
    let mut room = Room::new();
    let mut session: Session<'_> = Session::new(Box::new(line), &mut room, timing(None));
    let (mut screen, meter) = (Screen::new(), Meter::new());
    let frame = session.frame(PATIENCE, |session| {
        if is_shown && screen.is_due() {
            let figures = meter.lines(session.picture(), session.traffic(), None);
            screen.draw(session.picture(), &figures);
        }
    });
    let traffic = session.traffic();
    let (said, is_good) = machine.finish_receiving(Duration::from_secs(60), &mut session);
    let frame = frame.ok_or_else(|| format!("{board} sent no frame\n{said}"))?;
    Ok((frame, traffic, said, is_good))
}

/// Boots the example `stream`, and compares its picture with the host's.
pub fn stream(board: Board, number: Number, elf: &Path) -> Result<Outcome, String> {
    let (frame, traffic, said, is_good) = receive(board, elf, false)?;
    let mut problems: Vec<String> = frame.problem().into_iter().collect();
    if !is_good {
        problems.push(format!("the firmware was not content: {}", said.trim()));
    }
    let size =
        Size::new(frame.header.width, frame.header.height).map_err(|error| error.to_string())?;
    let want = match number {
        Number::F32 => on_host::<f32>(size)?,
        Number::I16f16 => on_host::<I16F16>(size)?,
    };
    let width = usize::from(size.width());
    let crc = crc::Crc::<u32>::new(&crc::CRC_32_ISO_HDLC);
    let differing = frame
        .pixels
        .chunks(width)
        .zip(want.chunks(width))
        .filter(|(got, want)| crc.checksum(got) != crc.checksum(want))
        .count();
    let is_same_as_host = differing == 0 && frame.pixels.len() == want.len();
    if !is_same_as_host {
        problems.push(format!("{differing} rows differ from the host's"));
    }
    let stack = said
        .lines()
        .find_map(|line| line.strip_prefix("stack ")?.split_whitespace().next()?.parse().ok());
    Ok(Outcome { frame, traffic, said, stack, is_same_as_host, problems })
}

/// The frame of the example `stream`, rendered here.
fn on_host<S: Scene>(size: Size) -> Result<Vec<u8>, String>
where
    Tee<S>: Scan<OrthographicRays<S>, Scalar = S>,
{
    let text = |error: &dyn std::fmt::Display| error.to_string();
    let camera = S::orthographic().map_err(|error| text(&error))?;
    let light = Lambert::new(S::TO_LIGHT, S::hundredths(15)).map_err(|error| text(&error))?;
    let tee = S::TEE;
    let mut picture = Picture::new(&tee, &camera, size, light, Gray8(0));
    let mut row = vec![Gray8(0); usize::from(size.width())];
    let mut bytes = Vec::new();
    for y in 0..size.height() {
        let scanline = picture.scanline(y);
        scanline.and_then(|mut row_of| row_of.render(&mut row)).map_err(|error| text(&error))?;
        bytes.extend(row.iter().map(|pixel| pixel.0));
    }
    Ok(bytes)
}

/// Boots a firmware, shows the picture that it sends, and saves it.
pub fn show(board: Board, elf: &Path, png: &Path) -> Result<(), String> {
    let (frame, traffic, said, is_good) = receive(board, elf, true)?;
    Film::new(png).push(&frame)?;
    println!("{}: {} bytes on the line; the board says\n{said}", png.display(), traffic.bytes);
    if let Some(problem) = frame.problem() {
        return Err(problem);
    }
    if is_good && frame.ending == Ending::Complete {
        Ok(())
    } else {
        Err("the firmware failed".into())
    }
}

/// Boots a firmware that only speaks, and returns what it says.
pub fn listen(board: Board, elf: &Path) -> Result<String, String> {
    let (machine, _line) = Machine::start(board, elf)?;
    match machine.finish(Duration::from_secs(120)) {
        (said, true) => Ok(said),
        (said, false) => Err(format!("{board}: the firmware failed, and said: {}", said.trim())),
    }
}

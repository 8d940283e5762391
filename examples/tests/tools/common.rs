//! What the tests of the tools share: running them, and their files.

#![cfg(unix)]

use rustix::fs::{OFlags, fcntl_setfl};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use std::fs::{self, File};
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::{Duration, Instant};

/// No tool takes so long: it hangs.
const HANGS: Duration = Duration::from_secs(120);

/// How many lines there have been.
static LINES: AtomicU32 = AtomicU32::new(0);

/// An example's binary, which `cargo test` builds beside the tests.
pub fn example(name: &str) -> Command {
    let test = std::env::current_exe().unwrap();
    let path = test.parent().and_then(Path::parent).unwrap().join("examples").join(name);
    assert!(path.exists(), "{} is missing: run `cargo build --examples`", path.display());
    Command::new(path)
}

/// The device's end of a serial line: a pseudo-terminal, whose other end a tool opens by its name.
///
/// The name is a link of this line's own. The system gives a terminal's number to the next test as soon as it is
/// free: a tool that looks for a device that has vanished would find another test's.
pub struct Pty {
    port: File,
    pub name: String,
}

impl Drop for Pty {
    fn drop(&mut self) {
        // Before the terminal is closed.
        let _ = fs::remove_file(&self.name);
    }
}

impl Pty {
    pub fn new() -> Self {
        let port = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY | OpenptFlags::CLOEXEC).unwrap();
        grantpt(&port).unwrap();
        unlockpt(&port).unwrap();
        let terminal = ptsname(&port, Vec::new()).unwrap().into_string().unwrap();
        let line = LINES.fetch_add(1, Ordering::Relaxed);
        let link = scratch(&format!("line-{}-{line}", std::process::id()));
        std::os::unix::fs::symlink(terminal, &link).unwrap();
        let name = link.to_str().unwrap().to_owned();
        fcntl_setfl(&port, OFlags::RDWR | OFlags::NONBLOCK).unwrap();
        Self { port: port.into(), name }
    }

    /// What comes within some milliseconds.
    pub fn read(&mut self) -> Vec<u8> {
        let mut buffer = [0; 512];
        for _ in 0..10 {
            // While nobody has opened the other end, this is an error.
            if let Ok(count @ 1..) = self.port.read(&mut buffer) {
                return buffer.get(..count).unwrap().to_vec();
            }
            std::thread::sleep(Duration::from_millis(2));
        }
        Vec::new()
    }

    /// Writes all bytes, as long as the tool runs.
    pub fn write(&mut self, tool: &mut Guarded, mut bytes: &[u8]) {
        let start = Instant::now();
        while !bytes.is_empty() && tool.is_running() {
            assert!(start.elapsed() < HANGS, "nobody reads");
            match self.port.write(bytes) {
                Ok(count) => bytes = bytes.get(count..).unwrap(),
                Err(_) => std::thread::sleep(Duration::from_millis(2)),
            }
        }
    }
}

/// A tool that runs, and doesn't outlive its test.
pub struct Guarded(Option<Child>);

impl Guarded {
    pub fn spawn(command: &mut Command) -> Self {
        let command = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        Self(Some(command.spawn().unwrap()))
    }

    pub fn child(&mut self) -> &mut Child {
        self.0.as_mut().unwrap()
    }

    pub fn is_running(&mut self) -> bool {
        self.child().try_wait().unwrap().is_none()
    }

    /// As ctrl-C does.
    pub fn interrupt(&mut self) {
        let id = self.child().id().to_string();
        assert!(Command::new("kill").args(["-INT", &id]).status().unwrap().success());
    }

    /// Waits for its end.
    pub fn end(mut self) -> Output {
        let start = Instant::now();
        while self.is_running() {
            assert!(start.elapsed() < HANGS, "it hangs");
            std::thread::sleep(Duration::from_millis(5));
        }
        self.0.take().unwrap().wait_with_output().unwrap()
    }
}

impl Drop for Guarded {
    fn drop(&mut self) {
        if let Some(child) = &mut self.0 {
            let _ = child.kill();
            let _ = child.wait();
        }
    }
}

/// Does the same to several cases, which mostly wait, at once.
pub fn at_once<T: Send>(cases: impl IntoIterator<Item = T>, check: impl Fn(T) + Copy + Send) {
    std::thread::scope(|scope| {
        cases.into_iter().for_each(|case| drop(scope.spawn(move || check(case))));
    });
}

/// A file of this test's own.
pub fn scratch(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name)
}

pub struct Png {
    pub width: u32,
    pub height: u32,
    pub color: png::ColorType,
    pub frames: u32,
    pub pixels: Vec<u8>,
}

pub fn read_png(path: &Path) -> Png {
    let file = std::io::BufReader::new(std::fs::File::open(path).unwrap());
    let mut reader = png::Decoder::new(file).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    pixels.truncate(info.buffer_size());
    let frames = reader.info().animation_control.map_or(1, |animation| animation.num_frames);
    Png { width: info.width, height: info.height, color: info.color_type, frames, pixels }
}

//! Receives until there is enough, and says how it went.

use crate::args::Args;
use crate::host::meter::Meter;
use crate::host::port;
use crate::host::receive::{Ending, Frame, News, Room, Session, timing};
use crate::host::screen::Screen;
use crate::host::send;
use crate::ports;
use crate::replay::Replay;
use crate::save::Saver;
use crate::serve::Server;
use crate::tap::Tap;
use clap::Parser;
use scancsg::stream::{PROTOCOL_VERSION, PacketError, Timing};
use std::fs;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

const INCOMPLETE: u8 = 3;
const NO_FRAME: u8 = 4;
/// What a shell calls a program that ctrl-C has ended.
const INTERRUPTED: i32 = 130;

/// Where so many frames are wanted, this is waited for rows.
const WAIT: u32 = 30;
/// Where whole frames are wanted, so many in a row that are not are too many.
const GIVE_UP: u32 = 10;
/// A device that has vanished is looked for this often.
const LOOK_AGAIN: Duration = Duration::from_millis(200);
/// So long the last frame is acknowledged again, if its end is repeated.
const LINGER: Duration = Duration::from_millis(400);
/// So long there are bytes and no packets until that is said.
const GARBAGE: Duration = Duration::from_secs(1);

pub fn run() -> ExitCode {
    let mut args = Args::parse();
    if args.send.is_some() {
        args.frames = Some(1);
    }
    if args.list {
        return match ports::list() {
            Ok(ports) => {
                ports.iter().for_each(|port| println!("{port}"));
                ExitCode::SUCCESS
            }
            Err(message) => fail(&message),
        };
    }
    receive(&args).unwrap_or_else(|message| fail(&message))
}

fn fail(message: &str) -> ExitCode {
    eprintln!("view: {message}");
    ExitCode::FAILURE
}

/// Whether ctrl-C was pressed. The second one ends the program at once.
fn interruption() -> Result<Arc<AtomicBool>, String> {
    let flag = Arc::new(AtomicBool::new(false));
    let pressed = Arc::clone(&flag);
    let handler = move || {
        if pressed.swap(true, Ordering::Relaxed) {
            std::process::exit(INTERRUPTED);
        }
    };
    ctrlc::set_handler(handler).map_err(|error| format!("can't listen to ctrl-C: {error}"))?;
    Ok(flag)
}

/// Why there is an end.
#[derive(Clone, Copy, PartialEq, Eq)]
enum End {
    /// There are as many frames as were wanted.
    Enough,
    /// Ctrl-C.
    Interrupted,
    /// The recording is over.
    Replayed,
    /// Nothing has come for too long.
    Silence,
    /// Too many frames were not whole.
    Damaged,
}

/// With `--wait`, a frame is given up after a third of it, but not before its missing rows were asked for twice.
fn patient(timing: Timing, wait: Option<u32>) -> Timing {
    let third = wait.map_or(timing.give_up, |seconds| seconds.saturating_mul(1000) / 3);
    Timing { give_up: timing.give_up.min(third.max(2 * timing.ask)), ..timing }
}

/// All that goes on while frames are received.
struct Run<'a> {
    args: &'a Args,
    /// The device, if it isn't a recording.
    device: Option<String>,
    session: Session<'a, Tap>,
    /// What is sent to the device, and how often it was.
    part: Option<Vec<u8>>,
    sent: u8,
    saver: Saver,
    meter: Meter,
    screen: Screen,
    is_interrupted: Arc<AtomicBool>,
    /// When rows came last.
    progress: Instant,
    /// Frames in a row that were not whole, and the last one.
    damaged: u32,
    unfinished: Option<Frame>,
    /// Since when nothing but garbage comes.
    garbage: Option<Instant>,
    has_said_refused: bool,
    has_said_garbage: bool,
}

fn receive(args: &Args) -> Result<ExitCode, String> {
    if let (Some(record), Some(replay)) = (&args.record, &args.replay)
        && replay
            .canonicalize()
            .is_ok_and(|replay| record.canonicalize().is_ok_and(|to| to == replay))
    {
        return Err(format!("{} can't be replayed and recorded at once", replay.display()));
    }
    let read = |path: &PathBuf| {
        fs::read(path).map_err(|error| format!("can't read {}: {error}", path.display()))
    };
    let part = args.send.as_ref().map(read).transpose()?;
    let is_interrupted = interruption()?;
    let device = match (&args.port, &args.replay) {
        (Some(device), _) => Some(device.clone()),
        (None, None) => Some(ports::only()?),
        (None, Some(_)) => None,
    };
    let line = match (&device, &args.replay) {
        (Some(device), _) => port::open(device, args.baud)?,
        (None, Some(path)) => Box::new(Replay::open(path)?),
        (None, None) => return Err("there is nothing to receive from".into()),
    };
    let mut screen = Screen::new();
    if let Some(device) = device.as_ref().filter(|_| args.port.is_none()) {
        screen.note(&format!("listening to {device} at {} baud", args.baud));
    }
    let server = args.serve.map(Server::start).transpose()?;
    if let Some(server) = &server {
        screen.note(&format!("serving ws://{}", server.address()));
    }
    let mut tap = Tap::new(line, server);
    if let Some(path) = &args.record {
        tap.record(path)?;
    }
    let saver = Saver::new(args)?;
    let mut room = Room::new();
    let mut run = Run {
        args,
        device,
        session: Session::new(tap, &mut room, patient(timing(Some(args.baud)), args.wait)),
        part,
        sent: 0,
        saver,
        meter: Meter::new(),
        screen,
        is_interrupted,
        progress: Instant::now(),
        damaged: 0,
        unfinished: None,
        garbage: None,
        has_said_refused: false,
        has_said_garbage: false,
    };
    run.send()?;
    let end = run.frames()?;
    run.finish(end)
}

impl Run<'_> {
    /// Sends the part, if there is one.
    fn send(&mut self) -> Result<(), String> {
        let Some(part) = &self.part else { return Ok(()) };
        self.sent += 1;
        self.screen.note(&format!("sending {} bytes", part.len()));
        let go_on = |_| !self.is_interrupted.load(Ordering::Relaxed);
        send::send(&mut self.session, part, Some(self.args.baud), go_on)?;
        self.progress = Instant::now();
        Ok(())
    }

    fn frames(&mut self) -> Result<End, String> {
        loop {
            if self.is_interrupted.load(Ordering::Relaxed) {
                return Ok(End::Interrupted);
            }
            let news = self.session.listen();
            if self.session.traffic().last_error == Some(PacketError::Version) {
                return Err(format!(
                    "the sender speaks another version of the protocol than {PROTOCOL_VERSION}"
                ));
            }
            match news {
                News::Begun | News::Rows => self.progress = Instant::now(),
                News::Frame(frame) => {
                    if let Some(end) = self.take(frame)? {
                        return Ok(end);
                    }
                }
                News::Refused(error) if !self.has_said_refused => {
                    self.has_said_refused = true;
                    self.screen.note(&format!("view: refused: {error}"));
                }
                News::Refused(_) | News::Nothing => {}
                News::Closed if self.device.is_none() => return Ok(End::Replayed),
                News::Closed => self.reconnect(),
            }
            if let Some(failure) = self.session.port().failure() {
                return Err(failure.clone());
            }
            if self.wait().is_some_and(|wait| self.progress.elapsed() >= wait) {
                return Ok(End::Silence);
            }
            self.look_for_garbage();
            if self.screen.is_due() {
                self.draw();
            }
        }
    }

    /// How long there may be no rows.
    fn wait(&self) -> Option<Duration> {
        let seconds = self.args.wait.or(self.args.frames.map(|_| WAIT))?;
        Some(Duration::from_secs(seconds.into()))
    }

    /// A frame is over.
    fn take(&mut self, frame: Frame) -> Result<Option<End>, String> {
        // A device that was reset is not to blame.
        let is_reset = frame.ending == Ending::Restarted;
        if !is_reset {
            self.meter.count(&frame);
        }
        if let Some(problem) = frame.problem() {
            self.screen.note(&format!("view: {problem}"));
            self.damaged += u32::from(!is_reset);
            let is_silent = frame.ending == Ending::Silent;
            self.unfinished = Some(frame);
            if is_silent && self.sent < send::ATTEMPTS {
                self.send()?;
            }
            let is_enough = self.args.frames.is_some() && self.damaged >= GIVE_UP;
            return Ok(is_enough.then_some(End::Damaged));
        }
        self.progress = Instant::now();
        (self.damaged, self.unfinished) = (0, None);
        self.saver.save(&frame)?;
        Ok((Some(self.saver.count()) == self.args.frames).then_some(End::Enough))
    }

    /// The device has vanished: it is opened again when it is back.
    fn reconnect(&mut self) {
        let Some(device) = &self.device else { return };
        if self.session.port().is_connected() {
            self.session.port().disconnect();
            self.screen.note(&format!("view: {device} has vanished; waiting for it"));
        }
        thread::sleep(LOOK_AGAIN);
        if let Ok(line) = port::open(device, self.args.baud) {
            self.screen.note(&format!("view: {device} is back"));
            self.session.port().connect(line);
        }
    }

    fn look_for_garbage(&mut self) {
        if !self.meter.is_garbage(self.session.traffic()) {
            self.garbage = None;
        } else if self.garbage.get_or_insert_with(Instant::now).elapsed() >= GARBAGE
            && !self.has_said_garbage
        {
            self.has_said_garbage = true;
            self.screen.note(&format!("view: {}", self.wrong_speed()));
        }
    }

    fn wrong_speed(&self) -> String {
        format!("bytes, but no packet: wrong baud rate? It is {} here", self.args.baud)
    }

    fn draw(&mut self) {
        let picture = self.session.picture();
        let figures = self.meter.lines(picture, self.session.traffic(), self.args.frames);
        self.screen.draw(picture, &figures);
    }

    /// Says how it went.
    fn finish(mut self, end: End) -> Result<ExitCode, String> {
        if end == End::Enough {
            self.linger();
        }
        self.draw();
        let mut problems = Vec::new();
        let is_connected = self.session.port().is_connected();
        let under_way = self.session.unfinished(match end {
            End::Interrupted => Ending::Stopped,
            _ if end == End::Replayed || !is_connected => Ending::Closed,
            _ => Ending::Silent,
        });
        if let Some(frame) = under_way.filter(|_| end != End::Enough) {
            problems.extend(frame.problem());
            if end == End::Silence {
                self.meter.count(&frame);
            }
            self.unfinished = Some(frame);
        }
        let whole = self.saver.count();
        // Better a part than nothing.
        if let Some(frame) = self.unfinished.take().filter(|_| whole == 0) {
            self.saver.save(&frame)?;
        }
        let traffic = self.session.traffic();
        for place in self.saver.places() {
            println!("{place}: {}", frames(self.saver.count()));
        }
        if !self.screen.is_terminal() {
            let [_, figures] = self.meter.lines(self.session.picture(), traffic, None);
            println!("{figures}");
        }
        if end == End::Interrupted && self.saver.count() == 0 {
            problems.push(match self.meter.is_garbage(traffic) {
                true => self.wrong_speed(),
                false => "no frame came".to_string(),
            });
        }
        if let End::Silence = end {
            let wait = self.wait().unwrap_or_default().as_secs();
            problems.push(if !is_connected {
                format!("the port vanished, and did not come back within {wait} s")
            } else if self.meter.is_garbage(traffic) {
                self.wrong_speed()
            } else {
                format!("nothing of a frame came for {wait} s")
            });
        }
        let is_whole = match self.args.frames {
            Some(count) => whole >= count,
            None => self.meter.incomplete() == 0,
        };
        if let Some(count) = self.args.frames.filter(|_| !is_whole) {
            problems.push(format!("only {whole} of {}", frames(count)));
        }
        for problem in &problems {
            eprintln!("view: {problem}");
        }
        Ok(ExitCode::from(match self.saver.count() {
            0 => NO_FRAME,
            _ if is_whole && whole > 0 => 0,
            _ => INCOMPLETE,
        }))
    }

    /// The sender may not have heard that the last frame is whole.
    fn linger(&mut self) {
        let start = Instant::now();
        while start.elapsed() < LINGER && !self.is_interrupted.load(Ordering::Relaxed) {
            match self.session.listen() {
                News::Nothing | News::Refused(_) => {}
                _ => return,
            }
        }
    }
}

fn frames(count: u32) -> String {
    if count == 1 { "1 frame".into() } else { format!("{count} frames") }
}

//! The host: gives the frames a line, and looks at what comes out.

use crate::args::Args;
use crate::frames::send;
use crate::host::film::Film;
use crate::host::meter::Meter;
use crate::host::port::{self, Port};
use crate::host::receive::{Ending, Room, Session, timing};
use crate::host::screen::Screen;
use crate::host::wire::{Trouble, Wire};
use crate::line::Line;
use clap::Parser;
use scancsg::stream::Timing;
use std::process::ExitCode;
use std::thread;
use std::time::{Duration, Instant};

/// For the pipe's segments, and their views and rows, and those of a file's part, which an unoptimised build copies
/// about. The system gives it as it is used.
const SENDER_STACK: usize = 64 << 20;

/// A frame's first packet may have to be rendered for so long; a sender that fails closes the line.
const FRAME_WAIT: Duration = Duration::from_secs(120);

/// A frame is incomplete, or not acknowledged.
const INCOMPLETE: u8 = 3;

pub fn run() -> ExitCode {
    let args = Args::parse();
    let result = match &args.port {
        Some(device) => send_to_device(&args, device),
        None => loop_back(&args),
    };
    match result {
        Ok(problems) if problems.is_empty() => ExitCode::SUCCESS,
        Ok(problems) => {
            eprintln!("stream: {}", problems.join("\n        "));
            ExitCode::from(INCOMPLETE)
        }
        Err(message) => {
            eprintln!("stream: {message}");
            ExitCode::FAILURE
        }
    }
}

fn line(port: Box<dyn Port>, args: &Args) -> Line {
    let baud = args.baud.filter(|_| args.port.is_none());
    Line::new(Wire::new(port, Trouble { baud, noise: args.noise, cut_after: args.cut_after }))
}

/// Sends to a real device, and waits for it to acknowledge. Returns the problems.
fn send_to_device(args: &Args, device: &str) -> Result<Vec<String>, String> {
    let port = port::open(device, args.baud.unwrap_or(115_200))?;
    let start = Instant::now();
    let sent = send(args, &line(port, args), &mut |frame| {
        eprintln!("frame {}/{} sent to {device}", frame + 1, args.frames);
    })?;
    println!(
        "{} frame(s) of {}x{}, {} bytes in {:.1} s to {device}",
        sent.frames,
        args.size.width(),
        args.size.height(),
        sent.bytes,
        start.elapsed().as_secs_f32()
    );
    let mut problems = Vec::new();
    if sent.unheard > 0 && !args.one_way {
        problems.push(format!("{} frame(s) were not acknowledged by the other end", sent.unheard));
    }
    if sent.frames < args.frames {
        problems.push(format!("gave up after {} of {} frames", sent.frames, args.frames));
    }
    Ok(problems)
}

/// Sends in a thread into one end of a line, receives at the other end, shows and saves.
fn loop_back(args: &Args) -> Result<Vec<String>, String> {
    let (near, far) = port::loopback()?;
    let start = Instant::now();
    thread::scope(|scope| {
        let sender = thread::Builder::new()
            .stack_size(SENDER_STACK)
            .spawn_scoped(scope, || send(args, &line(far, args), &mut |_| {}))
            .map_err(|error| format!("starting a thread failed: {error}"))?;
        let mut room = Room::new();
        let give_up = FRAME_WAIT.as_millis() as u32;
        let timing = Timing { give_up, ..timing(args.baud) };
        let mut session: Session<'_> = Session::new(near, &mut room, timing);
        let (mut screen, mut meter, mut film) = (Screen::new(), Meter::new(), Film::new(&args.out));
        let count = u32::from(args.frames);
        let (mut problems, mut arrived, mut raw) = (Vec::new(), 0, 0);
        while arrived < count {
            let frame = session.frame(FRAME_WAIT, |session| {
                if screen.is_due() {
                    let figures = meter.lines(session.picture(), session.traffic(), Some(count));
                    screen.draw(session.picture(), &figures);
                }
            });
            let Some(frame) = frame else { break };
            arrived += 1;
            meter.count(&frame);
            film.push(&frame)?;
            raw += frame.pixels.len();
            problems.extend(frame.problem().map(|problem| problem + "; what arrived is saved"));
            if frame.ending == Ending::Closed {
                break;
            }
        }
        let traffic = session.traffic();
        screen.draw(session.picture(), &meter.lines(session.picture(), traffic, Some(count)));
        // The sender may still be waiting for an answer.
        drop(session);
        match arrived {
            0 => problems.push("no frame arrived, and nothing was written".to_string()),
            arrived if arrived < count => {
                problems.push(format!("only {arrived} of {count} frames arrived"));
            }
            _ => {}
        }
        for file in film.files() {
            println!(
                "{}: {arrived} frame(s) of {}x{}\n{} bytes on the line for {raw} bytes of pixels, {:.2} s",
                file.display(),
                args.size.width(),
                args.size.height(),
                traffic.bytes,
                start.elapsed().as_secs_f32()
            );
        }
        if traffic.bad_packets > 0 || traffic.requests > 0 {
            println!(
                "{} damaged packet(s), {} request(s) to send something again",
                traffic.bad_packets, traffic.requests
            );
        }
        let sent = sender.join().map_err(|_| "the sending thread panicked")?;
        if let (Err(cause), false) = (sent, problems.is_empty()) {
            problems.push(cause);
        }
        Ok(problems)
    })
}

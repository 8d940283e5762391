//! The command line, and receiving.

use crate::host::image::write_png;
use crate::host::port;
use crate::host::receive::{Ending, Frame, Session};
use crate::host::terminal::Display;
use clap::Parser;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Duration;

/// Receive frames from a serial device, show them, and save them as a PNG file.
///
/// Rows that are lost on the way are asked for again.
#[derive(Debug, Parser)]
#[command(name = "view", version)]
struct Args {
    /// The serial device to listen to
    #[arg(long, value_name = "DEVICE")]
    port: String,

    /// The line's speed in bits per second
    #[arg(long, value_name = "N", default_value_t = 115_200,
          value_parser = clap::value_parser!(u32).range(300..))]
    baud: u32,

    /// The PNG file to write; several frames become an animation
    #[arg(long, value_name = "FILE.png", default_value = "view.png")]
    out: PathBuf,

    /// How many frames to receive
    #[arg(long, value_name = "N", default_value_t = 1,
          value_parser = clap::value_parser!(u16).range(1..=3600))]
    frames: u16,

    /// How long to wait for a frame to begin, in seconds
    #[arg(long, value_name = "SECONDS", default_value_t = 30)]
    wait: u32,
}

pub fn run() -> ExitCode {
    match receive(&Args::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("view: {message}");
            ExitCode::FAILURE
        }
    }
}

fn receive(args: &Args) -> Result<(), String> {
    let mut session = Session::new(port::open(&args.port, args.baud)?);
    let patience = Duration::from_secs(u64::from(args.wait));
    let display = Display::new();
    let mut frames: Vec<Frame> = Vec::new();
    while frames.len() < usize::from(args.frames) {
        display.begin(frames.len() as u32, Some(u32::from(args.frames)));
        let frame = session.frame(patience, |receiver, traffic| display.show(receiver, traffic))?;
        let Some(frame) = frame else { break };
        let is_last = frame.ending == Ending::Closed;
        frames.push(frame);
        if is_last {
            break;
        }
    }
    display.finish();
    let Some(first) = frames.first() else {
        return Err(format!("no frame began on {} within {} s", args.port, args.wait));
    };
    let header = first.header;
    // An animation has one size.
    frames.retain(|frame| {
        let other = frame.header;
        (other.width, other.height, other.format) == (header.width, header.height, header.format)
    });
    write_png(&args.out, &frames)?;
    println!(
        "{}: {} frame(s) of {}x{}, {} bytes",
        args.out.display(),
        frames.len(),
        header.width,
        header.height,
        session.traffic().bytes
    );
    let problems: Vec<String> =
        frames.iter().enumerate().filter_map(|(index, frame)| frame.problem(index)).collect();
    if problems.is_empty() { Ok(()) } else { Err(problems.join("\n")) }
}

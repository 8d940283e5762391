//! The command line.

use clap::Parser;
use std::net::SocketAddr;
use std::path::PathBuf;

const EXIT_CODES: &str = "\
Exit codes: 0 all is well, 1 something failed, 2 wrong options, 3 fewer whole frames than --frames, or \
without it an incomplete one, 4 no frame came.";

/// Receive frames from a serial device, show them, and save them while they come.
///
/// Rows that are lost on the way are asked for again. It goes on until ctrl-C, or for as many
/// frames as --frames says. A port that vanishes is opened again when it comes back.
#[derive(Debug, Parser)]
#[command(name = "view", version, after_help = EXIT_CODES)]
pub struct Args {
    /// Send this part to the device first, a program in bytes, and receive the picture that answers it
    #[arg(long, value_name = "FILE", conflicts_with_all = ["replay", "frames"])]
    pub send: Option<PathBuf>,

    /// The serial device to listen to; without it, the only one there is
    #[arg(long, value_name = "DEVICE")]
    pub port: Option<String>,

    /// List the serial devices
    #[arg(long)]
    pub list: bool,

    /// The line's speed in bits per second
    #[arg(long, value_name = "N", default_value_t = 115_200,
          value_parser = clap::value_parser!(u32).range(300..))]
    pub baud: u32,

    /// The PNG file to write; several frames become an animation. view.png, if neither --series nor
    /// --record is there
    #[arg(long, value_name = "FILE.png")]
    pub out: Option<PathBuf>,

    /// A directory for each frame as a PNG file of its own
    #[arg(long, value_name = "DIR")]
    pub series: Option<PathBuf>,

    /// Write all bytes that come into this file
    #[arg(long, value_name = "FILE")]
    pub record: Option<PathBuf>,

    /// Receive from such a file instead of a device
    #[arg(long, value_name = "FILE", conflicts_with = "port")]
    pub replay: Option<PathBuf>,

    /// Pass the bytes on to web pages, both ways: a WebSocket server at this address, as 127.0.0.1:8765
    #[arg(long, value_name = "ADDRESS")]
    pub serve: Option<SocketAddr>,

    /// How many whole frames to receive; all that come if it is left out
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub frames: Option<u32>,

    /// End after so many seconds without rows of a frame; bytes that are no packets don't count. 30 with
    /// --frames, for ever without. A frame is over after a third of it without rows, or 10 seconds
    #[arg(long, value_name = "SECONDS", value_parser = clap::value_parser!(u32).range(1..))]
    pub wait: Option<u32>,
}

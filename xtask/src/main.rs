//! The chores of scancsg, behind one door: `cargo xtask --help`.

mod board;
mod boards;
mod boot;
mod c;
mod ci;
mod command;
mod counts;
mod decode;
mod device;
mod elf;
mod faults;
mod hals;
#[path = "../../examples/host/mod.rs"]
mod host;
#[path = "../../tests/footprint/kinds.rs"]
mod kinds;
mod layers;
#[path = "../../examples/lidar/world.rs"]
mod lidar;
mod log;
#[path = "../../examples/oled/screen/mod.rs"]
mod oled;
mod part;
mod paths;
mod pico;
#[path = "../../examples/bench/points.rs"]
mod points;
mod profile;
mod python;
mod report;
#[path = "../../examples/scene/mod.rs"]
mod scene;
mod search;
mod sent;
mod sizes;
mod template;
mod toolchain;
mod web;

use board::{Board, Number};
use clap::{Parser, Subcommand};
use std::path::PathBuf;
use std::process::ExitCode;

/// Builds firmware, boots it on emulated boards, and measures it; and checks everything.
#[derive(Debug, Parser)]
#[command(name = "xtask", bin_name = "cargo xtask", max_term_width = 80)]
struct Args {
    #[command(subcommand)]
    chore: Chore,
}

#[derive(Debug, Subcommand)]
enum Chore {
    /// Build the firmware of every board, boot it, receive its picture through its serial port, and
    /// compare it with the host's
    Boards(boards::Boards),

    /// Measure flash by firmware, feature and level of optimisation, and RAM by kind of solid
    Sizes(sizes::Sizes),

    /// Build firmware with its `defmt` log, and check the picture and the log
    Log(Chosen),

    /// Do to firmware what goes wrong on serial lines: garbage, a reset, nobody who reads
    Faults(Chosen),

    /// Send parts to firmware that waits for them, and compare its pictures with the host's
    Device {
        /// This board, in both number types; may be given several times [default: microbit in i16f16, an386 in f32]
        #[arg(long)]
        board: Vec<Board>,
    },

    /// Count where the instructions of a part of the example `bench` go
    Profile(profile::Profile),

    /// Build firmware with parts that `scancsg-scad --firmware` made, and print what they take
    Part(part::Parts),

    /// Build the page for browsers, `target/web/scancsg.html`
    Web(web::Web),

    /// Install the Python package into `target/python`, and test it
    Python,

    /// Build the library for Arduino, `target/arduino/Scancsg`
    Arduino,

    /// Check everything that must hold before a change lands, or one step of it
    Ci(ci::Ci),

    /// Run the random tests in an optimised build, with fresh seeds until time is over
    Search(search::Search),

    /// Boot one firmware, show the picture that it sends, and save it
    Boot {
        /// The board that it was built for
        board: Board,
        /// The firmware
        elf: PathBuf,
        /// The PNG file to write
        #[arg(long, value_name = "FILE.png", default_value = "board.png")]
        png: PathBuf,
    },
}

#[derive(Debug, clap::Args)]
struct Chosen {
    /// Only this board; may be given several times [default: microbit and virt]
    #[arg(long)]
    board: Vec<Board>,

    /// The number type
    #[arg(long, default_value = "i16f16")]
    number: Number,
}

impl Chosen {
    fn boards(&self) -> &[Board] {
        if self.board.is_empty() { &Board::SHORT } else { &self.board }
    }
}

fn main() -> ExitCode {
    let result = match Args::parse().chore {
        Chore::Boards(chosen) => boards::measure(&chosen),
        Chore::Sizes(chosen) => sizes::show(&chosen),
        Chore::Log(chosen) => {
            chosen.boards().iter().try_for_each(|board| log::check(*board, chosen.number))
        }
        Chore::Faults(chosen) => faults::check(chosen.boards(), chosen.number),
        Chore::Device { board } if board.is_empty() => device::check(&device::SHORT),
        Chore::Device { board } => board
            .iter()
            .try_for_each(|board| device::check(&Number::ALL.map(|number| (*board, number)))),
        Chore::Profile(chosen) => profile::show(&chosen),
        Chore::Part(chosen) => part::measure(&chosen),
        Chore::Web(chosen) => web::run(&chosen),
        Chore::Python => python::check(),
        Chore::Arduino => c::arduino(),
        Chore::Ci(chosen) => ci::run(&chosen),
        Chore::Search(chosen) => search::run(&chosen),
        Chore::Boot { board, elf, png } => boot::show(board, &elf, &png),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("xtask: {message}");
            ExitCode::FAILURE
        }
    }
}

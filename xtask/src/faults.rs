//! What goes wrong on a serial line, done to a firmware on purpose.

use crate::board::{Board, Number};
use crate::boot::Machine;
use crate::host::port::{Heard, Port, write_all};
use crate::host::receive::{Ending, Room, Session, timing};
use crate::toolchain;
use std::io;
use std::os::unix::net::UnixStream;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Duration;

type Fault = fn(Board, &Path) -> Result<(), String>;

/// Does everything to the firmware of some boards, of all of them at once.
pub fn check(boards: &[Board], number: Number) -> Result<(), String> {
    let problems: Vec<String> = thread::scope(|scope| {
        let checks: Vec<_> =
            boards.iter().map(|board| scope.spawn(move || check_one(*board, number))).collect();
        let done = checks.into_iter().map(|check| check.join());
        done.filter_map(|result| result.unwrap_or(Err("a check panicked".into())).err()).collect()
    });
    if problems.is_empty() { Ok(()) } else { Err(problems.join("\n       ")) }
}

fn check_one(board: Board, number: Number) -> Result<(), String> {
    let elf = toolchain::find(board.target())?.build(board, number, "stream", &[])?;
    let faults: [(&str, Fault); 4] = [
        ("garbage before every answer", garbage),
        ("reset in the middle of a frame", reset),
        ("nobody reads for a while", late),
        ("nobody ever reads", never),
    ];
    for (what, fault) in faults {
        fault(board, &elf).map_err(|problem| format!("{board}, {what}: {problem}"))?;
        println!("{board}, {what}: as it should be");
    }
    Ok(())
}

/// The firmware must pass over what isn't a packet, and find the acknowledgement behind it.
fn garbage(board: Board, elf: &Path) -> Result<(), String> {
    let (machine, line) = Machine::start(board, elf)?;
    receive(machine, Noisy(line))
}

/// Gets a frame whole, and makes sure that the board knows it.
fn receive(machine: Machine, line: impl Port + 'static) -> Result<(), String> {
    let mut room = Room::new();
    let mut session: Session<'_> = Session::new(Box::new(line), &mut room, timing(None));
    let frame = session.frame(Duration::from_secs(60), |_| {}).ok_or("no frame came")?;
    let (said, is_good) = machine.finish_receiving(Duration::from_secs(60), &mut session);
    match frame.problem() {
        None if is_good => Ok(()),
        None => Err(format!("the acknowledgement was not understood: {said}")),
        Some(problem) => Err(problem),
    }
}

/// A line on which every packet to the board comes behind bytes that mean nothing.
struct Noisy(UnixStream);

impl Port for Noisy {
    fn read(&mut self, buffer: &mut [u8], wait: Duration) -> Heard {
        Port::read(&mut self.0, buffer, wait)
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let noise: Vec<u8> =
            (0..60u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 24) as u8).collect();
        write_all(&mut self.0, &noise, Duration::from_secs(1))?;
        // The end of a packet, so that the next one begins afresh.
        write_all(&mut self.0, &[0], Duration::from_secs(1))?;
        Port::write(&mut self.0, bytes)
    }
}

/// The receiver must get the frame whole that is sent after the reset.
fn reset(board: Board, elf: &Path) -> Result<(), String> {
    let (machine, line) = Machine::start(board, elf)?;
    let port = Resetting { board, elf: elf.to_owned(), line, machine: Some(machine), left: 3000 };
    let mut room = Room::new();
    let mut session: Session<'_> = Session::new(Box::new(port), &mut room, timing(None));
    let frame = session.frame(Duration::from_secs(60), |_| {}).ok_or("no frame came")?;
    match frame.ending {
        Ending::Complete => Ok(()),
        _ => Err(frame.problem().unwrap_or_default()),
    }
}

/// A line to a board that is switched off and on again after so many bytes.
struct Resetting {
    board: Board,
    elf: PathBuf,
    line: UnixStream,
    machine: Option<Machine>,
    left: usize,
}

impl Port for Resetting {
    fn read(&mut self, buffer: &mut [u8], wait: Duration) -> Heard {
        if self.left == 0 {
            return Port::read(&mut self.line, buffer, wait);
        }
        let most = buffer.len().min(self.left);
        let heard = Port::read(&mut self.line, buffer.get_mut(..most).unwrap_or_default(), wait);
        let Heard::Bytes(count) = heard else { return heard };
        self.left -= count;
        if self.left == 0 {
            self.machine = None;
            let Ok((machine, line)) = Machine::start(self.board, &self.elf) else {
                return Heard::Closed;
            };
            (self.machine, self.line) = (Some(machine), line);
        }
        heard
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        Port::write(&mut self.line, bytes)
    }
}

/// The emulated serial port holds bytes back until somebody reads: the firmware waits, loses
/// nothing, and goes on. (A real one without flow control loses them, and rows are asked for again.)
fn late(board: Board, elf: &Path) -> Result<(), String> {
    let (machine, line) = Machine::start(board, elf)?;
    thread::sleep(Duration::from_secs(4));
    receive(machine, line)
}

/// The firmware must give up after some time, begin anew, and at last end by itself and say why.
fn never(board: Board, elf: &Path) -> Result<(), String> {
    if board == Board::Lm3s6965 {
        println!(
            "{board}: left out, because its emulated port stops the whole emulator instead of holding \
             bytes back"
        );
        return Ok(());
    }
    let (machine, line) = Machine::start(board, elf)?;
    let (said, is_good) = machine.finish(Duration::from_secs(300));
    drop(line);
    match said.lines().any(|line| line == "nobody reads") {
        true if !is_good => Ok(()),
        true => Err("the firmware counts it as a success".into()),
        false => Err(format!("the firmware waits for ever; it said: {said}")),
    }
}

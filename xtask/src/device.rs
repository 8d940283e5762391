//! Parts that are sent to the firmware of the example `device`: it must send the host's pictures, and refuse what
//! it can't take.

use crate::board::{Board, Number};
use crate::boot::Machine;
use crate::host::receive::{Room, Session, timing};
use crate::host::send;
use crate::scene::Scene;
use crate::scene::fit::Fit;
use crate::scene::housing::HousingScene;
use crate::scene::program::{Part, housing, tee};
use crate::{elf, toolchain};
use scancsg::Error;
use scancsg::geom::OrthographicRays;
use scancsg::program::Program;
use scancsg::render::{Gray8, Lambert, Picture, RowSource, Size};
use scancsg::scalar::I16F16;
use scancsg::solid::{Scan, Solid};
use scancsg::stream::Refusal;
use std::path::Path;
use std::thread;
use std::time::Duration;

/// The smallest core in fixed point, and one with floating point in hardware.
pub const SHORT: [(Board, Number); 2] =
    [(Board::Microbit, Number::I16f16), (Board::An386, Number::F32)];

/// Checks some boards, all of them at once.
pub fn check(boards: &[(Board, Number)]) -> Result<(), String> {
    let problems: Vec<String> = thread::scope(|scope| {
        let check = |(board, number): &(Board, Number)| {
            let (board, number) = (*board, *number);
            scope.spawn(move || {
                check_one(board, number).map_err(|problem| format!("{board}, {number}: {problem}"))
            })
        };
        let checks: Vec<_> = boards.iter().map(check).collect();
        let done = checks.into_iter().map(|check| check.join());
        done.filter_map(|result| result.unwrap_or(Err("a check panicked".into())).err()).collect()
    });
    if problems.is_empty() { Ok(()) } else { Err(problems.join("\n       ")) }
}

fn check_one(board: Board, number: Number) -> Result<(), String> {
    let elf = toolchain::find(board.target())?.build(board, number, "device", &[])?;
    let contents = elf::Contents::read(&elf)?;
    let stack = match number {
        Number::F32 => talk::<f32>(board, &elf, &of_tee::<I16F16>().map_err(text)?)?,
        Number::I16f16 => talk::<I16F16>(board, &elf, &of_tee::<f32>().map_err(text)?)?,
    };
    println!(
        "{board}, {number}: the host's pictures; {} bytes of flash, {} + {stack} of RAM",
        contents.flash, contents.ram
    );
    Ok(())
}

fn text(error: Error) -> String {
    error.as_str().to_owned()
}

fn of_tee<S: Scene>() -> Result<Vec<u8>, Error> {
    bytes(&tee::<S>()?)
}

/// A program as bytes.
fn bytes<S: Scene, const N: usize>(program: &Program<Part<S>, N>) -> Result<Vec<u8>, Error> {
    let mut buffer = [0; 4096];
    Ok(program.to_bytes(&mut buffer)?.to_vec())
}

/// Sends parts to a board, and `foreign`, which has numbers of another type. Returns how deep its stack was.
fn talk<S: HousingScene>(board: Board, elf: &Path, foreign: &[u8]) -> Result<u32, String>
where
    Part<S>: Scan<OrthographicRays<S>, Scalar = S>,
{
    let (machine, line) = Machine::start(board, elf)?;
    let mut room = Room::new();
    let mut session: Session<'_> = Session::new(Box::new(line), &mut room, timing(None));
    let device = send::ask(&mut session, None)?;
    let parts = parts::<S>().map_err(text)?;
    let refusals = [
        (vec![0; usize::from(device.capacity) + 1], "longer than the device has room for"),
        (foreign.to_vec(), "another number type"),
        (b"no program".to_vec(), "nothing that the device can read"),
    ];
    for ((part, picture), (bad, why)) in parts.iter().zip(&refusals) {
        let frame = send::picture(&mut session, part, None, |_| {})?;
        let differing = frame.pixels.iter().zip(picture).filter(|(got, want)| got != want).count();
        if differing > 0 || frame.pixels.len() != picture.len() {
            return Err(format!("{differing} pixels differ from the host's"));
        }
        match send::send(&mut session, bad, None, |_| true) {
            Err(problem) if problem.contains(why) => {}
            Err(problem) => return Err(format!("it should be {why}, and is: {problem}")),
            Ok(()) => return Err(format!("it took what is {why}")),
        }
    }
    drop(session);
    // It waits for the next part: nothing ends it but the emulator's end.
    let (said, _) = machine.finish(Duration::ZERO);
    let mut stacks = said.lines().filter_map(|line| {
        let (stack, room) = line.strip_prefix("stack ")?.split_once(" of ")?;
        Some((stack.parse::<u32>().ok()?, room.parse::<u32>().ok()?))
    });
    match stacks.next_back() {
        Some((stack, room)) if stack < room => Ok(stack),
        Some((_, room)) => Err(format!("the stack fills all of its {room} bytes")),
        None => Err(format!("the firmware doesn't say what its stack takes: {said}")),
    }
}

/// The bytes of a part, and the picture that the firmware should send of it.
type Sent = (Vec<u8>, Vec<u8>);

fn parts<S: HousingScene>() -> Result<[Sent; 3], Error>
where
    Part<S>: Scan<OrthographicRays<S>, Scalar = S>,
{
    let (tee, housing) = (tee::<S>()?, housing::<S>()?);
    let (of_tee, of_housing) =
        ((bytes(&tee)?, on_host(&tee)?), (bytes(&housing)?, on_host(&housing)?));
    Ok([of_tee.clone(), of_housing, of_tee])
}

fn on_host<S: Scene, const N: usize>(program: &Program<Part<S>, N>) -> Result<Vec<u8>, Error>
where
    Part<S>: Scan<OrthographicRays<S>, Scalar = S>,
{
    let fit = Fit::of(&program.bounds()).ok_or(Refusal::Invalid)?;
    let camera = fit.orthographic(None)?;
    let light = Lambert::new(Fit::to_light(), S::hundredths(15))?;
    let size = Size::new(160, 120)?;
    let mut picture = Picture::new(program, &camera, size, light, Gray8(0));
    let mut row = vec![Gray8(0); usize::from(size.width())];
    let mut levels = Vec::new();
    for y in 0..size.height() {
        picture.render(y, &mut row)?;
        levels.extend(row.iter().map(|pixel| pixel.0));
    }
    Ok(levels)
}

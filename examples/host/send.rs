//! Sending a part to a device that answers with its picture.
//!
//! A tool opens a port ([`port::open`](super::port::open)), makes a [`Session`] of it with a
//! [`Room`](super::receive::Room), and calls [`picture`]. [`ask`] says beforehand what the device takes.

use super::port::Port;
use super::receive::{Frame, Session};
use scancsg::stream::{Device, Outcome, Patience, Upload};
use std::time::Duration;

/// A device that is busy with a picture doesn't listen: it is asked for so long.
const BUSY: u32 = 30_000;
/// So long is waited for rows.
const FRAME_WAIT: Duration = Duration::from_secs(30);
/// A device that falls silent in the middle of its picture gets the part again: it may have been reset.
pub const ATTEMPTS: u8 = 3;

/// How long answers are waited for, in milliseconds, on a line of so many bits per second.
fn patience(baud: Option<u32>) -> Patience {
    let ticks = 250 + baud.map_or(0, |baud| 5_000_000 / baud.max(1));
    Patience { ticks, silences: (BUSY / ticks).max(10) as u16 }
}

/// Asks a device what it takes.
pub fn ask<P: Port>(session: &mut Session<'_, P>, baud: Option<u32>) -> Result<Device, String> {
    let mut question = Upload::new(&[], patience(baud));
    session.upload(&mut question, |_| true)?;
    question.device().ok_or_else(|| UNHEARD.into())
}

/// Sends a part. Its picture comes next: [`Session::frame`]. `go_on` hears how many bytes are there, and says whether
/// to go on.
pub fn send<P: Port>(
    session: &mut Session<'_, P>,
    part: &[u8],
    baud: Option<u32>,
    go_on: impl FnMut(usize) -> bool,
) -> Result<(), String> {
    if part.is_empty() {
        return Err("there are no bytes to send".into());
    }
    let mut upload = Upload::new(part, patience(baud));
    match (session.upload(&mut upload, go_on)?, upload.device()) {
        (Outcome::Taken, _) => Ok(()),
        (Outcome::Refused(why), None) => Err(format!("the part can't be sent: {why}")),
        (Outcome::Refused(why), Some(device)) => Err(format!(
            "the device refuses the part of {} bytes: {why}. It takes up to {} bytes, in {}",
            part.len(),
            device.capacity,
            number_name(device.number)
        )),
        (Outcome::Unheard, None) => Err(UNHEARD.into()),
        (Outcome::Unheard, Some(_)) => Err("the device doesn't answer any more".into()),
    }
}

const UNHEARD: &str =
    "the device doesn't answer: is it one that waits for a part, and is the line's speed right?";

/// Sends a part, and receives its picture; `watch` sees it grow.
pub fn picture<P: Port>(
    session: &mut Session<'_, P>,
    part: &[u8],
    baud: Option<u32>,
    mut watch: impl FnMut(&Session<'_, P>),
) -> Result<Frame, String> {
    let mut problem = None;
    for _ in 0..ATTEMPTS {
        send(session, part, baud, |_| true)?;
        match session.frame(FRAME_WAIT, &mut watch) {
            Some(frame) if frame.problem().is_none() => return Ok(frame),
            frame => problem = frame.and_then(|frame| frame.problem()),
        }
    }
    Err(problem.unwrap_or_else(|| "the device took the part, and sends no picture".into()))
}

/// The name of a number type, by its code in a program.
pub fn number_name(code: u8) -> String {
    match code {
        32 => "f32".into(),
        64 => "f64".into(),
        8..=28 => format!("I{}F{code}", 32 - code),
        _ => format!("numbers of the unknown type {code}"),
    }
}

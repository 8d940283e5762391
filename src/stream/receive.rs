//! The loop of a receiver over a line.

use embedded_io::{Read, ReadReady, Write};

use super::assembler::Event;
use super::clock::Clock;
use super::receiver::Receiver;
use super::serve::write;
use super::serve_error::ServeError;

/// Listens to the line until something has happened, and answers the sender: the receiving end of
/// [`serve`](super::serve).
///
/// Call it again and again. It returns with [`Event::Complete`] for each whole frame, and with the smaller
/// events before that. `read_ready` must not wait. An answer that can't be written is lost, as it may be on the
/// line, and costs no event.
///
/// ```
/// use embedded_io::{Read, ReadReady, Write};
/// use scancsg::stream::{Event, Looks, Memory, Receiver, ServeError, Timing, receive};
///
/// /// Waits for a whole frame of up to 160×120 grey pixels, and gives its middle row to `show`.
/// fn one_frame<L: Read + ReadReady + Write>(
///     line: &mut L,
///     mut show: impl FnMut(&[u8]),
/// ) -> Result<(), ServeError<L::Error>> {
///     let (mut pixels, mut rows, mut above) = ([0; 160 * 120], [false; 120], [0; 160]);
///     let memory = Memory { pixels: &mut pixels, rows: &mut rows, above: &mut above };
///     let timing = Timing { ask: 500_000, give_up: 20_000_000 }; // looks
///     let mut receiver = Receiver::<256>::new(memory, timing);
///     let mut clock = Looks::new();
///     while receive(&mut receiver, line, &mut clock)? != Event::Complete {}
///     show(receiver.frame().row(60).unwrap_or_default());
///     Ok(())
/// }
/// ```
///
/// # Errors
///
/// [`ServeError::Write`], [`ServeError::Read`] or [`ServeError::Closed`] if the line fails.
pub fn receive<L, const N: usize>(
    receiver: &mut Receiver<'_, N>,
    line: &mut L,
    clock: &mut impl Clock,
) -> Result<Event, ServeError<L::Error>>
where
    L: Read + ReadReady + Write + ?Sized,
{
    loop {
        let event = if line.read_ready().map_err(ServeError::Read)? {
            let mut byte = [0];
            if line.read(&mut byte).map_err(ServeError::Read)? == 0 {
                return Err(ServeError::Closed);
            }
            receiver.receive(&mut &byte[..], clock.now())
        } else {
            clock.idle(1);
            None
        };
        // Also while bytes come: they may be noise.
        let event = event.or_else(|| receiver.poll(clock.now()));
        let written = answer(receiver, line);
        if let Some(event) = event {
            return Ok(event);
        }
        written?;
    }
}

/// Writes the answers.
fn answer<L: Write + ?Sized, const N: usize>(
    receiver: &mut Receiver<'_, N>,
    line: &mut L,
) -> Result<(), ServeError<L::Error>> {
    while let Some(answer) = receiver.answer() {
        write(line, answer)?;
        line.flush().map_err(ServeError::Write)?;
    }
    Ok(())
}

//! The loop of a device that waits for an upload.

use embedded_io::{Read, ReadReady, Write};

use super::super::clock::Clock;
use super::super::serve::write;
use super::super::serve_error::ServeError;
use super::inbox::Inbox;

/// Waits until an upload has come, whole and checked, and returns its bytes.
///
/// Answer it with a frame ([`serve`](crate::stream::serve)), or refuse it ([`Inbox::refuse`]), and call it again
/// for the next one. `read_ready` must not wait. The clock only passes the time.
///
/// ```
/// use embedded_io::{Read, ReadReady, Write};
/// use scancsg::program::Program;
/// use scancsg::solid::Sphere;
/// use scancsg::stream::{Inbox, Looks, ServeError, take};
///
/// /// Waits for balls, and gives them to `show`, which sends a picture.
/// fn balls<L: Read + ReadReady + Write>(
///     line: &mut L,
///     mut show: impl FnMut(&Program<Sphere<f32>, 8>, &mut L),
/// ) -> Result<(), ServeError<L::Error>> {
///     let mut memory = [0; 256];
///     let mut inbox = Inbox::new(&mut memory, 32); // f32
///     loop {
///         let bytes = take(&mut inbox, line, &mut Looks::new())?;
///         match Program::from_bytes(bytes) {
///             Ok(program) => show(&program, line),
///             Err(error) => inbox.refuse(error.into()),
///         }
///     }
/// }
/// ```
///
/// # Errors
///
/// [`ServeError::Write`], [`ServeError::Read`] or [`ServeError::Closed`] if the line fails.
pub fn take<'i, L>(
    inbox: &'i mut Inbox<'_>,
    line: &mut L,
    clock: &mut impl Clock,
) -> Result<&'i [u8], ServeError<L::Error>>
where
    L: Read + ReadReady + Write + ?Sized,
{
    loop {
        if let Some(answer) = inbox.answer() {
            write(line, answer)?;
            line.flush().map_err(ServeError::Write)?;
        }
        if !line.read_ready().map_err(ServeError::Read)? {
            clock.idle(1);
            continue;
        }
        let mut byte = [0];
        if line.read(&mut byte).map_err(ServeError::Read)? == 0 {
            return Err(ServeError::Closed);
        }
        if byte.into_iter().any(|byte| inbox.receive(byte)) {
            return Ok(inbox.bytes());
        }
    }
}

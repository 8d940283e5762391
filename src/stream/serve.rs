//! The loop of firmware: render, send, listen, and render again what was lost.

use embedded_io::{Read, ReadReady, Write};

use super::clock::Clock;
use super::codec::RowCoding;
use super::pixel::{Wire, WirePixel};
use super::sender::{Delivery, Sender, Task};
use super::serve_error::ServeError;
use super::wire::FrameHeader;
use crate::render::{Palette, RowSource};

/// Sends one frame, and then renders again whatever was lost on the way, until the other end has all of
/// it.
///
/// `frame` is the frame's id: count it up from frame to frame. `pixels` is the memory for one row.
/// Requests are served between rows. `read_ready` must not wait.
///
/// # Errors
///
/// [`ServeError::Render`] if a row can't be rendered, as when `pixels` is not one row;
/// [`ServeError::Encode`] if the sender's buffer is too small for the source's rows; [`ServeError::Write`],
/// [`ServeError::Read`] or [`ServeError::Closed`] if the line fails. The frame is then over: call it again
/// with the next id.
///
/// ```
/// use embedded_io::{ErrorKind, ErrorType, Read, ReadReady, Write};
/// use scancsg::geom::vec3;
/// use scancsg::render::{Gray8, Lambert, Orthographic, Picture, Size};
/// use scancsg::solid::Sphere;
/// use scancsg::stream::{
///     Delivery, Looks, Patience, PixelFormat, Plain, Sender, encode_ack, row_capacity, serve,
/// };
///
/// /// In firmware, your HAL's serial port. Here the other end answers to the first flush.
/// struct Port<'a>(&'a [u8], bool);
/// # impl ErrorType for Port<'_> {
/// #     type Error = ErrorKind;
/// # }
/// # impl Read for Port<'_> {
/// #     fn read(&mut self, bytes: &mut [u8]) -> Result<usize, ErrorKind> {
/// #         self.0.read(bytes).map_err(|never| match never {})
/// #     }
/// # }
/// # impl ReadReady for Port<'_> {
/// #     fn read_ready(&mut self) -> Result<bool, ErrorKind> {
/// #         Ok(self.1 && !self.0.is_empty())
/// #     }
/// # }
/// # impl Write for Port<'_> {
/// #     fn write(&mut self, bytes: &[u8]) -> Result<usize, ErrorKind> {
/// #         Ok(bytes.len())
/// #     }
/// #     fn flush(&mut self) -> Result<(), ErrorKind> {
/// #         self.1 = true;
/// #         Ok(())
/// #     }
/// # }
///
/// let ball = Sphere::<f32>::new(vec3(0.0, 0.0, 0.0), 1.0)?;
/// let (eye, target, up) = (vec3(0.0, 0.0, 5.0), vec3(0.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));
/// let camera = Orthographic::look_at(eye, target, up, 3.0)?;
/// let light = Lambert::new(vec3(0.0, 0.0, 1.0), 0.2)?;
/// let mut picture = Picture::new(&ball, &camera, Size::new(32, 24)?, light, Gray8(0));
///
/// let mut answer = [0; 16];
/// let length = encode_ack(7, &mut answer)?;
/// let mut port = Port(&answer[..length], false);
///
/// let patience = Patience { ticks: 500_000, silences: 3 };
/// let mut sender = Sender::<_, { row_capacity(32, PixelFormat::Gray8) }>::new(Plain, patience);
/// let mut row = [Gray8(0); 32];
/// let delivery = serve(&mut picture, 7, &mut sender, &mut port, &mut row, &mut Looks::new())?;
/// assert_eq!(delivery, Delivery::Acknowledged { repairs: 0 });
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn serve<S, L, C, const N: usize>(
    source: &mut S,
    frame: u16,
    sender: &mut Sender<C, N>,
    line: &mut L,
    pixels: &mut [S::Pixel],
    clock: &mut impl Clock,
) -> Result<Delivery, ServeError<L::Error>>
where
    S: RowSource<Pixel: WirePixel> + ?Sized,
    L: Read + ReadReady + Write + ?Sized,
    C: RowCoding<S::Pixel>,
{
    sender.begin(header_of(source, frame)).map_err(ServeError::Encode)?;
    let mut rendered = None;
    let mut is_flushed = true;
    loop {
        let mut is_quiet = false;
        for _ in 0..READS {
            is_quiet = !line.read_ready().map_err(ServeError::Read)?;
            if is_quiet {
                break;
            }
            let mut bytes = [0; 16];
            let count = line.read(&mut bytes).map_err(ServeError::Read)?;
            if count == 0 {
                return Err(ServeError::Closed);
            }
            bytes.iter().take(count).for_each(|byte| sender.receive(*byte, clock.now()));
        }
        match sender.poll(clock.now()) {
            Task::Send(packet) => {
                write(line, packet)?;
                sender.sent(clock.now());
                is_flushed = false;
            }
            Task::Row(y) => {
                if rendered != Some(y) {
                    source.render(y, pixels).map_err(ServeError::Render)?;
                    rendered = Some(y);
                }
                sender.row(y, pixels).map_err(ServeError::Encode)?;
            }
            Task::Listen(ticks) if is_flushed => clock.idle(if is_quiet { ticks } else { 0 }),
            // The other end can't answer what still waits in a buffer.
            Task::Listen(_) => {
                line.flush().map_err(ServeError::Write)?;
                is_flushed = true;
            }
            Task::Done(delivery) => {
                line.flush().map_err(ServeError::Write)?;
                return Ok(delivery);
            }
        }
    }
}

/// So often the line is read before the next packet: noise without end must not hold a frame.
pub(super) const READS: u8 = 8;

/// Writes all of the bytes.
pub(super) fn write<L: Write + ?Sized>(
    line: &mut L,
    mut bytes: &[u8],
) -> Result<(), ServeError<L::Error>> {
    while !bytes.is_empty() {
        match line.write(bytes).map_err(ServeError::Write)? {
            0 => return Err(ServeError::Closed),
            count => bytes = bytes.get(count..).unwrap_or_default(),
        }
    }
    Ok(())
}

/// The header of a source's frame.
pub(super) fn header_of<S>(source: &S, frame: u16) -> FrameHeader
where
    S: RowSource<Pixel: WirePixel> + ?Sized,
{
    let size = source.size();
    let format = <S::Pixel as WirePixel>::Wire::FORMAT;
    let palette = if format.has_colors() { source.palette() } else { Palette::EMPTY };
    FrameHeader { frame, width: size.width(), height: size.height(), format, palette }
}

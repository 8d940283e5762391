//! The loop of firmware: render, send, listen, and render again what was lost.

use embedded_io::{Read, ReadReady, Write};

use super::decoder::Decoder;
use super::pixel::WirePixel;
use super::sender::{SendError, Sender};
use super::wire::{CONTROL_CAPACITY, FrameHeader, Packet, Part};
use crate::render::RowSource;

/// How long [`serve`] waits for the other end, which has no clock: it counts its looks at the line.
///
/// A look is one call of [`read_ready`](ReadReady::read_ready) that found nothing. On a microcontroller that
/// asks a register, some ten to thirty instructions pass from look to look: 500,000 looks are about a
/// second at 16 MHz. A `read_ready` that itself waits, for a timer's tick or in an operating system, needs
/// fewer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Patience {
    /// So many looks since the last packet are a silence, and the end of the frame is sent once more.
    /// Bytes that are no packet don't break a silence.
    pub looks: u32,
    /// After so many silences, one after the other, the frame counts as unheard.
    pub silences: u32,
}

/// How a frame ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Delivery {
    /// The other end has the whole frame.
    Acknowledged {
        /// How many things it has asked for again.
        repairs: u16,
    },
    /// The other end said nothing for as long as there was [`Patience`]: nobody is there, or can't answer.
    Unheard,
}

/// Sends one frame, and then renders again whatever was lost on the way, until the other end has all of
/// it.
///
/// `frame` is the frame's id: count it up from frame to frame. `pixels` is the memory for one row; the
/// sender has that for one packet. A 16-byte buffer for answers is all that comes on top.
///
/// # Errors
///
/// [`SendError::Render`] if a row can't be rendered, as when `pixels` is not one row;
/// [`SendError::Encode`] if the sender's buffer is too small for the source's rows; [`SendError::Io`],
/// [`SendError::Listen`] or [`SendError::Closed`] if the line fails. The frame is then over: call it again
/// with the next id.
///
/// ```
/// use embedded_io::{ErrorKind, ErrorType, Read, ReadReady, Write};
/// use scancsg::geom::vec3;
/// use scancsg::render::{Gray8, Lambert, Orthographic, Picture, Size};
/// use scancsg::solid::Sphere;
/// use scancsg::stream::{
///     Delivery, Patience, PixelFormat, Sender, encode_ack, packet_capacity, serve,
/// };
///
/// /// In firmware, your HAL's serial port. Here the other end has answered beforehand.
/// struct Port<'a>(&'a [u8]);
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
/// #         Ok(!self.0.is_empty())
/// #     }
/// # }
/// # impl Write for Port<'_> {
/// #     fn write(&mut self, bytes: &[u8]) -> Result<usize, ErrorKind> {
/// #         Ok(bytes.len())
/// #     }
/// #     fn flush(&mut self) -> Result<(), ErrorKind> {
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
/// let port = Port(&answer[..length]);
///
/// let mut sender = Sender::<_, { packet_capacity(32, PixelFormat::Gray8) }>::new(port);
/// let mut row = [Gray8(0); 32];
/// let patience = Patience { looks: 500_000, silences: 3 };
/// let delivery = serve(&mut picture, 7, &mut sender, &mut row, patience)?;
/// assert_eq!(delivery, Delivery::Acknowledged { repairs: 0 });
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn serve<S, L, const N: usize>(
    source: &mut S,
    frame: u16,
    sender: &mut Sender<L, N>,
    pixels: &mut [S::Pixel],
    patience: Patience,
) -> Result<Delivery, SendError<L::Error>>
where
    S: RowSource<Pixel: WirePixel> + ?Sized,
    L: Read + ReadReady + Write,
{
    let size = source.size();
    let (width, height) = (size.width(), size.height());
    sender.begin(FrameHeader { frame, width, height, format: S::Pixel::FORMAT })?;
    for y in 0..height {
        source.render(y, pixels).map_err(SendError::Render)?;
        sender.row(y, pixels)?;
    }
    sender.end()?;

    let mut decoder = Decoder::<CONTROL_CAPACITY>::new();
    let (mut looks, mut silences, mut repairs) = (0, 0, 0_u16);
    while silences < patience.silences {
        let Some(byte) = look(sender.writer_mut())? else {
            if looks == 0 {
                // The other end can't answer what still waits in a buffer.
                sender.writer_mut().flush().map_err(SendError::Io)?;
            }
            looks += 1;
            if looks >= patience.looks {
                (looks, silences) = (0, silences + 1);
                sender.end_again()?;
            }
            continue;
        };
        // What can't be read is asked for again by the other end.
        let Some(Ok(packet)) = decoder.push(byte) else { continue };
        (looks, silences) = (0, 0);
        match packet {
            Packet::Ack { frame: whole } if whole == frame => {
                return Ok(Delivery::Acknowledged { repairs });
            }
            Packet::Request(request) if request.frame == frame => {
                repairs = repairs.saturating_add(1);
                match request.part {
                    Part::Header => sender.header_again()?,
                    Part::End => sender.end_again()?,
                    Part::Row(y) if y < height => {
                        source.render(y, pixels).map_err(SendError::Render)?;
                        sender.resend_row(y, pixels)?;
                    }
                    Part::Row(_) => {}
                }
            }
            _ => {}
        }
    }
    Ok(Delivery::Unheard)
}

/// The next byte of the line, if there is one.
fn look<L: Read + ReadReady>(line: &mut L) -> Result<Option<u8>, SendError<L::Error>> {
    if !line.read_ready().map_err(SendError::Listen)? {
        return Ok(None);
    }
    let mut byte = [0];
    match line.read(&mut byte).map_err(SendError::Listen)? {
        0 => Err(SendError::Closed),
        _ => Ok(byte.first().copied()),
    }
}

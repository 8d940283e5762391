//! The device's side: renders a picture row by row into a serial line, and repairs it.
//!
//! Nothing here needs an operating system: firmware gives it a UART, the host a pseudo-terminal.

use embedded_io::Write;
use scancsg::render::{RowError, RowSource};
use scancsg::stream::{
    CONTROL_CAPACITY, Decoder, FrameHeader, Packet, Part, Request, SendError, Sender, WirePixel,
};

/// A serial line that can also be listened to.
pub trait Line: Write {
    /// The next byte from the other end, or `None` if none came within about a second.
    fn listen(&mut self) -> Result<Option<u8>, Self::Error>;
}

/// How a frame ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Delivery {
    /// The other end has the whole frame, after it has asked for so many things again.
    Acknowledged { repairs: u16 },
    /// The other end said nothing for three seconds: nobody is there, or can't answer.
    Unheard,
}

/// Why a frame could not be sent.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(target_os = "none", allow(dead_code))] // only a log tells all of it
pub enum DeviceError<E> {
    /// A row was asked for that does not fit the buffers.
    Row(RowError),
    /// The line failed, or the frame does not fit the sender.
    Send(SendError<E>),
}

impl<E> From<RowError> for DeviceError<E> {
    fn from(error: RowError) -> Self {
        Self::Row(error)
    }
}

impl<E> From<SendError<E>> for DeviceError<E> {
    fn from(error: SendError<E>) -> Self {
        Self::Send(error)
    }
}

/// Silence of the other end, in calls of [`Line::listen`], before a frame counts as unheard.
const PATIENCE: u32 = 3;

/// Sends one frame, and then renders again whatever was lost on the way, until the other end has
/// everything. `pixels` is the memory for one row.
pub fn send_frame<P, L, const N: usize>(
    picture: &mut impl RowSource<Pixel = P>,
    frame: u16,
    sender: &mut Sender<L, N>,
    pixels: &mut [P],
) -> Result<Delivery, DeviceError<L::Error>>
where
    P: WirePixel,
    L: Line,
{
    let size = picture.size();
    sender.begin(FrameHeader {
        frame,
        width: size.width(),
        height: size.height(),
        format: P::FORMAT,
    })?;
    for y in 0..size.height() {
        picture.render(y, pixels)?;
        sender.row(y, pixels)?;
    }
    sender.end()?;

    let mut decoder = Decoder::<CONTROL_CAPACITY>::new();
    let (mut silence, mut repairs) = (0, 0_u16);
    while silence < PATIENCE {
        let Some(byte) = sender.writer_mut().listen().map_err(SendError::Io)? else {
            silence += 1;
            sender.end_again()?;
            continue;
        };
        // What can't be read is asked for again by the other end.
        let Some(Ok(packet)) = decoder.push(byte) else { continue };
        silence = 0;
        match packet {
            Packet::Ack { frame: whole } if whole == frame => {
                return Ok(Delivery::Acknowledged { repairs });
            }
            Packet::Request(Request { frame: wanted, part }) if wanted == frame => {
                repairs = repairs.saturating_add(1);
                match part {
                    Part::Header => sender.header_again()?,
                    Part::End => sender.end_again()?,
                    Part::Row(y) if y < size.height() => {
                        picture.render(y, pixels)?;
                        sender.resend_row(y, pixels)?;
                    }
                    _ => {}
                }
            }
            _ => {}
        }
    }
    Ok(Delivery::Unheard)
}

//! The link: rows become packets, packets become bytes, and back.
//!
//! A sender renders a frame row by row and sends each row as one packet; a receiver puts the frame
//! together and asks for what is missing. Rendering is deterministic, so the sender keeps nothing: it
//! renders a row that was lost once more. The core does no I/O and allocates nothing, so a second
//! microcontroller can receive as well as a host can.
//!
//! # Packets
//!
//! A packet is `[kind u8][body][CRC u32]`, all numbers little-endian. The CRC-32/ISO-HDLC (that of zlib)
//! covers kind and body. The packet is framed by Consistent Overhead Byte Stuffing (S. Cheshire, M. Baker,
//! IEEE/ACM Transactions on Networking 7(2), 1999), so that no byte of it is zero, and a zero byte ends it.
//! Before a frame header a zero byte more cuts off whatever was on the line. Zeros between packets mean
//! nothing.
//!
//! | kind | packet  | body                                                                               |
//! |------|---------|------------------------------------------------------------------------------------|
//! | 0x01 | header  | version `u8` (1), frame `u16`, width `u16`, height `u16`, pixel format `u8`        |
//! | 0x02 | row     | frame `u16`, y `u16`, encoding `u8`, payload                                       |
//! | 0x03 | end     | frame `u16`, hash `u32`                                                            |
//! | 0x81 | request | frame `u16`, part `u8` (0 header, 1 row, 2 end), y `u16` (0 unless part is 1)      |
//! | 0x82 | ack     | frame `u16`                                                                        |
//!
//! Kinds from 0x80 on go back from the receiver to the sender. Pixel formats have the codes of
//! [`PixelFormat::code`]. Encoding 0 is the pixels as they are, encoding 1
//! PackBits (Apple Technical Note TN1023; TIFF 6.0, section 9) in units of pixels, not bytes; the sender
//! takes the shorter one. The hash of the frame is the sum modulo 2^32 of its rows' hashes, and a row's hash
//! is the CRC-32 of y (`u16`) and the row's pixels as they are ([`RowHash`], [`FrameHash`]).
//!
//! # Sizes
//!
//! In bytes on the line, terminator included, with P = width · bytes per pixel:
//!
//! | packet  | at most                             | 320 pixels of RGB565 |
//! |---------|-------------------------------------|----------------------|
//! | header  | 16                                  |                      |
//! | row     | 11 + P + ⌈(P + 10) / 254⌉           | 654                  |
//! | end     | 13                                  |                      |
//! | request | 12                                  |                      |
//! | ack     | 9                                   |                      |
//!
//! [`packet_capacity`] is the size of a buffer for all of them. An even row of 320 RGB565 pixels is three
//! runs: 21 bytes.
//!
//! # Repair
//!
//! The [`Decoder`] drops a damaged packet and finds the next one; nothing is ever repeated unasked.
//!
//! 1. The sender sends header, rows and end ([`Sender::begin`], [`row`](Sender::row), [`end`](Sender::end)).
//! 2. At the end, or when the line has gone quiet, the receiver sends [`Receiver::requests`]: the header if it
//!    never came, else the missing rows, else the end.
//! 3. The sender answers with [`header_again`](Sender::header_again), [`resend_row`](Sender::resend_row) or
//!    [`end_again`](Sender::end_again), and ignores requests for frames other than its own.
//! 4. When all rows are there and the hash is right, the receiver acknowledges. A sender that hears nothing
//!    for a while says [`end_again`](Sender::end_again): the receiver asks or acknowledges once more.
//!
//! [`serve`] is the sender's whole part of it: firmware calls it once for each frame.
//! Without a back channel, steps 2 to 4 fall away, and the receiver knows which rows it lacks.
//!
//! # Example
//!
//! ```
//! use scancsg::render::Gray8;
//! use scancsg::stream::{
//!     Decoder, Event, FrameHeader, PixelFormat, Receiver, Sender, packet_capacity,
//! };
//!
//! const CAPACITY: usize = packet_capacity(4, PixelFormat::Gray8);
//! let rows = [[1, 2, 3, 4].map(Gray8), [9, 9, 9, 9].map(Gray8)];
//!
//! // The sender's side; the line is a slice, which is a writer too.
//! let mut line = [0; 128];
//! let mut sender: Sender<_, CAPACITY> = Sender::new(&mut line[..]);
//! sender.begin(FrameHeader { frame: 1, width: 4, height: 2, format: PixelFormat::Gray8 })?;
//! for (y, row) in (0..).zip(&rows) {
//!     sender.row(y, row)?;
//! }
//! sender.end()?;
//! let sent = sender.bytes_sent() as usize;
//!
//! // The receiver's side.
//! let (mut pixels, mut flags) = ([0; 8], [false; 2]);
//! let mut receiver = Receiver::new(&mut pixels, &mut flags);
//! let mut decoder: Decoder<CAPACITY> = Decoder::new();
//! let mut bytes = &line[..sent];
//! let mut last = None;
//! while let Some(packet) = decoder.feed(&mut bytes) {
//!     last = Some(receiver.accept(&packet?)?);
//! }
//! assert_eq!(last, Some(Event::Complete));
//! assert_eq!(receiver.pixels(), [1, 2, 3, 4, 9, 9, 9, 9]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod assembler;
mod clock;
mod codec;
mod crc;
mod decoder;
mod error;
pub mod faults;
mod framing;
mod pixel;
mod receive;
mod receiver;
mod sender;
mod serve;
#[cfg(feature = "async")]
mod serve_async;
mod serve_error;
mod wire;

pub use assembler::{Assembler, Event, Memory, ReceiveError};
#[cfg(feature = "async")]
pub use clock::AsyncClock;
pub use clock::{Clock, Looks};
pub use codec::{Coding, Encoding, Plain, RowCoding, RowPayload};
pub use crc::{FrameHash, RowHash};
pub use decoder::Decoder;
pub use error::{EncodeError, PacketError, UnpackError};
pub use pixel::{PixelFormat, Wire, WirePixel};
pub use receive::receive;
pub use receiver::{Receiver, Timing, Traffic};
pub use sender::{Delivery, Patience, Sender, Task};
pub use serve::serve;
#[cfg(feature = "async")]
pub use serve_async::{receive_async, serve_async};
pub use serve_error::ServeError;
pub use wire::{
    CONTROL_CAPACITY, FrameHeader, PROTOCOL_VERSION, Packet, Part, Request, encode_ack, encode_end,
    encode_header, encode_request, encode_row, packet_capacity, row_capacity,
};

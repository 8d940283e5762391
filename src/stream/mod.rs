//! The link: rows become packets, packets become bytes, and back.
//!
//! A [`Sender`] takes a frame row by row and packs several rows into a packet. A [`Receiver`] puts the frame
//! together and asks for what is missing as soon as a gap shows. Rendering is deterministic, so the sender
//! keeps nothing: it renders a row that was lost once more. Both are state machines without I/O, driven by
//! bytes and ticks, and allocate nothing. A second microcontroller can receive as well as a host can.
//!
//! | to | use |
//! |---|---|
//! | send frames from firmware | [`serve`]; `serve_async` with the feature `async` |
//! | receive frames | [`receive`]; `receive_async` |
//! | drive the ends yourself | [`Sender::poll`], [`Receiver::receive`] |
//! | code rows short | [`Predictive`]: a quarter of the bytes of [`Plain`] |
//! | send with the least memory and time | [`Plain`] |
//! | send your own pixels | [`WirePixel`] |
//! | send a part to a device, which answers with its picture | [`Upload`]; on the device [`take`]; `take_async` |
//!
//! # Format
//!
//! The version is 2; another one is refused by name ([`PacketError::Version`]).
//! `docs/link.md` in the repository has every byte, and a decoder in Python.
//!
//! A packet is `[kind u8][body][CRC u32]`, all numbers little-endian. The CRC-32/ISO-HDLC (that of zlib)
//! covers kind and body. The packet is framed by Consistent Overhead Byte Stuffing (S. Cheshire, M. Baker,
//! IEEE/ACM Transactions on Networking 7(2), 1999), so that no byte of it is zero, and a zero byte ends it.
//! Zeros between packets mean nothing.
//!
//! | kind | packet  | body |
//! |------|---------|------|
//! | 0x01 | header  | version `u8` (2), frame `u16`, width `u16`, height `u16`, pixel format `u8`, n `u8`, n colours of 3 bytes |
//! | 0x02 | row     | frame `u16`, y `u16`, encoding `u8` (0 raw, 1 PackBits), payload |
//! | 0x03 | end     | frame `u16`, hash `u32` |
//! | 0x04 | rows    | frame `u16`, first y `u16`, count `u8`, payload |
//! | 0x05 | status  | upload's hash `u32`, bytes there `u16`, refusal `u8`, capacity `u16`, number type `u8` |
//! | 0x81 | request | frame `u16`, part `u8` (0 header, 1 rows, 2 end), first y `u16`, count `u16`, limit `u8` |
//! | 0x82 | ack     | frame `u16` |
//! | 0x83 | chunk   | upload's length `u16`, its hash `u32`, offset `u16`, bytes |
//!
//! Kinds from 0x80 on go back from the receiver to the sender. The hash of the frame is the sum modulo 2^32
//! of its rows' hashes, and a row's hash is the CRC-32 of y (`u16`) and the row's bytes ([`RowHash`],
//! [`FrameHash`]).
//!
//! # Repair
//!
//! 1. The sender sends header, rows and end.
//! 2. The receiver asks for rows that it lacks when later ones come, and for the header if that never came.
//!    The sender answers between rows.
//! 3. Whenever the sender has sent all that it knows of, it sends the end. What is missing then was lost:
//!    the receiver asks at once, for shorter packets each time.
//! 4. When all rows are there and the hash is right, the receiver acknowledges. A sender that hears nothing
//!    sends the end again, some times as late as answers took before.
//!
//! Without a way back, steps 2 to 4 fall away, and the receiver knows which rows it lacks.
//!
//! # Uploads
//!
//! 1. The receiver's end sends a chunk. The device answers each with a status: how many bytes it has.
//! 2. The next chunk has the bytes behind those. Without an answer, a chunk is sent again.
//! 3. When all bytes are there, a chunk without bytes hands them over. The device answers with a frame, or refuses.

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
mod schedule;
mod sender;
mod serve;
#[cfg(feature = "async")]
mod serve_async;
mod serve_error;
mod upload;
mod wire;

pub use assembler::{Assembler, Event, Memory, ReceiveError};
#[cfg(feature = "async")]
pub use clock::AsyncClock;
pub use clock::{Clock, Looks};
pub use codec::{
    Coding, Encoding, Plain, Predictable, Predictive, PredictiveMono, RowCoding, RowPayload,
};
pub use crc::{FrameHash, RowHash};
pub use decoder::Decoder;
pub use error::{EncodeError, LinkError, PacketError, UnpackError};
pub use pixel::{PixelFormat, Wire, WirePixel};
pub use receive::receive;
pub use receiver::{Receiver, Timing, Traffic};
pub use sender::{Delivery, Patience, Sender, Task};
pub use serve::serve;
#[cfg(feature = "async")]
pub use serve_async::{receive_async, serve_async, take_async};
pub use serve_error::ServeError;
pub use upload::{Device, Inbox, Outcome, Refusal, Upload, UploadTask, take};
pub use wire::{
    CONTROL_CAPACITY, FrameHeader, PROTOCOL_VERSION, Packet, Part, Request, encode_ack, encode_end,
    encode_header, encode_request, encode_row, packet_capacity, row_capacity,
};

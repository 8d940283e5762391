//! The packets of the link: what each one says, and its layout, for both directions.
//!
//! A layout is written once, in constants of the packet's name: its kind, and where each field is, counted
//! from the kind; `LEN` is where the last one ends. All numbers are little-endian. What goes around these
//! contents on the line is framing. The packets of an upload are in `upload/wire.rs`: firmware without one
//! doesn't read them.

mod answers;
mod capacity;
mod end;
mod fields;
mod header;
mod packet;
mod rows;

pub(super) use answers::REQUEST_CAPACITY;
pub use answers::{Part, Request, encode_ack, encode_request};
pub use capacity::{CONTROL_CAPACITY, packet_capacity, row_capacity};
pub use end::encode_end;
pub(super) use fields::{Field, Fields};
pub use header::{FrameHeader, PROTOCOL_VERSION, encode_header};
pub use packet::Packet;
pub use rows::encode_row;
pub(super) use rows::{rows_payload, seal_rows};

//! Why a packet can't be written, read or unpacked.

/// Why a packet could not be encoded. The buffer's contents are then meaningless.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum EncodeError {
    /// The packet does not fit into the buffer: see [`packet_capacity`](super::packet_capacity).
    BufferTooSmall,
    /// The frame or the row has no pixels, or the row has more than 65535.
    Size,
}

crate::error_text!(EncodeError {
    BufferTooSmall => "packet does not fit into the buffer",
    Size => "frame or row has no pixels, or too many",
});

/// Why the bytes up to a terminator are not a packet. The next packet is not affected.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum PacketError {
    /// The terminator came inside a COBS block.
    Framing,
    /// The packet does not fit into the decoder's buffer.
    TooLong,
    /// The checksum is wrong.
    Crc,
    /// The kind is unknown.
    Kind,
    /// The packet has a wrong length for its kind.
    Length,
    /// The header is of another protocol version than [`PROTOCOL_VERSION`](super::PROTOCOL_VERSION).
    Version,
    /// The header's pixel format is unknown.
    Format,
    /// The header's width or height is zero.
    Size,
    /// The row's encoding is unknown.
    Encoding,
    /// The request's part is unknown.
    Part,
}

crate::error_text!(PacketError {
    Framing => "packet ends inside a COBS block",
    TooLong => "packet is longer than the decoder's buffer",
    Crc => "packet checksum is wrong",
    Kind => "packet kind is unknown",
    Length => "packet has a wrong length for its kind",
    Version => "frame header is of another protocol version",
    Format => "pixel format is unknown",
    Size => "frame has no pixels",
    Encoding => "row encoding is unknown",
    Part => "requested part is unknown",
});

/// Why a payload is not the row that it should be.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum UnpackError {
    /// The payload ends inside a run or a pixel.
    Truncated,
    /// The payload holds more than the row.
    TooLong,
    /// The payload holds less than the row.
    TooShort,
}

crate::error_text!(UnpackError {
    Truncated => "row payload ends inside a run",
    TooLong => "row payload is longer than the row",
    TooShort => "row payload is shorter than the row",
});

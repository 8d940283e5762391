//! Why a packet can't be written, read or unpacked.

crate::error_text! {
    /// Why a packet could not be made.
    pub enum EncodeError {
        /// The packet does not fit into the buffer: see [`packet_capacity`](super::packet_capacity).
        BufferTooSmall => "packet does not fit into the buffer",
        /// The frame or the row has no pixels, or the row has more than 65535.
        Size => "frame or row has no pixels, or too many",
        /// No frame has been begun.
        NoFrame => "no frame has been begun",
        /// The pixels are not in the frame's format.
        Format => "pixels are not in the frame's format",
        /// The row is not as wide as the frame.
        Width => "row is not as wide as the frame",
        /// The row is not the one that is wanted: see [`Sender::poll`](super::Sender::poll).
        Order => "row is not the one that is wanted",
    }
}

crate::error_text! {
    /// Why the bytes up to a terminator are not a packet. The next packet is not affected.
    pub enum PacketError {
        /// The terminator came inside a COBS block.
        Framing => "packet ends inside a COBS block",
        /// The packet does not fit into the decoder's buffer.
        TooLong => "packet is longer than the decoder's buffer",
        /// The checksum is wrong.
        Crc => "packet checksum is wrong",
        /// The kind is unknown.
        Kind => "packet kind is unknown",
        /// The packet has a wrong length for its kind.
        Length => "packet has a wrong length for its kind",
        /// The header is of another protocol version than [`PROTOCOL_VERSION`](super::PROTOCOL_VERSION).
        Version => "frame header is of another protocol version",
        /// The header's pixel format is unknown.
        Format => "pixel format is unknown",
        /// The header's width or height is zero.
        Size => "frame has no pixels",
        /// The row's encoding is unknown.
        Encoding => "row encoding is unknown",
        /// The request's part is unknown.
        Part => "requested part is unknown",
    }
}

crate::error_text! {
    /// Why a payload is not the row that it should be.
    pub enum UnpackError {
        /// The payload ends inside a run or a pixel.
        Truncated => "row payload ends inside a run",
        /// The payload holds more than the row.
        TooLong => "row payload is longer than the row",
        /// The payload holds less than the row.
        TooShort => "row payload is shorter than the row",
        /// The receiver lends no memory for the row above, or too little.
        NoMemory => "receiver has no memory for rows that are coded together",
    }
}

crate::error_text! {
    /// How a line failed, without its own error: what [`scancsg::Error`](crate::Error) keeps of a
    /// [`ServeError`](super::ServeError).
    pub enum LinkError {
        /// Writing failed.
        Write => "writing to the line failed",
        /// Reading failed.
        Read => "reading from the line failed",
        /// The other end is closed.
        Closed => "line is closed at its other end",
    }
}

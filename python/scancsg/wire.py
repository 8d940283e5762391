"""Packets of the link's version 2, between the line and their meaning."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import Iterator, Union
from zlib import crc32

from .frame import Header, PixelFormat

VERSION = 2

HEADER, ROW, END, ROWS = 0x01, 0x02, 0x03, 0x04
REQUEST, ACK = 0x81, 0x82
RAW, PACKBITS = 0, 1

#: The longest packet that is kept: rows of 4,096 pixels of three bytes have shorter ones.
LONGEST = 1 << 16


class ProtocolError(Exception):
    """The sender speaks another version of the protocol."""


@dataclass(frozen=True)
class Rows:
    """Rows of a frame, one below the other, and their pixels as they are coded."""

    frame: int
    y: int
    count: int
    payload: bytes
    #: How a row that was sent by itself is coded; None for rows that were coded together.
    encoding: int | None


@dataclass(frozen=True)
class End:
    """The end of a frame, with the hash of all its rows."""

    frame: int
    hash: int


Packet = Union[Header, Rows, End]


def cobs_encode(content: bytes) -> bytes:
    """Makes content free of zeros (Cheshire, Baker 1999)."""
    out = bytearray()
    for block in (content + b"\0").split(b"\0")[:-1]:
        while len(block) >= 254:
            out += b"\xff" + block[:254]
            block = block[254:]
        out.append(len(block) + 1)
        out += block
    return bytes(out)


def cobs_decode(block: bytes) -> bytes | None:
    """The content again; None if it can't be such a block."""
    out = bytearray()
    at = 0
    while at < len(block):
        code = block[at]
        end = at + code
        if code == 0 or end > len(block):
            return None
        out += block[at + 1 : end]
        if code < 255 and end < len(block):
            out.append(0)
        at = end
    return bytes(out)


def seal(content: bytes) -> bytes:
    """The bytes on the line for a packet's content. The zero before it cuts off what was there."""
    return b"\0" + cobs_encode(content + struct.pack("<I", crc32(content))) + b"\0"


def request(frame: int, part: int, y: int = 0, count: int = 0, limit: int = 0) -> bytes:
    """Asks for the header (part 0), for rows (1) or for the end (2)."""
    return seal(struct.pack("<BHBHHB", REQUEST, frame, part, y, count, limit))


def ack(frame: int) -> bytes:
    """Says that a frame is complete."""
    return seal(struct.pack("<BH", ACK, frame))


def parse(block: bytes) -> Packet | None:
    """The packet in a COBS block; None if it is damaged or makes no sense."""
    sealed = cobs_decode(block)
    if sealed is None or len(sealed) < 5:
        return None
    content, crc = sealed[:-4], sealed[-4:]
    if struct.pack("<I", crc32(content)) != crc:
        return None
    kind, body = content[0], content[1:]
    try:
        if kind == HEADER:
            return _header(body)
        if kind == ROW:
            frame, y, encoding = struct.unpack_from("<HHB", body)
            known = encoding in (RAW, PACKBITS) and len(body) > 5
            return Rows(frame, y, 1, body[5:], encoding) if known else None
        if kind == ROWS:
            frame, y, count = struct.unpack_from("<HHB", body)
            return Rows(frame, y, count, body[5:], None) if count else None
        if kind == END:
            return End(*struct.unpack("<HI", body))
    except (struct.error, ValueError):
        pass
    return None


def _header(body: bytes) -> Header | None:
    version = body[:1]
    if version and version[0] != VERSION:
        raise ProtocolError(
            f"the sender speaks version {version[0]} of the protocol; this is version {VERSION}"
        )
    _, frame, width, height, code, count = struct.unpack_from("<BHHHBB", body)
    rest = body[9:]
    if count > 7 or len(rest) != 3 * count or not width or not height:
        return None
    colors = tuple((rest[i], rest[i + 1], rest[i + 2]) for i in range(0, 3 * count, 3))
    return Header(frame, width, height, PixelFormat(code), colors)


def unpack_row(rows: Rows, unit: int) -> bytes | None:
    """The pixels of a row that was sent by itself; None if its runs are cut off."""
    if rows.encoding == RAW:
        return rows.payload
    packed, at = rows.payload, 0
    out = bytearray()
    while at < len(packed):
        control = packed[at]
        at += 1
        if control == 128:
            continue
        length = unit * (control + 1 if control < 128 else 1)
        if at + length > len(packed):
            return None
        out += packed[at : at + length] * (1 if control < 128 else 257 - control)
        at += length
    return bytes(out)


class Decoder:
    """Finds packets in a stream of bytes, whatever the bytes are."""

    def __init__(self) -> None:
        self._buffer = bytearray()
        self._is_skipping = False

    def feed(self, data: bytes) -> Iterator[Packet | None]:
        """The packets that these bytes complete; None for a damaged one."""
        self._buffer += data
        *blocks, rest = self._buffer.split(b"\0")
        self._buffer = rest
        for block in blocks:
            if self._is_skipping:
                self._is_skipping = False
            elif block:
                yield parse(bytes(block))
        if len(self._buffer) > LONGEST:
            self._buffer.clear()
            if not self._is_skipping:
                self._is_skipping = True
                yield None

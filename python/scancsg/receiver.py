"""The receiving end of the link, without I/O: bytes in, frames and answers out."""

from __future__ import annotations

from dataclasses import dataclass
from struct import pack
from typing import Iterator
from zlib import crc32

from . import wire
from .frame import Frame, Header
from .rows import RowsDecoder

#: So many seconds after the last packet in the middle of a frame, what is missing is asked for. Then twice
#: as long, up to eight times.
ASK = 0.4
#: So many seconds after the last packet, the frame is given up.
GIVE_UP = 10.0

#: So many gaps are asked for at once: senders remember no more.
_GAPS = 8
#: The header of an unknown frame is asked for again after so many of its packets.
_STRAYS = 4
#: The most contents of a packet that is asked for first; half of it each time that it fails.
_FIRST_LIMIT = 127
#: Frames of more pixels are refused.
_MOST_PIXELS = 1 << 24


@dataclass
class Traffic:
    """What has come over the line so far."""

    bytes: int = 0
    #: Packets that could be read. None among many bytes: the line's speed is likely to be wrong.
    packets: int = 0
    #: Packets that were damaged, or did not fit their frame.
    bad_packets: int = 0
    #: Requests to send something again.
    requests: int = 0
    #: Complete frames.
    frames: int = 0
    #: Frames that were given up, or that the sender left behind.
    lost: int = 0


class _Assembly:
    """A frame in the making."""

    def __init__(self, header: Header) -> None:
        self.header = header
        self.data = bytearray(header.row_bytes * header.height)
        self.hashes: list[int | None] = [None] * header.height
        self.left = header.height
        self.end: int | None = None
        self.is_complete = False
        self.is_given_up = False
        self.decoder: RowsDecoder | None = None
        # What has been asked for.
        self.expected = 0
        self.has_ended = False
        self.limit = _FIRST_LIMIT

    def accept(self, rows: wire.Rows) -> bool:
        """Takes in rows. False if they don't fit."""
        header, size = self.header, self.header.row_bytes
        end = rows.y + rows.count
        if end > header.height:
            return False
        if None not in self.hashes[rows.y : end]:
            return True
        unpacked: list[bytes] | None
        if rows.encoding is None:
            self.decoder = self.decoder or RowsDecoder(header)
            unpacked = self.decoder.decode(rows.payload, rows.count)
        else:
            row = wire.unpack_row(rows, header.format.unit)
            unpacked = None if row is None or len(row) != size else [row]
        if unpacked is None:
            return False
        for y, row in enumerate(unpacked, rows.y):
            if self.hashes[y] is None:
                self.data[y * size : (y + 1) * size] = row
                self.hashes[y] = crc32(row, crc32(pack("<H", y)))
                self.left -= 1
        return True

    def conclude(self) -> bool:
        """Compares the hash when all is here. Which rows are wrong can't be told: all are missing then."""
        if self.left or self.end is None:
            return False
        if sum(known for known in self.hashes if known is not None) & 0xFFFF_FFFF == self.end:
            self.is_complete = True
            return True
        self.hashes = [None] * self.header.height
        self.left, self.end = self.header.height, None
        return False

    @property
    def missing(self) -> tuple[int, ...]:
        return tuple(y for y, known in enumerate(self.hashes) if known is None)

    def gaps(self) -> Iterator[tuple[int, int]]:
        """The missing rows: the first one's number, and how many they are."""
        start = 0
        missing = self.missing
        for i, y in enumerate(missing):
            if i + 1 == len(missing) or missing[i + 1] != y + 1:
                yield missing[start], y + 1 - missing[start]
                start = i + 1

    @property
    def frame(self) -> Frame:
        data = self.data.copy()
        size = self.header.row_bytes
        missing = () if self.is_complete else self.missing
        for y in missing:
            data[y * size : (y + 1) * size] = bytes(size)
        return Frame(self.header, bytes(data), self.is_complete, missing)


class Receiver:
    """Receives frame after frame, and asks for what is missing: a state machine without I/O or clock.

    Give it what the line brings (`receive`), call `poll` now and then, and write what `answers` returns.
    Times are in seconds.
    """

    def __init__(self, *, ask: float = ASK, give_up: float = GIVE_UP) -> None:
        self.traffic = Traffic()
        self._timing = ask, give_up
        self._decoder = wire.Decoder()
        self._current: _Assembly | None = None
        self._answers: list[bytes] = []
        # Packets of a frame without a header: how many, of which frame, whether its header is asked for.
        self._strays = 0
        self._stray_of: int | None = None
        self._unknown: int | None = None
        #: A frame whose header was no good: asking for it again would not help.
        self._refused: int | None = None
        self._since = 0.0
        self._next = self._step = ask
        self._is_silent = False

    def receive(self, data: bytes, now: float) -> list[Frame]:
        """Takes in bytes. Returns the frames that are over now: complete ones, and incomplete ones that
        the sender has left behind.

        Raises `ProtocolError` if the sender speaks another version.
        """
        self.traffic.bytes += len(data)
        over: list[Frame] = []
        for packet in self._decoder.feed(data):
            if packet is None:
                self.traffic.bad_packets += 1
                continue
            self.traffic.packets += 1
            if isinstance(packet, Header):
                self._header(packet, now, over)
            else:
                self._packet(packet, now, over)
        return over

    def poll(self, now: float) -> list[Frame]:
        """Looks at the clock: asks again, or gives the frame up and returns it."""
        current = self._current
        unfinished = current if current and not current.is_complete else None
        if self._is_silent or (unfinished is None and self._unknown is None):
            return []
        quiet = now - self._since
        if quiet >= self._timing[1]:
            self._is_silent = True
            self._unknown = None
            return self.finish()
        if quiet >= self._next:
            self._step = min(2 * self._step, 8 * self._timing[0])
            self._next = quiet + self._step
            self._answers.clear()
            if self._unknown is not None:
                self._request(self._unknown, 0)
            elif unfinished and unfinished.left:
                self._request_gaps(unfinished)
            elif unfinished:
                self._request(unfinished.header.id, 2)
        return []

    def finish(self) -> list[Frame]:
        """Gives up the frame that is put together, if it lacks something, and returns it."""
        current = self._current
        if current is None or current.is_complete or current.is_given_up:
            return []
        current.is_given_up = True
        self.traffic.lost += 1
        return [current.frame]

    def answers(self) -> bytes:
        """The bytes to write to the sender. Each answer is given once."""
        answers = b"".join(self._answers)
        self._answers.clear()
        return answers

    @property
    def current(self) -> Frame | None:
        """The frame that is put together, or the last one."""
        return self._current.frame if self._current else None

    def _heard(self, now: float) -> None:
        self._since = now
        self._next = self._step = self._timing[0]
        self._is_silent = False

    def _header(self, header: Header, now: float, over: list[Frame]) -> None:
        self._strays, self._stray_of, self._unknown = 0, None, None
        if header.width * header.height > _MOST_PIXELS:
            self.traffic.bad_packets += 1
            self._refused = header.id
            return
        self._refused = None
        self._heard(now)
        if self._current and self._current.header == header:
            return
        over += self.finish()
        self._answers.clear()
        self._current = _Assembly(header)

    def _packet(self, packet: wire.Rows | wire.End, now: float, over: list[Frame]) -> None:
        current = self._current
        if current is None or current.header.id != packet.frame:
            self._stray(packet, now)
            return
        self._strays, self._stray_of, self._unknown = 0, None, None
        if isinstance(packet, wire.Rows):
            if not current.accept(packet):
                self.traffic.bad_packets += 1
                return
            if packet.y > current.expected and not current.has_ended:
                count = packet.y - current.expected
                self._request(packet.frame, 1, current.expected, count, current.limit)
            current.expected = max(current.expected, packet.y + packet.count)
        else:
            current.end = packet.hash
        self._heard(now)
        was_complete = current.is_complete
        if not was_complete and current.conclude():
            self.traffic.frames += 1
            over.append(current.frame)
        if current.is_complete:
            if not was_complete or isinstance(packet, wire.End):
                self._answers = [wire.ack(packet.frame)]
        elif isinstance(packet, wire.End) or current.left == current.header.height:
            # The sender has done all that it was asked for: what is missing now was lost.
            self._request_gaps(current)

    def _stray(self, packet: wire.Rows | wire.End, now: float) -> None:
        """A packet of a frame without a header. A late one of the frame before is no reason to ask."""
        if packet.frame == self._refused:
            return
        is_expected = self._current is None or self._current.is_complete
        is_second = self._stray_of == packet.frame
        self._stray_of = packet.frame
        if not (is_expected or is_second):
            return
        self._unknown = packet.frame
        self._heard(now)
        if self._strays == 0 or isinstance(packet, wire.End):
            self._answers.clear()
            self._request(packet.frame, 0)
        self._strays = (self._strays + 1) % _STRAYS

    def _request_gaps(self, current: _Assembly) -> None:
        self._answers.clear()
        for _, (y, count) in zip(range(_GAPS), current.gaps()):
            self._request(current.header.id, 1, y, count, current.limit)
        if current.has_ended:
            current.limit //= 2
        current.has_ended = True

    def _request(self, frame: int, part: int, y: int = 0, count: int = 0, limit: int = 0) -> None:
        self._answers.append(wire.request(frame, part, y, count, limit))
        self.traffic.requests += 1

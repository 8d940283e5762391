"""Frames from a serial port, a recording, or anything that can be read."""

from __future__ import annotations

import os
import stat
import time
import warnings
from types import TracebackType
from typing import Any, Iterator, Protocol, Union, cast

import serial

from .frame import Frame
from .receiver import Receiver, Traffic

#: So long is waited for bytes, before the receiver looks at the clock.
_READ_TIMEOUT = 0.05


class Readable(Protocol):
    """What frames can come from."""

    def read(self, size: int = ..., /) -> bytes | None:
        """Some bytes; none at the end."""


Source = Union[str, "os.PathLike[str]", Readable]


class Link:
    """A line, and the receiver at its end: an iterator of frames that closes what it has opened.

    >>> with Link("/dev/ttyACM0", baud=921_600) as link:  # doctest: +SKIP
    ...     for frame in link:
    ...         print(frame.id, link.traffic)
    """

    def __init__(
        self,
        source: Source,
        *,
        baud: int = 115_200,
        incomplete: bool = False,
        wait: float | None = None,
    ) -> None:
        self._receiver = Receiver()
        self._incomplete = incomplete
        self._wait = wait
        self._is_ours = isinstance(source, (str, os.PathLike))
        self._source = cast(Any, _opened(source, baud) if self._is_ours else source)
        # A port without bytes is only silent; a file is over.
        self._can_be_silent = hasattr(self._source, "in_waiting")
        self._can_answer = _can_answer(self._source)

    @property
    def traffic(self) -> Traffic:
        """What has come over the line so far."""
        return self._receiver.traffic

    @property
    def current(self) -> Frame | None:
        """The frame that is put together, or the last one."""
        return self._receiver.current

    def __iter__(self) -> Iterator[Frame]:
        receiver = self._receiver
        heard = time.monotonic()
        packets = 0
        has_warned = False
        while True:
            data = self._read()
            now = time.monotonic()
            if data is None:
                break
            over = receiver.receive(data, now) + receiver.poll(now)
            if receiver.traffic.packets != packets:
                packets, heard = receiver.traffic.packets, now
            self._answer(receiver.answers())
            for frame in over:
                if frame.is_complete or self._incomplete:
                    yield frame
            if receiver.traffic.bytes > 1000 and not receiver.traffic.packets and not has_warned:
                has_warned = True
                warnings.warn("bytes, but no packet: is this the line's speed?", stacklevel=2)
            if self._wait is not None and now - heard > self._wait:
                break
        if self._incomplete:
            yield from receiver.finish()

    def close(self) -> None:
        """Closes the port or the file, if it was opened here."""
        if self._is_ours:
            self._source.close()

    def __enter__(self) -> Link:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def _read(self) -> bytes | None:
        """Some bytes; none if the line is silent, None if it is over."""
        source = self._source
        if self._can_be_silent:
            return bytes(source.read(max(1, source.in_waiting)))
        data = source.read1(4096) if hasattr(source, "read1") else source.read(4096)
        if data is None:
            # A file that does not wait.
            time.sleep(_READ_TIMEOUT)
            return b""
        return bytes(data) or None

    def _answer(self, answers: bytes) -> None:
        if answers and self._can_answer:
            self._source.write(answers)
            self._source.flush()


def frames(
    source: Source,
    *,
    baud: int = 115_200,
    incomplete: bool = False,
    wait: float | None = None,
) -> Iterator[Frame]:
    """Frames as they come, until the line is over.

    `source` is the name of a serial port or of a recording, or anything with a `read` method. If it can be
    written too, rows that get lost are asked for, and complete frames are acknowledged.

    With `incomplete`, frames that lack rows are returned too. With `wait`, it ends after so many seconds
    without a packet; other bytes don't count.

    Raises `ProtocolError` if the sender speaks another version of the protocol, and `OSError` if the source
    can't be opened or fails (`serial.SerialException` is one).
    """
    with Link(source, baud=baud, incomplete=incomplete, wait=wait) as link:
        yield from link


def _opened(source: Any, baud: int) -> Any:
    name = os.fspath(source)
    if os.path.isfile(name):
        return open(name, "rb")
    return serial.serial_for_url(name, baudrate=baud, timeout=_READ_TIMEOUT, exclusive=None)


def _can_answer(source: Any) -> bool:
    """Whether what is written gets to a sender: a file on disk would be changed by it."""
    if not hasattr(source, "write"):
        return False
    if hasattr(source, "writable") and not source.writable():
        return False
    try:
        return not stat.S_ISREG(os.fstat(source.fileno()).st_mode)
    except (AttributeError, OSError, ValueError):
        # Without a file descriptor: `io.BytesIO` is no line either.
        return not hasattr(source, "getbuffer")

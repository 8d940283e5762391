"""Frames, and their pixels as arrays."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

import numpy as np
import numpy.typing as npt


class PixelFormat(IntEnum):
    """The pixels of a frame on the link, by their codes."""

    GRAY8 = 0
    RGB565 = 1
    RGB888 = 2
    MONO = 3

    @property
    def unit(self) -> int:
        """The bytes of a unit: a pixel, or eight pixels of one bit."""
        return (1, 2, 3, 1)[self]

    def row_bytes(self, width: int) -> int:
        """The bytes of a row of so many pixels."""
        return (width + 7) // 8 if self is PixelFormat.MONO else width * self.unit


@dataclass(frozen=True)
class Header:
    """What a frame says before its rows."""

    id: int
    width: int
    height: int
    format: PixelFormat
    #: The colours of the scene's surfaces: red, green, blue.
    colors: tuple[tuple[int, int, int], ...] = ()

    @property
    def row_bytes(self) -> int:
        """The bytes of a row on the link."""
        return self.format.row_bytes(self.width)


@dataclass(frozen=True, eq=False)
class Frame:
    """A frame that was received."""

    header: Header
    #: The bytes of all rows on the link, top row first. Missing rows are zero.
    data: bytes
    #: Whether all rows have come, and their hash is the sender's.
    is_complete: bool
    #: The numbers of the rows that did not come. None may be missing of a frame whose end is.
    missing: tuple[int, ...] = ()

    @property
    def id(self) -> int:
        """The number that the sender gave the frame. It wraps around at 65,536."""
        return self.header.id

    @property
    def pixels(self) -> npt.NDArray[np.uint8]:
        """The pixels, 0 dark to 255 bright: height × width if they are grey or of one bit, and
        height × width × 3 (red, green, blue) if they have colours.
        """
        header = self.header
        rows = np.frombuffer(self.data, np.uint8).reshape(header.height, header.row_bytes)
        if header.format is PixelFormat.GRAY8:
            return rows.copy()
        if header.format is PixelFormat.RGB888:
            return rows.reshape(header.height, header.width, 3).copy()
        if header.format is PixelFormat.MONO:
            return np.unpackbits(rows, axis=1, count=header.width) * np.uint8(255)
        bits = np.frombuffer(self.data, "<u2").reshape(header.height, header.width)
        # Five and six bits to eight: the scale's ends meet.
        channels = [(bits >> 11, 31), (bits >> 5 & 63, 63), (bits & 31, 31)]
        widened = [(channel * np.uint32(255) + most // 2) // most for channel, most in channels]
        return np.stack(widened, axis=2).astype(np.uint8)

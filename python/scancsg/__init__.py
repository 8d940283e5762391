"""Receives the frames that a device renders with scancsg, as numpy arrays.

>>> for frame in scancsg.frames("/dev/ttyACM0"):  # doctest: +SKIP
...     print(frame.id, frame.pixels.shape)
"""

from .frame import Frame, Header, PixelFormat
from .line import Link, frames
from .receiver import Receiver, Traffic
from .wire import ProtocolError

__all__ = [
    "Frame",
    "Header",
    "Link",
    "PixelFormat",
    "ProtocolError",
    "Receiver",
    "Traffic",
    "frames",
]

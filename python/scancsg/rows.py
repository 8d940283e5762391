"""Rows that were coded together, by prediction: a binary range decoder with adaptive probabilities.

This is `src/stream/codec/predictive` of the crate, the way back only. A pixel's symbol is predicted from
its neighbours W (left), N (above), NW, NE and NEE.
"""

from __future__ import annotations

from .frame import Header, PixelFormat

# The numbers of the probabilities.
_FLAT = 0  # a run, or a pixel, as the one at the left? 3 kinds of question, 4 contexts
_ZERO = _FLAT + 12  # as predicted? 66 contexts of gradients, 3 of the last error's sign
_SIGN = _ZERO + 66 * 3  # the error's sign
_JUMP = _SIGN + 66  # far from the prediction? 4 activities, and whether the last error was large
_SMALL = _JUMP + 8  # sizes of small errors
_NEIGHBOR = _SMALL + 24  # a neighbour's symbol? 4 activities, 4 neighbours
_LARGE = _NEIGHBOR + 16  # sizes of large errors
_ESCAPE = _LARGE + 8  # in none of the chains?
_NEAR = _ESCAPE + 1  # the near symbol of such a pixel
_CHANNEL = _NEAR + 10  # what its channels differ by

#: The probabilities at the start of a payload, in 256ths.
_START = bytes((
    198, 252, 10, 211, 208, 232, 131, 217, 227, 248, 128, 255, 128, 128, 128, 204, 95, 241, 191,
    95, 172, 109, 83, 53, 139, 109, 94, 142, 218, 68, 168, 153, 119, 126, 58, 136, 55, 68, 68, 67,
    72, 70, 145, 173, 73, 134, 174, 57, 65, 106, 114, 122, 103, 117, 79, 61, 106, 99, 89, 97, 69,
    48, 41, 62, 43, 43, 124, 141, 68, 169, 136, 161, 69, 23, 84, 45, 37, 45, 58, 48, 55, 97, 70,
    52, 185, 193, 123, 168, 152, 136, 103, 65, 127, 95, 48, 91, 115, 105, 68, 136, 153, 134, 156,
    167, 119, 172, 151, 156, 127, 86, 136, 61, 39, 42, 95, 58, 69, 50, 54, 33, 114, 101, 82, 107,
    82, 101, 124, 60, 65, 102, 61, 62, 158, 164, 46, 71, 47, 29, 71, 31, 37, 124, 91, 68, 143,
    104, 115, 104, 62, 98, 67, 68, 35, 95, 52, 53, 146, 61, 41, 165, 143, 87, 160, 79, 46, 104,
    61, 82, 116, 62, 42, 109, 37, 79, 87, 50, 66, 129, 100, 80, 153, 88, 123, 112, 65, 109, 78,
    16, 43, 89, 26, 64, 52, 13, 43, 129, 53, 83, 87, 32, 74, 128, 128, 128, 110, 102, 81, 97, 76,
    44, 90, 248, 244, 40, 20, 4, 63, 153, 58, 55, 18, 29, 103, 139, 247, 248, 210, 217, 85, 217,
    249, 243, 229, 59, 43, 223, 252, 243, 56, 89, 53, 121, 190, 76, 87, 88, 34, 97, 123, 226, 237,
    222, 199, 75, 194, 235, 226, 190, 56, 52, 198, 246, 230, 87, 113, 118, 172, 210, 93, 106, 120,
    99, 103, 128, 78, 79, 81, 128, 12, 9, 15, 23, 107, 148, 51, 102, 109, 128, 128, 128, 17, 57,
    75, 24, 73, 68, 52, 57, 73, 119, 97, 94, 92, 112, 102, 150, 140, 112, 128, 128, 128, 53, 128,
    128, 128, 45, 128, 128, 53, 35, 71, 85, 42, 16, 226, 213, 197, 185, 168, 139, 32, 1, 27, 38,
    131, 214, 199, 201, 203, 214, 233, 7, 1, 105, 96, 102, 24, 1, 1, 128, 128, 128, 128, 164, 134,
    5, 19, 1, 128, 128, 128, 128, 128, 93, 124, 117, 56, 1, 128, 128, 128, 128, 128,
))

_RUN, _SHORTEST_RUN = 16, 4
_SMOOTH = 16
_LIMIT = 4

_FIRST_BILEVEL = [0x0880] + 510 * [0x8080] + [0xF880]


class _Decisions:
    """Decisions out of a payload. Zeros follow its last byte."""

    __slots__ = ("model", "low", "high", "value", "payload", "read")

    def __init__(self, model: list[int], payload: bytes) -> None:
        self.model = model
        self.low, self.high = 0, 0xFFFF_FFFF
        self.payload = payload + bytes(4)
        self.value = int.from_bytes(self.payload[:4], "big")
        self.read = 4

    def bin(self, slot: int) -> bool:
        """A decision with an adaptive probability."""
        model = self.model
        yes = model[slot]
        low, high = self.low, self.high
        middle = low + ((high - low) >> 12) * (yes >> 4 | 1)
        bit = self.value <= middle
        if bit:
            model[slot] = yes + ((0xFFFF - yes) >> 4)
            high = middle
        else:
            model[slot] = yes - (yes >> 4)
            low = middle + 1
        if (low ^ high) >> 24:
            self.low, self.high = low, high
        else:
            self._shift(low, high)
        return bit

    def even(self) -> bool:
        """A decision that is as likely as not."""
        low, high = self.low, self.high
        middle = low + ((high - low) >> 12) * 2048
        bit = self.value <= middle
        low, high = (low, middle) if bit else (middle + 1, high)
        self._shift(low, high)
        return bit

    def _shift(self, low: int, high: int) -> None:
        while not (low ^ high) >> 24:
            low = low << 8 & 0xFFFF_FFFF
            high = high << 8 & 0xFFFF_FFFF | 0xFF
            byte = self.payload[self.read] if self.read < len(self.payload) else 0
            self.value = self.value << 8 & 0xFFFF_FFFF | byte
            self.read += 1
        self.low, self.high = low, high

    @property
    def is_exact(self) -> bool:
        """Whether the payload has just the bytes that an encoder writes for these decisions."""
        kept = 0
        while kept < 4:
            below = 0xFFFF_FFFF >> 8 * kept
            up = self.low + below
            if up <= 0xFFFF_FFFF and up & ~below <= self.high:
                break
            kept += 1
        return len(self.payload) - 4 == self.read - 4 + kept

    def number(self, slot: int) -> int:
        """A number in an Exp-Golomb code."""
        bits = 0
        while bits < 16 and self.bin(slot + min(8, bits + 1) - 1):
            bits += 1
        read = 1
        for _ in range(bits):
            read = read << 1 | self.even()
        return read - 1

    def signed(self, slot: int) -> int:
        """A number with a sign."""
        if self.bin(slot):
            return 0
        is_minus = self.bin(slot + 1)
        size = 1 + self.number(slot + 2)
        return -size if is_minus else size


def _scale(channel: int, level: int) -> int:
    return (2 * channel * level + 255) // 510


class _Alphabet:
    """The symbols of a frame's pixels."""

    def __init__(self, header: Header) -> None:
        self.format = header.format
        #: The channels of each symbol's pixel.
        self.channels: list[tuple[int, int, int]] = []
        if self.format is PixelFormat.GRAY8:
            self.channels = [(level, level, level) for level in range(256)]
        else:
            for color in header.colors or ((255, 255, 255),):
                self._add_chain(color)
        #: The bytes of each symbol's pixel.
        self.pixels = [self.encode(channels) for channels in self.channels]

    @property
    def _most(self) -> tuple[int, int, int]:
        return (31, 63, 31) if self.format is PixelFormat.RGB565 else (255, 255, 255)

    def _add_chain(self, color: tuple[int, int, int]) -> None:
        """The different pixels that a colour has, from dark to light."""
        last = None
        for level in range(256):
            r, g, b = ((_scale(c, level) * most + 127) // 255 for c, most in zip(color, self._most))
            if (r, g, b) != last:
                last = (r, g, b)
                self.channels.append(last)

    def encode(self, channels: tuple[int, int, int]) -> bytes:
        """The bytes of the pixel with the nearest channels that there are."""
        r, g, b = (min(max(c, 0), most) for c, most in zip(channels, self._most))
        if self.format is PixelFormat.GRAY8:
            return bytes((r,))
        if self.format is PixelFormat.RGB565:
            return (r << 11 | g << 5 | b).to_bytes(2, "little")
        return bytes((r, g, b))


class RowsDecoder:
    """Decodes rows of a frame that were coded together."""

    def __init__(self, header: Header) -> None:
        self._width = header.width
        self._is_mono = header.format is PixelFormat.MONO
        self._alphabet = None if self._is_mono else _Alphabet(header)

    def decode(self, payload: bytes, count: int) -> list[bytes] | None:
        """The bytes of so many rows; None if the payload isn't just that."""
        if self._alphabet is None:
            decisions = _Decisions(_FIRST_BILEVEL.copy(), payload)
            rows = _bilevel(decisions, self._width, count)
        else:
            decisions = _Decisions([start << 8 | 0x80 for start in _START], payload)
            rows = []
            above: list[int] = []
            left = self._alphabet.pixels[0]
            for _ in range(count):
                row = _row(decisions, self._alphabet, self._width, above, left)
                left = row[0]
                rows.append(b"".join(row))
        return rows if decisions.is_exact else None


def _bilevel(decisions: _Decisions, width: int, count: int) -> list[bytes]:
    """Pixels of one bit: the context of each are 4 at the left and 5 above."""
    size = (width + 7) // 8
    rows = []
    # Two pixels more at the left, and enough at the right: all of them 0.
    above = [0] * (8 * size + 4)
    for _ in range(count):
        line = [0] * (8 * size + 4)
        left = 0
        # NWW to NE of the pixel that comes.
        around = above[2] << 1 | above[3]
        for x in range(width):
            around = (around << 1 | above[x + 4]) & 31
            line[x + 2] = bit = int(decisions.bin(left << 5 | around))
            left = (left << 1 | bit) & 15
        rows.append(int("".join(map(str, line[2 : 2 + 8 * size])), 2).to_bytes(size, "big"))
        above = line
    return rows


def _row(
    decisions: _Decisions, alphabet: _Alphabet, width: int, above: list[int], pixel: bytes
) -> list[bytes]:
    """A row's pixels. `above` holds the symbols of the row above, if there is one, and then this one's."""
    bin_, top, pixels = decisions.bin, len(alphabet.pixels) - 1, alphabet.pixels
    is_first = not above
    old = above.copy()
    if old:
        # What is beyond the row is like its last column.
        old += [old[-1]] * 2
    row: list[bytes] = []
    new: list[int] = []
    w = n = nw = ne = last = 0
    if not is_first:
        w = n = nw = old[0]
        ne = old[1]
    x = 0
    while x < width:
        nee = 0 if is_first else old[x + 2]
        if w == n == nw == ne:
            context = _FLAT + (w == 0) + 2 * is_first
            run = _flat(old, x, width, w, is_first)
            is_same = False
            if run >= _SHORTEST_RUN:
                end = x + run
                if bin_(context):
                    row += [pixel] * run
                    new += [w] * run
                    if not is_first:
                        n, ne = old[end], old[end + 1]
                    last = 0
                    x = end
                    continue
                # One of them differs: the last, if all others don't.
                while x + 1 < end and bin_(context + 4):
                    row.append(pixel)
                    new.append(w)
                    x += 1
                if not is_first:
                    ne, nee = old[x + 1], old[x + 2]
            else:
                is_same = bin_(context + 8)
            if is_same:
                symbol = w
            else:
                symbol, pixel = _other(decisions, alphabet, w, (w, w, ne, nee), 0, False, 0)
            last = symbol - w
        else:
            d1, d2, d3 = w - nw, nw - n, n - ne
            if -_SMOOTH < d1 < _SMOOTH and -_SMOOTH < d2 < _SMOOTH:
                guess = min(max(w - d2, 0), top)
            else:
                guess = min(max(w - d2, min(w, n)), max(w, n))
            signed = _level(d1) * 25 + _level(d2) * 5 + _level(d3)
            flip = signed < 0
            gradients = 63 + abs(_level(d2)) if is_first else abs(signed)
            turn = 0 if last == 0 else 1 + ((last < 0) != flip)
            if bin_(_ZERO + gradients * 3 + turn):
                symbol, pixel = guess, pixels[guess]
            else:
                steepest = max(abs(d1), abs(d2), abs(d3))
                activity = 2 * ((steepest > 0) + (steepest > 1) + (steepest > 4)) + (abs(last) > 1)
                near = (n, w, ne, nee)
                symbol, pixel = _other(decisions, alphabet, guess, near, gradients, flip, activity)
            last = symbol - guess
        row.append(pixel)
        new.append(symbol)
        x += 1
        if is_first:
            change = symbol - w
            n = min(max(symbol + change, 0), top) if abs(change) < _SMOOTH else symbol
            nw, ne = symbol, n
        else:
            nw, n, ne = n, ne, nee
        w = symbol
    above[:] = new
    return row


def _flat(old: list[int], x: int, width: int, symbol: int, is_first: bool) -> int:
    """How many columns from here on, at most 16, have this symbol at their upper right."""
    left = width - x
    if is_first:
        return min(left, _RUN)
    run = 0
    while run < _RUN and x + 1 + run < width and old[x + 1 + run] == symbol:
        run += 1
    return min(left, _RUN) if run + 1 == left else run


def _level(gradient: int) -> int:
    return min(max(gradient, -2), 2)


def _other(
    decisions: _Decisions,
    alphabet: _Alphabet,
    guess: int,
    near: tuple[int, int, int, int],
    gradients: int,
    flip: bool,
    activity: int,
) -> tuple[int, bytes]:
    """A pixel whose symbol is not as predicted, or that has none."""
    bin_, pixels = decisions.bin, alphabet.pixels
    top = len(pixels) - 1
    is_far = bin_(_JUMP + activity)
    if is_far:
        if alphabet.format is not PixelFormat.GRAY8 and bin_(_ESCAPE):
            return _escape(decisions, alphabet, guess, top)
        for i, candidate in enumerate(near):
            if candidate in near[:i] or abs(candidate - guess) <= _LIMIT:
                continue
            if bin_(_NEIGHBOR + activity // 2 * 4 + i):
                return candidate, pixels[candidate]
    is_minus = bin_(_SIGN + gradients) != flip
    if is_far:
        size = _LIMIT + 1 + decisions.number(_LARGE)
    else:
        size = 1
        while size < _LIMIT and bin_(_SMALL + activity * 3 - 1 + size):
            size += 1
    symbol = min(max(guess - size if is_minus else guess + size, 0), top)
    return symbol, pixels[symbol]


def _escape(
    decisions: _Decisions, alphabet: _Alphabet, guess: int, top: int
) -> tuple[int, bytes]:
    """A pixel that no chain has: the symbol of a near one, and what the channels differ by."""
    symbol = min(max(guess + decisions.signed(_NEAR), 0), top)
    r, g, b = (
        channel + decisions.signed(_CHANNEL + 10 * i)
        for i, channel in enumerate(alphabet.channels[symbol])
    )
    return symbol, alphabet.encode((r, g, b))

"""Payloads of rows of symbols, decoded: see link_rows.md."""

START = bytes.fromhex("""
c6fc0ad3d0e883d9e3f880ff8080808eda4491ad494345488b5d6ccc5ff1a8997786ae3a3744436d
3553bf5fac7e3a88416a727c67757c8d446046347369443d272b4f3d6aa988a1b9c27b8899855f3a
45635962451754a898889ca7773235204530292d242d67417fac979c7265513d2b2a3a30375f305b
7f56886c52667c3c417c5b44923d2a6d25514e102c663d3e8f6773a58f57573242591a3f9ea42e68
3e62a04f2e816450340d2b472f1d434423683d5299587b813553471f255f3435743e2a70416d5720
4a8080806e6651614c2c5a0412c8ebf83f1dc4d6f499678b553b374bf7d92b5957f8f9df3558d2f4
fc7922d9e5f3be617b4c38575ee2c235716bedebc67678dfe2f6ac63c7bee6d267804e4f51800c08
0f176b9233666d80808011384a18494234394977615d5c7066968c70808080358080802e80803522
47552a10e2d5c5b9a88b20011c2683d6c7c9cbd6e9070169606618010180808080a5860412018080
8080805d7d7538018080808080
""")
FLAT, ZERO, SIGN, JUMP, SMALL, NEIGHBOR, LARGE, ESCAPE, NEAR, CHANNEL = (
    0, 12, 210, 276, 284, 308, 324, 332, 333, 343)
MOST = {"Gray8": (255,), "Rgb565": (31, 63, 31)}


def clamp(value, low, high):
    return max(low, min(value, high))


def shaded(color, level, most):
    """The channels of a base colour at a level."""
    return tuple(((2 * c * level + 255) // 510 * m + 127) // 255 for c, m in zip(color, most))


def chains(colors, most):
    """All symbols' pixels."""
    pixels = []
    for color in colors or [(255, 255, 255)]:
        chain = [shaded(color, level, most) for level in range(256)]
        pixels += [p for i, p in enumerate(chain) if i == 0 or p != chain[i - 1]]
    return pixels


class Payload:
    def __init__(self, payload, pixels, most):
        self.p = [start << 8 | 0x80 for start in START]
        self.bytes = iter(payload + bytes(1 << 20))
        self.low, self.high, self.value = 0, 0xFFFFFFFF, 0
        for _ in range(4):
            self.value = self.value << 8 | next(self.bytes)
        self.pixels, self.most, self.top, self.left, self.above = pixels, most, len(pixels) - 1, pixels[0], None

    def split(self, yes):
        middle = self.low + (self.high - self.low >> 12) * yes
        bit = self.value <= middle
        self.low, self.high = (self.low, middle) if bit else (middle + 1, self.high)
        while self.low >> 24 == self.high >> 24:
            self.low = self.low << 8 & 0xFFFFFFFF
            self.high = self.high << 8 & 0xFFFFFFFF | 255
            self.value = self.value << 8 & 0xFFFFFFFF | next(self.bytes)
        return bit

    def bin(self, slot):
        bit = self.split(self.p[slot] >> 4 | 1)
        self.p[slot] += (65535 - self.p[slot] >> 4) if bit else -(self.p[slot] >> 4)
        return bit

    def number(self, slot):
        bits = 0
        while bits < 16 and self.bin(slot + min(bits, 7)):
            bits += 1
        value = 1
        for _ in range(bits):
            value = value << 1 | self.split(2048)
        return value - 1

    def signed(self, slot):
        if self.bin(slot):
            return 0
        minus = self.bin(slot + 1)
        size = 1 + self.number(slot + 2)
        return -size if minus else size

    def other(self, guess, near, gradients, flip, activity):
        """Symbol and pixel, where the symbol isn't the predicted one."""
        far = self.bin(JUMP + activity)
        if far:
            if len(self.most) > 1 and self.bin(ESCAPE):
                symbol = clamp(guess + self.signed(NEAR), 0, self.top)
                pixel = (clamp(c + self.signed(CHANNEL + 10 * i), 0, m)
                         for i, (c, m) in enumerate(zip(self.pixels[symbol], self.most)))
                return symbol, tuple(pixel)
            for i, symbol in enumerate(near):
                if symbol not in near[:i] and abs(symbol - guess) > 4:
                    if self.bin(NEIGHBOR + activity // 2 * 4 + i):
                        return symbol, self.pixels[symbol]
        minus = self.bin(SIGN + gradients) != flip
        size = 1
        if far:
            size = 5 + self.number(LARGE)
        else:
            while size < 4 and self.bin(SMALL + 3 * activity + size - 1):
                size += 1
        symbol = clamp(guess - size if minus else guess + size, 0, self.top)
        return symbol, self.pixels[symbol]

    def row(self, width):
        """The channels of the next row's pixels."""
        first, pixel, row, here = self.above is None, self.left, [], []
        above = [0] * (width + 2) if first else self.above + self.above[-1:] * 2
        w = nw = n = above[0]
        ne, last = above[1], 0
        while len(row) < width:
            x = len(row)
            if w == n == nw == ne:
                end = min(x + 16, width)
                if not first:
                    end = next((i for i in range(x, end) if above[i + 1] != w), end)
                context, same = FLAT + (w == 0) + 2 * first, False
                if end - x < 4:
                    same = self.bin(context + 8)
                elif self.bin(context):
                    row += [pixel] * (end - x)
                    here += [w] * (end - x)
                    last = 0
                    if not first:
                        n, ne = above[end], above[end + 1]
                    continue
                else:
                    while x + 1 < end and self.bin(context + 4):
                        row.append(pixel)
                        here.append(w)
                        x += 1
                    if not first:
                        ne = above[x + 1]
                symbol = w
                if not same:
                    near = [w, w, ne, 0 if first else above[x + 2]]
                    symbol, pixel = self.other(w, near, 0, False, 0)
                last = symbol - w
            else:
                d1, d2, d3 = w - nw, nw - n, n - ne
                smooth = abs(d1) < 16 and abs(d2) < 16
                guess = clamp(w - d2, 0, self.top) if smooth else clamp(w - d2, min(w, n), max(w, n))
                signed = 25 * clamp(d1, -2, 2) + 5 * clamp(d3, -2, 2) + clamp(d2, -2, 2)
                flip, gradients = signed < 0, abs(signed) + 63 * first
                turn = 0 if last == 0 else 1 + ((last < 0) != flip)
                if self.bin(ZERO + 3 * gradients + turn):
                    symbol, pixel = guess, self.pixels[guess]
                else:
                    steepest = max(abs(d1), abs(d2), abs(d3))
                    activity = 2 * sum(steepest > least for least in (0, 1, 4)) + (abs(last) > 1)
                    near = [n, w, ne, 0 if first else above[x + 2]]
                    symbol, pixel = self.other(guess, near, gradients, flip, activity)
                last = symbol - guess
            row.append(pixel)
            here.append(symbol)
            if first:
                n = clamp(2 * symbol - w, 0, self.top) if abs(symbol - w) < 16 else symbol
                nw, ne = symbol, n
            else:
                nw, n, ne = n, ne, above[x + 2]
            w = symbol
        self.left, self.above = row[0], here
        return row


def rows(payload, count, width, kind, colors=()):
    """The channels of all pixels of a payload: a list of rows."""
    most = MOST[kind]
    pixels = [(level,) for level in range(256)] if len(most) == 1 else chains(colors, most)
    decoder = Payload(payload, pixels, most)
    return [decoder.row(width) for _ in range(count)]

"""The package against bytes that no sender sends. `python3 -m unittest discover python/tests`"""

import io
import random
import socket
import struct
import tempfile
import time
import unittest
import warnings
from zlib import crc32

import scancsg
from scancsg import wire


def header(frame: int, width: int, height: int, pixel_format: int = 0, version: int = 2) -> bytes:
    return wire.seal(
        struct.pack("<BBHHHBB", wire.HEADER, version, frame, width, height, pixel_format, 0)
    )


def row(frame: int, y: int, payload: bytes, encoding: int = 0) -> bytes:
    return wire.seal(struct.pack("<BHHB", wire.ROW, frame, y, encoding) + payload)


def end(frame: int, rows: "list[bytes]") -> bytes:
    hashes = (crc32(struct.pack("<H", y) + row) for y, row in enumerate(rows))
    return wire.seal(struct.pack("<BHI", wire.END, frame, sum(hashes) & 0xFFFF_FFFF))


class Wire(unittest.TestCase):
    def test_examples_of_the_documentation(self) -> None:
        request = "00 03 81 01 03 01 07 02 02 06 7f 4a b7 cf e1 00"
        self.assertEqual(wire.request(1, 1, 7, 2, 127), bytes.fromhex(request))
        self.assertEqual(wire.ack(1), bytes.fromhex("00 03 82 01 05 bd 27 eb 04 00"))
        packed = bytes.fromhex("03 02 01 02 08 0c 01 81 34 12 e1 34 12 9b 50 21 d0")
        rows = wire.parse(packed)
        assert isinstance(rows, wire.Rows)
        self.assertEqual(wire.unpack_row(rows, 2), bytes.fromhex("34 12") * 160)

    def test_cobs_there_and_back(self) -> None:
        dice = random.Random(1)
        for length in [0, 1, 253, 254, 255, 508, 600]:
            for zeros in [0.0, 0.01, 0.5]:
                content = bytes(0 if dice.random() < zeros else 7 for _ in range(length))
                coded = wire.cobs_encode(content)
                self.assertNotIn(0, coded)
                self.assertEqual(wire.cobs_decode(coded), content)


class Receiving(unittest.TestCase):
    def setUp(self) -> None:
        self.receiver = scancsg.Receiver()

    def test_rows_in_any_order_make_a_frame(self) -> None:
        rows = [bytes([1, 2, 3]), bytes([4, 5, 6])]
        line = header(7, 3, 2) + row(7, 1, rows[1]) + end(7, rows)
        self.assertEqual(self.receiver.receive(line, 0.0), [])
        self.assertEqual(self.receiver.answers(), wire.request(7, 1, 0, 1, 127))
        (frame,) = self.receiver.receive(row(7, 0, rows[0]), 0.1)
        self.assertEqual(frame.pixels.tolist(), [[1, 2, 3], [4, 5, 6]])
        self.assertEqual(self.receiver.answers(), wire.ack(7))
        # The acknowledgement got lost.
        self.assertEqual(self.receiver.receive(end(7, rows), 0.2), [])
        self.assertEqual(self.receiver.answers(), wire.ack(7))

    def test_a_wrong_hash_asks_for_everything(self) -> None:
        line = header(7, 1, 2) + row(7, 0, b"a") + row(7, 1, b"b") + end(7, [b"a", b"c"])
        self.assertEqual(self.receiver.receive(line, 0.0), [])
        self.assertEqual(self.receiver.answers(), wire.request(7, 1, 0, 2, 127))
        line = row(7, 0, b"a") + row(7, 1, b"b") + end(7, [b"a", b"b"])
        (frame,) = self.receiver.receive(line, 0.1)
        self.assertTrue(frame.is_complete)

    def test_silence(self) -> None:
        self.receiver.receive(header(1, 1, 3) + row(1, 0, b"a"), 0.0)
        self.assertEqual(self.receiver.poll(0.3), [])
        self.assertEqual(self.receiver.answers(), b"")
        self.assertEqual(self.receiver.poll(0.5), [])
        self.assertEqual(self.receiver.answers(), wire.request(1, 1, 1, 2, 127))
        (frame,) = self.receiver.poll(11.0)
        self.assertEqual((frame.is_complete, frame.missing), (False, (1, 2)))
        self.assertEqual(self.receiver.poll(30.0), [])

    def test_a_lost_header_is_asked_for(self) -> None:
        self.receiver.receive(row(9, 0, b"a"), 0.0)
        self.assertEqual(self.receiver.answers(), wire.request(9, 0))
        (frame,) = self.receiver.receive(header(9, 1, 1) + row(9, 0, b"a") + end(9, [b"a"]), 0.1)
        self.assertEqual(frame.id, 9)

    def test_another_version_is_refused_by_name(self) -> None:
        with self.assertRaisesRegex(scancsg.ProtocolError, "version 1"):
            self.receiver.receive(header(1, 1, 1, version=1), 0.0)

    def test_packets_that_do_not_fit(self) -> None:
        bad = [
            header(1, 0, 1), header(1, 1, 0), header(1, 1, 1, 9), header(1, 65535, 65535),
            row(1, 3, b"abc"), row(1, 0, b"ab"), row(1, 0, b"abcd"), row(1, 0, b"\x7fa", 1),
            row(1, 0, b"\x02abc", 2), row(1, 0, b"", 1),
            wire.seal(struct.pack("<BHHB", wire.ROWS, 1, 0, 0)),
            wire.seal(struct.pack("<BHHB", wire.ROWS, 1, 2, 2)),
            wire.seal(struct.pack("<BHHB", wire.ROWS, 1, 0, 1) + bytes([1] * 200)),
            wire.seal(b"\x01"), wire.seal(b"\x03\x01"), wire.seal(b"\x55"), b"\x05\x01\0",
        ]
        self.receiver.receive(header(1, 3, 3), 0.0)
        for count, packet in enumerate(bad, 1):
            self.assertEqual(self.receiver.receive(packet, 0.0), [])
            self.assertEqual(self.receiver.traffic.bad_packets, count, packet)
        rows = [b"abc", b"def", b"ggg"]
        line = row(1, 0, rows[0]) + row(1, 1, rows[1]) + row(1, 2, b"\xfeg", 1) + end(1, rows)
        (frame,) = self.receiver.receive(line, 0.0)
        self.assertEqual(bytes(frame.pixels), b"".join(rows))

    def test_any_bytes(self) -> None:
        dice = random.Random(2)
        for pixel_format in range(4):
            line = bytearray(header(1, 9, 5, pixel_format))
            for _ in range(300):
                kind = dice.choice([wire.ROW, wire.END, wire.ROWS, 0x77])
                line += wire.seal(bytes([kind, 1, 0]) + dice.randbytes(dice.randrange(40)))
                if dice.random() < 0.2:
                    line[dice.randrange(len(line))] ^= 1 << dice.randrange(8)
            receiver = scancsg.Receiver()
            for start in range(0, len(line), 50):
                for frame in receiver.receive(bytes(line[start : start + 50]), start / 100):
                    self.assertEqual(frame.pixels.shape[:2], (5, 9))
                receiver.poll(start / 100)
                receiver.answers()
        endless = self.receiver.receive(b"\x01" * 300_000, 0.0)
        self.assertEqual((endless, self.receiver.traffic.bad_packets), ([], 1))


class Sources(unittest.TestCase):
    LINE = header(5, 2, 1) + row(5, 0, b"ab") + end(5, [b"ab"])

    def test_an_object_that_is_read(self) -> None:
        source = io.BytesIO(self.LINE)
        (frame,) = scancsg.frames(source)
        self.assertEqual(frame.pixels.tolist(), [[97, 98]])
        # Nothing was written into it.
        self.assertEqual(source.getvalue(), self.LINE)

    def test_an_object_that_is_written_gets_answers(self) -> None:
        ends = socket.socketpair()
        with ends[0], ends[1], ends[0].makefile("rwb") as near, ends[1].makefile("rwb") as far:
            far.write(self.LINE)
            far.flush()
            ends[1].shutdown(socket.SHUT_WR)
            (frame,) = scancsg.frames(near)
            self.assertEqual((frame.id, far.read1(100)), (5, wire.ack(5)))

    def test_a_file_on_disk_stays_as_it_is(self) -> None:
        with tempfile.TemporaryFile() as file:
            file.write(self.LINE)
            file.seek(0)
            self.assertEqual(len(list(scancsg.frames(file))), 1)
            file.seek(0)
            self.assertEqual(file.read(), self.LINE)

    def test_no_port(self) -> None:
        with self.assertRaises(OSError):
            next(scancsg.frames("/nowhere/at/all"))

    def test_garbage_is_not_waited_for(self) -> None:
        class Garbage:
            """A port at a wrong speed: it never falls silent."""

            in_waiting = 64

            def read(self, size: int = 1) -> bytes:
                time.sleep(0.001)
                return b"\x55" * size

        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            self.assertEqual(list(scancsg.frames(Garbage(), wait=0.2)), [])

    def test_bytes_but_no_packet(self) -> None:
        with self.assertWarnsRegex(UserWarning, "no packet"):
            self.assertEqual(list(scancsg.frames(io.BytesIO(bytes([7]) * 2000))), [])


if __name__ == "__main__":
    unittest.main()

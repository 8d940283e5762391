"""Receives frames for link.rs: a line for each, of what it is and its pixels in hexadecimal.

Arguments: the port or file, how many complete frames to wait for (0 is all), the line's speed.
"""

import sys

import scancsg


def main(source: str, count: int, baud: int) -> None:
    with scancsg.Link(source, baud=baud, incomplete=True, wait=60) as link:
        complete = 0
        for frame in link:
            shape = "x".join(map(str, frame.pixels.shape))
            missing = ",".join(map(str, frame.missing)) or ("none" if frame.is_complete else "end")
            print(frame.id, frame.header.format.name, shape, missing, frame.pixels.tobytes().hex())
            complete += frame.is_complete
            if count and complete == count:
                break
        traffic = link.traffic
        print("traffic", traffic.frames, traffic.lost, traffic.bad_packets, traffic.requests)


main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))

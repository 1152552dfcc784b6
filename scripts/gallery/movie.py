"""Joins frames, PNG files of one size, into a PNG that moves (APNG) with a palette: movie.py OUT MILLISECONDS FRAME...

Each frame holds the rectangle that differs from the one before. It needs numpy; the frames are 8-bit RGB or RGBA as fabric.render writes them.
"""
import struct
import sys
import zlib

import numpy


def read(path):
    """The pixels of a PNG, (height, width, 3)."""
    with open(path, "rb") as file:
        data = file.read()
    at, parts, kind = 8, b"", None
    while at < len(data):
        size, = struct.unpack(">I", data[at:at + 4])
        name, body = data[at + 4:at + 8], data[at + 8:at + 8 + size]
        if name == b"IHDR":
            width, height, depth, kind = struct.unpack(">IIBB", body[:10])
            if depth != 8 or kind not in (2, 6) or body[12]:
                sys.exit(f"{path}: expected 8-bit RGB or RGBA, not interlaced")
        parts += body if name == b"IDAT" else b""
        at += 12 + size
    n = 3 if kind == 2 else 4
    rows = numpy.frombuffer(zlib.decompress(parts), numpy.uint8).reshape(height, 1 + n * width)
    pixels, above = numpy.zeros((height, n * width), numpy.uint8), numpy.zeros(n * width, numpy.int64)
    for y, (kind, line) in enumerate(zip(rows[:, 0], rows[:, 1:].astype(numpy.int64))):
        if kind == 2:
            line = line + above
        elif kind == 1:
            line = numpy.cumsum(line.reshape(width, n), axis=0).reshape(-1)
        elif kind:
            left, corner = numpy.zeros(n, numpy.int64), numpy.zeros(n, numpy.int64)
            line = line.copy()
            for x in range(0, n * width, n):
                up = above[x:x + n]
                if kind == 3:
                    guess = (left + up) // 2
                else:
                    p = left + up - corner
                    a, b, c = abs(p - left), abs(p - up), abs(p - corner)
                    guess = numpy.where((a <= b) & (a <= c), left, numpy.where(b <= c, up, corner))
                left = line[x:x + n] = (line[x:x + n] + guess) & 255
                corner = up
        above = line & 255
        pixels[y] = above
    return pixels.reshape(height, width, n)[:, :, :3]


def palette_of(frames):
    """256 colours: the commonest of all frames in steps of 8, and for each such step its nearest colour."""
    seen = numpy.bincount(numpy.concatenate([bins(frame).reshape(-1) for frame in frames]), minlength=1 << 15)
    chosen = numpy.argsort(-seen, kind="stable")[:256]
    colours = centres(chosen)
    nearest = numpy.array([((colours - colour) ** 2).sum(axis=1).argmin() for colour in centres(numpy.arange(1 << 15))], numpy.uint8)
    return numpy.minimum(colours, 255).astype(numpy.uint8), nearest


def bins(frame):
    five = frame.astype(numpy.int64) >> 3
    return five[..., 0] << 10 | five[..., 1] << 5 | five[..., 2]


def centres(places):
    five = numpy.stack([places >> 10, places >> 5 & 31, places & 31], axis=-1)
    return (five * 255 + 15) // 31


def chunk(name, body):
    return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))


def main(out, milliseconds, paths):
    frames = [read(path) for path in paths]
    palette, nearest = palette_of(frames)
    images = [nearest[bins(frame)] for frame in frames]
    height, width = images[0].shape
    out_data = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0))
    out_data += chunk(b"acTL", struct.pack(">II", len(images), 0)) + chunk(b"PLTE", palette.tobytes())
    number, before = 0, None
    for k, image in enumerate(images):
        y0, y1, x0, x1 = 0, height, 0, width
        if before is not None:
            rows, columns = numpy.flatnonzero((image != before).any(axis=1)), numpy.flatnonzero((image != before).any(axis=0))
            y0, y1, x0, x1 = (rows[0], rows[-1] + 1, columns[0], columns[-1] + 1) if len(rows) else (0, 1, 0, 1)
        delay = 1500 if k == len(images) - 1 else milliseconds
        out_data += chunk(b"fcTL", struct.pack(">IIIIIHHBB", number, x1 - x0, y1 - y0, x0, y0, delay, 1000, 0, 0))
        number += 1
        piece = image[y0:y1, x0:x1]
        body = zlib.compress(numpy.hstack([numpy.zeros((len(piece), 1), numpy.uint8), piece]).tobytes(), 9)
        if k:
            out_data += chunk(b"fdAT", struct.pack(">I", number) + body)
            number += 1
        else:
            out_data += chunk(b"IDAT", body)
        before = image
    with open(out, "wb") as file:
        file.write(out_data + chunk(b"IEND", b""))


main(sys.argv[1], int(sys.argv[2]), sys.argv[3:])

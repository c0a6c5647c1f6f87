"""Reads the corpus of scenes, and compares pictures of a program with those that are right. Needs NumPy alone.

    python3 corpus.py FOLDER 'my-renderer {scene} {picture} {depth} {primitive}'

runs the command for each scene of the corpus in FOLDER. It writes the picture as PNG (8 bits a channel) or NPY, and may
write depth and primitive as NPY; {depth} and {primitive} can be omitted. Exit code 3 says that it cannot draw a scene.
"""

import collections
import concurrent.futures
import json
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

import numpy

SECONDS = 60
CHANNELS = {0: 1, 2: 3, 4: 2, 6: 4}


def read_png(path):
    """Returns the pixels of a PNG file with 8 bits a channel, not interlaced, as an array (rows, columns, RGBA)."""
    data, at, packed = pathlib.Path(path).read_bytes(), 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at : at + 8])
        if kind == b"IHDR":
            width, height, bits, color, _, _, interlace = struct.unpack(">IIBBBBB", data[at + 8 : at + 21])
        if kind == b"IDAT":
            packed += data[at + 8 : at + 8 + size]
        at += 12 + size
    if bits != 8 or interlace or color not in CHANNELS:
        raise ValueError("not a PNG file with 8 bits a channel")
    step = CHANNELS[color]
    raw = numpy.frombuffer(zlib.decompress(packed), numpy.uint8).reshape(height, 1 + step * width).astype(int)
    rows, above = [], numpy.zeros(step * width, int)
    for line in raw:
        row = line[1:].copy()
        for i in range(len(row)):
            left, up = row[i - step] if i >= step else 0, above[i]
            corner = above[i - step] if i >= step else 0
            nearest = min((left, up, corner), key=lambda value: abs(left + up - corner - value))
            row[i] = (row[i] + (0, left, up, (left + up) // 2, nearest)[line[0]]) % 256
        rows.append(row)
        above = row
    pixels = numpy.array(rows, numpy.uint8).reshape(height, width, step)
    opaque = numpy.full((height, width, 1), 255, numpy.uint8)
    gray = pixels[:, :, [0, 0, 0]] if step < 3 else pixels[:, :, :3]
    return numpy.concatenate([gray, pixels[:, :, step - 1 :] if step in (2, 4) else opaque], axis=2)


def read_picture(path):
    return numpy.load(path) if open(path, "rb").read(6) == b"\x93NUMPY" else read_png(path)


def scenes(folder):
    """Yields the name and the content of each scene, in the order of difficulty."""
    for path in sorted(pathlib.Path(folder).glob("*.json")):
        yield path.stem, json.loads(path.read_text())


def compare(folder, name, picture, depth=None, primitive=None):
    """Returns 'exact', 'within' the tolerance, or in words what is wrong. Arrays have the shape (rows, columns, ...)."""
    base = str(pathlib.Path(folder) / name)
    tolerance = json.loads(open(base + ".json").read())["tolerance"]
    exact, wrong = True, numpy.load(base + "-open.npy") & False
    for what, actual, right, most in (
        ("picture", picture, read_png(base + ".png"), tolerance["color"]),
        ("depth", depth, numpy.load(base + "-depth.npy"), tolerance["depth"]),
        ("primitive", primitive, numpy.load(base + "-primitive.npy"), 0),
    ):
        if actual is None:
            continue
        if actual.shape != right.shape:
            return "the %s has the shape %s, not %s" % (what, actual.shape, right.shape)
        difference = abs(actual.astype(numpy.int64) - right.astype(numpy.int64))
        exact = exact and not difference.any()
        wrong = wrong | ((difference.max(axis=2) if difference.ndim == 3 else difference) > most)
    wrong = wrong & ~numpy.load(base + "-open.npy")
    if not wrong.any():
        return "exact" if exact else "within"
    row, column = numpy.argwhere(wrong)[0]
    return "wrong at %d samples, the first of them in column %d, row %d" % (wrong.sum(), column, row)


def draw(folder, command, name):
    """Runs the command for a scene. Returns its exit code or 'timed out', and, if it is 0, the arrays that it wrote."""
    with tempfile.TemporaryDirectory() as scratch:
        paths = {what: str(pathlib.Path(scratch) / what) for what in ("picture", "depth", "primitive")}
        line = command.format(scene=str(pathlib.Path(folder) / (name + ".json")), **paths)
        with subprocess.Popen(line, shell=True, start_new_session=True) as process:
            try:
                code = process.wait(SECONDS)
            except subprocess.TimeoutExpired:
                (os.killpg if hasattr(os, "killpg") else os.kill)(process.pid, 9)
                code = "timed out"
        asked = [what for what in paths if "{%s}" % what in command] if code == 0 else []
        return code, {what: read_picture(paths[what]) for what in asked}


def run(folder, command, name):
    """Runs the command for a scene, and returns what compare returns, or 'not supported'."""
    try:
        code, arrays = draw(folder, command, name)
    except Exception as bad:
        return "no picture: %r" % bad
    if code:
        return code if code == "timed out" else "not supported" if code == 3 else "exit code %d" % code
    return compare(folder, name, **arrays)


if __name__ == "__main__":
    counts, names = collections.Counter(), [name for name, _ in scenes(sys.argv[1])]
    pool = concurrent.futures.ThreadPoolExecutor(os.cpu_count())
    for name, verdict in zip(names, pool.map(lambda name: run(sys.argv[1], sys.argv[2], name), names)):
        counts[verdict if verdict in ("exact", "within", "not supported") else "wrong"] += 1
        print("%-24s %s" % (name, verdict))
    print(", ".join("%d %s" % (count, verdict) for verdict, count in counts.items()))
    sys.exit(counts["wrong"] > 0)

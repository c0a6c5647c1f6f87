"""Reads the corpus of scenes, and compares pictures of a program with those that are right. Needs NumPy alone.

    python3 corpus.py FOLDER 'my-renderer {scene} {picture} {depth} {primitive}'

runs the command for each scene of the corpus in FOLDER. It writes the picture as PNG (8 bits a channel) or NPY, and may
write depth and primitive as NPY; {depth} and {primitive} can be omitted. Exit code 3 says that it cannot draw a scene.
Each scene has a minute. The exit code is 0 if nothing is wrong, 1 if something is, and 2 if there are no scenes.
"""

import collections
import concurrent.futures
import contextlib
import json
import os
import pathlib
import shlex
import signal
import struct
import subprocess
import sys
import tempfile
import zlib

import numpy

SECONDS = 60
CHANNELS = {0: 1, 2: 3, 4: 2, 6: 4}
FILES = {"picture": "picture.png", "depth": "depth.npy", "primitive": "primitive.npy"}


def read_png(path):
    """Returns the pixels of a PNG file with 8 bits a channel, not interlaced, as an array (rows, columns, RGBA)."""
    data, at, packed, bits = pathlib.Path(path).read_bytes(), 8, b"", 0
    while data[:4] == b"\x89PNG" and at < len(data):
        size, kind = struct.unpack(">I4s", data[at : at + 8])
        if kind == b"IHDR":
            width, height, bits, color, _, _, interlace = struct.unpack(">IIBBBBB", data[at + 8 : at + 21])
        if kind == b"IDAT":
            packed += data[at + 8 : at + 8 + size]
        at += 12 + size
    if bits != 8 or interlace or color not in CHANNELS:
        raise ValueError("it is neither NPY nor PNG with 8 bits a channel")
    step = CHANNELS[color]
    raw = numpy.frombuffer(zlib.decompress(packed), numpy.uint8).reshape(height, 1 + step * width).astype(int)
    above = numpy.zeros(step * width, int)
    for line in raw:
        row = line[1:]
        for i in range(len(row)):
            left, up = row[i - step] if i >= step else 0, above[i]
            corner = above[i - step] if i >= step else 0
            nearest = min((left, up, corner), key=lambda value: abs(left + up - corner - value))
            row[i] = (row[i] + (0, left, up, (left + up) // 2, nearest)[line[0]]) % 256
        above = row
    pixels = raw[:, 1:].astype(numpy.uint8).reshape(height, width, step)
    gray = pixels[:, :, [0, 0, 0]] if step < 3 else pixels[:, :, :3]
    return numpy.dstack([gray, pixels[:, :, -1] if step in (2, 4) else numpy.full_like(pixels[:, :, 0], 255)])


def read_array(path):
    """Returns the array of a file: PNG, or NPY, also if numpy.save has added .npy to the name."""
    path = path if os.path.exists(path) else path + ".npy"
    with open(path, "rb") as file:
        return numpy.load(path) if file.read(6) == b"\x93NUMPY" else read_png(path)


def scenes(folder):
    """Yields the name and the content of each scene, in the order of difficulty."""
    for path in sorted(pathlib.Path(folder).glob("*.json")):
        yield path.stem, json.loads(path.read_text())


def compare(folder, name, picture, depth=None, primitive=None):
    """Returns 'exact', 'within' the tolerance, or what is 'wrong: ...'. Arrays have the shape (rows, columns, ...)."""
    base = os.path.join(folder, name)
    scene = json.loads(pathlib.Path(base + ".json").read_text())
    exact, compared, wrong = True, ~numpy.load(base + "-open.npy"), []
    for what, actual, right, most in (
        ("picture", picture, read_png(base + ".png"), scene["tolerance"]["color"]),
        ("depth", depth, numpy.load(base + "-depth.npy"), scene["tolerance"]["depth"]),
        ("primitive", primitive, numpy.load(base + "-primitive.npy"), 0),
    ):
        if actual is None:
            continue
        if actual.shape != right.shape or actual.dtype.kind not in ("i" if what == "primitive" else "iu"):
            found = actual.dtype, actual.shape, right.dtype, right.shape
            wrong.append("%s has the type %s and the shape %s, not %s and %s" % (what, *found))
            continue
        difference = numpy.dstack([abs(actual.astype(numpy.int64) - right)]).max(axis=2)
        bad = (difference > most) & compared
        exact = exact and not difference.any()
        for row, column in numpy.argwhere(bad)[:1]:
            found = bad.sum(), column, row, actual[row, column].tolist(), right[row, column].tolist()
            wrong.append("%s at %d samples, the first in column %d, row %d: %s, not %s" % (what, *found))
    if wrong:
        return "wrong: %s (rule %s: %s)" % ("; ".join(wrong), scene["rule"], scene["intent"])
    return "exact" if exact else "within"


def draw(folder, command, name):
    """Runs the command for a scene. Returns its exit code or 'timed out', and, if it is 0, the arrays that it wrote."""
    with tempfile.TemporaryDirectory() as scratch:
        paths = {what: os.path.join(scratch, file) for what, file in FILES.items()}
        asked = [what for what in FILES if what == "picture" or "{%s}" % what in command]
        for what, path in {**paths, "scene": os.path.join(folder, name + ".json")}.items():
            command = command.replace("{%s}" % what, shlex.quote(path) if os.name == "posix" else path)
        with subprocess.Popen(command, shell=True, start_new_session=True) as process:
            try:
                code = process.wait(SECONDS)
            except subprocess.TimeoutExpired:
                code = "timed out"
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL) if os.name == "posix" else process.kill()
        return code, {} if code else {what: read_array(paths[what]) for what in asked}


def run(folder, command, name):
    """Runs the command for a scene, and returns what compare returns, 'not supported', or in words how it fails."""
    try:
        code, arrays = draw(folder, command, name)
    except Exception as error:  # a file may have anything in it
        return "wrong: cannot read what was written: %s" % error
    if code:
        return code if code == "timed out" else "not supported" if code == 3 else "exit code %d" % code
    return compare(folder, name, **arrays)


def main(folder, command):
    """Prints a line for each scene, one for each level, and the sum. Returns the exit code."""
    names, levels = [name for name, _ in scenes(folder)], collections.defaultdict(collections.Counter)
    pool = concurrent.futures.ThreadPoolExecutor(os.cpu_count())
    for name, verdict in zip(names, pool.map(lambda name: run(folder, command, name), names)):
        for level in "level %s: " % name.rpartition("-")[0], "":
            levels[level][verdict if verdict in ("exact", "within", "not supported") else "wrong"] += 1
        print("%-24s %s" % (name, verdict), flush=True)
    for level in sorted(levels, key=lambda level: (not level, level)):
        print(level + ", ".join("%d %s" % (count, kind) for kind, count in levels[level].items()))
    if not names:
        print("there are no scenes in", folder, file=sys.stderr)
    return 2 if not names else int(levels[""]["wrong"] > 0)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

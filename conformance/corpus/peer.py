#!/usr/bin/env python3
"""Draws a scene of the corpus with a program of jmh/peers, which draws files of triangles.

    peer.py [--linear] 'COMMAND OF THE PEER' SCENE PICTURE

The peer gets triangles, with linear colours, and writes sRGB, or, with --linear, linear colours. Scenes with more than that
are not supported: exit code 3.
"""

import json
import shlex
import struct
import subprocess
import sys
import tempfile

import numpy

SUPPORTED = {"triangle", "colors", "far-vertices"}


def main():
    words = sys.argv[1:]
    linear = words[0] == "--linear"
    command, scene_file, picture_file = words[linear:]
    with open(scene_file) as file:
        scene = json.load(file)
    if not SUPPORTED.issuperset(scene["tags"]):
        sys.exit(3)

    # A power of two, so that positions between -1 and 1 are exact
    width, height, side = scene["width"], scene["height"], 1
    while side < max(width, height):
        side *= 2
    triangles = b""
    smooth = any("colors" in primitive for primitive in scene["primitives"])
    for primitive in scene["primitives"]:
        colors = primitive.get("colors") or 3 * [primitive["color"]]
        for (x, y, depth), color in zip(primitive["plane"], colors):
            position = x / (128 * side) - 1, 1 - y / (128 * side), depth / 2**30 - 1
            triangles += struct.pack("<3f4B", *position, *color)
    header = struct.pack("<8s4i", b"LZTRI001", int(smooth), 0, 3 * len(scene["primitives"]), 0)
    with tempfile.NamedTemporaryFile() as file, tempfile.NamedTemporaryFile() as picture:
        file.write(header + numpy.eye(4, dtype="<f4").tobytes() + triangles)
        file.flush()
        options = [file.name, "--side", str(side), "--picture", picture.name]
        subprocess.run(shlex.split(command) + options, check=True)
        pixels = numpy.fromfile(picture.name, numpy.uint8).reshape(side, side, 4)[:height, :width]
    if linear:
        light = numpy.arange(256) / 255
        codes = numpy.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
        codes = numpy.floor(255 * codes + 0.5).astype(numpy.uint8)
        pixels = numpy.concatenate([codes[pixels[:, :, :3]], pixels[:, :, 3:]], axis=2)
    with open(picture_file, "wb") as file:
        numpy.save(file, pixels)


main()

#!/usr/bin/env python3
"""Draws a scene of the corpus with a program that draws files of triangles.

    peer.py [--linear] [--also TAGS] [--without TAGS] 'COMMAND OF THE PEER' SCENE PICTURE

The peer is called with a file, --side N and --picture FILE. The file is that of Triangles.java in jmh; if the number
for perspective is 2, the w of each vertex follows, a float by which position and 1 are multiplied. The picture has N
rows of N pixels, red, green, blue and alpha, a byte each, in sRGB, or, with --linear, in linear light. A scene may
have opaque triangles and other convex polygons with one colour, and what is in TAGS, separated by commas: colors,
perspective, depth-test, background; but not what --without says. Exit code 3 says that it has more. A peer with
depth-test and background also gets --depth-test NAME, --background R,G,B,A (from 0 to 1, in linear light) and
--background-depth D (from 0 to 1).
"""

import argparse
import fractions
import json
import shlex
import struct
import subprocess
import sys
import tempfile

BASIC = {"triangle", "polygon", "far-vertices", "fine-depth"}
LEAST_SIDE = 8
NOT_SUPPORTED = 3


def encoded(linear):
    """Returns the sRGB code, from 0 to 255, of a linear component, from 0 to 1."""
    return int(255 * (12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055) + 0.5)


def read(scene_file, tags):
    """Returns the scene; ends the process if it has more than these tags."""
    with open(scene_file) as file:
        scene = json.load(file)
    if not tags.issuperset(scene["tags"]):
        sys.exit(NOT_SUPPORTED)
    return scene


def write(picture_file, width, height, pixels):
    """Writes an NPY file of pixels, which are bytes."""
    head = "{'descr': '|u1', 'fortran_order': False, 'shape': (%d, %d, 4), }" % (height, width)
    with open(picture_file, "wb") as file:
        file.write(b"\x93NUMPY\x01\x00\x76\x00" + head.ljust(117).encode() + b"\n" + pixels)


def area(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def depth(plane, point):
    """Returns the depth of the plane at a point, exactly."""
    a, b, c = plane
    if a[2] == b[2] == c[2]:
        return a[2]
    up = area(c, a, point) * (b[2] - a[2]) + area(a, b, point) * (c[2] - a[2])
    return a[2] + fractions.Fraction(up, area(a, b, c))


def vertices(primitive):
    """Returns x, y, depth, w, colour of the corners of triangles that make up a polygon; None if it is not convex."""
    if "colors" in primitive:
        return [(*at, w, color) for at, w, color in zip(primitive["plane"], primitive["w"], primitive["colors"])]
    corners = [tuple(corner) for corner in primitive["contours"][0]]
    edges = list(zip(corners, corners[1:] + corners[:1]))
    sides = [area(start, end, corner) for start, end in edges for corner in corners]
    if len(primitive["contours"]) > 1 or min(sides) < 0 < max(sides) or len(set(corners)) < len(corners):
        return None
    fan = [corner for i in range(2, len(corners)) for corner in (corners[0], corners[i - 1], corners[i])]
    return [(*at, depth(primitive["plane"], at), 1, primitive["color"]) for at in fan]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--linear", action="store_true")
    parser.add_argument("--also", default="")
    parser.add_argument("--without", default="")
    parser.add_argument("command")
    parser.add_argument("scene")
    parser.add_argument("picture")
    options = parser.parse_args()
    tags = BASIC | set(options.also.split(","))
    scene = read(options.scene, tags - set(options.without.split(",")))

    # A power of two, so that positions between -1 and 1 are exact
    width, height, side = scene["width"], scene["height"], LEAST_SIDE
    while side < max(width, height):
        side *= 2
    polygons = [vertices(primitive) for primitive in scene["primitives"]]
    if None in polygons:
        sys.exit(NOT_SUPPORTED)
    corners = [corner for polygon in polygons for corner in polygon]
    perspective = 2 if "perspective" in scene["tags"] else 0
    triangles = struct.pack("<8s4i", b"LZTRI001", int("colors" in scene["tags"]), perspective, len(corners), 0)
    triangles += struct.pack("<16f", *(float(i % 5 == 0) for i in range(16)))
    for x, y, z, _, color in corners:
        triangles += struct.pack("<3f4B", x / (128 * side) - 1, 1 - y / (128 * side), z / 2**30 - 1, *color)
    if perspective:
        triangles += struct.pack("<%df" % len(corners), *(corner[3] for corner in corners))

    with tempfile.NamedTemporaryFile() as file, tempfile.NamedTemporaryFile() as picture:
        file.write(triangles)
        file.flush()
        words = [file.name, "--side", str(side), "--picture", picture.name]
        if "depth-test" in options.also:
            background = ",".join(str(part / 255) for part in scene["background"])
            words += ["--depth-test", scene["depth_test"], "--background", background]
            words += ["--background-depth", str(scene["background_depth"] / 2**31)]
        subprocess.run(shlex.split(options.command) + words, check=True, stdout=subprocess.DEVNULL)
        rows = picture.read()
    pixels = b"".join(rows[4 * side * y :][: 4 * width] for y in range(height))
    if options.linear:
        pixels = bytes(part if i % 4 == 3 else encoded(part / 255) for i, part in enumerate(pixels))
    write(options.picture, width, height, pixels)


if __name__ == "__main__":
    main()

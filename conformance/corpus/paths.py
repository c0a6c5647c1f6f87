#!/usr/bin/env python3
"""Draws a scene of the corpus with a library for drawings on paper, without antialiasing.

    paths.py cairo|skia SCENE PICTURE

Needs the Python package pycairo or skia-python. The library draws each polygon alone, in black: it decides which
samples this covers. It has no depth: which polygon is visible is decided here.
"""

import sys

import peer

TAGS = {"triangle", "polygon", "far-vertices", "fine-depth", "depth-test", "background"}


def cairo_alpha(contours, fill, width, height):
    import cairo

    surface = cairo.ImageSurface(cairo.FORMAT_A8, width, height)
    context = cairo.Context(surface)
    context.set_antialias(cairo.ANTIALIAS_NONE)
    context.set_fill_rule(cairo.FILL_RULE_EVEN_ODD if fill == "even-odd" else cairo.FILL_RULE_WINDING)
    for contour in contours:
        context.new_sub_path()
        for x, y in contour:
            context.line_to(x / 256, y / 256)
        context.close_path()
    context.fill()
    surface.flush()
    data, stride = surface.get_data(), surface.get_stride()
    return [bytes(data[stride * y :][:width]) for y in range(height)]


def skia_alpha(contours, fill, width, height):
    import skia

    path = skia.Path()
    path.setFillType(skia.PathFillType.kEvenOdd if fill == "even-odd" else skia.PathFillType.kWinding)
    for contour in contours:
        path.addPoly([skia.Point(x / 256, y / 256) for x, y in contour], True)
    surface = skia.Surface(width, height)
    surface.getCanvas().drawPath(path, skia.Paint(AntiAlias=False))
    return surface.toarray()[:, :, 3]


def main():
    library, scene_file, picture_file = sys.argv[1:]
    alpha = {"cairo": cairo_alpha, "skia": skia_alpha}[library]
    scene = peer.read(scene_file, TAGS)
    width, height, test = scene["width"], scene["height"], scene["depth_test"]
    nearer = (lambda a, b: a < b) if test.startswith("less") else (lambda a, b: a > b)
    visible = {(x, y): (scene["background_depth"], scene["background"]) for y in range(height) for x in range(width)}
    for primitive in scene["primitives"]:
        rows = alpha(primitive["contours"], primitive["fill"], width, height)
        for (x, y), (before, _) in visible.items():
            if rows[y][x]:
                depth = round(peer.depth(primitive["plane"], (256 * x + 128, 256 * y + 128)))
                if nearer(depth, before) or test.endswith("or-equal") and depth == before:
                    visible[x, y] = depth, primitive["color"]
    colors = [part for _, color in visible.values() for part in color]
    pixels = bytes(part if i % 4 == 3 else peer.encoded(part / 255) for i, part in enumerate(colors))
    peer.write(picture_file, width, height, pixels)


main()

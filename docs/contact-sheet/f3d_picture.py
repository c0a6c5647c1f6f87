"""Renders a model with the library of f3d.

    f3d_picture.py MODEL SIZE PICTURE [--texture FILE] [--direction X,Y,Z] [OPTION=VALUE ...]

Options are those of the library, with values in JSON, such as render.effect.tone_mapping=true. Without options, all
is as the library has it, except for the white background. X,Y,Z is the direction of view; the camera shows everything.
"""

import argparse
import json

import f3d

parser = argparse.ArgumentParser()
parser.add_argument("model")
parser.add_argument("size", type=int)
parser.add_argument("picture")
parser.add_argument("--texture")
parser.add_argument("--direction")
parser.add_argument("options", nargs="*")
arguments = parser.parse_intermixed_args()

f3d.Log.set_verbose_level(f3d.Log.QUIET)
f3d.Engine.autoload_plugins()
engine = f3d.Engine.create(True)
engine.window.size = arguments.size, arguments.size
engine.options["render.background.color"] = [1.0, 1.0, 1.0]
if arguments.texture:
    engine.options["model.color.texture"] = arguments.texture
for option in arguments.options:
    name, value = option.split("=", 1)
    engine.options[name] = json.loads(value)
engine.scene.add(arguments.model)
if arguments.direction:
    camera = engine.window.camera
    direction = [float(part) for part in arguments.direction.split(",")]
    camera.position = [at - along for at, along in zip(camera.focal_point, direction)]
    camera.reset_to_bounds()
engine.window.render_to_image().save(arguments.picture)

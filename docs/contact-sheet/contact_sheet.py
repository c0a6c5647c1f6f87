"""Renders a folder of models with Lazy Z, f3d and VTK, and puts the pictures side by side into contact sheets.

    python3 contact_sheet.py MODELS --jar zcli.jar --out FOLDER [--size 512] [--rounds 3] [--no-captions] ...

Each picture is made by a process of its own, and is written to FOLDER as MODEL-COLUMN.png; the sheets are sheet-1.png
and so on. README.md in this folder says what the columns are, which programs are needed, and how its sheets
were made.
"""

import argparse
import random
import re
import shutil
import statistics
import subprocess
import sys
import time
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

# What f3d uses for the thumbnails of a file manager, see thumbnail.d/05_all.json of its configuration
THUMBNAIL = (
    "--direction=-1,-0.5,-1 render.effect.antialiasing.mode=\"ssaa\" render.effect.tone_mapping=true"
    " render.effect.blending.mode=\"ddp\" render.hdri.ambient=true"
)
# Title of a column, program, options. To add a column, add a line
COLUMNS = [
    ("Lazy Z", "zcli", ""),
    ("Lazy Z --aa 1", "zcli", "--aa 1"),
    ("Lazy Z --edges", "zcli", "--edges"),
    ("Lazy Z technical", "zcli", "--style technical --hidden-lines dashed"),
    ("Lazy Z section", "zcli", "--cut z=50% --edges"),
    ("Lazy Z wireframe", "zcli", "--wireframe --edge-width 0.5"),
    ("Lazy Z product", "zcli", "--style product"),
    ("f3d", "f3d", ""),
    ("f3d, SSAA", "f3d", 'render.effect.antialiasing.mode="ssaa"'),
    ("f3d, thumbnail", "f3d", THUMBNAIL),
    ("VTK", "vtk", ""),
]
EXTENSIONS = {".obj", ".stl", ".ply", ".glb", ".gltf"}
TIME_LIMIT_SECONDS = 300
GAP = 4


def texture_of(model):
    """The file MODEL_texture.png next to a model, which is the texture of models that name none; or None."""
    file = model.with_name(model.stem + "_texture.png")
    return file if file.is_file() else None


def zcli(arguments, model, size, picture):
    texture = texture_of(model)
    return [
        *(arguments.java, "-jar", arguments.jar, "render", model, "-o", picture),
        *("--size", size, "--background", "white"),
        *(["--texture", texture] if texture else []),
    ]


def f3d(arguments, model, size, picture):
    texture = texture_of(model)
    return [*python(arguments, "f3d"), model, size, picture, *(["--texture", texture] if texture else [])]


def vtk(arguments, model, size, picture):
    texture = texture_of(model)
    return [*python(arguments, "vtk"), model, size, picture, *([texture] if texture else [])]


def python(arguments, program):
    return arguments.python, Path(__file__).with_name(program + "_picture.py")


PROGRAMS = {"zcli": zcli, "f3d": f3d, "vtk": vtk}


def check(arguments):
    """Exits with a message if a program is missing. Returns the version of each."""
    if not Path(arguments.jar).is_file():
        sys.exit(f"no file {arguments.jar}: build it, or name it with --jar")
    f3d_version = "import f3d; print('f3d', f3d.Engine.get_lib_info().version)"
    vtk_version = "import vtk; print('VTK', vtk.VTK_VERSION)"
    commands = {
        "java": [arguments.java, "-jar", arguments.jar, "--version"],
        "f3d": [arguments.python, "-c", f3d_version],
        "vtk": [arguments.python, "-c", vtk_version],
    }
    versions = []
    for program, command in commands.items():
        if not shutil.which(command[0]):
            sys.exit(f"no program {command[0]}: install it, or name another with --java or --python")
        run = subprocess.run(command, capture_output=True, text=True)
        if run.returncode != 0:
            sys.exit(f"{program} does not work, see README.md for what to install:\n{run.stderr.strip()}")
        versions.append(run.stdout.strip().splitlines()[0])
    return ", ".join(versions)


def picture_file(out, model, title):
    return out / f"{model.name}-{re.sub('[^a-z0-9]+', '-', title.lower())}.png"


def render(arguments, model, column):
    """Makes one picture. Returns the seconds of the process, or None if there is no picture, after printing why."""
    title, program, options = column
    picture = picture_file(arguments.out, model, title)
    picture.unlink(missing_ok=True)
    command = [str(part) for part in PROGRAMS[program](arguments, model, arguments.size, picture)] + options.split()
    start = time.perf_counter()
    try:
        run = subprocess.run(command, capture_output=True, text=True, timeout=TIME_LIMIT_SECONDS)
        seconds, message = time.perf_counter() - start, run.stderr.strip() + run.stdout.strip()
    except subprocess.TimeoutExpired:
        seconds, message = TIME_LIMIT_SECONDS, "no picture in time"
    if picture.is_file():
        return seconds
    print(f"{model.name}, {title}: no picture: {message[-1000:]}")
    return None


def blind(arguments, models, columns):
    """Makes a sheet of each model, whose pictures have letters and a random order, and a key.txt that names them."""
    order = random.Random(arguments.blind)
    with open(arguments.out / "key.txt", "w") as key:
        for number, model in enumerate(models, 1):
            mixed = order.sample(columns, len(columns))
            letters = [chr(ord("A") + i) for i in range(len(mixed))]
            sheet(arguments, [model], mixed, arguments.out / f"blind-{number:02}.png", letters)
            key.write(f"{number:02} {model.name}: " + ", ".join(f"{a} {c[0]}" for a, c in zip(letters, mixed)) + "\n")


def shown(arguments, picture, side):
    """What a sheet shows of a picture: its middle, pixel by pixel, or all of it, made smaller."""
    if arguments.detail:
        left, top = (picture.width - side) // 2, (picture.height - side) // 2
        return picture.crop((left, top, left + side, top + side))
    return picture.resize((side, side), Image.Resampling.LANCZOS)


def sheet(arguments, models, columns, file, letters=None):
    """Puts the pictures of some models into one picture, a row each. With letters, nothing else is written on it."""
    side = arguments.detail or arguments.shown or arguments.size
    font = ImageFont.load_default(max(10, side // 12))
    top, left = 2 * font.size, int(max(font.getlength(m.name) for m in models)) + 2 * GAP
    if letters:
        left = 0
    elif arguments.no_captions:
        top, left = 0, 0
    image = Image.new("RGB", (left + len(columns) * (side + GAP), top + len(models) * (side + GAP)), "white")
    draw = ImageDraw.Draw(image)
    for column, (title, _, _) in enumerate(columns):
        x = left + column * (side + GAP)
        if letters or not arguments.no_captions:
            draw.text((x + side / 2, top / 2), letters[column] if letters else title, "black", font, anchor="mm")
        for row, model in enumerate(models):
            y = top + row * (side + GAP)
            picture = picture_file(arguments.out, model, title)
            if picture.is_file():
                with Image.open(picture) as opened:
                    image.paste(shown(arguments, opened.convert("RGB"), side), (x, y))
            else:
                draw.text((x + side / 2, y + side / 2), "no picture", "gray", font, anchor="mm")
            if column == 0 and not letters and not arguments.no_captions:
                draw.text((GAP, y + side / 2), model.name, "black", font, anchor="lm")
    image.save(file, quality=arguments.quality)
    print(f"{file}: {image.width} x {image.height}, {file.stat().st_size / 1e6:.2f} MB")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("models", type=Path, help="folder of models, searched with its sub-folders")
    parser.add_argument("--jar", required=True, help="zcli.jar")
    parser.add_argument("--out", type=Path, required=True, help="folder for pictures and sheets")
    parser.add_argument("--size", type=int, default=512, help="side of each picture in pixels")
    parser.add_argument("--shown", type=int, help="side of each picture in the sheets; default: --size")
    parser.add_argument("--detail", type=int, help="shows only so many pixels of each side, from the middle, unscaled")
    parser.add_argument("--rows", type=int, default=100, help="rows of a sheet at most")
    parser.add_argument("--format", default="png", help="png or jpg")
    parser.add_argument("--quality", type=int, default=90, help="quality of jpg, 1..95")
    parser.add_argument("--rounds", type=int, default=1, help="how often each picture is made; times are medians")
    parser.add_argument("--columns", help="numbers of columns, from 1, separated by commas; default: all")
    parser.add_argument("--no-captions", action="store_true", help="sheets without titles of rows and columns")
    parser.add_argument("--blind", type=int, metavar="SEED", help="sheets of one model, columns in random order")
    parser.add_argument("--only-sheets", action="store_true", help="use the pictures that are in --out")
    parser.add_argument("--java", default="java", help="Java 17 or newer")
    parser.add_argument("--python", default=sys.executable, help="a Python with f3d and vtk; default: this one")
    arguments = parser.parse_args()

    models = [file for file in arguments.models.rglob("*") if file.suffix.lower() in EXTENSIONS]
    models.sort(key=lambda file: file.name.lower())
    if not models:
        sys.exit(f"no models in {arguments.models}")
    wanted = arguments.columns.split(",") if arguments.columns else []
    columns = [column for number, column in enumerate(COLUMNS, 1) if str(number) in wanted or not wanted]
    if not columns:
        sys.exit(f"no columns {arguments.columns}: there are 1 to {len(COLUMNS)}")
    arguments.out.mkdir(parents=True, exist_ok=True)

    if not arguments.only_sheets:
        print(check(arguments))
        seconds = {c: {m: [] for m in models} for c in columns}
        for _ in range(arguments.rounds):
            for model in models:
                for column in columns:
                    seconds[column][model].append(render(arguments, model, column))
        # Compare the programs on the models of which all of them made a picture
        common = [m for m in models if all(None not in seconds[c][m] for c in columns)]
        print(f"\nSeconds a picture: means over {len(common)} models of medians of {arguments.rounds} rounds\n")
        print("| column | seconds | in multiples of the first |\n|---|---|---|")
        means = [statistics.mean(statistics.median(seconds[c][m]) for m in common) for c in columns] if common else []
        for (title, _, _), mean in zip(columns, means):
            print(f"| {title} | {mean:.2f} | {mean / means[0]:.2f} |")

    if arguments.blind is not None:
        blind(arguments, models, columns)
        return
    for number, first in enumerate(range(0, len(models), arguments.rows), 1):
        file = arguments.out / f"sheet-{number}.{arguments.format}"
        sheet(arguments, models[first : first + arguments.rows], columns, file)


if __name__ == "__main__":
    main()

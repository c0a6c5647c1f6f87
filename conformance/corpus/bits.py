#!/usr/bin/env python3
"""Tells for how many scenes of the corpus commands give other bits than the first of them.

    bits.py FOLDER COMMAND COMMAND...

Commands are those of corpus.py: for example the same program with other instructions of the processor.
"""

import collections
import concurrent.futures
import os
import sys

import corpus


def group(name):
    return name.split("-")[1]


def main():
    folder, *commands = sys.argv[1:]
    names = [name for name, _ in corpus.scenes(folder)]
    pool = concurrent.futures.ThreadPoolExecutor(os.cpu_count())
    first = None
    for command in commands:
        drawn = dict(zip(names, pool.map(lambda name: corpus.draw(folder, command, name), names)))
        pictures = {name: arrays["picture"].tobytes() for name, (code, arrays) in drawn.items() if code == 0}
        first = first or pictures
        groups = collections.Counter(group(name) for name in pictures if pictures[name] != first.get(name))
        which = ", ".join("%s %d" % pair for pair in groups.items())
        print("%d of %d other: %s\n    %s" % (groups.total(), len(pictures), which or "none", command), flush=True)


main()

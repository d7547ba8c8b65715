"""What a renderer's own process does: reads what to render from standard input, a line of JSON each, and answers with a
line each to the file descriptor named behind `--`. Standard output is left to what the renderer prints."""
import json
import os
import resource
import sys

import numpy as np

from scene_script import SceneScript


def processor_seconds():
    usage = resource.getrusage(resource.RUSAGE_SELF)
    return usage.ru_utime + usage.ru_stime


def words():
    """The words behind `--` and the descriptor."""
    return sys.argv[sys.argv.index("--") + 2 :]


def serve(about, load):
    """`about` says who renders. `load` makes of a SceneScript what has render(samples, seed, one_line), which returns
    the picture, first row on top, and the processor seconds that it took."""
    with os.fdopen(int(sys.argv[sys.argv.index("--") + 1]), "w", buffering=1) as answers:
        print(json.dumps(about), file=answers)
        scenes = {}
        for line in sys.stdin:
            asked = json.loads(line)
            commands = asked["commands"]
            if commands not in scenes:
                with open(commands) as file:
                    scenes[commands] = load(SceneScript(file.read()))
            picture, seconds = scenes[commands].render(asked["samples"], asked["seed"], asked["one_line"])
            np.save(asked["picture"], picture)
            print(json.dumps(seconds), file=answers)

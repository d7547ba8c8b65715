"""The renderers, all with render(scene, samples, seed, one_line): it returns the picture and the processor seconds."""
import json
import os
import pathlib
import shutil
import subprocess
import sys

import numpy as np

import pictures

here = pathlib.Path(__file__).resolve().parent
root = here.parents[2]

# scenes/reference-*.gr; a-direct is a with direct light only.
all_scenes = ["a", "a-direct", "bas", "c", "d", "e"]

servers = ["cycles", "mitsuba-llvm", "mitsuba-scalar"]

# The metal and the glass of bas are written in Python for Mitsuba, and the scalar variants call that sample by sample.
cannot = {("mitsuba-scalar", "bas")}


def say(message):
    print(f"tools/{os.environ['TOOL']}: {message}", file=sys.stderr)


def fail(message):
    say(message)
    raise SystemExit(1)


class Grsh:
    def __init__(self, program, options):
        self.name = "grsh" if program == root / "grsh" else str(program)
        self.about = f"{self.name} with {' '.join(options)}"
        self.program = program
        self.options = ["exposure", "0", "progress", "off", *options]

    def command(self, scene):
        """What runs commands.tcl, and the options that make the scene what its name says."""
        file, _, direct = scene.partition("-")
        command = [self.program, here / "commands.tcl", root / "scenes" / f"reference-{file}.gr"]
        return command, [*self.options, *(["pathlength", "1"] if direct else [])]

    def commands(self, scene):
        """What the scene's script does."""
        command, options = self.command(scene)
        return subprocess.run([*command, "", *options], check=True, capture_output=True, text=True).stdout

    def render(self, scene, samples, seed, one_line):
        """The time is that of the process, start and end included."""
        command, options = self.command(scene)
        words = ["samplesperpixel", str(samples), "seed", str(seed), *options]
        if one_line:
            words += ["startline", "0", "stopline", "0"]
        process = subprocess.Popen([*command, "grsh.pfm", *words])
        _, status, usage = os.wait4(process.pid, 0)
        if status:
            raise SystemExit(1)  # grsh has said why
        return pictures.read_pfm("grsh.pfm"), usage.ru_utime + usage.ru_stime


class Server:
    """A process that server.py's protocol is spoken with. It knows a scene by the file NAME.commands."""

    def __init__(self, name, command, *words):
        self.name = name
        read, write = os.pipe()
        self.log = open(f"{name}.log", "w+")
        self.process = subprocess.Popen([*command, "--", str(write), *words], stdin=subprocess.PIPE, text=True,
                                        pass_fds=[write], stdout=self.log, stderr=subprocess.STDOUT)
        os.close(write)
        self.answers = os.fdopen(read)
        self.about = self.answer()

    def answer(self):
        line = self.answers.readline()
        if not line:
            self.log.seek(0)
            fail(f"{self.name} ended, exit code {self.process.wait()}. It said:\n{self.log.read()[-3000:]}")
        return json.loads(line)

    def render(self, scene, samples, seed, one_line):
        asked = {"commands": f"{scene}.commands", "samples": samples, "seed": seed, "one_line": one_line,
                 "picture": f"{self.name}.npy"}
        print(json.dumps(asked), file=self.process.stdin, flush=True)
        seconds = self.answer()
        return np.load(asked["picture"]), seconds


def server(name, threads, sampler="independent"):
    if name == "cycles":
        blender = ["blender", "--background", "--factory-startup", "-noaudio", "--python-exit-code", "1", "--python"]
        python = blender if shutil.which("blender") else [sys.executable]
        return Server(name, [*python, here / "cycles_server.py"], threads)
    variant = {"mitsuba-llvm": "llvm_ad_rgb", "mitsuba-scalar": "scalar_rgb"}[name]
    return Server(name, [sys.executable, here / "mitsuba_server.py"], threads, variant, sampler)


def write_commands(grsh, scene):
    pathlib.Path(f"{scene}.commands").write_text(grsh.commands(scene))

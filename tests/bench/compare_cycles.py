# What tools/compare_cycles runs in Blender: renders the reference scenes with Cycles and with grsh, in turn, and prints
# what each made of its processor time. It prints to file descriptor 3: Blender itself talks on standard output.
import argparse
import os
import pathlib
import resource
import statistics
import subprocess
import sys

import bpy
import numpy

here = pathlib.Path(__file__).resolve().parent
sys.path.append(str(here))
from cycles_scene import CyclesScene

root = here.parent.parent

# scenes/reference-*.gr; a-direct is a with direct light only.
all_scenes = ["a", "a-direct", "bas", "c"]

# The references were made with smaller seeds: what shares their noise would look too good.
first_seed = 1000


def say(message):
    print(f"tools/compare_cycles: {message}", file=sys.stderr)


def fail(message):
    say(message)
    raise SystemExit(1)


def processor_seconds(usage):
    return usage.ru_utime + usage.ru_stime


def read_exr(path):
    """Red, green, blue and alpha; the bottom row first, as in a PFM."""
    image = bpy.data.images.load(str(path))
    pixels = numpy.empty(len(image.pixels), numpy.float32)
    image.pixels.foreach_get(pixels)
    size = image.size[1], image.size[0], 4
    bpy.data.images.remove(image)
    return pixels.reshape(size)


def read_pfm(path):
    with open(path, "rb") as file:
        kind, size, scale = file.readline(), file.readline(), file.readline()
        width, height = map(int, size.split())
        order = "<" if float(scale) < 0 else ">"
        return numpy.frombuffer(file.read(), order + "f4").reshape(height, width, 3)


class Reference:
    """A converged picture. Its alpha is 0 where a pixel does not count: at the lamp, whose own light has no noise."""

    def __init__(self, name):
        self.name = name
        picture = read_exr(root / "tests" / "reference" / f"{name}.exr").astype(float)
        self.counts = picture[..., 3] > 0.5
        self.pixels = picture[self.counts, :3]

    def relative_error(self, picture):
        """relMSE: the mean of the squared difference, in proportion to what is there."""
        return ((picture[self.counts] - self.pixels) ** 2 / (self.pixels**2 + 0.01)).mean()

    def mean_ratio(self, picture):
        ratio = picture[self.counts].mean() / self.pixels.mean()
        if not 0.95 < ratio < 1.05:
            fail(f"not the picture of tests/reference/{self.name}.exr: the mean is {ratio:.3f} times that one's")
        return ratio


class Grsh:
    def __init__(self, name, options):
        scene, _, direct = name.partition("-")
        self.command = [root / "grsh", here / "compare_cycles.tcl", root / "scenes" / f"reference-{scene}.gr"]
        self.options = ["exposure", "0", "progress", "off", *options]
        if direct:
            self.options += ["pathlength", "1"]
        self.run(1, 0, one_line=True)  # a wrong option is told now

    def commands(self):
        """What the scene's script does."""
        return subprocess.run([*self.command, "", *self.options], check=True, capture_output=True, text=True).stdout

    def run(self, samples, seed, one_line):
        """The processor seconds of one run, start and end included."""
        words = ["samplesperpixel", str(samples), "seed", str(seed), *self.options]
        if one_line:
            words += ["startline", "0", "stopline", "0"]
        process = subprocess.Popen([*self.command, "grsh.pfm", *words])
        _, status, usage = os.wait4(process.pid, 0)
        if status:
            raise SystemExit(1)  # grsh has said why
        return processor_seconds(usage)

    def picture(self):
        return read_pfm("grsh.pfm")


class Cycles:
    def __init__(self, commands, threads):
        built = CyclesScene(commands)
        self.scene = built.scene
        render, cycles = self.scene.render, self.scene.cycles
        render.engine = "CYCLES"
        render.threads_mode, render.threads = "FIXED", threads
        render.use_compositing = render.use_sequencer = False
        render.filepath = os.path.abspath("cycles.exr")
        file = render.image_settings
        file.file_format, file.color_mode, file.color_depth, file.exr_codec = "OPEN_EXR", "RGB", "32", "NONE"
        # The picture that grsh computes: a pixel is the mean over its square, nothing is clamped, blurred or denoised,
        # and every pixel gets all the samples asked for.
        cycles.pixel_filter_type = "BOX"
        cycles.use_adaptive_sampling = cycles.use_denoising = False
        cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
        cycles.blur_glossy = 0
        cycles.caustics_reflective = cycles.caustics_refractive = True
        # A path of n surface points bounces n - 1 times before light is drawn for the last time.
        bounces = built.path_length - 1
        cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = cycles.transmission_bounces = bounces

    def run(self, samples, seed, one_line):
        """The processor seconds of one render, synchronization of the scene included."""
        self.scene.cycles.samples, self.scene.cycles.seed = samples, seed
        render = self.scene.render
        render.use_border = one_line
        render.border_max_y = 1 / render.resolution_y
        before = processor_seconds(resource.getrusage(resource.RUSAGE_SELF))
        bpy.ops.render.render(scene=self.scene.name, write_still=True)
        return processor_seconds(resource.getrusage(resource.RUSAGE_SELF)) - before

    def picture(self):
        return read_exr("cycles.exr")[..., :3]


def measure(renderer, reference, samples, seed):
    """What one picture shows and costs. The time of one line with one sample is that of all but rendering."""
    start = renderer.run(1, seed, one_line=True)
    seconds = renderer.run(samples, seed, one_line=False) - start
    picture = renderer.picture()
    error = reference.relative_error(picture)
    return {"mean": reference.mean_ratio(picture), "error": error, "seconds": seconds,
            "efficiency": 1 / (error * seconds)}


def row(scene, samples, cycles, grsh):
    """A line of the table: of each renderer's rounds the medians, and the median of the rounds' ratios."""
    cells = [scene, str(samples)]
    for rounds in (cycles, grsh):
        for key, form in (("mean", ".4f"), ("error", ".2e"), ("seconds", ".2f"), ("efficiency", ".3g")):
            cells.append(format(statistics.median(r[key] for r in rounds), form))
    ratios = [ours["efficiency"] / theirs["efficiency"] for theirs, ours in zip(cycles, grsh)]
    cells.append(f"{statistics.median(ratios):.3g} ({min(ratios):.3g} to {max(ratios):.3g})")
    return "| " + " | ".join(cells) + " |"


def count(text):
    if not text.isdigit() or int(text) == 0:
        raise argparse.ArgumentTypeError(f"must be a whole number of at least 1, not {text!r}")
    return int(text)


def arguments():
    parser = argparse.ArgumentParser("tools/compare_cycles", allow_abbrev=False)
    parser.add_argument("samples", nargs="*", type=count, default=[64], help="samples per pixel; default 64")
    parser.add_argument("--scene", action="append", choices=all_scenes, help="may be given again; default: all")
    parser.add_argument("--rounds", type=count, default=5, help="default 5")
    parser.add_argument("--threads", type=count, default=os.cpu_count(), help="of each renderer; default: all cores")
    parser.add_argument("--integrator", help="grsh's; default: its own default")
    return parser.parse_args(sys.argv[sys.argv.index("--") + 1 :])


def main():
    asked = arguments()
    options = ["threads", str(asked.threads)]
    if asked.integrator:
        options += ["integrator", asked.integrator]
    scenes = asked.scene or all_scenes
    renderers, references, results = {}, {}, {}
    for scene in scenes:
        grsh = Grsh(scene, options)
        renderers[scene] = Cycles(grsh.commands(), asked.threads), grsh
        references[scene] = Reference(scene)

    # In rounds, so that what disturbs the machine for a while disturbs both renderers, and no median.
    for turn in range(1, asked.rounds + 1):
        for samples in asked.samples:
            for scene in scenes:
                say(f"round {turn} of {asked.rounds}: {scene}, {samples} samples")
                for renderer in renderers[scene]:
                    result = measure(renderer, references[scene], samples, first_seed + turn)
                    results.setdefault((scene, samples, type(renderer)), []).append(result)

    integrator = f"integrator {asked.integrator}" if asked.integrator else "its default integrator"
    print(f"Cycles of Blender {bpy.app.version_string}, grsh with {integrator}, {asked.rounds} rounds, "
          f"{asked.threads} threads each\n")
    print("| scene | samples | Cycles: mean | relMSE | CPU s | efficiency | grsh: mean | relMSE | CPU s | efficiency "
          "| grsh / Cycles |")
    print("| --- " * 11 + "|")
    for scene in scenes:
        for samples in asked.samples:
            print(row(scene, samples, *(results[scene, samples, kind] for kind in (Cycles, Grsh))))


with os.fdopen(3, "w") as sys.stdout:
    main()

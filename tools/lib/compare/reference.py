"""What tools/reference runs: renders pictures of a reference scene, each with another seed, and adds them to the mean
that is kept in tests/reference/."""
import argparse
import os
import tempfile

import numpy as np

import pictures
import renderers
from command_line import count
from scene_script import SceneScript


class Mean:
    """Of all samples so far. The file's own attributes tell how many they are, and which seeds are used up."""

    def __init__(self, name, anew):
        self.name, self.path = name, pictures.folder / f"{name}.exr"
        self.samples, self.seeds, self.sum, self.made = 0, 0, 0.0, []
        if anew or not self.path.exists():
            return
        reference = pictures.Reference(name)
        header = reference.header
        if "samples" not in header:
            renderers.fail(f"{self.path} does not say how many samples it is made of: nothing can be added to it. "
                           "--anew makes it anew")
        self.samples, self.seeds, self.made = header["samples"], header["seeds"], [header["comments"]]
        self.sum = self.samples * reference.picture[..., :3]

    def add(self, picture, samples):
        self.sum = self.sum + samples * picture.astype(float)
        self.samples += samples
        self.seeds += 1

    def write(self, counts, made):
        pictures.write_reference(self.path, self.sum / self.samples, counts, {
            "samples": self.samples, "seeds": self.seeds, "comments": "; ".join([*self.made, made])})


class Spread:
    """How far the pictures of this run are apart, from which follows how much noise there is in the mean."""

    def __init__(self):
        self.count, self.mean, self.squares = 0, 0.0, 0.0

    def add(self, picture):
        self.count += 1
        change = picture - self.mean
        self.mean = self.mean + change / self.count
        self.squares = self.squares + change * (picture - self.mean)

    def relative_error(self, counts, part):
        """The relMSE of a mean of which one picture is this part."""
        variance = self.squares / (self.count - 1)
        return pictures.relative_error(np.sqrt(variance[counts] * part), self.mean[counts])


def arguments():
    parser = argparse.ArgumentParser("tools/reference", allow_abbrev=False)
    parser.add_argument("scene", choices=renderers.all_scenes)
    parser.add_argument("--renderer", choices=renderers.servers, default="mitsuba-llvm", help="default mitsuba-llvm")
    parser.add_argument("--pictures", type=count, default=4, help="how many to add, each of another seed; default 4")
    parser.add_argument("--samples", type=count, default=256, help="of each picture; default 256")
    parser.add_argument("--threads", type=count, default=os.cpu_count(), help="default: all cores")
    parser.add_argument("--anew", action="store_true", help="forget the samples that there are")
    return parser.parse_args()


def main():
    asked = arguments()
    os.chdir(scratch)
    if (asked.renderer, asked.scene) in renderers.cannot:
        renderers.fail(f"{asked.renderer} cannot render {asked.scene}")
    grsh = renderers.Grsh(renderers.root / "grsh", [])
    commands = grsh.commands(asked.scene)
    renderers.write_commands(grsh, asked.scene)
    script = SceneScript(commands)
    counts = ~pictures.lamp_pixels(script.camera, script.lamps)

    mean, spread = Mean(asked.scene, asked.anew), Spread()
    renderer = renderers.server(asked.renderer, str(asked.threads))
    for number in range(1, asked.pictures + 1):
        picture, seconds = renderer.render(asked.scene, asked.samples, mean.seeds + 1, one_line=False)
        mean.add(picture, asked.samples)
        spread.add(picture)
        mean.write(counts, f"{number} pictures of {asked.samples} samples by {renderer.about}")
        left = ""
        if number > 1:
            left = f", relMSE left {spread.relative_error(counts, asked.samples / mean.samples):.2e}"
        renderers.say(f"{asked.scene}: {number} of {asked.pictures}, {seconds:.1f} CPU s, "
                      f"{mean.samples} samples in all{left}")


with tempfile.TemporaryDirectory() as scratch:
    main()

"""What tools/compare runs: renders the reference scenes with each renderer in turn, and prints what each made of its
processor time."""
import argparse
import os
import pathlib
import statistics
import tempfile

import pictures
import renderers
from command_line import count
from pictures import Reference
from renderers import all_scenes, cannot, fail, say, servers

# The references were made with smaller seeds: what shares their noise would look too good.
first_seed = 100001


def measure(renderer, scene, reference, samples, seed):
    """What one picture shows and costs. The time of one line with one sample is that of all but rendering."""
    _, start = renderer.render(scene, 1, seed, one_line=True)
    picture, seconds = renderer.render(scene, samples, seed, one_line=False)
    ratio = reference.mean_ratio(picture)
    if not 0.95 < ratio < 1.05:
        fail(f"{renderer.name}: not the picture of {reference.path}: the mean is {ratio:.3f} times that one's")
    error = reference.relative_error(picture)
    seconds -= start
    return {"mean": ratio, "error": error, "seconds": seconds, "efficiency": 1 / (error * seconds)}


def row(scene, samples, name, rounds, ours):
    """A line of the table: the medians of the rounds, and the median of the ratios within a round."""
    cells = [scene, str(samples), name]
    for key, form in (("mean", ".4f"), ("error", ".2e"), ("seconds", ".2f"), ("efficiency", ".3g")):
        cells.append(format(statistics.median(r[key] for r in rounds), form))
    ratios = [r["efficiency"] / other["efficiency"] for r, other in zip(ours, rounds)]
    cells.append("" if ours is rounds or not ratios else
                 f"{statistics.median(ratios):.3g} ({min(ratios):.3g} to {max(ratios):.3g})")
    return "| " + " | ".join(cells) + " |"


def program(text):
    path = pathlib.Path(text).resolve()
    if not os.access(path, os.X_OK) or path.is_dir():
        raise argparse.ArgumentTypeError(f"there is no program {text!r}")
    return path


def names(text):
    asked = text.split(",")
    for name in asked:
        if name not in ["grsh", *servers]:
            raise argparse.ArgumentTypeError(f"no such renderer {name!r}: must be some of grsh, {', '.join(servers)}, "
                                             "with commas between them")
    return asked


def arguments():
    parser = argparse.ArgumentParser("tools/compare", allow_abbrev=False)
    parser.add_argument("samples", nargs="*", type=count, default=[64], help="samples per pixel; default 64")
    parser.add_argument("--scene", action="append", choices=all_scenes, help="may be given again; default: all")
    parser.add_argument("--rounds", type=count, default=5, help="default 5")
    parser.add_argument("--threads", type=count, default=os.cpu_count(), help="of each renderer; default: all cores")
    parser.add_argument("--renderers", type=names, default=["grsh", "cycles", "mitsuba-llvm"],
                        help=f"some of grsh,{','.join(servers)}; default: grsh,cycles,mitsuba-llvm")
    parser.add_argument("--grsh", action="append", type=program, default=[], metavar="PROGRAM",
                        help="another grsh to compare with; may be given again")
    parser.add_argument("--integrator", help="grsh's; default: its own default")
    parser.add_argument("--sampler", default="independent", help="Mitsuba's; default: its own default, independent")
    return parser.parse_args()


def main():
    asked = arguments()
    os.chdir(scratch)
    options = ["threads", str(asked.threads)]
    if asked.integrator:
        options += ["integrator", asked.integrator]
    scenes = asked.scene or all_scenes
    for scene in scenes:
        if not (pictures.folder / f"{scene}.exr").exists():
            fail(f"there is no tests/reference/{scene}.exr to compare with: tools/reference {scene} makes it")
    references = {scene: Reference(scene) for scene in scenes}
    own = renderers.Grsh(renderers.root / "grsh", options)
    for scene in scenes:
        renderers.write_commands(own, scene)

    all_renderers = [own] if "grsh" in asked.renderers else []
    all_renderers += [renderers.Grsh(path, options) for path in asked.grsh]
    for renderer in all_renderers:
        renderer.render(scenes[0], 1, 0, one_line=True)  # a wrong option is told now
    all_renderers += [renderers.server(name, str(asked.threads), asked.sampler) for name in servers
                      if name in asked.renderers]

    # In rounds, so that what disturbs the machine for a while disturbs all renderers, and no median.
    results = {}
    for turn in range(asked.rounds):
        for samples in asked.samples:
            for scene in scenes:
                say(f"round {turn + 1} of {asked.rounds}: {scene}, {samples} samples")
                for renderer in all_renderers:
                    if (renderer.name, scene) in cannot:
                        continue
                    result = measure(renderer, scene, references[scene], samples, first_seed + turn)
                    results.setdefault((scene, samples, renderer.name), []).append(result)

    print(f"{asked.rounds} rounds of {'; '.join(renderer.about for renderer in all_renderers)}; {asked.threads} "
          "threads each\n")
    print("| scene | samples | renderer | mean | relMSE | CPU s | efficiency | grsh / this |")
    print("| --- " * 8 + "|")
    for scene in scenes:
        for samples in asked.samples:
            ours = results.get((scene, samples, "grsh"), [])
            for renderer in all_renderers:
                rounds = results.get((scene, samples, renderer.name))
                if rounds:
                    print(row(scene, samples, renderer.name, rounds, ours))


with tempfile.TemporaryDirectory() as scratch:
    main()

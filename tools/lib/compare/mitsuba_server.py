"""Mitsuba 3, as a server. Words: the threads, the variant, and the sampler."""
import drjit
import mitsuba as mi
import numpy as np

from server import processor_seconds, serve, words

threads, variant, sampler = words()
mi.set_variant(variant)
compiled = variant.startswith("llvm")
if compiled:
    import mitsuba_materials  # noqa: F401 (registers them)
import mitsuba_scene

drjit.set_thread_count(int(threads))
drjit.set_flag(drjit.JitFlag.KernelHistory, compiled)


class Mitsuba:
    def __init__(self, script):
        # Of n surface points a path goes on to the lamp: that is n + 1 edges from the camera.
        self.scene = mitsuba_scene.load(script, script.path_length + 1, sampler)

    def once(self, samples, seed, one_line):
        before = processor_seconds()
        picture = mi.render(self.scene, sensor=int(one_line), spp=samples, seed=seed)
        drjit.eval(picture)
        drjit.sync_thread()
        seconds = processor_seconds() - before
        return np.array(picture), seconds

    def render(self, samples, seed, one_line):
        """With LLVM a kernel is compiled for each number of samples: that is not rendering, and done before."""
        while True:
            picture, seconds = self.once(samples, seed, one_line)
            if not compiled or not any(kernel.get("backend_time") for kernel in drjit.kernel_history()):
                return picture, seconds


serve(f"Mitsuba {mi.__version__} ({variant}, {sampler} sampler)", Mitsuba)

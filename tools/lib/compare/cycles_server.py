"""Cycles, Blender's path tracer, as a server. Runs in Blender, or where Blender is a module. Words: the threads."""
import os
import pathlib
import sys

import bpy
import numpy as np

sys.path.append(str(pathlib.Path(__file__).resolve().parent))
from cycles_scene import CyclesScene
from server import processor_seconds, serve, words


class Cycles:
    def __init__(self, script):
        self.scene = CyclesScene(script).scene
        render, cycles = self.scene.render, self.scene.cycles
        render.engine = "CYCLES"
        render.threads_mode, render.threads = "FIXED", int(words()[0])
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
        bounces = script.path_length - 1
        cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = cycles.transmission_bounces = bounces

    def render(self, samples, seed, one_line):
        """The time includes that of Blender's making Cycles' scene of its own: each render does that anew."""
        self.scene.cycles.samples, self.scene.cycles.seed = samples, seed
        render = self.scene.render
        render.use_border = one_line
        render.border_max_y = 1 / render.resolution_y
        before = processor_seconds()
        bpy.ops.render.render(scene=self.scene.name, write_still=True)
        seconds = processor_seconds() - before
        return self.picture(), seconds

    def picture(self):
        image = bpy.data.images.load(self.scene.render.filepath)
        pixels = np.empty(len(image.pixels), np.float32)
        image.pixels.foreach_get(pixels)
        size = image.size[1], image.size[0], 4
        bpy.data.images.remove(image)
        return pixels.reshape(size)[::-1, :, :3]


serve(f"Cycles of Blender {bpy.app.version_string}", Cycles)

"""A jaguar, lying: makes a .blend of it, for Blender 3 and 4, in about a minute.

    blender -b -P scenes/models/jaguar.py -- jaguar.blend
    blender jaguar.blend -b -P tools/export_gr.py -- scenes/models/jaguar.gr

The second command writes jaguar-body.ply, which scenes/final.gr shows. The places here are as they are there, with y
up: it lies on the floor y = 0, is 2.2 long and looks along +z, its head turned to its left, +x. The mesh is one closed
surface. Where the eyes are, which are balls of their own, is printed.
"""
import os
import sys

import bpy
import numpy as np

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "lib"))
import nets
from clay import Clay, turn

EYE = (0.072, 0.040, 0.106, 0.033)
HEAD = (0, 0.71, 0.645)      # the middle of the skull
SIZE = 1.36                  # of the head, as against the numbers below
TURN = (0, 28, -4)           # its nod, turn and tilt


def at_head(p):
    return tuple(HEAD[i] + SIZE * p[i] for i in range(3)) + tuple(SIZE * r for r in p[3:])


def body(clay):
    # Trunk
    clay.limb([(0, 0.30, -0.52, 0.19), (0, 0.315, -0.2, 0.185), (0, 0.325, 0.12, 0.22), (0, 0.335, 0.38, 0.22)], 0.05)
    clay.egg((0, 0.2, -0.05), (0.25, 0.2, 0.55), 0.1)
    clay.egg((0, 0.25, 0.46), (0.18, 0.24, 0.19), 0.1)
    # Neck
    clay.limb([(0, 0.40, 0.34, 0.21), (0, 0.50, 0.46, 0.195), (0, 0.61, 0.56, 0.175), (0, 0.71, 0.62, 0.16)], 0.08)
    with clay.both():
        # Shoulder blade, upper arm
        clay.egg((0.135, 0.42, 0.34), (0.085, 0.20, 0.14), 0.05, (-18, 0, 14))
        clay.limb([(0.17, 0.33, 0.48, 0.125), (0.235, 0.13, 0.28, 0.098)], 0.05)
        # Forearm, paw
        clay.limb([(0.24, 0.105, 0.25, 0.096), (0.225, 0.09, 0.48, 0.08), (0.21, 0.075, 0.76, 0.062)], 0.04)
        paw(clay, 0.205, 0.86, 1.18)
        # Haunch, shank, foot
        clay.limb([(0.11, 0.30, -0.54, 0.165), (0.19, 0.25, -0.32, 0.17), (0.255, 0.20, -0.10, 0.125)], 0.05)
        clay.limb([(0.27, 0.14, -0.12, 0.09), (0.285, 0.075, -0.50, 0.065)], 0.03)
        clay.limb([(0.285, 0.06, -0.55, 0.06), (0.31, 0.055, -0.12, 0.055)], 0.03)
        paw(clay, 0.315, -0.04, 1.05)
    # Tail
    clay.limb([(0, 0.26, -0.62, 0.10), (0.02, 0.10, -0.80, 0.07), (0.16, 0.06, -0.95, 0.06), (0.40, 0.055, -0.90, 0.055),
               (0.57, 0.055, -0.66, 0.052), (0.64, 0.055, -0.36, 0.05), (0.63, 0.065, -0.10, 0.05), (0.55, 0.10, 0.08, 0.048), (0.46, 0.17, 0.13, 0.042)], 0.05)


def paw(clay, x, z, size):
    clay.egg((x, 0.062 * size, z + 0.01), (0.085 * size, 0.066 * size, 0.12 * size), 0.04)
    for dx, dz in ((-0.062, 0.070), (-0.022, 0.105), (0.022, 0.105), (0.062, 0.070)):
        clay.egg((x + dx * size, 0.046 * size, z + dz * size), (0.027 * size, 0.048 * size, 0.052 * size), 0.012, (0, dx * 250, 0))


def head(clay):
    def egg(p, radii, smooth, angles=(0, 0, 0)):
        clay.egg(at_head(p), np.multiply(radii, SIZE), SIZE * smooth, angles)

    def limb(balls, smooth, steps=10):
        clay.limb([at_head(b) for b in balls], SIZE * smooth, steps)

    def lid(balls, smooth):
        limb([(EYE[0] + x, EYE[1] + y, EYE[2] + z, r) for x, y, z, r in balls], smooth)

    with clay.turned(HEAD, *TURN):
        egg((0, 0.03, -0.03), (0.138, 0.118, 0.155), 0.08)
        # Muzzle, bridge and tip of the nose, chin
        egg((0, -0.045, 0.15), (0.083, 0.070, 0.12), 0.05)
        limb([(0, 0.072, 0.06, 0.062), (0, 0.036, 0.16, 0.045), (0, 0.004, 0.235, 0.039)], 0.03)
        egg((0, -0.014, 0.270), (0.043, 0.026, 0.022), 0.012)
        egg((0, -0.112, 0.190), (0.052, 0.038, 0.056), 0.03)
        with clay.both():
            # Cheek, jaw, lip
            egg((0.092, -0.025, 0.020), (0.062, 0.078, 0.095), 0.05)
            limb([(0.072, -0.085, 0.0, 0.06), (0.035, -0.106, 0.17, 0.044)], 0.04)
            egg((0.042, -0.058, 0.222), (0.047, 0.042, 0.055), 0.02)
            # Brow
            limb([(0.030, 0.084, 0.116, 0.020), (0.070, 0.096, 0.098, 0.022), (0.112, 0.080, 0.056, 0.014)], 0.035)
        with clay.pressed(), clay.both():
            egg((0.070, 0.036, 0.138), (0.042, 0.028, 0.024), 0.025, (0, 26, 12))
        with clay.both():
            # Eye, lids
            egg(EYE[:3], (EYE[3],) * 3, 0.004)
            lid([(-0.034, -0.016, 0.024, 0.007), (-0.018, 0.016, 0.028, 0.010), (0.010, 0.026, 0.024, 0.011), (0.034, 0.012, 0.006, 0.008), (0.042, 0.004, -0.006, 0.006)], 0.010)
            lid([(-0.036, -0.020, 0.024, 0.006), (-0.016, -0.016, 0.030, 0.007), (0.010, -0.018, 0.026, 0.008), (0.030, -0.006, 0.012, 0.008), (0.042, 0.004, -0.006, 0.006)], 0.010)
            # Ear
            egg((0.108, 0.128, -0.06), (0.056, 0.064, 0.034), 0.025, (-10, 32, -32))
        with clay.pressed(), clay.both():
            egg((0.119, 0.138, -0.028), (0.039, 0.047, 0.028), 0.012, (-10, 32, -32))
        with clay.pressed():
            # Philtrum, mouth, nostrils
            limb([(0, -0.036, 0.290, 0.005), (0, -0.080, 0.276, 0.007)], 0.007)
            with clay.both():
                limb([(0, -0.084, 0.272, 0.009), (0.034, -0.102, 0.254, 0.010), (0.072, -0.096, 0.200, 0.011), (0.096, -0.080, 0.12, 0.006)], 0.012)
                egg((0.026, -0.020, 0.287), (0.013, 0.009, 0.012), 0.006)


def model(cell):
    clay = Clay((-0.5, -0.03, -1.08), (0.76, 1.1, 1.18), cell)
    body(clay)
    head(clay)
    clay.floor(0)
    vertices, faces = nets.closed(clay.field)
    for _ in range(3):
        vertices = nets.relax(clay.field, vertices, faces)
    return clay.lower + cell * vertices, faces


def eyes():
    """Places of the eyeballs, a little larger than those of clay, and their radius."""
    places = [np.array(HEAD) + turn(*TURN) @ (SIZE * np.multiply(EYE[:3], (side, 1, 1))) for side in (1, -1)]
    return places, 1.05 * SIZE * EYE[3]


def in_blender(vertices, faces, triangles):
    """The mesh as Blender's one object, smooth, with fewer triangles where it is flat. Blender's z axis is up."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    mesh = bpy.data.meshes.new("body")
    mesh.from_pydata(np.stack([vertices[:, 0], -vertices[:, 2], vertices[:, 1]], 1).tolist(), [], faces.tolist())
    body = bpy.data.objects.new("body", mesh)
    bpy.context.collection.objects.link(body)
    fewer = body.modifiers.new("fewer", "DECIMATE")
    fewer.ratio = triangles / (2 * len(faces))
    small = bpy.data.meshes.new_from_object(body.evaluated_get(bpy.context.evaluated_depsgraph_get()))
    body.modifiers.clear()
    body.data = small
    bpy.data.meshes.remove(mesh)
    small.name = "body"
    small.polygons.foreach_set("use_smooth", [True] * len(small.polygons))
    return small


def look_at_it():
    """A camera, without which Blender renders nothing and tools/export_gr.py exports nothing."""
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.location, camera.rotation_euler = (4.5, -5.5, 1.5), (1.45, 0, 0.68)
    bpy.context.collection.objects.link(camera)
    bpy.context.scene.camera = camera


def main():
    words = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
    if len(words) != 1 or not words[0].endswith(".blend"):
        sys.exit("usage: blender -b -P scenes/models/jaguar.py -- jaguar.blend")
    mesh = in_blender(*model(cell=0.007), triangles=84000)
    look_at_it()
    print(len(mesh.polygons), "triangles; eyes", *eyes())
    bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath(words[0]))


if __name__ == "__main__":
    main()

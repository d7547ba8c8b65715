"""A jaguar, lying: makes a .blend of it, for Blender 3 and 4, in half a minute, and beside that a list of its spots.

    blender -b -P scenes/models/jaguar.py -- jaguar.blend
    blender jaguar.blend -b -P tools/export_gr.py -- jaguar.gr

The second command writes jaguar-body.ply. That and jaguar-spots.txt, with x, y, z and radius of a ball for each spot,
are kept beside this script, for scenes/final.gr. Eyes and nose are balls there, too. Places have y up here, as there:
the jaguar lies on the floor y = 0, is 2.2 long, and looks along +z, its head turned to its left, +x. The mesh is one
closed surface.
"""
import os
import sys

import numpy as np

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "lib"))
import blend
import nets
from clay import Clay, spline, turn

HEAD = (0, 0.71, 0.645)    # the middle of the skull
SIZE = 1.36    # of the head, as against its measures below
TURN = (1, 38, -5)    # its nod, turn and tilt, in degrees
EYE = (0.069, 0.034, 0.108, 0.037)    # a ball in the head's measures; in the scene a little larger one covers it
TAIL = [(0, 0.26, -0.62, 0.10), (0.02, 0.10, -0.80, 0.07), (0.16, 0.06, -0.95, 0.06), (0.40, 0.055, -0.90, 0.055),
        (0.57, 0.055, -0.66, 0.052), (0.64, 0.055, -0.36, 0.05), (0.63, 0.065, -0.10, 0.05), (0.55, 0.10, 0.08, 0.048),
        (0.46, 0.17, 0.13, 0.042)]
WHISKERS = [(0.058, -0.054, 0.252), (0.064, -0.070, 0.250), (0.060, -0.086, 0.244), (0.078, -0.058, 0.236),
            (0.084, -0.074, 0.230)]    # a spot for each, on both sides
SPOT = 0.05    # the radius of a spot's ball


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
    clay.limb(TAIL, 0.05)


def paw(clay, x, z, size):
    clay.egg((x, 0.062 * size, z + 0.01), (0.085 * size, 0.066 * size, 0.12 * size), 0.04)
    for dx, dz in ((-0.062, 0.070), (-0.022, 0.105), (0.022, 0.105), (0.062, 0.070)):
        clay.egg((x + dx * size, 0.046 * size, z + dz * size), (0.027 * size, 0.048 * size, 0.052 * size), 0.012,
                 (0, dx * 250, 0))


def head(clay):
    def egg(p, radii, smooth, angles=(0, 0, 0)):
        clay.egg(at_head(p), np.multiply(radii, SIZE), SIZE * smooth, angles)

    def limb(balls, smooth, steps=10):
        clay.limb([at_head(b) for b in balls], SIZE * smooth, steps)

    def lid(balls, smooth):
        limb([(EYE[0] + x, EYE[1] + y, EYE[2] + z, r) for x, y, z, r in balls], smooth)

    with clay.turned(HEAD, *TURN):
        egg((0, 0.03, -0.03), (0.142, 0.116, 0.155), 0.08)
        # Muzzle, bridge and tip of the nose, chin
        egg((0, -0.048, 0.14), (0.083, 0.066, 0.115), 0.05)
        limb([(0, 0.070, 0.055, 0.060), (0, 0.028, 0.155, 0.045), (0, -0.008, 0.222, 0.038)], 0.03)
        egg((0, -0.028, 0.256), (0.043, 0.026, 0.021), 0.012)
        egg((0, -0.110, 0.176), (0.047, 0.034, 0.052), 0.03)
        with clay.both():
            # Cheek, jaw, lip
            egg((0.094, -0.022, 0.015), (0.066, 0.082, 0.095), 0.05)
            limb([(0.074, -0.080, 0.0, 0.06), (0.033, -0.102, 0.16, 0.044)], 0.04)
            egg((0.043, -0.066, 0.208), (0.047, 0.039, 0.052), 0.02)
            # Brow
            limb([(0.034, 0.070, 0.118, 0.016), (0.072, 0.084, 0.098, 0.018), (0.102, 0.076, 0.070, 0.012)], 0.05)
        with clay.pressed(), clay.both():
            egg((0.060, 0.026, 0.142), (0.030, 0.020, 0.012), 0.025, (0, 26, 20))
        with clay.both():
            # Eye, lids
            egg(EYE[:3], (EYE[3],) * 3, 0.003)
            lid([(-0.038, -0.026, 0.022, 0.006), (-0.024, 0.014, 0.032, 0.008), (0.004, 0.032, 0.026, 0.010),
                 (0.034, 0.027, 0.008, 0.009), (0.050, 0.017, -0.012, 0.006)], 0.010)
            lid([(-0.039, -0.029, 0.022, 0.006), (-0.014, -0.030, 0.027, 0.007), (0.014, -0.025, 0.027, 0.007),
                 (0.038, -0.006, 0.012, 0.007), (0.050, 0.014, -0.012, 0.006)], 0.010)
            # Ear
            egg((0.114, 0.122, -0.06), (0.056, 0.062, 0.034), 0.025, (-10, 32, -36))
        with clay.pressed(), clay.both():
            egg((0.125, 0.131, -0.028), (0.039, 0.045, 0.028), 0.012, (-10, 32, -36))
        with clay.pressed():
            # Philtrum, mouth, nostrils
            limb([(0, -0.050, 0.276, 0.006), (0, -0.088, 0.260, 0.010)], 0.006)
            with clay.both():
                limb([(0, -0.090, 0.256, 0.010), (0.034, -0.107, 0.236, 0.011), (0.070, -0.100, 0.185, 0.012),
                      (0.096, -0.080, 0.105, 0.006)], 0.008)
                egg((0.026, -0.034, 0.273), (0.013, 0.009, 0.012), 0.006)


def scattered(points, spacing, chance):
    """Numbers of some of the points, no two of them nearer to each other than that, and others not much farther."""
    free, chosen = np.ones(len(points), bool), []
    for i in chance.permutation(len(points)):
        if free[i]:
            chosen.append(i)
            free &= np.linalg.norm(points - points[i], axis=1) > spacing
    return np.array(chosen)


def rosette(vertices, normals, i, chance):
    """The numbers of five vertices in a ring about the vertex i."""
    across = np.cross(normals[i], (0.3, 0.2, 1))
    along = 1.25 * np.cross(normals[i], across)
    for angle in chance.uniform(0, 6.28) + 1.257 * np.arange(5) + chance.uniform(-0.2, 0.2, 5):
        at = vertices[i] + chance.uniform(0.034, 0.042) * (np.cos(angle) * across + np.sin(angle) * along)
        yield np.linalg.norm(vertices - at, axis=1).argmin()


def coat(vertices, normals):
    """Spots, each a ball of which a little looks out of the clay: rosettes on the trunk, single ones elsewhere."""
    chance = np.random.default_rng(2001)
    x, y, z = vertices.T
    u, v, w = ((vertices - HEAD) @ turn(*TURN) / SIZE).T    # in the head's measures
    brow = (np.abs(u) < 0.065) & (v > 0.09) & (w > -0.02) & (w < 0.10)
    cheek = (np.abs(u) > 0.10) & (v < 0.02) & (v > -0.1) & (w > -0.06) & (w < 0.07)
    skull = np.linalg.norm(vertices - HEAD - turn(*TURN) @ (0, 0.08, 0.08), axis=1) < 0.33
    tail = (z < -0.66) | (x > 0.43)
    free = ~skull & ~tail & (y > 0.12) & (y < 0.86) & (z < 0.74) & (normals[:, 1] > -0.5)
    trunk = free & (y > 0.17) & (z < 0.42)

    def some(where, spacing):
        return np.flatnonzero(where)[scattered(vertices[where], spacing, chance)]

    spots = []
    for i in some(trunk, 0.135):
        spots += [(k, chance.uniform(0.0022, 0.0042)) for k in rosette(vertices, normals, i, chance)]
    spots += [(i, chance.uniform(0.0016, 0.0034)) for i in some(free & ~trunk, 0.066)]
    spots += [(i, chance.uniform(0.0006, 0.0012)) for i in some(brow | cheek, 0.048)]
    balls = [(*(vertices[i] - (SPOT - out) * normals[i]), SPOT) for i, out in spots]
    for place in WHISKERS:
        for side in (1, -1):
            at = HEAD + SIZE * turn(*TURN) @ np.multiply(place, (side, 1, 1))
            i = np.linalg.norm(vertices - at, axis=1).argmin()
            balls.append((*(vertices[i] - 0.009 * normals[i]), 0.01))
    return balls + [(*p, r + 0.004) for *p, r in spline(TAIL, 10)[14::5]]


def model(cell):
    clay = Clay((-0.5, -0.03, -1.08), (0.76, 1.1, 1.18), cell)
    body(clay)
    head(clay)
    clay.floor(0)
    vertices, faces = nets.closed(clay.field)
    for _ in range(3):
        vertices = nets.relax(clay.field, vertices, faces)
    return clay.lower + cell * vertices, faces, nets.normals(clay.field, vertices)


def main():
    words = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
    if len(words) != 1 or not words[0].endswith(".blend"):
        sys.exit("usage: blender -b -P scenes/models/jaguar.py -- jaguar.blend")
    if not os.path.isdir(os.path.dirname(os.path.abspath(words[0]))):
        sys.exit(f'jaguar.py: cannot write "{words[0]}": there is no such folder')
    vertices, faces, normals = model(cell=0.007)
    blend.empty()
    blend.mesh("body", vertices, faces, triangles=84000)
    blend.camera((4.5, 1.5, 5.5), (-0.62, -0.12, -0.77))
    with open(words[0].removesuffix(".blend") + "-spots.txt", "w", encoding="ascii") as file:
        file.writelines("{:.4f} {:.4f} {:.4f} {:.4f}\n".format(*ball) for ball in coat(vertices, normals))
    blend.save(words[0])


if __name__ == "__main__":
    main()

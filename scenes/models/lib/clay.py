# Modelling in clay, with numpy: lumps that are smoothed into each other or pressed out of each other. What stands is
# kept as a field on a grid: the distance to the surface, negative inside. nets.py makes a mesh of it.
#
# A place is (x, y, z), a ball (x, y, z, radius). The last word of most methods is how far the new lump is smoothed into
# what is there before it. clay.tcl is the same idea in Tcl, for fewer triangles.

import contextlib

import numpy as np


def turn(nod, yaw, tilt):
    """A rotation matrix: tilted about z, then turned about y, then nodded about x; in degrees."""
    (a, b, c) = np.radians((nod, yaw, tilt))
    about_x = np.array([[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]])
    about_y = np.array([[np.cos(b), 0, np.sin(b)], [0, 1, 0], [-np.sin(b), 0, np.cos(b)]])
    about_z = np.array([[np.cos(c), -np.sin(c), 0], [np.sin(c), np.cos(c), 0], [0, 0, 1]])
    return about_x @ about_y @ about_z


def spline(balls, steps):
    """A curve through balls (Catmull-Rom), `steps` pieces between two of them; their radii change smoothly, too."""
    p = np.array([balls[0], *balls, balls[-1]], float)
    curve = []
    for i in range(1, len(p) - 2):
        for t in np.arange(steps) / steps:
            curve.append(0.5 * (2 * p[i] + (p[i + 1] - p[i - 1]) * t
                                + (2 * p[i - 1] - 5 * p[i] + 4 * p[i + 1] - p[i + 2]) * t**2
                                + (3 * p[i] - p[i - 1] - 3 * p[i + 1] + p[i + 2]) * t**3))
    return np.array([*curve, p[-2]])


class Clay:
    def __init__(self, lower, upper, cell):
        self.lower = np.array(lower, float)
        self.cell = cell
        counts = np.ceil((np.array(upper) - self.lower) / cell).astype(int) + 1
        self.axes = [self.lower[i] + cell * np.arange(counts[i]) for i in range(3)]
        self.field = np.full(counts, 1.0, np.float32)
        self.sides = (1,)    # the sign of x for each copy of what is made
        self.sign = 1        # -1 where it is pressed out
        self.frame = np.eye(3)
        self.pivot = np.zeros(3)

    @contextlib.contextmanager
    def both(self):
        """What is made within is there twice: as told, and mirrored in the plane x = 0."""
        self.sides = (1, -1)
        yield
        self.sides = (1,)

    @contextlib.contextmanager
    def pressed(self):
        """What is made within is pressed out instead of added."""
        self.sign = -1
        yield
        self.sign = 1

    @contextlib.contextmanager
    def turned(self, pivot, nod, yaw, tilt):
        """What is made within is turned about a place."""
        before = self.frame, self.pivot
        self.frame, self.pivot = turn(nod, yaw, tilt), np.array(pivot, float)
        yield
        self.frame, self.pivot = before

    def place(self, point, side=1):
        """Where a place comes to lie: first by `both`, then by `turned`."""
        return self.pivot + self.frame @ (np.array(point) * (side, 1, 1) - self.pivot)

    def add(self, balls, distance, smooth):
        """Adds the body that `distance` tells of, which lies within balls. Far from it nothing has to be asked."""
        for side in self.sides:
            centres = np.array([self.place(ball[:3], side) for ball in balls])
            reach = np.array([ball[3] for ball in balls])[:, None] + smooth + 3 * self.cell
            low = np.floor(((centres - reach).min(0) - self.lower) / self.cell).astype(int).clip(0)
            high = np.ceil(((centres + reach).max(0) - self.lower) / self.cell).astype(int).clip(0) + 1
            part = tuple(slice(a, b) for a, b in zip(low, high))
            points = np.stack(np.meshgrid(*[axis[s] for axis, s in zip(self.axes, part)], indexing="ij"), -1)
            local = ((points - self.pivot) @ self.frame + self.pivot) * (side, 1, 1)
            self.join(part, distance(local).astype(np.float32), smooth)

    def join(self, part, lump, smooth):
        """The lesser of two distances, rounded where they are nearly alike; pressed out: the greater, likewise."""
        here = self.sign * self.field[part]
        both = np.maximum(smooth - np.abs(here - lump), 0) ** 2 / (4 * max(smooth, 1e-6))
        self.field[part] = self.sign * (np.minimum(here, lump) - both)

    def limb(self, balls, smooth, steps=10):
        """All balls on a curve through some."""
        balls = spline(balls, steps) if len(balls) > 2 else np.array(balls, float)

        def distance(p):
            least = np.full(p.shape[:-1], np.inf)
            for a, b in zip(balls[:-1], balls[1:]):
                along = b[:3] - a[:3]
                t = ((p - a[:3]) @ along / max(along @ along, 1e-12)).clip(0, 1)
                out = np.linalg.norm(p - a[:3] - t[..., None] * along, axis=-1)
                least = np.minimum(least, out - a[3] - t * (b[3] - a[3]))
            return least

        self.add(balls, distance, smooth)

    def egg(self, centre, radii, smooth, angles=(0, 0, 0)):
        """An ellipsoid, turned about its own centre."""
        axes, radii = turn(*angles), np.array(radii, float)

        def distance(p):
            q = (p - centre) @ axes / radii
            k = np.linalg.norm(q, axis=-1)
            return k * (k - 1) / np.maximum(np.linalg.norm(q / radii, axis=-1), 1e-9)

        self.add([(*centre, max(radii))], distance, smooth)

    def floor(self, height):
        """Nothing is below this."""
        self.field = np.maximum(self.field, (height - self.axes[1])[None, :, None].astype(np.float32))

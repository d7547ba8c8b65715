"""What a grsh scene shows, for other renderers: found from the commands of its script, as commands.tcl prints them."""
import math
import re
from collections import namedtuple

import numpy as np

# Places are in the world. A mesh's faces are their corners, all in one list, and how many each face has. A ball is the
# unit ball, moved by a matrix. A lamp is a parallelogram round its centre, with the sides x and z; it shines along down.
# A material is its kind and a dict of its options.
Mesh = namedtuple("Mesh", "vertices corners counts material")
Ball = namedtuple("Ball", "matrix material")
Lamp = namedtuple("Lamp", "radiance centre x z down")
Material = namedtuple("Material", "name kind options")
Camera = namedtuple("Camera", "width height eye right up forward fov lens_radius focus_distance")


def numbers(text):
    return np.array(text.split(), float)


def pairs(options):
    return dict(zip(options[::2], options[1::2]))


def lists(text):
    """A Tcl list of lists of numbers: all numbers in one list, and how many each list has."""
    counts = [len(item.split()) for item in re.split(r"\}\s*\{", text.strip().strip("{}"))]
    return text.replace("{", " ").replace("}", " ").split(), np.array(counts)


def matrix(linear=None, offset=(0, 0, 0)):
    result = np.eye(4)
    if linear is not None:
        result[:3, :3] = linear
    result[:3, 3] = offset
    return result


def moved(transform, points):
    return points @ transform[:3, :3].T + transform[:3, 3]


class Node:
    def __init__(self, parent, make):
        self.parent, self.make = parent, make  # make: of the material and the matrix into the world
        self.matrix = matrix()
        self.material = None

    def world(self):
        return self.parent.world() @ self.matrix if self.parent else self.matrix

    def inherited_material(self):
        return self.material or (self.parent.inherited_material() if self.parent else None)


class SceneScript:
    """Knows the commands of the reference scenes; any other command is an error that names it."""

    def __init__(self, commands):
        self.nodes = {":": Node(None, None)}
        self.materials, self.meshes, self.balls, self.lamps = {}, [], [], []
        for line in commands.splitlines():
            command, *arguments = line.split("\t")
            if not hasattr(self, command):
                raise SystemExit(f"scene_script.py does not know {command}")
            getattr(self, command)(*arguments)
        for node in self.nodes.values():
            if node.make:
                node.make(self.materials.get(node.inherited_material()), node.world())

    def create(self, parent, name, make=None):
        self.nodes[f"{parent.rstrip(':')}:{name}"] = Node(self.nodes[parent], make)

    def create_mesh(self, parent, name, vertices, corners, counts):
        def make(material, world):
            self.meshes.append(Mesh(moved(world, vertices), corners, counts, material))

        self.create(parent, name, make)

    def gr_transform(self, parent, name):
        self.create(parent, name)

    def gr_polyhedron(self, parent, name, vertices, faces):
        corners, counts = lists(faces)
        places = np.array(lists(vertices)[0], float).reshape(-1, 3)
        self.create_mesh(parent, name, places, np.array(corners, int), counts)

    def gr_box(self, parent, name, corner, size):
        corner, size = numbers(corner), numbers(size)
        vertices = np.array([[corner[axis] + (bits >> axis & 1) * size[axis] for axis in range(3)]
                             for bits in range(8)])
        faces = np.array([(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)])
        self.create_mesh(parent, name, vertices, faces.ravel(), np.full(6, 4))

    def gr_sphere(self, parent, name, centre, radius):
        place = matrix(float(radius) * np.eye(3), numbers(centre))
        self.create(parent, name, lambda material, world: self.balls.append(Ball(world @ place, material)))

    def gr_als_planar(self, parent, name, radiance, centre, size):
        radiance, centre, size = numbers(radiance), numbers(centre), float(size)

        def make(_, world):
            x, z = size * world[:3, 0], size * world[:3, 2]
            down = np.cross(x, z) / np.linalg.norm(np.cross(x, z))
            self.lamps.append(Lamp(radiance, moved(world, centre), x, z, down))

        self.create(parent, name, make)

    def transform(self, node, by):
        self.nodes[node].matrix = self.nodes[node].matrix @ by

    def gr_translate(self, node, offset):
        self.transform(node, matrix(offset=numbers(offset)))

    def gr_rotate(self, node, axis, degrees):
        cos, sin = math.cos(math.radians(float(degrees))), math.sin(math.radians(float(degrees)))
        first, second = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
        turn = np.eye(3)
        turn[first, first], turn[first, second], turn[second, first], turn[second, second] = cos, -sin, sin, cos
        self.transform(node, matrix(turn))

    def gr_scale(self, node, factors):
        self.transform(node, matrix(np.diag(numbers(factors))))

    def gr_surfaceproperty(self, node, material):
        self.nodes[node].material = material

    def gr_material(self, name, kind, *options):
        self.materials[name] = Material(name, kind, {key: numbers(value) for key, value in pairs(options).items()})

    def gr_render(self, node, file, width, height, eye, view, up, fov, *options):
        options = pairs(options)
        if options.get("projection", "perspective") != "perspective":
            raise SystemExit(f"scene_script.py does not know projection {options['projection']}")
        self.path_length = int(options["pathlength"])
        forward = numbers(view) / np.linalg.norm(numbers(view))
        right = np.cross(forward, numbers(up))
        right /= np.linalg.norm(right)
        lens = options.get("depthoffield") == "on"
        self.camera = Camera(int(width), int(height), numbers(eye), right, np.cross(right, forward), forward,
                             math.radians(float(fov)), float(options["aperture"]) if lens else 0,
                             float(options["focaldistance"]) if lens else 1)

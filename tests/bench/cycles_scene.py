# A grsh scene in Blender, for Cycles: built from the commands of its script, as compare_cycles.tcl prints them.
import math
import re

import bmesh
import bpy
from mathutils import Matrix, Vector


def words(line):
    """A line of Tcl as nested lists of words; braces make a list."""
    stack = [[]]
    for token in re.findall(r"[{}]|[^\s{}]+", line):
        if token == "{":
            stack.append([])
        elif token == "}":
            stack[-2].append(stack.pop())
        else:
            stack[-1].append(token)
    return stack[0]


def numbers(texts):
    return [float(text) for text in texts]


def pairs(options):
    return dict(zip(options[::2], options[1::2]))


def polygons(vertices, faces):
    mesh = bpy.data.meshes.new("grsh")
    mesh.from_pydata(vertices, [], faces)
    return mesh


def fine_ball():
    """Cycles has no spheres that glass could fill: one of so many triangles, shaded smoothly, that it is as round."""
    ball = bmesh.new()
    bmesh.ops.create_icosphere(ball, subdivisions=7, radius=1)
    mesh = bpy.data.meshes.new("grsh")
    ball.to_mesh(mesh)
    ball.free()
    mesh.polygons.foreach_set("use_smooth", [True] * len(mesh.polygons))
    return mesh


def shader(kind, socket="Surface", material=None, **inputs):
    """A material of one shader node, or a node more for a material. Returns both."""
    if material is None:
        material = bpy.data.materials.new("grsh")
        material.use_nodes = True
        material.node_tree.nodes.remove(material.node_tree.nodes["Principled BSDF"])
    tree = material.node_tree
    node = tree.nodes.new(kind)
    for key, value in inputs.items():
        node.inputs[key].default_value = value
    tree.links.new(node.outputs[0], tree.nodes["Material Output"].inputs[socket])
    return material, node


class Node:
    def __init__(self, parent, make):
        self.parent, self.make = parent, make  # make: of the material and the matrix into the world, an object
        self.matrix = Matrix()
        self.material = None

    def world(self):
        return self.parent.world() @ self.matrix if self.parent else self.matrix

    def inherited_material(self):
        return self.material or (self.parent.inherited_material() if self.parent else None)


class CyclesScene:
    """Knows the commands and materials of the reference scenes; any other command is an error that names it."""

    def __init__(self, commands):
        self.scene = bpy.data.scenes.new("grsh")
        self.nodes = {":": Node(None, None)}
        self.materials = {}
        for line in commands.splitlines():
            command, *arguments = words(line)
            if not hasattr(self, command):
                raise SystemExit(f"tools/compare_cycles: cycles_scene.py does not know {command}")
            getattr(self, command)(*arguments)
        for node in self.nodes.values():
            if node.make:
                node.make(self.materials.get(node.inherited_material()), node.world())

    def link(self, data, matrix=Matrix()):
        item = bpy.data.objects.new("grsh", data)
        item.matrix_world = matrix
        self.scene.collection.objects.link(item)
        return item

    def create(self, parent, name, make=None):
        self.nodes[f"{parent.rstrip(':')}:{name}"] = Node(self.nodes[parent], make)

    def create_mesh(self, parent, name, mesh):
        def make(material, matrix):
            mesh.transform(matrix)
            mesh.materials.append(material)
            self.link(mesh)

        self.create(parent, name, make)

    def gr_transform(self, parent, name):
        self.create(parent, name)

    def gr_polyhedron(self, parent, name, vertices, faces):
        self.create_mesh(parent, name, polygons([numbers(v) for v in vertices], [[int(i) for i in f] for f in faces]))

    def gr_box(self, parent, name, corner, size):
        corner, size = numbers(corner), numbers(size)
        vertices = [[corner[axis] + (bits >> axis & 1) * size[axis] for axis in range(3)] for bits in range(8)]
        faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
        self.create_mesh(parent, name, polygons(vertices, faces))

    def gr_sphere(self, parent, name, centre, radius):
        ball = fine_ball()
        ball.transform(Matrix.Translation(numbers(centre)) @ Matrix.Scale(float(radius), 4))
        self.create_mesh(parent, name, ball)

    def gr_als_planar(self, parent, name, radiance, centre, size):
        radiance, centre, size = numbers(radiance), Vector(numbers(centre)), float(size)

        def make(_, matrix):
            x, z = (matrix.to_3x3() @ Vector(side) * size for side in ((1, 0, 0), (0, 0, 1)))
            down, place = x.cross(z).normalized(), matrix @ centre
            lamp = bpy.data.lights.new("grsh", "AREA")
            lamp.shape, lamp.size, lamp.size_y = "RECTANGLE", x.length, z.length
            # Radiance is energy times colour, divided by four times the area.
            lamp.energy, lamp.color = 4 * x.length * z.length, radiance
            # It shines along its own -z.
            axes = Matrix((x.normalized(), z.normalized(), -down)).transposed().to_4x4()
            self.link(lamp, Matrix.Translation(place) @ axes)
            # Light passes Cycles' lamps from behind, while ours are black there.
            back = place - down * 1e-4 * math.sqrt(x.length * z.length)
            corners = [back + a * x + b * z for a, b in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5))]
            plate = polygons(corners, [(0, 1, 2, 3)])
            plate.materials.append(shader("ShaderNodeBsdfDiffuse", Color=(0, 0, 0, 1))[0])
            self.link(plate)

        self.create(parent, name, make)

    def gr_translate(self, node, offset):
        self.nodes[node].matrix @= Matrix.Translation(numbers(offset))

    def gr_rotate(self, node, axis, degrees):
        self.nodes[node].matrix @= Matrix.Rotation(math.radians(float(degrees)), 4, axis.upper())

    def gr_scale(self, node, factors):
        self.nodes[node].matrix @= Matrix.Diagonal(numbers(factors) + [1])

    def gr_surfaceproperty(self, node, material):
        self.nodes[node].material = material

    def gr_material(self, name, kind, *options):
        self.materials[name] = getattr(self, kind)(**pairs(options))

    def diffuse(self, diffuse):
        return shader("ShaderNodeBsdfDiffuse", Color=numbers(diffuse) + [1])[0]

    def dielectric(self, n, beers):
        material, glass = shader("ShaderNodeBsdfGlass", Color=(1, 1, 1, 1), IOR=float(n))
        glass.distribution = "SHARP"
        # Absorption is density times 1 - colour.
        beers = numbers(beers)
        density = max(beers)
        colour = [1 - a / density for a in beers] + [1]
        return shader("ShaderNodeVolumeAbsorption", "Volume", material, Color=colour, Density=density)[0]

    def shirley(self, diffuse, specular, exp):
        if any(numbers(diffuse)) or exp[0] != exp[1]:
            raise SystemExit("tools/compare_cycles: cycles_scene.py knows shirley only as metal with one exponent")
        # Cycles' exponent is 2/a^2 - 2, where a is the roughness squared.
        roughness = (2 / (float(exp[0]) + 2)) ** 0.25
        material, metal = shader("ShaderNodeBsdfGlossy", Color=numbers(specular) + [1], Roughness=roughness)
        metal.distribution = "ASHIKHMIN_SHIRLEY"
        return material

    def gr_render(self, node, file, width, height, eye, view, up, fov, *options):
        options = pairs(options)
        self.path_length = int(options["pathlength"])
        camera = bpy.data.cameras.new("grsh")
        camera.sensor_fit, camera.angle = "VERTICAL", math.radians(float(fov))
        camera.clip_start, camera.clip_end = 1e-3, 1e5
        if options.get("depthoffield") == "on":
            camera.dof.use_dof = True
            camera.dof.focus_distance = float(options["focaldistance"])
            # The lens's radius is half its focal length, here in mm, through the f-stop.
            camera.dof.aperture_fstop = camera.lens * 1e-3 / (2 * float(options["aperture"]))
        forward = Vector(numbers(view)).normalized()
        right = forward.cross(Vector(numbers(up))).normalized()
        axes = Matrix((right, right.cross(forward), -forward)).transposed().to_4x4()
        self.scene.camera = self.link(camera, Matrix.Translation(numbers(eye)) @ axes)
        self.scene.render.resolution_x, self.scene.render.resolution_y = int(width), int(height)

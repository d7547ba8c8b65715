"""A grsh scene in Blender, for Cycles."""
import math

import bmesh
import bpy
import numpy as np
from mathutils import Matrix, Vector


def mesh_of(vertices, corners, counts):
    mesh = bpy.data.meshes.new("grsh")
    faces = [face.tolist() for face in np.split(corners, np.cumsum(counts)[:-1])]
    mesh.from_pydata(vertices.tolist(), [], faces)
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


def rgba(colour):
    return [*colour, 1]


def diffuse(diffuse):
    return shader("ShaderNodeBsdfDiffuse", Color=rgba(diffuse))[0]


def dielectric(n, beers):
    material, glass = shader("ShaderNodeBsdfGlass", Color=(1, 1, 1, 1), IOR=float(n[0]), Roughness=0)
    if bpy.app.version < (4, 0, 0):  # later, all that is not rough is sharp
        glass.distribution = "SHARP"
    # Absorption is density times 1 - colour.
    density = max(beers)
    colour = rgba(1 - beers / density)
    return shader("ShaderNodeVolumeAbsorption", "Volume", material, Color=colour, Density=density)[0]


def shirley(diffuse, specular, exp):
    if any(diffuse) or exp[0] != exp[1]:
        raise SystemExit("cycles_scene.py knows shirley only as metal with one exponent")
    # Cycles' exponent is 2/a^2 - 2, where a is the roughness squared.
    roughness = (2 / (exp[0] + 2)) ** 0.25
    material, metal = shader("ShaderNodeBsdfGlossy", Color=rgba(specular), Roughness=roughness)
    metal.distribution = "ASHIKHMIN_SHIRLEY"
    return material


materials = {"diffuse": diffuse, "dielectric": dielectric, "shirley": shirley}


class CyclesScene:
    def __init__(self, script):
        self.scene = bpy.data.scenes.new("grsh")
        made = {name: materials[m.kind](**m.options) for name, m in script.materials.items()}
        for mesh in script.meshes:
            self.link_mesh(mesh_of(*mesh[:3]), made[mesh.material.name])
        for ball in script.balls:
            mesh = fine_ball()
            mesh.transform(Matrix(ball.matrix.tolist()))
            self.link_mesh(mesh, made[ball.material.name])
        for lamp in script.lamps:
            self.link_lamp(lamp)
        self.link_camera(script.camera)

    def link(self, data, place=Matrix()):
        item = bpy.data.objects.new("grsh", data)
        item.matrix_world = place
        self.scene.collection.objects.link(item)
        return item

    def link_mesh(self, mesh, material):
        mesh.materials.append(material)
        self.link(mesh)

    def link_lamp(self, lamp):
        x, z, down, centre = (Vector(v) for v in (lamp.x, lamp.z, lamp.down, lamp.centre))
        light = bpy.data.lights.new("grsh", "AREA")
        light.shape, light.size, light.size_y = "RECTANGLE", x.length, z.length
        # Radiance is energy times colour, divided by four times the area; by pi times the area in Blender 5.
        part = 4 if bpy.app.version < (5, 0, 0) else math.pi
        light.energy, light.color = part * x.length * z.length, lamp.radiance
        # It shines along its own -z.
        axes = Matrix((x.normalized(), z.normalized(), -down)).transposed().to_4x4()
        self.link(light, Matrix.Translation(centre) @ axes)
        # Light passes Cycles' lamps from behind, while ours are black there.
        back = lamp.centre - lamp.down * 1e-4 * math.sqrt(x.length * z.length)
        corners = [back + a * lamp.x + b * lamp.z for a, b in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5))]
        self.link_mesh(mesh_of(np.array(corners), np.arange(4), np.array([4])), diffuse((0, 0, 0)))

    def link_camera(self, camera):
        item = bpy.data.cameras.new("grsh")
        item.sensor_fit, item.angle = "VERTICAL", camera.fov
        item.clip_start, item.clip_end = 1e-3, 1e5
        if camera.lens_radius:
            item.dof.use_dof = True
            item.dof.focus_distance = camera.focus_distance
            # The lens's radius is half its focal length, here in mm, through the f-stop.
            item.dof.aperture_fstop = item.lens * 1e-3 / (2 * camera.lens_radius)
        axes = Matrix((camera.right, camera.up, -camera.forward)).transposed().to_4x4()
        self.scene.camera = self.link(item, Matrix.Translation(camera.eye) @ axes)
        self.scene.render.resolution_x, self.scene.render.resolution_y = camera.width, camera.height

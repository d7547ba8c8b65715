# A model as a Blender file. Places are given with y up; Blender's z axis is up.

import os

import bpy
import numpy as np
from mathutils import Vector


def z_up(places):
    x, y, z = np.asarray(places).T
    return np.stack([x, -z, y], -1).tolist()


def empty():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.scene.view_settings.view_transform = "Standard"


def mesh(name, vertices, faces, triangles):
    """A smooth mesh of about so many triangles: where it is flat there are fewer than given."""
    whole = bpy.data.meshes.new(name)
    whole.from_pydata(z_up(vertices), [], faces.tolist())
    thing = bpy.data.objects.new(name, whole)
    bpy.context.collection.objects.link(thing)
    thing.modifiers.new("fewer", "DECIMATE").ratio = triangles / (2 * len(faces))
    thing.data = bpy.data.meshes.new_from_object(thing.evaluated_get(bpy.context.evaluated_depsgraph_get()))
    thing.modifiers.clear()
    bpy.data.meshes.remove(whole)
    thing.data.polygons.foreach_set("use_smooth", [True] * len(thing.data.polygons))
    thing.data.name = name


def camera(eye, view):
    """Without one Blender renders nothing, and tools/export_gr.py exports nothing."""
    thing = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    thing.location = z_up(eye)
    thing.rotation_euler = Vector(z_up(view)).to_track_quat("-Z", "Y").to_euler()
    bpy.context.collection.objects.link(thing)
    bpy.context.scene.camera = thing


def save(path):
    bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath(path))

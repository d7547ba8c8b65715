"""A grsh scene for Mitsuba 3."""
import math

import mitsuba as mi
import numpy as np


def rgb(colour):
    return {"type": "rgb", "value": [float(part) for part in colour]}


def diffuse(diffuse):
    return {"type": "twosided", "inner": {"type": "diffuse", "reflectance": rgb(diffuse)}}


def dielectric(n, beers):
    return {"type": "grsh_glass", "n": float(n[0]), "beers": mi.ScalarColor3f(beers.tolist())}


def shirley(diffuse, specular, exp):
    if any(diffuse) or exp[0] != exp[1]:
        raise SystemExit("mitsuba_scene.py knows shirley only as metal with one exponent")
    return {"type": "grsh_metal", "exponent": float(exp[0]), "colour": mi.ScalarColor3f(specular.tolist())}


materials = {"diffuse": diffuse, "dielectric": dielectric, "shirley": shirley}


def triangles(corners, counts):
    """Convex faces, each cut into a fan."""
    if (counts == 3).all():
        return corners.reshape(-1, 3)
    faces = np.split(corners, np.cumsum(counts)[:-1])
    return np.array([(face[0], *face[i : i + 2]) for face in faces for i in range(1, len(face) - 1)])


def flat_mesh(mesh, material):
    faces = triangles(mesh.corners, mesh.counts)
    properties = mi.Properties()
    properties["bsdf"] = material
    properties["face_normals"] = True
    made = mi.Mesh("grsh", len(mesh.vertices), len(faces), props=properties)
    parameters = mi.traverse(made)
    parameters["vertex_positions"] = mesh.vertices.astype(np.float32).ravel()
    parameters["faces"] = faces.astype(np.uint32).ravel()
    parameters.update()
    return made


def transform(*columns):
    """Of the three axes and the origin."""
    return mi.ScalarTransform4f([[*(float(column[row]) for column in columns)] for row in range(3)] + [[0, 0, 0, 1]])


def emitter(lamp):
    """A square of side 2, which shines along its z: its back is black as all lamps are that light falls on."""
    return {"type": "rectangle", "to_world": transform(lamp.x / 2, lamp.z / 2, lamp.down, lamp.centre),
            "material": {"type": "diffuse", "reflectance": rgb((0, 0, 0))},
            "light": {"type": "area", "radiance": rgb(lamp.radiance)}}


def sensor(camera, lines, sampler):
    # Mitsuba's camera looks along its z and has its x on the left.
    made = {"type": "perspective", "fov_axis": "y", "fov": math.degrees(camera.fov), "near_clip": 1e-2, "far_clip": 1e5,
            "to_world": transform(-camera.right, camera.up, camera.forward, camera.eye),
            "sampler": {"type": sampler},
            "film": {"type": "hdrfilm", "width": camera.width, "height": camera.height, "crop_width": camera.width,
                     "crop_height": lines, "component_format": "float32", "pixel_format": "rgb",
                     "filter": {"type": "box"}}}
    if camera.lens_radius:
        made |= {"type": "thinlens", "aperture_radius": camera.lens_radius, "focus_distance": camera.focus_distance}
    return made


def load(script, path_edges, sampler):
    """The scene with two sensors, for the whole picture and for its first line. `path_edges`: what Mitsuba counts, one
    more than surface points."""
    scene = {"type": "scene", "integrator": {"type": "path", "max_depth": path_edges, "hide_emitters": False}}
    made = {name: mi.load_dict(materials[m.kind](**m.options)) for name, m in script.materials.items()}
    for i, mesh in enumerate(script.meshes):
        scene[f"mesh{i}"] = flat_mesh(mesh, made[mesh.material.name])
    for i, ball in enumerate(script.balls):
        scene[f"ball{i}"] = {"type": "sphere", "to_world": mi.ScalarTransform4f(ball.matrix.tolist()),
                             "material": made[ball.material.name]}
    for i, lamp in enumerate(script.lamps):
        scene[f"lamp{i}"] = emitter(lamp)
    scene["whole"] = sensor(script.camera, script.camera.height, sampler)
    scene["line"] = sensor(script.camera, 1, sampler)
    return mi.load_dict(scene)

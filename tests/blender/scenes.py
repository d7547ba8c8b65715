"""What export.test exports: blender -b --factory-startup -P scenes.py -- NAME ... writes NAME.blend, and NAME.pfm as
Cycles renders it where there is something to compare."""
import math
import os
import sys

import bpy
import numpy
from mathutils import Matrix, Vector


def start() -> bpy.types.Scene:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.world = bpy.data.worlds.new("World")
    scene.world.color = 0.15, 0.18, 0.25
    scene.view_settings.view_transform = "Standard"
    return scene


def diffuse(name: str, colour) -> bpy.types.Material:
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.remove(nodes["Principled BSDF"])
    shader = nodes.new("ShaderNodeBsdfDiffuse")
    shader.inputs["Color"].default_value = *colour, 1
    material.node_tree.links.new(shader.outputs[0], nodes["Material Output"].inputs["Surface"])
    return material


def shape(kind: str, name: str, material=None, **words) -> bpy.types.Object:
    getattr(bpy.ops.mesh, f"primitive_{kind}_add")(**words)
    item = bpy.context.object
    item.name = item.data.name = name
    if material:
        item.data.materials.append(material)
    return item


def add(name: str, data, matrix=Matrix()) -> bpy.types.Object:
    item = bpy.data.objects.new(name, data)
    item.matrix_world = matrix
    bpy.context.scene.collection.objects.link(item)
    return item


def look(eye, at, roll=0.0) -> Matrix:
    """Placed at the eye, -z towards a point; for cameras and lamps."""
    turn = (Vector(eye) - Vector(at)).to_track_quat("Z", "Y").to_matrix().to_4x4()
    return Matrix.Translation(eye) @ turn @ Matrix.Rotation(roll, 4, "Z")


def lamp(name: str, kind: str, watts: float, matrix: Matrix, **more) -> bpy.types.Object:
    light = bpy.data.lights.new(name, kind)
    light.energy = watts
    for key, value in more.items():
        setattr(light, key, value)
    return add(name, light, matrix)


def camera(scene, matrix: Matrix, size, lens=50.0, fit="AUTO") -> bpy.types.Object:
    data = bpy.data.cameras.new("Camera")
    data.lens, data.sensor_fit, data.sensor_height = lens, fit, 30
    scene.camera = add("Camera", data, matrix)
    scene.render.resolution_x, scene.render.resolution_y = (2 * side for side in size)
    scene.render.resolution_percentage = 50
    return scene.camera


def meshes() -> None:
    """Smooth and flat ones, of two materials, instanced, parented with a shear, mirrored, and hidden ones."""
    scene = start()
    red, green, white = diffuse("red", (0.8, 0.2, 0.1)), diffuse("green", (0.2, 0.6, 0.2)), diffuse("white", (0.8,) * 3)
    shape("plane", "floor", white, size=30)
    ball = shape("ico_sphere", "ball", red, radius=1, location=(-1.6, 0.2, 1))
    bpy.ops.object.shade_smooth()
    smoother = ball.modifiers.new("finer", "SUBSURF")
    smoother.levels, smoother.render_levels = 0, 4
    block = shape("cube", "block", green, size=1.2, location=(1.1, -0.4, 0.6), rotation=(0, 0, 0.5))
    block.data.materials.append(red)
    block.data.polygons[3].material_index = 1
    can = shape("cylinder", "can", white, radius=0.4, depth=1, location=(1.9, -2.2, 0.5), rotation=(0, 0.3, 0))
    bpy.ops.object.shade_smooth()
    # The lid's edge is sharp.
    if hasattr(can.data, "set_sharp_from_angle"):  # Blender 4.1 and later
        can.data.set_sharp_from_angle(angle=0.6)
    else:
        can.data.use_auto_smooth, can.data.auto_smooth_angle = True, 0.6
    # What hangs below an object that is turned and scaled by two different amounts is sheared.
    child = shape("cone", "child", white, radius1=0.5, depth=1, location=(1, 0.2, 1.2), rotation=(0.4, 0.5, 0.9))
    child.parent = block
    child.scale = 1, 0.5, 1.5
    block.scale = 1, 1.6, 0.8
    head = shape("monkey", "head", red, size=1.4, location=(-0.2, -1.6, 0.8), rotation=(-0.4, 0, 0.6))
    mirrored = head.copy()
    mirrored.location, mirrored.scale = (-2.9, -1.9, 0.8), (-0.9, 0.7, 0.9)
    scene.collection.objects.link(mirrored)
    group = bpy.data.collections.new("pair")
    for at in (0, 0.7):
        post = add("post", bpy.data.meshes["child"], Matrix.Translation((at, 0, 0.5)))
        scene.collection.objects.unlink(post)
        group.objects.link(post)
    for number in range(3):
        pair = add("pair", None, Matrix.Translation((2.4 - number, 2.5, 0)) @ Matrix.Rotation(number, 4, "Z"))
        pair.instance_type, pair.instance_collection = "COLLECTION", group
    hidden = shape("cube", "hidden", red, size=3, location=(0, -3, 1))
    hidden.hide_render = True
    lamp("window", "AREA", 700, look((-4, -5, 6), (0, 0, 0.5), 0.7), shape="RECTANGLE", size=2, size_y=0.7,
         color=(1, 0.9, 0.7))
    lamp("bulb", "POINT", 150, Matrix.Translation((4, -3, 4)), shadow_soft_size=0, color=(0.6, 0.8, 1))
    camera(scene, look((2.5, -8, 4), (-0.2, 0, 0.7), 0.15), (128, 96), lens=48)


def lens() -> None:
    """Depth of field, a high picture with the sensor fitted to its height, a sun, a world of nodes, a curve."""
    scene = start()
    scene.world.use_nodes = True
    sky = scene.world.node_tree.nodes["Background"].inputs
    sky["Color"].default_value, sky["Strength"].default_value = (0.3, 0.5, 1, 1), 0.6
    clay = diffuse("clay", (0.7, 0.45, 0.3))
    shape("plane", "floor", diffuse("white", (0.7,) * 3), size=30)
    for number in range(5):
        shape("cube", f"block {number}", clay, size=0.8, location=(-1 + 0.5 * number, 1.8 * number, 0.4))
    curve = bpy.data.curves.new("ring", "CURVE")
    curve.dimensions, curve.bevel_depth, curve.bevel_resolution = "3D", 0.12, 6
    ring = curve.splines.new("NURBS")
    ring.points.add(7)
    for number, point in enumerate(ring.points):
        angle = math.tau * number / 8
        point.co = math.cos(angle), 0, math.sin(angle), 1
    ring.use_cyclic_u = True
    curve.materials.append(clay)
    bend = add("ring", curve, Matrix.Translation((-0.8, 5, 1.2)))
    lamp("sun", "SUN", 3, look((3, -4, 5), (0, 0, 0)), angle=0, color=(1, 0.95, 0.8))
    eye = camera(scene, look((0.5, -6, 2.2), (0, 2, 0.5)), (96, 128), lens=55, fit="VERTICAL").data
    eye.dof.use_dof, eye.dof.focus_object = True, bend
    eye.dof.aperture_fstop = 0.11


def parallel() -> None:
    """An orthographic camera, shifted, with a lens."""
    scene = start()
    red, white = diffuse("red", (0.8, 0.2, 0.1)), diffuse("white", (0.8,) * 3)
    shape("plane", "floor", white, size=30)
    shape("cube", "near", red, size=1.2, location=(-1.2, -2, 0.6), rotation=(0, 0, 0.5))
    shape("cube", "far", red, size=1.2, location=(1.3, 2.5, 0.6), rotation=(0, 0, 0.9))
    lamp("area", "AREA", 1500, look((7, -5, 6), (0, 0, 0)), shape="SQUARE", size=2)
    data = camera(scene, look((1, -8, 5), (0, 0, 0.3), roll=0.1), (80, 64)).data
    data.type, data.ortho_scale, data.shift_x = "ORTHO", 7, 0.06
    data.dof.use_dof, data.dof.focus_distance, data.dof.aperture_fstop = True, 7, 8


def shaders() -> None:
    """A ball of each material."""
    scene = start()
    balls = {
        "plastic": ("BsdfPrincipled", {"Base Color": (0.8, 0.1, 0.1, 1), "Roughness": 0.5}),
        "gold": ("BsdfPrincipled", {"Base Color": (1, 0.7, 0.3, 1), "Metallic": 1.0, "Roughness": 0.25}),
        "chalk": ("BsdfDiffuse", {"Color": (0.9, 0.9, 0.8, 1)}),
        "mirror": ("BsdfGlossy", {"Color": (0.9, 0.9, 0.9, 1), "Roughness": 0.0}),
        "water": ("BsdfGlass", {"Color": (1, 1, 1, 1), "Roughness": 0.0, "IOR": 1.33}),
        "ruby": ("BsdfGlass", {"Color": (0.9, 0.5, 0.5, 1), "Roughness": 0.0, "IOR": 1.76}),
        "glow": ("Emission", {"Color": (0.3, 0.9, 0.3, 1), "Strength": 2.0}),
        "toon": ("BsdfToon", {}),
    }
    for number, (name, (kind, inputs)) in enumerate(balls.items()):
        material = diffuse(name, (0, 0, 0))
        tree = material.node_tree
        shader = tree.nodes.new(f"ShaderNode{kind}")
        for key, value in inputs.items():
            shader.inputs[key].default_value = value
        tree.links.new(shader.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
        shape("uv_sphere", f"ball of {name}" + (' [x] "$y"' if name == "toon" else ""), material, radius=1, segments=8,
              ring_count=4, location=(3 * number, 0, 0))
    volume = bpy.data.materials["water"].node_tree
    inside = volume.nodes.new("ShaderNodeVolumeAbsorption")
    inside.inputs["Color"].default_value, inside.inputs["Density"].default_value = (0.2, 0.6, 1, 1), 0.5
    volume.links.new(inside.outputs[0], volume.nodes["Material Output"].inputs["Volume"])
    varnish = bpy.data.materials["chalk"].node_tree
    mix, gloss = varnish.nodes.new("ShaderNodeMixShader"), varnish.nodes.new("ShaderNodeBsdfGlossy")
    mix.inputs[0].default_value = 0.25
    gloss.inputs["Color"].default_value, gloss.inputs["Roughness"].default_value = (0.8, 0.8, 0.8, 1), 0.5
    chalk = next(node for node in varnish.nodes if node.type == "BSDF_DIFFUSE" and node.inputs[0].default_value[0] > 0)
    for socket, node in ((1, chalk), (2, gloss)):
        varnish.links.new(node.outputs[0], mix.inputs[socket])
    varnish.links.new(mix.outputs[0], varnish.nodes["Material Output"].inputs["Surface"])
    picture = bpy.data.materials["plastic"].node_tree
    checks = picture.nodes.new("ShaderNodeTexChecker")
    plastic = next(node for node in picture.nodes if node.type == "BSDF_PRINCIPLED")
    picture.links.new(checks.outputs[0], plastic.inputs["Base Color"])
    lamp("spot", "SPOT", 4 * math.pi**2, Matrix.Translation((0, 0, 5)), shadow_soft_size=0)
    lamp("disc", "AREA", 400, Matrix.Translation((0, 0, 9)), shape="DISK", size=2)
    camera(scene, look((0, -30, 0), (0, 0, 0)), (64, 64)).data.shift_x = 0.25


def no_camera() -> None:
    start()
    shape("cube", "cube")


def round_camera() -> None:
    scene = start()
    shape("cube", "cube")
    camera(scene, look((0, -9, 0), (0, 0, 0)), (64, 64)).data.type = "PANO"


def no_mesh() -> None:
    scene = start()
    lamp("bulb", "POINT", 100, Matrix(), shadow_soft_size=0)
    camera(scene, look((0, -9, 0), (0, 0, 0)), (64, 64))


def render(path: str) -> None:
    """The picture that grsh computes: a pixel is the mean over its square; nothing is clamped, blurred or denoised."""
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.threads_mode, scene.render.threads = "FIXED", 1
    cycles = scene.cycles
    cycles.samples, cycles.pixel_filter_type = 256, "BOX"
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = cycles.blur_glossy = 0
    cycles.light_sampling_threshold = 0
    # At a path's last point Cycles asks for the background, grsh does not: let there be little left.
    cycles.max_bounces, cycles.diffuse_bounces, cycles.glossy_bounces = 20, 10, 10
    file = scene.render.image_settings
    file.file_format, file.color_mode, file.color_depth = "OPEN_EXR", "RGB", "32"
    scene.render.filepath = path + ".exr"
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(path + ".exr")
    pixels = numpy.empty(len(image.pixels), numpy.float32)
    image.pixels.foreach_get(pixels)
    with open(path + ".pfm", "wb") as picture:
        picture.write(b"PF\n%d %d\n-1\n" % tuple(image.size) + pixels.reshape(-1, 4)[:, :3].astype("<f4").tobytes())


def make(name: str) -> None:
    globals()[name]()
    if name in ("meshes", "lens", "parallel"):
        render(os.path.abspath(name))
    bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath(f"{name}.blend"))


try:
    for scene_name in sys.argv[sys.argv.index("--") + 1 :]:
        make(scene_name)
except Exception as error:
    sys.exit(f"scenes.py: {error!r}")

"""From the scene that Blender has loaded to the files."""
import os

import bpy

from .errors import Warnings
from .gather import gather
from .materials import linked
from .script import Script
from .words import number, numbers


def background(world, warnings: Warnings) -> list[str]:
    if world is None:
        return []
    colour, strength = world.color, 1.0
    output = world.use_nodes and world.node_tree.get_output_node("CYCLES")
    if output:
        node = linked(output.inputs["Surface"])
        if node is None:
            return []
        thing = f'world "{world.name}"'
        if node.type != "BACKGROUND":
            warnings.warn(thing, f'grsh has no background like "{node.name}": it is black')
            return []
        colour, strength = node.inputs["Color"].default_value[:3], node.inputs["Strength"].default_value
        for name in ("Color", "Strength"):
            behind = linked(node.inputs[name])
            if behind is not None:
                warnings.warn(thing, f'{name} comes from "{behind.name}": '
                              f"{numbers(strength * x for x in colour)} is taken for both")
    if max(colour) * strength <= 0:
        return []
    return [f"background {numbers(strength * x for x in colour)}"]


def path_length(scene, has_glass: bool) -> int:
    """Cycles counts bounces, with limits for each kind beside that for all, and draws light once more behind the last.
    Glass needs the most; without it the others' limits count."""
    cycles = getattr(scene, "cycles", None)  # an add-on, which may be off
    if cycles is None:
        return 8
    bounces = cycles.max_bounces
    return 1 + (bounces if has_glass else min(bounces, max(cycles.diffuse_bounces, cycles.glossy_bounces)))


def options(scene, has_glass: bool, warnings: Warnings) -> list[str]:
    view = scene.view_settings
    is_plain = view.look == "None" and view.gamma == 1 and not view.use_curve_mapping
    if view.view_transform not in ("Standard", "Raw") or not is_plain:
        warnings.warn(f'scene "{scene.name}"', f'the view transform "{view.view_transform}" is left out: a .png is '
                      "sRGB here, as Blender's Standard")
    if scene.render.use_border:
        warnings.warn(f'scene "{scene.name}"', "the render region is left out: the whole picture is rendered")
    exposure = f" exposure {number(view.exposure)}" if view.exposure else ""
    length = path_length(scene, has_glass)
    return [f"globalillumination on antialiasing on pathlength {length} samplesperpixel 64{exposure}",
            *background(scene.world, warnings)]


def title() -> str:
    source = os.path.basename(bpy.data.filepath) or "A scene"
    return (f"# {source}, from Blender {bpy.app.version_string} by tools/export_gr.py. y is up here: Blender's "
            "(x, y, z) is (x, z, -y).\n")


def write(folder: str, files: dict[str, bytes]) -> None:
    """No file before all are complete."""
    unfinished = {os.path.join(folder, f".{name}.{os.getpid()}"): os.path.join(folder, name) for name in files}
    try:
        for path, data in zip(unfinished, files.values()):
            with open(path, "xb") as file:
                file.write(data)
        for path, final in unfinished.items():
            os.replace(path, final)
    finally:
        for path in unfinished:
            if os.path.exists(path):
                os.remove(path)


def export(path: str, warnings: Warnings) -> None:
    folder, name = os.path.split(path)
    scene = bpy.context.scene
    script = Script(gather(scene, warnings), name.removesuffix(".gr"), warnings)
    text = script.text(title(), options(scene, script.has_glass(), warnings))
    files = {file: part.ply() for file, part in script.files.items()}
    write(folder, {**files, name: text.encode()})
    print(f"export_gr: {name} and {len(files)} mesh files in {folder}")

"""What Blender renders, taken over from its dependency graph."""
from dataclasses import dataclass, field

import bpy
from mathutils import Matrix, Vector

from .camera import Camera
from .errors import ExportError, Warnings
from .lights import Lamp, PointLight, area_lamp, point_light, sun
from .meshes import Part, parts_of

# Curves and texts are shown to renderers once as what they are, and once more as meshes; metaballs, too, since 3.4.
WITH_FACES = {"MESH"} if bpy.app.version >= (3, 4) else {"MESH", "META"}
WITHOUT_MATCH = {"VOLUME", "POINTCLOUD", "CURVES", "GPENCIL", "GREASEPENCIL"}


@dataclass
class Item:
    """An object with faces, or one of its instances."""

    name: str
    mesh: object  # a key of Gathered.meshes
    materials: tuple  # of the mesh's parts
    matrix: Matrix
    thickness: float


@dataclass
class Gathered:
    """What a script is made of."""

    camera: Camera | None = None
    meshes: dict[object, tuple[str, list[Part]]] = field(default_factory=dict)
    items: list[Item] = field(default_factory=list)
    lamps: list[tuple[str, Lamp]] = field(default_factory=list)
    lights: list[tuple[str, PointLight]] = field(default_factory=list)


def data_key(item) -> object:
    """Alike for objects that have the same faces."""
    if item.modifiers or item.original.type != "MESH":
        # Modifiers may make several meshes of one object.
        return item.name_full, item.data.as_pointer()
    return item.data.name_full, item.data.library


class Gatherer:
    def __init__(self, warnings: Warnings) -> None:
        self.warnings, self.found = warnings, Gathered()
        self.suns: list[tuple] = []
        self.corners: list[Vector] = []  # of the boxes of all objects

    def gather(self, depsgraph) -> None:
        scene = depsgraph.scene_eval
        self.found.camera = Camera(scene.camera, scene.render, self.warnings)
        for instance in depsgraph.object_instances:
            # Neither the instance nor its object may be kept beyond this step.
            if instance.show_self:
                self.add(instance.object, instance.matrix_world.copy())
        if not self.found.items:
            raise ExportError("there is no mesh to render")
        self.place_suns()

    def add(self, item, matrix: Matrix) -> None:
        thing = f'object "{item.name}"'
        if item.type in WITH_FACES:
            self.add_mesh(item, matrix, thing)
        elif item.type == "LIGHT":
            self.add_light(item, matrix, thing)
        elif item.type in WITHOUT_MATCH:
            self.warnings.warn(thing, f"grsh has nothing like a {item.type.lower()}: it is left out")
        if any(system.settings.type == "HAIR" and system.settings.render_type == "PATH"
               for system in getattr(item, "particle_systems", ())):
            self.warnings.warn(thing, "its hair is left out")

    def add_mesh(self, item, matrix: Matrix, thing: str) -> None:
        key = data_key(item)
        if key not in self.found.meshes:
            name = item.data.name if item.original.type == "MESH" else item.name
            self.found.meshes[key] = name, parts_of(item.to_mesh())
            item.to_mesh_clear()
        parts = self.found.meshes[key][1]
        if not parts:
            self.warnings.warn(thing, "it has no faces and is left out")
            return
        if not item.visible_camera:
            self.warnings.warn(thing, "grsh's camera sees it, Blender's does not")
        slots = [slot.material and slot.material.original for slot in item.material_slots]
        # A face with a slot that is not there has the last one's.
        materials = tuple(slots[min(part.slot, len(slots) - 1)] if slots else None for part in parts)
        corners = [matrix @ Vector(corner) for corner in item.bound_box]
        self.corners += corners
        sides = [(corners[0] - corners[i]).length for i in (1, 3, 4)]
        self.found.items.append(Item(item.name, key, materials, matrix, sum(sides) / 3))

    def add_light(self, item, matrix: Matrix, thing: str) -> None:
        light = item.data
        if light.type == "AREA":
            lamp = area_lamp(light, matrix, thing, self.warnings)
            if lamp.radiance:
                self.found.lamps.append((item.name, lamp))
                if not item.visible_camera and self.found.camera.sees(matrix.translation):
                    self.warnings.warn(thing, "grsh's camera sees it, Blender's does not")
        elif light.type == "SUN":
            self.suns.append((item.name, light.original, matrix, thing))
        else:
            self.found.lights.append((item.name, point_light(light, matrix, thing, self.warnings)))

    def place_suns(self) -> None:
        low = Vector(min(corner[axis] for corner in self.corners) for axis in range(3))
        high = Vector(max(corner[axis] for corner in self.corners) for axis in range(3))
        for name, light, matrix, thing in self.suns:
            far = 1000 * max((high - low).length, 1e-3)
            self.found.lights.append((name, sun(light, matrix, (low + high) / 2, far, thing, self.warnings)))


class ExportEngine(bpy.types.RenderEngine):
    """A renderer that gathers: only renderers are shown the scene as it is rendered, with what is hidden from them left
    out and modifiers at the quality for them."""

    bl_idname = "GRSH_EXPORT"
    bl_label = "grsh export"
    gatherer: Gatherer | None = None
    error: Exception | None = None

    def render(self, depsgraph) -> None:
        kind = type(self)
        if kind.gatherer.found.camera is not None:
            kind.gatherer.warnings.warn(f'view layer "{depsgraph.view_layer.name}"', "only the first layer is written")
            return
        try:
            kind.gatherer.gather(depsgraph)
        except Exception as error:  # Blender would print it and go on
            kind.error = error


def gather(scene, warnings: Warnings) -> Gathered:
    if scene.camera is None:
        raise ExportError(f'scene "{scene.name}" has no camera')
    ExportEngine.gatherer, ExportEngine.error = Gatherer(warnings), None
    bpy.utils.register_class(ExportEngine)
    engine, scene.render.engine = scene.render.engine, ExportEngine.bl_idname
    steps = scene.render.use_compositing, scene.render.use_sequencer
    scene.render.use_compositing = scene.render.use_sequencer = False
    try:
        bpy.ops.render.render(scene=scene.name)
    finally:
        scene.render.engine = engine
        scene.render.use_compositing, scene.render.use_sequencer = steps
        bpy.utils.unregister_class(ExportEngine)
    if ExportEngine.error is not None:
        raise ExportEngine.error
    if ExportEngine.gatherer.found.camera is None:
        raise ExportError(f'Blender did not render scene "{scene.name}"')
    return ExportEngine.gatherer.found

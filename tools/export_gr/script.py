"""The script: what was gathered as commands of grsh."""
from collections import Counter

from .errors import Warnings
from .gather import Gathered, Item
from .materials import look_of
from .meshes import Part
from .transforms import place, y_up
from .words import Names, word

PUT = """\
# Gives a node its material, {} for none, and its place: it is turned by the last of the words first, then scaled,
# turned and moved. Turns are degrees about x, y and z, that about z first.
proc put {node material {at {0 0 0}} {turn {0 0 0}} {size {1 1 1}} {before {0 0 0}}} {
    if {$material ne ""} {gr_surfaceproperty $node $material}
    gr_translate $node $at
    turn $node $turn
    gr_scale $node $size
    turn $node $before
}
proc turn {node degrees} {
    lassign $degrees x y z
    gr_rotate $node y $y
    gr_rotate $node x $x
    gr_rotate $node z $z
}
"""


class Script:
    def __init__(self, found: Gathered, stem: str, warnings: Warnings) -> None:
        self.found, self.stem, self.warnings = found, stem, warnings
        self.nodes, self.stored_nodes, self.material_names, self.file_names = (Names() for _ in range(4))
        self.materials: dict[object, str] = {}
        self.material_lines: list[str] = []
        self.store_lines: list[str] = []
        self.object_lines: list[str] = []
        self.files: dict[str, Part] = {}
        self.file_of: dict[tuple[object, int], str] = {}
        self.stored: dict[tuple, str] = {}
        counts = Counter(self.kind(item) for item in found.items)
        for item in found.items:
            self.add(item, counts[self.kind(item)] > 1)

    @staticmethod
    def kind(item: Item) -> tuple:
        """Items of a kind can be instances of one node. A mesh of one part may have another material in each."""
        return item.mesh, item.materials if len(item.materials) > 1 else ()

    def material(self, material, thickness: float) -> str:
        if material not in self.materials:
            name = self.material_names.new(material.name if material else "default")
            words = look_of(material, self.warnings).words(thickness)
            self.material_lines.append(f"gr_material {name} {words}")
            self.materials[material] = name
        return self.materials[material]

    def has_glass(self) -> bool:
        return any(" dielectric " in line for line in self.material_lines)

    def file(self, item: Item, number: int) -> str:
        """The file of the mesh's part of this number."""
        if (item.mesh, number) not in self.file_of:
            name, parts = self.found.meshes[item.mesh]
            wish = name if len(parts) == 1 else f"{name}-{parts[number].slot + 1}"
            file = f"{self.stem}-{self.file_names.new(wish)}.ply"
            self.files[file] = parts[number]
            self.file_of[item.mesh, number] = file
        return self.file_of[item.mesh, number]

    def node(self, lines: list[str], parent: str, name: str, item: Item) -> str:
        """The command that makes the node: for a mesh of several parts one that holds them."""
        if len(item.materials) == 1:
            return f"gr_mesh {parent} {name} {word(self.file(item, 0))}"
        lines.append(f"gr_transform {parent} {name}")
        for number, material in enumerate(item.materials):
            lines.append(f"put [gr_mesh {parent}:{name} {number + 1} {word(self.file(item, number))}] "
                         f"{self.material(material, item.thickness)}")
        return f"set node {parent}:{name}"

    def add(self, item: Item, is_shared: bool) -> None:
        matrix, is_flat = place(y_up(item.matrix))
        if is_flat:
            self.warnings.warn(f'object "{item.name}"', "it is scaled by 0: it becomes very thin instead")
        material = self.material(item.materials[0], item.thickness) if len(item.materials) == 1 else "{}"
        name = self.nodes.new(item.name)
        if is_shared:
            command = f"gr_instance :scene {name} {self.store(item)}"
        else:
            command = self.node(self.object_lines, ":scene", name, item)
        self.object_lines.append(f"put [{command}] {material} {matrix}".rstrip())

    def store(self, item: Item) -> str:
        kind = self.kind(item)
        if kind not in self.stored:
            name = self.stored_nodes.new(self.found.meshes[item.mesh][0])
            command = self.node(self.store_lines, ":store", name, item)
            if not command.startswith("set "):
                self.store_lines.append(command)
            self.stored[kind] = f":store:{name}"
        return self.stored[kind]

    def text(self, title: str, options: list[str]) -> str:
        lights = Names()
        light_names = [lights.new(name) for name, _ in self.found.lights]
        lines = [title, PUT, "# Materials", *self.material_lines, ""]
        if self.store_lines:
            lines += ["# Meshes that stand in several places: they are read once, outside of what is rendered.",
                      "gr_transform : store", *self.store_lines, ""]
        lines += ["# Objects", "gr_transform : scene", *self.object_lines, ""]
        if self.found.lamps or self.found.lights:
            lines.append("# Lamps")
        for name, lamp in self.found.lamps:
            node = f"gr_als_planar :scene {self.nodes.new(name)} {lamp.radiance} {{0 0 0}} 1"
            lines.append(f"put [{node}] {{}} {lamp.place}")
        for name, (_, light) in zip(light_names, self.found.lights):
            lines.append(f"gr_light {name} {light.words}")
        camera = self.found.camera
        shining = [f"{{0 0 0}} {{{' '.join(light_names)}}}"] if light_names else []
        lines += ["", "# What the camera sees. More samples make less noise: see gr_help gr_render.",
                  " \\\n    ".join([f"gr_render :scene {word(self.stem + '.png')} {camera.size}", camera.sight,
                                   *shining, *camera.options, *options]), ""]
        return "\n".join(lines)

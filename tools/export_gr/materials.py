"""Blender's materials: each becomes a Look, and that the nearest material of grsh."""
import math
from dataclasses import dataclass, replace

from .errors import Warnings
from .words import number, numbers

Colour = tuple[float, float, float]
BLACK: Colour = (0.0, 0.0, 0.0)
WHITE: Colour = (1.0, 1.0, 1.0)


def mixed(a: Colour, b: Colour, part: float) -> Colour:
    return tuple((1 - part) * x + part * y for x, y in zip(a, b))


def times(colour: Colour, factor: float) -> Colour:
    return tuple(factor * x for x in colour)


def limited(colour: Colour, most: float = 1.0) -> Colour:
    return tuple(min(max(x, 0.0), most) for x in colour)


@dataclass(frozen=True)
class Look:
    """What a shader node is, in the words of grsh's materials."""

    diffuse: Colour = BLACK
    specular: Colour = BLACK
    exponent: float = 0.0
    glass: float = 0.0  # the part of it that lets light through
    n: float = 1.0
    tint: Colour = WHITE  # what is left of light behind one surface
    absorption: Colour = BLACK  # per unit length

    def mixed(self, other: "Look", part: float) -> "Look":
        """Of what cannot be mixed, that of the one which has more of it."""
        mine, theirs = (1 - part) * max(self.specular), part * max(other.specular)
        glass = other if part * other.glass > (1 - part) * self.glass else self
        return replace(glass, diffuse=mixed(self.diffuse, other.diffuse, part),
                       specular=mixed(self.specular, other.specular, part),
                       exponent=other.exponent if theirs > mine else self.exponent,
                       glass=(1 - part) * self.glass + part * other.glass)

    def words(self, thickness: float) -> str:
        """Type and options of gr_material."""
        if self.glass >= 0.5:
            # Light passes two surfaces.
            tint = (-2 * math.log(max(c, 1e-3)) / thickness for c in limited(self.tint))
            beers = [a + b for a, b in zip(self.absorption, tint)]
            return f"dielectric n {number(self.n)}" + (f" beers {numbers(beers)}" if max(beers) > 0 else "")
        if max(self.specular) < 1e-4:
            return f"diffuse diffuse {numbers(limited(self.diffuse))}"
        exponent = number(self.exponent)
        return (f"shirley diffuse {numbers(limited(self.diffuse))} specular {numbers(limited(self.specular))} "
                f"exp {{{exponent} {exponent}}}")


def phong_exponent(roughness: float) -> float:
    """Of a highlight as wide as Blender's, whose microfacets have the slope roughness^2."""
    return min(2 / max(roughness, 1e-3) ** 4 - 2, 1e6)


def reflectance(n: float) -> float:
    """Of a surface that is looked at straight."""
    return ((n - 1) / (n + 1)) ** 2 if n > 0 else 0.0


def linked(socket):
    """The node behind a socket, or None."""
    while socket is not None and socket.is_linked:
        node = socket.links[0].from_node
        if node.type != "REROUTE":
            return node
        socket = node.inputs[0]
    return None


class Shader:
    """Reads the shader nodes of one material."""

    def __init__(self, thing: str, warnings: Warnings) -> None:
        self.thing, self.warnings = thing, warnings
        self.readers = {
            "BSDF_PRINCIPLED": self.principled, "BSDF_DIFFUSE": self.diffuse, "BSDF_GLOSSY": self.glossy,
            "BSDF_ANISOTROPIC": self.glossy, "BSDF_GLASS": self.glass, "BSDF_REFRACTION": self.glass,
            "BSDF_TRANSPARENT": self.transparent, "EMISSION": self.emission, "MIX_SHADER": self.mix,
            "ADD_SHADER": self.add}

    def warn(self, what: str) -> None:
        self.warnings.warn(self.thing, what)

    def value(self, node, *names: str):
        """The first socket of these names that the node has; their names changed with Blender 4."""
        socket = next((node.inputs[name] for name in names if name in node.inputs), None)
        if socket is None:
            return 0.0
        behind = linked(socket)
        value = socket.default_value
        if behind is not None and behind.type in ("RGB", "VALUE"):
            value = behind.outputs[0].default_value
        elif behind is not None:
            self.warn(f'{names[0]} comes from "{behind.name}": {self.shown(value)} is taken')
        return value if isinstance(value, float) else tuple(value)[:3]

    @staticmethod
    def shown(value) -> str:
        return number(value) if isinstance(value, float) else numbers(tuple(value)[:3])

    def leave_out(self, node, *sockets: tuple[str, ...]) -> None:
        """Warns of sockets that grsh has nothing for, where they do something."""
        for names in sockets:
            for socket in (node.inputs[name] for name in names if name in node.inputs):
                if socket.is_linked or socket.default_value != 0:
                    self.warn(f"{socket.name} is left out")

    def look(self, socket) -> Look:
        node = linked(socket)
        if node is None:
            self.warn("it has no surface shader: it is black")
            return Look()
        if node.type not in self.readers:
            self.warn(f'grsh has nothing like "{node.name}": a grey diffuse material is taken')
            return Look(diffuse=(0.5, 0.5, 0.5))
        if "Normal" in node.inputs and node.inputs["Normal"].is_linked:
            self.warn("bumps are left out")
        return self.readers[node.type](node)

    def principled(self, node) -> Look:
        base, n = self.value(node, "Base Color"), self.value(node, "IOR")
        metallic, glass = self.value(node, "Metallic"), self.value(node, "Transmission", "Transmission Weight")
        roughness = self.value(node, "Roughness")
        # In Blender 4 the level doubles or halves what the index of refraction gives.
        dielectric = 0.08 * self.value(node, "Specular") if "Specular" in node.inputs else (
            2 * reflectance(n) * self.value(node, "Specular IOR Level"))
        self.leave_out(node, ("Subsurface", "Subsurface Weight"), ("Anisotropic",), ("Sheen", "Sheen Weight"),
                       ("Clearcoat", "Coat Weight"))
        if node.inputs["Alpha"].is_linked or node.inputs["Alpha"].default_value != 1:
            self.warn("Alpha is left out: it is opaque")
        self.check_emission(node)
        if glass not in (0, 1):
            self.warn(f"Transmission {number(glass)} is taken as {round(glass)}")
        opaque = Look(diffuse=times(base, 1 - metallic), specular=mixed((dielectric,) * 3, base, metallic),
                      exponent=phong_exponent(roughness))
        return opaque.mixed(self.clear(n, base, roughness), (1 - metallic) * glass) if glass else opaque

    def check_emission(self, node) -> None:
        colour = self.value(node, "Emission", "Emission Color")
        power = self.value(node, "Emission Strength")
        if colour != 0.0 and max(colour) * power > 0:
            self.warn("it shines in Blender; in grsh only lamps do")

    def clear(self, n: float, tint: Colour, roughness: float) -> Look:
        if roughness > 0:
            self.warn(f"glass of roughness {number(roughness)} becomes smooth")
        if min(tint) < 1:
            self.warn(f"the tint {numbers(tint)} of its surface becomes absorption inside, by its first object's size")
        return Look(glass=1.0, n=n, tint=tint)

    def diffuse(self, node) -> Look:
        self.leave_out(node, ("Roughness",))
        return Look(diffuse=self.value(node, "Color"))

    def glossy(self, node) -> Look:
        self.leave_out(node, ("Anisotropy",))
        return Look(specular=self.value(node, "Color"), exponent=phong_exponent(self.value(node, "Roughness")))

    def glass(self, node) -> Look:
        if node.type == "BSDF_REFRACTION":
            self.warn("a refraction shader becomes glass, which reflects, too")
        roughness = 0.0 if getattr(node, "distribution", "") == "SHARP" else self.value(node, "Roughness")
        return self.clear(self.value(node, "IOR"), self.value(node, "Color"), roughness)

    def transparent(self, node) -> Look:
        return self.clear(1.0, self.value(node, "Color"), 0.0)

    def emission(self, node) -> Look:
        self.warn("it shines in Blender; in grsh only lamps do, and it is diffuse in its colour")
        return Look(diffuse=limited(self.value(node, "Color")))

    def mix(self, node) -> Look:
        first, second = self.look(node.inputs[1]), self.look(node.inputs[2])
        part = self.part(node.inputs[0])
        if 0 < part < 1 and first.glass != second.glass:
            kept = "glass" if first.mixed(second, part).glass >= 0.5 else "what is not glass"
            self.warn(f"glass is not mixed with what is not: {kept} is taken")
        return first.mixed(second, part)

    def part(self, socket) -> float:
        """Of a mix by Fresnel's reflectance, that along the normal: grsh's highlight grows by itself."""
        behind = linked(socket)
        if behind is not None and behind.type == "FRESNEL":
            return reflectance(behind.inputs["IOR"].default_value)
        if behind is not None and behind.type == "VALUE":
            return behind.outputs[0].default_value
        if behind is not None:
            self.warn(f'a mix by "{behind.name}": {number(socket.default_value)} is taken')
        return socket.default_value

    def add(self, node) -> Look:
        half = self.look(node.inputs[0]).mixed(self.look(node.inputs[1]), 0.5)
        whole = replace(half, diffuse=times(half.diffuse, 2), specular=times(half.specular, 2))
        if max(whole.diffuse + whole.specular) > 1:
            self.warn("more than all light would be reflected: colours are cut off at 1")
        return whole


def absorption(socket, shader: Shader) -> Colour:
    node = linked(socket)
    if node is None:
        return BLACK
    if node.type != "VOLUME_ABSORPTION":
        shader.warn(f'grsh has no volume like "{node.name}": it is left out')
        return BLACK
    density = shader.value(node, "Density")
    return tuple(density * max(1 - c, 0.0) for c in shader.value(node, "Color"))


def look_of(material, warnings: Warnings) -> Look:
    if material is None:
        return Look(diffuse=(0.8, 0.8, 0.8))
    shader = Shader(f'material "{material.name}"', warnings)
    output = material.use_nodes and material.node_tree.get_output_node("CYCLES")
    if not output:
        return Look(diffuse=tuple(material.diffuse_color)[:3])
    if output.inputs["Displacement"].is_linked:
        shader.warn("its displacement is left out")
    inside = absorption(output.inputs["Volume"], shader)
    if linked(output.inputs["Surface"]) is None and max(inside) > 0:
        return Look(glass=1.0, absorption=inside)
    look = shader.look(output.inputs["Surface"])
    if max(inside) > 0 and look.glass < 0.5:
        shader.warn("its volume is left out: it is not glass")
    return replace(look, absorption=inside)

"""Blender's lamps. Its watts are those of Cycles: a lamp's colour, too, multiplies them."""
import math
from dataclasses import dataclass

import bpy
from mathutils import Matrix, Vector

from .errors import Warnings
from .transforms import place, y_up, Y_UP
from .words import numbers


@dataclass
class Lamp:
    """An area lamp: radiance is "" for what cannot be a gr_als_planar."""

    radiance: str
    place: str


@dataclass
class PointLight:
    """The words of gr_light behind the name."""

    words: str


def strength(light, thing: str, warnings: Warnings) -> Vector:
    """Watts for each colour; of a sun watts per square metre."""
    power = light.energy * 2 ** getattr(light, "exposure", 0)
    if getattr(light, "use_temperature", False):
        warnings.warn(thing, "its temperature is left out")
    colour = Vector(light.color)
    if light.use_nodes and light.node_tree:
        emission = next((node for node in light.node_tree.nodes if node.type == "EMISSION"), None)
        if emission is None or len(light.node_tree.nodes) > 2 or any(s.is_linked for s in emission.inputs):
            warnings.warn(thing, "its nodes are left out")
        else:
            power *= emission.inputs["Strength"].default_value
            colour *= Vector(emission.inputs["Color"].default_value[:3])
    return power * colour


# Watts over area and radiance of an area lamp. Up to Blender 3 Cycles took 4 for pi.
POWER_OVER_RADIANCE = math.pi if bpy.app.version >= (4, 0) else 4


def area_lamp(light, matrix: Matrix, thing: str, warnings: Warnings) -> Lamp:
    """The lamp shines along its own -z, gr_als_planar along -y, and y_up makes the one of the other."""
    axes = matrix.to_3x3()
    is_round = light.shape in ("DISK", "ELLIPSE")
    if is_round:
        warnings.warn(thing, "a round lamp becomes a rectangular one of the same area")
    if light.spread < math.pi * 0.999:
        warnings.warn(thing, "its spread is left out: it shines to all sides below it")
    height = light.size_y if light.shape in ("RECTANGLE", "ELLIPSE") else light.size
    sides = [light.size * axes.col[0].length, height * axes.col[1].length]
    if is_round:
        sides = [side * math.sqrt(math.pi) / 2 for side in sides]
    if min(sides) <= 0:
        warnings.warn(thing, "it has no area and is left out")
        return Lamp("", "")
    power = strength(light, thing, warnings)
    if getattr(light, "normalize", True):
        power /= sides[0] * sides[1]
    # A mirrored lamp shines along its -z, too.
    across, up = axes.col[0].normalized(), axes.col[1].normalized()
    turned = Matrix((sides[0] * across, sides[1] * up, across.cross(up))).transposed().to_4x4()
    if turned.col[2].xyz.dot(axes.col[2]) < 0:
        turned.col[0], turned.col[2] = -turned.col[0], -turned.col[2]
    turned.translation = matrix.translation
    return Lamp(numbers(power / POWER_OVER_RADIANCE), place(y_up(turned))[0])


def point_light(light, matrix: Matrix, thing: str, warnings: Warnings) -> PointLight:
    """Cycles: the irradiance at distance d is watts / (4 pi d^2); a white surface shows 1 / pi of it, which is what
    gr_light is given by."""
    if light.type == "SPOT":
        warnings.warn(thing, "a spot becomes a point light, which shines to all sides")
    if light.shadow_soft_size > 0:
        warnings.warn(thing, "a point light has no radius: its shadows are sharp")
    power = strength(light, thing, warnings) / (4 * math.pi**2)
    return PointLight(f"{numbers(Y_UP @ matrix.translation)} {numbers(power)} {{0 0 1}}")


def sun(light, matrix: Matrix, centre: Vector, distance: float, thing: str, warnings: Warnings) -> PointLight:
    """A light that does not fade, so far away that its rays are as good as parallel."""
    if light.angle > 0:
        warnings.warn(thing, "a point light has no angle: its shadows are sharp")
    place_of = centre + distance * matrix.to_3x3().col[2].normalized()
    return PointLight(f"{numbers(Y_UP @ place_of)} {numbers(strength(light, thing, warnings) / math.pi)} {{1 0 0}}")

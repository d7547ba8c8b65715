"""Blender's camera as words of gr_render."""
import math

from mathutils import Vector

from .errors import ExportError, Warnings
from .transforms import Y_UP
from .words import number, numbers


def picture_size(render) -> tuple[int, int]:
    width, height = (side * render.resolution_percentage // 100 for side in (render.resolution_x, render.resolution_y))
    return max(1, width), max(1, height)


def is_wide(camera, width: int, height: int) -> bool:
    """Whether the sensor's side covers the picture's width, or else its height."""
    return camera.sensor_fit == "HORIZONTAL" or camera.sensor_fit == "AUTO" and width >= height


def half_height(camera, width: int, height: int) -> float:
    """Of the picture at distance 1; of an orthographic one anywhere."""
    if camera.type == "ORTHO":
        return camera.ortho_scale / 2 * (height / width if is_wide(camera, width, height) else 1)
    sensor = camera.sensor_height if camera.sensor_fit == "VERTICAL" else camera.sensor_width
    return sensor / (2 * camera.lens) * (height / width if is_wide(camera, width, height) else 1)


def focal_distance(camera, eye: Vector, view: Vector) -> float:
    """Along the view, as grsh measures it."""
    focus = camera.dof.focus_object
    return abs((focus.matrix_world.translation - eye).dot(view)) if focus else camera.dof.focus_distance


class Camera:
    """The words of gr_render: its size; its sight, which is eye, view, up and fov; and options."""

    def __init__(self, item, render, warnings: Warnings) -> None:
        camera, self.thing = item.data, f'camera "{item.name}"'
        if camera.type not in ("PERSP", "ORTHO"):
            raise ExportError(f"{self.thing} is {camera.type.lower()}: it must have perspective or be orthographic")
        self.is_parallel = camera.type == "ORTHO"
        self.width, self.height = picture_size(render)
        half = half_height(camera, self.width, self.height)
        axes = item.matrix_world.to_3x3().normalized()
        right, up, view = axes.col[0], axes.col[1], -axes.col[2]
        eye = item.matrix_world.translation
        self.options = self.lens_options(camera, eye, view, warnings)
        # gr_render is told how high an orthographic picture is by the focal distance and the angle.
        distance = 1.0
        if self.is_parallel:
            distance = focal_distance(camera, eye, view) if camera.dof.use_dof else half
            self.options = ["projection orthographic", *(self.options or [f"focaldistance {number(half)}"])]
        if render.pixel_aspect_x != render.pixel_aspect_y:
            warnings.warn(self.thing, "pixels are square here")
        if camera.shift_x or camera.shift_y:
            # Shifts are parts of the side that the sensor covers.
            side = 2 * half * (self.width / self.height if is_wide(camera, self.width, self.height) else 1)
            shift = side * (camera.shift_x * right + camera.shift_y * up)
            if self.is_parallel:
                eye = eye + shift
            else:
                warnings.warn(self.thing, "gr_render has no lens shift: it is turned to the picture's middle instead")
                view = view + shift
        self.inverse, self.half = item.matrix_world.inverted(), half
        turned = [numbers(Y_UP.to_3x3() @ vector) for vector in (eye, view, up)]
        self.size = f"{self.width} {self.height}"
        self.sight = f"{' '.join(turned)} {number(math.degrees(2 * math.atan(half / distance)))}"

    def lens_options(self, camera, eye: Vector, view: Vector, warnings: Warnings) -> list[str]:
        dof = camera.dof
        if not dof.use_dof:
            return []
        if dof.aperture_blades > 2 or dof.aperture_ratio != 1:
            warnings.warn(self.thing, "the lens is round here")
        # The focal length is in millimetres, whatever the scene's unit; without perspective Cycles takes it for 1.
        radius = (1 if self.is_parallel else camera.lens / 1000) / (2 * dof.aperture_fstop)
        return [f"depthoffield on focaldistance {number(focal_distance(camera, eye, view))} aperture {number(radius)}"]

    def sees(self, place: Vector) -> bool:
        """Whether the place is in the picture, or just outside."""
        x, y, z = self.inverse @ place
        reach = 1.2 * self.half * (1 if self.is_parallel else -z)
        return z < 0 and abs(y) < reach and abs(x) < reach * self.width / self.height

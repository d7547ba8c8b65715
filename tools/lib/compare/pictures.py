"""Pictures as arrays of linear floats, the first row on top, and the converged ones of tests/reference/."""
import pathlib

import numpy as np
import OpenEXR

folder = pathlib.Path(__file__).resolve().parents[3] / "tests" / "reference"


def read_pfm(path):
    with open(path, "rb") as file:
        kind, size, scale = file.readline(), file.readline(), file.readline()
        width, height = map(int, size.split())
        order = "<" if float(scale) < 0 else ">"
        return np.frombuffer(file.read(), order + "f4").reshape(height, width, 3)[::-1]


def lamp_pixels(camera, lamps):
    """Where a lamp is seen, and one pixel round it; what stands before a lamp is not asked."""
    seen = np.zeros((camera.height + 2, camera.width + 2), bool)
    steps = np.linspace(-0.5, 0.5, 1001)
    for lamp in lamps:
        places = (lamp.centre + np.multiply.outer(steps, lamp.x)[:, None] + np.multiply.outer(steps, lamp.z)[None])
        way = places.reshape(-1, 3) - camera.eye
        along = way @ camera.forward
        shining = (along > 0) & (way @ lamp.down < 0)
        half = np.tan(camera.fov / 2) * along
        x = np.floor((way @ camera.right / half * camera.height + camera.width) / 2)
        y = np.floor((1 - way @ camera.up / half) * camera.height / 2)
        inside = shining & (x >= 0) & (x < camera.width) & (y >= 0) & (y < camera.height)
        seen[y[inside].astype(int) + 1, x[inside].astype(int) + 1] = True
    wide = np.zeros_like(seen)
    for down in (-1, 0, 1):
        for right in (-1, 0, 1):
            wide |= np.roll(seen, (down, right), (0, 1))
    return wide[1:-1, 1:-1]


def relative_error(error, pixels):
    """relMSE: the mean of the squared error, in proportion to what is there."""
    return (error**2 / (pixels**2 + 0.01)).mean()


class Reference:
    """A converged picture, linear RGBA. Alpha is 0 where a pixel does not count: at the lamp, whose light has no noise."""

    def __init__(self, name):
        self.path = folder / f"{name}.exr"
        file = OpenEXR.File(str(self.path))
        self.header = file.header()
        self.picture = file.channels()["RGBA"].pixels.astype(float)
        self.counts = self.picture[..., 3] > 0.5
        self.pixels = self.picture[self.counts, :3]

    def relative_error(self, picture):
        return relative_error(picture[self.counts] - self.pixels, self.pixels)

    def mean_ratio(self, picture):
        return picture[self.counts].mean() / self.pixels.mean()


def write_reference(path, picture, counts, attributes):
    """The file is there complete, or the old one still."""
    pixels = np.dstack([picture, counts]).astype(np.float16)
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage, **attributes}
    unfinished = path.with_suffix(".new")
    OpenEXR.File(header, {"RGBA": np.ascontiguousarray(pixels)}).write(str(unfinished))
    unfinished.replace(path)

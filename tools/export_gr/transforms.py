"""Matrices as the transforms of a grsh script."""
import numpy
from mathutils import Euler, Matrix

from .words import numbers

# From Blender's axes, z up, to those of grsh's scenes, y up.
Y_UP = Matrix(((1, 0, 0, 0), (0, 0, 1, 0), (0, -1, 0, 0), (0, 0, 0, 1)))
# Smaller parts of a matrix than this are its roundings.
ROUNDING = 1e-5


def y_up(matrix: Matrix) -> Matrix:
    """What the matrix does in Blender's axes, in grsh's."""
    return Y_UP @ matrix @ Y_UP.inverted()


def degrees(rotation: numpy.ndarray) -> list[float]:
    """Turns about x, y and z, that about z acting first, that about y last."""
    euler: Euler = Matrix(rotation.tolist()).to_euler("ZXY")
    return [float(numpy.degrees(angle)) for angle in euler]


def place(matrix: Matrix) -> tuple[str, bool]:
    """The words behind the material in "put": at, turn, size, before; what does nothing at the end is left out. And
    whether the matrix flattens what it acts on, which grsh does not know: it becomes very thin."""
    linear = numpy.array(matrix.to_3x3(), dtype=float)
    lengths = numpy.linalg.norm(linear, axis=0)
    dots = linear.T @ linear
    scale = max(lengths.max(), 1e-30)
    before = numpy.eye(3)
    if lengths.min() > ROUNDING * scale and abs(dots - numpy.diag(lengths**2)).max() < ROUNDING * scale**2:
        turn, size = linear / lengths, lengths
    else:
        # Any matrix is a turn, a scale and another turn.
        turn, size, before = numpy.linalg.svd(linear)
        if numpy.linalg.det(before) < 0:
            before[0], size[0] = -before[0], -size[0]
    # A mirror goes into the size.
    if numpy.linalg.det(turn) < 0:
        turn[:, 0], size[0] = -turn[:, 0], -size[0]
    flat = abs(size) < 1e-6 * scale
    size = numpy.where(flat, numpy.copysign(1e-6 * scale, size), size)
    parts = [numbers(matrix.translation), numbers(degrees(turn)), numbers(size), numbers(degrees(before))]
    nothing = ["{0 0 0}", "{0 0 0}", "{1 1 1}", "{0 0 0}"]
    while parts and parts[-1] == nothing[len(parts) - 1]:
        parts.pop()
    return " ".join(parts), bool(flat.any())

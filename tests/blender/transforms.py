"""blender -b -P transforms.py -- FILE writes a script in which grsh checks that what export_gr makes of matrices,
turned, sheared and mirrored ones, is those matrices."""
import os
import random
import sys

from mathutils import Matrix

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "..", "tools"))
from export_gr.script import PUT
from export_gr.transforms import place

CHECK = """
proc check {words matrix} {
    gr_reset
    gr_sphere : ball
    put :ball {} {*}$words
    if {![regexp {matrix (.*)} [gr_print :ball] - found]} {set found {{1 0 0 0} {0 1 0 0} {0 0 1 0}}}
    foreach a [concat {*}$found] b [concat {*}$matrix] {
        if {abs($a - $b) > 1e-5} {puts "$words is $found, not $matrix"; return}
    }
    incr ::right
}
"""


def chance() -> Matrix:
    """With columns at right angles to each other, or sheared; half of either are mirrored."""
    turn = Matrix.Identity(4)
    for axis in "XYZ":
        turn = turn @ Matrix.Rotation(random.uniform(-4, 4), 4, axis)
    size = Matrix.Diagonal((*(random.choice((-1, 1)) * random.uniform(0.2, 3) for _ in range(3)), 1))
    shear = Matrix.Shear("XY", 4, (random.uniform(-1, 1), random.uniform(-1, 1))) if random.random() < 0.5 else Matrix()
    return Matrix.Translation([random.uniform(-5, 5) for _ in range(3)]) @ turn @ size @ shear


random.seed(6)
# A turn by 90 degrees about x leaves the others undetermined.
matrices = [Matrix(), Matrix.Rotation(1.5707964, 4, "X"), *(chance() for _ in range(100))]
with open(sys.argv[-1], "w") as script:
    script.write(PUT + CHECK)
    for matrix in matrices:
        rows = " ".join("{" + " ".join(f"{x:.9g}" for x in row) + "}" for row in list(matrix)[:3])
        script.write(f"check {{{place(matrix)[0]}}} {{{rows}}}\n")
    script.write("puts $right\n")

"""Writes a Blender scene as a script for grsh, and its meshes beside it:

    blender scene.blend -b -P tools/export_gr.py -- out.gr

makes out.gr and a file out-NAME.ply for each mesh. For Blender 3 and 4. What grsh has no match for becomes the nearest
that it has, and is told in a warning. On an error nothing is written.

Blender's z axis is up, grsh's scenes have y up: (x, y, z) becomes (x, z, -y), in the meshes as in the script.
"""
import os
import sys
import traceback

import bpy

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
try:
    import numpy  # noqa: F401, only to see whether it is there
except ImportError:
    sys.exit("export_gr: the Python of this Blender has no numpy; on Debian it is in the package python3-numpy")
from export_gr.errors import ExportError, Warnings
from export_gr.export import export


def arguments() -> list[str]:
    return sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []


def output_path() -> str:
    words = arguments()
    if len(words) != 1 or not words[0].endswith(".gr"):
        raise ExportError("usage: blender scene.blend -b -P tools/export_gr.py -- out.gr")
    path = os.path.abspath(words[0])
    if not os.path.isdir(os.path.dirname(path)):
        raise ExportError(f'cannot write "{words[0]}": there is no such folder')
    if os.path.isdir(path):
        raise ExportError(f'cannot write "{words[0]}": it is a folder')
    return path


def main() -> None:
    try:
        path = output_path()
        export(path, Warnings())
    except (ExportError, OSError) as error:
        sys.exit(f"export_gr: {error}")
    except Exception:
        # Blender itself would print it, and exit with 0.
        traceback.print_exc()
        sys.exit(1)


if __name__ == "__main__":
    main()

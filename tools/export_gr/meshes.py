"""Blender's meshes as PLY files: triangles, y up, with the normals of corners where faces are shaded smoothly."""
import numpy


class Part:
    """The triangles of a mesh that have one material slot."""

    def __init__(self, slot: int, vertices: numpy.ndarray, normals: numpy.ndarray | None, faces: numpy.ndarray) -> None:
        self.slot, self.vertices, self.normals, self.faces = slot, vertices, normals, faces

    def ply(self) -> bytes:
        columns = self.vertices if self.normals is None else numpy.hstack([self.vertices, self.normals])
        names = ["x", "y", "z", "nx", "ny", "nz"][: columns.shape[1]]
        header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(columns)}"]
        header += [f"property float {name}" for name in names]
        header += [f"element face {len(self.faces)}", "property list uchar int vertex_indices", "end_header", ""]
        faces = numpy.empty(len(self.faces), [("count", "u1"), ("corners", "<i4", 3)])
        faces["count"], faces["corners"] = 3, self.faces
        return "\n".join(header).encode() + columns.astype("<f4").tobytes() + faces.tobytes()


def values(collection, attribute: str, width: int, kind=numpy.float32) -> numpy.ndarray:
    flat = numpy.empty(len(collection) * width, kind)
    collection.foreach_get(attribute, flat)
    return flat.reshape(-1, width) if width > 1 else flat


def corner_normals(mesh) -> numpy.ndarray:
    if hasattr(mesh, "corner_normals"):  # Blender 4.1 and later
        return values(mesh.corner_normals, "vector", 3)
    mesh.calc_normals_split()
    return values(mesh.loops, "normal", 3)


def y_up(vectors: numpy.ndarray) -> numpy.ndarray:
    return numpy.stack([vectors[:, 0], vectors[:, 2], -vectors[:, 1]], axis=1)


def parts_of(mesh) -> list[Part]:
    """A part for each material slot that has faces."""
    mesh.calc_loop_triangles()
    triangles = mesh.loop_triangles
    if len(triangles) == 0:
        return []
    vertices = y_up(values(mesh.vertices, "co", 3))
    corners = values(triangles, "loops", 3, numpy.int32)
    slots = values(triangles, "material_index", 1, numpy.int32)
    smooth = values(triangles, "use_smooth", 1, bool)
    vertex_of = values(mesh.loops, "vertex_index", 1, numpy.int32)
    normals = y_up(corner_normals(mesh))
    return [part(slot, vertices, vertex_of, normals, corners[slots == slot], smooth[slots == slot].any())
            for slot in numpy.unique(slots).tolist()]


def part(slot: int, vertices: numpy.ndarray, vertex_of: numpy.ndarray, normals: numpy.ndarray, corners: numpy.ndarray,
         is_smooth: bool) -> Part:
    flat = corners.reshape(-1)
    if not is_smooth:
        used, faces = numpy.unique(vertex_of[flat], return_inverse=True)
        return Part(slot, vertices[used], None, faces.reshape(-1, 3))
    # Corners with the same vertex and the same normal become one.
    keys = numpy.empty(len(flat), [("vertex", "<i4"), ("normal", "<f4", 3)])
    keys["vertex"], keys["normal"] = vertex_of[flat], normals[flat] + 0.0
    _, first, faces = numpy.unique(keys.view(f"V{keys.itemsize}"), return_index=True, return_inverse=True)
    return Part(slot, vertices[vertex_of[flat[first]]], normals[flat[first]], faces.reshape(-1, 3))

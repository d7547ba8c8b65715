#!/usr/bin/env python3
"""Writes the mesh files of tests/corpus/meshes into the folder that it is given:

    python3 tests/corpus/make_meshes.py tests/corpus/meshes

They are kept as files, so that they stay what they are. Most show the same tetrahedron, with the corners 0 0 0, 1 0 0,
0 1 0 and 0 0 1, each time written in another way that is allowed, or in one that is not.
"""
import base64
import json
import math
import pathlib
import struct
import sys

folder = pathlib.Path(sys.argv[1])
places = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
faces = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]


def write(name, content):
    data = content if isinstance(content, bytes) else content.encode()
    (folder / name).write_bytes(data)


# OBJ
obj_places = "".join("v %d %d %d\n" % place for place in places)
obj_faces = "".join("f %d %d %d\n" % tuple(i + 1 for i in face) for face in faces)


def objs():
    write("indented.obj", "".join("\t  " + line + "\n" for line in (obj_places + obj_faces).splitlines()))
    write("dots.obj", "v .0 0. -.0\nv 1. 0 0\nv 0 +1 0\nv 0 0 10e-1\nvt .5 .5\n" + obj_faces)
    write("unused.obj", obj_places + "v .5 .5 9\n" + obj_faces)
    write("colours.obj", "".join("v %d %d %d .2 .3 .4\n" % place for place in places) + obj_faces)
    write("alpha.obj", "".join("v %d %d %d .2 .3 .4 1\n" % place for place in places) + obj_faces)
    write("five.obj", "".join("v %d %d %d .2 .3\n" % place for place in places) + obj_faces)
    write("no_vt.obj", obj_places + "f 1/1 3/3 2/2\n" + obj_faces[8:])
    write("late_vt.obj", obj_places + "f 1/1 3/3 2/2\nvt 0 0\nvt 1 0\nvt 0 1\n" + obj_faces[8:])
    write("vt_1_4.obj", obj_places + "vt .5\nvt .5 .5 0 1\n" + obj_faces.replace("f 1 3 2", "f 1/1 3/2 2/2"))
    write("bom.obj", "\ufeff" + obj_places + obj_faces)
    write("utf16.obj", (obj_places + obj_faces).encode("utf-16-be"))
    write("bad_vn.obj", obj_places + "vn 0 0 -1\nvn 1 1 1\n" + obj_faces[:-8] + "f 3//2 1//9 4//2\n")
    write("comments.obj", "# C:\\models\\\n" + obj_places.replace("\n", " # a place\n") + obj_faces.replace("\n", " # f\n"))
    write("lod.obj", "lod 3\nbevel on\ns off\n" + obj_places + obj_faces)
    write("returns.obj", (obj_places + obj_faces).replace("\n", "\r"))
    write("backwards.obj", obj_places + "f -4 -2 -3\nf -4 -3 -1\nf -3 -2 -1\nf -2 -4 -1\n")
    write("groups.obj", obj_places + "o low\nusemtl red wall\nf 1 3 2\ng high\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
    write("fold.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 1 0.1 1\nf 1 2 3 4\n")
    write("steep.obj", "v 0 0 0\nv 1 0 0\nv 1 1 5\nv 0 1 0\nf 1 2 3 4\n")
    write("bow.obj", obj_places + obj_faces + "v 5 0 0\nv 6 1 0\nv 6 0 0\nv 5 1 0\nf 5 6 7 8\n")
    write("index.obj", obj_places + "f 1 2 9\n")
    write("far.obj", "".join("v %.2f %d %d\n" % (5e6 + x / 4, y, z) for x, y, z in places) + obj_faces)
    # A cube with a cavity: the inner one is wound the other way round.
    corners = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    text = "".join("v %g %g %g\n" % tuple(3 * c for c in corner) for corner in corners)
    text += "".join("v %g %g %g\n" % tuple(1 + c for c in corner) for corner in corners)
    text += "".join("f %d %d %d %d\n" % tuple(i + 1 for i in quad) for quad in quads)
    text += "".join("f %d %d %d %d\n" % tuple(i + 9 for i in reversed(quad)) for quad in quads)
    write("hollow.obj", text)


# PLY
def ply(form="ascii", before="", vertex="", between="", middle=b"", first=b"", body=None):
    header = "ply\nformat %s 1.0\n%selement vertex 4\nproperty float x\n%sproperty float y\nproperty float z\n" % (
        form, before, vertex)
    header += between + "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
    order = "<" if form == "binary_little_endian" else ">"
    if form == "ascii":
        points = "".join("%d %d %d\n" % place for place in places).encode()
        sides = "".join("3 %d %d %d\n" % face for face in faces).encode()
    else:
        points = b"".join(struct.pack(order + "fff", *place) for place in places)
        sides = b"".join(struct.pack(order + "Biii", 3, *face) for face in faces)
    return header.encode() + (body if body is not None else first + points + middle + sides)


def plys():
    little, big = "binary_little_endian", "binary_big_endian"
    write("text.ply", ply())
    write("little.ply", ply(little))
    write("big.ply", ply(big))
    write("comments.ply", ply(vertex="comment between\nobj_info properties\n"))
    camera = "element camera 1\nproperty list uchar float at\nproperty int view\n"
    write("camera_text.ply", ply(before=camera, first=b"3 9 9 9 7\n"))
    write("camera_little.ply", ply(little, before=camera, first=struct.pack("<Bfffi", 3, 9, 9, 9, 7)))
    write("camera_between.ply", ply(between=camera, middle=b"3 9 9 9 7\n"))
    text = ply().decode()
    vertex, face = text.index("element vertex"), text.index("element face")
    end = text.index("end_header\n") + len("end_header\n")
    body = text[end:].splitlines(True)
    write("faces_first.ply", text[:vertex] + text[face:end - 11] + text[vertex:face] + "end_header\n" +
          "".join(body[4:] + body[:4]))
    strips = "element vertex 6\nproperty float x\nproperty float y\nproperty float z\n" \
        "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
    grid = [(0, 0, 0), (0, 1, 0), (1, 0, 0), (1, 1, 0), (2, 0, 0), (2, 1, 0)]
    write("strips_text.ply", "ply\nformat ascii 1.0\n" + strips + "".join("%d %d %d\n" % p for p in grid) +
          "9 0 1 2 3 -1 2 3 4 5\n")
    write("strips_little.ply", ("ply\nformat binary_little_endian 1.0\n" + strips).encode() +
          b"".join(struct.pack("<fff", *p) for p in grid) + struct.pack("<10i", 9, 0, 1, 2, 3, -1, 2, 3, 4, 5))
    # The first number's first byte is that of a line's end.
    header = ply(little, body=b"")
    x = struct.unpack("<f", b"\n\0\0?")[0]
    write("first_byte.ply", header + b"".join(
        struct.pack("<fff", x if i == 0 else place[0], place[1], place[2]) for i, place in enumerate(places)) +
        b"".join(struct.pack("<Biii", 3, *face) for face in faces))
    write("coloured.ply", ply(between="property uchar red\nproperty uchar green\nproperty uchar blue\n", body=(
        "".join("%d %d %d 255 128 0\n" % place for place in places) +
        "".join("3 %d %d %d\n" % face for face in faces)).encode()))
    write("points.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
          "end_header\n0 0 0\n")
    write("cut.ply", ply(little)[:-3])
    write("billion.ply", ply().replace(b"vertex 4", b"vertex 1000000000"))


# STL
def stl(word=str):
    lines = []
    for face in faces:
        lines += ["facet normal 0 0 0", "outer loop"] + ["vertex %d %d %d" % places[i] for i in face]
        lines += ["endloop", "endfacet"]
    return "".join(word(line) + "\n" for line in lines)


def stls():
    write("text.stl", "solid x\n" + stl() + "endsolid x\n")
    write("capitals.stl", "SOLID X\n" + stl(str.upper) + "ENDSOLID X\n")
    write("end_solid.stl", "\n solid x\n" + stl() + "end solid x\n")
    write("bom.stl", "\ufeffsolid x\n" + stl() + "EndSolid x")
    data = struct.pack("<I", 4) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *(c for i in face for c in places[i]), 0) for face in faces)
    write("bytes.stl", b"made by hand".ljust(80) + data)
    write("solid.stl", b"solid, yet of bytes".ljust(80) + data + b"\n")
    write("open.stl", "solid x\n" + stl())
    write("cut.stl", b" " * 80 + data[:-3])


# glTF
class Gltf:
    """A tetrahedron whose buffer is built piece by piece."""

    def __init__(self):
        self.bytes = b""
        self.json = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                     "buffers": [{}], "bufferViews": [], "accessors": []}

    def accessor(self, data, kind, component, count, **more):
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        self.json["bufferViews"].append({"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(data)})
        self.bytes += data
        self.json["accessors"].append({"bufferView": len(self.json["bufferViews"]) - 1, "componentType": component,
                                       "count": count, "type": kind, **more})
        return len(self.json["accessors"]) - 1

    def floats(self, rows, kind):
        return self.accessor(b"".join(struct.pack("<%df" % len(r), *r) for r in rows), kind, 5126, len(rows))

    def mesh(self, position=None, **attributes):
        position = self.floats(places, "VEC3") if position is None else position
        indices = self.accessor(b"".join(struct.pack("<3H", *face) for face in faces), "SCALAR", 5123, 12)
        self.json["meshes"] = [{"primitives": [{"attributes": {"POSITION": position, **attributes},
                                                "indices": indices}]}]
        return self

    def text(self, uri=None):
        self.json["buffers"][0]["byteLength"] = len(self.bytes)
        self.json["buffers"][0]["uri"] = uri or (
            "data:application/octet-stream;base64," + base64.b64encode(self.bytes).decode())
        return json.dumps(self.json)

    def glb(self, pad=b" "):
        self.json["buffers"][0]["byteLength"] = len(self.bytes)
        text = json.dumps(self.json).encode()
        text += pad * (-len(text) % 4)
        data = self.bytes + b"\0" * (-len(self.bytes) % 4)
        return b"glTF" + struct.pack("<II", 2, 28 + len(text) + len(data)) + struct.pack("<I", len(text)) + b"JSON" + \
            text + struct.pack("<I", len(data)) + b"BIN\0" + data


def gltfs():
    write("plain.gltf", Gltf().mesh().text())
    write("plain.glb", Gltf().mesh().glb())
    gltf = Gltf().mesh()
    write("percent.gltf", gltf.text("a%20buffer.bin"))
    write("a buffer.bin", gltf.bytes + b"more than is needed")
    write("climbing.gltf", gltf.text("../meshes/a%20buffer.bin"))
    write("absolute.gltf", gltf.text("/etc/passwd"))
    gltf.json["asset"]["version"] = "1.0"
    write("version1.gltf", gltf.text())
    write("utf16.gltf", Gltf().mesh().text().encode("utf-16"))
    gltf = Gltf().mesh()
    gltf.json["nodes"][0]["extras"] = 7
    write("extras.gltf", gltf.text())
    gltf = Gltf().mesh()
    gltf.json["extensionsRequired"] = ["MADE_UP_geometry"]
    write("required.gltf", gltf.text())

    # 16 bits: as they are, scaled by the node; and as parts of 32767.
    gltf = Gltf()
    quantized = b"".join(struct.pack("<4H", *(1000 * c for c in place), 0) for place in places)
    position = gltf.accessor(quantized, "VEC3", 5123, 4)
    gltf.json["bufferViews"][-1]["byteStride"] = 8
    gltf.mesh(position)
    gltf.json["nodes"][0]["scale"] = [0.001] * 3
    gltf.json["extensionsRequired"] = ["KHR_mesh_quantization"]
    write("quantized.gltf", gltf.text())
    gltf = Gltf()
    quantized = b"".join(struct.pack("<4h", *(32767 * c for c in place), 0) for place in places)
    position = gltf.accessor(quantized, "VEC3", 5122, 4, normalized=True)
    gltf.json["bufferViews"][-1]["byteStride"] = 8
    gltf.mesh(position)
    gltf.json["extensionsRequired"] = ["KHR_mesh_quantization"]
    write("normalized.gltf", gltf.text())

    # The last vertex has fewer bytes than the stride.
    gltf = Gltf()
    position = gltf.accessor(b"".join(struct.pack("<6f", *place, 0, 0, 0) for place in places)[:-12], "VEC3", 5126, 4)
    gltf.json["bufferViews"][-1]["byteStride"] = 24
    write("interleaved.gltf", gltf.mesh(position).text())

    gltf = Gltf().mesh()
    shifts = gltf.floats([(0, 0, 0), (10, 0, 0), (20, 0, 0)], "VEC3")
    gltf.json["nodes"][0]["extensions"] = {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": shifts}}}
    gltf.json["extensionsRequired"] = ["EXT_mesh_gpu_instancing"]
    write("instances.gltf", gltf.text())

    # The joint is what places the vertices, and not the node, which is somewhere else.
    gltf = Gltf()
    joints = gltf.accessor(b"\0" * 16, "VEC4", 5121, 4)
    weights = gltf.floats([(1, 0, 0, 0)] * 4, "VEC4")
    gltf.mesh(JOINTS_0=joints, WEIGHTS_0=weights)
    gltf.json["nodes"] = [{"mesh": 0, "skin": 0, "translation": [100, 0, 0]}, {"translation": [10, 0, 0]}]
    gltf.json["scenes"][0]["nodes"] = [0, 1]
    gltf.json["skins"] = [{"joints": [1]}]
    write("skin.gltf", gltf.text())

    gltf = Gltf().mesh()
    target = gltf.floats([(0, 0, 0), (0, 0, 0), (0, 0, 0), (0, 0, 1)], "VEC3")
    gltf.json["meshes"][0]["primitives"][0]["targets"] = [{"POSITION": target}]
    gltf.json["meshes"][0]["weights"] = [1]
    write("morph.gltf", gltf.text())

    gltf = Gltf()
    normals = gltf.accessor(b"".join(struct.pack("<4b", *(round(127 / math.sqrt(3)) if c == 0 else -127 for c in place), 0)
                                     for place in places), "VEC3", 5120, 4, normalized=True)
    gltf.json["bufferViews"][-1]["byteStride"] = 4
    uvs = gltf.floats([(0, 0), (1, 0), (0, 1), (1, 1)], "VEC2")
    colours = gltf.accessor(b"\xff\x80\0\xff" * 4, "VEC4", 5121, 4, normalized=True)
    gltf.mesh(NORMAL=normals, TEXCOORD_0=uvs, COLOR_0=colours)
    gltf.json["meshes"][0]["name"] = "all"
    gltf.json["materials"] = [{"name": "gold"}]
    gltf.json["meshes"][0]["primitives"][0]["material"] = 0
    write("all.gltf", gltf.text())

    # Numbers that a file of 300 bytes cannot have.
    gltf = Gltf().mesh()
    gltf.json["accessors"][0]["count"] = 1000000000
    write("billion.gltf", gltf.text())
    write("cut.glb", Gltf().mesh().glb()[:-20])


objs()
plys()
stls()
gltfs()

"""Shared code of the tests that run in Blender without a window."""

import json
import struct
import tempfile
import unittest
import zlib
from pathlib import Path

import addon_utils
import bpy

from furrow.format.container import GltfFile, ImageFile, add_wrinkles
from furrow.material import wrinkle_group

ROOT = Path(__file__).parents[3]
FLAT = (128, 128, 255)


class BlenderTest(unittest.TestCase):
    """Provides an empty scene, with the extension enabled, and a temporary folder for each test."""

    def setUp(self):
        self.empty()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def empty(self):
        """Reset Blender to an empty scene."""
        bpy.ops.wm.read_factory_settings(use_empty=True)
        addon_utils.enable("furrow", default_set=True)

    def import_face(self, path):
        """Import a file. Returns the wrinkle group of the first material that has one, or None."""
        self.assertEqual(bpy.ops.import_scene.gltf(filepath=str(path)), {"FINISHED"})
        return next((group for group in map(wrinkle_group, bpy.data.materials) if group), None)

    def export_face(self, name="out.glb", **options):
        """Export the scene to the temporary folder. Returns the path of the file."""
        path = self.folder / name
        self.assertEqual(bpy.ops.export_scene.gltf(filepath=str(path), **options), {"FINISHED"})
        return path

    def write_face(self, document, images, name="face.glb", **more):
        """Write a small face with wrinkles to the temporary folder. Returns the path of the file."""
        path = self.folder / name
        path.write_bytes(small_face(**more))
        add_wrinkles(path, {"skin": (document, images)})
        return path


def set_weights(group, weights):
    blocks = group.furrow.face.data.shape_keys.key_blocks
    for name, value in weights.items():
        blocks[name].slider_min, blocks[name].slider_max = -10, 10
        blocks[name].value = value
    bpy.context.view_layer.update()


def document(areas=("nose",), layers=None, drivers=()):
    """Create a valid document in which all layers use texture 0, and all areas use texture 1."""
    texture = {"index": 1}
    defaults = {"layer": 0, "texture": texture, "channel": 0, "combine": "sum", "activation": 0}
    return {
        "layers": layers or [{"name": "skin", "kind": "replace", "normalTexture": {"index": 0, "scale": 1}}],
        "areas": [{**defaults, **(area if isinstance(area, dict) else {"name": area})} for area in areas],
        "drivers": list(drivers),
    }


def image(name, pixel, size=8):
    """Encode a PNG. `pixel`: (red, green, blue), or a function of column and row that returns such a tuple."""
    rows = b""
    for y in range(size):
        rows += b"\0" + b"".join(bytes(pixel(x, y) if callable(pixel) else pixel) for x in range(size))
    header = struct.pack(">IIBBBBB", size, size, 8, 2, 0, 0, 0)
    chunks = ((b"IHDR", header), (b"IDAT", zlib.compress(rows)), (b"IEND", b""))
    data = b"\x89PNG\r\n\x1a\n"
    for kind, content in chunks:
        data += struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
    return ImageFile(name, "image/png", data)


def small_face(targets=(), normal=None, material=None):
    """
    Create a `.glb` file with a square of one metre, which its texture covers exactly once.

    `targets`: names of shape keys. All move the first corner along its normal: the first by 0.1 m, the second by 0.2 m,
    and so on. `normal`: ImageFile of the material's normal map.
    """
    positions = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
    arrays = [
        ("VEC3", [value for position in positions for value in position]),
        ("VEC3", [0, 0, 1] * 4),
        ("VEC2", [0, 1, 1, 1, 1, 0, 0, 0]),
        *[("VEC3", [0, 0, 0.1 * (i + 1), *[0] * 9]) for i in range(len(targets))],
    ]
    binary, views, accessors = b"", [], []
    for kind, values in arrays:
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": 4 * len(values)})
        size = int(kind[-1])
        accessor = {"bufferView": len(views) - 1, "componentType": 5126, "count": len(values) // size, "type": kind}
        accessor["min"] = [min(values[i::size]) for i in range(size)]
        accessor["max"] = [max(values[i::size]) for i in range(size)]
        accessors.append(accessor)
        binary += struct.pack(f"<{len(values)}f", *values)
    views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": 12})
    accessors.append({"bufferView": len(views) - 1, "componentType": 5123, "count": 6, "type": "SCALAR"})
    binary += struct.pack("<6H", 0, 1, 2, 0, 2, 3)
    primitive = {
        "attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2},
        "indices": len(accessors) - 1,
        "material": 0,
    }
    mesh = {"name": "face", "primitives": [primitive]}
    if targets:
        primitive["targets"] = [{"POSITION": 3 + i} for i in range(len(targets))]
        mesh["extras"] = {"targetNames": list(targets)}
    content = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"name": "face", "mesh": 0}],
        "meshes": [mesh],
        "materials": [{"name": "skin", **(material or {})}],
        "accessors": accessors,
        "bufferViews": views,
    }
    if normal:
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(normal.data)})
        binary += normal.data
        content["images"] = [{"bufferView": len(views) - 1, "mimeType": normal.mime_type}]
        content["textures"] = [{"source": 0}]
        content["materials"][0].setdefault("normalTexture", {})["index"] = 0
    content["buffers"] = [{"byteLength": len(binary)}]
    text = json.dumps(content).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    out = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(binary), 0x004E4942) + binary
    return b"glTF" + struct.pack("<II", 2, 12 + len(out)) + out


def wrinkles_of(path, material="skin"):
    """Return the wrinkle extension of a material in a file, and the GltfFile with its images."""
    file = GltfFile(path)
    json_ = next(item for item in file.json["materials"] if item["name"] == material)
    return json_.get("extensions", {}).get("FURROW_wrinkle_maps"), file

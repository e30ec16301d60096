"""Tests reading images, and adding wrinkles to existing files."""

import base64
import json
import struct
import tempfile
import unittest
from pathlib import Path

from furrow.format.container import GltfFile, ImageFile, add_wrinkles
from furrow.format.document import EXTENSION
from furrow.format.reader import FurrowError

PNG = b"\x89PNG\r\n\x1a\n" + bytes(range(60))
WEBP = b"RIFF\0\0\0\0WEBP" + bytes(9)
DOCUMENT = {
    "layers": [{"name": "skin", "kind": "replace", "normalTexture": {"index": 0, "scale": 1}}],
    "areas": [{"name": "nose", "layer": 0, "texture": {"index": 1}, "channel": 0, "combine": "sum", "activation": 0}],
    "drivers": [],
}
IMAGES = [ImageFile("normal", "image/png", PNG), ImageFile("areas", "image/webp", WEBP)]


def glb(content, binary=b""):
    text = json.dumps(content).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
    if binary:
        chunks += struct.pack("<II", len(binary), 0x004E4942) + binary
    return b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks


class ContainerTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, name, data):
        path = self.folder / name
        path.write_bytes(data if isinstance(data, bytes) else json.dumps(data).encode())
        return path

    def test_wrinkles_are_added_to_both_kinds_of_file(self):
        content = {
            "asset": {"version": "2.0"},
            "buffers": [{"byteLength": 4}],
            "materials": [{"name": "eye"}, {"name": "skin", "normalTexture": {"index": 0, "texCoord": 1}}],
        }
        separate = {**content, "buffers": [{"byteLength": 4, "uri": "data:;base64,AAAAAA=="}]}
        for path in (self.write("a.glb", glb(content, b"abcd")), self.write("b.gltf", separate)):
            with self.subTest(path.suffix):
                self.assertEqual(add_wrinkles(path, {"skin": (DOCUMENT, IMAGES), "hair": (DOCUMENT, IMAGES)}), ["skin"])
                file = GltfFile(path)
                extension = file.json["materials"][1]["extensions"][EXTENSION]
                normal, area = extension["layers"][0]["normalTexture"], extension["areas"][0]["texture"]
                self.assertEqual(file.image_of(normal["index"]), IMAGES[0])
                self.assertEqual(file.image_of(area["index"]).data, WEBP)
                self.assertEqual(normal["texCoord"], 1)
                self.assertEqual(set(file.json["extensionsUsed"]), {EXTENSION, "EXT_texture_webp"})
                self.assertNotIn("extensions", file.json["materials"][0])

    def test_a_file_without_these_materials_is_unchanged(self):
        data = glb({"asset": {"version": "2.0"}}, b"abcd")
        path = self.write("a.glb", data)
        self.assertEqual(add_wrinkles(path, {"skin": (DOCUMENT, IMAGES)}), [])
        self.assertEqual(path.read_bytes(), data)

    def test_images_that_cannot_be_read_are_refused(self):
        uri = "data:image/png;base64," + base64.b64encode(PNG).decode()
        content = {
            "textures": [
                {"source": 0},
                {"source": 7},
                {"source": 1},
                {"extensions": {"KHR_texture_basisu": {"source": 0}}},
                {"source": 2},
                {"source": 3},
            ],
            "images": [{"uri": uri}, {"uri": "missing.png"}, {"bufferView": 0}, {"uri": "data:;base64,AAAA"}],
            "bufferViews": [{"buffer": 0, "byteLength": 99}],
            "buffers": [{"byteLength": 4}],
        }
        file = GltfFile(self.write("a.glb", glb(content, b"abcd")))
        self.assertEqual(file.image_of(0).data, PNG)
        for texture in (1, 2, 3, 4, 5, 6):
            with self.subTest(texture), self.assertRaises(FurrowError):
                file.image_of(texture)

    def test_truncated_files_are_refused(self):
        data = glb({"asset": {"version": "2.0"}}, b"abcd")
        for length in range(len(data)):
            with self.subTest(length), self.assertRaises(FurrowError):
                GltfFile(self.write("a.glb", data[:length]))


if __name__ == "__main__":
    unittest.main()

"""Tests that import and export keep layers, areas, drivers and pixels, and write valid files."""

import base64
import subprocess
import unittest

import bpy

from furrow.exporter import restore_materials
from furrow.format.container import ImageFile
from furrow.format.document import SLOTS, read_document
from furrow.material import group_node
from support import FLAT, ROOT, BlenderTest, document, image, wrinkles_of

#: A lossless WebP image of 8 x 8 texels with the colour (128, 128, 255), as base64.
WEBP = "UklGRh4AAABXRUJQVlA4TBEAAAAvB8ABAAdQwAL2v/+BiOh/AAA="
IMAGES = [image("normal", FLAT), image("areas", lambda x, y: (x * 30, y * 30, 90))]


def comparable(path):
    """Read the document of a file. Replaces texture indices by the bytes of the images, and rounds numbers."""
    extension, file = wrinkles_of(path)
    found = read_document(extension, file.texture_count)
    for owner, slots in ((found["layers"], SLOTS), (found["areas"], ["texture"])):
        for item in owner:
            for slot in slots:
                if slot in item:
                    item[slot]["index"] = file.image_of(item[slot]["index"]).data
                    for field in ("scale", "strength", "amplitude"):
                        if field in item[slot]:
                            item[slot][field] = float(f"{item[slot][field]:.6g}")
    return found


def validate(path):
    command = ["node", ROOT / "packages/cli/bin/furrow.js", "validate", path]
    result = subprocess.run(command, capture_output=True, text=True, timeout=60)
    return result.returncode, result.stdout + result.stderr


class RoundTripTest(BlenderTest):
    def check(self, source):
        self.import_face(source)
        written = self.export_face()
        self.assertEqual(comparable(written), comparable(source))
        code, text = validate(written)
        self.assertEqual(code, 0, text)
        return written

    def test_the_shipped_face(self):
        written = self.check(ROOT / "faces" / "human.glb")
        # Blender's exporter found the textures of the material, although the wrinkle group is linked to them.
        material = next(item for item in wrinkles_of(written)[1].json["materials"] if item["name"] == "skin")
        self.assertIn("normalTexture", material)
        self.assertIn("baseColorTexture", material["pbrMetallicRoughness"])
        self.assertIn("metallicRoughnessTexture", material["pbrMetallicRoughness"])

    def test_joints_delays_and_unknown_fields(self):
        self.check(ROOT / "faces" / "hand.glb")
        self.empty()
        drivers = [
            {"type": "breath", "depth": 3, "extras": {"a": [1]}},
            {"type": "tension", "area": "nose", "measure": "stretch", "curve": [[0, 0], [0.123456789, 1]]},
            {"type": "expression", "name": "sad", "targets": [{"name": "a", "weight": 0.3}], "activations": []},
            {"type": "time", "area": "nose", "attack": 0.1, "release": 0.7},
        ]
        made = document(
            [{"name": "nose", "extras": {"b": 1}, "activation": 0.35}, "Stirn / ärgerlich"], drivers=drivers
        )
        made["strokes"] = {"version": 1, "strokes": []}
        made["shapes"] = [{"mesh": "face", "target": "a", "shape": "jawOpen", "extras": {"c": 2}}, {"target": "b"}]
        made["layers"][0]["later"] = "kept"
        self.check(self.write_face(made, IMAGES, targets=["a"]))

    def test_corrections_follow_a_renamed_mesh(self):
        made = document()
        made["shapes"] = [{"mesh": "face", "target": "a", "shape": "jawOpen"}, {"mesh": "other", "target": "a"}]
        path = self.write_face(made, IMAGES, targets=["a"])
        # If an object or a mesh with this name exists, Blender appends a number to the name of the imported one.
        bpy.data.objects.new("face", bpy.data.meshes.new("face"))
        self.import_face(path)
        written = wrinkles_of(self.export_face())[0]["shapes"]
        self.assertEqual(written, [{"mesh": "face.001", "target": "a", "shape": "jawOpen"}, made["shapes"][1]])

    def test_malformed_corrections_are_kept(self):
        made = document()
        made["shapes"] = {"no": "list"}
        self.check(self.write_face(made, IMAGES, targets=["a"]))

    def test_webp_stays_webp(self):
        flat = ImageFile("normal", "image/webp", base64.b64decode(WEBP))
        self.check(self.write_face(document(), [flat, IMAGES[1]], targets=["a"]))

    def test_separate_files(self):
        self.import_face(self.write_face(document(), IMAGES, targets=["a"], normal=IMAGES[0]))
        before = comparable(self.folder / "face.glb")
        written = self.export_face("separate.gltf", export_format="GLTF_SEPARATE")
        self.assertEqual(comparable(written), before)
        self.assertEqual(validate(written)[0], 0)

    def test_an_export_keeps_the_material(self):
        group = self.import_face(ROOT / "faces" / "human.glb")
        node = group_node(bpy.data.materials["skin"])

        def links():
            tree = bpy.data.materials["skin"].node_tree
            return sorted((a.from_socket.name, a.from_node.name, a.to_node.name, a.to_socket.name) for a in tree.links)

        before = links()
        self.export_face()
        self.assertEqual(links(), before)
        self.assertFalse(node.mute)
        self.assertEqual(group_node(bpy.data.materials["skin"]).node_tree, group)

    def test_a_failed_export_keeps_the_material(self):
        self.import_face(self.write_face(document(), IMAGES, targets=["a"]))
        (self.folder / "file").write_text("not a folder")
        with self.assertRaises(RuntimeError):
            bpy.ops.export_scene.gltf(filepath=str(self.folder / "file" / "out.glb"))
        restore_materials()
        node = group_node(bpy.data.materials["skin"])
        self.assertTrue(node.outputs["Normal"].is_linked)

    def test_painted_images_are_exported(self):
        group = self.import_face(self.write_face(document(), IMAGES, targets=["a"]))
        painted = group.furrow.areas[0].image
        pixels = list(painted.pixels)
        pixels[0:4] = (0.2, 0.4, 0.6, 1)
        painted.pixels = pixels
        written = self.export_face()
        self.empty()
        again = self.import_face(written).furrow.areas[0].image
        for a, b in zip(again.pixels, pixels, strict=True):
            self.assertAlmostEqual(a, b, delta=1 / 255)

    def test_an_incomplete_set_exports_the_plain_face(self):
        group = self.import_face(self.write_face(document(), IMAGES, targets=["a"]))
        group.furrow.areas[0].image = None
        written = self.export_face()
        self.assertIsNone(wrinkles_of(written)[0])


if __name__ == "__main__":
    unittest.main()

"""Tests the import of valid and damaged files."""

import json
import unittest

import bpy

from furrow.format.container import GltfFile, write_glb
from furrow.format.document import EXTENSION
from furrow.material import group_node
from support import FLAT, ROOT, BlenderTest, document, image, small_face, wrinkles_of

IMAGES = [image("normal", FLAT), image("areas", (255, 0, 0))]


class ImportTest(BlenderTest):
    def test_a_face_becomes_a_group_with_its_layers_and_areas(self):
        group = self.import_face(ROOT / "faces" / "human.glb")
        wrinkles = group.furrow
        extension, _ = wrinkles_of(ROOT / "faces" / "human.glb")
        self.assertEqual([layer.name for layer in wrinkles.layers], [item["name"] for item in extension["layers"]])
        self.assertEqual([area.name for area in wrinkles.areas], [item["name"] for item in extension["areas"]])
        self.assertEqual(len(wrinkles.drivers), len(extension["drivers"]))
        self.assertEqual(wrinkles.face.name, "skin")
        self.assertEqual(wrinkles.notes.splitlines()[0], "Not shown: occlusion of expression")
        node = group_node(bpy.data.materials["skin"])
        self.assertEqual(node.inputs["Normal"].links[0].from_node.type, "TEX_IMAGE")
        self.assertEqual(node.outputs["Normal"].links[0].to_node.type, "NORMAL_MAP")

    def test_a_face_without_wrinkles_gets_no_group(self):
        path = self.folder / "plain.glb"
        path.write_bytes(small_face())
        self.assertIsNone(self.import_face(path))

    def test_a_separate_file_is_read_with_its_images(self):
        path = self.folder / "face.gltf"
        content = GltfFile(ROOT / "faces" / "hand.glb")
        (self.folder / "face.bin").write_bytes(content.binary)
        content.json["buffers"][0]["uri"] = "face.bin"
        path.write_text(json.dumps(content.json))
        self.assertEqual(len(self.import_face(path).furrow.areas), 29)

    def test_a_material_without_a_normal_map_gets_one(self):
        group = self.import_face(self.write_face(document(), IMAGES, targets=["a"]))
        node = group_node(bpy.data.materials["skin"])
        self.assertEqual(node.outputs["Normal"].links[0].to_node.type, "NORMAL_MAP")
        self.assertEqual(node.inputs["UV"].links[0].from_node.type, "UVMAP")
        self.assertEqual(group.furrow.face.name, "face")

    def test_an_unlit_material_keeps_its_plain_face(self):
        self.check_refused(self.write_face(document(), IMAGES, material={"extensions": {"KHR_materials_unlit": {}}}))

    def test_an_error_costs_the_wrinkles_and_one_warning(self):
        png, jpeg = IMAGES[0], b"\xff\xd8\xff" + bytes(20)
        broken = {
            "no layers": {"layers": []},
            "no areas": {"areas": None},
            "an unknown texture": {"layers": [{"name": "skin", "normalTexture": {"index": 99}}]},
            "a word as the drivers": {"drivers": "none"},
            "a slice": {"layers": [{"name": "skin", "normalTexture": {"index": 0, "slice": 0}}]},
        }
        for name, change in broken.items():
            with self.subTest(name):
                path = self.write_face(document(), IMAGES)
                self.change(path, change)
                self.check_refused(path)
        for name, data in {"half a PNG": png.data[:40], "no JPEG": jpeg}.items():
            with self.subTest(name):
                damaged = type(png)("normal", png.mime_type, data)
                self.check_refused(self.write_face(document(), [damaged, IMAGES[1]]))

    def test_a_malformed_driver_is_skipped_with_a_warning(self):
        drivers = [{"type": "morph", "area": "chin"}, {"type": "age", "area": "nose", "curve": [[20, 0], [60, 1]]}]
        path = self.write_face(document(), IMAGES)
        self.change(path, {"drivers": drivers})
        group, warnings = self.import_with_warnings(path)
        self.assertEqual(len(group.furrow.drivers), 1)
        self.assertEqual(len(warnings), 1)
        self.assertIn("drivers[0].area", warnings[0])

    def test_key_frames_of_activations_are_skipped_with_a_warning(self):
        path = self.write_face(document(), IMAGES)
        file = GltfFile(path)
        pointer = f"/materials/0/extensions/{EXTENSION}/areas/0/activation"
        target = {"path": "pointer", "extensions": {"KHR_animation_pointer": {"pointer": pointer}}}
        sampler = {"input": 0, "output": 0}
        file.json["animations"] = [{"samplers": [sampler], "channels": [{"sampler": 0, "target": target}]}]
        file.json["extensionsUsed"].append("KHR_animation_pointer")
        path.write_bytes(write_glb(file.json, file.binary))
        group, warnings = self.import_with_warnings(path)
        self.assertEqual(len(group.furrow.areas), 1)
        self.assertEqual(len(warnings), 1)
        self.assertIn("key frames", warnings[0])

    def change(self, path, change):
        file = GltfFile(path)
        extensions = file.json["materials"][0]["extensions"]
        extensions[EXTENSION] = {**extensions[EXTENSION], **change}
        path.write_bytes(write_glb(file.json, file.binary))

    def check_refused(self, path):
        images, groups = len(bpy.data.images), len(bpy.data.node_groups)
        group, warnings = self.import_with_warnings(path)
        self.assertIsNone(group)
        self.assertEqual(len(warnings), 1, warnings)
        self.assertIn("without wrinkles", warnings[0])
        self.assertTrue(any(item.type == "MESH" for item in bpy.data.objects))
        self.assertEqual((len(bpy.data.images), len(bpy.data.node_groups)), (images, groups))

    def import_with_warnings(self, path):
        from furrow import importer

        warnings = []
        original = importer._warn
        importer._warn = lambda gltf, text: (warnings.append(text), original(gltf, text))
        try:
            return self.import_face(path), warnings
        finally:
            importer._warn = original


if __name__ == "__main__":
    unittest.main()

"""Tests that wrinkles in a saved .blend file work without the imported glTF file, and without the extension."""

import unittest

import addon_utils
import bpy

from support import FLAT, BlenderTest, document, image, wrinkles_of

IMAGES = [image("normal", FLAT), image("areas", (255, 0, 0))]
DRIVER = {"type": "morph", "area": "nose", "targets": [{"name": "brow", "weight": 0.5}]}


class SavedTest(BlenderTest):
    def setUp(self):
        super().setUp()
        face = self.write_face(
            document([{"name": "nose", "activation": 0.1}], drivers=[DRIVER]), IMAGES, targets=["brow"]
        )
        self.import_face(face)
        self.path = self.folder / "face.blend"
        bpy.ops.wm.save_as_mainfile(filepath=str(self.path))
        face.unlink()
        bpy.ops.wm.read_factory_settings(use_empty=True)

    def check(self):
        group = next(item for item in bpy.data.node_groups if "Steps" in item.nodes)
        keys = bpy.data.shape_keys[0].key_blocks
        keys["brow"].value = 0.8
        bpy.context.view_layer.update()
        self.assertAlmostEqual(group.nodes["Steps"]["a0"], 0.5, 6)

    def test_it_can_be_opened_and_exported(self):
        addon_utils.enable("furrow", default_set=True)
        bpy.ops.wm.open_mainfile(filepath=str(self.path))
        self.check()
        extension, file = wrinkles_of(self.export_face())
        self.assertEqual(extension["areas"][0]["activation"], 0.1)
        self.assertEqual(file.image_of(extension["areas"][0]["texture"]["index"]).data, IMAGES[1].data)

    def test_drivers_and_nodes_work_without_the_extension(self):
        addon_utils.disable("furrow", default_set=True)
        bpy.ops.wm.open_mainfile(filepath=str(self.path))
        self.check()


if __name__ == "__main__":
    unittest.main()

"""Tests that the panel only uses properties and operators that exist. Draws it on a fake layout."""

import unittest
from types import SimpleNamespace

import bpy

from furrow import panel
from support import FLAT, BlenderTest, document, image

IMAGES = [image("normal", FLAT), image("areas", (255, 0, 0))]


class Layout:
    """Replaces Blender's layout, which would need a window."""

    def __init__(self):
        self.lines = []

    def row(self, **_):
        return self

    column = box = row

    def label(self, text="", icon="NONE"):
        self.lines.append(text)

    def prop(self, data, name, text=None, **_):
        data.path_resolve(name)
        self.lines.append(name if text is None else text)

    def operator(self, name, text=None, **_):
        kind, function = name.split(".")
        operator = getattr(getattr(bpy.ops, kind), function)
        self.lines.append(operator.get_rna_type().name if text is None else text)
        return SimpleNamespace()

    def template_list(self, kind, _id, data, name, active_data, active, rows):
        assert hasattr(bpy.types, kind)
        drawn = getattr(panel, kind)
        for i, item in enumerate(getattr(data, name)):
            words = (None, self, data, item, 0, active_data, active)
            drawn.draw_item(self, *words, *([i] if kind == "FURROW_UL_areas" else []))

    def template_ID(self, data, name, new, open, text=""):
        assert isinstance(data.bl_rna.properties[name], bpy.types.PointerProperty)
        self.lines.append(text)


class PanelTest(BlenderTest):
    def draw(self):
        layout = Layout()
        context = bpy.context
        for cls in panel.CLASSES:
            if issubclass(cls, bpy.types.Panel) and cls.poll(context):
                cls.draw(SimpleNamespace(layout=layout), context)
        return layout.lines

    def test_it_shows_the_set_and_notes_unsupported_drivers(self):
        links = [{"name": "brow", "weight": 0.5}]
        drivers = [
            {"type": "morph", "area": "nose", "targets": links},
            {"type": "age", "area": "nose", "curve": [[20, 0], [60, 1]]},
            {"type": "time", "area": "nose", "attack": 1},
            {"type": "tension", "area": "nose", "curve": [[0, 0], [0.2, 1]]},
        ]
        self.import_face(self.write_face(document(drivers=drivers), IMAGES, targets=["brow"]))
        bpy.context.view_layer.objects.active = bpy.data.objects["face"]
        lines = self.draw()
        for line in ("New Wrinkle Set", "Not there"):
            self.assertNotIn(line, lines)
        for line in ("Remove Wrinkle Set", "0.5 brow", "age", "rises in 1 s, falls in 0 s", "At Rest"):
            self.assertIn(line, lines)
        self.assertIn("Not shown: tension: a driver cannot measure the deformed skin", lines)
        self.assertEqual(lines.count("Exported, but not shown in Blender"), 1)

    def test_a_plain_material_offers_a_new_set(self):
        bpy.ops.mesh.primitive_cube_add()
        bpy.context.object.data.materials.append(bpy.data.materials.new("skin"))
        self.assertEqual(self.draw(), ["New Wrinkle Set", "Make Wrinkles Automatically"])


if __name__ == "__main__":
    unittest.main()

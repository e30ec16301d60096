"""Tests that a user can add a wrinkle set to a material, edit its areas, layers and links, and export a valid file."""

import os
import stat
import sys
import unittest

import bpy
import numpy as np

from furrow.images import image_from_file
from furrow.material import group_node, wrinkle_group
from furrow.operators.base import drivers_of
from furrow.rig import activation_of
from furrow.weights import draw_weights
from support import FLAT, ROOT, BlenderTest, document, image, set_weights, small_face, wrinkles_of
from test_round_trip import validate


class AuthorTest(BlenderTest):
    def setUp(self):
        super().setUp()
        path = self.folder / "plain.glb"
        path.write_bytes(small_face(targets=["brow", "jaw"], normal=image("own", FLAT)))
        self.import_face(path)
        self.face = bpy.data.objects["face"]
        bpy.context.view_layer.objects.active = self.face

    def new_set(self):
        bpy.ops.furrow.new_set()
        tree = wrinkle_group(self.face.active_material)
        tree.furrow.layers[0].normal = image_from_file(image("lines", FLAT))
        return tree

    def paint(self, name, weights):
        group = self.face.vertex_groups.new(name=name)
        for vertex, weight in enumerate(weights):
            group.add([vertex], weight, "REPLACE")
        self.face.vertex_groups.active = group

    def test_a_set_is_authored_and_exported(self):
        tree = self.new_set()
        self.paint("forehead", [0, 0, 1, 1])
        bpy.ops.furrow.area_from_vertex_group(size=32)
        self.face.active_shape_key_index = 1
        bpy.ops.furrow.link_shape_key(weight=0.5, start=0.2, full=0.6)
        bpy.ops.furrow.link_shape_key(target="jaw", weight=-0.25)
        set_weights(tree, {"brow": 0.6, "jaw": 0.4})
        self.assertAlmostEqual(activation_of(tree, 0), 0.4, 6)
        written = self.export_face()
        code, text = validate(written)
        self.assertEqual(code, 0, text)
        extension, _ = wrinkles_of(written)
        self.assertEqual(extension["areas"][0]["name"], "forehead")
        self.assertEqual(
            extension["drivers"][0]["targets"],
            [
                {"name": "brow", "weight": 0.5, "curve": [[0.2, 0], [0.6, 1]]},
                {"name": "jaw", "weight": -0.25},
            ],
        )

    def test_weights_are_drawn_where_the_triangles_are(self):
        corners = [[(0, 0), (1, 0), (1, 1)], [(0, 0), (1, 1), (0, 1)]]
        drawn = draw_weights(corners, [[0, 1, 1], [0, 1, 0]], 16)
        expected = np.tile((np.arange(16) + 0.5) / 16, (16, 1))
        np.testing.assert_allclose(drawn, expected, atol=1e-6)
        # The margin is two texels wide.
        small = draw_weights([[(0, 0), (0.25, 0), (0, 0.25)]], [[1, 1, 1]], 16, margin=2)
        self.assertEqual(small[5, 0], 1)
        self.assertEqual(small[8, 8], 0)

    def test_a_repainted_group_redraws_its_area(self):
        tree = self.new_set()
        self.paint("forehead", [0, 0, 1, 1])
        bpy.ops.furrow.area_from_vertex_group(size=8)
        self.face.vertex_groups["forehead"].add([0, 1, 2, 3], 0.5, "REPLACE")
        bpy.ops.furrow.area_from_vertex_group(size=8)
        self.assertEqual(len(tree.furrow.areas), 1)
        np.testing.assert_allclose(np.array(tree.furrow.areas[0].image.pixels)[0::4], 0.5, atol=1 / 255)

    def test_areas_are_renamed_and_removed_with_their_drivers(self):
        tree = self.new_set()
        for name, rest in (("a", 0.1), ("b", 0.2), ("c", 0.3)):
            bpy.ops.furrow.area_add(name=name)
            tree.furrow.areas[-1].activation = rest
            bpy.ops.furrow.link_shape_key(target="brow")
        tree.furrow.areas[2].name = "chin"
        self.assertEqual([item["area"] for item in drivers_of(tree)], ["a", "b", "chin"])
        tree.furrow.active_area = 1
        bpy.ops.furrow.area_remove()
        self.assertEqual([item["area"] for item in drivers_of(tree)], ["a", "chin"])
        self.assertEqual([round(area.activation, 3) for area in tree.furrow.areas], [0.1, 0.3])

    def test_layers_are_added_and_removed(self):
        tree = self.new_set()
        bpy.ops.furrow.layer_add()
        bpy.ops.furrow.area_add(name="a")
        self.assertEqual(tree.furrow.areas[0].layer, 1)
        bpy.ops.furrow.layer_remove()
        self.assertEqual(tree.furrow.areas[0].layer, 0)
        with self.assertRaises(RuntimeError):
            bpy.ops.furrow.layer_remove()

    def test_removing_a_map_restores_the_link_to_the_texture(self):
        self.import_face(ROOT / "faces" / "human.glb")
        material = bpy.data.materials["skin.001"]
        tree = wrinkle_group(material)
        shader = next(node for node in material.node_tree.nodes if node.type == "BSDF_PRINCIPLED")
        self.assertEqual(shader.inputs["Base Color"].links[0].from_node, group_node(material))
        tree.furrow.layers[0].blood = None
        self.assertEqual(shader.inputs["Base Color"].links[0].from_node.type, "TEX_IMAGE")
        tree.furrow.layers[0].blood = tree.furrow.layers[0].occlusion
        self.assertEqual(shader.inputs["Base Color"].links[0].from_node, group_node(material))
        self.assertEqual(group_node(material).inputs["Base Color"].links[0].from_node.type, "TEX_IMAGE")

    def test_a_material_without_a_shader_can_be_exported(self):
        tree = self.new_set()
        nodes = self.face.active_material.node_tree.nodes
        nodes.remove(next(node for node in nodes if node.type == "BSDF_PRINCIPLED"))
        tree.furrow.layers[0].kind = "detail"
        self.export_face()

    def test_removing_a_set_restores_the_plain_material(self):
        material = self.face.active_material

        def links():
            return sorted((a.from_node.name, a.to_node.name, a.to_socket.name) for a in material.node_tree.links)

        before, groups = links(), len(bpy.data.node_groups)
        self.new_set()
        bpy.ops.furrow.remove_set()
        self.assertIsNone(group_node(material))
        self.assertEqual(links(), before)
        self.assertEqual(len(bpy.data.node_groups), groups)

    def test_a_multires_sculpt_is_baked(self):
        tree = self.new_set()
        modifier = self.face.modifiers.new("sculpt", "MULTIRES")
        for _ in range(3):
            bpy.ops.object.multires_subdivide(modifier="sculpt")
        self.sculpt(modifier)
        bpy.ops.furrow.layer_bake(size=32)
        layer = tree.furrow.layers[0]
        self.assertEqual(layer.kind, "detail")
        normals = np.array(layer.normal.pixels).reshape(32, 32, 4)[..., :3] * 2 - 1
        # The sculpt is a hill, so normals on its left lean to the left.
        self.assertLess(normals[16, 4, 0], -0.1)
        self.assertGreater(normals[16, 27, 0], 0.1)
        self.assertGreater(normals[..., 2].min(), 0)

    def sculpt(self, modifier):
        """Lift the middle of the mesh, as a sculpting brush would."""
        copy = self.face.copy()
        copy.data = self.face.data.copy()
        copy.shape_key_clear()
        bpy.context.scene.collection.objects.link(copy)
        copy.modifiers["sculpt"].levels = modifier.total_levels
        with bpy.context.temp_override(object=copy, active_object=copy):
            bpy.ops.object.modifier_apply(modifier="sculpt")
        for vertex in copy.data.vertices:
            x, _, z = vertex.co
            vertex.co.y -= 0.2 * max(0, 0.25 - (x - 0.5) ** 2 - (z - 0.5) ** 2)
        self.face.select_set(True)
        copy.select_set(True)
        bpy.context.view_layer.objects.active = self.face
        modifier.levels = modifier.total_levels
        bpy.ops.object.multires_reshape(modifier="sculpt")
        bpy.data.objects.remove(copy)

    def test_make_automatically_runs_the_command(self):
        files = [image("n", FLAT), image("w", (9, 9, 9))]
        made = self.write_face(document(["brows"]), files, "made.glb", targets=["brow"])
        self.command(f"import shutil, sys; shutil.copy({str(made)!r}, sys.argv[sys.argv.index('-o') + 1])")
        bpy.ops.furrow.make_automatically()
        tree = wrinkle_group(self.face.active_material)
        self.assertEqual(tree.furrow.areas[0].name, "brows")
        self.assertEqual(tree.furrow.face, self.face)
        # A second run replaces the first set.
        bpy.ops.furrow.make_automatically()
        self.assertIsNotNone(wrinkle_group(self.face.active_material))
        self.assertEqual(sum(group.furrow.is_wrinkles for group in bpy.data.node_groups), 1)

    def test_make_automatically_reports_errors(self):
        self.command("import sys; sys.exit('furrow auto: no brows; use a face')")
        with self.assertRaisesRegex(RuntimeError, "no brows"):
            bpy.ops.furrow.make_automatically()
        bpy.context.preferences.addons["furrow"].preferences.command = "/nowhere/furrow"
        with self.assertRaisesRegex(RuntimeError, "npm install"):
            bpy.ops.furrow.make_automatically()
        self.assertIsNone(wrinkle_group(self.face.active_material))

    def command(self, code):
        """Set the command in the preferences to a script that runs Python code."""
        path = self.folder / "furrow-command"
        path.write_text(f"#!{sys.executable}\n{code}\n")
        os.chmod(path, path.stat().st_mode | stat.S_IEXEC)
        bpy.context.preferences.addons["furrow"].preferences.command = str(path)


if __name__ == "__main__":
    unittest.main()

"""Tests that delayed activations follow their drivers from frame to frame."""

import math
import unittest

import bpy

from furrow.rig import activation_of
from support import FLAT, BlenderTest, document, image, set_weights

IMAGES = [image("normal", FLAT), image("areas", (255, 255, 255))]
RATE = 25
ATTACK, RELEASE = 0.2, 0.5
DRIVERS = [
    {"type": "morph", "area": "nose", "targets": [{"name": "up"}]},
    {"type": "area", "area": "chin", "areas": [{"name": "nose"}]},
    {"type": "time", "area": "nose", "attack": ATTACK, "release": RELEASE},
]


class DelaysTest(BlenderTest):
    def setUp(self):
        super().setUp()
        self.group = self.import_face(
            self.write_face(document(["nose", "chin"], drivers=DRIVERS), IMAGES, targets=["up"])
        )
        self.scene = bpy.context.scene
        self.scene.render.fps = RATE
        self.scene.frame_set(1)

    def shown(self):
        return activation_of(self.group, 0)

    def test_skin_creases_quickly_and_relaxes_slowly(self):
        set_weights(self.group, {"up": 1})
        for frame in range(2, 12):
            self.scene.frame_set(frame)
        risen = 1 - math.exp(-10 / RATE / ATTACK)
        self.assertAlmostEqual(self.shown(), risen, 5)
        self.assertAlmostEqual(activation_of(self.group, 1), 1, 6)
        set_weights(self.group, {"up": 0})
        self.scene.frame_set(16)
        self.assertAlmostEqual(self.shown(), risen * math.exp(-5 / RATE / RELEASE), 5)

    def test_no_delay_without_a_frame_change(self):
        set_weights(self.group, {"up": 0.6})
        self.assertAlmostEqual(self.shown(), 0.6, 6)

    def test_repeating_a_frame_keeps_delays_and_going_back_resets_them(self):
        set_weights(self.group, {"up": 1})
        self.scene.frame_set(3)
        shown = self.shown()
        self.assertLess(shown, 0.5)
        # Motion blur goes back and forth by fractions of a frame.
        for frame, part in ((3, 0.0), (2, 0.75), (3, 0.0)):
            self.scene.frame_set(frame, subframe=part)
            self.assertAlmostEqual(self.shown(), shown, 6)
        self.scene.frame_set(1)
        self.assertAlmostEqual(self.shown(), 1, 6)

    def test_a_rendered_animation_has_delays(self):
        block = self.group.furrow.face.data.shape_keys.key_blocks["up"]
        for frame, value in ((1, 0), (2, 1)):
            block.value = value
            block.keyframe_insert("value", frame=frame)
        background = self.show_in_background()
        render = self.scene.render
        render.engine = "CYCLES"
        self.scene.cycles.samples = 1
        self.scene.view_settings.view_transform = "Raw"
        render.dither_intensity = 0
        render.resolution_x = render.resolution_y = 4
        render.filepath = str(self.folder / "frame")
        self.scene.frame_start, self.scene.frame_end = 1, 6
        bpy.ops.render.render(animation=True)
        background.driver_remove("default_value")
        for frame in range(1, 7):
            rendered = self.first_pixel(f"frame{frame:04}.png")
            background.default_value = 1 - math.exp(-(frame - 1) / RATE / ATTACK)
            render.filepath = str(self.folder / "expected.png")
            bpy.ops.render.render(write_still=True)
            self.assertAlmostEqual(rendered, self.first_pixel("expected.png"), delta=1 / 255, msg=f"frame {frame}")

    def first_pixel(self, name):
        image = bpy.data.images.load(str(self.folder / name))
        value = image.pixels[0]
        bpy.data.images.remove(image)
        return value

    def show_in_background(self):
        """
        Create a camera, and a world background whose brightness is the activation of the area.

        Returns the socket of the brightness.
        """
        world = bpy.data.worlds.new("world")
        world.use_nodes = True
        background = world.node_tree.nodes["Background"].inputs["Strength"]
        curve = background.driver_add("default_value")
        curve.keyframe_points.clear()
        curve.driver.type = "SUM"
        target = curve.driver.variables.new().targets[0]
        target.id_type, target.id, target.data_path = "NODETREE", self.group, 'nodes["Steps"]["s0"]'
        self.scene.world = world
        bpy.ops.object.camera_add(location=(0, 0, 3), rotation=(math.pi, 0, 0))
        self.scene.camera = bpy.context.object
        return background

    def test_a_saved_file_has_no_lag(self):
        set_weights(self.group, {"up": 1})
        self.scene.frame_set(3)
        self.assertLess(self.shown(), 0.5)
        bpy.ops.wm.save_as_mainfile(filepath=str(self.folder / "face.blend"))
        self.assertEqual(self.group["late0"], 0)


if __name__ == "__main__":
    unittest.main()

"""
Compares activations and error messages with the expected results of the conformance suite's samples.

test_shading.py compares rendered normals and colours. If the environment variable FURROW_CONFORMANCE_REPORT names a
file, the results are written to it as JSON, for the table of docs/conformance.md.
"""

import json
import os
from pathlib import Path

import bpy

from furrow.rig import activation_of
from support import ROOT, BlenderTest, set_weights

FILES = ROOT / "conformance" / "files"

# Samples that Blender does not support, with reasons.
MISSING = {
    "ktx2": "KTX 2 images",
    "meshopt": "Blender does not read EXT_meshopt_compression",
    "muscle": "muscles do not become shape keys",
    "tension": "tension is kept as data",
    "tension-direction": "tension is kept as data",
}


class ConformanceTest(BlenderTest):
    def test_samples(self):
        results = {}
        for path in sorted(FILES.glob("*.json")):
            if path.stem in MISSING:
                continue
            with self.subTest(path.stem):
                results[path.stem] = False
                self.empty()
                self.check(FILES / f"{path.stem}.glb", json.loads(path.read_text()))
                results[path.stem] = True
        self.assertGreater(len(results), 50)
        if report := os.environ.get("FURROW_CONFORMANCE_REPORT"):
            Path(report).write_text(json.dumps(results))

    def check(self, path, expected):
        group = self.import_face(path)
        self.assertEqual(group is None, "refused" in expected)
        scene = bpy.context.scene
        scene.render.fps = 100
        scene.frame_set(0)
        for pose in expected.get("poses", []):
            blocks = group.furrow.face.data.shape_keys
            names = blocks.key_blocks.keys()[1:] if blocks else []
            for item in group.furrow.inputs:
                if item.name in pose.get("inputs", {}):
                    item.value = pose["inputs"][item.name]
            for item in bpy.data.objects:
                if item.type == "EMPTY":
                    self.pose_node(item, pose)
            if names:
                set_weights(group, {name: pose.get("weights", {}).get(name, 0) for name in names})
            bpy.context.view_layer.update()
            if seconds := pose.get("seconds"):
                scene.frame_set(scene.frame_current + round(100 * seconds))
            activations = {area.name: activation_of(group, i) for i, area in enumerate(group.furrow.areas)}
            self.assertEqual(set(activations), set(pose["activations"]))
            for name, activation in pose["activations"].items():
                self.assertAlmostEqual(activations[name], activation, delta=1e-6, msg=name)

    def pose_node(self, item, pose):
        """Rotate and move a node. Converts the pose from glTF's axes (+Y up) to Blender's (+Z up)."""
        x, y, z, w = pose.get("rotations", {}).get(item.name, (0, 0, 0, 1))
        item.rotation_mode = "QUATERNION"
        item.rotation_quaternion = (w, x, -z, y)
        if item.name in pose.get("translations", {}):
            x, y, z = pose["translations"][item.name]
            item.location = (x, -z, y)

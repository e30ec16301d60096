"""Tests that Blender accepts the .zip as valid, and installs it as an extension."""

import subprocess
import sys
import unittest
from pathlib import Path

import addon_utils
import bpy

from support import ROOT, BlenderTest

sys.path.insert(0, str(ROOT / "blender"))
from build import build, find_problems


class PackageTest(BlenderTest):
    def test_blenders_validator_accepts_it(self):
        archive = build(self.folder / "furrow.zip")
        checker = Path(addon_utils.__file__).parents[1] / "addons_core/bl_pkg/cli/blender_ext.py"
        result = subprocess.run(
            [sys.executable, checker, "validate", archive], capture_output=True, text=True, timeout=60
        )
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_blender_installs_it_and_reads_a_face_with_it(self):
        addon_utils.disable("furrow", default_set=True)
        archive = build(self.folder / "furrow.zip")
        bpy.ops.extensions.package_install_files(filepath=str(archive), repo="user_default", enable_on_install=True)
        try:
            self.assertIn("bl_ext.user_default.furrow", bpy.context.preferences.addons)
            bpy.ops.import_scene.gltf(filepath=str(ROOT / "faces" / "hand.glb"))
            self.assertTrue(any(group.furrow.is_wrinkles for group in bpy.data.node_groups))
        finally:
            addon_utils.disable("bl_ext.user_default.furrow", default_set=True)

    def test_an_invalid_manifest_is_refused(self):
        self.assertEqual(len(find_problems({"license": ["MIT"]})), 9)


if __name__ == "__main__":
    unittest.main()

"""Compares Blender's activations with those of the plan, evaluated in float64, and those of the command line tool."""

import json
import random
import struct
import subprocess
import unittest

import bpy
from mathutils import Matrix, Quaternion, Vector

from evaluate import curve_at, evaluate_plan
from furrow.format.container import GltfFile
from furrow.format.plan import plan_drivers
from furrow.rig import STEPS, activation_of
from furrow.wrinkle_set import document_of
from support import FLAT, ROOT, BlenderTest, document, image, set_weights

IMAGES = [image("normal", FLAT), image("areas", (255, 255, 255))]
TARGETS = ["up", 'out "left"', "browInnerUp_L", "browInnerUp_R", "down"]
AREAS = ["a", "b", "c", "d"]


def morph(area, *names, **more):
    links = [name if isinstance(name, dict) else {"name": name} for name in names]
    return {"type": "morph", "area": area, "targets": links, **more}


DRIVERS = [
    {"type": "conflict", "targets": ["up", "down"]},
    {"type": "conflict", "targets": ["browInnerUp", 'out "left"']},
    morph(
        "a", {"name": "up", "weight": 0.7, "curve": [[0.1, 0], [0.4, 0.9], [1, 1]]}, {"name": "down", "weight": -0.5}
    ),
    morph("a", "browInnerUp", curve=[[0.2, 0.1], [0.8, 0.6]]),
    morph("b", "up", 'out "left"', {"name": "browInnerUp", "weight": 1.5}, rule="min"),
    morph("c", "up", 'out "left"', {"name": "down", "weight": 2}, rule="product"),
    morph("c", "jawOpen", rule="max", curve=[[0, 0.05], [1, 1]]),
    {"type": "area", "area": "d", "areas": [{"name": "a", "weight": 0.5}, {"name": "c"}], "rule": "max"},
    {"type": "age", "area": "b", "curve": [[20, 0], [80, 0.5]], "initial": 50},
    {"type": "input", "name": "cold", "area": "c", "curve": [[0, 0], [10, 0.5]]},
    {"type": "time", "area": "a", "attack": 1},
]


class DriversTest(BlenderTest):
    def check(self, group, areas, expected):
        for i, name in enumerate(areas):
            self.assertAlmostEqual(activation_of(group, i), expected[f"a{i}"], 6, name)

    def test_activations_match_the_plan(self):
        areas = [{"name": name, "activation": 0.1 * i} for i, name in enumerate(AREAS)]
        path = self.write_face(document(areas, drivers=DRIVERS), IMAGES, targets=TARGETS)
        group = self.import_face(path)
        drivers = [json.loads(driver.json) for driver in group.furrow.drivers]
        plan = plan_drivers(drivers, AREAS, TARGETS)
        rng = random.Random(1)
        for _ in range(20):
            weights = {name: rng.uniform(-0.2, 1.2) for name in TARGETS}
            inputs = {"age": rng.uniform(10, 90), "cold": rng.uniform(-2, 12)}
            for item in group.furrow.inputs:
                item.value = inputs[item.name]
            set_weights(group, weights)
            read = {"target": weights, "rest": {i: 0.1 * i for i in range(4)}, "input": inputs, "late": {0: 0}}
            self.check(group, AREAS, evaluate_plan(plan, lambda source, read=read: read[source.kind][source.name]))

    def test_blender_evaluates_expressions_without_running_python(self):
        """In untrusted files, Blender runs no Python, but still evaluates simple expressions."""
        small = self.write_face(document(AREAS, drivers=DRIVERS), IMAGES, targets=TARGETS)
        for path in (small, ROOT / "faces" / "hand.glb", ROOT / "faces" / "neck.glb"):
            self.empty()
            drivers = [curve.driver for curve in self.import_face(path).animation_data.drivers]
            scripted = [driver for driver in drivers if driver.type == "SCRIPTED"]
            self.assertTrue(scripted)
            for driver in scripted:
                self.assertTrue(driver.is_simple_expression, driver.expression)
                self.assertLess(len(driver.expression), 255)

    def test_no_step_is_written_back_by_another_thread(self):
        """
        Test that the group has no driven properties of its own, because Blender sometimes reverts them (see rig.py).

        The effect is too rare to be tested.
        """
        group = self.import_face(self.write_face(document(AREAS, drivers=DRIVERS), IMAGES, targets=TARGETS))
        drivers = group.animation_data.drivers
        self.assertGreater(len(drivers), 20)
        self.assertEqual([curve.data_path for curve in drivers if not curve.data_path.startswith("nodes[")], [])

    def test_1024_links_need_no_long_expression(self):
        names = [f"shape {i} of a rig that names its shapes at length" for i in range(1024)]
        drivers = [morph("a", *[{"name": name, "weight": 0.001} for name in names])]
        group = self.import_face(self.write_face(document(AREAS, drivers=drivers), IMAGES, targets=names))
        set_weights(group, dict.fromkeys(names, 0.5))
        self.assertAlmostEqual(activation_of(group, 0), 0.512, 5)
        longest = max(len(curve.driver.expression) for curve in group.animation_data.drivers)
        self.assertLess(longest, 255)

    def test_the_shipped_face_agrees_with_the_command(self):
        weights = {
            "browInnerUp": 0.8,
            "browOuterUpLeft": 0.3,
            "mouthSmileLeft": 0.9,
            "noseSneerRight": 0.6,
            "jawOpen": 0.2,
        }
        group = self.import_face(ROOT / "faces" / "human.glb")
        set_weights(group, weights)
        command = [
            "node",
            ROOT / "packages/cli/bin/furrow.js",
            "activations",
            ROOT / "faces/human.glb",
            "--json",
            "--set",
        ]
        printed = subprocess.run(
            [*command, *[f"{name}={value}" for name, value in weights.items()]],
            capture_output=True,
            check=True,
            timeout=60,
        )
        expected = {area["area"]: area["activation"] for area in json.loads(printed.stdout)["areas"]}
        self.assertGreater(sum(value > 0.1 for value in expected.values()), 4)
        for i, area in enumerate(group.furrow.areas):
            self.assertAlmostEqual(activation_of(group, i), expected[area.name], 5, area.name)

    def test_joints_are_measured_from_rest(self):
        content = GltfFile(ROOT / "faces" / "hand.glb")
        (self.folder / "hand.bin").write_bytes(content.binary)
        content.json["buffers"][0]["uri"] = "hand.bin"
        for material in content.json["materials"]:
            for driver in material.get("extensions", {}).get("FURROW_wrinkle_maps", {}).get("drivers", []):
                driver.pop("axis", None)
        path = self.folder / "hand.gltf"
        path.write_text(json.dumps(content.json))
        group = self.import_face(path)
        armature = group.furrow.face.find_armature()
        bones = [json.loads(driver.json) for driver in group.furrow.drivers]
        driver = next(
            item for item in bones if item["type"] == "bone" and item["measure"] == "angle" and "axis" not in item
        )
        bone = armature.pose.bones[driver["joints"][1]]
        bone.rotation_mode = "QUATERNION"
        step = f"d{bones.index(driver)}"
        for angle in (0, 0.4, 0.9, 1.4):
            bone.rotation_quaternion = Quaternion((1, 2, -0.5), angle)
            bpy.context.view_layer.update()
            self.assertAlmostEqual(group.nodes[STEPS][step], curve_at(driver["curve"], angle), 4)

    def test_signed_angles_about_an_axis_of_the_joint(self):
        group = self.import_face(ROOT / "faces" / "neck.glb")
        armature = group.furrow.face.find_armature()
        drivers = [json.loads(driver.json) for driver in group.furrow.drivers]
        found = [(i, item) for i, item in enumerate(drivers) if item["type"] == "bone" and "axis" in item]
        self.assertTrue(found)
        for bone in armature.pose.bones:
            # The file is posed, so bones are rotated back to rest.
            bone.rotation_quaternion = (1, 0, 0, 0)
        rests = _inverse_bind_rotations(GltfFile(ROOT / "faces" / "neck.glb"))
        for i, driver in found:
            bone = armature.pose.bones[driver["joints"][1]]
            bone.rotation_mode = "QUATERNION"
            for angle in (-0.6, -0.2, 0.3, 0.7):
                # Converts the axis from the rest frame of the joint to glTF's world (+Y up), then to Blender's world
                # (+Z up), and then to the frame of the bone.
                x, y, z = rests[bone.name].transposed() @ Vector(driver["axis"])
                own = bone.bone.matrix_local.to_3x3().inverted() @ Vector((x, -z, y))
                bone.rotation_quaternion = Quaternion(own, angle)
                bpy.context.view_layer.update()
                self.assertAlmostEqual(group.nodes[STEPS][f"d{i}"], curve_at(driver["curve"], angle), 4, driver)
            bone.rotation_quaternion = (1, 0, 0, 0)

    def test_nodes_other_than_bones_are_measured_in_each_copy_of_a_face(self):
        source = ROOT / "conformance" / "files" / "bone-angle.glb"
        first = self.import_face(source)
        before = set(bpy.data.node_groups)
        self.import_face(source)
        second = next(group for group in bpy.data.node_groups if group not in before and group.furrow.is_wrinkles)
        joints = [joint.object for joint in second.furrow.joints]
        self.assertEqual(len({*joints, *(joint.object for joint in first.furrow.joints)}), 2 * len(joints))
        driver = json.loads(second.furrow.drivers[0].json)
        self.assertEqual(driver["type"], "bone")
        joint = second.furrow.joints[driver["joints"][1]].object
        joint.name = "renamed"
        joint.rotation_quaternion = Quaternion((1, 0, 0), 0.5)
        bpy.context.view_layer.update()
        area = [item.name for item in second.furrow.areas].index(driver["area"])
        self.assertAlmostEqual(activation_of(second, area), curve_at(driver["curve"], 0.5), 5)
        self.assertEqual(activation_of(first, area), curve_at(driver["curve"], 0))
        document, _ = document_of(second)
        self.assertEqual(document["drivers"][0]["joints"][1], "renamed")

    def test_preview_shows_one_area_only(self):
        group = self.import_face(self.write_face(document(AREAS, drivers=DRIVERS[:4]), IMAGES, targets=TARGETS))
        set_weights(group, {"up": 1})
        wrinkles = group.furrow
        before = _node_inputs(group)
        wrinkles.active_area = 2
        wrinkles.preview = True
        bpy.context.view_layer.update()
        self.assertEqual(sorted(_node_inputs(group).values()), [0, 0, 0, 1])
        wrinkles.preview = False
        bpy.context.view_layer.update()
        self.assertEqual(_node_inputs(group), before)


def _inverse_bind_rotations(file):
    skin = file.json["skins"][0]
    data = file.view(file.json["accessors"][skin["inverseBindMatrices"]]["bufferView"])
    rotations = {}
    for i, joint in enumerate(skin["joints"]):
        columns = struct.unpack_from("<16f", data, 64 * i)
        rotations[file.json["nodes"][joint]["name"]] = Matrix([columns[row:12:4] for row in range(3)])
    return rotations


def _node_inputs(group):
    paths = [curve.data_path for curve in group.animation_data.drivers if curve.data_path.endswith(".default_value")]
    return {path: group.path_resolve(path) for path in paths}


if __name__ == "__main__":
    unittest.main()

"""Compares the activations that planned drivers compute with the rules of the specification."""

import unittest

from evaluate import evaluate_plan
from furrow.format.document import read_document
from furrow.format.plan import activation_name, plan_drivers, shown_name

AREAS = ["forehead", "glabella", "nose"]
TEXTURE = {"index": 0}


def document(drivers):
    areas = [{"name": name, "texture": TEXTURE} for name in AREAS]
    layers = [{"name": "skin", "normalTexture": TEXTURE}]
    return read_document({"layers": layers, "areas": areas, "drivers": drivers}, 1)


def activations(drivers, weights, rest=(0, 0, 0), inputs=(), late=()):
    plan = plan_drivers(document(drivers)["drivers"], AREAS, list(weights))
    values = {
        "target": weights,
        "rest": dict(enumerate(rest)),
        "input": {**plan.inputs, **dict(inputs)},
        "late": dict(late),
    }
    steps = evaluate_plan(plan, lambda source: values[source.kind][source.name])
    return [steps[activation_name(i)] for i in range(len(AREAS))], plan


def morph(area, targets, **more):
    return {"type": "morph", "area": area, "targets": targets, **more}


class PlanTest(unittest.TestCase):
    def check(self, drivers, weights, expected, **more):
        found, plan = activations(drivers, weights, **more)
        for value, wanted in zip(found, expected, strict=True):
            self.assertAlmostEqual(value, wanted, 12)
        return plan

    def test_links_have_weights_and_curves(self):
        links = [{"name": "up", "weight": 0.5, "curve": [[0, 0], [0.5, 2]]}, {"name": "out", "weight": -0.25}]
        self.check([morph("nose", links)], {"up": 0.25, "out": 0.4}, [0, 0, 0.5 - 0.1])

    def test_rules(self):
        links = [{"name": "a"}, {"name": "b"}, {"name": "c", "weight": 2}]
        weights = {"a": 0.5, "b": 0.25, "c": 0.2}
        for rule, expected in {"sum": 1, "max": 0.5, "min": 0.25, "product": 0.05}.items():
            self.check([morph("nose", links, rule=rule)], weights, [0, 0, expected])

    def test_sums_are_clamped_and_rest_is_added(self):
        drivers = [morph("nose", [{"name": "a"}]), morph("nose", [{"name": "a"}])]
        self.check(drivers, {"a": 0.3}, [0, 0.1, 0.8], rest=(0, 0.1, 0.2))
        self.check(drivers, {"a": 0.7}, [0, 0, 1])

    def test_a_missing_target_counts_as_0_and_is_listed(self):
        links = [{"name": "a"}, {"name": "jawOpen", "curve": [[0, 0.5], [1, 1]]}]
        plan = self.check([morph("nose", links)], {"a": 0.25}, [0, 0, 0.75])
        self.assertEqual(plan.missing, ["jawOpen"])
        self.check([morph("nose", [*links[:1], {"name": "jawOpen"}], rule="product")], {"a": 1}, [0, 0, 0])

    def test_spellings_and_halves(self):
        links = [{"name": "browInnerUp"}]
        self.check([morph("nose", links)], {"blendShape1.browInnerUp": 0.5}, [0, 0, 0.5])
        self.check([morph("nose", links)], {"browInnerUp_L": 0.5, "browInnerUp_R": 0.25}, [0, 0, 0.375])

    def test_conflicts_are_resolved_in_list_order(self):
        drivers = [
            morph("forehead", [{"name": "up"}]),
            morph("glabella", [{"name": "down"}]),
            morph("nose", [{"name": "out"}]),
            {"type": "conflict", "targets": ["up", "down"]},
            {"type": "conflict", "targets": ["up", "out"]},
        ]
        self.check(drivers, {"up": 0.7, "down": 0.25, "out": 0.9}, [0, 0, 0.45])
        self.check(drivers, {"up": 0.7, "down": -1, "out": 0}, [0.7, 0, 0])

    def test_conflicts_of_halves(self):
        drivers = [
            morph("forehead", [{"name": "browInnerUp"}]),
            {"type": "conflict", "targets": ["browInnerUp", "down"]},
        ]
        self.check(drivers, {"browInnerUp_L": 0.6, "browInnerUp_R": 0.2, "down": 0.1}, [0.3, 0, 0])

    def test_areas_drive_areas_unless_in_cycles(self):
        chain = [
            {"type": "area", "area": "nose", "areas": [{"name": "glabella", "weight": 0.5}]},
            {"type": "area", "area": "glabella", "areas": [{"name": "forehead"}]},
            morph("forehead", [{"name": "a"}]),
        ]
        self.check(chain, {"a": 0.8}, [0.8, 0.8, 0.4])
        cycle = [*chain, {"type": "area", "area": "forehead", "areas": [{"name": "nose"}]}]
        plan = self.check(cycle, {"a": 0.8}, [0.8, 0, 0])
        self.assertEqual(len(plan.unsupported), 3)

    def test_age_and_inputs(self):
        drivers = [
            {"type": "age", "area": "nose", "curve": [[20, 0], [60, 1]], "initial": 40},
            {"type": "input", "name": "cold", "area": "forehead", "curve": [[0, 0], [10, 1]]},
        ]
        plan = self.check(drivers, {}, [0, 0, 0.5])
        self.assertEqual(plan.inputs, {"age": 40, "cold": 0})
        self.check(drivers, {}, [0.5, 0, 1], inputs={"age": 70, "cold": 5})

    def test_the_last_delay_applies_and_areas_read_undelayed_values(self):
        drivers = [
            morph("nose", [{"name": "a"}]),
            {"type": "area", "area": "glabella", "areas": [{"name": "nose"}]},
            {"type": "time", "area": "nose", "attack": 1},
            {"type": "time", "area": "nose", "attack": 0.5, "release": 2},
        ]
        plan = self.check(drivers, {"a": 0.75}, [0, 0.75, 0.75], late={2: -0.5})
        self.assertEqual(plan.delays, {2: (0.5, 2)})
        self.assertEqual(shown_name(2, plan.delays), "s2")
        self.assertEqual(shown_name(1, plan.delays), activation_name(1))
        steps = evaluate_plan(plan, lambda source: {"target": 0.75, "rest": 0, "late": -0.5}[source.kind])
        self.assertEqual(steps["s2"], 0.25)

    def test_unsupported_drivers_are_listed(self):
        drivers = [
            {"type": "tension", "area": "nose", "curve": [[0, 0], [0.2, 1]]},
            {"type": "breath", "depth": 3},
            {"type": "bone", "area": "nose", "joints": ["a", "b"], "measure": "angle", "curve": [[0, 0], [1, 1]]},
        ]
        plan = self.check(drivers, {}, [0, 0, 0])
        self.assertEqual(len(plan.unsupported), 3)

    def test_expressions_are_far_shorter_than_blenders_limit(self):
        many = [{"name": f"a shape with a long name, number {i}"} for i in range(1024)]
        weights = {link["name"]: 0.9995 for link in many}
        plan = self.check([morph("nose", many, rule="product")], weights, [0, 0, 0.9995**1024])
        self.assertLess(max(len(step.expression) for step in plan.steps), 64)


if __name__ == "__main__":
    unittest.main()

"""Tests which documents are accepted, and which errors the others raise."""

import copy
import unittest

from furrow.format.document import read_document, without_defaults
from furrow.format.reader import FurrowError

VALID = {
    "layers": [
        {"name": "skin", "normalTexture": {"index": 0}, "heightTexture": {"index": 1, "amplitude": 0.001}},
        {"name": "age", "kind": "detail", "normalTexture": {"index": 0, "scale": 0.7}, "extras": {"a": 1}},
    ],
    "areas": [
        {"name": "forehead", "texture": {"index": 2}},
        {"name": "nose", "layer": 1, "texture": {"index": 2}, "channel": 1, "combine": "max", "activation": 0.25},
    ],
    "drivers": [
        {"type": "breath", "depth": 2},
        {"type": "morph", "area": "nose", "targets": [{"name": "sneer"}]},
    ],
    "strokes": {"version": 1},
}


def change(path, value):
    """Copy the valid document with another value for one field. Removes the field if `value` is None."""
    json = copy.deepcopy(VALID)
    item = json
    for key in path[:-1]:
        item = item[key]
    if value is None:
        del item[path[-1]]
    else:
        item[path[-1]] = value
    return json


class DocumentTest(unittest.TestCase):
    def test_defaults_are_filled_in_and_unknown_fields_are_kept(self):
        document = read_document(VALID, 3)
        self.assertEqual(document["layers"][0]["kind"], "replace")
        self.assertEqual(document["layers"][0]["normalTexture"]["scale"], 1)
        self.assertEqual(document["layers"][1]["extras"], {"a": 1})
        self.assertEqual(document["areas"][0]["combine"], "sum")
        self.assertEqual(document["drivers"][0], {"type": "breath", "depth": 2})
        self.assertEqual(document["strokes"], {"version": 1})

    def test_writing_omits_defaults(self):
        written = without_defaults(read_document(VALID, 3))
        self.assertEqual(written["layers"], VALID["layers"])
        self.assertEqual(written["areas"], VALID["areas"])
        self.assertEqual(read_document(written, 3), read_document(VALID, 3))

    def test_errors_have_the_path_of_the_field(self):
        invalid = {
            "layers": change(["layers"], []),
            "layers[0].normalTexture": change(["layers", 0, "normalTexture"], None),
            "layers[0].normalTexture.index": change(["layers", 0, "normalTexture", "index"], 3),
            "layers[0].heightTexture.amplitude": change(["layers", 0, "heightTexture"], {"index": 1}),
            "layers[1].kind": change(["layers", 1, "kind"], "both"),
            "layers[1].name": change(["layers", 1, "name"], "skin"),
            "areas": change(["areas"], None),
            "areas[0].name": change(["areas", 0, "name"], "a\nb"),
            "areas[1].layer": change(["areas", 1, "layer"], 2),
            "areas[1].activation": change(["areas", 1, "activation"], float("nan")),
            "areas[1].channel": change(["areas", 1, "channel"], True),
            "drivers": change(["drivers"], {}),
            "drivers[1].area": change(["drivers", 1, "area"], "chin"),
            "drivers[1].targets": change(["drivers", 1, "targets"], []),
            "drivers[1].curve": change(["drivers", 1, "curve"], [[0, 0], [0, 1]]),
            "the extension": [],
        }
        for path, json in invalid.items():
            with self.subTest(path), self.assertRaises(FurrowError) as raised:
                read_document(json, 3)
            self.assertIn(f": {path}", str(raised.exception))

    def test_a_malformed_driver_is_skipped(self):
        errors = []
        json = change(["drivers", 1, "area"], "chin")
        document = read_document(json, 3, on_error=errors.append)
        self.assertEqual([driver["type"] for driver in document["drivers"]], ["breath"])
        self.assertEqual(len(errors), 1)


if __name__ == "__main__":
    unittest.main()

"""Tests edits of the drivers of a document."""

import unittest

from furrow.format.edit import (
    describe_driver,
    link_target,
    meshes_of,
    remove_area,
    remove_link,
    rename_area,
    rename_meshes,
)

PLAIN = {"rule": "sum", "curve": [[0, 0], [1, 1]]}
MORPH = {"type": "morph", "area": "nose", "targets": [{"name": "a", "weight": 1}], **PLAIN}
READS = {"type": "area", "area": "brow", "areas": [{"name": "nose", "weight": 1}], **PLAIN}
UNKNOWN = {"type": "breath", "depth": 2}


class EditTest(unittest.TestCase):
    def test_links_join_a_plain_driver_of_the_area(self):
        drivers = link_target([UNKNOWN, MORPH], "nose", "b", 0.5)
        self.assertEqual(drivers[1]["targets"], [{"name": "a", "weight": 1}, {"name": "b", "weight": 0.5}])
        self.assertEqual(len(drivers), 2)
        self.assertEqual(MORPH["targets"], [{"name": "a", "weight": 1}])

    def test_a_link_to_the_same_target_is_replaced(self):
        drivers = link_target([MORPH], "nose", "a", 0.5, 0.2, 0.8)
        self.assertEqual(drivers[0]["targets"], [{"name": "a", "weight": 0.5, "curve": [[0.2, 0], [0.8, 1]]}])

    def test_other_areas_and_curves_get_a_new_driver(self):
        curved = {**MORPH, "curve": [[0.2, 0], [1, 1]]}
        self.assertEqual(len(link_target([curved], "nose", "b")), 2)
        self.assertEqual(link_target([MORPH], "brow", "b")[1]["area"], "brow")

    def test_removing_the_last_link_removes_the_driver(self):
        self.assertEqual(remove_link([UNKNOWN, MORPH], 1, "a"), [UNKNOWN])

    def test_areas_are_removed_and_renamed_in_all_drivers(self):
        self.assertEqual(remove_area([MORPH, READS, UNKNOWN], "nose"), [UNKNOWN])
        renamed = rename_area([MORPH, READS, UNKNOWN], "nose", "bridge")
        self.assertEqual((renamed[0]["area"], renamed[1]["areas"][0]["name"]), ("bridge", "bridge"))

    def test_corrections_follow_renamed_meshes(self):
        shapes = [{"mesh": "Head", "target": "a"}, {"target": "b"}, {"mesh": 7}, None]
        self.assertEqual(meshes_of(shapes), ["Head"])
        renamed = rename_meshes(shapes, {"Head": "Head.001"})
        self.assertEqual(renamed, [{"mesh": "Head.001", "target": "a"}, *shapes[1:]])
        for malformed in ("none", {}, [None]):
            self.assertEqual(rename_meshes(malformed, {"Head": "Face"}), malformed)

    def test_every_driver_has_a_description(self):
        self.assertEqual(describe_driver(MORPH), "1 a")
        self.assertEqual(describe_driver(UNKNOWN), "breath")


if __name__ == "__main__":
    unittest.main()

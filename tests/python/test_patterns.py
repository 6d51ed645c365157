"""Patterns in Python: loaded, changed, made, saved and checked."""

import copy
import json
import math
import unittest

import numpy as np
from support import PATTERNS, InFolder, shipped, two_squares

import selvedge


class Patterns(InFolder):
    def test_what_is_loaded_is_in_metres_and_radians(self):
        pattern = selvedge.load_pattern(shipped("two_squares"))
        front = pattern.panel("front")
        self.assertEqual([panel.name for panel in pattern.panels], ["front", "back"])
        np.testing.assert_allclose(front.vertices[1], [0.28, 0])
        np.testing.assert_allclose(front.translation, [0, 0.808, 0.22])
        self.assertEqual(pattern.seams[0].first, ("front", 3))
        self.assertEqual(pattern.fabric, "cotton_shirting")
        self.assertEqual(pattern.check(), [])

    def test_every_shipped_pattern_is_saved_as_it_was_loaded(self):
        for path in sorted(PATTERNS.glob("*.json")):
            with self.subTest(path.name):
                saved = self.folder / path.name
                selvedge.load_pattern(path).save(saved)
                self.assertEqual(json.loads(saved.read_text()), json.loads(path.read_text()))

    def test_a_change_is_saved_and_all_else_stays(self):
        pattern = selvedge.load_pattern(shipped("tshirt"))
        pattern.fabric = "silk"
        pattern.panels[0].vertices[0] += (0, -0.01)
        saved = self.folder / "changed.json"
        pattern.save(saved)
        before, after = json.loads(shipped("tshirt").read_text()), json.loads(saved.read_text())
        self.assertEqual(after["selvedge"]["fabric"], "silk")
        self.assertEqual(after["pattern"]["stitches"], before["pattern"]["stitches"])
        again = selvedge.load_pattern(saved)
        np.testing.assert_allclose(again.panels[0].vertices, pattern.panels[0].vertices, atol=1e-9)

    def test_a_renamed_panel_keeps_what_the_file_says_of_it(self):
        path = self.folder / "own.json"
        own = json.loads(shipped("two_squares").read_text())
        own["pattern"]["panels"]["front"]["note"] = "kept"
        path.write_text(json.dumps(own))
        pattern = selvedge.load_pattern(path)
        pattern.panel("front").name = "forward"
        for seam in pattern.seams:
            seam.first = ("forward", seam.first[1])
        pattern.save(path)
        self.assertEqual(json.loads(path.read_text())["pattern"]["panels"]["forward"]["note"], "kept")

    def test_a_pattern_is_made_from_nothing(self):
        pattern = two_squares()
        self.assertEqual(pattern.check(), [])
        path = self.folder / "made.json"
        pattern.save(path)
        self.assertEqual(selvedge.check(path), [])
        self.assertEqual(len(selvedge.load_pattern(path).seams), 4)

    def test_all_kinds_of_edges_come_back(self):
        edges = [
            selvedge.Edge(0, 1, "quadratic", [(0.1, -0.05)]),
            selvedge.Edge(1, 2, "cubic", [(0.25, 0.05), (0.15, 0.15)]),
            selvedge.Edge(2, 3, "circle", radius=0.15, turns_right=True, label="hem", allowance=0.01),
            selvedge.Edge(3, 0),
        ]
        panel = selvedge.Panel("curved", np.array([(0, 0), (0.2, 0), (0.2, 0.2), (0, 0.2)]), edges)
        panel.notches = [selvedge.Notch(3, 0.25, "v", 2)]
        panel.internal_lines = [selvedge.InternalLine("fold", [(0.05, 0.05), (0.15, 0.05)], "fold")]
        panel.grain_angle = math.radians(45)
        path = self.folder / "curved.json"
        selvedge.Pattern("curved", [panel]).save(path)
        again = selvedge.load_pattern(path).panels[0]
        self.assertEqual([edge.kind for edge in again.edges], ["quadratic", "cubic", "circle", "line"])
        np.testing.assert_allclose(again.edges[1].control, [(0.25, 0.05), (0.15, 0.15)], atol=1e-9)
        self.assertTrue(again.edges[2].turns_right)
        self.assertEqual((again.edges[2].label, again.edges[2].allowance), ("hem", 0.01))
        self.assertEqual((again.notches[0].kind, again.notches[0].count), ("v", 2))
        self.assertEqual(again.internal_lines[0].use, "fold")
        self.assertAlmostEqual(again.grain_angle, math.radians(45))

    def test_topstitch_comes_back(self):
        pattern = selvedge.load_pattern(shipped("two_squares"))
        stitches = selvedge.Topstitch((0.006, 0.004), 2, thread=selvedge.Thread("#102030", 0.0005))
        pattern.seams[0].topstitch = stitches
        pattern.panels[0].edges[0].topstitch = selvedge.Topstitch()
        path = self.folder / "stitched.json"
        pattern.save(path)
        again = selvedge.load_pattern(path)
        read = again.seams[0].topstitch
        np.testing.assert_allclose(read.distances, (0.006, 0.004), atol=1e-12)
        self.assertEqual((read.rows, read.thread.colour, read.thread.thickness), (2, "#102030", 0.0005))
        self.assertEqual(again.panels[0].edges[0].topstitch.rows, 1)
        self.assertIsNone(again.panels[0].edges[1].topstitch)
        pattern.seams[0].topstitch.rows = 10
        with self.assertRaises(selvedge.InputError):
            pattern.save(path)

    def test_an_elastic_comes_back(self):
        pattern = selvedge.load_pattern(shipped("two_squares"))
        pattern.panels[0].edges[0].elastic = selvedge.Elastic(0.6, stiffness=12)
        path = self.folder / "elastic.json"
        pattern.save(path)
        read = selvedge.load_pattern(path).panels[0].edges[0].elastic
        self.assertEqual((read.share, read.stiffness), (0.6, 12))
        pattern.panels[0].edges[0].elastic.share = 2
        with self.assertRaises(selvedge.InputError):
            pattern.save(path)

    def test_a_polygon_is_turned_counter_clockwise(self):
        panel = selvedge.Panel.polygon("one", [(0, 0), (0, 1), (1, 0)])
        self.assertEqual(selvedge.Pattern("one", [panel]).check(), [])

    def test_a_copy_is_a_pattern_of_its_own(self):
        pattern = selvedge.load_pattern(shipped("two_squares"))
        other = copy.deepcopy(pattern)
        other.panels[0].vertices[0] -= 0.05
        self.assertFalse(np.array_equal(other.panels[0].vertices, pattern.panels[0].vertices))
        self.assertEqual([fault for fault in other.check() if fault.severity == "error"], [])

    def test_a_misspelt_attribute_is_an_error(self):
        with self.assertRaises(AttributeError):
            selvedge.load_pattern(shipped("tshirt")).panels[0].fabirc = "silk"

    def test_faults_name_the_place(self):
        def of(change):
            pattern = two_squares()
            change(pattern)
            faults = pattern.check()
            self.assertTrue(faults)
            return faults[0]

        def clockwise(pattern):
            pattern.panels[0].vertices = pattern.panels[0].vertices * (-1, 1)

        self.assertIn("clockwise", of(clockwise).problem)
        self.assertEqual(of(lambda p: setattr(p.panels[0].edges[2], "end", 99)).place, "panels[0].edges[2].end")
        self.assertEqual(of(lambda p: setattr(p.seams[1], "second", ("back", 8))).place, "seams[1].second")
        self.assertEqual(of(lambda p: setattr(p.seams[1], "second", ("bakc", 1))).problem, "no panel 'bakc'")
        self.assertEqual(of(lambda p: setattr(p.panels[1], "vertices", np.full((8, 2), np.nan))).place,
                         "panels[1].vertices")
        self.assertEqual(of(lambda p: setattr(p.panels[1], "rotation", np.ones((3, 3)))).place, "panels[1].rotation")
        self.assertEqual(of(lambda p: setattr(p.panels[1], "name", "front")).place, "panels[1].name")
        self.assertEqual(of(lambda p: setattr(p, "tartan", "no such")).severity, "error")
        self.assertIn("sewn already", of(lambda p: p.seams.append(selvedge.Seam(("front", 1), ("front", 3)))).problem)

    def test_a_wrong_pattern_is_not_saved(self):
        pattern = two_squares()
        pattern.panels[0].edges.pop()
        with self.assertRaises(selvedge.InputError):
            pattern.save(self.folder / "wrong.json")
        self.assertFalse((self.folder / "wrong.json").exists())

    def test_a_file_that_is_no_pattern_is_an_input_error_with_its_parts(self):
        path = self.folder / "no.json"
        path.write_text("{}")
        with self.assertRaises(ValueError) as caught:
            selvedge.load_pattern(path)
        self.assertIsInstance(caught.exception, selvedge.InputError)
        self.assertEqual(caught.exception.file, str(path))
        self.assertIn("pattern", caught.exception.problem)
        self.assertEqual(len(selvedge.check(path)), 1)
        self.assertEqual(selvedge.check(self.folder / "absent.json")[0].severity, "error")


if __name__ == "__main__":
    unittest.main()

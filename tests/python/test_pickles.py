"""Results, bodies and patterns go through pickle, as between the processes of a Pool; wrong arguments are named."""

import multiprocessing
import pickle
import unittest

import numpy as np
from support import QUICK, shipped

import selvedge


def again(thing):
    return pickle.loads(pickle.dumps(thing))


def dress_quickly(work):
    pattern, body = work
    return selvedge.dress(pattern, body, **QUICK)


class Pickles(unittest.TestCase):
    def test_a_body_keeps_its_surface_measures_and_bones(self):
        body = selvedge.mannequin(bust=0.95, resolution=1)
        same = again(body)
        np.testing.assert_array_equal(same.vertices, body.vertices)
        np.testing.assert_array_equal(same.triangles, body.triangles)
        np.testing.assert_array_equal(same.joints, body.joints)
        self.assertEqual(same.measures, body.measures)
        self.assertEqual(same.bone_names, body.bone_names)
        self.assertEqual(same.notes, body.notes)

    def test_a_pattern_keeps_what_it_is_and_is_dressed_alike(self):
        pattern = selvedge.load_pattern(shipped("two_squares"))
        pattern.panels[0].allowance = 0.012
        same = again(pattern)
        self.assertEqual(same.panels[0].allowance, 0.012)
        self.assertEqual([panel.name for panel in same.panels], [panel.name for panel in pattern.panels])
        for one, other in zip(same.panels, pattern.panels):
            np.testing.assert_array_equal(one.vertices, other.vertices)
        self.assertEqual(same.check(), pattern.check())

    def test_a_result_keeps_all_that_it_gives(self):
        body = selvedge.mannequin(resolution=1)
        result = selvedge.dress(shipped("two_squares"), body, **QUICK)
        same = again(result)
        for name in ("positions", "normals", "triangles", "material", "panel", "level", "strain_warp", "shear",
                     "clearance", "pressure", "contact_force", "seam"):
            np.testing.assert_array_equal(getattr(same, name), getattr(result, name), err_msg=name)
        self.assertEqual(same.report, result.report)
        self.assertEqual(same.faults, result.faults)
        self.assertEqual(same.settled, result.settled)
        self.assertEqual(same.panel_names, result.panel_names)
        self.assertEqual(same.seam_names, result.seam_names)
        np.testing.assert_array_equal(same.body.vertices, result.body.vertices)

    def test_a_pool_passes_them(self):
        work = (selvedge.load_pattern(shipped("two_squares")), selvedge.mannequin(resolution=1))
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            (result,) = pool.map(dress_quickly, [work])
        np.testing.assert_array_equal(result.positions, dress_quickly(work).positions)

    def test_what_is_broken_is_refused(self):
        kind, arguments, state = selvedge.mannequin(resolution=1).__reduce_ex__(2)[:3]
        with self.assertRaises(selvedge.InputError):
            kind(*arguments).__setstate__(state[: len(state) // 2])


class Arguments(unittest.TestCase):
    def wrong(self, call, *args, **kwargs):
        with self.assertRaises(TypeError) as caught:
            call(*args, **kwargs)
        self.assertNotIn("incompatible", str(caught.exception))
        return str(caught.exception)

    def test_a_wrong_type_is_told_with_the_argument(self):
        self.assertEqual(self.wrong(selvedge.mannequin, bust="wide"),
                         "mannequin(): bust must be a number, not str")
        self.assertIn("subject must be a Result, a Mesh, a frame or a Body, not int", self.wrong(selvedge.render, 4))
        self.assertIn("body must be a Body or a path, not int", self.wrong(selvedge.dress, shipped("poncho"), 4))
        self.assertIn("seconds must be a number, not str", self.wrong(selvedge.dress, shipped("two_squares"), seconds="long"))
        self.assertIn("max_level must be a whole number, not str",
                      self.wrong(selvedge.dress, shipped("two_squares"), max_level="three"))
        self.assertIn("path must be a path, not int", self.wrong(selvedge.load_body, 3))
        self.assertIn("unit must be a text, not int", self.wrong(selvedge.load_body, "body.obj", unit=3))

    def test_what_is_lacking_or_unknown_is_named(self):
        self.assertIn("path", self.wrong(selvedge.load_body))
        self.assertIn("units", self.wrong(selvedge.load_body, "body.obj", units="m"))


if __name__ == "__main__":
    unittest.main()

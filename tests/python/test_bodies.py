"""Bodies in Python."""

import unittest

import numpy as np
from support import QUICK, InFolder, run_program, shipped

import selvedge


class Bodies(InFolder):
    def test_a_mannequin_has_the_measures_it_was_asked_for(self):
        body = selvedge.mannequin(bust=0.96, waist=0.78, resolution=1)
        self.assertEqual(body.notes, [])
        self.assertAlmostEqual(body.measures["bust"], 0.96, delta=0.003)
        self.assertAlmostEqual(body.measures["waist"], 0.78, delta=0.003)
        self.assertEqual(body.joints.shape, (len(body.bone_names), 3))
        self.assertAlmostEqual(body.vertices[:, 1].min(), 0, delta=1e-3)
        self.assertLess(body.triangles.max(), len(body.vertices))

    def test_the_same_mannequin_as_the_command(self):
        path = self.folder / "program.ply"
        run_program("mannequin", "--bust", "96", "--resolution", "1", "-o", path)
        own = self.folder / "module.ply"
        selvedge.mannequin(bust=0.96, resolution=1).export(own)
        self.assertEqual(own.read_bytes(), path.read_bytes())

    def test_a_body_that_is_named_has_its_measures(self):
        result = selvedge.dress(shipped("two_squares"), "mannequin:bust=96,resolution=1", **QUICK)
        self.assertAlmostEqual(result.body.measures["bust"], 0.96, delta=0.003)

    def test_arrays_are_views_that_keep_the_body(self):
        body = selvedge.mannequin(resolution=1)
        vertices, joints = body.vertices, body.joints
        self.assertEqual(vertices.__array_interface__["data"], body.vertices.__array_interface__["data"])
        for array in (vertices, joints, body.triangles):
            self.assertFalse(array.flags.writeable)
            self.assertFalse(array.flags.owndata)
        before = vertices.copy()
        del body
        np.testing.assert_array_equal(vertices, before)

    def test_a_body_is_loaded_in_its_unit(self):
        path = self.folder / "body.obj"
        selvedge.mannequin(resolution=1).export(path)
        metres = selvedge.load_body(path)
        self.assertAlmostEqual(selvedge.load_body(path, unit="ft").height, metres.height * 0.3048, delta=1e-6)

    def test_wrong_input_names_the_argument(self):
        def place_of(call):
            with self.assertRaises(selvedge.InputError) as caught:
                call()
            return caught.exception.place

        self.assertEqual(place_of(lambda: selvedge.load_body("body.obj", unit="ell")), "unit")
        self.assertEqual(place_of(lambda: selvedge.load_body("body.obj", up="x")), "up")
        self.assertEqual(place_of(lambda: selvedge.mannequin("other")), "sex")
        self.assertIn("bust", place_of(lambda: selvedge.mannequin(bust=92)))
        with self.assertRaises(selvedge.InputError):
            selvedge.mannequin(bust=float("nan"))
        with self.assertRaises(selvedge.InputError):
            selvedge.load_body("absent.obj")


if __name__ == "__main__":
    unittest.main()

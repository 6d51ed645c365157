"""A session that is stepped by hand."""

import unittest

import numpy as np
from support import shipped, two_squares

import selvedge


class Sessions(unittest.TestCase):
    def setUp(self):
        self.body = selvedge.mannequin(resolution=1)
        self.session = selvedge.Session(shipped("two_squares"), self.body, edge_length=0.08, max_level=1)

    def hang(self):
        self.session.start()
        for _ in range(300):
            frame = self.session.advance(1)
            if frame.stage == "draping":
                return self.session.advance(5)
        self.fail(f"it does not hang: {frame} {frame.problem}")

    def test_the_stages_follow_each_other(self):
        self.assertEqual(self.session.stage, "placed")
        placed = self.session.frame
        self.assertEqual(placed.seam_lines.shape, (len(placed.seam_line_seams), 2, 3))
        self.session.start()
        self.assertEqual(self.session.advance(1).stage, "sewing")
        self.assertEqual(self.hang().stage, "draping")
        self.session.reset()
        self.assertEqual(self.session.advance(0).stage, "placed")
        np.testing.assert_array_equal(self.session.frame.mesh.positions, placed.mesh.positions)

    def test_a_paused_session_stands_still(self):
        before = self.hang()
        self.session.pause()
        after = self.session.advance(5)
        np.testing.assert_array_equal(before.mesh.positions, after.mesh.positions)
        self.assertFalse(after.is_running)

    def test_a_pinned_point_stays_and_a_pulled_one_follows(self):
        frame = self.hang()
        pinned = frame.mesh.positions[frame.mesh.triangles[0]].mean(axis=0)
        self.session.pin(0)
        frame = self.session.advance(3)
        self.assertEqual(frame.pins.shape, (1, 3))
        self.assertLess(np.linalg.norm(frame.pins[0] - pinned), 0.15)
        held = frame.pins.copy()
        last = len(frame.mesh.triangles) - 1
        middle = frame.mesh.positions[frame.mesh.triangles[last]].mean(axis=0)
        goal = middle + (0, 0, -0.1)
        self.session.pull(last, goal)
        frame = self.session.advance(10)
        self.assertLess(np.linalg.norm(frame.mesh.positions - goal, axis=1).min(), 0.1)
        np.testing.assert_allclose(frame.pins, held, atol=1e-4)
        self.session.let_go()
        self.session.unpin_all()
        self.assertEqual(self.session.advance(1).pins.shape, (0, 3))

    def test_a_changed_pattern_goes_on_from_where_it_hangs(self):
        self.hang()
        pattern = selvedge.load_pattern(shipped("two_squares"))
        for panel in pattern.panels:
            panel.vertices[:, 1] *= 1.02
        self.session.set_pattern(pattern)
        self.assertEqual(self.session.advance(1).stage, "draping")
        self.session.set_pattern(two_squares())
        self.assertNotEqual(self.session.advance(1).stage, "failed")

    def test_frames_outlive_the_session_and_are_views(self):
        frame = self.hang()
        positions = frame.mesh.positions
        before = positions.copy()
        del self.session, frame
        np.testing.assert_array_equal(positions, before)
        self.assertFalse(positions.flags.writeable or positions.flags.owndata)

    def test_a_body_outlives_its_replacement(self):
        taken = self.session.body
        vertices = taken.vertices
        before = vertices.copy()
        other = selvedge.mannequin(resolution=1, bust=1.1)
        self.session.set_body(other)
        np.testing.assert_array_equal(self.session.body.vertices, other.vertices)
        np.testing.assert_array_equal(taken.vertices, before)
        del taken, self.body
        self.session.advance(0)
        np.testing.assert_array_equal(vertices, before)

    def test_wrong_input_is_refused(self):
        self.hang()
        for call in (
            lambda: self.session.pin(-1),
            lambda: self.session.pin(10**6),
            lambda: self.session.pin(0, (1, 1, 1)),
            lambda: self.session.pin(0, (float("nan"), 0, 1)),
            lambda: self.session.pull(0, (0, float("inf"), 0)),
            lambda: self.session.pull_to((1e9, 0, 0)),
            lambda: self.session.advance(-1),
            lambda: self.session.set_pattern(selvedge.Pattern("x", [selvedge.Panel("p", np.zeros((3, 2)), [])])),
        ):
            with self.assertRaises(selvedge.InputError):
                call()
        self.assertEqual(self.session.advance(1).stage, "draping")


if __name__ == "__main__":
    unittest.main()

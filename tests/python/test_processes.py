"""Processes that are forked or spawned after their parent has dressed and drawn: they dress, draw and end."""

import multiprocessing
import os
import sys
import unittest

import numpy as np
from support import QUICK, shipped

import selvedge

SECONDS = 60  # for what takes some seconds


def dress_and_draw(body):
    result = selvedge.dress(shipped("two_squares"), body, **QUICK)
    return np.array(result.positions), selvedge.render(result, size=(64, 64))


class Processes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.body = selvedge.mannequin(resolution=1)
        cls.positions, cls.picture = dress_and_draw(cls.body)

    def check_pool(self, method):
        with multiprocessing.get_context(method).Pool(2) as pool:
            for positions, picture in pool.map_async(dress_and_draw, [self.body] * 3).get(SECONDS):
                np.testing.assert_array_equal(positions, self.positions)
                np.testing.assert_array_equal(picture, self.picture)

    def test_a_forked_pool_dresses_and_draws(self):
        self.check_pool("fork")

    def test_a_spawned_pool_dresses_and_draws(self):
        self.check_pool("spawn")

    def test_a_forked_child_and_its_child_draw_and_leave_with_their_status(self):
        def fork(depth):
            child = os.fork()
            if child:
                return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
            is_equal = np.array_equal(dress_and_draw(self.body)[1], self.picture)
            ended = fork(depth - 1) if depth else 7
            sys.stdout.flush()
            leave(0 if is_equal and ended in (0, 7) else 1)

        def leave(status):  # with Python's and C's exit handlers, without unittest's
            import ctypes

            ctypes.CDLL(None).exit(status)

        runner = multiprocessing.get_context("fork").Process(target=lambda: sys.exit(fork(1)))
        runner.start()
        runner.join(SECONDS)
        self.assertEqual(runner.exitcode, 0)


if __name__ == "__main__":
    unittest.main()

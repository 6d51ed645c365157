"""Pictures in Python."""

import unittest

import numpy as np
from support import QUICK, QUICK_TEXTS, InFolder, run_program, shipped

import selvedge


class Pictures(InFolder):
    @classmethod
    def setUpClass(cls):
        cls.result = selvedge.dress(shipped("two_squares"), **QUICK)

    def test_the_picture_of_the_command(self):
        theirs, ours = self.folder / "program.png", self.folder / "module.png"
        look = ["--size", "200x300", "--view", "three-quarter", "--tartan", "Black Watch", "--sett-size", "7"]
        run_program("dress", shipped("two_squares"), *QUICK_TEXTS, "--render", theirs, *look, "--quiet")
        picture = selvedge.render(
            self.result, size=(200, 300), view="three-quarter", tartan="Black Watch", sett_size=0.07
        )
        self.assertEqual((picture.shape, picture.dtype), ((300, 200, 4), np.uint8))
        selvedge.write_png(picture, ours)
        self.assertEqual(ours.read_bytes(), theirs.read_bytes())

    def test_every_mode_draws_something_of_its_own(self):
        pictures = {
            show: selvedge.render(self.result, size=(96, 96), show=show)
            for show in ("tartan", "plain", "edges", "strain", "clearance", "panels", "seams", "hierarchy")
        }
        self.assertEqual(len({picture.tobytes() for picture in pictures.values()}), len(pictures))

    def test_a_mesh_is_drawn_with_and_without_a_body(self):
        mesh = selvedge.Mesh(
            self.result.positions, self.result.triangles, material=self.result.material, panel=self.result.panel,
            panel_names=self.result.panel_names,
        )
        alone = selvedge.render(mesh, size=(64, 64), transparent=True, camera=(20, 10))
        dressed = selvedge.render(mesh, self.result.body, size=(64, 64), design="#203040", fabric="silk")
        self.assertTrue((alone[..., 3] == 0).any())
        self.assertTrue((dressed[..., 3] == 255).all())

    def test_wrong_input_names_the_argument(self):
        for name, value in {
            "size": (0, 10), "view": "below", "show": "no such", "frame": "none", "samples": 3, "sett_size": -1,
            "camera": (1,), "tartan": "no such", "surface": "no such",
        }.items():
            with self.subTest(name), self.assertRaises(selvedge.InputError) as caught:
                selvedge.render(self.result, **{name: value})
            if name != "tartan":
                self.assertEqual(caught.exception.place, name)
        with self.assertRaises(selvedge.InputError):
            selvedge.render(self.result.mesh, show="clearance")
        with self.assertRaises(selvedge.InputError):
            selvedge.write_png(np.zeros((3, 3)), self.folder / "a.png")


if __name__ == "__main__":
    unittest.main()

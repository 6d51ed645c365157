"""Dressing in Python: the same bits as the program, views without a copy, threads, and ends before time."""

import functools
import gc
import io
import json
import signal
import threading
import time
import unittest

import numpy as np
from support import QUICK, QUICK_TEXTS, InFolder, run_program, shipped, two_squares

import selvedge

ARRAYS = {
    "positions": ("vertices", np.float32, (3,)),
    "normals": ("vertices", np.float32, (3,)),
    "triangles": ("triangles", np.uint32, (3,)),
    "material": ("triangles", np.float32, (3, 2)),
    "panel": ("triangles", np.uint16, ()),
    "level": ("triangles", np.uint8, ()),
    "strain_warp": ("triangles", np.float32, ()),
    "strain_weft": ("triangles", np.float32, ()),
    "shear": ("triangles", np.float32, ()),
    "clearance": ("vertices", np.float32, ()),
}


class Dressed(InFolder):
    """Of one short drape."""

    @classmethod
    def setUpClass(cls):
        cls.body = selvedge.mannequin(resolution=1)
        cls.result = selvedge.dress(shipped("two_squares"), cls.body, **QUICK)

    def test_the_arrays_have_their_shapes_and_types(self):
        sizes = {"vertices": len(self.result.positions), "triangles": len(self.result.triangles)}
        self.assertGreater(sizes["triangles"], 50)
        for name, (of, dtype, inner) in ARRAYS.items():
            array = getattr(self.result, name)
            self.assertEqual((name, array.shape, array.dtype), (name, (sizes[of], *inner), dtype))
        self.assertLess(self.result.triangles.max(), sizes["vertices"])
        self.assertEqual(self.result.panel_names, ["front", "back"])
        self.assertEqual(set(self.result.panel), {0, 1})

    def test_a_path_is_no_list_of_garments_worn_over_it(self):
        with self.assertRaises(TypeError):
            selvedge.dress("patterns/vest.json", over="patterns/poncho.json")

    def test_the_arrays_are_no_copies_and_read_only(self):
        for name in ARRAYS:
            array = getattr(self.result, name)
            again = getattr(self.result, name)
            self.assertEqual(array.__array_interface__["data"][0], again.__array_interface__["data"][0], name)
            self.assertFalse(array.flags.writeable, name)
            self.assertFalse(array.flags.owndata, name)
            self.assertIsNotNone(array.base, name)
            with self.assertRaises(ValueError):
                array[...] = 0
        self.assertEqual(
            self.result.positions.__array_interface__["data"], self.result.mesh.positions.__array_interface__["data"]
        )

    def test_the_arrays_outlive_the_result(self):
        result = selvedge.dress(shipped("two_squares"), self.body, **{**QUICK, "seconds": 0.01})
        kept = {name: getattr(result, name) for name in ARRAYS}
        copies = {name: array.copy() for name, array in kept.items()}
        del result
        gc.collect()
        rubbish = [np.full(100_000, 7.0) for _ in range(20)]
        for name, array in kept.items():
            np.testing.assert_array_equal(array, copies[name], name)
        del rubbish

    def test_strain_is_that_of_positions_and_material_coordinates(self):
        x = self.result.positions[self.result.triangles].astype(float)
        u = self.result.material.astype(float)
        edges, sides = x[:, 1:] - x[:, :1], u[:, 1:] - u[:, :1]
        gradient = np.linalg.solve(sides, edges)  # rows: what one metre along weft and warp becomes
        np.testing.assert_allclose(np.linalg.norm(gradient[:, 1], axis=1) - 1, self.result.strain_warp, atol=1e-3)
        np.testing.assert_allclose(np.linalg.norm(gradient[:, 0], axis=1) - 1, self.result.strain_weft, atol=1e-3)

    def test_seams_are_where_two_panels_meet(self):
        result = self.result
        panels_at = [set() for _ in result.positions]
        for triangle, panel in zip(result.triangles, result.panel):
            for vertex in triangle:
                panels_at[vertex].add(panel)
        expected = np.array([len(panels) > 1 for panels in panels_at])
        np.testing.assert_array_equal(result.seam >= 0, expected)
        self.assertEqual(len(result.seam_names), 4)
        vertices = result.seam_vertices(0)
        self.assertGreater(len(vertices), 2)
        np.testing.assert_array_equal(vertices, result.seam_vertices(result.seam_names[0]))
        for wrong in (-1, 4, "no such"):
            with self.assertRaises(selvedge.InputError):
                result.seam_vertices(wrong)

    def test_the_report_is_a_dict(self):
        report = self.result.report
        self.assertEqual(report["mesh"]["leaf_triangles"], len(self.result.triangles))
        self.assertEqual(self.result.faults, report["faults"])
        self.assertEqual(self.result.settled, report["settled"])

    def test_pressure_is_where_the_cloth_touches(self):
        pressure, clearance = self.result.pressure, self.result.clearance
        self.assertEqual((pressure.shape, pressure.dtype), (clearance.shape, np.float32))
        self.assertTrue(np.all(pressure >= 0))
        self.assertGreater(pressure.max(), 0)
        self.assertEqual(pressure[clearance > 0.02].max(), 0)
        self.assertFalse(pressure.flags.writeable)

    def test_exports_are_written(self):
        for name in ("a.obj", "a.glb", "a.ply", "a.stl"):
            path = self.folder / name
            self.result.export(path, texture_size=64)
            self.assertGreater(path.stat().st_size, 1000)
        self.result.export(self.folder / "thick.stl", thickness=0.002)
        for wrong in ({"thickness": 5.0}, {"texture_size": 3}):
            with self.assertRaises(selvedge.InputError):
                self.result.export(self.folder / "b.obj", **wrong)
        with self.assertRaises(selvedge.InputError):
            self.result.export(self.folder / "a.txt")


class Dressing(InFolder):
    def test_the_same_bits_as_the_program(self):
        ply, report = self.folder / "program.ply", self.folder / "report.json"
        run_program("dress", shipped("poncho"), *QUICK_TEXTS, "--export", ply, "--report", report, "--quiet")
        result = selvedge.dress(selvedge.load_pattern(shipped("poncho")), **QUICK)
        own = self.folder / "module.ply"
        result.export(own)
        self.assertEqual(own.read_bytes(), ply.read_bytes())
        theirs, ours = json.loads(report.read_text()), result.report
        self.assertEqual(ours["inputs"], [], "a pattern in memory is no file")
        for one in (theirs, ours):
            del one["timing"], one["inputs"]
        self.assertEqual(ours, theirs)

    def test_garments_are_worn_over_each_other(self):
        result = selvedge.dress(two_squares(), over=[shipped("vest")], **{**QUICK, "seconds": 0.01})
        self.assertEqual(len(result.report["garments"]), 2)
        self.assertIn("front", result.panel_names)

    def test_progress_grows_to_one(self):
        seen = []
        selvedge.dress(shipped("two_squares"), **QUICK, progress=lambda done, text: seen.append((done, text)))
        done = [one for one, _ in seen]
        self.assertEqual(done, sorted(done))
        self.assertEqual(seen[-1], (1.0, "done"))
        self.assertTrue({"sewing", "draping"} <= {text for _, text in seen})

    def test_an_exception_in_the_progress_ends_it(self):
        class Enough(Exception):
            pass

        def stop(done, _):
            if done > 0.2:
                raise Enough

        with self.assertRaises(Enough):
            selvedge.dress(shipped("two_squares"), **QUICK, progress=stop)

    def test_an_interrupt_ends_it_before_it_is_done(self):
        # What is called is written in C: only what dresses can notice the signal.
        heard = io.StringIO()
        interrupt = threading.Thread(target=self.interrupt_once_heard, args=[heard], daemon=True)
        interrupt.start()
        with self.assertRaises(KeyboardInterrupt):
            selvedge.dress(
                shipped("tshirt"), selvedge.mannequin(resolution=1), progress=functools.partial(print, file=heard)
            )
        interrupt.join()
        self.assertNotIn("done", heard.getvalue())

    @staticmethod
    def interrupt_once_heard(heard):
        while not heard.getvalue():
            time.sleep(0.01)
        signal.raise_signal(signal.SIGINT)

    def test_two_threads_dress_at_once(self):
        inside, most, results = [0], [0], {}
        lock = threading.Lock()

        def dress(name):
            begun = [False]

            def note(_, text):
                with lock:
                    if text == "done":
                        inside[0] -= 1
                    elif not begun[0]:
                        begun[0] = True
                        inside[0] += 1
                    most[0] = max(most[0], inside[0])

            results[name] = selvedge.dress(shipped("two_squares"), **QUICK, threads=1, progress=note)

        threads = [threading.Thread(target=dress, args=(name,)) for name in "ab"]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(most[0], 2)
        np.testing.assert_array_equal(results["a"].positions, results["b"].positions)

    def test_a_body_can_be_named_as_the_command_names_it(self):
        named = selvedge.dress(shipped("two_squares"), "mannequin:bust=84", **QUICK)
        made = selvedge.dress(shipped("two_squares"), selvedge.mannequin(bust=0.84), **QUICK)
        np.testing.assert_array_equal(named.positions, made.positions)
        with self.assertRaises(selvedge.InputError):
            selvedge.dress(shipped("two_squares"), "mannequin:bust=1e9", **QUICK)
        with self.assertRaises(selvedge.InputError):
            selvedge.dress(shipped("two_squares"), "", **QUICK)

    def test_wrong_input_names_the_argument(self):
        for name, value in {
            "seconds": -1,
            "edge_length": float("nan"),
            "max_level": 9,
            "shortest_edge": 0,
            "triangles": 1,
            "threads": 0,
        }.items():
            with self.subTest(name), self.assertRaises(selvedge.InputError) as caught:
                selvedge.dress(shipped("two_squares"), **{name: value})
            self.assertEqual(caught.exception.place, name)
        with self.assertRaises(selvedge.InputError):
            selvedge.dress(shipped("two_squares"), fabric="no such fabric")
        with self.assertRaises(TypeError):
            selvedge.dress(shipped("two_squares"), progress=1)
        with self.assertRaises(TypeError):
            selvedge.dress(7)


if __name__ == "__main__":
    unittest.main()

"""Garments on bodies that move: the same bits as the command, frames that stay, and what is raised meanwhile."""

import unittest
import warnings

import numpy as np
from support import InFolder, run_program, shipped

import selvedge

MOTION = {"motion": "walk", "seconds": 0.2, "blend": 0.2, "fps": 10, "edge_length": 0.08, "max_level": 1}
TEXTS = ["--motion", "walk", "--seconds", "0.2", "--blend", "0.2", "--fps", "10", "--edge-length", "8", "--max-level", "1"]


class Animations(InFolder):
    def test_frames_film_and_caches_are_those_of_the_command(self):
        for name in ("ours", "theirs"):
            (self.folder / name / "frames").mkdir(parents=True)
        ours, theirs = self.folder / "ours", self.folder / "theirs"
        animation = selvedge.animate(
            shipped("two_squares"), **MOTION, film=f"{ours}/frames/", size=(96, 96), texture_size=128,
            export=[ours / "a.pc2", ours / "a.glb"], report=ours / "a.json")
        frames = []
        for frame in animation:
            selvedge.render(frame, size=(32, 32))  # draws between two pictures of the film
            frames.append(frame)
        run_program("animate", shipped("two_squares"), *TEXTS, "--film", f"{theirs}/frames/", "--size", "96x96",
                    "--texture-size", "128", "--export", theirs / "a.pc2", "--export", theirs / "a.glb", "-q")
        names = ["a.pc2", "a.glb", *(f"frames/frame_{i:04}.png" for i in range(1, len(frames) + 1))]
        for name in names:
            self.assertEqual((ours / name).read_bytes(), (theirs / name).read_bytes(), name)
        self.assertEqual(len(frames), animation.frame_count)
        self.assertTrue(animation.is_finished)
        self.assertEqual([frame.number for frame in frames], list(range(5)))
        cache = np.frombuffer((ours / "a.pc2").read_bytes()[32:], dtype="<f4").reshape(len(frames), -1, 3)
        for frame, positions in zip(frames, cache):  # frames stay as the animation goes on
            np.testing.assert_array_equal(frame.fixed_positions, positions)
            self.assertFalse(frame.positions.flags.writeable)
            self.assertEqual(frame.triangles.max() + 1, len(frame.positions))
        self.assertEqual(animation.fixed_mesh.positions.shape, frames[0].fixed_positions.shape)
        self.assertEqual(animation.report["animation"]["frames"], len(frames))
        self.assertTrue((ours / "a.json").exists())

    def test_it_may_be_stopped_and_what_progress_raises_leaves_it_where_it_was(self):
        seen = []

        def progress(done, stage):
            seen.append((done, stage))
            if len([one for one in seen if one[1] == "moving" and one[0] > 0.3]) == 2:
                raise KeyboardInterrupt

        animation = selvedge.animate(shipped("two_squares"), **MOTION, export=self.folder / "a.pc2", progress=progress)
        self.assertFalse((self.folder / "a.pc2").exists())
        next(animation)
        with self.assertRaises(KeyboardInterrupt):
            next(animation)
        animation.stop()
        self.assertEqual(animation.report["animation"]["frames"], 2)
        self.assertTrue((self.folder / "a.pc2").exists())
        self.assertEqual([done for done, _ in seen], sorted(done for done, _ in seen))
        self.assertRaises(StopIteration, next, animation)

    def test_what_is_given_up_before_its_files_are_written_is_told(self):
        animation = selvedge.animate(shipped("two_squares"), **MOTION, export=self.folder / "a.pc2")
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            del animation
        self.assertIn("finish()", str(told[0].message))
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_wrong_input_names_the_argument(self):
        for argument, value in (("motion", "fly"), ("fps", 0), ("start", 1e4), ("speed", 0), ("film", "walk.txt")):
            with self.assertRaises(selvedge.InputError) as caught:
                selvedge.animate(shipped("two_squares"), **{**MOTION, argument: value})
            self.assertIn(argument if argument != "film" else "walk.txt", str(caught.exception))


if __name__ == "__main__":
    unittest.main()

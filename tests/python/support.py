"""What the tests of the Python module share."""

from __future__ import annotations

import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np

import selvedge

SOURCE = pathlib.Path(__file__).resolve().parents[2]
PATTERNS = SOURCE / "patterns"
QUICK = {"edge_length": 0.08, "max_level": 1, "seconds": 1.0}  # a short and coarse drape
QUICK_TEXTS = ["--edge-length", "8", "--max-level", "1", "--seconds", "1"]  # the same for the command


def shipped(name: str) -> pathlib.Path:
    """A garment that ships."""
    return PATTERNS / f"{name}.json"


def run_program(*arguments: object) -> subprocess.CompletedProcess[str]:
    """Runs the program; exit code 3, a fault of a short drape, is no failure."""
    command = [os.environ["SELVEDGE_PROGRAM"], *(os.fspath(one) for one in arguments)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 3):
        raise AssertionError(f"{command}: {done.returncode}: {done.stderr}")
    return done


def square(name: str, z: float, **attributes: object) -> selvedge.Panel:
    """A panel of 56 x 56 cm, of which the upper edge is divided for a neck, upright at that z (m)."""
    lower = [(-0.28, 0), (0.28, 0), (0.28, 0.26), (0.28, 0.56)]
    corners = [*lower, (0.12, 0.56), (-0.12, 0.56), (-0.28, 0.56), (-0.28, 0.26)]
    if z < 0:  # seen from the back
        rotation = np.diag([-1.0, 1.0, -1.0])
        attributes = {"rotation": rotation, **attributes}
    return selvedge.Panel.polygon(name, corners, translation=np.array([0, 0.808, z]), **attributes)


def two_squares() -> selvedge.Pattern:
    """A top of two squares, sewn at the shoulders and sides, made from nothing."""
    seams = [selvedge.Seam((front, i), (back, j)) for front, i, back, j in
             (("front", 3, "back", 5), ("front", 5, "back", 3), ("front", 1, "back", 7), ("front", 7, "back", 1))]
    return selvedge.Pattern("squares", [square("front", 0.22), square("back", -0.17)], seams)


class InFolder(unittest.TestCase):
    """A test with an empty folder of its own."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

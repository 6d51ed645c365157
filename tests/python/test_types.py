"""The types of the module, by mypy: of the package, of a user's script, and of the stub beside the native part."""

import importlib.util
import os
import subprocess
import sys
import unittest

from support import SOURCE, InFolder

import selvedge

sys.path.append(str(SOURCE / "tests/support"))
import skips

SCRIPT = '''
import numpy as np
import numpy.typing as npt
import selvedge

body: selvedge.Body = selvedge.mannequin("female", bust=0.9)
result = selvedge.dress("tshirt.json", body, progress=lambda done, stage: print(done, stage))
heights: npt.NDArray[np.float32] = result.positions[:, 1]
selvedge.write_png(selvedge.render(result, size=(64, 64)), "picture.png")
result.export("tshirt.glb")
for frame in selvedge.animate("tshirt.json", motion="walk", export=["walk.pc2"]):
    print(frame.number, frame.fixed_positions.shape)
shown: str = result._repr_html_()
'''
# pybind11's classes have a metaclass of its own, and an initializer that refuses.
KNOWN = r"selvedge\._selvedge\.\w+(\.__init__)?" + "\n"


class Types(InFolder):
    @classmethod
    def setUpClass(cls):
        if not importlib.util.find_spec("mypy"):
            skips.skip_test("python.types", "mypy is not installed")

    def run_mypy(self, *arguments):
        environment = {**os.environ, "MYPYPATH": str(SOURCE / "python")}
        done = subprocess.run([sys.executable, "-m", *arguments], cwd=self.folder, env=environment, text=True,
                              capture_output=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_the_package_and_a_script_are_strictly_typed(self):
        (self.folder / "script.py").write_text(SCRIPT)
        self.run_mypy("mypy", "--strict", "--cache-dir", "cache", "-p", "selvedge")
        self.run_mypy("mypy", "--strict", "--cache-dir", "cache", "script.py")

    def test_a_wrong_type_in_a_script_is_found(self):
        (self.folder / "script.py").write_text(SCRIPT.replace("bust=0.9", "bust='wide'"))
        with self.assertRaises(AssertionError):
            self.run_mypy("mypy", "--strict", "--cache-dir", "cache", "script.py")

    def test_the_stub_is_that_of_the_module(self):
        (self.folder / "known.txt").write_text(KNOWN)
        self.run_mypy("mypy.stubtest", "selvedge._selvedge", "--allowlist", "known.txt", "--ignore-unused-allowlist")
        self.assertTrue(selvedge.__file__.endswith("__init__.py"))


if __name__ == "__main__":
    unittest.main()

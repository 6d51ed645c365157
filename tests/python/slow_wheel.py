"""pip install . in virtual environments: the wheel is self-contained, and the session of three lines makes a picture."""

import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest
import zipfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
# As the checkout is built, so that a compiler cache serves the wheel from it.
SETTINGS = "--config-settings=cmake=-DSELVEDGE_WERROR=ON"
SCRIPT = """
import selvedge
result = selvedge.dress("tshirt.json", seconds=1)
selvedge.write_png(selvedge.render(result, size=(96, 96)), "python.png")
maps = {line.split()[-1] for line in open("/proc/self/maps") if ".so" in line}
ours = ("LLVM", "OSMesa", "tbb", "assimp", "cairo", "poppler")
foreign = [one for one in maps if any(name in one for name in ours) and "selvedge" not in one]
assert not foreign, foreign
assert "site-packages" in selvedge.__file__ and "site-packages" in str(selvedge.program())
"""


def run(*command, **options):
    done = subprocess.run([os.fspath(one) for one in command], capture_output=True, text=True, check=False, **options)
    if done.returncode:
        raise AssertionError(f"{command}: {done.returncode}: {done.stdout[-4000:]}{done.stderr[-4000:]}")
    return done.stdout


class Wheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.environment = {name: value for name, value in os.environ.items()
                           if name not in ("PYTHONPATH", "SELVEDGE_PROGRAM")}
        before = run("git", "-C", SOURCE, "status", "--porcelain", "--ignored")
        begin = time.monotonic()
        run(sys.executable, "-m", "venv", "--system-site-packages", cls.folder / "env")
        run(cls.folder / "env/bin/pip", "wheel", "--no-deps", "-w", cls.folder, SETTINGS, SOURCE, env=cls.environment)
        (cls.wheel,) = cls.folder.glob("*.whl")
        print(f"{cls.wheel.name}: {cls.wheel.stat().st_size / 1e6:.0f} MB, {time.monotonic() - begin:.0f} s")
        cls.is_tree_changed = run("git", "-C", SOURCE, "status", "--porcelain", "--ignored") != before
        (cls.folder / "tshirt.json").write_bytes((SOURCE / "patterns/tshirt.json").read_bytes())

    def test_it_is_tagged_and_names_what_it_needs_and_no_folder_of_the_builder(self):
        self.assertRegex(self.wheel.name, r"-cp(3\d+)-cp\1-manylinux_2_\d+_x86_64\.whl$")
        self.assertFalse(self.is_tree_changed)
        with zipfile.ZipFile(self.wheel) as archive:
            names = archive.namelist()
            metadata = archive.read(next(one for one in names if one.endswith("/METADATA"))).decode()
            for name in names:
                content = archive.read(name)
                for place in (os.fspath(SOURCE), os.fspath(self.folder), f"{tempfile.gettempdir()}/selvedge-"):
                    self.assertFalse(place.encode() in content, f"{name} names {place}")
        self.assertIn("Requires-Dist: numpy", metadata)
        self.assertIn("License: GPL-3.0-or-later", metadata)
        self.assertTrue(any(one.endswith("licenses/LICENSE") for one in names))
        self.assertTrue(any("licenses/libraries/" in one for one in names))

    def test_what_it_tells_of_itself_is_known_before_it_is_built(self):
        script = "import sys, wheel_backend; print(wheel_backend.prepare_metadata_for_build_wheel(sys.argv[1]))"
        (self.folder / "info").mkdir()
        name = run(self.folder / "env/bin/python", "-B", "-c", script, self.folder / "info", cwd=SOURCE / "python").strip()
        with zipfile.ZipFile(self.wheel) as archive:
            for file in ("METADATA", "entry_points.txt"):
                self.assertEqual((self.folder / "info" / name / file).read_bytes(), archive.read(f"{name}/{file}"), file)

    def test_it_works_where_no_package_is_installed_but_numpy(self):
        run(sys.executable, "-m", "venv", self.folder / "bare")
        python = self.folder / "bare/bin/python"
        run(python, "-m", "pip", "install", "--no-deps", self.wheel, env=self.environment)
        without = subprocess.run([python, "-c", "import selvedge"], capture_output=True, text=True, check=False,
                                 env=self.environment)
        self.assertIn("selvedge needs NumPy", without.stderr.strip().splitlines()[-1])
        import numpy

        (self.folder / "numpy_only").mkdir()
        (self.folder / "numpy_only/numpy").symlink_to(pathlib.Path(numpy.__file__).parent)
        environment = {**self.environment, "PYTHONPATH": os.fspath(self.folder / "numpy_only")}
        run(python, "-c", SCRIPT, cwd=self.folder, env=environment)
        self.assertTrue((self.folder / "python.png").exists())

    def test_three_lines_make_a_picture(self):
        run(self.folder / "env/bin/pip", "install", self.wheel, env=self.environment)
        run(self.folder / "env/bin/selvedge", "dress", "tshirt.json", "--seconds", "12", "--render", "command.png",
            cwd=self.folder, env=self.environment)
        self.assertTrue((self.folder / "command.png").exists())


if __name__ == "__main__":
    unittest.main()

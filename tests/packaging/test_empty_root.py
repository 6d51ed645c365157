"""The program with the libraries that scripts/bundle_libraries gives it, where nothing else is but the C library."""

import os
import pathlib
import shutil
import tempfile
import unittest

from support import SOURCE, Installed, empty_root, run, skips


class EmptyRoot(Installed, unittest.TestCase):
    program = os.environ["SELVEDGE_PROGRAM"]
    selvedge = "/opt/somewhere/bin/selvedge"
    patterns = "/opt/somewhere/share/selvedge/patterns"

    @classmethod
    def setUpClass(cls):
        for tool in ("unshare", "chroot", "patchelf", "strip"):
            if not shutil.which(tool):
                skips.skip_program("packaging.empty_root", f"no {tool}")
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.root = empty_root(pathlib.Path(folder.name))
        tree = cls.root.folder / "opt/somewhere"
        build = os.environ["SELVEDGE_BUILD"]
        run("cmake", "--install", build, "--component", "program", "--prefix", tree, "--strip")
        run(SOURCE / "scripts/bundle_libraries", "--to", tree / "lib/selvedge", "--fonts", tree / "share/selvedge/fonts",
            "--licences", tree / "share/doc/selvedge/licences", tree / "bin/selvedge")

    def test_tells_its_version(self):
        lines = self.root.run(self.selvedge, "--version").stdout.splitlines()
        self.assertRegex(lines[0], r"^selvedge [0-9]+\.[0-9]+\.[0-9]+$")

    def test_starts_without_proc_when_it_is_told_where_it_lies(self):
        # The loader looks in /proc for the program's folder.
        done = run("unshare", *([] if os.geteuid() == 0 else ["--user", "--map-root-user"]), "chroot", self.root.folder,
                   self.selvedge, "--version", env={**os.environ, "LD_ORIGIN_PATH": "/opt/somewhere/bin"})
        self.assertIn("selvedge ", done.stdout)

    def test_refuses_a_film_on_one_line_that_names_ffmpeg(self):
        done = self.root.run(self.selvedge, "animate", f"{self.patterns}/skirt.json", "--motion", "walk", "--film",
                             "/files/walk.mp4", accepts=(2,))
        self.assertRegex(done.stderr, r"^selvedge: .*ffmpeg.*\n$")

    def test_tells_on_one_line_that_there_is_no_display(self):
        done = self.root.run(self.selvedge, "edit", accepts=(2,))
        self.assertRegex(done.stderr, r"^selvedge: window: .*\n$")

    def test_has_the_licence_of_every_library(self):
        tree = self.root.folder / "opt/somewhere"
        libraries = {file.name for file in (tree / "lib/selvedge").rglob("*.so*")}
        licences = tree / "share/doc/selvedge/licences"
        rows = [row.split("\t") for row in (licences / "packages.tsv").read_text().splitlines()[1:]]
        self.assertEqual(libraries - {name for row in rows for name in row[3].split()}, set())
        for row in rows:
            self.assertTrue((licences / f"{row[0]}.txt").read_text(), row[0])


if __name__ == "__main__":
    unittest.main()

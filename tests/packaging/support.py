"""What the tests of packages share."""

from __future__ import annotations

import os
import pathlib
import shutil
import subprocess
import sys
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(SOURCE / "tests/support"))
import skips

C_LIBRARY = ["libc.so.6", "libm.so.6", "libmvec.so.1", "libdl.so.2", "libpthread.so.0", "librt.so.1", "libresolv.so.2"]
LOADER = {"x86_64": "/lib64/ld-linux-x86-64.so.2", "aarch64": "/lib/ld-linux-aarch64.so.1"}[os.uname().machine]
QUICK = ["--edge-length", "8", "--max-level", "1", "--seconds", "1", "--size", "300x400", "--quiet"]


def run(*command: object, accepts: tuple[int, ...] = (0,), **options: object) -> subprocess.CompletedProcess[str]:
    words = [os.fspath(word) for word in command]
    done = subprocess.run(words, capture_output=True, text=True, check=False, **options)
    if done.returncode not in accepts:
        raise AssertionError(f"{words}: {done.returncode}: {done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done


class Root:
    """A folder that a program sees as the whole file system."""

    def __init__(self, folder: pathlib.Path):
        self.folder = folder

    def run(self, *command: object, accepts: tuple[int, ...] = (0,), **environment: str):
        words = [os.fspath(word) for word in command]
        enter = 'mount --rbind /proc "$0/proc" && mount --bind /dev/null "$0/dev/null" && exec chroot "$0" "$@"'
        user = [] if os.geteuid() == 0 else ["--user", "--map-root-user"]
        unshare = ["unshare", *user, "--mount", "--pid", "--fork", "sh", "-c", enter, self.folder]
        path = "/usr/sbin:/usr/bin:/sbin:/bin"
        return run(*unshare, *words, accepts=accepts, env={"PATH": path, "HOME": "/files", **environment})

    def is_allowed(self) -> bool:
        try:
            self.run(LOADER, "--version")
        except (AssertionError, OSError):
            return False
        return True


def empty_root(folder: pathlib.Path) -> Root:
    """Holds the C library, its loader, /proc, /dev/null, and an empty folder /files."""
    for name in ("files", "proc", "dev", "lib", "lib64"):
        (folder / name).mkdir(parents=True)
    (folder / "dev/null").touch()
    loader = folder / LOADER.lstrip("/")
    shutil.copyfile(LOADER, loader)
    loader.chmod(0o755)
    libraries = pathlib.Path(f"/lib/{os.uname().machine}-linux-gnu")
    target = folder / str(libraries).lstrip("/")
    target.mkdir()
    for name in C_LIBRARY:
        shutil.copyfile(libraries / name, target / name)
    root = Root(folder)
    if not root.is_allowed():
        skips.skip_program("packaging", "neither root nor a user namespace may enter another root folder")
    return root


class Installed:
    """Tests of a program in a root folder. A subclass sets root, selvedge (as seen from the root), the folder of its
    patterns there, and program, the same of the build."""

    root: Root
    selvedge: str
    patterns: str
    program: str

    def test_draws_the_picture_of_the_program_that_was_built(self: unittest.TestCase):
        self.root.run(self.selvedge, "dress", f"{self.patterns}/skirt.json", *QUICK, "--render", "/files/a.png",
                      accepts=(0, 3))
        theirs = self.root.folder / "files/b.png"
        run(self.program, "dress", SOURCE / "patterns/skirt.json", *QUICK, "--render", theirs, accepts=(0, 3))
        self.assertEqual((self.root.folder / "files/a.png").read_bytes(), theirs.read_bytes())

    def test_prints_texts_that_are_read_again_from_the_pages(self: unittest.TestCase):
        self.root.run(self.selvedge, "print", f"{self.patterns}/tshirt.json", "-o", "/files/t.pdf")
        self.root.run(self.selvedge, "import", "/files/t.pdf", "-o", "/files/t.garment.json")
        text = (self.root.folder / "files/t.garment.json").read_text()
        self.assertIn('"left_sleeve_front"', text)  # without a font, there are no names in the pages

    def test_reads_bodies_in_its_child_process(self: unittest.TestCase):
        self.root.run(self.selvedge, "mannequin", "-o", "/files/body.obj")
        self.root.run(self.selvedge, "dress", f"{self.patterns}/skirt.json", "--body", "/files/body.obj", *QUICK,
                      "--export", "/files/skirt.glb", accepts=(0, 3))
        self.root.run(self.selvedge, "render", "/files/skirt.glb", "-o", "/files/c.png", "--size", "64x64")

    def test_plays_a_script_of_the_editor(self: unittest.TestCase):
        self.root.run(self.selvedge, "edit", f"{self.patterns}/skirt.json", "--screenshot", "/files/edit.png", "--size",
                      "640x480")
        self.assertGreater((self.root.folder / "files/edit.png").stat().st_size, 10_000)

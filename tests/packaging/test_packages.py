"""What scripts/package makes: the archive, unpacked elsewhere, and the .deb, installed by apt in a new system."""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

from support import SOURCE, Installed, Root, empty_root, run, skips

PACKAGES = SOURCE / "out/packages"
PROGRAM = SOURCE / "build/release/selvedge"
LARGEST = 60_000_000  # bytes, of a package
OS_RELEASE = dict(re.findall(r'^([A-Z_]+)="?([^"\n]*)"?$', pathlib.Path("/etc/os-release").read_text(), re.M))


def setUpModule():
    if OS_RELEASE.get("ID") != "debian":
        skips.skip_program("packaging.packages", "packages are made on Debian")
    shutil.rmtree(PACKAGES, ignore_errors=True)
    print(run(SOURCE / "scripts/package").stdout, flush=True)


def only(pattern):
    (found,) = PACKAGES.glob(pattern)
    return found


def folder_of_test(case):
    folder = tempfile.TemporaryDirectory()
    case.addClassCleanup(folder.cleanup)
    return pathlib.Path(folder.name)


def is_elf(file):
    with file.open("rb") as stream:
        return stream.read(4) == b"\x7fELF"


class Archive(Installed, unittest.TestCase):
    program = os.fspath(PROGRAM)

    @classmethod
    def setUpClass(cls):
        cls.root = empty_root(folder_of_test(cls))
        cls.archive = only("selvedge-*-linux-*.tar.xz")
        (cls.root.folder / "anywhere").mkdir()
        run("tar", "--extract", "--file", cls.archive, "--directory", cls.root.folder / "anywhere")
        (cls.tree,) = (cls.root.folder / "anywhere").iterdir()
        place = f"/anywhere/{cls.tree.name}"
        cls.selvedge, cls.patterns = f"{place}/bin/selvedge", f"{place}/share/selvedge/patterns"
        cls.files = [file for file in cls.tree.rglob("*") if file.is_file() and not file.is_symlink()]

    def test_is_small_enough(self):
        self.assertLessEqual(self.archive.stat().st_size, LARGEST)

    def test_names_no_folder_of_the_builder(self):
        for text in (os.fspath(SOURCE), os.fspath(pathlib.Path.home()) + "/"):
            holders = [file for file in self.files if text.encode() in file.read_bytes()]
            self.assertEqual(holders, [], text)

    def test_asks_for_no_newer_c_library_than_that_of_debian_12(self):
        if OS_RELEASE["VERSION_ID"] != "12":
            skips.skip_test(self.id(), "the archive is made on Debian 12")
        for file in filter(is_elf, self.files):
            versions = re.findall(r"GLIBC_2\.([0-9]+)", run("readelf", "--version-info", "--wide", file).stdout)
            self.assertLessEqual(max(map(int, versions), default=0), 36, file)

    def test_looks_for_libraries_beside_itself_and_in_the_system_only(self):
        for file in filter(is_elf, self.files):
            found = re.search(r"RUNPATH.*\[(.*)\]", run("readelf", "--dynamic", "--wide", file).stdout)
            for folder in found[1].split(":"):
                self.assertTrue(folder.startswith(("$ORIGIN", "/usr/lib")), f"{file}: {folder}")

    def test_opens_a_window_with_the_libraries_of_this_system_that_drivers_share(self):
        for tool in ("Xvfb", "xdotool"):
            if not shutil.which(tool):
                skips.skip_test(self.id(), f"no {tool}")
        read, write = os.pipe()
        server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1400x900x24"], pass_fds=[write],
                                  stderr=subprocess.DEVNULL)
        self.addCleanup(server.wait)
        self.addCleanup(server.kill)
        os.close(write)
        with os.fdopen(read) as stream:
            environment = {**os.environ, "DISPLAY": f":{stream.readline().strip()}", "HOME": os.fspath(self.root.folder)}
        editor = subprocess.Popen([self.tree / "bin/selvedge", "edit", self.tree / "share/selvedge/patterns/skirt.json"],
                                  env=environment)
        self.addCleanup(editor.wait)
        self.addCleanup(editor.kill)
        run("timeout", "120", "xdotool", "search", "--sync", "--onlyvisible", "--name", "skirt.json - Selvedge",
            env=environment)
        self.assertIsNone(editor.poll())
        mapped = pathlib.Path(f"/proc/{editor.pid}/maps").read_text()
        for name in ("libstdc++.so.6", "libX11.so.6"):
            self.assertRegex(mapped, rf" /(usr/)?lib/\S*/{re.escape(name)}", name)
            self.assertNotIn(f"fallback/{name}", mapped)
        self.assertIn("lib/selvedge/libglfw.so.3", mapped)

    def test_is_the_same_when_it_is_made_again(self):
        before = self.archive.read_bytes()
        run(SOURCE / "scripts/package", "archive")
        self.assertTrue(self.archive.read_bytes() == before)


class Metadata(unittest.TestCase):
    """What desktops read of the installed files."""

    @classmethod
    def setUpClass(cls):
        cls.share = folder_of_test(cls) / "usr/share"
        run("dpkg-deb", "--extract", only("selvedge_*.deb"), cls.share.parent.parent)

    def test_desktop_file_is_valid(self):
        self.assertEqual(run("desktop-file-validate", self.share / "applications/selvedge.desktop").stdout, "")

    def test_metainfo_is_valid_but_for_a_domain_and_a_page_that_the_project_does_not_have(self):
        if not shutil.which("appstreamcli"):
            skips.skip_test(self.id(), "no appstreamcli")
        done = run("appstreamcli", "validate", "--no-net", self.share / "metainfo/selvedge.metainfo.xml", accepts=(0, 3))
        found = set(re.findall(r"^[EW]: \S+ (\S+)", done.stdout, re.M))
        self.assertLessEqual(found, {"cid-desktopapp-is-not-rdns", "url-homepage-missing"}, done.stdout)

    def test_garments_have_a_type_and_other_json_files_have_not(self):
        run("update-mime-database", self.share / "mime")
        globs = (self.share / "mime/globs2").read_text()
        self.assertIn(":application/x-selvedge-garment+json:*.garment.json\n", globs)
        self.assertNotIn(":*.json\n", globs)

    def test_manual_names_every_command(self):
        page = run("gzip", "-dc", self.share / "man/man1/selvedge.1.gz").stdout
        listed = run(PROGRAM, "--help").stdout.split("Subcommands:")[1]
        for command in re.findall(r"^  ([a-z]+) ", listed, re.M):
            self.assertIn(f".B {command}\n", page)


class Deb(Installed, unittest.TestCase):
    """Installed by apt in a system that debootstrap makes; skipped where Debian's archive is not reached."""

    program = os.fspath(PROGRAM)
    selvedge = "/usr/bin/selvedge"
    patterns = "/usr/share/selvedge/patterns"

    @classmethod
    def setUpClass(cls):
        cls.deb = only("selvedge_*.deb")
        if not shutil.which("debootstrap") or os.geteuid() != 0:
            skips.skip_test("packaging.packages.Deb", "needs debootstrap, and root")
        folder = folder_of_test(cls) / "system"
        try:
            run("debootstrap", "--variant=minbase", OS_RELEASE["VERSION_CODENAME"], folder)
        except AssertionError as failure:
            skips.skip_test("packaging.packages.Deb", f"debootstrap: {str(failure)[-200:]}")
        for file in pathlib.Path("/etc/apt").glob("sources.list.d/debian.sources"):
            shutil.copyfile(file, folder / "etc/apt/sources.list.d" / file.name)
        (folder / "etc/apt/apt.conf.d/90no-date").write_text('Acquire::Check-Valid-Until "false";\n')
        (folder / "files").mkdir()
        cls.root = Root(folder)
        shutil.copyfile(cls.deb, folder / "files" / cls.deb.name)
        shutil.copyfile("/etc/resolv.conf", folder / "etc/resolv.conf")
        cls.root.run("apt-get", "update")
        cls.root.run("apt-get", "install", "--yes", "--no-install-recommends", f"/files/{cls.deb.name}",
                     DEBIAN_FRONTEND="noninteractive")

    def test_is_small_enough(self):
        self.assertLessEqual(self.deb.stat().st_size, LARGEST)

    def test_has_no_errors_of_lintian(self):
        done = subprocess.run(["lintian", "--fail-on", "error", "--allow-root", self.deb], capture_output=True, text=True,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_is_removed_without_a_trace(self):
        before = {os.fspath(path) for path in (self.root.folder / "usr").rglob("*selvedge*")}
        self.root.run("dpkg", "--remove", "selvedge")
        left = list((self.root.folder / "usr").rglob("*selvedge*"))
        self.root.run("dpkg", "--install", f"/files/{self.deb.name}")
        self.assertEqual(left, [])
        self.assertEqual({os.fspath(path) for path in (self.root.folder / "usr").rglob("*selvedge*")}, before)


if __name__ == "__main__":
    unittest.main(verbosity=2)

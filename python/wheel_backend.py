"""Builds the wheel: a backend of `pip install .` (PEP 517) that runs CMake. Needs nothing but Python's own library, so
that pip works without a network, and leaves no file in the source tree, which setuptools would.

The sources are copied to a temporary folder and built there by the preset release, as build/release of a checkout is:
so a compiler cache serves one from the other. `pip install . --config-settings build-folder=FOLDER` keeps that folder,
for the next time; `--config-settings cmake=-DX=Y` passes an argument on.

In the wheel: selvedge/ with the module, bin/selvedge, lib/ with their shared libraries (scripts/bundle_libraries) and
the licences. Where libraries cannot be bundled, the wheel is for this machine only, which is told.
"""

from __future__ import annotations

import base64
import contextlib
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import tomllib
import zipfile
from collections.abc import Iterator
from typing import Any

ROOT = pathlib.Path(__file__).resolve().parents[1]
Settings = dict[str, Any] | None
INTER = pathlib.Path("/usr/share/fonts/opentype/inter")  # the package fonts-inter
DATE = (1980, 1, 1, 0, 0, 0)  # of the files in a wheel: the earliest that an archive can hold, for equal bytes


def _project() -> dict[str, Any]:
    found: dict[str, Any] = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    return found


def _version() -> str:
    found = re.search(r"project\(selvedge VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))
    if not found:
        raise SystemExit("selvedge: CMakeLists.txt names no version")
    return found[1]


def _numpy() -> str:
    """What it needs of NumPy: what pybind11 compiles before 2.12 reads arrays of NumPy 1 only."""
    version = _output("pkg-config", "--modversion", "pybind11").strip()
    numbers = tuple(int(part) for part in re.findall(r"\d+", version)[:2])
    return "numpy>=1.24,<2" if numbers < (2, 12) else "numpy>=1.24"


def _metadata() -> str:
    project = _project()
    heads = {
        "Metadata-Version": "2.1",
        "Name": project["name"],
        "Version": _version(),
        "Summary": project["description"],
        "License": project["license"]["text"],
        "Keywords": ",".join(project["keywords"]),
        "Requires-Python": project["requires-python"],
        "Requires-Dist": _numpy(),
        "Description-Content-Type": "text/markdown",
    }
    lines = [f"{name}: {value}" for name, value in heads.items()]
    lines += [f"Classifier: {one}" for one in project["classifiers"]]
    return "\n".join(lines) + "\n\n" + (ROOT / project["readme"]).read_text(encoding="utf-8")


def _run(*command: str | os.PathLike[str]) -> None:
    # What pip says to the Python of this process is not for the Python programs that CMake runs, such as glad.
    environment = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "PYTHONNOUSERSITE")}
    try:
        subprocess.run(command, check=True, env=environment)
    except FileNotFoundError:
        raise SystemExit(f"selvedge: {command[0]} is not installed: see scripts/install_dependencies") from None
    except subprocess.CalledProcessError as error:
        raise SystemExit(f"selvedge: {command[0]} ended with {error.returncode}: see above") from None


def _output(*command: str | os.PathLike[str]) -> str:
    try:
        return subprocess.run(command, check=True, capture_output=True, text=True).stdout
    except (FileNotFoundError, subprocess.CalledProcessError):
        return ""


def _sources(folder: pathlib.Path) -> list[pathlib.Path]:
    """What a build needs of the tree: no history, no earlier builds and environments, no tests."""
    return [one for one in sorted(folder.iterdir())
            if not one.name.startswith(".") and one.name not in ("build", "out", "tests")
            and not (one / "pyvenv.cfg").exists() and not one.name.endswith((".whl", ".tar.gz"))]


@contextlib.contextmanager
def _work_folder(settings: Settings) -> Iterator[pathlib.Path]:
    kept = (settings or {}).get("build-folder")
    if kept:
        folder = pathlib.Path(kept).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        yield folder
        return
    with tempfile.TemporaryDirectory(prefix="selvedge-") as name:
        yield pathlib.Path(name)


def _copy_sources(folder: pathlib.Path) -> pathlib.Path:
    """Keeps the times of files, so that a folder that is used again compiles what has changed."""
    copy = folder / "selvedge"
    copy.mkdir(exist_ok=True)
    for one in copy.iterdir():
        if one.name == "build":
            continue
        if one.is_dir():
            shutil.rmtree(one)
        else:
            one.unlink()
    for one in _sources(ROOT):
        if one.is_dir():
            shutil.copytree(one, copy / one.name, ignore=shutil.ignore_patterns("__pycache__"))
        else:
            shutil.copy2(one, copy)
    return copy


def _compile(sources: pathlib.Path, settings: Settings) -> pathlib.Path:
    """The folder of the build."""
    build = sources / "build" / "release"
    given = (settings or {}).get("cmake", [])
    arguments = [given] if isinstance(given, str) else given
    _run("cmake", "-S", sources, "--preset", "release", "-DSELVEDGE_TESTS=OFF", "-DSELVEDGE_WERROR=OFF",
         f"-DPython3_EXECUTABLE={sys.executable}", *arguments)
    _run("cmake", "--build", build, "--target", "selvedge_python", "selvedge")
    return build


def _stage(build: pathlib.Path, sources: pathlib.Path, folder: pathlib.Path) -> bool:
    """Lays the package and its licences into an empty folder. Whether its libraries are in it."""
    package = folder / "selvedge"
    shutil.copytree(build / "python/selvedge", package, ignore=shutil.ignore_patterns("__pycache__"))
    (package / "bin").mkdir()
    shutil.copy2(build / "selvedge", package / "bin/selvedge")
    licences = folder / f"selvedge-{_version()}.dist-info/licenses"
    licences.mkdir(parents=True)
    shutil.copy2(sources / "LICENSE", licences)
    modules = sorted(package.glob("_selvedge*.so"))
    tool = sources / "scripts/bundle_libraries"
    if not all(shutil.which(one) for one in ("patchelf", "strip", "dpkg")):
        print("selvedge: patchelf, strip or dpkg is missing: the wheel has no libraries in it, and is for this machine only")
        return False
    fonts: list[str | pathlib.Path] = ["--fonts", package / "share/selvedge/fonts"] if INTER.is_dir() else []
    _run(sys.executable, tool, "--rename", "--to", package / "lib", "--licences", licences / "libraries", *fonts, *modules,
         package / "bin/selvedge")
    return True


def _platform(folder: pathlib.Path, has_libraries: bool) -> str:
    """manylinux_2_36_x86_64 where nothing needs more than that version of the C library."""
    processor = os.uname().machine
    if not has_libraries:
        return f"linux_{processor}"
    newest = 0
    for file in folder.rglob("*"):
        if file.is_file() and file.read_bytes()[:4] == b"\x7fELF":
            versions = re.findall(r"GLIBC_2\.(\d+)", _output("readelf", "--version-info", "--wide", file))
            newest = max([newest, *map(int, versions)])
    return f"manylinux_2_{newest}_{processor}"


def _tag(folder: pathlib.Path, has_libraries: bool) -> str:
    python = "cp" + sysconfig.get_config_var("py_version_nodot")
    return f"{python}-{python}-{_platform(folder, has_libraries)}"


def _add(archive: zipfile.ZipFile, name: str, content: bytes, is_program: bool = False) -> None:
    info = zipfile.ZipInfo(name, DATE)
    info.compress_type = zipfile.ZIP_DEFLATED
    info.external_attr = (0o100755 if is_program else 0o100644) << 16
    archive.writestr(info, content, compresslevel=9)


def _pack(folder: pathlib.Path, wheel: pathlib.Path) -> None:
    records = []
    record = f"selvedge-{_version()}.dist-info/RECORD"
    with zipfile.ZipFile(wheel, "w") as archive:
        for file in sorted(one for one in folder.rglob("*") if one.is_file()):
            name, content = file.relative_to(folder).as_posix(), file.read_bytes()
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            records.append(f"{name},sha256={digest},{len(content)}\n")
            _add(archive, name, content, os.access(file, os.X_OK))
        _add(archive, record, "".join([*records, f"{record},,\n"]).encode())


def _write_info(folder: pathlib.Path, tag: str) -> str:
    """Writes what the wheel tells of itself, but for the list of its files; the name of the folder that holds it."""
    info = folder / f"selvedge-{_version()}.dist-info"
    info.mkdir(exist_ok=True)
    (info / "METADATA").write_text(_metadata(), encoding="utf-8")
    (info / "WHEEL").write_text(f"Wheel-Version: 1.0\nGenerator: selvedge\nRoot-Is-Purelib: false\nTag: {tag}\n")
    scripts = "".join(f"{script} = {function}\n" for script, function in _project()["scripts"].items())
    (info / "entry_points.txt").write_text(f"[console_scripts]\n{scripts}")
    return info.name


def prepare_metadata_for_build_wheel(metadata_directory: str, config_settings: Settings = None) -> str:
    """So pip finds out that NumPy is missing before it compiles. What the tag will be is not known yet."""
    folder = pathlib.Path(metadata_directory)
    return _write_info(folder, _tag(folder, has_libraries=False))


def build_wheel(wheel_directory: str, config_settings: Settings = None, metadata_directory: str | None = None) -> str:
    """Builds it; its file's name."""
    with _work_folder(config_settings) as work, tempfile.TemporaryDirectory(prefix="selvedge-") as name:
        folder = pathlib.Path(name)
        sources = _copy_sources(work)
        has_libraries = _stage(_compile(sources, config_settings), sources, folder)
        tag = _tag(folder, has_libraries)
        _write_info(folder, tag)
        wheel = f"selvedge-{_version()}-{tag}.whl"
        _pack(folder, pathlib.Path(wheel_directory, wheel))
    return wheel


def build_sdist(sdist_directory: str, config_settings: Settings = None) -> str:
    """The sources that a build needs; its file's name."""
    name = f"selvedge-{_version()}"
    with tarfile.open(pathlib.Path(sdist_directory, f"{name}.tar.gz"), "w:gz", format=tarfile.PAX_FORMAT) as archive:
        info = tarfile.TarInfo(f"{name}/PKG-INFO")
        with tempfile.TemporaryFile() as content:
            info.size = content.write(_metadata().encode())
            content.seek(0)
            archive.addfile(info, content)
        for one in _sources(ROOT):
            archive.add(one, f"{name}/{one.name}",
                        filter=lambda entry: None if "__pycache__" in entry.name else entry)
    return f"{name}.tar.gz"

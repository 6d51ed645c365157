#!/usr/bin/env python3
"""Other projects that use the library (docs/library.md). Installed: the library is installed alone, and the example of
examples/ is built against it; its positions are the program's, bit for bit. Within: a project takes this one in, and stays
what it was; nothing is built. Built: the same, built and run. Usage: SELVEDGE_BUILD=... SELVEDGE_PROGRAM=...
SELVEDGE_COMPILER=... test_projects.py [Installed|Within|Built]"""
import os
import pathlib
import re
import shutil
import struct
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ["SELVEDGE_BUILD"])
PROGRAM = os.environ["SELVEDGE_PROGRAM"]
COMPILER = os.environ.get("SELVEDGE_COMPILER", "c++")
GARMENT = ROOT / "patterns/skirt.json"
WARNINGS = ["-Wall", "-Wextra", "-Wconversion", "-Wpedantic", "-Wshadow", "-Werror"]


def run(*command, cwd=None, code=0):
    """What the command prints. Fails if it ends with another code."""
    done = subprocess.run([str(word) for word in command], cwd=cwd, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, check=False)
    if done.returncode != code:
        raise AssertionError(f"{' '.join(map(str, command))}: {done.returncode}\n{done.stdout[-4000:]}")
    return done.stdout


def configure(source, build, *options, code=0):
    return run("cmake", "-S", source, "-B", build, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={COMPILER}", *options, code=code)


def positions_of(path):
    """The bits of the positions in an OBJ file, as floats."""
    lines = [line.split()[1:4] for line in path.read_text().splitlines() if line.startswith("v ")]
    return [struct.pack("3f", *map(float, line)) for line in lines]


def cache_of(build):
    """Names of the entries of a build folder's cache."""
    return set(re.findall(r"^([^/#:\n][^:\n]*):", (build / "CMakeCache.txt").read_text(), re.M))


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="selvedge_project_"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def check_positions(self, example):
        """The example's positions are those that the program writes."""
        run(example, GARMENT, "library.obj", cwd=self.folder)
        run(PROGRAM, "dress", GARMENT, "-q", "--no-textures", "--export", "program.obj", cwd=self.folder)
        ours, theirs = (positions_of(self.folder / name) for name in ("library.obj", "program.obj"))
        self.assertGreater(len(ours), 1000)
        self.assertEqual(ours, theirs)


class Installed(Case):
    def setUp(self):
        super().setUp()
        self.prefix = self.folder / "prefix"
        run("cmake", "--install", BUILD, "--prefix", self.prefix, "--component", "library")

    def test_the_example_dresses_as_the_program_does(self):
        source, build = self.folder / "source", self.folder / "build"
        shutil.copytree(ROOT / "examples", source)
        configure(source, build, f"-DCMAKE_PREFIX_PATH={self.prefix}", "-DCMAKE_BUILD_TYPE=Release",
                  f"-DCMAKE_CXX_FLAGS={' '.join(WARNINGS)}")
        found = re.search(r"^selvedge_DIR:PATH=(.*)$", (build / "CMakeCache.txt").read_text(), re.M)[1]
        self.assertTrue(pathlib.Path(found).is_relative_to(self.prefix), found)
        run("cmake", "--build", build)
        self.check_positions(build / "dress")
        text = (source / "CMakeLists.txt").read_text()
        (source / "CMakeLists.txt").write_text(text.replace("selvedge 0.1 ", "selvedge 0.2 "))
        self.assertNotEqual(text, (source / "CMakeLists.txt").read_text())
        said = configure(source, self.folder / "newer", f"-DCMAKE_PREFIX_PATH={self.prefix}", code=1)
        self.assertIn("not accepted", " ".join(said.split()))

    def test_nothing_of_the_checkout_is_installed(self):
        files = [path for path in self.prefix.rglob("*") if path.is_file() and not path.is_symlink()]
        self.assertIn("selvedge.h", [path.name for path in files])
        for path in files:
            self.assertTrue(path.suffix in (".h", ".cmake") or path.name.startswith("libselvedge.so."), path)
            self.assertNotEqual(path.name, "content.h")
            if path.suffix in (".h", ".cmake"):
                for folder in (ROOT, BUILD):  # as a whole path: it may be one with a usual name, as /selvedge
                    self.assertNotRegex(path.read_text(), rf"(?<![\w}}]){re.escape(str(folder))}", path)

    def test_the_library_shows_its_public_names_alone(self):
        library = next(self.prefix.rglob("libselvedge.so"))
        names = [line.split(maxsplit=2)[2] for line in run("nm", "-DC", "--defined-only", library).splitlines()]
        self.assertIn("selvedge::version()", names)
        for name in names:
            self.assertRegex(name, r"^(typeinfo (name )?for |vtable for )?selvedge::")
            self.assertNotRegex(name, r"^(typeinfo (name )?for |vtable for )?selvedge::(sim|render|app|editor)::")
        self.assertRegex(run("readelf", "-d", library), r"SONAME.*libselvedge\.so\.0\.1\b")
        self.assertNotRegex(run("readelf", "-d", library), r"RPATH|RUNPATH")

    def test_the_code_of_the_page_compiles(self):
        page = (ROOT / "docs/library.md").read_text(encoding="utf-8")
        blocks = re.findall(r"^```cpp\n(.*?)^```", page, re.M | re.S)
        self.assertTrue(blocks)
        for block in blocks:
            source = self.folder / "page.cpp"
            source.write_text(block)
            run(COMPILER, "-std=c++17", "-fsyntax-only", *WARNINGS, "-Wno-missing-field-initializers",
                f"-I{self.prefix}/include", source)

    def test_each_header_compiles_alone(self):
        headers = sorted((self.prefix / "include/selvedge").iterdir())
        for compiler, standard, tried in (("g++", "c++17", headers), ("clang++", "c++17", headers[-2:]),
                                          ("clang++", "c++20", headers[-2:])):
            for header in tried if shutil.which(compiler) else ():
                source = self.folder / "one.cpp"
                source.write_text(f"#include <selvedge/{header.name}>\n")
                run(compiler, f"-std={standard}", "-fsyntax-only", *WARNINGS, f"-I{self.prefix}/include", source)
        self.assertEqual([header.name for header in headers[-2:]], ["selvedge.h", "version.h"])


# A project that has settings of its own, and stops where they were changed.
PARENT = """cmake_minimum_required(VERSION 3.25)
project(parent VERSION 3 LANGUAGES CXX)
set(CMAKE_CXX_STANDARD 17)
enable_testing()
add_test(NAME own COMMAND true)
@TAKE@
foreach(property COMPILE_OPTIONS COMPILE_DEFINITIONS INCLUDE_DIRECTORIES LINK_OPTIONS LINK_LIBRARIES)
  get_property(value DIRECTORY PROPERTY ${property})
  if(value)
    message(FATAL_ERROR "${property} of this folder is now '${value}'")
  endif()
endforeach()
foreach(variable CMAKE_BUILD_TYPE CMAKE_RUNTIME_OUTPUT_DIRECTORY CMAKE_CXX_COMPILER_LAUNCHER CMAKE_C_COMPILER_LAUNCHER
    CMAKE_CXX_EXTENSIONS CMAKE_POSITION_INDEPENDENT_CODE BUILD_TESTING)
  if(NOT "${${variable}}" STREQUAL "${GIVEN_${variable}}")
    message(FATAL_ERROR "${variable} is now '${${variable}}'")
  endif()
endforeach()
if(NOT CMAKE_PROJECT_VERSION EQUAL 3 OR NOT PROJECT_VERSION EQUAL 3 OR NOT CMAKE_CXX_STANDARD EQUAL 17)
  message(FATAL_ERROR "the version or the C++ standard of this folder has changed")
endif()
add_executable(dress dress.cpp)
target_link_libraries(dress PRIVATE selvedge::selvedge)
"""
TAKE = {"add_subdirectory": 'add_subdirectory("@ROOT@" selvedge)',
        "FetchContent": 'include(FetchContent)\nFetchContent_Declare(selvedge SOURCE_DIR "@ROOT@")\n'
                        "FetchContent_MakeAvailable(selvedge)"}


class Parent(Case):
    def make_parent(self, how):
        source = self.folder / "source"
        source.mkdir()
        shutil.copy(ROOT / "examples/dress.cpp", source)
        (source / "CMakeLists.txt").write_text(PARENT.replace("@TAKE@", TAKE[how]).replace("@ROOT@", str(ROOT)))
        return source


class Within(Parent):
    def test_a_project_stays_what_it_was_when_it_takes_this_one_in(self):
        source, build, alone = self.make_parent("add_subdirectory"), self.folder / "build", self.folder / "alone"
        configure(source, build, "-DGIVEN_CMAKE_BUILD_TYPE=Release", "-DCMAKE_BUILD_TYPE=Release")
        (self.folder / "bare").mkdir()
        (self.folder / "bare/CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.25)\nproject(parent VERSION 3 LANGUAGES C CXX)\nfind_package(Threads)\n")
        configure(self.folder / "bare", alone, "-DGIVEN_CMAKE_BUILD_TYPE=Release", "-DCMAKE_BUILD_TYPE=Release")
        new = [name for name in cache_of(build) - cache_of(alone)
               if name.startswith(("CMAKE_", "BUILD_")) or name in ("CCACHE", "BUILDNAME", "SITE")]
        self.assertEqual(new, [])
        self.assertNotRegex((build / "CMakeCache.txt").read_text(), r"(?m)^(CLI11|GTest|pybind11)_DIR|^(glfw|imgui)_FOUND")
        listed = run("ctest", "--test-dir", build, "-N")
        self.assertRegex(listed, r"Total Tests: 1\b")
        for script in build.rglob("cmake_install.cmake"):
            self.assertNotIn("file(INSTALL", script.read_text(), script)
        steps = run("ninja", "-C", build, "-t", "commands", "dress")
        self.assertRegex(steps, r"-shared .*libselvedge\.so")
        self.assertNotRegex(steps, r" -c \S*/(app|batch|bench|editor|python|tests)/")


class Built(Parent):
    def test_a_project_that_fetches_this_one_dresses_as_the_program_does(self):
        source, build = self.make_parent("FetchContent"), self.folder / "build"
        cached = []
        if shutil.which("ccache"):  # as this project sets it for itself
            words = ("cmake;-E;env;CCACHE_DEPEND=true;CCACHE_NOHASHDIR=true;CCACHE_SLOPPINESS=pch_defines,time_macros;"
                     f"CCACHE_BASEDIR={ROOT};ccache")
            cached = [f"-D{prefix}CMAKE_CXX_COMPILER_LAUNCHER={words}" for prefix in ("", "GIVEN_")]
        configure(source, build, "-DGIVEN_CMAKE_BUILD_TYPE=Release", "-DCMAKE_BUILD_TYPE=Release",
                  "-DCMAKE_CXX_FLAGS_RELEASE=-O3", "-DSELVEDGE_BATCH_SIZE=16", *cached)
        run("cmake", "--build", build, "--target", "dress")
        self.check_positions(build / "dress")


if __name__ == "__main__":
    unittest.main()

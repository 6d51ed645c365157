"""Each style check must be able to fail: here every one meets the snippet that it is there for."""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import check_format
import check_includes
import check_text
import rules
from sources import Source, functions_of

PRAGMA = "#pragma once\n// What it is for.\n"


def problems(faults):
    return [str(fault) for fault in faults]


class Includes(unittest.TestCase):
    def test_a_room_that_reaches_back_is_named_with_its_line(self):
        bad = Source("sim/core/math.h", '#pragma once\n#include "sim/mesh/sew.h"\n')
        self.assertEqual(problems(check_includes.check_directions([bad])),
                         ["sim/core/math.h:2: sim/core may not include sim/mesh"])

    def test_the_simulation_may_not_ask_the_renderer(self):
        bad = Source("sim/dress/dress.cpp", '#include "render/draw/renderer.h"\n')
        self.assertEqual(len(list(check_includes.check_directions([bad]))), 1)

    def test_what_the_table_allows_passes(self):
        good = Source("sim/mesh/sew.cpp", '#include "sim/mesh/sew.h"\n#include "sim/core/math.h"\n#include <vector>\n')
        self.assertEqual(problems(check_includes.check_directions([good])), [])

    def test_an_include_that_does_not_start_at_the_root_fails(self):
        bad = Source("sim/mesh/sew.cpp", '#include "sew.h"\n')
        self.assertEqual(len(list(check_includes.check_directions([bad]))), 1)

    def test_a_folder_that_is_no_room_fails(self):
        bad = Source("sim/magic/wand.h", PRAGMA)
        self.assertEqual(problems(check_includes.check_directions([bad])),
                         ["sim/magic/wand.h:1: stands in no room of the table"])

    def test_a_package_outside_its_room_fails(self):
        for name, path in [("nlohmann/json.hpp", "sim/pattern/load.cpp"), ("CGAL/version.h", "sim/body/body.cpp"),
                           ("tbb/parallel_for.h", "sim/cloth/step.cpp"), ("png.h", "render/gl/handle.cpp"),
                           ("CLI/CLI.hpp", "sim/dress/dress.h"), ("assimp/scene.h", "render/draw/renderer.cpp"),
                           ("GL/osmesa.h", "app/main.cpp"), ("gtest/gtest.h", "sim/core/math.h")]:
            bad = Source(path, f"#include <{name}>\n")
            self.assertEqual(len(list(check_includes.check_packages([bad]))), 1, name)

    def test_a_package_in_its_room_or_in_a_test_passes(self):
        good = [Source("sim/core/json.cpp", "#include <nlohmann/json.hpp>\n"),
                Source("tests/sim/body/checks.cpp", "#include <CGAL/Surface_mesh.h>\n")]
        self.assertEqual(problems(check_includes.check_packages(good)), [])

    def test_files_that_include_each_other_are_a_circle(self):
        faults = check_includes.check_cycles([Source("sim/core/a.h", '#include "sim/core/b.h"\n'),
                                              Source("sim/core/b.h", '#include "sim/core/a.h"\n')])
        self.assertEqual(problems(faults),
                         ["sim/core/a.h:1: a circle: sim/core/a.h -> sim/core/b.h -> sim/core/a.h"])

    def test_rooms_that_include_each_other_are_a_circle_even_by_different_files(self):
        faults = check_includes.check_cycles([Source("app/a.h", '#include "bench/c.h"\n'), Source("bench/c.h", ""),
                                              Source("bench/b.h", '#include "app/d.h"\n'), Source("app/d.h", "")])
        self.assertEqual(problems(faults), ["app/a.h:1: a circle: app -> bench -> app"])


    def test_a_table_in_the_document_that_says_otherwise_fails(self):
        rows = [f"| {room} | {', '.join(others) or 'nothing of ours'} |" for room, others in rules.MAY_INCLUDE.items()]
        self.assertEqual(problems(check_includes.check_document("\n".join(rows))), [])
        rows[0] = "| sim/core | sim/mesh |"
        self.assertEqual(problems(check_includes.check_document("\n".join(rows))),
                         ["docs/architecture.md:1: sim/core stands otherwise in tests/style/rules.py"])
        self.assertEqual(len(list(check_includes.check_document("\n".join(rows[2:])))), 2)


class Text(unittest.TestCase):
    def faults_of(self, text, path="sim/core/x.cpp"):
        return problems(check_text.check_lines([Source(path, text)]))

    def test_tabs_and_space_at_line_ends_fail(self):
        self.assertEqual(self.faults_of("int a;\n\tint b;\n"), ["sim/core/x.cpp:2: a tab"])
        self.assertEqual(self.faults_of("int a; \n"), ["sim/core/x.cpp:1: space at the end of the line"])

    def test_a_missing_last_newline_fails(self):
        self.assertEqual(len(self.faults_of("int a;")), 1)

    def test_open_ends_and_machine_paths_fail(self):
        self.assertEqual(len(self.faults_of("// TO" + "DO later\n")), 1)
        self.assertEqual(len(self.faults_of('open("/ho' + 'me/someone/file");\n')), 1)
        self.assertEqual(self.faults_of("int todos = 1;  // see docs/tmp_notes, a/work/b\n"), [])

    def test_a_header_without_guard_or_purpose_fails(self):
        for text in ["// What it is for.\n", "#pragma once\n\nint a;\n", "#pragma once\n"]:
            self.assertEqual(len(list(check_text.check_headers([Source("sim/core/x.h", text)]))), 1, text)
        self.assertEqual(problems(check_text.check_headers([Source("sim/core/x.h", PRAGMA)])), [])


class Lengths(unittest.TestCase):
    def test_a_file_that_is_too_long_fails(self):
        self.assertEqual(len(list(check_text.check_lengths([Source("sim/core/x.cpp", "int a;\n" * 451)]))), 1)
        self.assertEqual(len(list(check_text.check_lengths([Source("sim/core/x.cpp", "int a;\n" * 450)]))), 0)

    def test_a_function_that_is_too_long_fails_at_its_place(self):
        text = "namespace selvedge {\n\nint f(int a) {\n" + "    a += 1;\n" * 59 + "}\n\n}\n"
        self.assertEqual(problems(check_text.check_lengths([Source("sim/core/x.cpp", text)])),
                         ["sim/core/x.cpp:3: f has 61 lines, more than 60"])

    def test_functions_are_found_in_classes_and_behind_signatures_of_many_lines(self):
        text = ("namespace {\nstruct S {\n    int get() const {\n        return 1;\n    }\n};\n}\n"
                "std::vector<int> make(int a,\n                      int b) {\n"
                "    auto g = [](int c) { return c; };\n    if (a) { b = g(a); }\n    return {a, b};\n}\n"
                "const int table[] = {\n    1,\n    2};\n")
        found = [(function.name, function.line, function.length) for function in functions_of(Source("x.cpp", text))]
        self.assertEqual(found, [("get", 3, 3), ("make", 9, 5)])

    def test_braces_in_comments_and_literals_do_not_count(self):
        text = 'void f() {\n    g("}", \'{\', 1\'000);  // }\n    h(R"x( } )x");\n#define B {\n}\n'
        found = [(function.name, function.length) for function in functions_of(Source("x.cpp", text))]
        self.assertEqual(found, [("f", 5)])


class Format(unittest.TestCase):
    def test_a_file_that_clang_format_would_change_fails(self):
        program, why_not = check_format.find_clang_format()
        if not program:
            self.skipTest(why_not)
        with tempfile.TemporaryDirectory() as root:
            pathlib.Path(root, ".clang-format").write_text("BasedOnStyle: Google\n", encoding="utf-8")
            for name, text in [("bad.cpp", "int   a ;\n"), ("good.cpp", "int a;\n")]:
                pathlib.Path(root, name).write_text(text, encoding="utf-8")
            sources = [Source("bad.cpp", ""), Source("good.cpp", "")]
            self.assertEqual(problems(check_format.check_format(root, sources, program)),
                             ["bad.cpp:1: clang-format -i would write this otherwise"])


class Program(unittest.TestCase):
    def test_it_fails_on_a_tree_with_a_fault_and_passes_one_without(self):
        script = pathlib.Path(__file__).with_name("check_style.py")
        with tempfile.TemporaryDirectory() as root:
            header = pathlib.Path(root, "sim", "core", "a.h")
            header.parent.mkdir(parents=True)
            pathlib.Path(root, "docs").mkdir()
            shutil.copy(script.parents[2] / "docs" / "architecture.md", pathlib.Path(root, "docs"))
            for text, exit_code in [(PRAGMA, 0), (PRAGMA + '#include "app/commands.h"\n', 1)]:
                header.write_text(text, encoding="utf-8")
                result = subprocess.run([sys.executable, str(script), "includes", root], check=False,
                                        capture_output=True)
                self.assertEqual(result.returncode, exit_code)


if __name__ == "__main__":
    unittest.main()

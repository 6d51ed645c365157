"""Each style check must be able to fail: here every one meets the snippet that it is there for."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

import check_examples
import check_fields
import check_flow
import check_format
import check_includes
import check_text
import check_types
import draw_modules
import rules
from sources import Source, functions_of

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import skips

PRAGMA = "#pragma once\n// What it is for.\n"


def problems(faults):
    return [str(fault) for fault in faults]


TABLES = """
| module | may include |
|---|---|
| sim/core | nothing of ours |
| sim/mesh | sim/core |
| sim/dress | sim/core, sim/mesh |
| render/draw | sim/core |
| app, bench, tests | everything |

| package | its headers | owner |
|---|---|---|
| nlohmann-json | `nlohmann/` | `sim/core/json` |
| OSMesa, EGL | `GL/`, `EGL/` | `render/draw/` |
"""
MODULES = rules.Modules(TABLES)


class Includes(unittest.TestCase):
    def directions(self, path, text):
        return problems(check_includes.check_directions([Source(path, text)], MODULES))

    def packages(self, path, name):
        return problems(check_includes.check_packages([Source(path, f"#include <{name}>\n")], MODULES))

    def test_a_module_that_reaches_back_is_named_with_its_line(self):
        self.assertEqual(self.directions("sim/core/math.h", '#pragma once\n#include "sim/mesh/sew.h"\n'),
                         ["sim/core/math.h:2: sim/core may not include sim/mesh"])

    def test_the_simulation_may_not_ask_the_renderer(self):
        self.assertEqual(len(self.directions("sim/dress/dress.cpp", '#include "render/draw/renderer.h"\n')), 1)

    def test_what_the_table_allows_passes(self):
        text = '#include "sim/mesh/sew.h"\n#include "sim/core/math.h"\n#include <vector>\n'
        self.assertEqual(self.directions("sim/mesh/sew.cpp", text), [])
        self.assertEqual(self.directions("app/main.cpp", text), [])

    def test_an_include_that_does_not_start_at_the_root_fails(self):
        self.assertEqual(len(self.directions("sim/mesh/sew.cpp", '#include "sew.h"\n')), 1)

    def test_a_folder_that_is_no_module_fails(self):
        self.assertEqual(self.directions("sim/magic/wand.h", PRAGMA),
                         ["sim/magic/wand.h:1: stands in no module of the table"])

    def test_an_allowance_that_nobody_uses_fails(self):
        sources = [Source("sim/mesh/sew.cpp", '#include "sim/core/math.h"\n'),
                   Source("sim/dress/dress.cpp", '#include "sim/core/math.h"\n#include "sim/mesh/sew.h"\n')]
        self.assertEqual(problems(check_includes.check_allowances(sources, MODULES)),
                         ["docs/modules.md:7: render/draw never includes sim/core"])

    def test_a_package_outside_its_module_fails(self):
        self.assertEqual(len(self.packages("sim/mesh/load.cpp", "nlohmann/json.hpp")), 1)
        self.assertEqual(len(self.packages("app/main.cpp", "GL/osmesa.h")), 1)

    def test_a_package_in_its_module_or_in_a_test_passes(self):
        self.assertEqual(self.packages("sim/core/json.cpp", "nlohmann/json.hpp"), [])
        self.assertEqual(self.packages("tests/sim/mesh/checks.cpp", "nlohmann/json.hpp"), [])

    def test_a_source_includes_its_own_header_before_anything_else(self):
        def faults(text):
            return problems(check_includes.check_own_header([Source("sim/core/a.h", PRAGMA),
                                                             Source("sim/core/a.cpp", text)]))

        self.assertEqual(faults('#include <vector>\n#include "sim/core/a.h"\n'),
                         ['sim/core/a.cpp:1: does not include "sim/core/a.h" first'])
        self.assertEqual(faults("int a;\n"), ['sim/core/a.cpp:1: does not include "sim/core/a.h" first'])
        self.assertEqual(faults('// What a is.\n#include "sim/core/a.h"\n'), [])

    def test_files_that_include_each_other_are_a_circle(self):
        faults = check_includes.check_cycles([Source("sim/core/a.h", '#include "sim/core/b.h"\n'),
                                              Source("sim/core/b.h", '#include "sim/core/a.h"\n')], MODULES)
        self.assertEqual(problems(faults),
                         ["sim/core/a.h:1: a circle: sim/core/a.h -> sim/core/b.h -> sim/core/a.h"])

    def test_modules_that_include_each_other_are_a_circle_even_by_different_files(self):
        faults = check_includes.check_cycles([Source("app/a.h", '#include "bench/c.h"\n'), Source("bench/c.h", ""),
                                              Source("bench/b.h", '#include "app/d.h"\n'), Source("app/d.h", "")],
                                             MODULES)
        self.assertEqual(problems(faults), ["app/a.h:1: a circle: app -> bench -> app"])

    def test_a_table_with_a_circle_fails(self):
        circle = rules.Modules(TABLES.replace("| nothing of ours |", "| sim/mesh |"))
        self.assertEqual(len(problems(check_includes.check_table(circle))), 1)
        self.assertEqual(problems(check_includes.check_table(MODULES)), [])


class Picture(unittest.TestCase):
    PICTURE = "\n".join(draw_modules.draw(MODULES.may_include))

    def faults_of(self, text):
        return problems(draw_modules.check_picture(rules.Modules(TABLES + text)))

    def test_an_arrow_that_follows_from_others_is_left_out(self):
        self.assertIn("sim_dress --> sim_mesh", self.PICTURE)
        self.assertNotIn("sim_dress --> sim_core", self.PICTURE)
        self.assertEqual(self.faults_of("text\n" + self.PICTURE + "\ntext"), [])

    def test_a_picture_with_another_arrow_or_with_one_less_fails(self):
        self.assertEqual(len(self.faults_of(self.PICTURE.replace("sim_mesh --> sim_core", "sim_core --> sim_mesh"))), 2)
        self.assertEqual(len(self.faults_of("no picture")), 1)

    def test_a_picture_in_another_order_or_with_a_line_twice_fails(self):
        lines = self.PICTURE.split("\n")
        self.assertEqual(len(self.faults_of("\n".join(lines[:-3] + [lines[-2], lines[-3], lines[-1]]))), 1)
        self.assertEqual(len(self.faults_of("\n".join(lines[:-1] + lines[-2:]))), 1)

    def test_what_it_writes_into_the_page_passes_and_leaves_the_rest(self):
        old = "text\n" + self.PICTURE.replace("sim_mesh --> sim_core", "sim_core --> sim_mesh") + "\ntext"
        new = draw_modules.with_picture(rules.Modules(TABLES + old))
        self.assertEqual(new, TABLES + "text\n" + self.PICTURE + "\ntext")

    def test_a_module_that_the_architecture_does_not_name_fails(self):
        page = "`sim/core`, `sim/mesh`, `sim/dress`, `app`, `bench`, `tests`"
        self.assertEqual(problems(draw_modules.check_names(MODULES, page)),
                         ["docs/modules.md:7: docs/architecture.md does not name render/draw"])
        self.assertEqual(problems(draw_modules.check_names(MODULES, page + ", `render/draw`")), [])


class Flow(unittest.TestCase):
    MESH = """#pragma once
namespace selvedge {
// curve(Cloth) gives a Surface.
struct Mesh {
    std::vector<Cloth> cloths{};
    Cloth cut() const { return curve(1); }
};
Surface curve(const sim::Cloth& cloth, const Options& options = {});
class Over {
 public:
    const Surface& curve(const Cloth& cloth);
 private:
    Mesh mesh_;
};
}
"""
    PICTURE = """```mermaid
flowchart TD
  file["sim::Cloth"] -->|"curve<br>sim/mesh/a.h"| Surface
  Cloth -->|"Over::curve<br>sim/mesh/a.h"| Surface
  Cloth -->|"Mesh::cloths<br>sim/mesh/a.h"| Mesh
```
"""

    def faults_of(self, text):
        sources = [Source("sim/mesh/a.h", self.MESH), Source("sim/mesh/b.h", PRAGMA)]
        return problems(check_flow.check_flow(sources, text))

    def test_a_picture_of_what_the_headers_declare_passes(self):
        self.assertEqual(self.faults_of(self.PICTURE), [])

    def test_an_arrow_from_or_to_another_type_fails(self):
        self.assertEqual(self.faults_of(self.PICTURE.replace("| Mesh", "| Image")),
                         ["docs/architecture.md:5: no declaration of Mesh::cloths mentions Cloth and Image"])
        self.assertEqual(self.faults_of(self.PICTURE.replace('file["sim::Cloth"]', "Mesh")),
                         ["docs/architecture.md:3: no declaration of curve mentions Mesh and Surface"])

    def test_a_function_that_the_header_does_not_declare_fails(self):
        for header in ("sim/mesh/b.h", "sim/mesh/none.h"):
            picture = self.PICTURE.replace('"Over::curve<br>sim/mesh/a.h"', f'"curve<br>{header}"')
            self.assertEqual(self.faults_of(picture), [f"docs/architecture.md:4: {header} does not declare curve"])
        self.assertEqual(self.faults_of(self.PICTURE.replace("Mesh::cloths", "Over::cloths")),
                         ["docs/architecture.md:5: sim/mesh/a.h does not declare Over::cloths"])

    def test_a_missing_picture_and_a_line_that_is_no_arrow_fail(self):
        self.assertEqual(len(self.faults_of("no picture")), 1)
        self.assertEqual(self.faults_of(self.PICTURE.replace('|"Mesh::cloths<br>sim/mesh/a.h"|', "")),
                         ["docs/architecture.md:5: 'Cloth --> Mesh' is no arrow of the picture"])


class Types(unittest.TestCase):
    def faults_of(self, *texts):
        return problems(check_types.check_types([Source(f"{name}.h", text) for name, text in zip("ab", texts)]))

    def test_a_type_that_two_files_define_in_one_namespace_fails(self):
        text = "namespace selvedge::sim {\nstruct Edge {\n    int a;\n};\n}\n"
        self.assertEqual(self.faults_of(text, "\n" + text), ["b.h:3: selvedge::sim::Edge is defined in a.h too"])
        self.assertEqual(self.faults_of(text, text.replace("struct Edge", "enum class Edge : int")),
                         ["b.h:2: selvedge::sim::Edge is defined in a.h too"])

    def test_one_that_is_declared_or_stands_elsewhere_passes(self):
        text = "namespace selvedge::sim {\nstruct Edge {\n};\n}\n"
        for other in ["namespace selvedge::sim {\nstruct Edge;\nEdge make(struct Edge* e) {\n}\n}\n",
                      text.replace("::sim", "::render"), "namespace selvedge::sim {\nnamespace {\nclass Edge {\n};\n}\n}\n",
                      "namespace selvedge::sim {\nstruct Mesh {\n    struct Edge {\n    };\n};\n}\n"]:
            self.assertEqual(self.faults_of(text, other), [], other)


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

    def paths(self, line, path="sim/core/x.cpp"):
        return problems(check_text.check_paths([Source(path, "void f(std::error_code& why) {\n" + line + "\n}\n")]))

    def test_a_question_about_a_path_that_may_throw_fails(self):
        self.assertEqual(self.paths("if (std::filesystem::exists(path)) {}"),
                         ["sim/core/x.cpp:2: exists() throws: see sim/core/file_path.h"])
        for call in ["fs::absolute(f(a, b))", "fs::is_directory(path)", "fs::temp_directory_path()",
                     "for (auto& e : fs::directory_iterator(path)) {}", "fs::directory_iterator entry(path);"]:
            self.assertEqual(len(self.paths(call)), 1, call)

    def test_one_with_an_error_code_passes(self):
        for call in ["fs::exists(path, why)", "fs::weakly_canonical(f(a, b), why)", "fs::temp_directory_path(why)",
                     "fs::directory_iterator entry(path, why);", "it != fs::directory_iterator()", "fs::path(text)",
                     "std::filesystem::exists(status)"]:
            self.assertEqual(self.paths(call), [], call)
        self.assertEqual(self.paths("fs::exists(path)", "tests/sim/core/x.cpp"), [])


class Lengths(unittest.TestCase):
    def test_a_file_that_is_too_long_fails(self):
        self.assertEqual(len(list(check_text.check_lengths([Source("sim/core/x.cpp", "int a;\n" * 701)]))), 1)
        self.assertEqual(len(list(check_text.check_lengths([Source("sim/core/x.cpp", "int a;\n" * 700)]))), 0)

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


class Fields(unittest.TestCase):
    PARTS = check_fields.Parts(
        "Field<&Seam::first>{} Field<&Seam::second>{} Field<&Panel::name>{} Field<&Panel::layer>{} "
        "Field<&Panel::notches>{} Field<&Notch::edge>{} Field<&Notch::t>{} Field<&SeamSide::edge>{} "
        "fields(const Seam*) fields(const Panel*) fields(const Notch*) fields(const SeamSide*)",
        "struct Panel {\n    std::vector<Notch> notches;\n};\nstruct Pattern {\n    std::vector<Seam> seams;\n};\n")

    def faults_of(self, text, path="sim/mesh/x.cpp"):
        return problems(check_fields.check_fields([Source(path, text)], self.PARTS))

    def test_a_part_that_is_made_without_names_fails_at_its_line(self):
        self.assertEqual(self.faults_of("int a;\nNotch notch{3, 0.5};\n"),
                         ["sim/mesh/x.cpp:2: a Notch without the names of its members"])
        for text in ["f(sim::Seam{a, b});", "panel.notches.push_back({3, 0.5});", "pattern.seams = {{{0, 1}, {1, 2}}};",
                     "pattern.panels[0].notches = {{.edge = 1}, {2, 0.5}};", "std::vector<Notch> notches{{1, 0.5}};",
                     "void f(sim::Panel& own) { own.notches = {{1, 0.5}}; }", "Notch f() {\n    return {1, 0.5};\n}"]:
            self.assertEqual(len(self.faults_of(text)), 1, text)

    def test_a_part_with_names_or_defaults_and_other_types_pass(self):
        for text in ["Notch notch{.edge = 3};", "Notch notch{};", "struct Notch {\n    int edge = 0;\n};", "Seam f() {\n}",
                     "class SELVEDGE_API Seam {\n    int edge = 0;\n};",
                     "SeamSide side{0, 1};", "shape.notches.push_back({3, 0.5});", "std::vector<int> seams{{1}, {2}};",
                     "pattern.seams = {a, b};", "panel.notches = other.notches;", 'f("Notch{1, 2}");']:
            self.assertEqual(self.faults_of(text), [], text)

    def test_tests_may_write_a_seam_as_two_sides_and_nothing_more(self):
        path = "tests/sim/mesh/x.cpp"
        self.assertEqual(self.faults_of("pattern.seams = {{{0, 1}, {1, 3}}, {{p, e}, {q, 0}}};", path), [])
        self.assertEqual(len(self.faults_of("pattern.seams = {{{0, 1}, {1, 3}, false}};", path)), 1)

    def test_members_that_are_copied_one_by_one_fail(self):
        copies = "\n    a.name = b.name;\n    a.layer = b.layer;\n    a.notches = b.notches;\n"
        self.assertEqual(self.faults_of("void f() {" + copies + "}"),
                         ["sim/mesh/x.cpp:2: copies name, layer, notches of a Panel one by one"])
        self.assertEqual(len(self.faults_of("{" + copies.replace("a.", "all[i]->").replace("b.", "f(x).") + "}")), 1)

    def test_two_copies_other_members_and_several_sources_pass(self):
        for text in ["a.name = b.name; a.layer = b.layer;", "a.x = b.x; a.y = b.y; a.z = b.z;",
                     "a.name = b.name; a.layer = c.layer; a.notches = b.notches;",
                     "panel.name = command.name; panel.layer = command.layer; panel.notches = command.notches;"]:
            self.assertEqual(self.faults_of("{" + text + "}"), [], text)


class Examples(unittest.TestCase):
    SOURCE = "int before;\n    // [block]\n    int a;\n      int b;\n    // [/block]\n"
    PAGE = "Text.\n<!-- tests/docs/x.cpp: block -->\n```cpp\nint a;\n  int b;\n```\n"

    def faults_of(self, page, source=SOURCE):
        return problems(check_examples.check_examples([Source("docs/adding-x.md", page)],
                                                      [Source("tests/docs/x.cpp", source)]))

    def test_a_block_that_equals_its_region_passes(self):
        self.assertEqual(self.faults_of(self.PAGE), [])

    def test_a_block_with_another_byte_fails(self):
        self.assertEqual(self.faults_of(self.PAGE.replace("int b", "int  b")),
                         ["docs/adding-x.md:3: differs from the region block of tests/docs/x.cpp"])

    def test_a_block_without_origin_or_with_a_wrong_one_fails(self):
        self.assertEqual(self.faults_of(self.PAGE + "\n```\nint c;\n```\n"),
                         ["docs/adding-x.md:8: no comment above this block names the region that it shows"])
        self.assertIn("docs/adding-x.md:2: tests/docs/x.cpp has no region black",
                      self.faults_of(self.PAGE.replace(": block", ": black")))

    def test_a_region_that_no_page_shows_or_without_end_fails(self):
        self.assertEqual(self.faults_of("No block.\n"), ["tests/docs/x.cpp:2: no page shows the region block"])
        self.assertIn("tests/docs/x.cpp:2: the region block has no end",
                      self.faults_of(self.PAGE, self.SOURCE.replace("[/block]", "[/black]")))


class Format(unittest.TestCase):
    def test_a_file_that_clang_format_would_change_fails(self):
        program, why_not = check_format.find_clang_format()
        if not program:
            skips.skip_test(self.id(), why_not)
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
            table = "| module | may include |\n|---|---|\n| sim/core | nothing of ours |\n| app | everything |\n"
            pathlib.Path(root, "docs", "modules.md").write_text(table, encoding="utf-8")
            for text, exit_code in [(PRAGMA, 0), (PRAGMA + '#include "app/commands.h"\n', 1)]:
                header.write_text(text, encoding="utf-8")
                result = subprocess.run([sys.executable, str(script), "includes", root], check=False,
                                        capture_output=True)
                self.assertEqual(result.returncode, exit_code)


if __name__ == "__main__":
    unittest.main()

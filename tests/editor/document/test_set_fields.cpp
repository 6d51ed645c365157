#include <gtest/gtest.h>

#include "editor/document/command.h"
#include "editor/document/document.h"
#include "editor/document/set_fields.h"
#include "editor/geometry/draft.h"
#include "tests/editor/document/support.h"

namespace selvedge::editor {
namespace {

SetFields fields_of(FieldOwner part, const std::string& panel, int index, const std::string& values) {
    return {.part = part, .panel = panel, .index = index, .values = sim::parse_json(values, "values")};
}

std::string problem_of(sim::Pattern pattern, const SetFields& command) {
    try {
        set_fields(pattern, command);
    } catch (const GeometryError& error) {
        return error.what();
    }
    return "";
}

TEST(SetFields, changes_the_named_fields_and_no_others) {
    sim::Pattern pattern = shipped("tshirt.json").pattern;
    const sim::Pattern before = pattern;
    sim::Panel& panel = pattern.panels[0];
    panel.notches = {{.edge = 1, .t = 0.25}};
    set_fields(pattern, fields_of(FieldOwner::Panel, panel.name, 0, R"({"pieces": 2, "allowance": 0.01})"));
    set_fields(pattern, fields_of(FieldOwner::Edge, panel.name, 1, R"({"allowance_corner": "mirrored"})"));
    set_fields(pattern, fields_of(FieldOwner::Notch, panel.name, 0, R"({"notch_kind": "castle", "count": 3})"));
    set_fields(pattern, fields_of(FieldOwner::Pattern, "", 0, R"({"size": "40", "edge_length": 0.03})"));
    EXPECT_EQ(panel.pieces, 2);
    EXPECT_EQ(panel.edges[1].allowance_corner, sim::AllowanceCorner::Mirrored);
    EXPECT_EQ(panel.notches[0], (sim::Notch{.edge = 1, .t = 0.25, .kind = sim::NotchKind::Castle, .count = 3}));
    EXPECT_EQ(pattern.edge_length, 0.03);
    set_fields(pattern, fields_of(FieldOwner::Panel, panel.name, 0, R"({"allowance": null})"));
    EXPECT_EQ(panel.allowance, before.panels[0].allowance);
    EXPECT_EQ(panel.vertices, before.panels[0].vertices);
}

TEST(SetFields, refuses_unknown_fields_and_values_out_of_range) {
    const sim::Pattern pattern = shipped("tshirt.json").pattern;
    const std::string& name = pattern.panels[0].name;
    EXPECT_EQ(problem_of(pattern, fields_of(FieldOwner::Panel, name, 0, R"({"pieces": 0})")),
              "selvedge.pieces: the value is out of range");
    EXPECT_EQ(problem_of(pattern, fields_of(FieldOwner::Edge, name, 1, R"({"allowance": 0.7})")),
              "edges[1].selvedge.allowance: an allowance is from 0 to 50 cm");
    EXPECT_EQ(problem_of(pattern, fields_of(FieldOwner::Pattern, "", 0, R"({"edge_length": 1})")),
              "edge_length: the value is no edge length of a mesh: 0.5 to 30 cm are");
    EXPECT_EQ(problem_of(pattern, fields_of(FieldOwner::Panel, name, 0, R"({"layer": "x"})")),
              "values.layer: a string where a number should be");
    for (const char* key : {"name", "vertices", "mirror_of", "notches", "internal_lines", "pins", "is_mirrored", "x"}) {
        EXPECT_EQ(problem_of(pattern, fields_of(FieldOwner::Panel, name, 0, "{\"" + std::string(key) + "\": 1}")),
                  "'" + std::string(key) + "' is no property that can be set");
    }
    EXPECT_NE(problem_of(pattern, fields_of(FieldOwner::Edge, name, 99, "{}")), "");
    EXPECT_NE(problem_of(pattern, fields_of(FieldOwner::Notch, "nobody", 0, "{}")), "");
    EXPECT_NE(problem_of(pattern, fields_of(FieldOwner::Seam, "", 999, "{}")), "");
    EXPECT_NE(problem_of(pattern, fields_of(FieldOwner::Panel, name, 0, "[]")), "");
}

TEST(SetFields, gives_all_seams_of_a_sewing_a_topstitch_that_is_undone) {
    sim::PatternDocument source = shipped("tshirt.json");
    source.pattern.seams[0].sewing = source.pattern.seams[1].sewing = "both";
    Document document(source);
    const sim::Pattern before = document.pattern();
    document.run(fields_of(FieldOwner::Seam, "", 1, R"({"topstitch": {"rows": 2, "thread": {"colour": "#102030"}}})"));
    for (const std::size_t seam : {std::size_t(0), std::size_t(1)}) {
        ASSERT_TRUE(document.pattern().seams[seam].topstitch);
        EXPECT_EQ(document.pattern().seams[seam].topstitch->rows, 2);
        EXPECT_EQ(document.pattern().seams[seam].topstitch->thread.colour, "#102030");
    }
    EXPECT_THROW(document.run(fields_of(FieldOwner::Seam, "", 1, R"({"topstitch": {"rows": 10}})")), GeometryError);
    document.undo();
    EXPECT_EQ(document.pattern(), before);
}

TEST(SetFields, gives_an_edge_an_elastic_that_is_undone) {
    const sim::PatternDocument source = shipped("tshirt.json");
    Document document(source);
    const sim::Pattern before = document.pattern();
    const std::string& name = source.pattern.panels[0].name;
    document.run(fields_of(FieldOwner::Edge, name, 1, R"({"elastic": {"share": 0.5}})"));
    EXPECT_EQ(document.pattern().panels[0].edges[1].elastic, (sim::Elastic{.share = 0.5}));
    EXPECT_THROW(document.run(fields_of(FieldOwner::Edge, name, 1, R"({"elastic": {"share": 2}})")), GeometryError);
    document.undo();
    EXPECT_EQ(document.pattern(), before);
}

TEST(SetFields, is_undone_and_written_to_journals) {
    Document document(shipped("tshirt.json"));
    const std::string name = document.pattern().panels[0].name;
    const std::string text = R"({"set_fields":{"part":"panel","panel":")" + name + R"(","values":{"pieces":3}}})";
    const sim::Json json = sim::parse_json(text, "f");
    const Command command = parse_command(sim::JsonView(json, "f"));
    EXPECT_EQ(write_json(to_json(command), -1), text);
    EXPECT_EQ(label_of(command), "Change pieces");
    document.run(command);
    EXPECT_EQ(document.pattern().panels[0].pieces, 3);
    document.undo();
    EXPECT_EQ(document.pattern().panels[0].pieces, 1);
}

}  // namespace
}  // namespace selvedge::editor

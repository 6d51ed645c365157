// Surface designs in garment and fabric files.
#include "sim/pattern/surface_design.h"

#include <gtest/gtest.h>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/pattern_file.h"
#include "tests/sim/pattern/sample.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
namespace {

std::string with_surface(const std::string& surface) {
    return replaced(sample_text(), R"("pattern": {)", R"("selvedge": {"surface": )" + surface + R"(}, "pattern": {)");
}

TEST(SurfaceDesign, comes_back_from_a_file_as_it_was) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "mine.json";
    PatternDocument document = parse_pattern(sample_text(), file.string());
    const std::string picture = (std::filesystem::canonical(file.parent_path()) / "roses.png").string();
    document.pattern.surface = SurfaceDesign{.kind = DesignKind::Colour, .source = "#7A1F2B"};
    document.pattern.panels[0].surface = SurfaceDesign{.kind = DesignKind::Picture,
                                                       .source = picture,
                                                       .size = 0.3,
                                                       .position = Vec2d(0.01, 0.02),
                                                       .rotation = std::numbers::pi / 6,
                                                       .is_repeated = false,
                                                       .ground = "#102030"};
    save_pattern(document, file);
    const PatternDocument again = load_pattern(file);
    EXPECT_EQ(again.pattern.surface, document.pattern.surface);
    ASSERT_TRUE(again.pattern.panels[0].surface);
    EXPECT_EQ(again.pattern.panels[0].surface->source, picture);
    EXPECT_NEAR(again.pattern.panels[0].surface->rotation, std::numbers::pi / 6, 1e-9);
    EXPECT_FALSE(again.pattern.panels[0].surface->is_repeated);
    EXPECT_EQ(write_pattern(again, file), write_pattern(document, file));
    EXPECT_NE(write_pattern(again, file).find("\"file\": \"roses.png\""), std::string::npos);
}

TEST(SurfaceDesign, another_kind_leaves_nothing_of_the_one_before) {
    PatternDocument document = parse_pattern(with_surface(R"({"kind": "colour", "colour": "#7A1F2B"})"), "f.json");
    document.pattern.surface = SurfaceDesign{.kind = DesignKind::Test, .size = 0.1};
    EXPECT_EQ(write_pattern(document).find("#7A1F2B"), std::string::npos);
    document.pattern.surface.reset();
    EXPECT_EQ(write_pattern(document).find("\"surface\""), std::string::npos);
}

TEST(SurfaceDesign, what_is_wrong_is_told_with_its_place) {
    const auto only = [](const std::string& surface) {
        const std::vector<std::string> lines = faults_of(with_surface(surface));
        return lines.size() == 1 ? lines[0] : std::to_string(lines.size()) + " faults";
    };
    EXPECT_EQ(only(R"({})"), "f.json: selvedge.surface: no key 'kind'");
    EXPECT_EQ(only(R"({"kind": "colour"})"), "f.json: selvedge.surface: no key 'colour'");
    EXPECT_EQ(only(R"({"kind": "colour", "colour": "red"})"),
              "f.json: selvedge.surface.colour: 'red' is no colour: #RRGGBB is");
    EXPECT_EQ(only(R"({"kind": "picture"})"), "f.json: selvedge.surface: no key 'file'");
    EXPECT_EQ(only(R"({"kind": "test", "size": 0})"),
              "f.json: selvedge.surface.size: 0 is no size of a repeat: 0.1 to 500 cm are");
    EXPECT_NE(only(R"({"kind": "velvet"})").find("velvet"), std::string::npos);
    EXPECT_TRUE(faults_of(with_surface(R"({"kind": "tartan"})")).empty());
}

TEST(SurfaceDesign, a_fabric_file_may_have_one_in_metres) {
    const TemporaryFolder folder;
    const std::string file = (folder / "print.json").string();
    std::string text(embedded_fabrics().front().text);
    text.replace(text.find('{'), 1, R"({"surface": {"kind": "picture", "file": "roses.png", "size": 0.25},)");
    write_file_atomically(file, text);
    const Fabric fabric = find_fabric(file);
    ASSERT_TRUE(fabric.surface);
    EXPECT_EQ(fabric.surface->size, 0.25);
    EXPECT_EQ(fabric.surface->source, (folder / "roses.png").string());
    text.replace(text.find("picture"), 7, "velvety");
    write_file_atomically(file, text);
    EXPECT_THROW(find_fabric(file), InputError);
}

}  // namespace
}  // namespace selvedge::sim

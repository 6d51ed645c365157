// A T-shirt made in the editor from an empty sheet, by clicks and keys alone, equals the shipped T-shirt.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "render/image/image.h"
#include "sim/core/sha256.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/pattern_file.h"
#include "tests/app/selvedge_program.h"
#include "tests/golden/drape_numbers.h"
#include "tests/golden/golden.h"
#include "tests/support/checkout.h"

namespace selvedge::test {
namespace {

constexpr double kLength = 0.001;  // m: handles are typed to 0.01 mm, the file rounds them to 1/10000 of their edge
constexpr double kArea = 0.0002;   // m2

// Panels and lengths of both sides, in an order that does not depend on which side was clicked first.
struct SewnPair {
    std::vector<std::string> panels;
    std::vector<double> lengths;  // m

    bool operator<(const SewnPair& other) const {
        return panels != other.panels ? panels < other.panels : lengths < other.lengths;
    }
};

std::vector<SewnPair> sewn_pairs(const sim::Pattern& pattern) {
    std::vector<SewnPair> pairs;
    for (const sim::Seam& seam : pattern.seams) {
        SewnPair pair;
        for (const sim::SeamSide& side : {seam.first, seam.second}) {
            const sim::Panel& panel = pattern.panels.at(static_cast<std::size_t>(side.panel));
            pair.panels.push_back(panel.name);
            pair.lengths.push_back(outline_length(panel, panel.edges.at(static_cast<std::size_t>(side.edge))));
        }
        std::sort(pair.panels.begin(), pair.panels.end());
        std::sort(pair.lengths.begin(), pair.lengths.end());
        pairs.push_back(pair);
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

double perimeter(const sim::Panel& panel) {
    double sum = 0;
    for (const sim::OutlineEdge& edge : panel.edges) sum += outline_length(panel, edge);
    return sum;
}

std::map<std::string, sim::Panel> by_name(const sim::Pattern& pattern) {
    std::map<std::string, sim::Panel> panels;
    for (const sim::Panel& panel : pattern.panels) panels[panel.name] = panel;
    return panels;
}

// The sheet and its tools. The 3D view is left out: before they are placed, copies may intersect in front of the body.
render::Image sheet_of(const render::Image& screen) {
    constexpr int kSheetEnd = 498;  // px
    render::Image sheet(kSheetEnd, screen.height_px);
    for (int y = 0; y < sheet.height_px; ++y) {
        for (int x = 0; x < sheet.width_px; ++x) sheet.at(x, y) = screen.at(x, y);
    }
    return sheet;
}

// One process runs this suite, so the script runs only once.
class EditTshirt : public testing::Test {
 protected:
    static void SetUpTestSuite() {
        folder_ = new app::ScratchFolder;
        const std::string script = "'" + source_folder() + "/tests/golden/edit_tshirt.script'";
        played_ = app::run_command("cd '" + folder_->path().string() + "' && '" + program_folder() +
                                   "/selvedge' edit --state state " + "--script " + script);
    }
    static void TearDownTestSuite() {
        delete folder_;
        folder_ = nullptr;
    }

    void SetUp() override { ASSERT_EQ(played_.exit_code, 0) << played_.err; }

    static sim::Pattern made() { return sim::load_pattern(*folder_ / "made.json").pattern; }
    static sim::Pattern shipped_tshirt() {
        return sim::load_pattern(source_folder() + "/patterns/tshirt.json").pattern;
    }

    static app::ScratchFolder* folder_;
    static app::ProgramResult played_;
};

app::ScratchFolder* EditTshirt::folder_ = nullptr;
app::ProgramResult EditTshirt::played_;

TEST_F(EditTshirt, has_the_shipped_panels) {
    const auto ours = by_name(made()), theirs = by_name(shipped_tshirt());
    ASSERT_EQ(ours.size(), theirs.size());
    for (const auto& [name, panel] : theirs) {
        ASSERT_TRUE(ours.contains(name)) << name;
        EXPECT_NEAR(outline_area(ours.at(name)), outline_area(panel), kArea) << name;
        EXPECT_NEAR(perimeter(ours.at(name)), perimeter(panel), kLength) << name;
    }
}

TEST_F(EditTshirt, is_sewn_as_the_shipped_one) {
    const std::vector<SewnPair> ours = sewn_pairs(made()), theirs = sewn_pairs(shipped_tshirt());
    ASSERT_EQ(ours.size(), theirs.size());
    for (std::size_t i = 0; i < ours.size(); ++i) {
        EXPECT_EQ(ours[i].panels, theirs[i].panels);
        for (const std::size_t side : {0U, 1U}) EXPECT_NEAR(ours[i].lengths[side], theirs[i].lengths[side], kLength);
    }
}

TEST_F(EditTshirt, lies_about_the_body_that_it_names_and_is_linked_from_left_to_right) {
    const sim::Pattern pattern = made();
    EXPECT_EQ(pattern.body, "mannequin:sex=female");
    for (const auto& [name, panel] : by_name(pattern)) {
        EXPECT_EQ(!panel.mirror_of.empty(), name.starts_with("right")) << name;
        EXPECT_GT(panel.wrap_radius, 0) << name << " went to no arrangement point";
    }
}

// Panels are placed at arrangement points around the body, while the shipped garment stands flat in front of and behind
// it. So the folds differ, but it settles too, with the same height and the same strain.
TEST_F(EditTshirt, hangs_as_the_shipped_one) {
    const sim::Body body = coarse_mannequin();
    const sim::DressOptions options{.max_level = 2};
    const DrapeNumbers ours = drape_numbers(dress(made(), body, options));
    const DrapeNumbers theirs = drape_numbers(dress(shipped_tshirt(), body, options));
    RecordProperty("compared", "hem " + std::to_string(ours.hem_height) + " " + std::to_string(theirs.hem_height) +
                                   ", p99 " + std::to_string(ours.warp_weft_p99) + " " +
                                   std::to_string(theirs.warp_weft_p99) + ", centres apart " +
                                   std::to_string((ours.centre - theirs.centre).norm()));
    EXPECT_TRUE(ours.settled);
    EXPECT_TRUE(ours.faults.empty());
    EXPECT_NEAR(ours.warp_weft_p99, theirs.warp_weft_p99, 0.01);
    EXPECT_NEAR(ours.hem_height, theirs.hem_height, 0.01);
    EXPECT_LT((ours.centre - theirs.centre).norm(), 0.01);
}

TEST_F(EditTshirt, looks_at_each_stage_as_it_did) {
    const std::filesystem::path letters = "/usr/share/fonts/opentype/inter/Inter-Regular.otf";
    constexpr const char* kDrawn = "a7e791e8f5a0fb02b65663f7fca73e1d1ca9543f772ad480cbd76f4e3fe3f8cc";
    if (!std::filesystem::exists(letters) || sim::sha256_of_file(letters) != kDrawn)
        GTEST_SKIP() << "the pictures have the letters of fonts-inter 4.0~beta7 (Debian 12), which is not installed";
    const auto picture = [](const std::string& name) { return render::read_png(*folder_ / (name + ".png")); };
    for (const std::string name : {"front_half", "unfolded", "placed"}) {
        EXPECT_TRUE(matches_golden(picture(name), "edit_" + name));
    }
    for (const std::string name : {"panels", "twisted", "sewn"}) {
        EXPECT_TRUE(matches_golden(sheet_of(picture(name)), "edit_" + name));
    }
    EXPECT_TRUE(matches_golden_by_blocks(picture("settled"), "edit_settled"));
}

TEST(EditScript, that_expects_another_state_of_the_drape_ends_with_its_line) {
    const app::ScratchFolder folder;
    std::ofstream(folder / "wish.script") << "click widget start.empty\nexpect Settled\n";
    const app::ProgramResult result =
        app::run_command("'" + program_folder() + "/selvedge' edit --state '" + folder / "state" + "' --script '" +
                         folder / "wish.script" + "'");
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("line 2: the drape is not 'Settled'"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace selvedge::test

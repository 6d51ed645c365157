// selvedge match: its output and messages agree with the file that it writes.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "sim/core/file.h"
#include "sim/core/json.h"
#include "sim/pattern/pattern.h"
#include "sim/pattern/pattern_file.h"
#include "sim/tartan/tartan_file.h"
#include "tests/app/selvedge_program.h"
#include "tests/sim/tartan/seamed_panels.h"
#include "tests/support/checkout.h"

namespace selvedge::app {
namespace {

constexpr const char* kPatterns[] = {"poncho.json", "skirt.json", "tshirt.json", "tshirt_thesis.json",
                                     "two_squares.json"};

// A copy of a shipped pattern without any sett matching.
class Copy {
 public:
    explicit Copy(const std::string& name) : path_(folder_ / name) {
        sim::Json json = sim::read_json(source_folder() + "/patterns/" + name);
        json.find("selvedge")->erase("matched_sett");
        for (sim::Json::Member& panel : json.find("pattern")->find("panels")->members()) panel.value.erase("selvedge");
        sim::write_file_atomically(path_, write_json(json));
    }

    const std::string& path() const { return path_; }
    std::string beside(const std::string& name) const { return folder_ / name; }
    ProgramResult match(const std::string& options = "") const {
        return run_selvedge("match '" + path_ + "' " + options);
    }

 private:
    ScratchFolder folder_;
    std::string path_;
};

double figure(const sim::Json& seam, const char* key) {
    return sim::JsonView(seam, "seams.json").at(key).number();
}

TEST(MatchCommand, what_it_reports_is_what_the_colours_of_the_saved_garment_show) {
    for (const char* name : kPatterns) {
        const Copy copy(name);
        const sim::Pattern before = sim::load_pattern(copy.path()).pattern;
        const std::string table = copy.beside("seams.json");
        const ProgramResult result = copy.match("--json '" + table + "'");
        ASSERT_EQ(result.exit_code, 0) << result.err;
        const sim::Pattern after = sim::load_pattern(copy.path()).pattern;
        const sim::Sett sett = sim::find_tartan(after.tartan);
        const sim::Json json = sim::read_json(table);
        const std::vector<sim::Json>& seams = json.find("seams")->elements();
        ASSERT_EQ(seams.size(), after.seams.size());
        for (std::size_t s = 0; s < seams.size(); ++s) {
            EXPECT_EQ(sim::JsonView(seams[s], "").at("name").string(), seam_name(after, after.seams[s]));
            EXPECT_NEAR(figure(seams[s], "before_mm"), 1e3 * seen_mismatch(before, before.seams[s], sett), 0.5) << name;
            EXPECT_NEAR(figure(seams[s], "after_mm"), 1e3 * seen_mismatch(after, after.seams[s], sett), 0.5) << name;
        }
    }
}

TEST(MatchCommand, side_seams_and_shoulders_of_what_ships_meet) {
    const Copy copy("tshirt.json");
    ASSERT_EQ(copy.match().exit_code, 0);
    const sim::Pattern after = sim::load_pattern(copy.path()).pattern;
    const sim::Sett sett = sim::find_tartan(after.tartan);
    for (const char* name : {"front.1+back.7", "front.8+back.0", "front.3+back.5", "front.6+back.2"}) {
        const std::vector<int> found = find_seams(after, name);
        ASSERT_EQ(found.size(), 1U) << name;
        EXPECT_LT(seen_mismatch(after, after.seams[static_cast<std::size_t>(found[0])], sett), 0.2e-3) << name;
    }
}

TEST(MatchCommand, writes_nothing_when_the_file_has_a_newer_format) {
    const Copy copy("skirt.json");
    sim::Json newer = sim::read_json(copy.path());
    newer["selvedge"]["format"] = sim::Json(sim::kGarmentFormat + 1);
    const std::string text = write_json(newer);
    sim::write_file_atomically(copy.path(), text);
    const ProgramResult result = copy.match();
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("written by a newer program"), std::string::npos) << result.err;
    EXPECT_EQ(write_json(sim::read_json(copy.path())), text);
    const ProgramResult other = copy.match("-o '" + copy.beside("other.json") + "'");
    EXPECT_EQ(other.err.rfind("selvedge: " + copy.path() + ": selvedge.format: written by a newer", 0), 0U)
        << other.err;
    EXPECT_FALSE(std::filesystem::exists(copy.beside("other.json")));
    const ProgramResult over = run_selvedge("match " + shipped("skirt.json") + " -o '" + copy.path() + "'");
    EXPECT_EQ(over.exit_code, 2);
    EXPECT_NE(over.err.find("not written over: the garment there was written by a newer"), std::string::npos)
        << over.err;
    EXPECT_EQ(write_json(sim::read_json(copy.path())), text);
    EXPECT_EQ(run_selvedge("check '" + copy.path() + "'").exit_code, 0);
}

TEST(MatchCommand, changes_nothing_in_the_file_but_offsets_and_what_they_are_for) {
    const Copy copy("skirt.json");
    const sim::Json before = sim::read_json(copy.path());
    ASSERT_EQ(copy.match().exit_code, 0);
    sim::Json after = sim::read_json(copy.path());
    const sim::JsonView view(after, "");
    EXPECT_EQ(view.at("selvedge").at("matched_sett").at("tartan").string(), "black_watch");
    EXPECT_EQ(view.at("selvedge").at("matched_sett").at("repeat").numbers(), (std::vector<double>{14.9, 14.9}));
    after.find("selvedge")->erase("matched_sett");
    int moved = 0;
    for (sim::Json::Member& panel : after.find("pattern")->find("panels")->members()) {
        if (sim::Json* own = panel.value.find("selvedge")) {
            moved += own->find("sett_offset") ? 1 : 0;
            panel.value.erase("selvedge");
        }
    }
    EXPECT_EQ(moved, 1);  // the front stays, the back is offset
    EXPECT_EQ(write_json(after), write_json(before));
}

TEST(MatchCommand, a_dry_run_and_another_output_leave_the_garment_as_it_was) {
    const Copy copy("skirt.json");
    const std::string before = content_of(copy.path());
    const ProgramResult dry = copy.match("--dry-run");
    EXPECT_EQ(dry.exit_code, 0);
    EXPECT_NE(dry.out.find("front.1+back.2"), std::string::npos) << dry.out;
    const std::string other = copy.beside("other.json");
    EXPECT_EQ(copy.match("-o '" + other + "'").exit_code, 0);
    EXPECT_EQ(content_of(copy.path()), before);
    EXPECT_NE(content_of(other), before);
    EXPECT_EQ(run_selvedge("check --strict '" + other + "'").exit_code, 0);
}

TEST(MatchCommand, matching_twice_writes_the_same_bytes) {
    for (const char* name : kPatterns) {
        const Copy copy(name);
        ASSERT_EQ(copy.match().exit_code, 0);
        const std::string once = content_of(copy.path());
        ASSERT_EQ(copy.match().exit_code, 0);
        EXPECT_EQ(content_of(copy.path()), once) << name;
    }
}

TEST(MatchCommand, another_tartan_and_size_are_matched_and_written_down) {
    const Copy copy("tshirt.json");
    ASSERT_EQ(copy.match("--tartan 'K10 R30 G5 W7' --sett-size 11.7").exit_code, 0);
    const sim::Pattern after = sim::load_pattern(copy.path()).pattern;
    ASSERT_TRUE(after.matched_sett);
    EXPECT_EQ(after.matched_sett->tartan, "K10 R30 G5 W7");
    EXPECT_NEAR(after.matched_sett->repeat.x(), 0.117, 1e-9);
    EXPECT_EQ(after.tartan, "K10 R30 G5 W7");  // offsets are valid for one tartan only
}

TEST(MatchCommand, seams_go_by_their_own_names_too) {
    const Copy copy("skirt.json");
    sim::PatternDocument document = sim::load_pattern(copy.path());
    document.pattern.seams[1].name = "right side";
    save_pattern(document, copy.path());
    const ProgramResult result = copy.match("--seams 'right side,back.2+front.1'");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("\nright side "), std::string::npos) << result.out;
    EXPECT_EQ(sim::load_pattern(copy.path()).pattern.seams[1].name, "right side");
    EXPECT_EQ(run_selvedge("match --seams front.1+back.2 '" + copy.path() + "'").exit_code, 0);
}

TEST(MatchCommand, a_wrong_word_gets_one_line) {
    const Copy copy("skirt.json");
    const std::string before = content_of(copy.path());
    const auto expect_line = [&](const std::string& options, const std::string& said) {
        const ProgramResult result = copy.match(options);
        EXPECT_EQ(result.exit_code, 2) << options;
        EXPECT_EQ(count_lines(result.err), 1) << result.err;
        EXPECT_NE(result.err.find(said), std::string::npos) << result.err;
    };
    expect_line("--seams hem", "no seam 'hem'; known are front.1+back.2, front.3+back.0");
    expect_line("--centre sleeve", "no panel 'sleeve'; known are front, back");
    expect_line("--centre front --tartan buchanan", "no mirror");
    expect_line("--sett-size 0", "--sett-size");
    expect_line("--sett-size nan", "--sett-size");
    expect_line("--tartan plaid", "none is called 'plaid'");
    expect_line("--json '" + copy.path() + "'", "already");
    expect_line("--tartan plaid", "selvedge: --tartan: none is");
    expect_line("--tartan 'B/24 W4 Q/2'", "selvedge: --tartan: stripe 3 'Q/2': no colour 'Q'");
    expect_line("-o /nowhere/skirt.json", "cannot write");
    expect_line("-o '" + copy.beside("skirt.txt") + "'", ".json");
    EXPECT_EQ(content_of(copy.path()), before);
}

TEST(MatchCommand, a_wrong_tartan_of_the_garment_is_named_with_its_place) {
    const Copy copy("skirt.json");
    sim::Json json = sim::read_json(copy.path());
    json["selvedge"]["tartan"] = sim::Json("plaid");
    sim::write_file_atomically(copy.path(), write_json(json));
    for (const ProgramResult& result : {copy.match(""), run_selvedge("dress '" + copy.path() + "'")}) {
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_EQ(result.err.rfind("selvedge: " + copy.path() + ": selvedge.tartan: none is called 'plaid'", 0), 0U)
            << result.err;
    }
}

TEST(MatchCommand, refuses_a_garment_without_a_tartan_unless_one_is_given) {
    const Copy copy("two_squares.json");
    sim::Json json = sim::read_json(copy.path());
    json.find("selvedge")->erase("tartan");
    json.find("selvedge")->erase("sett_size");
    sim::write_file_atomically(copy.path(), write_json(json));
    const ProgramResult refused = copy.match();
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_EQ(refused.err, "selvedge: " + copy.path() + ": selvedge.tartan: names no tartan to match: --tartan\n");
    EXPECT_EQ(copy.match("--tartan gordon").exit_code, 0);
}

TEST(MatchCommand, dressing_says_when_another_tartan_is_drawn_than_was_matched) {
    const Copy copy("two_squares.json");
    ASSERT_EQ(copy.match("--tartan gordon").exit_code, 0);
    const std::string quick = "dress '" + copy.path() + "' --seconds 0.01 --edge-length 12 --max-level 0 --render '" +
                              copy.beside("out.png") + "' --size 32x32 ";
    EXPECT_NE(run_selvedge(quick + "--tartan buchanan").out.find("matched for gordon"), std::string::npos);
    EXPECT_EQ(run_selvedge(quick).out.find("matched for"), std::string::npos);
}

}  // namespace
}  // namespace selvedge::app

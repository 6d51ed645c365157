#include "sim/tartan/tartan_file.h"

#include <gtest/gtest.h>

#include "sim/core/error.h"

namespace selvedge {
namespace {

std::string fault_of(const std::string& json) {
    try {
        parse_tartan(json, "mine.json");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(TartanFile, every_shipped_tartan_parses_to_a_repeat_that_a_weaver_would_know) {
    const std::vector<std::string> names = shipped_tartans();
    ASSERT_GE(names.size(), 3U);
    for (const std::string& name : names) {
        const Sett sett = find_tartan(name);
        EXPECT_FALSE(sett.name.empty()) << name;
        EXPECT_GE(sett.stripes.size(), 2U) << name;
        EXPECT_GT(sett.thread_spacing, 0.0003) << name;
        EXPECT_LT(sett.thread_spacing, 0.0005) << name;
        EXPECT_GT(repeat_size(sett), name == "shepherd_check" ? 0.004 : 0.07) << name;
        EXPECT_LT(repeat_size(sett), 0.20) << name;
    }
}

TEST(TartanFile, black_watch_has_its_416_threads_and_its_own_blue) {
    const Sett sett = find_tartan("Black Watch");
    EXPECT_EQ(thread_count(sett), 416);
    EXPECT_EQ(sett.stripes.front().colour, (Rgb8{0x20, 0x20, 0x60}));
    EXPECT_TRUE(sett.is_mirrored);
}

TEST(TartanFile, a_name_may_have_blanks_hyphens_and_capitals) {
    EXPECT_EQ(find_tartan("royal-stewart").name, "Royal Stewart");
    EXPECT_EQ(find_tartan("ROYAL STEWART").name, "Royal Stewart");
    EXPECT_EQ(find_tartan(kDefaultTartan).stripes.size(), 22U);
}

TEST(TartanFile, a_threadcount_stands_for_itself) {
    EXPECT_EQ(thread_count(find_tartan("K/4 R10 W/2")), 26);
}

TEST(TartanFile, an_unknown_name_is_answered_with_those_there_are) {
    try {
        find_tartan("blakc watch");
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), "tartan");
        EXPECT_NE(error.problem().find("'blakc watch'"), std::string::npos);
        EXPECT_NE(error.problem().find("black_watch"), std::string::npos);
    }
}

TEST(TartanFile, faults_name_the_file_and_the_place) {
    EXPECT_NE(fault_of(R"({"name": "x", "threadcount": "Q4"})").find("mine.json: threadcount: stripe 1"),
              std::string::npos);
    EXPECT_NE(fault_of(R"({"name": "x", "threadcount": "K4", "palette": {"K": "red"}})").find("mine.json: palette.K"),
              std::string::npos);
    EXPECT_NE(fault_of(R"({"name": "x"})").find("threadcount"), std::string::npos);
    EXPECT_NE(fault_of(R"({"name": "x", "threadcount": "K4", "repeat_cm": -1})").find("repeat_cm"), std::string::npos);
}

}  // namespace
}  // namespace selvedge

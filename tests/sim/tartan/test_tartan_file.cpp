#include "sim/tartan/tartan_file.h"

#include <gtest/gtest.h>

#include <set>

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
        EXPECT_GE(sett.stripes.size() + sett.weft_stripes.size(), 2U) << name;
        EXPECT_GT(sett.thread_spacing, 0.0003) << name;
        EXPECT_LT(sett.thread_spacing, 0.0005) << name;
        const bool is_tartan = name != "shepherd_check" && name != "gingham" && name != "indigo_denim";
        EXPECT_GT(repeat_size(sett), is_tartan ? 0.07 : 0.001) << name;
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

TEST(TartanFile, twelve_or_more_name_their_entry_in_the_register_and_no_two_the_same) {
    std::set<int> numbers;
    for (const std::string& name : shipped_tartans()) {
        const Sett sett = find_tartan(name);
        EXPECT_EQ(sett.register_number > 0, !sett.register_name.empty()) << name;
        if (sett.register_number == 0) continue;
        EXPECT_TRUE(numbers.insert(sett.register_number).second) << name;
    }
    EXPECT_GE(numbers.size(), 12U);
    EXPECT_EQ(find_tartan("black_watch").register_number, 277);
}

TEST(TartanFile, may_say_a_weft_and_a_weave) {
    const Sett sett = parse_tartan(
        R"({"name": "x", "threadcount": "B4", "weft": "W/2 B/1", "weave": "denim", "repeat_cm": 1,
            "register": {"name": "X", "number": 7}})",
        "x.json");
    EXPECT_EQ(sett.weave, Weave::Twill31);
    EXPECT_TRUE(sett.is_weft_mirrored);
    EXPECT_EQ(sett.register_number, 7);
    EXPECT_DOUBLE_EQ(repeat_size(sett), 0.01);
    EXPECT_DOUBLE_EQ(weft_repeat_size(sett), 0.0075);
}

TEST(TartanFile, faults_of_weft_weave_and_register_name_their_place) {
    const auto fault = [](const std::string& more) {
        return fault_of(R"({"name": "x", "threadcount": "K4 weft: W4", )" + more + "}");
    };
    EXPECT_NE(fault(R"("weft": "R4")").find("mine.json: weft: the weft is given twice"), std::string::npos);
    EXPECT_NE(fault(R"("weft": "Q4")").find("mine.json: weft: stripe 1 'Q4'"), std::string::npos);
    EXPECT_NE(fault(R"("weave": "satin")").find("mine.json: weave: "), std::string::npos);
    EXPECT_NE(fault(R"("register": {"name": "X"})").find("register"), std::string::npos);
    EXPECT_NE(fault(R"("register": {"name": "X", "number": 0})").find("register.number"), std::string::npos);
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

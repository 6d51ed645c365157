#include <gtest/gtest.h>
#include <set>

#include "sim/core/error.h"
#include "sim/tartan/sett.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge::sim {
namespace {

std::string written(const Sett& sett) {
    std::string text;
    for (const SettStripe& stripe : sett.stripes) text += stripe.code + std::to_string(stripe.threads) + " ";
    return text;
}

std::string fault_of(const std::string& threadcount) {
    try {
        parse_threadcount(threadcount);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Threadcount, pivots_are_laid_once_and_the_stripes_between_are_mirrored) {
    const Sett sett = parse_threadcount("B/24 W4 K8 R/2");
    EXPECT_EQ(written(sett), "B24 W4 K8 R2 K8 W4 ");
    EXPECT_TRUE(sett.is_mirrored);
    EXPECT_EQ(thread_count(sett), 24 + 2 * (4 + 8) + 2);
}

TEST(Threadcount, without_slashes_the_stripes_repeat_as_written) {
    const Sett sett = parse_threadcount("B18 G46 K6");
    EXPECT_EQ(written(sett), "B18 G46 K6 ");
    EXPECT_FALSE(sett.is_mirrored);
}

TEST(Threadcount, may_be_written_without_blanks_with_commas_dots_and_small_letters) {
    const std::string expected = written(parse_threadcount("B/24 W4 DB/8"));
    EXPECT_EQ(written(parse_threadcount("B/24W4DB/8")), expected);
    EXPECT_EQ(written(parse_threadcount("b/24, w4, db/8")), expected);
    EXPECT_EQ(written(parse_threadcount("... B24 W4 ...")), "B24 W4 ");
}

TEST(Threadcount, two_pivots_alone_mirror_to_themselves) {
    EXPECT_EQ(written(parse_threadcount("K/4 R/6")), "K4 R6 ");
    EXPECT_EQ(written(parse_threadcount("R/6")), "R6 ");
}

TEST(Threadcount, the_tartans_own_palette_goes_before_the_usual_letters) {
    const Rgb8 own{1, 2, 3};
    EXPECT_EQ(parse_threadcount("K4 R4", {{"K", own}}).stripes[0].colour, own);
    EXPECT_EQ(parse_threadcount("K=#010203; K4 R4").stripes[0].colour, own);
    EXPECT_EQ(parse_threadcount("K4 R4").stripes[0].colour, standard_palette().at("K"));
}

TEST(Threadcount, colours_run_thread_by_thread_over_one_repeat) {
    const std::vector<Rgb8> colours = thread_colours(parse_threadcount("K/2 W1 R/1"));
    const Rgb8 k = standard_palette().at("K"), w = standard_palette().at("W"), r = standard_palette().at("R");
    EXPECT_EQ(colours, (std::vector<Rgb8>{k, k, w, r, w}));
}

TEST(Threadcount, what_is_wrong_is_named_with_its_stripe) {
    EXPECT_EQ(fault_of("B4 Q5").substr(0, 36), "threadcount: stripe 2 'Q5': no colou");
    EXPECT_NE(fault_of("B4 W/4").find("stripe 1 'B4': one pivot alone"), std::string::npos);
    EXPECT_NE(fault_of("B/4 W4").find("stripe 2 'W4': one pivot alone"), std::string::npos);
    EXPECT_NE(fault_of("B/4 W/4 R/4").find("stripe 2 'W/4': a pivot within"), std::string::npos);
    EXPECT_NE(fault_of("B4 W").find("stripe 2 'W'"), std::string::npos);
    EXPECT_NE(fault_of("B4 12").find("stripe 2 '12'"), std::string::npos);
    EXPECT_NE(fault_of("B0").find("from 1 to"), std::string::npos);
    EXPECT_NE(fault_of("B99999999999").find("stripe 1"), std::string::npos);
    EXPECT_NE(fault_of("B-4").find("stripe 1"), std::string::npos);
    EXPECT_NE(fault_of("B/3000 W2000 B/4").find("more than"), std::string::npos);
    EXPECT_NE(fault_of("B=#12345 B4").find("hexadecimal"), std::string::npos);
    EXPECT_NE(fault_of("B=#12345G B4").find("hexadecimal"), std::string::npos);
    EXPECT_NE(fault_of("S=#A090601 S4").find("hexadecimal"), std::string::npos) << "a digit too many";
    EXPECT_NE(fault_of("").find("no stripes"), std::string::npos);
    EXPECT_NE(fault_of("K=#000000").find("no stripes"), std::string::npos);
}

// As the Scottish Register of Tartans gives them: a threadcount, and a "pallet" of colours with names.
TEST(Threadcount, may_come_with_the_pallet_of_the_register) {
    const Sett expected =
        parse_threadcount("B=#2C2C80 W=#FFFFFF R=#C80000 K=#101010 G=#006818 B/24 W4 B24 R2 K24 G24 W/2");
    const std::string stripes = "B/24 W4 B24 R2 K24 G24 W/2";
    for (const std::string pallet :
         {"B=2C2C80BLUE;W=FFFFFFWHITE;R=C80000RED;K=101010BLACK;G=006818GREEN;",
          "B=2C2C80ROYAL BLUE;W=FFFFFFWILSON WHITE;R=C80000RED;K=101010BLACK;G=006818MID GREEN 2;",
          "B=2C2C80;BLUE;W=FFFFFF;R=C80000;DARK RED;K=101010;G=006818;GREEN;",
          "B=2C2C80 W=FFFFFF R=C80000RED K=101010 G=006818",
          "B=2C2C80 Blue\nW=#FFFFFF Snow white\nR=c80000\nK=101010\nG=006818 Green\n"}) {
        EXPECT_EQ(parse_threadcount(pallet + " " + stripes), expected) << pallet;
        EXPECT_EQ(parse_threadcount("Pallet:\n" + pallet + "\nThreadcount:\n" + stripes), expected) << pallet;
        EXPECT_EQ(parse_threadcount("Threadcount: " + stripes + "\nPallet: " + pallet), expected) << pallet;
        EXPECT_EQ(parse_threadcount("Threadcount\nB/24W4B24R2K24G24W/2\nPallet\n\"" + pallet + "\""), expected)
            << pallet;
    }
    EXPECT_EQ(written(parse_threadcount("LT=E8CCB8LIGHT BROWN;LT4 K2")), "LT4 K2 ");
    EXPECT_EQ(parse_threadcount("LT=E8CCB8LIGHT BROWN;LT4").stripes[0].colour, (Rgb8{0xE8, 0xCC, 0xB8}));
}

TEST(Threadcount, may_stand_under_its_heading_with_the_usual_colours) {
    const Sett expected = parse_threadcount("B/24 W4 B24 R2 K24 G24 W/2");
    for (const char* heading : {"Threadcount:", "Thread count:", "threadcount", "Sett:", "Warp:"})
        EXPECT_EQ(parse_threadcount(std::string(heading) + " B/24 W4 B24 R2 K24 G24 W/2."), expected) << heading;
}

// What the Register says below its threadcounts.
TEST(Threadcount, may_be_followed_by_how_its_pivots_count) {
    const Sett expected = parse_threadcount("B/24 W4 R/2");
    const std::string full = "\nThreadcount given over a half sett with full count at the pivots.\n";
    EXPECT_EQ(parse_threadcount("Threadcount: B/24 W4 R/2" + full + "Pallet: "), expected);
    EXPECT_EQ(parse_threadcount("B24 W4 R2" + full), expected) << "without slashes";
    EXPECT_EQ(parse_threadcount("B/12 W4 R/1\nThreadcount given over a half sett with half count at the pivots."),
              expected);
    EXPECT_EQ(parse_threadcount("B24 W4 R2\nThreadcount given over the full sett."), parse_threadcount("B24 W4 R2"));
}

// As the Scottish Tartans Authority writes a weft of its own.
TEST(Threadcount, may_have_its_weft_after_a_dot) {
    const Sett expected = parse_threadcount("B24 W4 B24 R2 weft: K24 G24 W2");
    for (const char* text : {"B24 W4 B24 R2 . K24 G24 W2", "B24W4B24R2.K24G24W2", "B24 W4 B24 R2. K24 G24 W2.",
                             "...B24 W4 B24 R2... . ...K24 G24 W2...", "...B24 W4 B24 R2... ...K24 G24 W2...",
                             "\xE2\x80\xA6"
                             "B24 W4 B24 R2\xE2\x80\xA6 . K24 G24 W2"})
        EXPECT_EQ(parse_threadcount(text), expected) << text;
    EXPECT_TRUE(parse_threadcount("B/24 W4 R/2 . K/8 W/2").is_weft_mirrored);
    EXPECT_NE(fault_of("B24 . W4 . K2").find("given twice"), std::string::npos);
    EXPECT_NE(fault_of("B24 W4 ... K2").find("stripe 4 'K2': '...' stands before"), std::string::npos);
}

TEST(Sett, a_wished_repeat_keeps_the_proportions_and_the_threads_near_their_spacing) {
    const Sett sett = with_repeat_size(parse_threadcount("K/4 A4 G16 DB16 W/2"), 0.12);
    EXPECT_DOUBLE_EQ(repeat_size(sett), 0.12);
    EXPECT_EQ(thread_count(sett), 78 * 4);
    EXPECT_EQ(sett.stripes[2].threads, 16 * 4);
    EXPECT_NEAR(sett.thread_spacing, 0.00036, 0.00004);
}

TEST(Threadcount, may_say_a_weft_with_pivots_of_its_own_and_the_weave) {
    const Sett sett = parse_threadcount("K20 R6 Weft: K/8 W4 G/2 weave: Denim");
    EXPECT_EQ(written(sett), "K20 R6 ");
    EXPECT_FALSE(sett.is_mirrored);
    EXPECT_TRUE(sett.is_weft_mirrored);
    EXPECT_EQ(weft_thread_count(sett), 8 + 2 * 4 + 2);
    EXPECT_EQ(weft_thread_colours(sett).size(), 18U);
    EXPECT_EQ(sett.weave, Weave::Twill31);
    EXPECT_EQ(parse_threadcount("K/4 R/6weft:W1weave:plain").weave, Weave::Plain);
    EXPECT_EQ(parse_threadcount("K4 weave: twill").weave, Weave::Twill22);
}

TEST(Threadcount, a_weft_that_is_not_said_repeats_the_warp) {
    const Sett sett = parse_threadcount("K/4 R/6");
    EXPECT_TRUE(sett.weft_stripes.empty());
    EXPECT_EQ(weft_thread_colours(sett), thread_colours(sett));
    EXPECT_EQ(sett.weave, Weave::Twill22);
}

TEST(Threadcount, what_is_wrong_with_weft_and_weave_is_named) {
    EXPECT_NE(fault_of("K4 weft:").find("no stripes of the weft"), std::string::npos);
    EXPECT_NE(fault_of("weft: K4").find("no stripes"), std::string::npos);
    EXPECT_NE(fault_of("K4 weft: W/4 R4").find("stripe 4 'R4': one pivot alone"), std::string::npos);
    EXPECT_NE(fault_of("K4 weft: R4 weft: W4").find("given twice"), std::string::npos);
    EXPECT_NE(fault_of("K4 weave: satin").find("plain, twill, denim"), std::string::npos);
    EXPECT_NE(fault_of("K4 weave:").find("plain, twill, denim"), std::string::npos);
    EXPECT_NE(fault_of("K4 weave: plain twill").find("plain, twill, denim"), std::string::npos);
    EXPECT_NE(fault_of("K4 warp: R4").find("end in a colon"), std::string::npos);
    EXPECT_NE(fault_of("K4 weft: R4096 W1").find("more than"), std::string::npos);
}

TEST(Sett, a_wished_repeat_is_the_warps_and_the_weft_keeps_its_proportion) {
    const Sett sett = with_repeat_size(parse_threadcount("K20 R20 weft: W7 G3"), 0.12);
    EXPECT_DOUBLE_EQ(repeat_size(sett), 0.12);
    EXPECT_DOUBLE_EQ(weft_repeat_size(sett), 0.03);
    EXPECT_NEAR(sett.thread_spacing, 0.00036, 0.00004);
}

TEST(Sett, no_repeat_outgrows_the_most_threads_because_of_its_weft) {
    const Sett sett = with_repeat_size(parse_threadcount("K2 R2 weft: W4000"), 1);
    EXPECT_EQ(thread_count(sett), 4);
    EXPECT_EQ(weft_thread_count(sett), 4000);
}

TEST(Sett, a_tiny_repeat_keeps_every_thread_and_makes_them_finer) {
    const Sett sett = with_repeat_size(parse_threadcount("K10 R10"), 0.002);
    EXPECT_EQ(thread_count(sett), 20);
    EXPECT_DOUBLE_EQ(sett.thread_spacing, 0.0001);
}

std::string fault_in_file(const std::string& json) {
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

TEST(TartanFile, may_have_threadcount_and_palette_as_the_registers_write_them) {
    const Sett expected = parse_tartan(
        R"({"name": "a", "threadcount": "B/24 LT/4 . K2 B6", "palette": {"B": "#2C2C80", "LT": "#E8CCB8"}})", "f");
    EXPECT_EQ(
        parse_tartan(R"({"name": "a", "threadcount": "B=2C2C80BLUE;LT=E8CCB8LIGHT BROWN; B/24 LT/4 . K2 B6"})", "f"),
        expected);
    EXPECT_EQ(
        parse_tartan(
            R"({"name": "a", "threadcount": "B/24 LT/4 . K2 B6", "palette": "B=2C2C80BLUE;LT=E8CCB8LIGHT BROWN;"})",
            "f"),
        expected);
    EXPECT_EQ(parse_tartan(R"({"name": "a", "threadcount": "B/24 LT/4 . K2 B6",
                               "palette": {"B": "2C2C80BLUE", "LT": "E8CCB8"}})",
                           "f"),
              expected);
}

TEST(TartanFile, faults_of_weft_weave_and_register_name_their_place) {
    const auto fault = [](const std::string& more) {
        return fault_in_file(R"({"name": "x", "threadcount": "K4 weft: W4", )" + more + "}");
    };
    EXPECT_NE(fault(R"("weft": "R4")").find("mine.json: weft: the weft is given twice"), std::string::npos);
    EXPECT_NE(fault(R"("weft": "Q4")").find("mine.json: weft: stripe 1 'Q4'"), std::string::npos);
    EXPECT_NE(fault(R"("weave": "satin")").find("mine.json: weave: "), std::string::npos);
    EXPECT_NE(fault(R"("register": {"name": "X"})").find("register"), std::string::npos);
    EXPECT_NE(fault(R"("register": {"name": "X", "number": 0})").find("register.number"), std::string::npos);
}

TEST(TartanFile, faults_name_the_file_and_the_place) {
    EXPECT_NE(fault_in_file(R"({"name": "x", "threadcount": "Q4"})").find("mine.json: threadcount: stripe 1"),
              std::string::npos);
    EXPECT_NE(
        fault_in_file(R"({"name": "x", "threadcount": "K4", "palette": {"K": "red"}})").find("mine.json: palette.K"),
        std::string::npos);
    EXPECT_NE(fault_in_file(R"({"name": "x"})").find("threadcount"), std::string::npos);
    EXPECT_NE(fault_in_file(R"({"name": "x", "threadcount": "K4", "repeat_cm": -1})").find("repeat_cm"),
              std::string::npos);
}

}  // namespace

}  // namespace selvedge::sim

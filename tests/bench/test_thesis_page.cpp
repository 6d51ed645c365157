// The captions of the thesis against the measured tables, and the HTML page of all items.
#include <gtest/gtest.h>
#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include "bench/thesis/captions.h"
#include "bench/thesis/page.h"
#include "bench/thesis/thesis.h"
#include "tests/bench/support.h"
#include "tests/support/checkout.h"

namespace selvedge::bench {
namespace {

constexpr auto kTable = CaptionKind::Table;
constexpr auto kFigure = CaptionKind::Figure;
constexpr auto kListing = CaptionKind::Listing;

const Caption& caption_named(std::string_view name) {
    const auto found = std::ranges::find_if(thesis_captions(), [&](const Caption& c) { return short_name(c) == name; });
    EXPECT_NE(found, thesis_captions().end()) << name;
    return *found;
}

// The thesis' own lists of tables, figures and listings, from chapter 3 on.
TEST(Captions, are_those_of_the_thesis_and_each_once) {
    struct Count {
        CaptionKind kind;
        const char* chapter;
        int count;
    };
    for (const Count& wanted :
         {Count{kTable, "3.", 14}, Count{kTable, "4.", 1}, Count{kTable, "5.", 4}, Count{kTable, "6.", 4},
          Count{kFigure, "3.", 30}, Count{kFigure, "4.", 13}, Count{kFigure, "5.", 11}, Count{kFigure, "6.", 10},
          Count{kListing, "3.", 13}, Count{kListing, "5.", 1}}) {
        std::set<std::string_view> numbers;
        for (const Caption& caption : thesis_captions()) {
            if (caption.kind != wanted.kind || !caption.number.starts_with(wanted.chapter)) continue;
            EXPECT_TRUE(numbers.insert(caption.number).second) << caption.number;
        }
        EXPECT_EQ(numbers.size(), static_cast<std::size_t>(wanted.count)) << wanted.chapter;
        for (int i = 1; i <= wanted.count; ++i)
            EXPECT_TRUE(numbers.contains(wanted.chapter + std::to_string(i))) << wanted.chapter << i;
    }
    EXPECT_EQ(thesis_captions().size(), 101U);
}

TEST(Captions, of_tables_name_columns_with_units) {
    for (const Caption& caption : thesis_captions()) {
        EXPECT_EQ(caption.kind == kTable, !caption.columns.empty()) << short_name(caption);
        EXPECT_FALSE(caption.subject.empty()) << short_name(caption);
    }
}

TEST(Captions, a_column_that_lacks_its_unit_is_missing) {
    const Caption& caption = caption_named("T3.2");
    Table table{.name = "3.2", .title = "", .columns = {"configuration", "clear, us", "configure, ms"}};
    EXPECT_EQ(missing_columns(caption, table), (std::vector<std::string>{"configure, us"}));
    table.columns[2] = "Selvedge: configure, us";
    EXPECT_TRUE(missing_columns(caption, table).empty());
}

TEST(Captions, of_one_number_do_not_take_the_items_of_another) {
    EXPECT_TRUE(is_of(caption_named("T3.1"), "3.1"));
    EXPECT_FALSE(is_of(caption_named("T3.1"), "3.14"));
    EXPECT_TRUE(is_of(caption_named("T6.2"), "6.2-distance"));
    EXPECT_TRUE(is_of(caption_named("L3.1"), "listing-3.1"));
    EXPECT_FALSE(is_of(caption_named("T3.1"), "listing-3.1"));
    EXPECT_FALSE(is_of(caption_named("L3.1"), "3.1"));
}

// A figure that only explains is drawn; a listing has its place in the project.
TEST(Captions, none_is_missing_and_every_figure_has_an_experiment) {
    const ThesisPage page;
    for (const Caption& caption : thesis_captions()) {
        if (short_name(caption) == "F4.2") continue;  // the application adds it: it needs the editor
        const ItemState state = state_of(caption, page);
        EXPECT_NE(state, ItemState::Missing) << short_name(caption);
        if (caption.kind == kFigure) {
            EXPECT_EQ(state, ItemState::NotRun) << short_name(caption);
        }
    }
}

// Every table that has an experiment, run at small size, has the columns and units that its caption asks for.
TEST(Thesis, every_table_has_the_columns_and_units_that_its_caption_names) {
    ThesisOptions quick{.is_quick = true};
    quick.tshirt = source_folder() + "/patterns/tshirt_thesis.json";
    quick.dress = source_folder() + "/patterns/dress.json";
    std::set<std::string> checked;
    for (const Experiment& experiment : thesis_experiments()) {
        const bool has_caption = std::ranges::any_of(experiment.tables, [](const std::string& name) {
            return std::ranges::any_of(thesis_captions(),
                                       [&](const Caption& c) { return c.kind == kTable && c.number == name; });
        });
        if (!has_caption) continue;
        for (const Table& table : experiment.measure(quick).tables) {
            for (const Caption& caption : thesis_captions()) {
                if (caption.kind != kTable || caption.number != table.name) continue;
                checked.insert(table.name);
                for (const std::string& column : missing_columns(caption, table))
                    ADD_FAILURE() << "table " << table.name << " has no column \"" << column << "\"";
                EXPECT_FALSE(table.rows.empty()) << table.name;
            }
        }
    }
    for (int i = 1; i <= 14; ++i) EXPECT_TRUE(checked.contains("3." + std::to_string(i))) << i;
    for (const char* name : {"4.1", "5.1", "5.2", "5.3", "5.4", "6.1", "6.2", "6.3", "6.4"})
        EXPECT_TRUE(checked.contains(name)) << name;
}

// The part of the page that shows an item.
std::string section_of(const std::string& html, const std::string& name) {
    const std::size_t from = html.find("<section id=\"" + name + "\">");
    if (from == std::string::npos) return {};
    return html.substr(from, html.find("</section>", from) - from);
}

TEST(ThesisPage, has_a_place_for_every_caption_and_says_of_each_that_is_not_shown_why) {
    const ThesisPage page;
    const std::string html = to_html(page);
    for (const Caption& caption : thesis_captions()) {
        const std::string name = short_name(caption), section = section_of(html, name);
        ASSERT_FALSE(section.empty()) << name;
        EXPECT_NE(html.find("href=\"#" + name + "\""), std::string::npos) << name;
        switch (state_of(caption, page)) {
            case ItemState::Shown:
                ADD_FAILURE() << name << " cannot be shown: nothing was measured";
                break;
            case ItemState::Explained:
                EXPECT_NE(section.find("In the project: "), std::string::npos) << name;
                break;
            case ItemState::NotRun:
                EXPECT_NE(section.find("Not part of this run: selvedge bench thesis"), std::string::npos) << name;
                break;
            case ItemState::Missing:
                EXPECT_NE(section.find("Missing: "), std::string::npos) << name;
        }
    }
    EXPECT_EQ(occurrences(html, "<section id="), thesis_captions().size());
}

TEST(ThesisPage, shows_tables_drawings_and_pictures_under_their_captions_only) {
    ThesisPage page;
    Table table{.name = "3.2", .title = "A <title>", .note = "n", .columns = {"a, us", "b"}};
    table.add_row({Cell(1.5, 1), "x & y"});
    page.tables = {table};
    page.drawings = {{.name = "6.4", .title = "shapes", .svg = "<svg></svg>"}};
    page.pictures = {{.name = "3.16", .file = "figure-3.16-level.png", .moment = "level"}};
    const std::string html = to_html(page);
    const std::string shown = section_of(html, "T3.2");
    EXPECT_NE(shown.find("A &lt;title&gt;"), std::string::npos);
    EXPECT_NE(shown.find("x &amp; y"), std::string::npos);
    EXPECT_NE(shown.find("a, \u00B5s"), std::string::npos);
    EXPECT_NE(section_of(html, "F6.4").find("<svg></svg>"), std::string::npos);
    EXPECT_NE(section_of(html, "F3.16").find("src=\"figure-3.16-level.png\""), std::string::npos);
    EXPECT_EQ(section_of(html, "F3.2").find("A &lt;title&gt;"), std::string::npos);
    page.drawings = {{.name = "3.2", .title = "edges", .svg = "<svg></svg>"}};
    EXPECT_NE(section_of(to_html(page), "F3.2").find("In the project: "), std::string::npos) << "beside the drawing";
    EXPECT_EQ(state_of(caption_named("T3.2"), page), ItemState::Shown);
    EXPECT_EQ(html.find("http://", html.find("<body>")), std::string::npos) << "nothing is loaded from elsewhere";
    EXPECT_EQ(html.find("https://"), std::string::npos);
}

TEST(ThesisPage, says_whether_a_trend_agrees) {
    ThesisPage page;
    page.trends = {{.item = "T3.5", .reported = "r.", .measured = "m.", .agrees = true},
                   {.item = "T3.6", .reported = "r.", .measured = "m.", .agrees = false}};
    const std::string html = to_html(page);
    EXPECT_NE(section_of(html, "T3.5").find("<b>Agrees.</b>"), std::string::npos);
    EXPECT_NE(section_of(html, "T3.6").find("<b>Differs.</b>"), std::string::npos);
    EXPECT_NE(html.find("1 of 2 trends agree"), std::string::npos);
}

TEST(ThesisPage, every_trend_belongs_to_a_caption) {
    const ThesisOptions quick{.is_quick = true};
    for (const auto& measure : {measure_traversal, measure_memory, measure_uniform_refinement, measure_edge_pair,
                                list_curve_weights, draw_curve_shapes, draw_soft_cap, measure_point_search}) {
        for (const Trend& trend : measure(quick).trends) {
            caption_named(trend.item);
            EXPECT_FALSE(trend.measured.empty()) << trend.item;
            EXPECT_FALSE(trend.reported.empty()) << trend.item;
        }
    }
}

}  // namespace
}  // namespace selvedge::bench

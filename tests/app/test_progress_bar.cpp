#include "app/progress_bar.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>

namespace selvedge::app {
namespace {

// The text that a task's progress reports write to the stream.
std::string shown(const ProgressBarOptions& options, const std::function<void(const sim::Progress&)>& task) {
    char* text = nullptr;
    std::size_t size = 0;
    std::FILE* stream = open_memstream(&text, &size);
    {
        ProgressBar bar(options, stream);
        task(bar.progress());
    }
    std::fclose(stream);
    std::string result(text, size);
    std::free(text);
    return result;
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

void sew_and_drape(const sim::Progress& progress) {
    sim::report(progress, "sewing", 0.5);
    sim::report(progress, "sewing", 1.0);
    sim::report(progress, "draping", 0.25);
    sim::report(progress, "draping", 0.75);
}

TEST(ProgressBar, shows_phase_bar_percent_and_time) {
    const std::string line = progress_line("draping", 0.5, 4.24, {.width = 42});
    EXPECT_EQ(line, "draping      [#####-----]   50 %    4.2 s");
}

TEST(ProgressBar, fits_the_width_whatever_the_phase_and_fraction) {
    for (int width = 40; width <= 200; width += 7)
        for (const double fraction : {0.0, 0.333, 0.999, 1.0})
            EXPECT_LT(progress_line("a phase with a very long name", fraction, 1234.5, {.width = width}).size(),
                      static_cast<std::size_t>(width));
}

TEST(ProgressBar, reaches_100_percent_only_at_the_end) {
    EXPECT_NE(progress_line("draping", 0.9999, 1, {}).find(" 99 %"), std::string::npos);
    EXPECT_NE(progress_line("draping", 1.0, 1, {}).find("100 %"), std::string::npos);
}

TEST(ProgressBar, writes_one_line_per_phase_and_no_escapes_where_there_is_no_terminal) {
    const std::string text = shown({.is_terminal = false}, sew_and_drape);
    EXPECT_EQ(count(text, "\n"), 2U);
    EXPECT_EQ(count(text, "sewing"), 1U);
    EXPECT_EQ(count(text, "draping"), 1U);
    EXPECT_EQ(count(text, "\x1b"), 0U);
    EXPECT_EQ(count(text, "\r"), 0U);
}

TEST(ProgressBar, redraws_one_line_on_a_terminal_and_leaves_it_clean) {
    const std::string text = shown({.is_terminal = true}, sew_and_drape);
    EXPECT_EQ(count(text, "\n"), 2U);
    EXPECT_GE(count(text, "\r\x1b[K"), 4U);
    EXPECT_EQ(text.back(), '\n');
    EXPECT_EQ(count(text, "\x1b[32m"), 0U);
}

TEST(ProgressBar, colours_only_when_asked) {
    EXPECT_GT(count(shown({.is_terminal = true, .has_colour = true}, sew_and_drape), "\x1b[32m"), 0U);
}

TEST(ProgressBar, says_nothing_when_quiet) {
    EXPECT_EQ(shown({.is_quiet = true, .is_terminal = true}, sew_and_drape), "");
}

TEST(ProgressBar, takes_a_fraction_that_is_no_number_for_the_beginning) {
    const std::string text = shown({.is_terminal = true}, [](const sim::Progress& progress) {
        sim::report(progress, "draping", std::numeric_limits<double>::quiet_NaN());
        sim::report(progress, "draping", 1e9);
    });
    EXPECT_EQ(count(text, "nan"), 0U);
    EXPECT_EQ(count(text, "100 %"), 1U);
}

}  // namespace
}  // namespace selvedge::app

#pragma once
// The windows of the menu Help: the first steps, the keys, the manual. None is modal; Escape closes them.
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace selvedge::editor {

struct AppState;

struct HelpWindows {
    std::optional<std::size_t> tour_step{};  // which of the first steps is shown; none: the tour is closed
    bool has_keys = false;
    bool has_manual = false;
    std::string wanted{};     // in the manual: chapters that have these words
    std::size_t chapter = 0;  // of the manual, that is shown
};

void show_help(AppState& state);

inline constexpr std::size_t kTourSteps = 5;

// A part of the manual between two headings.
struct ManualBlock {
    enum class Kind { Paragraph, Item, Row, Code };
    Kind kind = Kind::Paragraph;
    std::vector<std::string> cells{};  // of a row; else one text
};
struct ManualChapter {
    std::string title;
    std::vector<ManualBlock> blocks{};
};

// Of Markdown: headings, paragraphs, lists, tables and code. Marks of emphasis and links are left out.
std::vector<ManualChapter> chapters_of(const std::string& markdown);

}  // namespace selvedge::editor

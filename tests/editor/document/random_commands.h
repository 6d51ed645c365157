#pragma once
// Random commands for monkey tests: most are plausible, many are not possible.
#include <random>
#include <string>

#include "editor/document/command.h"

namespace selvedge::editor {

class RandomCommands {
 public:
    explicit RandomCommands(unsigned seed) : random_(seed) {}

    Command next(const sim::Pattern& pattern);

    // A random index, 0 .. count - 1.
    int pick(std::size_t count);
    double between(double least, double most);

 private:
    std::string some_panel(const sim::Pattern& pattern);
    Command on_pattern(const sim::Pattern& pattern, int kind);
    Command on_panel(const sim::Pattern& pattern, int kind);
    Command on_outline(const sim::Pattern& pattern, int kind);
    Command on_seams(const sim::Pattern& pattern, int kind);
    PartRef some_vertex(const sim::Pattern& pattern);
    PartRef some_edge(const sim::Pattern& pattern);
    PlaneMap some_map();
    Vec2d some_shift(double most);

    std::mt19937 random_;
};

}  // namespace selvedge::editor

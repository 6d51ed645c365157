#pragma once
// Commands as a monkey with a mouse would make them: mostly sensible, often impossible.
#include <random>
#include <string>

#include "editor/document/command.h"

namespace selvedge {

class RandomCommands {
 public:
    explicit RandomCommands(unsigned seed) : random_(seed) {}

    Command next(const Pattern& pattern);

    // 0 .. count - 1
    int pick(std::size_t count);
    double between(double least, double most);

 private:
    std::string some_panel(const Pattern& pattern);
    Command on_pattern(const Pattern& pattern, int kind);
    Command on_panel(const Pattern& pattern, int kind);
    Command on_outline(const Pattern& pattern, int kind);
    Command on_seams(const Pattern& pattern, int kind);
    PartRef some_vertex(const Pattern& pattern);
    PartRef some_edge(const Pattern& pattern);
    PlaneMap some_map();
    Vec2d some_shift(double most);

    std::mt19937 random_;
};

}  // namespace selvedge

#pragma once
// How far a long task has come, told to whoever asked: a bar in the terminal, a status line in the editor, nobody.
#include <functional>
#include <string_view>

namespace selvedge {

// phase: a few words ("sewing", "draping"); fraction: 0..1 of that phase.
using Progress = std::function<void(std::string_view phase, double fraction)>;

inline void report(const Progress& progress, std::string_view phase, double fraction) {
    if (progress) progress(phase, fraction);
}

}  // namespace selvedge

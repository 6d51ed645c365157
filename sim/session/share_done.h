#pragma once
// How much of a dressing is done, for a bar that grows evenly enough.
#include <algorithm>
#include <array>
#include <string_view>

namespace selvedge::sim {

struct DressingPhase {
    std::string_view name;
    double begin;  // shares of the whole
    double end;
};
// The last two follow only if the arms were lowered.
inline constexpr std::array<DressingPhase, 4> kDressingPhases{
    {{"sewing", 0, 0.3}, {"draping", 0.3, 0.8}, {"moving", 0.8, 0.9}, {"settling", 0.9, 1}}};

// 0 to 1, from what dress() tells a Progress; 0 for a phase that is none of these.
inline double share_done(std::string_view phase, double fraction) {
    for (const DressingPhase& one : kDressingPhases)
        if (one.name == phase) return one.begin + (one.end - one.begin) * std::clamp(fraction, 0.0, 1.0);
    return 0;
}

}  // namespace selvedge::sim

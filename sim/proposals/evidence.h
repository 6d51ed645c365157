#pragma once
// What speaks for and against a seam, as the logarithm of odds and in words.
#include <algorithm>
#include <initializer_list>
#include <string>

#include "sim/proposals/panel_role.h"

namespace selvedge::sim {

struct Evidence {
    double odds = 0;  // natural logarithm
    std::string reason;
    bool is_dart = false;     // both sides are the legs of a dart
    bool is_possible = true;  // false: whatever the odds are, it is no seam
};

inline void add(Evidence& evidence, double odds, const std::string& reason = {}) {
    evidence.odds += odds;
    if (!reason.empty()) evidence.reason += (evidence.reason.empty() ? "" : "; ") + reason;
}

inline bool is_one_of(GarmentPart part, std::initializer_list<GarmentPart> parts) {
    return std::ranges::find(parts, part) != parts.end();
}

inline bool are_parts(GarmentPart a, GarmentPart b, GarmentPart one, GarmentPart other) {
    return (a == one && b == other) || (a == other && b == one);
}

}  // namespace selvedge::sim

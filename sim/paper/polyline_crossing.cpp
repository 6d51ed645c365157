#include "sim/paper/polyline_crossing.h"

#include <algorithm>
#include <cmath>

namespace selvedge::sim {

std::optional<PolylineCrossing> find_crossing(const std::vector<Vec2d>& a, const std::vector<Vec2d>& b) {
    for (std::size_t j = 0; j + 1 < b.size(); ++j) {
        for (std::size_t k = a.size() - 1; k-- > 0;) {
            const Vec2d d = a[k + 1] - a[k], e = b[j + 1] - b[j], off = b[j] - a[k];
            const double area = cross2(d, e);
            if (std::abs(area) < 1e-18) continue;
            const double s = cross2(off, e) / area, t = cross2(off, d) / area;
            if (s >= -1e-9 && s <= 1 + 1e-9 && t >= -1e-9 && t <= 1 + 1e-9)
                return PolylineCrossing{k, j, a[k] + std::clamp(s, 0.0, 1.0) * d};
        }
    }
    return std::nullopt;
}

std::vector<Vec2d> part_before(const std::vector<Vec2d>& a, const PolylineCrossing& at) {
    std::vector<Vec2d> part(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(at.before) + 1);
    part.push_back(at.place);
    return part;
}

std::vector<Vec2d> part_after(const std::vector<Vec2d>& b, const PolylineCrossing& at) {
    std::vector<Vec2d> part{at.place};
    part.insert(part.end(), b.begin() + static_cast<std::ptrdiff_t>(at.after) + 1, b.end());
    return part;
}

}  // namespace selvedge::sim

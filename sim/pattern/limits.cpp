#include "sim/pattern/limits.h"

#include <algorithm>
#include <cmath>

#include "sim/pattern/fault.h"

namespace selvedge::sim {
namespace {

bool is_near(double value) {
    return std::abs(value) <= kMaxCoordinate;  // false for NaN
}

bool is_near(const Vec2d& point) {
    return is_near(point.x()) && is_near(point.y());
}

bool is_near(const Vec3d& point) {
    return is_near(point.x()) && is_near(point.y()) && is_near(point.z());
}

}  // namespace

std::string layer_problem() {
    const std::string most = std::to_string(kHighestLayer);
    return "a layer is a whole number from -" + most + " to " + most;
}

std::vector<LimitFault> limit_faults(const Panel& panel) {
    std::vector<LimitFault> faults;
    const auto require = [&](bool is_within, const char* place, const std::string& problem) {
        if (!is_within) faults.push_back({place, problem});
    };
    const std::string far = "further than 100 m";
    require(is_near(panel.translation), "translation", far);
    require(panel.rotation.allFinite(), "rotation", "not finite");
    require(std::abs(panel.layer) <= kHighestLayer, "selvedge.layer", layer_problem());
    require(std::isfinite(panel.grain_angle), "selvedge.grainline", "not finite");
    require(is_near(panel.sett_offset), "selvedge.sett_offset", far);
    require(is_near(panel.wrap_radius), "selvedge.wrap_radius", far);
    require(!panel.wrap_cone || is_near(panel.wrap_cone->apex), "selvedge.wrap_cone.apex", far);
    require(!panel.sheet_position || is_near(*panel.sheet_position), "selvedge.sheet_position", far);
    const auto are_near = [](const std::vector<Vec2d>& points) {
        return std::ranges::all_of(points, [](const Vec2d& point) { return is_near(point); });
    };
    require(std::ranges::all_of(panel.internal_lines, [&](const InternalLine& line) { return are_near(line.points); }),
            "selvedge.internal_lines", far);
    require(are_near(panel.drill_points), "selvedge.drill_points", far);
    return faults;
}

}  // namespace selvedge::sim

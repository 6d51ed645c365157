#include "sim/pattern/pattern.h"

#include <algorithm>
#include <cmath>

namespace selvedge::sim {
Vec3d Panel::place(const Vec2d& u) const {
    const double side = is_mirrored ? -1 : 1;  // the right side faces side * z
    Vec3d local(side * u.x(), u.y(), 0);
    if (wrap_radius > 0) {
        const double angle = u.x() / wrap_radius;
        local.x() = side * wrap_radius * std::sin(angle);
        local.z() = side * wrap_radius * (std::cos(angle) - 1);
    }
    if (wrap_cone) {
        const Vec2d from_apex = u - wrap_cone->apex;
        const double reach = from_apex.norm();
        const double way = wrap_cone->sine < 0 ? 1 : -1, sine = std::abs(wrap_cone->sine);
        const double angle = std::atan2(from_apex.x(), way * from_apex.y()) / sine;
        const double cosine = std::sqrt(std::max(0.0, 1 - sine * sine));
        local.x() = side * (wrap_cone->apex.x() + reach * sine * std::sin(angle));
        local.y() = wrap_cone->apex.y() + way * reach * cosine;
        local.z() = side * reach * sine * std::cos(angle);
    }
    return rotation * local + translation;
}

bool is_body_file(std::string_view body) {
    return !body.empty() && body != "mannequin" && !body.starts_with("mannequin:");
}

const Panel& panel_of(const Pattern& pattern, const SeamSide& side) {
    return pattern.panels[static_cast<std::size_t>(side.panel)];
}

namespace {

std::string side_name(const Pattern& pattern, const SeamSide& side) {
    return panel_of(pattern, side).name + "." + std::to_string(side.edge);
}

std::string name_of_edges(const Pattern& pattern, const SeamSide& first, const SeamSide& second) {
    return side_name(pattern, first) + "+" + side_name(pattern, second);
}

const std::string& label_of(const Pattern& pattern, const SeamSide& side) {
    return panel_of(pattern, side).edges[static_cast<std::size_t>(side.edge)].label;
}

}  // namespace

std::string seam_name(const Pattern& pattern, const Seam& seam) {
    return seam.name.empty() ? name_of_edges(pattern, seam.first, seam.second) : seam.name;
}

std::vector<int> find_seams(const Pattern& pattern, std::string_view name) {
    std::vector<int> found;
    if (name.empty()) return found;
    for (std::size_t i = 0; i < pattern.seams.size(); ++i) {
        const Seam& seam = pattern.seams[i];
        if (name == seam.name || name == name_of_edges(pattern, seam.first, seam.second) ||
            name == name_of_edges(pattern, seam.second, seam.first) || name == label_of(pattern, seam.first) ||
            name == label_of(pattern, seam.second)) {
            found.push_back(static_cast<int>(i));
        }
    }
    return found;
}

std::string free_sewing_name(const Pattern& pattern) {
    const auto is_taken = [&](const std::string& name) {
        return std::any_of(pattern.seams.begin(), pattern.seams.end(),
                           [&](const Seam& seam) { return seam.sewing == name; });
    };
    for (int i = 1;; ++i) {
        std::string name = "sewing " + std::to_string(i);
        if (!is_taken(name)) return name;
    }
}

}  // namespace selvedge::sim

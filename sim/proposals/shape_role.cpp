#include "sim/proposals/shape_role.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

// Whether the side of the outline above a height comes out again after it went in, as an armhole does below the
// shoulder, and a crotch does not.
bool comes_out_again(const Panel& panel, double from, bool is_right) {
    constexpr int kSteps = 40;      // along each edge, and up
    constexpr double kOut = 0.012;  // m
    const Eigen::AlignedBox2d box = outline_box(panel, 1e-3);
    std::array<double, kSteps> reach{};  // of the side, outward, per level
    reach.fill(-1e9);
    for (const OutlineEdge& edge : panel.edges) {
        for (int i = 0; i <= 4 * kSteps; ++i) {
            const Vec2d p = outline_point(panel, edge, i / (4.0 * kSteps));
            const double share = (p.y() - from) / (box.max().y() - from);
            if (share < 0) continue;
            double& level = reach[std::min<std::size_t>(kSteps - 1, static_cast<std::size_t>(share * kSteps))];
            level = std::max(level, is_right ? p.x() : -p.x());
        }
    }
    double least = 1e9;
    for (const double x : reach) {
        if (x < -1e8) continue;
        least = std::min(least, x);
        if (x > least + kOut) return true;
    }
    return false;
}

// Whether the outline turns by much at a vertex, as at a crotch and not at a hip.
bool is_corner(const Panel& panel, std::size_t vertex) {
    constexpr double kNear = 0.05;  // of an edge
    constexpr double kLeast = 0.6;  // rad
    Vec2d in = Vec2d::Zero(), out = Vec2d::Zero();
    for (const OutlineEdge& edge : panel.edges) {
        if (static_cast<std::size_t>(edge.end) == vertex)
            in = outline_point(panel, edge, 1) - outline_point(panel, edge, 1 - kNear);
        if (static_cast<std::size_t>(edge.start) == vertex)
            out = outline_point(panel, edge, kNear) - outline_point(panel, edge, 0);
    }
    return std::abs(std::atan2(cross2(in, out), in.dot(out))) > kLeast;
}

// The outermost vertices on the left and on the right; of equal ones, the lowest index.
std::array<std::size_t, 2> outermost(const Panel& panel) {
    std::array<std::size_t, 2> found{0, 0};
    for (std::size_t i = 0; i < panel.vertices.size(); ++i) {
        if (panel.vertices[i].x() < panel.vertices[found[0]].x()) found[0] = i;
        if (panel.vertices[i].x() > panel.vertices[found[1]].x()) found[1] = i;
    }
    return found;
}

// Both underarms are corners at about one height, and the cap above them narrows to its top in the middle.
bool looks_like_sleeve(const Panel& panel) {
    constexpr double kLevel = 0.12, kOffMiddle = 0.2;      // of the height, and of the width
    constexpr double kLeastWidth = 0.2, kMostWidth = 0.7;  // m
    const Eigen::AlignedBox2d box = outline_box(panel, 1e-3);
    const std::array<std::size_t, 2> out = outermost(panel);
    const Vec2d left = panel.vertices[out[0]], right = panel.vertices[out[1]];
    const double width = box.sizes().x(), height = box.sizes().y();
    if (width < kLeastWidth || width > kMostWidth) return false;
    if (std::abs(left.y() - right.y()) > kLevel * height || !is_corner(panel, out[0]) || !is_corner(panel, out[1]))
        return false;
    const double share = ((left.y() + right.y()) / 2 - box.min().y()) / height;
    if (share < 0.2 || share > 0.92) return false;
    if (comes_out_again(panel, left.y(), false) || comes_out_again(panel, right.y(), true)) return false;
    const auto top = std::ranges::max_element(panel.vertices, {}, [](const Vec2d& v) { return v.y(); });
    return std::abs(top->x() - box.center().x()) < kOffMiddle * width;
}

// Whether the outline goes up from an underarm to the tip of a shoulder, on to the neck, and down round it to the
// middle.
bool has_shoulder_above(const Panel& panel, std::size_t underarm, bool is_right) {
    constexpr double kLeastArmhole = 0.08, kLeastRise = -0.005, kLeastLength = 0.02;  // m: straps are level
    constexpr double kMostLength = 0.25, kLeastNeck = 0.03;                           // m, along x
    constexpr double kLeastDepth = 0.005;                                             // m, of the neck
    constexpr double kSteep = 0.7;         // inward over up, of an armhole; the cap of a sleeve is flatter
    constexpr double kDeepestNeck = 0.45;  // of the height
    const Eigen::AlignedBox2d box = outline_box(panel, 1e-3);
    const std::size_t count = panel.edges.size();
    const auto found = std::ranges::find(panel.edges, static_cast<int>(underarm), &OutlineEdge::start);
    if (found == panel.edges.end()) return false;
    // Outlines run counter-clockwise: up on the right.
    std::size_t edge = static_cast<std::size_t>(found - panel.edges.begin());
    double lowest = 0;  // m, of the outline before the corner
    const auto next_corner = [&] {
        lowest = box.max().y();
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t before = is_right ? edge : (edge + count - 1) % count;
            for (const double t : {0.25, 0.5, 0.75})
                lowest = std::min(lowest, outline_point(panel, panel.edges[before], t).y());
            edge = (edge + (is_right ? 1 : count - 1)) % count;
            const auto vertex = static_cast<std::size_t>(panel.edges[edge].start);
            if (is_corner(panel, vertex)) return panel.vertices[vertex];
        }
        return panel.vertices[underarm];
    };
    const Vec2d from = panel.vertices[underarm], tip = next_corner(), neck = next_corner(), middle = next_corner();
    const double way = is_right ? -1 : 1;  // towards the middle
    const double length = way * (neck.x() - tip.x()), drop = neck.y() - std::min(lowest, middle.y());
    const double up = tip.y() - from.y(), in = way * (tip.x() - from.x());
    return up > kLeastArmhole && in < kSteep * up && neck.y() - tip.y() > kLeastRise && length > kLeastLength &&
           length < kMostLength && way * (middle.x() - neck.x()) > kLeastNeck && drop > kLeastDepth &&
           drop < kDeepestNeck * box.sizes().y();
}

// Where a bodice has its armholes: on neither, the left, the right side, or on both.
struct Armholes {
    bool is_left = false, is_right = false;
};
Armholes armholes_of(const Panel& panel) {
    constexpr double kLowest = 0.3, kHighest = 0.9;  // of the height, of an underarm
    constexpr double kLeastHeight = 0.3;             // m
    const Eigen::AlignedBox2d box = outline_box(panel, 1e-3);
    if (box.sizes().y() < kLeastHeight) return {};
    const auto is_underarm = [&](std::size_t vertex, bool is_right) {
        const double y = panel.vertices[vertex].y(), share = (y - box.min().y()) / box.sizes().y();
        return share > kLowest && share < kHighest && is_corner(panel, vertex) &&
               (comes_out_again(panel, y, is_right) || has_shoulder_above(panel, vertex, is_right));
    };
    // The hem may reach out as far as the underarm.
    constexpr double kNear = 0.01;  // m, from the outermost place
    const auto has_armhole = [&](bool is_right) {
        for (std::size_t v = 0; v < panel.vertices.size(); ++v) {
            const double x = panel.vertices[v].x(), in = is_right ? box.max().x() - x : x - box.min().x();
            if (in < kNear && is_underarm(v, is_right)) return true;
        }
        return false;
    };
    return {has_armhole(false), has_armhole(true)};
}

// From the highest point down to the outline in the middle of the body, m.
double neck_depth(const Panel& panel, const Armholes& armholes) {
    constexpr double kNear = 0.02;  // m
    const Eigen::AlignedBox2d box = outline_box(panel, 1e-3);
    const double middle = armholes.is_left && armholes.is_right ? box.center().x()
                          : armholes.is_left                    ? box.max().x()
                                                                : box.min().x();
    double high = box.min().y();
    for (const OutlineEdge& edge : panel.edges) {
        for (const Vec2d& p : outline_polyline(panel, edge, 1e-3)) {
            if (std::abs(p.x() - middle) < kNear) high = std::max(high, p.y());
        }
    }
    return box.max().y() - high;
}

// Halves the panels at the middle between the least and the greatest value: the greater ones have the first face.
void set_faces(std::vector<PanelRole>& roles, GarmentPart part, const std::vector<double>& values, Face greater,
               Face less) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t p = 0; p < roles.size(); ++p) {
        if (roles[p].part != part) continue;
        low = std::min(low, values[p]);
        high = std::max(high, values[p]);
    }
    constexpr double kAlike = 1e-4;
    for (std::size_t p = 0; p < roles.size(); ++p) {
        if (roles[p].part == part && high - low > kAlike) roles[p].face = values[p] > (low + high) / 2 ? greater : less;
    }
}

}  // namespace

bool looks_like_bodice(const Panel& panel) {
    const Armholes armholes = armholes_of(panel);
    return armholes.is_left || armholes.is_right;
}

bool looks_like_leg(const Panel& panel) {
    constexpr double kSlender = 1.3;  // height over width
    constexpr double kHook = 0.03;    // m, by which the crotch stands out above
    const Eigen::AlignedBox2d box = outline_box(panel, 1e-3);
    const double height = box.sizes().y(), width = box.sizes().x();
    if (!(height > kSlender * width)) return false;
    // The waist slopes up to the middle of the back.
    constexpr double kSlope = 0.1;  // m
    const double low = box.min().y(), top = box.max().y() - std::min(kSlope, 0.25 * height);
    std::array<double, 2> at_top{box.max().x(), box.min().x()};
    std::array<std::size_t, 2> outmost{0, 0};  // the outermost vertex on the left and on the right
    std::array<double, 2> reach{box.max().x(), box.min().x()};
    for (std::size_t i = 0; i < panel.vertices.size(); ++i) {
        const Vec2d& v = panel.vertices[i];
        if (v.y() > top) at_top = {std::min(at_top[0], v.x()), std::max(at_top[1], v.x())};
        if (v.x() < reach[0]) reach[0] = v.x(), outmost[0] = i;
        if (v.x() > reach[1]) reach[1] = v.x(), outmost[1] = i;
    }
    // A slanted pocket takes a corner off the other side: the crotch stands out further.
    const std::array<double, 2> out{at_top[0] - reach[0], reach[1] - at_top[1]};
    const std::size_t side = out[0] > out[1] ? 0 : 1;
    const double level = panel.vertices[outmost[side]].y(), share = (level - low) / height;
    return out[side] > kHook && out[side] > 1.5 * out[1 - side] && share > 0.35 && share < 0.85 &&
           is_corner(panel, outmost[side]) && !comes_out_again(panel, level, side == 1);
}

bool looks_like_whole_leg(const Panel& panel) {
    constexpr double kLevel = 0.12, kLowest = 0.5, kHighest = 0.92;  // of the height
    constexpr double kSlender = 1.3;                                 // height over width
    const Eigen::AlignedBox2d box = outline_box(panel, 1e-3);
    const double height = box.sizes().y();
    const std::array<std::size_t, 2> out = outermost(panel);
    const double left = panel.vertices[out[0]].y(), right = panel.vertices[out[1]].y();
    const double share = ((left + right) / 2 - box.min().y()) / height;
    return height > kSlender * box.sizes().x() && std::abs(left - right) < kLevel * height && share > kLowest &&
           share < kHighest && is_corner(panel, out[0]) && is_corner(panel, out[1]) &&
           !comes_out_again(panel, left, false) && !comes_out_again(panel, right, true);
}

std::vector<PanelRole> roles_by_shape(const Pattern& pattern, GarmentPart told) {
    std::vector<PanelRole> roles(pattern.panels.size());
    std::vector<double> depths(roles.size(), 0), widths(roles.size(), 0);
    for (std::size_t p = 0; p < roles.size(); ++p) {
        const Panel& panel = pattern.panels[p];
        const Armholes armholes = armholes_of(panel);
        widths[p] = outline_box(panel, 1e-3).sizes().x();
        if (armholes.is_left || armholes.is_right) {
            roles[p].part = GarmentPart::Torso;
            depths[p] = neck_depth(panel, armholes);
        } else if (looks_like_leg(panel)) {
            roles[p].part = GarmentPart::Leg;
        } else if (looks_like_sleeve(panel)) {
            roles[p].part = GarmentPart::Sleeve;
        }
    }
    // With sleeves, what looks like a leg is the half of a bodice whose armhole is shallow; alone, it is no trousers.
    const auto count = [&](GarmentPart part) {
        return std::ranges::count(roles, part, [](const PanelRole& role) { return role.part; });
    };
    const GarmentPart no_leg = count(GarmentPart::Sleeve) > 0 ? GarmentPart::Torso : GarmentPart::Unknown;
    const bool is_upper = count(GarmentPart::Sleeve) + count(GarmentPart::Torso) > 0 || count(GarmentPart::Leg) < 2;
    for (PanelRole& role : roles) {
        if (role.part == GarmentPart::Leg && is_upper) role.part = no_leg;
    }
    constexpr double kSmallestSkirt = 0.04;  // m2, of a part of it
    for (std::size_t p = 0; p < roles.size() && told == GarmentPart::Skirt; ++p) {
        const bool is_large = std::abs(outline_area(pattern.panels[p])) > kSmallestSkirt;
        if (roles[p].part == GarmentPart::Unknown && is_large) roles[p].part = told;
    }
    set_faces(roles, GarmentPart::Skirt, widths, Face::Front, Face::Back);
    set_faces(roles, GarmentPart::Torso, depths, Face::Front, Face::Back);
    set_faces(roles, GarmentPart::Leg, widths, Face::Back, Face::Front);
    return roles;
}

}  // namespace selvedge::sim

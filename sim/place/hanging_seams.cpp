#include "sim/place/hanging_seams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "sim/core/disjoint_sets.h"

namespace selvedge::sim {
namespace {

constexpr double kUpright = 0.7;  // cosine, 45 degrees: shoulders slope, and so do waists

// Both sides of a seam between two panels: sums over its links.
struct PlacedSeam {
    std::array<int, 2> panels{};
    std::array<Vec3d, 2> into{Vec3d::Zero(), Vec3d::Zero()};            // from the seam into the cloth
    double first_over_second = 0;                                       // m
    Vec3d top = Vec3d(0, -std::numeric_limits<double>::infinity(), 0);  // m, the highest point of its first side
    std::vector<SeamLink> links;

    // How far upwards the cloth of a side lies from the seam, -1 to 1.
    double upness(std::size_t side) const {
        return into[side].y() / std::max(into[side].norm(), std::numeric_limits<double>::min());
    }
    std::size_t upper() const { return upness(0) > 0 ? 0 : 1; }  // of a level seam: the side that the other hangs from
    bool is_shoulder() const { return upness(0) < -kUpright && upness(1) < -kUpright; }
    bool is_level() const {
        return std::min(std::abs(upness(0)), std::abs(upness(1))) > kUpright && upness(0) * upness(1) < 0;
    }
};

// Per vertex, a direction into the cloth around it.
std::vector<Vec3d> into_cloth(const GarmentMesh& unsewn) {
    std::vector<Vec3d> into(unsewn.x.size(), Vec3d::Zero());
    const auto at = [&](int v) -> const Vec3d& { return unsewn.x[static_cast<std::size_t>(v)]; };
    for (const GarmentTriangle& triangle : unsewn.triangles) {
        const auto& [a, b, c] = triangle.vertices;
        const Vec3d centre = (at(a) + at(b) + at(c)) / 3;
        for (const int v : triangle.vertices) into[static_cast<std::size_t>(v)] += centre - at(v);
    }
    return into;
}

// Those between two panels; a seam that joins several pairs of them counts as several.
std::vector<PlacedSeam> placed_seams(const GarmentMesh& unsewn, const std::vector<int>& panel_of) {
    const std::vector<Vec3d> into = into_cloth(unsewn);
    std::map<std::array<int, 3>, PlacedSeam> seams;  // by seam and panels
    for (SeamLink link : unsewn.links) {
        const auto panel = [&](int v) { return panel_of[static_cast<std::size_t>(v)]; };
        if (panel(link.a) > panel(link.b)) std::swap(link.a, link.b);
        if (panel(link.a) < 0 || panel(link.a) == panel(link.b)) continue;
        PlacedSeam& seam = seams[{link.seam, panel(link.a), panel(link.b)}];
        seam.panels = {panel(link.a), panel(link.b)};
        const auto a = static_cast<std::size_t>(link.a), b = static_cast<std::size_t>(link.b);
        seam.into[0] += into[a].normalized();
        seam.into[1] += into[b].normalized();
        seam.first_over_second += unsewn.x[a].y() - unsewn.x[b].y();
        if (unsewn.x[a].y() > seam.top.y()) seam.top = unsewn.x[a];
        seam.links.push_back(link);
    }
    std::vector<PlacedSeam> found;
    for (auto& [key, seam] : seams) found.push_back(std::move(seam));
    return found;
}

// Of the body.
struct Shoulders {
    double top = 0;               // m
    Vec3d chest = Vec3d::Zero();  // m
    double half_breadth = 0;      // m, of both shoulders
    double head = 0;              // m, its middle

    // The side seams of a wide skirt also have its cloth below them, but their upper ends lie lower, or farther out;
    // and the seam along the top of a hood lies higher.
    bool bear(const PlacedSeam& seam) const {
        return seam.top.y() > chest.y() && seam.top.y() < head && std::abs(seam.top.x() - chest.x()) < half_breadth;
    }
};

std::optional<Shoulders> shoulders_of(const MeasuredBody* body) {
    constexpr std::size_t kChest = 2, kMiddle = 1;  // of the torso's joints, and of the head's
    constexpr double kHalfBreadth = 0.129;          // of the stature (Drillis and Contini 1966)
    if (body == nullptr || !body->shoulder_top()) return std::nullopt;
    const BodyLimbs& limbs = body->limbs();
    const Limb& head = limbs[LimbKind::Head];
    if (limbs.torso.size() <= kChest) return std::nullopt;
    return Shoulders{.top = *body->shoulder_top(),
                     .chest = limbs.torso[kChest].centre,
                     .half_breadth = kHalfBreadth * body->stature().height(),
                     .head = head.is_found && head.joints.size() > kMiddle ? head.joints[kMiddle].centre.y()
                                                                           : std::numeric_limits<double>::infinity()};
}

// Whether what has shoulder seams stays where it is, or is lifted to the body's shoulders.
enum class AtShoulders { Stay, Lift };

// Panels that seams other than level ones join move together.
class LevelGroups {
 public:
    LevelGroups(const GarmentMesh& unsewn, const std::vector<int>& panel_of, const MeasuredBody* body, AtShoulders how)
        : seams_(placed_seams(unsewn, panel_of)),
          groups_(unsewn.panel_names.size()),
          height_(unsewn.panel_names.size(), kLowest),
          rise_(unsewn.panel_names.size()) {
        for (const PlacedSeam& seam : seams_)
            if (!seam.is_level()) groups_.join(seam.panels[0], seam.panels[1]);
        for (std::size_t v = 0; v < panel_of.size(); ++v)
            if (panel_of[v] >= 0) raise(group_of(panel_of[v]), unsewn.x[v].y());
        hold_shoulders(shoulders_of(body), how);
        hang_all();
    }

    // How far up a panel moves, m.
    double rise_of(int panel) { return rise_[group_of(panel)].value_or(0); }

 private:
    static constexpr double kLowest = -std::numeric_limits<double>::infinity();

    std::size_t group_of(int panel) { return static_cast<std::size_t>(groups_.find(panel)); }
    std::size_t above_of(const PlacedSeam& seam) { return group_of(seam.panels[seam.upper()]); }
    std::size_t below_of(const PlacedSeam& seam) { return group_of(seam.panels[1 - seam.upper()]); }
    void raise(std::size_t group, double height) { height_[group] = std::max(height_[group], height); }

    // What has shoulder seams on the body's shoulders, or any if these are not known.
    void hold_shoulders(const std::optional<Shoulders>& shoulders, AtShoulders how) {
        std::map<std::size_t, double> tops;  // m, by group
        for (const PlacedSeam& seam : seams_) {
            if (!seam.is_shoulder() || (shoulders && !shoulders->bear(seam))) continue;
            double& top = tops.try_emplace(group_of(seam.panels[0]), kLowest).first->second;
            top = std::max(top, seam.top.y());
        }
        const bool lifts = shoulders && how == AtShoulders::Lift;
        for (const auto& [group, top] : tops) rise_[group] = lifts ? std::max(0.0, shoulders->top - top) : 0;
    }

    void hang_all() {
        std::vector<std::size_t> held;
        for (std::size_t group = 0; group < rise_.size(); ++group)
            if (rise_[group]) held.push_back(group);
        for (const std::size_t group : held) hang_from(group);
        stand_on(held);
        while (const std::optional<std::size_t> top = highest()) {
            rise_[*top] = 0;
            hang_from(*top);
        }
    }

    // What stands on these groups, as a hood on a neckline, keeps its height over them.
    void stand_on(std::vector<std::size_t> reached) {
        for (std::size_t i = 0; i < reached.size(); ++i) {
            for (const PlacedSeam& seam : seams_) {
                if (!seam.is_level() || below_of(seam) != reached[i] || rise_[above_of(seam)]) continue;
                rise_[above_of(seam)] = rise_[reached[i]];
                reached.push_back(above_of(seam));
            }
        }
    }

    // Of the groups whose rise is not known.
    std::optional<std::size_t> highest() const {
        std::optional<std::size_t> found;
        for (std::size_t group = 0; group < height_.size(); ++group) {
            if (rise_[group] || height_[group] == kLowest) continue;
            if (!found || height_[group] > height_[*found]) found = group;
        }
        return found;
    }

    // The groups that hang from this one by level seams, those that hang from them, and so on.
    void hang_from(std::size_t root) {
        std::vector<std::size_t> reached{root};
        for (std::size_t i = 0; i < reached.size(); ++i) {
            std::map<std::size_t, std::pair<double, double>> gaps;  // by group: sum over the links, m, and their number
            for (const PlacedSeam& seam : seams_) {
                const std::size_t above = above_of(seam), below = below_of(seam);
                if (!seam.is_level() || above != reached[i] || below == above) continue;
                auto& [sum, count] = gaps[below];
                sum += seam.upper() == 0 ? seam.first_over_second : -seam.first_over_second;
                count += static_cast<double>(seam.links.size());
            }
            for (const auto& [group, gap] : gaps) {
                if (rise_[group]) continue;
                rise_[group] = *rise_[reached[i]] + gap.first / gap.second;
                reached.push_back(group);
            }
        }
    }

    std::vector<PlacedSeam> seams_;
    DisjointSets groups_;
    std::vector<double> height_;               // m, of the highest point, by group
    std::vector<std::optional<double>> rise_;  // m, by group; none: not known yet
};

// Returns the largest move, m.
double move_groups(GarmentMesh& unsewn, const MeasuredBody* body, AtShoulders how) {
    const std::vector<int> panel_of = panels_of_vertices(unsewn);
    LevelGroups groups(unsewn, panel_of, body, how);
    double largest = 0;
    for (std::size_t v = 0; v < unsewn.x.size(); ++v) {
        if (panel_of[v] < 0) continue;
        const double rise = groups.rise_of(panel_of[v]);
        unsewn.x[v].y() += rise;
        largest = std::max(largest, std::abs(rise));
    }
    return largest;
}

}  // namespace

std::vector<SeamLink> shoulder_links(const GarmentMesh& unsewn) {
    std::vector<SeamLink> links;
    for (const PlacedSeam& seam : placed_seams(unsewn, panels_of_vertices(unsewn)))
        if (seam.is_shoulder()) links.insert(links.end(), seam.links.begin(), seam.links.end());
    return links;
}

double close_level_gaps(GarmentMesh& unsewn, const MeasuredBody* body) {
    return move_groups(unsewn, body, AtShoulders::Stay);
}

void hang_on_shoulders(GarmentMesh& unsewn, const MeasuredBody& body) {
    move_groups(unsewn, &body, AtShoulders::Lift);
}

}  // namespace selvedge::sim

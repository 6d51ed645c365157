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
    std::array<Vec3d, 2> into{Vec3d::Zero(), Vec3d::Zero()};  // from the seam into the cloth
    double first_over_second = 0;                             // m
    std::vector<SeamLink> links;

    // How far upwards the cloth of a side lies from the seam, -1 to 1.
    double upness(std::size_t side) const {
        return into[side].y() / std::max(into[side].norm(), std::numeric_limits<double>::min());
    }
    bool is_shoulder() const { return upness(0) < -kUpright && upness(1) < -kUpright; }
    bool is_level() const {
        return std::min(std::abs(upness(0)), std::abs(upness(1))) > kUpright && upness(0) * upness(1) < 0;
    }
};

// The panel of each vertex; -1: it has no triangle.
std::vector<int> panels_of_vertices(const GarmentMesh& unsewn) {
    std::vector<int> panels(unsewn.x.size(), -1);
    for (const GarmentTriangle& triangle : unsewn.triangles)
        for (const int v : triangle.vertices) panels[static_cast<std::size_t>(v)] = triangle.panel;
    return panels;
}

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
        seam.links.push_back(link);
    }
    std::vector<PlacedSeam> found;
    for (auto& [key, seam] : seams) found.push_back(std::move(seam));
    return found;
}

// Panels that seams other than level ones join move together.
class LevelGroups {
 public:
    LevelGroups(const GarmentMesh& unsewn, const std::vector<int>& panel_of)
        : seams_(placed_seams(unsewn, panel_of)),
          groups_(unsewn.panel_names.size()),
          height_(unsewn.panel_names.size(), kLowest),
          rise_(unsewn.panel_names.size()) {
        for (const PlacedSeam& seam : seams_)
            if (!seam.is_level()) groups_.join(seam.panels[0], seam.panels[1]);
        for (std::size_t v = 0; v < panel_of.size(); ++v)
            if (panel_of[v] >= 0) raise(group_of(panel_of[v]), unsewn.x[v].y());
        for (const PlacedSeam& seam : seams_)
            if (seam.is_shoulder()) rise_[group_of(seam.panels[0])] = 0;
        hang_all();
    }

    // How far up a panel moves, m.
    double rise_of(int panel) { return rise_[group_of(panel)].value_or(0); }

 private:
    static constexpr double kLowest = -std::numeric_limits<double>::infinity();

    std::size_t group_of(int panel) { return static_cast<std::size_t>(groups_.find(panel)); }
    void raise(std::size_t group, double height) { height_[group] = std::max(height_[group], height); }

    void hang_all() {
        std::vector<std::size_t> held;
        for (std::size_t group = 0; group < rise_.size(); ++group)
            if (rise_[group]) held.push_back(group);
        for (const std::size_t group : held) hang_from(group);
        for (;;) {
            std::size_t highest = 0;
            double height = kLowest;
            for (std::size_t group = 0; group < height_.size(); ++group) {
                if (rise_[group] || height_[group] <= height) continue;
                highest = group;
                height = height_[group];
            }
            if (height == kLowest) return;
            rise_[highest] = 0;
            hang_from(highest);
        }
    }

    // The groups that hang from this one by level seams, those that hang from them, and so on.
    void hang_from(std::size_t root) {
        std::vector<std::size_t> reached{root};
        for (std::size_t i = 0; i < reached.size(); ++i) {
            std::map<std::size_t, std::pair<double, double>> gaps;  // by group: sum over the links, m, and their number
            for (const PlacedSeam& seam : seams_) {
                const std::size_t upper = seam.upness(0) > 0 ? 0 : 1;
                const std::size_t above = group_of(seam.panels[upper]), below = group_of(seam.panels[1 - upper]);
                if (!seam.is_level() || above != reached[i] || below == above) continue;
                auto& [sum, count] = gaps[below];
                sum += upper == 0 ? seam.first_over_second : -seam.first_over_second;
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

}  // namespace

std::vector<SeamLink> shoulder_links(const GarmentMesh& unsewn) {
    std::vector<SeamLink> links;
    for (const PlacedSeam& seam : placed_seams(unsewn, panels_of_vertices(unsewn)))
        if (seam.is_shoulder()) links.insert(links.end(), seam.links.begin(), seam.links.end());
    return links;
}

double close_level_gaps(GarmentMesh& unsewn) {
    const std::vector<int> panel_of = panels_of_vertices(unsewn);
    LevelGroups groups(unsewn, panel_of);
    double largest = 0;
    for (std::size_t v = 0; v < unsewn.x.size(); ++v) {
        if (panel_of[v] < 0) continue;
        const double rise = groups.rise_of(panel_of[v]);
        unsewn.x[v].y() += rise;
        largest = std::max(largest, std::abs(rise));
    }
    return largest;
}

}  // namespace selvedge::sim

#include "sim/pattern/dart.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/core/math.h"
#include "sim/pattern/edge_shape.h"

namespace selvedge::sim {
namespace {

class DartFinder {
 public:
    DartFinder(const Panel& panel, int index, std::span<const Seam> seams)
        : panel_(panel), count_(static_cast<int>(panel.edges.size())), partner_(panel.edges.size(), -1) {
        for (const Seam& seam : seams) {
            if (seam.first.panel != index || seam.second.panel != index || joins_right_to_wrong(seam)) continue;
            if (std::max(seam.first.edge, seam.second.edge) >= count_) continue;
            partner_[as_size(seam.first.edge)] = seam.second.edge;
            partner_[as_size(seam.second.edge)] = seam.first.edge;
        }
    }

    std::vector<Dart> find() const {
        std::vector<Dart> darts;
        for (int e = 0; e < count_; ++e) {
            if (partner_[as_size(e)] != after(e) || !is_tip(e)) continue;
            Dart dart{.first_leg = e};
            const auto may_grow = [&] { return 2 * (dart.leg_edges + 1) + 2 <= count_; };
            while (may_grow() && partner_[as_size(before(dart.first_leg))] == after(last_leg(dart))) {
                dart.first_leg = before(dart.first_leg);
                ++dart.leg_edges;
            }
            if (2 * dart.leg_edges + 2 > count_) continue;
            set_side(dart);
            darts.push_back(dart);
        }
        return darts;
    }

 private:
    int before(int e) const { return (e + count_ - 1) % count_; }
    int after(int e) const { return (e + 1) % count_; }
    int last_leg(const Dart& dart) const { return (dart.first_leg + 2 * dart.leg_edges - 1) % count_; }
    const OutlineEdge& edge(int e) const { return panel_.edges[as_size(e)]; }

    // Whether the outline turns back where edge e ends, round a wedge that lies outside the panel.
    bool is_tip(int e) const {
        constexpr double kWidest = 100 * std::numbers::pi / 180;  // rad, of a wedge that is folded away
        const Vec2d in = curve_direction(panel_, edge(e), EdgeEnd::End);
        const Vec2d out = curve_direction(panel_, edge(after(e)), EdgeEnd::Start);
        const double turn = std::atan2(cross2(in, out), in.dot(out));
        return turn < kWidest - std::numbers::pi || turn > std::numbers::pi - 1e-6;
    }

    void set_side(Dart& dart) const {
        const int tip_edge = (dart.first_leg + dart.leg_edges) % count_;
        const Vec3d tip = panel_.place(panel_.vertices[as_size(edge(tip_edge).start)]);
        const Vec3d begin = panel_.place(panel_.vertices[as_size(edge(dart.first_leg).start)]);
        const Vec3d end = panel_.place(panel_.vertices[as_size(edge(last_leg(dart)).end)]);
        const Vec3d along = (begin + end) / 2 - tip;
        dart.is_level = std::abs(along.y()) < std::hypot(along.x(), along.z());
        const bool is_before = dart.is_level ? begin.y() <= end.y() : std::abs(begin.x()) <= std::abs(end.x());
        dart.pressed_to = is_before ? DartSide::Before : DartSide::After;
    }

    const Panel& panel_;
    int count_;
    std::vector<int> partner_;  // per edge, the edge that it is sewn to; -1: none of this panel
};

}  // namespace

std::vector<Dart> find_darts(const Panel& panel, int index, std::span<const Seam> seams) {
    return DartFinder(panel, index, seams).find();
}

}  // namespace selvedge::sim

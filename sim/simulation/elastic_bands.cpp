#include "sim/simulation/elastic_bands.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "sim/adaptive/panel_lines.h"
#include "sim/cloth/solver_state.h"
#include "sim/core/assert.h"

namespace selvedge::sim {
namespace {

constexpr float kDrawing = 0.5F;  // 1/s: an elastic draws cloth in by half of its length per second at most
// m that a sub-step may move a vertex where the body is given all of what presses on it. Steps move 5 mm, so it is
// given half: its friction still bears many times the weight of a garment. All of it would throw vertices of a light
// hem into the body by millimetres in each sub-step, and the cloth beside them comes to rest later or not at all.
constexpr float kAllPressing = 0.01F;
constexpr float kTouching = 0.0003F;  // m from where the body holds vertices

constexpr int kLiftings = 3;  // per sub-step, of what leaves the body

// Calls visit(edge, length) for the leaf edges inside of an edge of that length, in its direction.
template <class Visit>
void for_leaves(const AdaptiveMesh& mesh, EdgeId edge, float length, const Visit& visit) {
    if (!mesh.is_split(edge)) return visit(edge, length);
    for (const EdgeId child : mesh.edge(edge).children) for_leaves(mesh, child, length / 2, visit);
}

float length_in_panel(const AdaptiveMesh& mesh, EdgeId base, std::size_t side) {
    const AdaptiveTriangle& t = mesh.triangle(mesh.edge(base).sides[side]);
    const std::size_t k = index_of(t, base);
    return (t.u[(k + 1) % 3] - t.u[k]).norm();
}

Vec3d point(const float* points, std::uint32_t v) {
    return {points[4 * v], points[4 * v + 1], points[4 * v + 2]};
}

}  // namespace

bool has_elastics(const Pattern& pattern) {
    return std::ranges::any_of(pattern.panels, [](const Panel& panel) {
        return std::ranges::any_of(panel.edges, [](const OutlineEdge& edge) { return edge.elastic.has_value(); });
    });
}

ElasticBands::ElasticBands(const Pattern& pattern) {
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
        for (std::size_t e = 0; e < pattern.panels[p].edges.size(); ++e) {
            const std::optional<Elastic>& elastic = pattern.panels[p].edges[e].elastic;
            if (!elastic) continue;
            bands_.push_back({.panel = static_cast<int>(p),
                              .edge = static_cast<int>(e),
                              .share = static_cast<float>(elastic->share),
                              .stiffness = static_cast<float>(elastic->stiffness)});
        }
    }
}

// A seam with an elastic on both of its edges has two springs on each of its edges, which are in different chains.
void ElasticBands::make(const Cloth& cloth) {
    std::map<std::pair<int, int>, std::uint32_t> band_at;
    for (std::uint32_t i = 0; i < bands_.size(); ++i) band_at[{bands_[i].panel, bands_[i].edge}] = i;
    std::array<std::vector<Spring>, 2> loose;
    std::vector<float> now(bands_.size(), 0), flat(bands_.size(), 0);  // m
    for (std::uint32_t i = 0; i < cloth.mesh.base_edge_count(); ++i) {
        const EdgeId base(i);
        const auto lines = lines_of(cloth.mesh, base);
        bool is_second = false;
        for (std::size_t side = 0; side < 2; ++side) {
            if (!lines[side]) continue;
            const auto band = band_at.find({lines[side]->panel, lines[side]->edge});
            if (band == band_at.end()) continue;
            for_leaves(cloth.mesh, base, length_in_panel(cloth.mesh, base, side), [&](EdgeId leaf, float length) {
                const auto& ends = cloth.mesh.edge(leaf).ends;
                loose[is_second ? 1 : 0].push_back({{ends[0].value, ends[1].value}, band->second, length});
                now[band->second] += (cloth.x[ends[0].value] - cloth.x[ends[1].value]).norm();
                flat[band->second] += length;
            });
            is_second = true;
        }
    }
    // It starts as it lies, without tension.
    for (std::size_t i = 0; i < bands_.size(); ++i) {
        if (bands_[i].drawn_to == 0 && flat[i] > 0)
            bands_[i].drawn_to = std::clamp(now[i] / flat[i], bands_[i].share, 1.0F);
    }
    springs_.clear();
    chains_.clear();
    for (std::vector<Spring>& springs : loose) chain_up(std::move(springs));
    held_.assign(springs_.size(), {Vec3f::Zero(), Vec3f::Zero()});
    substep_ = cloth.substep;
    per_mass_ = compliance_of_spring(cloth, 1);
}

// Chains end where no spring or several go on. What is left are rings.
void ElasticBands::chain_up(std::vector<Spring> loose) {
    std::map<std::uint32_t, std::vector<std::size_t>> at;  // springs by vertex
    for (std::size_t i = 0; i < loose.size(); ++i)
        for (const std::uint32_t v : loose[i].ends) at[v].push_back(i);
    std::vector<bool> is_used(loose.size(), false);
    const auto follow = [&](std::size_t spring, std::uint32_t from) {
        Chain chain{.first = static_cast<std::uint32_t>(springs_.size())};
        for (std::uint32_t v = from;;) {
            is_used[spring] = true;
            Spring& added = springs_.emplace_back(loose[spring]);
            if (added.ends[0] != v) std::swap(added.ends[0], added.ends[1]);
            v = added.ends[1];
            const std::vector<std::size_t>& here = at[v];
            if (v == from) chain.is_ring = here.size() == 2;
            if (v == from || here.size() != 2) break;
            spring = here[0] == spring ? here[1] : here[0];
        }
        chain.count = static_cast<std::uint32_t>(springs_.size()) - chain.first;
        chains_.push_back(chain);
    };
    for (const auto& [vertex, here] : at) {
        if (here.size() == 2) continue;
        for (const std::size_t spring : here)
            if (!is_used[spring]) follow(spring, vertex);
    }
    for (std::size_t i = 0; i < loose.size(); ++i)
        if (!is_used[i]) follow(i, loose[i].ends[0]);
}

void ElasticBands::begin_step(const Cloth& cloth, const Collider& body, const StepOptions& stepping) {
    pressing_ = std::min(1.0F, stepping.max_move_per_substep / kAllPressing);
    for (std::size_t i = 0; i < springs_.size(); ++i) {
        for (std::size_t end = 0; end < 2; ++end) {
            const std::uint32_t v = springs_[i].ends[end];
            const Contact at = body.contact(cloth.x[v].head<3>());
            const float held_at = stepping.contact.offset + cloth.solver->contacts.standoff[v] + kTouching;
            held_[i][end] = at.distance < held_at ? at.normal : Vec3f(Vec3f::Zero());
        }
    }
}

float ElasticBands::rest_length(const Spring& spring) const {
    return bands_[spring.band].drawn_to * spring.length;
}

void ElasticBands::solve(float* points, const float* before) {
    for (Band& band : bands_)
        if (band.drawn_to > 0) band.drawn_to = std::max(band.share, band.drawn_to - kDrawing * substep_);
    for (const Chain& chain : chains_) {
        is_lifted_.assign(chain.count + 1, false);
        set_up(chain, points, before);
        solve_nodes();
        for (int pass = 0; pass < kLiftings && lift_off(chain); ++pass) {
            set_up(chain, points, before);
            solve_nodes();
        }
        apply(chain, points);
    }
}

// Rows of  (M / h^2 + K) way = M / h^2 (points - before) + forces,  linear about `before`. The momentum of corrections
// provides a part of the stiffness (docs/solver.md), so h^2 is (1 - kMomentum) times that of a sub-step.
void ElasticBands::set_up(const Chain& chain, const float* points, const float* before) {
    const auto per_mass = static_cast<double>(per_mass_);
    nodes_.resize(chain.is_ring ? chain.count : chain.count + 1);
    pulls_.assign(chain.count, {});
    const std::size_t last = nodes_.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
        const std::size_t spring = chain.first + std::min<std::size_t>(i, chain.count - 1),
                          end = i < chain.count ? 0 : 1;
        constexpr double kHeavy = 1e3;  // kg, of a vertex that cannot move
        const std::uint32_t v = springs_[spring].ends[end];
        const double w = static_cast<double>(points[4 * v + 3]), inertia = per_mass * (w > 0 ? 1 / w : kHeavy);
        const Vec3d normal = is_lifted_[i] ? Vec3d(Vec3d::Zero()) : Vec3d(held_[spring][end].cast<double>());
        const Vec3d motion = point(points, v) - point(before, v);
        nodes_[i] = {
            .vertex = v,
            .held = normal,
            .drive = inertia * motion,
            .stiffness = inertia * Eigen::Matrix3d::Identity() + kHeavy * per_mass * normal * normal.transpose(),
            .next = Eigen::Matrix3d::Zero(),
            .last = Eigen::Matrix3d::Zero(),
            .force = inertia * (motion - normal.dot(motion) * normal),  // the body takes up what is along it
            .way = Vec3d::Zero()};
    }
    for (std::size_t i = 0; i < chain.count; ++i) {
        const Spring& spring = springs_[chain.first + i];
        Node &a = nodes_[i], &b = nodes_[(i + 1) % nodes_.size()];
        const Vec3d d = point(before, b.vertex) - point(before, a.vertex);
        const auto rest = static_cast<double>(rest_length(spring));
        const double length = d.norm();
        if (length <= rest) continue;  // slack
        const double stiffness = static_cast<double>(bands_[spring.band].stiffness) / rest;
        const double tension = stiffness * (length - rest);
        const Eigen::Matrix3d along = d * d.transpose() / (length * length);
        pulls_[i].force = tension / length * d;
        pulls_[i].stiffness = stiffness * along + tension / length * (Eigen::Matrix3d::Identity() - along);
        a.force += pulls_[i].force;
        b.force -= pulls_[i].force;
        a.stiffness += pulls_[i].stiffness;
        b.stiffness += pulls_[i].stiffness;
        if (i + 1 < last) a.next -= pulls_[i].stiffness;
        if (i + 1 == last) a.last -= pulls_[i].stiffness;
        if (i + 1 > last) b.last -= pulls_[i].stiffness;  // closes the ring
    }
}

// Elimination from the first node to the last, whose column is carried along.
void ElasticBands::solve_nodes() {
    Node& last = nodes_.back();
    for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
        Node& node = nodes_[i];
        const Eigen::Matrix3d inverse = node.stiffness.inverse();
        if (i + 2 < nodes_.size()) {
            Node& next = nodes_[i + 1];
            const Eigen::Matrix3d factor = node.next.transpose() * inverse;
            next.stiffness -= factor * node.next;
            next.last -= factor * node.last;
            next.force -= factor * node.force;
        }
        const Eigen::Matrix3d factor = node.last.transpose() * inverse;
        last.stiffness -= factor * node.last;
        last.force -= factor * node.force;
        node.stiffness = inverse;
    }
    last.way = last.stiffness.inverse() * last.force;
    for (std::size_t i = nodes_.size() - 1; i-- > 0;) {
        Node& node = nodes_[i];
        Vec3d rest = node.force - node.last * last.way;
        if (i + 2 < nodes_.size()) rest -= node.next * nodes_[i + 1].way;
        node.way = node.stiffness * rest;
    }
}

// A body holds what presses on it. What its elastic lifts off, as where the line is straighter than the body, is free.
bool ElasticBands::lift_off(const Chain& chain) {
    for (std::size_t i = 0; i < chain.count; ++i) {
        Node &a = nodes_[i], &b = nodes_[(i + 1) % nodes_.size()];
        const Vec3d force = pulls_[i].force + pulls_[i].stiffness * (b.way - a.way);
        a.drive += force;
        b.drive -= force;
    }
    bool is_any = false;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (nodes_[i].held.dot(nodes_[i].drive) <= 0) continue;
        is_lifted_[i] = is_any = true;
    }
    return is_any;
}

// Elastics do not push.
void ElasticBands::apply(const Chain& chain, float* points) const {
    for (std::size_t i = 0; i < chain.count; ++i) {
        const Node &a = nodes_[i], &b = nodes_[(i + 1) % nodes_.size()];
        const Vec3d force = pulls_[i].force + pulls_[i].stiffness * (b.way - a.way);
        if (force.dot(pulls_[i].force) <= 0) continue;
        push(a, force, points);
        push(b, -force, points);
    }
}

void ElasticBands::push(const Node& node, const Vec3d& force, float* points) const {
    float* const x = points + 4 * node.vertex;
    const double by = static_cast<double>(x[3]) / static_cast<double>(per_mass_);
    const double inward = std::max(0.0, -node.held.dot(force));  // N
    const Vec3d way = by * (force + (1 - static_cast<double>(pressing_)) * inward * node.held);
    for (int axis = 0; axis < 3; ++axis) x[axis] += static_cast<float>(way[axis]);
}

bool ElasticBands::is_at_rest() const {
    return std::ranges::all_of(bands_, [](const Band& band) { return band.drawn_to <= band.share; });
}

std::vector<float> ElasticBands::tensions(const Cloth& cloth, int panel, int edge) const {
    std::vector<float> tensions;
    for (const Spring& spring : springs_) {
        const Band& band = bands_[spring.band];
        if (band.panel != panel || band.edge != edge) continue;
        const float length = (cloth.x[spring.ends[0]] - cloth.x[spring.ends[1]]).norm();
        tensions.push_back(band.stiffness * std::max(0.0F, length / (band.share * spring.length) - 1));
    }
    return tensions;
}

}  // namespace selvedge::sim

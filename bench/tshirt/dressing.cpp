#include "bench/tshirt/dressing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "sim/dress/drape.h"
#include "sim/dress/dress.h"
#include "sim/dress/sewing.h"
#include "sim/mesh/sew.h"
#include "sim/place/placement.h"

namespace selvedge::bench {
namespace {

// The vertices that divide the triangles of a body. The two triangles of an edge share the vertices on it.
class SplitPoints {
 public:
    SplitPoints(sim::Body& body, int parts) : body_(body), parts_(parts) {}

    // The vertex with these barycentric weights (one per corner, sum: parts); created on first use.
    int at(const std::array<int, 3>& corners, const std::array<int, 3>& weights) {
        std::array<std::array<int, 2>, 3> key{};  // (vertex, weight) pairs; (-1, 0) where the weight is 0
        Vec3d x = Vec3d::Zero();
        for (std::size_t k = 0; k < 3; ++k) {
            key[k] = weights[k] > 0 ? std::array{corners[k], weights[k]} : std::array{-1, 0};
            x += weights[k] * body_.x[static_cast<std::size_t>(corners[k])];
        }
        std::ranges::sort(key);
        const auto [place, is_new] = known_.try_emplace(key, static_cast<int>(body_.x.size()));
        if (key[1][0] < 0) return key[2][0];  // a corner
        if (is_new) body_.x.emplace_back(x / parts_);
        return place->second;
    }

 private:
    sim::Body& body_;
    int parts_;
    std::map<std::array<std::array<int, 2>, 3>, int> known_;
};

void split_triangle(const std::array<int, 3>& corners, int parts, SplitPoints& points,
                    std::vector<std::array<int, 3>>& into) {
    const auto point = [&](int i, int j) { return points.at(corners, {parts - i - j, i, j}); };
    for (int i = 0; i < parts; ++i) {
        for (int j = 0; i + j < parts; ++j) {
            into.push_back({point(i, j), point(i + 1, j), point(i, j + 1)});
            if (i + j + 1 < parts) into.push_back({point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)});
        }
    }
}

sim::GarmentMesh placed_panels(const sim::Pattern& pattern, const sim::Body& body, const sim::BodyCollider& collider,
                               const DressingOptions& options) {
    sim::Pattern moved = pattern;
    anchor_panels(moved, placed_for(pattern), body);
    sim::MeshOptions meshing;
    meshing.target_edge = options.edge_length.value_or(pattern.edge_length.value_or(meshing.target_edge));
    sim::GarmentMesh unsewn = assemble(moved, meshing);
    const double lift = seam_clearing_lift(unsewn, collider);
    for (Vec3d& x : unsewn.x) x.y() += lift;
    clear_panels(unsewn, collider);
    return unsewn;
}

// Decreases shortest_edge step by step, with some frames to settle after each, until there are enough leaf triangles.
void refine_on(Dressing& dressing, const sim::BodyCollider& collider, int least_leaves) {
    constexpr int kRounds = 80;
    constexpr int kFrames = 15;  // of one adaptation and four steps
    constexpr float kShorter = 0.98F;
    constexpr double kMargin = 1.015;  // the middle of the accepted range, see sized_row() in tshirt.cpp
    const sim::StepOptions stepping{.extra_damping = 8};
    for (int round = 0; round < kRounds; ++round) {
        if (static_cast<double>(dressing.cloth.mesh.leaf_triangles().size()) >= kMargin * least_leaves) return;
        dressing.shortest_edge *= kShorter;
        for (int frame = 0; frame < kFrames; ++frame) {
            adapt_cloth(dressing.cloth, collider, {.shortest_edge = dressing.shortest_edge});
            for (int i = 0; i < 4; ++i) step(dressing.cloth, collider, stepping);
        }
    }
}

}  // namespace

sim::Body split_triangles(const sim::Body& body, int triangles) {
    const double ratio = triangles / static_cast<double>(body.triangles.size());
    const int parts = std::max(1, static_cast<int>(std::ceil(std::sqrt(ratio) - 1e-9)));
    sim::Body split{.name = body.name, .x = body.x, .triangles = {}, .bones = {}, .skin = {}};
    SplitPoints points(split, parts);
    for (const auto& corners : body.triangles) split_triangle(corners, parts, points, split.triangles);
    return split;
}

Dressing dress_cloth(const sim::Pattern& pattern, const sim::Body& body, const sim::BodyCollider& collider,
                     const DressingOptions& options, const sim::Progress& progress) {
    const std::vector<sim::Fabric> fabrics = fabrics_of(pattern);
    const sim::SewingResult sewing =
        sew_on_body(placed_panels(pattern, body, collider, options), fabrics, collider, {}, progress);
    Dressing dressing{.cloth = make_cloth(sewing.sewn, fabrics, {.max_level = options.max_level}),
                      .shortest_edge = options.shortest_edge};
    sim::DrapeOptions draping;
    draping.adapt.shortest_edge = options.shortest_edge;
    draping.finish_time = 0;  // the experiment continues with the usual sub-steps
    dressing.is_settled = drape(dressing.cloth, collider, draping, progress).settled;
    refine_on(dressing, collider, options.least_leaves);
    return dressing;
}

}  // namespace selvedge::bench

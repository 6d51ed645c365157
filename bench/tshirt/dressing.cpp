#include "bench/tshirt/dressing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "sim/cloth/adapt_cloth.h"
#include "sim/cloth/step.h"
#include "sim/dress/dressing.h"

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
        if (!is_new) return place->second;
        body_.x.emplace_back(x / parts_);
        if (!body_.skin.empty()) body_.skin.push_back(mixed_skin(corners, weights));
        if (!body_.bind.empty()) body_.bind.push_back(mixed_bind(corners, weights));
        return place->second;
    }

 private:
    // The four largest of the mixed weights.
    sim::SkinWeights mixed_skin(const std::array<int, 3>& corners, const std::array<int, 3>& weights) const {
        std::map<std::uint16_t, float> mixed;
        for (std::size_t k = 0; k < 3; ++k) {
            const sim::SkinWeights& skin = body_.skin[static_cast<std::size_t>(corners[k])];
            for (std::size_t i = 0; i < 4; ++i)
                mixed[skin.bones[i]] += static_cast<float>(weights[k]) * skin.weights[i];
        }
        std::vector<std::pair<float, std::uint16_t>> ordered;
        for (const auto& [bone, weight] : mixed) ordered.emplace_back(-weight, bone);
        std::ranges::sort(ordered);
        sim::SkinWeights result;
        float sum = 0;
        for (std::size_t i = 0; i < std::min<std::size_t>(4, ordered.size()); ++i) sum -= ordered[i].first;
        for (std::size_t i = 0; i < std::min<std::size_t>(4, ordered.size()); ++i) {
            result.bones[i] = ordered[i].second;
            result.weights[i] = -ordered[i].first / sum;
        }
        return result;
    }

    Vec3d mixed_bind(const std::array<int, 3>& corners, const std::array<int, 3>& weights) const {
        Vec3d x = Vec3d::Zero();
        for (std::size_t k = 0; k < 3; ++k) x += weights[k] * body_.bind[static_cast<std::size_t>(corners[k])];
        return x / parts_;
    }

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

// Decreases shortest_edge step by step, with some frames to settle after each, until there are enough leaf triangles.
void refine_on(DressedCloth& dressed, const sim::BodyCollider& collider, int min_leaves) {
    constexpr int kRounds = 80;
    constexpr int kFrames = 15;  // of one adaptation and four steps
    constexpr float kShorter = 0.98F;
    constexpr double kMargin = 1.015;  // the middle of the accepted range, see sized_row() in tshirt.cpp
    const sim::StepOptions stepping{.extra_damping = 8};
    for (int round = 0; round < kRounds; ++round) {
        if (static_cast<double>(dressed.cloth.mesh.leaf_triangles().size()) >= kMargin * min_leaves) return;
        dressed.shortest_edge *= kShorter;
        for (int frame = 0; frame < kFrames; ++frame) {
            adapt_cloth(dressed.cloth, collider, {.shortest_edge = dressed.shortest_edge});
            for (int i = 0; i < 4; ++i) step(dressed.cloth, collider, stepping);
        }
    }
}

}  // namespace

sim::Body split_triangles(const sim::Body& body, int triangles) {
    const double ratio = triangles / static_cast<double>(body.triangles.size());
    const int parts = std::max(1, static_cast<int>(std::ceil(std::sqrt(ratio) - 1e-9)));
    sim::Body split = body;
    split.triangles.clear();
    split.made_from.clear();
    SplitPoints points(split, parts);
    for (const auto& corners : body.triangles) split_triangle(corners, parts, points, split.triangles);
    return split;
}

DressedCloth dress_cloth(const sim::Pattern& pattern, const sim::Body& body, const DressingOptions& options,
                         const sim::Progress& progress) {
    sim::Dressing dressing;
    dressing.set_options({.edge_length = options.edge_length,
                          .max_level = options.max_level,
                          .shortest_edge = static_cast<double>(options.shortest_edge),
                          .finish_time = 0});  // the experiment continues with the usual sub-steps
    dressing.set_body(std::shared_ptr<const sim::Body>(std::shared_ptr<void>(), &body));
    dressing.set_pattern(pattern);
    while (dressing.advance()) sim::report(progress, "dressing", dressing.fraction());
    DressedCloth dressed{
        .cloth = *dressing.cloth(), .shortest_edge = options.shortest_edge, .is_settled = dressing.result().settled};
    refine_on(dressed, dressing.collider(), options.min_leaves);
    return dressed;
}

}  // namespace selvedge::bench

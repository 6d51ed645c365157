#include "sim/dress/motion_quality.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <utility>

#include "sim/cloth/cloth_penetration.h"
#include "sim/cloth/moving_contact.h"
#include "sim/core/math.h"
#include "sim/dress/report.h"

namespace selvedge::sim {

void MotionQuality::note(const Cloth& cloth, const MovingBodyCollider& body, double seconds) {
    ++frames;
    note_stretch(cloth, seconds);
    if (!has_bad_number) note_depths(cloth, body);
}

std::vector<std::string> MotionQuality::faults() const {
    constexpr double kNoticed = 0.1;  // s, for which an overstretched triangle is seen
    std::vector<std::string> faults;
    std::array<char, 128> text{};
    if (has_bad_number) faults.emplace_back("a coordinate is no longer finite");
    if (deep_vertices > 0 || deepest_face > FaultLimits{}.face_depth) {
        std::snprintf(text.data(), text.size(),
                      "cloth is in the body by %.1f mm: %d vertices and %d faces by more than 1 mm, all frames",
                      1e3 * std::max(deepest_vertex, deepest_face), deep_vertices, deep_faces);
        faults.emplace_back(text.data());
    }
    if (overstretched_seconds > kNoticed) {
        std::snprintf(text.data(), text.size(), "a triangle is stretched by more than 15 %% for %.2f s",
                      overstretched_seconds);
        faults.emplace_back(text.data());
    }
    return faults;
}

void MotionQuality::note_stretch(const Cloth& cloth, double seconds) {
    has_bad_number = has_bad_number || find_bad_vertex(cloth).has_value();
    if (has_bad_number) return;
    const std::vector<TriangleStrain> strains = measure_strain(cloth);
    const auto& leaves = cloth.mesh.leaf_triangles();
    std::vector<double> stretches, since;
    for (std::size_t i = 0; i < strains.size(); ++i) {
        stretches.push_back(static_cast<double>(strains[i].warp));
        stretches.push_back(static_cast<double>(strains[i].weft));
        if (std::max(strains[i].warp, strains[i].weft) <= kOverstretched) continue;
        const std::size_t id = leaves[i].triangle.value;
        if (since.size() <= id) since.resize(id + 1, 0);
        since[id] = seconds + (id < stretched_since_.size() ? stretched_since_[id] : 0);
        overstretched_seconds = std::max(overstretched_seconds, since[id]);
    }
    stretched_since_ = std::move(since);
    p99_stretch = std::max(p99_stretch, quantile(stretches, 0.99));
    max_stretch = std::max(max_stretch, quantile(stretches, 1));
}

void MotionQuality::note_depths(const Cloth& cloth, const MovingBodyCollider& body) {
    const MovingContacts& contacts = cloth.solver.contacts.moving;
    const auto pinches = [&](VertexId v) { return is_pinched(contacts, v); };
    const auto& vertices = cloth.mesh.leaf_vertices();
    pinched = std::max(pinched, static_cast<int>(std::ranges::count_if(vertices, pinches)));
    for (const VertexId v : vertices) {
        if (pinches(v)) continue;
        const auto closest = body.surface().closest(cloth.x[v.value].head<3>(), std::numeric_limits<float>::infinity());
        const float depth = closest ? -closest->distance : 0;
        deepest_vertex = std::max(deepest_vertex, static_cast<double>(depth));
        deep_vertices += depth > kDeep ? 1 : 0;
    }
    constexpr float kSeen = 0.0001F;  // m: flesh that comes through by so little shows as a spot, 5 mm wide on a thigh
    for (const DeepFace& face : find_penetration(cloth, body.surface(), {.depth = kSeen}).deep_faces) {
        if (std::ranges::any_of(cloth.mesh.leaf_triangles()[face.triangle].v, pinches)) continue;
        deepest_face = std::max(deepest_face, static_cast<double>(face.depth));
        deep_faces += face.depth > kDeep ? 1 : 0;
    }
}

}  // namespace selvedge::sim

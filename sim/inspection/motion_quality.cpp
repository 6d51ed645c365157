#include "sim/inspection/motion_quality.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <utility>

#include "sim/adaptive/leaf_tracker.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/cloth_penetration.h"
#include "sim/cloth/moving_contact.h"
#include "sim/cloth/solver_state.h"
#include "sim/collide/moving_body.h"
#include "sim/core/math.h"
#include "sim/inspection/inspection.h"

namespace selvedge::sim {

namespace {

std::string described(const MotionQuality::Event& event, std::span<const std::string> panels) {
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), "%.2f s, at (%.2f, %.2f, %.2f) m", event.seconds,
                  static_cast<double>(event.place.x()), static_cast<double>(event.place.y()),
                  static_cast<double>(event.place.z()));
    const std::string panel = event.panel < panels.size() ? " in panel '" + panels[event.panel] + "'" : "";
    return text.data() + panel;
}

std::string counted(int count, const char* one, const char* many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace

void MotionQuality::note(const Cloth& cloth, const MovingBodyCollider& body, double seconds) {
    ++frames;
    note_stretch(cloth, seconds);
    if (!has_bad_number) note_depths(cloth, body);
}

std::vector<std::string> MotionQuality::faults(std::span<const std::string> panels) const {
    constexpr double kNoticed = 0.1;  // s, for which an overstretched triangle is seen
    std::vector<std::string> faults;
    std::array<char, 96> text{};
    if (has_bad_number) faults.emplace_back("a coordinate is no longer finite");
    if (deep_vertices > 0 || deepest_face > FaultLimits{}.face_depth) {
        std::snprintf(text.data(), text.size(), "cloth is in the body by %.1f mm at ",
                      1e3 * std::max(deepest_vertex, deepest_face));
        faults.push_back(text.data() + described(deepest, panels) +
                         "; by more than 1 mm are, summed over the frames, " +
                         counted(deep_vertices, "vertex", "vertices") + " and " + counted(deep_faces, "face", "faces"));
    }
    if (overstretched_seconds > kNoticed) {
        std::snprintf(text.data(), text.size(), "a triangle is stretched by more than 15 %% for %.2f s, until ",
                      overstretched_seconds);
        faults.push_back(text.data() + described(most_overstretched, panels));
    }
    return faults;
}

MotionQuality::Event MotionQuality::event_at(const Cloth& cloth, const LeafTriangle& face) const {
    Vec3f middle = Vec3f::Zero();
    for (const VertexId v : face.v) middle += cloth.x[v.value].head<3>() / 3;
    return {.seconds = seconds_, .place = middle, .panel = face.panel};
}

void MotionQuality::note_stretch(const Cloth& cloth, double seconds) {
    seconds_ += seconds;
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
        if (since[id] <= overstretched_seconds) continue;
        overstretched_seconds = since[id];
        most_overstretched = event_at(cloth, leaves[i]);
    }
    stretched_since_ = std::move(since);
    p99_stretch = std::max(p99_stretch, quantile(stretches, 0.99));
    max_stretch = std::max(max_stretch, quantile(stretches, 1));
}

void MotionQuality::note_depths(const Cloth& cloth, const MovingBodyCollider& body) {
    const MovingContacts& contacts = cloth.solver->contacts.moving;
    const auto pinches = [&](VertexId v) { return is_pinched(contacts, v); };
    const auto& vertices = cloth.mesh.leaf_vertices();
    pinched = std::max(pinched, static_cast<int>(std::ranges::count_if(vertices, pinches)));
    std::vector<std::uint16_t> panels(cloth.x.size(), 0);  // by vertex, of one triangle at it
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles())
        for (const VertexId v : leaf.v) panels[v.value] = leaf.panel;
    for (const VertexId v : vertices) {
        if (pinches(v)) continue;
        const auto closest = body.surface().closest(cloth.x[v.value].head<3>(), std::numeric_limits<float>::infinity());
        const float depth = closest ? -closest->distance : 0;
        if (static_cast<double>(depth) > std::max(deepest_vertex, deepest_face))
            deepest = {.seconds = seconds_, .place = cloth.x[v.value].head<3>(), .panel = panels[v.value]};
        deepest_vertex = std::max(deepest_vertex, static_cast<double>(depth));
        deep_vertices += depth > kDeep ? 1 : 0;
    }
    constexpr float kSeen = 0.0001F;  // m: flesh that comes through by so little shows as a spot, 5 mm wide on a thigh
    for (const DeepFace& face : find_penetration(cloth, body.surface(), {.depth = kSeen}).deep_faces) {
        if (std::ranges::any_of(cloth.mesh.leaf_triangles()[face.triangle].v, pinches)) continue;
        if (static_cast<double>(face.depth) > std::max(deepest_vertex, deepest_face))
            deepest = event_at(cloth, cloth.mesh.leaf_triangles()[face.triangle]);
        deepest_face = std::max(deepest_face, static_cast<double>(face.depth));
        deep_faces += face.depth > kDeep ? 1 : 0;
    }
}

}  // namespace selvedge::sim

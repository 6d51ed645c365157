#include "render/surface/lift.h"

#include <algorithm>

#include "sim/body/collider.h"

namespace selvedge {
namespace {

constexpr int kRounds = 3;      // the way out changes with the place
constexpr float kNear = 1e-5F;  // m, that is as good as on the offset surface

}  // namespace

Lift::Lift(CurvedSurface& surface, const MoveOptions& options)
    : surface_(surface), body_(options.body), offset_(options.offset) {
    if (body_ == nullptr) return;
    surface_.clear.resize(surface_.mesh.vertex_capacity());
    for (std::size_t v = 0; v < surface_.mesh.base_vertex_count(); ++v) {
        surface_.clear[v] = body_->contact(surface_.x[v].head<3>()).distance;
    }
}

// Distances change by no more than one moves: what is farther from both ends' nearest than it is from them is clear.
Vec4f Lift::lifted(const SurfacePlan::Point& point, const Vec4f& where) const {
    if (body_ == nullptr) return where;
    float& clear = surface_.clear[point.v.value];
    const auto still_clear = [&](VertexId end) {
        return surface_.clear[end.value] - (where - surface_.x[end.value]).norm();
    };
    clear = std::max(still_clear(point.a), still_clear(point.b));
    if (clear > offset_ + body_->max_error()) return where;
    Vec4f x = where;
    for (int round = 0; round < kRounds; ++round) {
        const Contact contact = body_->contact(x.head<3>());
        clear = contact.distance;
        const float lacking = offset_ - contact.distance;
        if (lacking <= kNear) break;
        x += padded(contact.normal * lacking);
        clear = offset_;
    }
    return x;
}

}  // namespace selvedge

#include "sim/cloth/body_contact.h"

#include <algorithm>

namespace selvedge::sim {

Vec3f point_of(const Carrier& carrier, const std::vector<Vec4f>& points) {
    Vec3f x = Vec3f::Zero();
    for (std::size_t k = 0; k < 3; ++k) x += carrier.shares[k] * points[carrier.vertices[k]].head<3>();
    return x;
}

void shift(const Carrier& carrier, const Vec3f& by, std::vector<Vec4f>& points) {
    float sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += points[carrier.vertices[k]].w() * carrier.shares[k] * carrier.shares[k];
    if (sum <= 0) return;
    for (std::size_t k = 0; k < 3; ++k) {
        Vec4f& x = points[carrier.vertices[k]];
        x.head<3>() += by * (x.w() * carrier.shares[k] / sum);
    }
}

MetPlane<OnePoint, Vec3f> met(const BodySide& side, const Vec3f& x, const StepShare& share) {
    const auto [normal, height] = plane_now(side.plane, x, share.end);
    const float depth = std::max(0.0F, side.offset.start + share.end * side.offset.change - height);
    return {.normal = normal,
            .depth = depth,
            .gained = std::min(depth, share.length * side.offset.change),
            .motion = share.length * side.plane.motion};
}

void push_out(const Carrier& carrier, const MetPlane<OnePoint, Vec3f>& plane, float friction_scale,
              std::vector<Vec4f>& points, std::vector<Vec4f>& before) {
    if (plane.depth <= 0) return;
    const Vec3f x = point_of(carrier, points), from = point_of(carrier, before);
    shift(carrier, plane.normal * plane.gained, before);
    shift(carrier, projected(x, from, plane, carrier.friction * friction_scale) - x, points);
}

void set_side(MovingSideBlock& block, std::size_t slot, const BodySide& side) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::ptrdiff_t>(axis);
        block.start.point[axis][slot] = side.plane.point[i];
        block.start.normal[axis][slot] = side.plane.normal[i];
        block.motion[axis][slot] = side.plane.motion[i];
        block.turn[axis][slot] = side.plane.turn[i];
    }
    block.start.height[slot] = -side.offset.start;
    block.rise[slot] = side.offset.change;
}

void clear_side(MovingSideBlock& block, std::size_t slot) {
    set_side(block, slot, {.plane = {.point = Vec3f(0, -kFarAway, 0), .normal = Vec3f::UnitY()}});
}

}  // namespace selvedge::sim

#include "sim/selfcontact/expected_paths.h"

#include <algorithm>
#include <cmath>

namespace selvedge::sim {

template <class Position>
Vec3f ExpectedPaths::mean_of(const Position& position) const {
    Vec4f sum = Vec4f::Zero();
    for (const std::uint32_t v : vertices_) sum += position(v);
    return sum.head<3>() / static_cast<float>(std::max<std::size_t>(1, vertices_.size()));
}

void ExpectedPaths::start(std::span<const std::uint32_t> vertices, const MovingPoints& points) {
    vertices_.assign(vertices.begin(), vertices.end());
    starts_.resize(points.count);
    moves_.assign(points.count + 1, Vec4f::Zero());
    deviations_.assign(points.count, 0);
    first_mean_ = mean_of([&](std::uint32_t v) { return points.wide_at(v); });
    mean_move_ = mean_of([&](std::uint32_t v) -> Vec4f { return points.wide_at(v) - points.wide_was_at(v); });
    for (const std::uint32_t v : vertices_) start_one(v, Vec3f::Zero(), points);
    mark(points);
}

void ExpectedPaths::restart(std::span<const std::uint8_t> stays, const MovingPoints& points) {
    const Vec3f origin = frame(points);
    mean_move_ = mean_of([&](std::uint32_t v) -> Vec4f { return points.wide_at(v) - points.wide_was_at(v); });
    for (const std::uint32_t v : vertices_) {
        if (stays[v] == 0) start_one(v, origin, points);
    }
}

void ExpectedPaths::start_one(std::uint32_t vertex, const Vec3f& frame, const MovingPoints& points) {
    starts_[vertex] = with_zero_w(points.at(vertex) - frame);
    moves_[vertex] = with_zero_w(points.at(vertex) - points.was_at(vertex) - mean_move_);
}

Vec3f ExpectedPaths::frame(const MovingPoints& points) const {
    return mean_of([&](std::uint32_t v) { return points.wide_at(v); }) - first_mean_;
}

void ExpectedPaths::mark(const MovingPoints& points) {
    marks_.resize(points.count);
    const Vec4f origin = with_zero_w(frame(points));
    for (const std::uint32_t v : vertices_) marks_[v] = points.wide_at(v) - origin;
}

ExpectedPaths::Distances ExpectedPaths::measure(const MovingPoints& points, float ahead) {
    const auto position = [&](std::uint32_t v) -> Vec4f {
        const Vec4f now = points.wide_at(v);
        return now + (now - points.wide_was_at(v)) * ahead;
    };
    const Vec4f frame = with_zero_w(mean_of(position) - first_mean_);
    float farthest_off = 0, farthest_moved = 0;
    for (const std::uint32_t v : vertices_) {
        const Vec4f at = position(v) - frame, moved = at - starts_[v], move = moves_[v];
        const float along = moved.dot(move) / std::max(1e-20F, move.squaredNorm());
        deviations_[v] = (moved - move * std::clamp(along, 0.0F, substeps_)).squaredNorm();
        farthest_off = std::max(farthest_off, deviations_[v]);
        farthest_moved = std::max(farthest_moved, (at - marks_[v]).squaredNorm());
    }
    return {.off_path = std::sqrt(farthest_off), .from_mark = std::sqrt(farthest_moved)};
}

Sweep ExpectedPaths::sweep(const MovingPoints& points) const {
    constexpr float kToSpare = 1.2F;
    const Vec3f origin = frame(points);
    return {.moves = moves_.front().data(),
            .substeps = kToSpare * substeps_,
            .frame = {origin.x(), origin.y(), origin.z()}};
}

}  // namespace selvedge::sim

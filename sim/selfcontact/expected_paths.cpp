#include "sim/selfcontact/expected_paths.h"

#include <algorithm>
#include <cmath>

namespace selvedge::sim {

template <class Position>
Vec3f ExpectedPaths::mean_of(const Position& position) const {
    Vec3f sum = Vec3f::Zero();
    for (const std::uint32_t v : vertices_) sum += position(v);
    return vertices_.empty() ? sum : Vec3f(sum / static_cast<float>(vertices_.size()));
}

void ExpectedPaths::start(std::span<const std::uint32_t> vertices, const MovingPoints& points) {
    vertices_.assign(vertices.begin(), vertices.end());
    starts_.resize(points.count);
    moves_.assign(points.count + 1, Vec4f::Zero());
    deviations_.assign(points.count, 0);
    first_mean_ = mean_of([&](std::uint32_t v) { return points.at(v); });
    mean_move_ = mean_of([&](std::uint32_t v) -> Vec3f { return points.at(v) - points.was_at(v); });
    for (const std::uint32_t v : vertices_) start_one(v, Vec3f::Zero(), points);
    mark(points);
}

void ExpectedPaths::restart(std::span<const std::uint8_t> stays, const MovingPoints& points) {
    const Vec3f origin = frame(points);
    mean_move_ = mean_of([&](std::uint32_t v) -> Vec3f { return points.at(v) - points.was_at(v); });
    for (const std::uint32_t v : vertices_) {
        if (stays[v] == 0) start_one(v, origin, points);
    }
}

void ExpectedPaths::start_one(std::uint32_t vertex, const Vec3f& frame, const MovingPoints& points) {
    starts_[vertex] = with_zero_w(points.at(vertex) - frame);
    moves_[vertex] = with_zero_w(points.at(vertex) - points.was_at(vertex) - mean_move_);
}

Vec3f ExpectedPaths::frame(const MovingPoints& points) const {
    return mean_of([&](std::uint32_t v) { return points.at(v); }) - first_mean_;
}

void ExpectedPaths::mark(const MovingPoints& points) {
    marks_.resize(points.count);
    const Vec3f origin = frame(points);
    for (const std::uint32_t v : vertices_) marks_[v] = with_zero_w(points.at(v) - origin);
}

ExpectedPaths::Distances ExpectedPaths::measure(const MovingPoints& points, float ahead) {
    const auto position = [&](std::uint32_t v) -> Vec3f {
        const Vec3f now = points.at(v);
        return now + (now - points.was_at(v)) * ahead;
    };
    const Vec3f frame = mean_of(position) - first_mean_;
    float farthest_off = 0, farthest_moved = 0;
    for (const std::uint32_t v : vertices_) {
        const Vec3f at = position(v) - frame, moved = at - starts_[v].head<3>(), move = moves_[v].head<3>();
        const float along = moved.dot(move) / std::max(1e-20F, move.squaredNorm());
        deviations_[v] = (moved - move * std::clamp(along, 0.0F, substeps_)).squaredNorm();
        farthest_off = std::max(farthest_off, deviations_[v]);
        farthest_moved = std::max(farthest_moved, (at - marks_[v].head<3>()).squaredNorm());
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

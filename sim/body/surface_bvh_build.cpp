#include "sim/body/surface_bvh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/core/assert.h"

namespace selvedge {

namespace {

constexpr double kNoArea = 1e-30;  // m^4, the square of twice a triangle's area

// Which triangles lie at an undirected edge: sorted, so that equal edges are neighbours.
struct EdgeUse {
    std::uint32_t low;
    std::uint32_t high;
    std::uint32_t triangle;
    std::uint32_t side;
    auto operator<=>(const EdgeUse&) const = default;
};

std::vector<EdgeUse> sorted_edges(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    std::vector<EdgeUse> uses;
    uses.reserve(triangles.size() * 3);
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        for (std::uint32_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
            uses.push_back({low, high, t, k});
        }
    std::sort(uses.begin(), uses.end());
    return uses;
}

double corner_angle(const Vec3d& at, const Vec3d& left, const Vec3d& right) {
    const Vec3d a = left - at;
    const Vec3d b = right - at;
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

Vec3f as_unit(const Vec3d& v) {
    return v.stableNormalized().cast<float>();
}

}  // namespace

// Splits the triangles in halves along the longest axis of their centroids, twice per node; every packet but the last
// is full.
struct SurfaceBvh::Builder {
    static constexpr std::size_t kInPacket = TrianglePacket::kLanes;

    SurfaceBvh& bvh;
    std::vector<Vec3f> centroids;
    std::vector<std::uint32_t> order;

    struct Range {
        std::size_t first;
        std::size_t last;
        std::size_t size() const { return last - first; }
    };

    std::size_t split(Range range) {
        Eigen::AlignedBox3f box;
        for (std::size_t i = range.first; i < range.last; ++i) box.extend(centroids[order[i]]);
        int axis = 0;
        box.sizes().maxCoeff(&axis);
        const std::size_t packets = (range.size() + kInPacket - 1) / kInPacket;
        const std::size_t middle = range.first + (packets / 2) * kInPacket;
        const auto begin = order.begin();
        std::nth_element(begin + std::ptrdiff_t(range.first), begin + std::ptrdiff_t(middle),
                         begin + std::ptrdiff_t(range.last), [&](std::uint32_t i, std::uint32_t j) {
                             const float a = centroids[i][axis];
                             const float b = centroids[j][axis];
                             return a != b ? a < b : i < j;
                         });
        return middle;
    }

    std::vector<Range> children_of(Range range) {
        std::vector<Range> halves{range};
        for (int round = 0; round < 2; ++round) {
            std::vector<Range> next;
            for (const Range& half : halves) {
                if (half.size() <= kInPacket) {
                    next.push_back(half);
                    continue;
                }
                const std::size_t middle = split(half);
                next.push_back({half.first, middle});
                next.push_back({middle, half.last});
            }
            halves = std::move(next);
        }
        return halves;
    }

    std::int32_t add_packet(Range range, Eigen::AlignedBox3f& box) {
        const std::span<const std::uint32_t> chosen(&order[range.first], range.size());
        for (const std::uint32_t t : chosen)
            for (const std::uint32_t v : bvh.triangles_[t]) box.extend(bvh.x_[v]);
        bvh.packets_.push_back(make_packet(bvh.x_, bvh.triangles_, chosen));
        return ~std::int32_t(bvh.packets_.size() - 1);
    }

    std::int32_t add_node(Range range, Eigen::AlignedBox3f& box) {
        const std::size_t index = bvh.nodes_.size();
        bvh.nodes_.emplace_back();
        Node node{};
        node.child.fill(kNoChild);
        for (auto& low : node.low) low.fill(std::numeric_limits<float>::infinity());  // spare children are far away
        std::size_t k = 0;
        for (const Range& part : children_of(range)) {
            Eigen::AlignedBox3f child_box;
            node.child[k] = part.size() <= kInPacket ? add_packet(part, child_box) : add_node(part, child_box);
            for (int axis = 0; axis < 3; ++axis) {
                node.low[std::size_t(axis)][k] = child_box.min()[axis];
                node.high[std::size_t(axis)][k] = child_box.max()[axis];
            }
            box.extend(child_box);
            ++k;
        }
        bvh.nodes_[index] = node;
        return std::int32_t(index);
    }
};

SurfaceBvh::SurfaceBvh(const Body& body) {
    x_.reserve(body.x.size());
    for (const Vec3d& p : body.x) {
        SELVEDGE_ASSERT(p.allFinite());
        x_.push_back(p.cast<float>());
    }
    Builder builder{*this, {}, {}};
    for (const std::array<int, 3>& triangle : body.triangles) {
        std::array<std::uint32_t, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k) {
            SELVEDGE_ASSERT(triangle[k] >= 0 && std::size_t(triangle[k]) < x_.size());
            corners[k] = std::uint32_t(triangle[k]);
        }
        triangles_.push_back(corners);
    }
    make_normals(body);
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
        const auto [a, b, c] = triangles_[t];
        builder.centroids.emplace_back((x_[a] + x_[b] + x_[c]) / 3.0F);
        if (has_area(t)) builder.order.push_back(t);
    }
    if (builder.order.empty()) return;
    Eigen::AlignedBox3f box;
    builder.add_node({0, builder.order.size()}, box);
    low_ = box.min();
    high_ = box.max();
}

// Baerentzen and Aanaes, "Signed distance computation using the angle weighted pseudonormal", 2005.
void SurfaceBvh::make_normals(const Body& body) {
    std::vector<Vec3d> at_vertex(x_.size(), Vec3d::Zero());
    std::vector<Vec3d> at_face(triangles_.size(), Vec3d::Zero());
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
        const auto& corners = triangles_[t];
        const Vec3d area = (body.x[corners[1]] - body.x[corners[0]]).cross(body.x[corners[2]] - body.x[corners[0]]);
        if (area.squaredNorm() < kNoArea) continue;
        at_face[t] = area.stableNormalized();
        for (std::size_t k = 0; k < 3; ++k)
            at_vertex[corners[k]] += at_face[t] * corner_angle(body.x[corners[k]], body.x[corners[(k + 1) % 3]],
                                                               body.x[corners[(k + 2) % 3]]);
    }
    for (const Vec3d& normal : at_face) face_normals_.push_back(normal.cast<float>());
    for (const Vec3d& normal : at_vertex) vertex_normals_.push_back(as_unit(normal));

    edge_normals_.resize(triangles_.size());
    const std::vector<EdgeUse> uses = sorted_edges(triangles_);
    for (std::size_t first = 0; first < uses.size();) {
        std::size_t last = first;
        Vec3d sum = Vec3d::Zero();
        for (; last < uses.size() && uses[last].low == uses[first].low && uses[last].high == uses[first].high; ++last)
            sum += at_face[uses[last].triangle];
        for (; first < last; ++first) edge_normals_[uses[first].triangle][uses[first].side] = as_unit(sum);
    }
}

}  // namespace selvedge

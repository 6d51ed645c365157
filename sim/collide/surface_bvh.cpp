#include "sim/collide/surface_bvh.h"

#include <immintrin.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "sim/core/assert.h"
#include "sim/core/edge_table.h"
#include "sim/core/simd_level.h"

namespace selvedge::sim {
namespace {

constexpr float kTiny = 1e-30F;  // keeps quotients finite for slivers

}  // namespace

TrianglePoint closest_on_triangle(const Vec3f& p, const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    const Vec3f ab = b - a;
    const Vec3f ac = c - a;
    const float d1 = ab.dot(p - a);
    const float d2 = ac.dot(p - a);
    if (d1 <= 0 && d2 <= 0) return {a, 4};
    const float d3 = ab.dot(p - b);
    const float d4 = ac.dot(p - b);
    if (d3 >= 0 && d4 <= d3) return {b, 5};
    const float vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return {a + ab * (d1 / std::max(d1 - d3, kTiny)), 1};
    const float d5 = ab.dot(p - c);
    const float d6 = ac.dot(p - c);
    if (d6 >= 0 && d5 <= d6) return {c, 6};
    const float vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return {a + ac * (d2 / std::max(d2 - d6, kTiny)), 3};
    const float va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 >= d3 && d5 >= d6) return {b + (c - b) * ((d4 - d3) / std::max(d4 - d3 + d5 - d6, kTiny)), 2};
    const float scale = 1 / std::max(va + vb + vc, kTiny);
    return {a + ab * (vb * scale) + ac * (vc * scale), 0};
}

std::array<float, 3> barycentric(const Vec3f& p, const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    const Vec3f ab = b - a, ac = c - a, ap = p - a;
    const float bb = ab.squaredNorm(), bc = ab.dot(ac), cc = ac.squaredNorm(), pb = ap.dot(ab), pc = ap.dot(ac);
    const float determinant = bb * cc - bc * bc;
    if (determinant <= 0) return {1, 0, 0};
    const float u = (cc * pb - bc * pc) / determinant, v = (bb * pc - bc * pb) / determinant;
    return {1 - u - v, u, v};
}

Vec3f SurfaceBvh::face_normal(std::uint32_t triangle) const {
    if (!adjacency_) return face_normals_[triangle];
    const auto [a, b, c] = triangles_[triangle];
    const Vec3f area = (x_[b] - x_[a]).cross(x_[c] - x_[a]);
    const float squared = area.squaredNorm();
    return squared > kTiny ? Vec3f(area / std::sqrt(squared)) : Vec3f::Zero();
}

Vec3f SurfaceBvh::pseudo_normal(std::uint32_t triangle, int feature) const {
    if (feature == 0) return face_normal(triangle);
    if (feature <= 3) {
        const std::size_t side = std::size_t(feature - 1);
        return adjacency_ ? moved_edge_normal(triangle, side) : edge_normals_[triangle][side];
    }
    const std::uint32_t vertex = triangles_[triangle][std::size_t(feature - 4)];
    return adjacency_ ? moved_vertex_normal(vertex) : vertex_normals_[vertex];
}

Vec3f SurfaceBvh::moved_edge_normal(std::uint32_t triangle, std::size_t side) const {
    return (face_normal(triangle) + face_normal(adjacency_->beside[triangle][side])).stableNormalized();
}

Vec3f SurfaceBvh::moved_vertex_normal(std::uint32_t vertex) const {
    Vec3f sum = Vec3f::Zero();
    for (std::uint32_t i = adjacency_->first[vertex]; i < adjacency_->first[vertex + 1]; ++i) {
        const std::uint32_t t = adjacency_->round[i];
        const std::array<std::uint32_t, 3>& corners = triangles_[t];
        const std::size_t k = std::size_t(std::ranges::find(corners, vertex) - corners.begin());
        const Vec3f left = x_[corners[(k + 1) % 3]] - x_[vertex], right = x_[corners[(k + 2) % 3]] - x_[vertex];
        sum += std::atan2(left.cross(right).norm(), left.dot(right)) * face_normal(t);
    }
    return sum.stableNormalized();
}

NearestTriangle SurfaceBvh::distance_to(std::uint32_t triangle, const Vec3f& p) const {
    const auto [a, b, c] = triangles_[triangle];
    return {.squared = (closest_on_triangle(p, x_[a], x_[b], x_[c]).point - p).squaredNorm(), .triangle = triangle};
}

ClosestPoint SurfaceBvh::closest_on(std::uint32_t triangle, const Vec3f& p) const {
    const auto [a, b, c] = triangles_[triangle];
    const TrianglePoint on = closest_on_triangle(p, x_[a], x_[b], x_[c]);
    const Vec3f outward = pseudo_normal(triangle, on.feature);
    const Vec3f offset = p - on.point;
    const float length = offset.norm();
    const float sign = offset.dot(outward) < 0 ? -1.0F : 1.0F;
    constexpr float kOnSurface = 1e-6F;  // m, below this the offset's direction is rounding error
    const Vec3f normal = length > kOnSurface ? Vec3f(offset * (sign / length)) : outward;
    return {.point = on.point, .normal = normal, .distance = sign * length, .triangle = triangle};
}

namespace {

constexpr std::size_t kStack = 128;  // 4 children per node, 2^32 triangles have 15 levels

// Squared distances to the children's boxes, and a bit for each child whose squared distance is below `limit`.
struct BoxDistances {
    std::array<float, 4> squared;
    unsigned nearer;
};

// Distances from the box low..high, which is a point when low equals high.
template <class Node>
BoxDistances box_distances(const Node& node, const Vec3f& low, const Vec3f& high, float limit) {
    __m128 sum = _mm_setzero_ps();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto a = std::ptrdiff_t(axis);
        const __m128 below = _mm_sub_ps(_mm_loadu_ps(node.low[axis].data()), _mm_set1_ps(high[a]));
        const __m128 above = _mm_sub_ps(_mm_set1_ps(low[a]), _mm_loadu_ps(node.high[axis].data()));
        const __m128 out = _mm_max_ps(_mm_setzero_ps(), _mm_max_ps(below, above));  // propagates NaN
        sum = _mm_add_ps(sum, _mm_mul_ps(out, out));
    }
    BoxDistances boxes;
    _mm_storeu_ps(boxes.squared.data(), sum);
    boxes.nearer = unsigned(_mm_movemask_ps(_mm_cmplt_ps(sum, _mm_set1_ps(limit))));
    return boxes;
}

struct StackEntry {
    float key;           // squared distance to its box; for a ray the entry fraction
    std::int32_t child;  // a node, or ~packet
    std::int32_t place;  // index of its box: node * 4 + child
};

// A stack on which a node's children are sorted, nearest on top.
struct NearFirstStack {
    std::array<StackEntry, kStack> entries;
    std::size_t size = 0;

    void push(std::size_t bottom, StackEntry entry) {
        std::size_t k = size++;
        for (; k > bottom && entries[k - 1].key < entry.key; --k) entries[k] = entries[k - 1];
        entries[k] = entry;
    }

    template <class Node>
    void push_nearer(const Node& node, std::int32_t index, const BoxDistances& boxes) {
        const std::size_t bottom = size;
        for (unsigned nearer = boxes.nearer; nearer != 0; nearer &= nearer - 1) {
            const std::size_t k = std::size_t(std::countr_zero(nearer));
            push(bottom, {boxes.squared[k], node.child[k], index * 4 + std::int32_t(k)});
        }
    }
};

}  // namespace

std::size_t SurfaceBvh::bytes() const {
    const auto size_of = [](const auto& list) { return list.size() * sizeof(list[0]); };
    return size_of(nodes_) + size_of(packets_) + size_of(x_) + size_of(triangles_) + size_of(face_normals_) +
           size_of(vertex_normals_) + size_of(edge_normals_);
}

std::optional<ClosestPoint> SurfaceBvh::closest(const Vec3f& p, float radius) const {
    if (nodes_.empty() || !(radius >= 0)) return std::nullopt;
    NearestTriangle best;
    // Slightly enlarged, so that a point at exactly the radius is found.
    best.squared = radius * radius * 1.000002F + kTiny;
    const Vec3f in_boxes = p - shift_;
    NearFirstStack stack;
    stack.push(0, {0, 0, 0});
    while (stack.size > 0) {
        const StackEntry top = stack.entries[--stack.size];
        if (top.key >= best.squared) continue;
        if (top.child < 0) {
            best.test(*kernels_, packets_[std::size_t(~top.child)], p);
            continue;
        }
        const Node& node = nodes_[std::size_t(top.child)];
        stack.push_nearer(node, top.child, box_distances(node, in_boxes, in_boxes, best.squared));
    }
    if (!best.found()) return std::nullopt;
    return closest_on(best.triangle, p);
}

// Low and high corner of a child's box.
std::array<float, 6> SurfaceBvh::box_at(std::int32_t place) const {
    const Node& node = nodes_[std::size_t(place / kChildren)];
    const std::size_t k = std::size_t(place % kChildren);
    return {node.low[0][k] + shift_.x(),  node.low[1][k] + shift_.y(),  node.low[2][k] + shift_.z(),
            node.high[0][k] + shift_.x(), node.high[1][k] + shift_.y(), node.high[2][k] + shift_.z()};
}

std::optional<std::uint32_t> SurfaceBvh::nearest_facing(const Vec3f& p, const Vec3f& normal, const CosineRange& cosines,
                                                        float radius) const {
    if (nodes_.empty()) return std::nullopt;
    std::optional<std::uint32_t> best;
    float limit = radius * radius;
    const Vec3f in_boxes = p - shift_;
    NearFirstStack stack;
    stack.push(0, {0, 0, 0});
    while (stack.size > 0) {
        const StackEntry top = stack.entries[--stack.size];
        if (top.key >= limit) continue;
        if (top.child >= 0) {
            const Node& node = nodes_[std::size_t(top.child)];
            stack.push_nearer(node, top.child, box_distances(node, in_boxes, in_boxes, limit));
            continue;
        }
        const TrianglePacket& packet = packets_[std::size_t(~top.child)];
        TrianglePacket::Lanes squares;
        unsigned nearer = kernels_->squared_distances(packet.corner[0].data(), p.data(), limit, squares.data());
        for (; nearer != 0; nearer &= nearer - 1) {
            const std::size_t i = std::size_t(std::countr_zero(nearer));
            if (squares[i] >= limit) continue;
            const float cosine = face_normal(packet.triangle[i]).dot(normal);
            if (cosine < cosines.least || cosine > cosines.most) continue;
            limit = squares[i];
            best = packet.triangle[i];
        }
    }
    return best;
}

void SurfaceBvh::find_nearest(PointGroup& group, float reach) const {
    if (nodes_.empty()) return;
    Vec3f low = group.point(0);
    Vec3f high = low;
    for (std::size_t i = 1; i < PointGroup::kPoints; ++i) {
        low = low.cwiseMin(group.point(i));
        high = high.cwiseMax(group.point(i));
    }
    low -= shift_;
    high -= shift_;
    const float reach_squared = reach * reach;
    float farthest = std::min(reach_squared, *std::max_element(group.squared.begin(), group.squared.end()));
    NearFirstStack stack;
    stack.push(0, {0, 0, 0});
    while (stack.size > 0) {
        const StackEntry top = stack.entries[--stack.size];
        if (top.key >= farthest) continue;
        if (top.child < 0) {
            const TrianglePacket& packet = packets_[std::size_t(~top.child)];
            const std::array<float, 6> box = box_at(top.place);
            farthest =
                std::min(reach_squared, kernels_->nearest_in_packet(packet.corner[0].data(), packet.triangle.data(),
                                                                    box.data(), group.x.data(), group.triangle.data()));
            continue;
        }
        const Node& node = nodes_[std::size_t(top.child)];
        stack.push_nearer(node, top.child, box_distances(node, low, high, farthest));
    }
}

namespace {

struct Ray {
    Vec3f origin;
    Vec3f along;
};

// Fraction (0..1) at which the segment enters the box; infinite when it misses.
template <class Node>
float entry_fraction(const Node& node, std::size_t k, const Ray& ray) {
    float enter = 0;
    float leave = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const float origin = ray.origin[std::ptrdiff_t(axis)];
        const float along = ray.along[std::ptrdiff_t(axis)];
        if (along == 0) {
            if (origin < node.low[axis][k] || origin > node.high[axis][k])
                return std::numeric_limits<float>::infinity();
            continue;
        }
        const float a = (node.low[axis][k] - origin) / along;
        const float b = (node.high[axis][k] - origin) / along;
        enter = std::max(enter, std::min(a, b) - 1e-6F);
        leave = std::min(leave, std::max(a, b) + 1e-6F);
    }
    return enter <= leave ? enter : std::numeric_limits<float>::infinity();
}

}  // namespace

std::optional<float> crossing_fraction(const std::array<Vec3f, 2>& segment, const Vec3f& a, const Vec3f& b,
                                       const Vec3f& c) {
    const Vec3d along = Vec3f(segment[1] - segment[0]).cast<double>();
    const Vec3d edge1 = b.cast<double>() - a.cast<double>();
    const Vec3d edge2 = c.cast<double>() - a.cast<double>();
    const Vec3d p = along.cross(edge2);
    const double det = edge1.dot(p);
    if (det == 0) return std::nullopt;
    const Vec3d s = segment[0].cast<double>() - a.cast<double>();
    const double u = s.dot(p) / det;
    const Vec3d q = s.cross(edge1);
    const double v = along.dot(q) / det;
    const double t = edge2.dot(q) / det;
    constexpr double kSlack = 1e-9;
    if (u < -kSlack || v < -kSlack || u + v > 1 + kSlack || t < 0 || t > 1) return std::nullopt;
    return float(t);
}

std::optional<SurfaceHit> SurfaceBvh::first_hit(const Vec3f& from, const Vec3f& to) const {
    if (nodes_.empty()) return std::nullopt;
    const Ray ray{from, to - from}, in_boxes{from - shift_, to - from};
    std::optional<SurfaceHit> hit;
    NearFirstStack stack;
    stack.push(0, {0, 0, 0});
    while (stack.size > 0) {
        const StackEntry top = stack.entries[--stack.size];
        if (hit && top.key > hit->fraction) continue;
        if (top.child >= 0) {
            const Node& node = nodes_[std::size_t(top.child)];
            const std::size_t bottom = stack.size;
            for (std::size_t k = 0; k < kChildren; ++k) {
                if (node.child[k] == kNoChild) continue;
                const float enter = entry_fraction(node, k, in_boxes);
                if (enter <= 1) stack.push(bottom, {enter, node.child[k], 0});
            }
            continue;
        }
        for (const std::uint32_t t : packets_[std::size_t(~top.child)].triangle) {
            const auto [a, b, c] = triangles_[t];
            const std::optional<float> fraction = crossing_fraction({from, to}, x_[a], x_[b], x_[c]);
            if (fraction && (!hit || *fraction < hit->fraction))
                hit = SurfaceHit{from + ray.along * *fraction, face_normal(t), *fraction, t};
        }
    }
    return hit;
}

namespace {

constexpr double kNoArea = 1e-30;  // m^4, the square of twice a triangle's area

double corner_angle(const Vec3d& at, const Vec3d& left, const Vec3d& right) {
    const Vec3d a = left - at;
    const Vec3d b = right - at;
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

Vec3f as_unit(const Vec3d& v) {
    return v.stableNormalized().cast<float>();
}

}  // namespace

// Splits each node's triangles twice in halves, along the longest axis of their centroids; every packet but the last is
// full.
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
        for (int iteration = 0; iteration < 2; ++iteration) {
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
        for (auto& low : node.low) low.fill(std::numeric_limits<float>::infinity());  // unused children are at infinity
        for (auto& high : node.high) high.fill(-std::numeric_limits<float>::infinity());
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

// Angle-weighted pseudonormals (Baerentzen and Aanaes, "Signed distance computation using the angle weighted
// pseudonormal", 2005).
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
    const EdgeTable<std::uint32_t> table(triangles_);
    for (const auto edge : table.edges()) {
        Vec3d sum = Vec3d::Zero();
        for (const auto& side : edge) sum += at_face[side.triangle];
        for (const auto& side : edge) edge_normals_[side.triangle][side.k] = as_unit(sum);
    }
}

// Pre: the surface is closed.
void SurfaceBvh::make_adjacency() {
    Adjacency& adjacency = adjacency_.emplace();
    adjacency.beside.resize(triangles_.size());
    const EdgeTable<std::uint32_t> table(triangles_);
    for (const auto edge : table.edges()) {
        for (std::size_t i = 0; i < edge.size(); ++i) {
            const std::size_t other = i + 1 < edge.size() ? i + 1 : i > 0 ? i - 1 : i;
            adjacency.beside[edge[i].triangle][edge[i].k] = edge[other].triangle;
        }
    }
    adjacency.first.assign(x_.size() + 1, 0);
    for (const auto& corners : triangles_)
        for (const std::uint32_t v : corners) ++adjacency.first[v + 1];
    for (std::size_t v = 0; v < x_.size(); ++v) adjacency.first[v + 1] += adjacency.first[v];
    adjacency.round.resize(3 * triangles_.size());
    std::vector<std::uint32_t> next = adjacency.first;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
        for (const std::uint32_t v : triangles_[t]) adjacency.round[next[v]++] = t;
}

std::uint32_t SurfaceBvh::walk_nearest(std::uint32_t from, const Vec3f& p, const Vec3f& normal,
                                       const CosineRange& cosines) const {
    const auto squared = [&](std::uint32_t triangle) {
        const auto [a, b, c] = triangles_[triangle];
        return (closest_on_triangle(p, x_[a], x_[b], x_[c]).point - p).squaredNorm();
    };
    std::uint32_t best = from;
    float least = squared(from);
    for (bool is_nearer = true; is_nearer;) {
        is_nearer = false;
        for (const std::uint32_t corner : triangles_[best]) {
            for (std::uint32_t i = adjacency_->first[corner]; i < adjacency_->first[corner + 1]; ++i) {
                const float distance = squared(adjacency_->round[i]);
                if (distance >= least) continue;
                const float cosine = face_normal(adjacency_->round[i]).dot(normal);
                if (cosine < cosines.least || cosine > cosines.most) continue;
                least = distance;
                best = adjacency_->round[i];
                is_nearer = true;
            }
            if (is_nearer) break;
        }
    }
    return best;
}

// One after the last node, and after the last packet, of a subtree: both follow each other in the order of the tree.
std::array<std::size_t, 2> SurfaceBvh::ends_of_subtree(std::size_t node) const {
    std::array<std::size_t, 2> ends{node + 1, 0};
    for (const std::int32_t child : nodes_[node].child) {
        if (child == kNoChild) continue;
        const std::array<std::size_t, 2> below =
            child < 0 ? std::array{node + 1, std::size_t(~child) + 1} : ends_of_subtree(std::size_t(child));
        ends = {std::max(ends[0], below[0]), std::max(ends[1], below[1])};
    }
    return ends;
}

void SurfaceBvh::make_parts() {
    constexpr std::size_t kMostPackets = 64;  // in a part
    std::vector<std::uint32_t> seen_by(x_.size(), std::numeric_limits<std::uint32_t>::max());
    std::vector<std::size_t> waiting{0};
    while (!waiting.empty()) {
        const std::size_t node = waiting.back();
        waiting.pop_back();
        const auto [last_node, last_packet] = ends_of_subtree(node);
        std::size_t first = node;  // down to the first packet
        while (nodes_[first].child[0] >= 0) first = std::size_t(nodes_[first].child[0]);
        const std::size_t first_packet = std::size_t(~nodes_[first].child[0]);
        if (node == 0 || last_packet - first_packet > kMostPackets) {
            upper_nodes_.push_back(node);
            for (const std::int32_t child : nodes_[node].child)
                if (child != kNoChild && child >= 0) waiting.push_back(std::size_t(child));
            continue;
        }
        Part part{.first_node = node, .last_node = last_node, .first_packet = first_packet, .last_packet = last_packet};
        const auto number = std::uint32_t(parts_.size());
        for (std::size_t i = first_packet; i < last_packet; ++i)
            for (const std::uint32_t triangle : packets_[i].triangle)
                for (const std::uint32_t v : triangles_[triangle])
                    if (std::exchange(seen_by[v], number) != number) part.vertices.push_back(v);
        parts_.push_back(std::move(part));
    }
    std::ranges::sort(upper_nodes_);
}

void SurfaceBvh::sweep_part(Part& part, const Region& region) {
    Eigen::AlignedBox3f box;
    for (const std::uint32_t v : part.vertices) box.extend(x_[v]).extend(Vec3f(end_[v] - drift_));
    if (!region.meets(box)) {
        constexpr float kFar = std::numeric_limits<float>::infinity();
        for (auto& low : nodes_[part.first_node].low) low.fill(kFar);
        for (auto& high : nodes_[part.first_node].high) high.fill(-kFar);
        part.has_packets = false;
        return;
    }
    if (!part.has_packets) {
        for (std::size_t i = part.first_packet; i < part.last_packet; ++i)
            packets_[i] = make_packet(x_, triangles_, packets_[i].triangle);
        part.has_packets = true;
    }
    for (std::size_t i = part.last_node; i-- > part.first_node;)
        sweep_node(nodes_[i]);  // children follow their parents
}

Vec3f SurfaceBvh::drift_to(std::span<const Vec3f> end) const {
    Vec3d sum = Vec3d::Zero();
    for (std::size_t v = 0; v < x_.size(); ++v) sum += (end[v] - x_[v]).cast<double>();
    return (sum / std::max(1.0, double(x_.size()))).cast<float>();
}

void SurfaceBvh::sweep_to(std::span<const Vec3f> end, const Region& region) {
    SELVEDGE_ASSERT(end.size() == x_.size());
    if (!adjacency_) {
        make_adjacency();
        end_packets_ = packets_;
        if (!nodes_.empty()) make_parts();
    }
    end_.assign(end.begin(), end.end());
    drift_ = drift_to(end);
    shift_ = Vec3f::Zero();
    if (nodes_.empty()) return;
    Eigen::AlignedBox3f whole;
    for (std::size_t v = 0; v < x_.size(); ++v) whole.extend(x_[v]).extend(Vec3f(end_[v] - drift_));
    low_ = whole.min();
    high_ = whole.max();
    for (Part& part : parts_) sweep_part(part, region);
    for (std::size_t i = upper_nodes_.size(); i-- > 0;) sweep_node(nodes_[upper_nodes_[i]]);
}

void SurfaceBvh::arrive() {
    x_.swap(end_);
    packets_.swap(end_packets_);
    shift_ = drift_;
    low_ += shift_;
    high_ += shift_;
    drift_ = Vec3f::Zero();
}

// The boxes hold the triangles where they are, and where they will be less the drift.
void SurfaceBvh::sweep_node(Node& node) {
    for (std::size_t k = 0; k < kChildren; ++k) {
        const std::int32_t child = node.child[k];
        if (child == kNoChild) continue;
        std::array<float, 6> box{};  // low, high
        if (child < 0) {
            const std::size_t packet = std::size_t(~child);
            kernels_->sweep_packet(packets_[packet].corner[0].data(), packets_[packet].triangle.data(),
                                   triangles_.front().data(), end_.front().data(), drift_.data(),
                                   end_packets_[packet].corner[0].data(), box.data());
        } else {
            const Node& below = nodes_[std::size_t(child)];
            for (std::size_t axis = 0; axis < 3; ++axis) {
                box[axis] = std::ranges::min(below.low[axis]);
                box[axis + 3] = std::ranges::max(below.high[axis]);
            }
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            node.low[axis][k] = box[axis];
            node.high[axis][k] = box[axis + 3];
        }
    }
}

// Kernels address a packet as nine rows of floats, and a group as four.
static_assert(offsetof(TrianglePacket, triangle) == 9 * sizeof(TrianglePacket::Lanes));
static_assert(offsetof(PointGroup, triangle) == 4 * PointGroup::kPoints * sizeof(float));

TrianglePacket make_packet(std::span<const Vec3f> points, std::span<const std::array<std::uint32_t, 3>> triangles,
                           std::span<const std::uint32_t> chosen) {
    SELVEDGE_ASSERT(!chosen.empty() && chosen.size() <= TrianglePacket::kLanes);
    TrianglePacket packet{};
    for (std::size_t lane = 0; lane < TrianglePacket::kLanes; ++lane) {
        packet.triangle[lane] = chosen[std::min(lane, chosen.size() - 1)];
        const auto [a, b, c] = triangles[packet.triangle[lane]];
        const Vec3f edge1 = points[b] - points[a];
        const Vec3f edge2 = points[c] - points[a];
        for (int axis = 0; axis < 3; ++axis) {
            packet.corner[std::size_t(axis)][lane] = points[a][axis];
            packet.edge1[std::size_t(axis)][lane] = edge1[axis];
            packet.edge2[std::size_t(axis)][lane] = edge2[axis];
        }
    }
    return packet;
}

}  // namespace selvedge::sim

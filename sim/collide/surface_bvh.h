#pragma once
// Bounding-volume hierarchy over a body's surface, with four children per node and packets of eight triangles as
// leaves. It finds exact closest points and first hits of segments. The sign of the distance comes from angle-weighted
// pseudonormals (Baerentzen and Aanaes 2005).
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "sim/body/body.h"
#include "sim/collide/kernels.h"
#include "sim/core/math.h"

namespace selvedge::sim {

// The point of a triangle nearest to p.  (Ericson, Real-Time Collision Detection, 5.1.5)
struct TrianglePoint {
    Vec3f point;
    int feature;  // 0: the face; 1..3: the edge from corner k-1; 4..6: corner k-4
};
TrianglePoint closest_on_triangle(const Vec3f& p, const Vec3f& a, const Vec3f& b, const Vec3f& c);

// Barycentric coordinates of a point in the plane of a triangle; (1, 0, 0) for one without area.
std::array<float, 3> barycentric(const Vec3f& p, const Vec3f& a, const Vec3f& b, const Vec3f& c);

// Packets of eight triangles whose squared distances from a point are computed together.

struct TrianglePacket {
    static constexpr std::size_t kLanes = 8;
    using Lanes = std::array<float, kLanes>;

    std::array<Lanes, 3> corner, edge1, edge2;   // first corner and the two edges from it, m
    std::array<std::uint32_t, kLanes> triangle;  // unused slots repeat the last triangle
};

// Pre: `chosen` holds 1 to 8 indices into `triangles`.
TrianglePacket make_packet(std::span<const Vec3f> points, std::span<const std::array<std::uint32_t, 3>> triangles,
                           std::span<const std::uint32_t> chosen);

struct NearestTriangle {
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

    float squared = 0;  // m^2, the smallest so far; at first the search limit
    std::uint32_t triangle = kNone;
    bool found() const { return triangle != kNone; }

    // Of triangles at equal distance the one tested first is kept.
    void test(const CollideKernels& kernels, const TrianglePacket& packet, const Vec3f& p) {
        TrianglePacket::Lanes squares;
        unsigned nearer = kernels.squared_distances(packet.corner[0].data(), p.data(), squared, squares.data());
        for (; nearer != 0; nearer &= nearer - 1) {
            const std::size_t i = std::size_t(std::countr_zero(nearer));
            if (squares[i] >= squared) continue;
            squared = squares[i];
            triangle = packet.triangle[i];
        }
    }
};

// Nearby points and the triangle nearest to each. Unused slots repeat one of the points.
struct alignas(64) PointGroup {
    static constexpr std::size_t kPoints = 16;

    std::array<float, kPoints> x{}, y{}, z{};  // m
    std::array<float, kPoints> squared{};      // m^2, the smallest so far; at first the search limit
    std::array<std::uint32_t, kPoints> triangle{};

    Vec3f point(std::size_t lane) const { return {x[lane], y[lane], z[lane]}; }
    // Resets the slot to a new point and limits its search to `radius` (m).
    void start(std::size_t lane, const Vec3f& p, float radius) {
        x[lane] = p.x();
        y[lane] = p.y();
        z[lane] = p.z();
        squared[lane] = radius * radius;
        triangle[lane] = NearestTriangle::kNone;
    }
};

struct ClosestPoint {
    Vec3f point = Vec3f::Zero();  // on the surface, m
    Vec3f normal =
        Vec3f::Zero();           // unit, outward from the body: along p - point, or the surface normal where that is 0
    float distance = 0;          // m, negative inside
    std::uint32_t triangle = 0;  // index into Body::triangles
};

struct SurfaceHit {
    Vec3f point = Vec3f::Zero();   // m
    Vec3f normal = Vec3f::Zero();  // unit, the triangle's normal, out of the body
    float fraction = 0;            // 0 at the segment's start, 1 at its end
    std::uint32_t triangle = 0;
};

// Copies the body's data, so the body need not outlive it. Triangles without area are ignored in searches. Pre: the
// body's coordinates are finite and its indices in range. Signs are correct where the surface is closed and free of
// self-intersections.
class SurfaceBvh {
 public:
    explicit SurfaceBvh(const Body& body);

    // The surface point nearest to p; nullopt when none is within radius (m, may be infinite).
    std::optional<ClosestPoint> closest(const Vec3f& p, float radius) const;

    // Finds the triangle nearest to each point of the group that is nearer than its `squared`, and updates both.
    // `squared` is exact up to rounding. One traversal for all points: efficient when they are close together.
    void find_nearest(PointGroup& group) const;

    // The point of this triangle nearest to p. The sign is correct only if no other triangle is nearer.
    ClosestPoint closest_on(std::uint32_t triangle, const Vec3f& p) const;

    // First intersection of the segment with the surface, from either side.
    std::optional<SurfaceHit> first_hit(const Vec3f& from, const Vec3f& to) const;

    // The searched surface, in the body's order.
    std::span<const Vec3f> points() const { return x_; }
    std::span<const std::array<std::uint32_t, 3>> triangles() const { return triangles_; }
    bool empty() const { return nodes_.empty(); }
    bool has_area(std::uint32_t triangle) const { return face_normals_[triangle] != Vec3f::Zero(); }
    std::size_t bytes() const;

    // Bounding box of the surface, m.
    const Vec3f& low() const { return low_; }
    const Vec3f& high() const { return high_; }

 private:
    static constexpr int kChildren = 4;
    static constexpr std::int32_t kNoChild = INT32_MIN;

    struct Node {
        std::array<std::array<float, kChildren>, 3> low;
        std::array<std::array<float, kChildren>, 3> high;
        std::array<std::int32_t, kChildren> child;  // node index; ~packet index; or kNoChild
    };
    struct Builder;

    void make_normals(const Body& body);
    std::array<float, 6> box_at(std::int32_t place) const;
    Vec3f pseudo_normal(std::uint32_t triangle, int feature) const;

    std::vector<Node> nodes_;  // the first is the root
    std::vector<TrianglePacket> packets_;
    const CollideKernels* kernels_ = &collide_kernels(simd_level());
    std::vector<Vec3f> x_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    std::vector<Vec3f> face_normals_;
    std::vector<Vec3f> vertex_normals_;
    std::vector<std::array<Vec3f, 3>> edge_normals_;  // per triangle: of the edge from corner k to k+1
    Vec3f low_ = Vec3f::Zero();
    Vec3f high_ = Vec3f::Zero();
};

}  // namespace selvedge::sim

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
#include "sim/core/region.h"

namespace selvedge::sim {

// The point of a triangle nearest to p.  (Ericson, Real-Time Collision Detection, 5.1.5)
struct TrianglePoint {
    Vec3f point;
    int feature;  // 0: the face; 1..3: the edge from corner k-1; 4..6: corner k-4
};
TrianglePoint closest_on_triangle(const Vec3f& p, const Vec3f& a, const Vec3f& b, const Vec3f& c);

// Barycentric coordinates of a point in the plane of a triangle; (1, 0, 0) for one without area.
std::array<float, 3> barycentric(const Vec3f& p, const Vec3f& a, const Vec3f& b, const Vec3f& c);

// The share of the segment at which it crosses the triangle, from either side; nullopt if it does not. In double
// precision, so that a segment cannot pass between two adjacent triangles.  (Moeller and Trumbore 1997)
std::optional<float> crossing_fraction(const std::array<Vec3f, 2>& segment, const Vec3f& a, const Vec3f& b,
                                       const Vec3f& c);

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
    // The search of the slot starts with this triangle as its nearest, if that is within its limit.
    void start_with(std::size_t lane, const NearestTriangle& known) {
        if (!(known.squared < squared[lane])) return;
        squared[lane] = known.squared;
        triangle[lane] = known.triangle;
    }
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

struct CosineRange {
    float least = -1, most = 1;
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

    // A surface that moves. sweep_to() sets where its vertices will be (m): from then on find_nearest() visits what
    // comes within its reach on the way there, and all other functions still find the surface where it is. arrive()
    // puts it there. The hierarchy keeps its shape, so searches become slower the more the surface deforms. Pre: as
    // many as points(), all finite; a later sweep_to() replaces an earlier one.
    //
    // Parts of the surface that stay outside of `region` (m) on the way, less the drift, are left out: until the next
    // sweep_to(), searches do not find them.
    void sweep_to(std::span<const Vec3f> end, const Region& region = {});
    void arrive();
    // Where the vertices will be, m. Pre: between sweep_to() and arrive().
    std::span<const Vec3f> end_points() const { return end_; }
    // The mean motion of the vertices until arrive(), m; and if they went there.
    const Vec3f& drift() const { return drift_; }
    Vec3f drift_to(std::span<const Vec3f> end) const;

    // The surface point nearest to p; nullopt when none is within radius (m, may be infinite).
    std::optional<ClosestPoint> closest(const Vec3f& p, float radius) const;

    // Finds the triangle nearest to each point of the group that is nearer than its `squared`, and updates both.
    // `squared` is exact up to rounding. One traversal for all points: efficient when they are close together. Leaves
    // out what does not come within `reach` (m) of any of the points while the surface moves, less its drift.
    void find_nearest(PointGroup& group, float reach = std::numeric_limits<float>::infinity()) const;

    // The triangle, with its squared distance from p.
    NearestTriangle distance_to(std::uint32_t triangle, const Vec3f& p) const;

    // The point of this triangle nearest to p. The sign is correct only if no other triangle is nearer.
    ClosestPoint closest_on(std::uint32_t triangle, const Vec3f& p) const;

    // The triangle nearest to p within `radius` (m) whose outward normal makes an angle with `normal` (unit) whose
    // cosine is in that range: one side of a crease. nullopt if there is none.
    std::optional<std::uint32_t> nearest_facing(const Vec3f& p, const Vec3f& normal, const CosineRange& cosines,
                                                float radius) const;

    // From one triangle to the nearer one of its neighbours until none is nearer to p: the nearest one of the same
    // sheet, where others are nearer. Goes only to triangles whose outward normal is as in nearest_facing(). Pre:
    // sweep_to() was called.
    std::uint32_t walk_nearest(std::uint32_t from, const Vec3f& p, const Vec3f& normal,
                               const CosineRange& cosines) const;

    // First intersection of the segment with the surface, from either side.
    std::optional<SurfaceHit> first_hit(const Vec3f& from, const Vec3f& to) const;

    // Unit, outward; zero for a triangle without area.
    Vec3f face_normal(std::uint32_t triangle) const;

    // The searched surface, in the body's order.
    std::span<const Vec3f> points() const { return x_; }
    std::span<const std::array<std::uint32_t, 3>> triangles() const { return triangles_; }
    bool empty() const { return nodes_.empty(); }
    bool has_area(std::uint32_t triangle) const { return face_normal(triangle) != Vec3f::Zero(); }
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

    // The triangles beside each edge and round each vertex, for normals of a surface that moves.
    struct Adjacency {
        std::vector<std::array<std::uint32_t, 3>> beside;  // per triangle: the one across the edge from corner k to k+1
        std::vector<std::uint32_t> first, round;           // round vertex v: round[first[v]] to round[first[v + 1]]
    };

    // A subtree that is swept or left out as a whole.
    struct Part {
        std::size_t first_node = 0, last_node = 0, first_packet = 0, last_packet = 0;
        std::vector<std::uint32_t> vertices{};
        bool has_packets = true;  // whether its packets hold the surface as it is
    };

    void make_normals(const Body& body);
    void make_adjacency();
    void make_parts();
    std::array<std::size_t, 2> ends_of_subtree(std::size_t node) const;
    void sweep_part(Part& part, const Region& region);
    void sweep_node(Node& node);
    std::array<float, 6> box_at(std::int32_t place) const;
    Vec3f pseudo_normal(std::uint32_t triangle, int feature) const;
    Vec3f moved_edge_normal(std::uint32_t triangle, std::size_t side) const;
    Vec3f moved_vertex_normal(std::uint32_t vertex) const;

    std::vector<Node> nodes_;  // the first is the root
    std::vector<TrianglePacket> packets_;
    const CollideKernels* kernels_ = &collide_kernels(simd_level());
    std::vector<Vec3f> x_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    std::vector<Vec3f> face_normals_;  // these three: until the surface moves
    std::vector<Vec3f> vertex_normals_;
    std::vector<std::array<Vec3f, 3>> edge_normals_;  // per triangle: of the edge from corner k to k+1

    // Once the surface has moved.
    std::optional<Adjacency> adjacency_;
    std::vector<Part> parts_;
    std::vector<std::size_t> upper_nodes_;     // above the parts, each after its parent
    std::vector<Vec3f> end_;                   // where the vertices will be, m
    std::vector<TrianglePacket> end_packets_;  // the same
    Vec3f drift_ = Vec3f::Zero();
    Vec3f shift_ = Vec3f::Zero();  // m, that the boxes are to be moved by: they hold the surface less its drift
    Vec3f low_ = Vec3f::Zero();
    Vec3f high_ = Vec3f::Zero();
};

}  // namespace selvedge::sim

#pragma once
// Exact closest points on a body's surface, and first hits of segments: a tree of boxes, four children wide, over
// packets of eight triangles. The sign comes from angle-weighted pseudo-normals.  (SPEC 3.3)
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/body/body.h"
#include "sim/body/triangle_packet.h"
#include "sim/core/vec.h"

namespace selvedge {

struct ClosestPoint {
    Vec3f point = Vec3f::Zero();  // on the surface, m
    Vec3f normal =
        Vec3f::Zero();           // unit, away from the body: along p - point, or the surface's own where that vanishes
    float distance = 0;          // m, negative inside
    std::uint32_t triangle = 0;  // index into Body::triangles
};

struct SurfaceHit {
    Vec3f point = Vec3f::Zero();   // m
    Vec3f normal = Vec3f::Zero();  // unit, the triangle's own, away from the body
    float fraction = 0;            // 0 at the segment's start, 1 at its end
    std::uint32_t triangle = 0;
};

// Keeps copies of what it needs: the body may go. Triangles without area are left out.
// Pre: the body is finite, its indices are in range. Signs are right where the surface is closed and does not cross
// itself.
class SurfaceBvh {
 public:
    explicit SurfaceBvh(const Body& body);

    // The surface point nearest to p, if there is one within radius (m, may be infinite).
    std::optional<ClosestPoint> closest(const Vec3f& p, float radius) const;

    // The triangle nearest to each point of the group, if one is nearer than its `squared` says; that is brought down
    // to it, but for rounding. One search for all: cheap where the points lie close together.
    void find_nearest(PointGroup& group) const;

    // The nearest point of that one triangle; the sign is right only if the surface has no nearer one.
    ClosestPoint closest_on(std::uint32_t triangle, const Vec3f& p) const;

    // Where the segment first meets the surface, from either side.
    std::optional<SurfaceHit> first_hit(const Vec3f& from, const Vec3f& to) const;

    // The surface that is searched, in the body's order.
    std::span<const Vec3f> points() const { return x_; }
    std::span<const std::array<std::uint32_t, 3>> triangles() const { return triangles_; }
    bool empty() const { return nodes_.empty(); }
    bool has_area(std::uint32_t triangle) const { return face_normals_[triangle] != Vec3f::Zero(); }
    std::size_t bytes() const;

    // Its box, m.
    const Vec3f& low() const { return low_; }
    const Vec3f& high() const { return high_; }

 private:
    static constexpr int kChildren = 4;
    static constexpr std::int32_t kNoChild = INT32_MIN;

    struct Node {
        std::array<std::array<float, kChildren>, 3> low;
        std::array<std::array<float, kChildren>, 3> high;
        std::array<std::int32_t, kChildren> child;  // a node; ~packet; or kNoChild
    };
    struct Builder;

    void make_normals(const Body& body);
    std::array<float, 6> box_at(std::int32_t place) const;
    Vec3f pseudo_normal(std::uint32_t triangle, int feature) const;

    std::vector<Node> nodes_;  // the first is the root
    std::vector<TrianglePacket> packets_;
    PacketKernel kernel_ = packet_kernel();
    GroupKernel group_kernel_ = group_kernel();
    std::vector<Vec3f> x_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    std::vector<Vec3f> face_normals_;
    std::vector<Vec3f> vertex_normals_;
    std::vector<std::array<Vec3f, 3>> edge_normals_;  // of the edge from corner k to k+1
    Vec3f low_ = Vec3f::Zero();
    Vec3f high_ = Vec3f::Zero();
};

}  // namespace selvedge

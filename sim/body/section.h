#pragma once
// Plane sections of a body and tape measurements on them. A tape measure bridges hollows, so a girth is the perimeter
// of the section's convex hull (docs/mannequin.md).
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/body/body.h"
#include "sim/core/math.h"

namespace selvedge::sim {

struct Plane {
    Vec3d point = Vec3d::Zero();
    Vec3d normal = Vec3d::UnitY();  // unit
};

// One closed loop of a section: 3D points (m) in order around the loop.
struct SectionLoop {
    std::vector<Vec3d> points;
    Vec3d centre = Vec3d::Zero();  // centroid of the enclosed area
    double area = 0;               // m^2
};

// All closed loops in which the plane cuts the surface. The order is deterministic.
std::vector<SectionLoop> section(const Body& body, const Plane& plane);

// Level sections of one body, for many levels: triangles are found by their heights.
class LevelSections {
 public:
    explicit LevelSections(const Body& body);  // must outlive it

    // section() by the plane at height y (m), with equal bits.
    std::vector<SectionLoop> at(double y) const;

 private:
    std::size_t slab_of(double y) const;

    const Body& body_;
    double low_ = 0;
    double per_metre_ = 0;                  // slabs
    std::vector<std::uint32_t> first_;      // per slab, and one more: where its triangles begin
    std::vector<std::uint32_t> triangles_;  // of each slab that they reach into, ascending
};

// Perimeter of the loop's convex hull, m.
double tape_length(const SectionLoop& loop, const Plane& plane);

// The loop whose centre is nearest to `near`; nullopt when there are no loops.
std::optional<SectionLoop> nearest_loop(const std::vector<SectionLoop>& loops, const Vec3d& near);

}  // namespace selvedge::sim

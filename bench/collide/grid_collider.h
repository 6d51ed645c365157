#pragma once
// Two colliders that search the triangles of the surface, as baselines for the distance field: the collision grid of
// the thesis (4.4.1, fig. 4.7), and a bounding volume hierarchy (BVH).
#include <array>
#include <cstdint>
#include <vector>

#include "sim/collide/collider.h"
#include "sim/collide/surface_bvh.h"

namespace selvedge::bench {

// The collision grid of the thesis: 32^3 cells over the body's bounding box; each cell lists the triangles whose
// bounding boxes overlap it. Exact up to `reach` on both sides of the surface; deeper points inside count as outside.
class GridCollider final : public sim::Collider {
 public:
    static constexpr int kCells = 32;  // along each axis

    // The surface must outlive the collider. Pre: the surface is closed; reach > 0 (m).
    explicit GridCollider(const sim::SurfaceBvh& surface, float reach = 0.01F);

    sim::Contact contact(const Vec3f& p) const override;
    std::optional<sim::SurfaceHit> first_hit(const Vec3f& from, const Vec3f& to) const override {
        return surface_.first_hit(from, to);
    }
    float band() const override { return reach_; }
    float max_error() const override { return 1e-6F; }

    std::size_t bytes() const;

 private:
    using CellIndex = std::array<int, 3>;

    // The cells that a box overlaps.
    struct CellRange {
        CellIndex first;
        CellIndex last;  // inclusive
        bool is_empty() const { return first[0] > last[0] || first[1] > last[1] || first[2] > last[2]; }
    };
    static std::size_t place(int i, int j, int k) { return std::size_t(i + kCells * (j + kCells * k)); }
    CellRange cells_in(const Vec3f& low, const Vec3f& high) const;
    float squared_distance(const CellIndex& cell, const Vec3f& p) const;
    void test_cell(std::size_t cell, const Vec3f& p, sim::NearestTriangle& best) const;
    void list_triangles();

    const sim::SurfaceBvh& surface_;
    const sim::CollideKernels* kernels_ = &sim::collide_kernels(sim::simd_level());
    float reach_;
    Vec3f cell_size_;                   // m
    std::vector<std::uint32_t> first_;  // by cell: index of its first packet; one more entry at the end
    std::vector<sim::TrianglePacket> packets_;
};

// BVH queries limited to `reach`. Points deeper inside count as outside.
class BvhCollider final : public sim::Collider {
 public:
    // The surface must outlive the collider. Pre: the surface is closed; reach > 0 (m), infinite for no limit.
    explicit BvhCollider(const sim::SurfaceBvh& surface, float reach) : surface_(surface), reach_(reach) {}

    sim::Contact contact(const Vec3f& p) const override;
    std::optional<sim::SurfaceHit> first_hit(const Vec3f& from, const Vec3f& to) const override {
        return surface_.first_hit(from, to);
    }
    float band() const override { return reach_; }
    float max_error() const override { return 1e-6F; }

 private:
    const sim::SurfaceBvh& surface_;
    float reach_;
};

}  // namespace selvedge::bench

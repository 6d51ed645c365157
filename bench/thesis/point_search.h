#pragma once
// Two structures that find points in a cube: a uniform grid, and an octree of the same resolution. A cell or leaf may
// hold several points, which are searched linearly. (thesis table 4.1)
#include <cstdint>
#include <span>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::bench {

inline constexpr int kPointDepth = 5;                          // levels of the octree below its root
inline constexpr std::uint32_t kPointSide = 1 << kPointDepth;  // cells along each side
inline constexpr std::uint32_t kNoPoint = 0xFFFFFFFFU;

struct Cube {
    Vec3f low = Vec3f::Zero();  // m
    float side = 1;             // m

    bool contains(const Vec3f& p) const { return ((p - low).array() >= 0).all() && ((p - low).array() < side).all(); }
    // 0..kPointSide-1 along each axis. Pre: contains(p).
    std::array<std::uint32_t, 3> cell(const Vec3f& p) const;
};

class PointGrid {
 public:
    // Stores the points that lie in the cube.
    PointGrid(std::span<const Vec3f> points, const Cube& cube);

    std::uint32_t find(const Vec3f& p) const;  // index of a point with exactly these coordinates, or kNoPoint
    std::size_t size() const { return points_.size(); }
    std::size_t bytes() const;

 private:
    struct Entry {
        Vec3f x = Vec3f::Zero();
        std::uint32_t index = 0;
    };
    std::size_t cell_of(const Vec3f& p) const;

    Cube cube_;
    std::vector<std::uint32_t> first_;  // by cell: index of its first point in points_; one more entry at the end
    std::vector<Entry> points_;
};

class PointOctree {
 public:
    PointOctree(std::span<const Vec3f> points, const Cube& cube);

    std::uint32_t find(const Vec3f& p) const;
    std::size_t size() const { return points_.size(); }
    std::size_t bytes() const;

 private:
    struct Entry {
        Vec3f x = Vec3f::Zero();
        std::uint32_t index = 0;
    };
    // The eight children of a node are contiguous from `children`; 0: a leaf. A node is divided while it holds more
    // than one point, down to kPointDepth.
    struct Node {
        std::uint32_t children = 0;
        std::uint32_t first = 0;
        std::uint32_t count = 0;
    };
    void divide(std::uint32_t node, int depth, std::vector<std::uint32_t>& codes);

    Cube cube_;
    std::vector<Node> nodes_;
    std::vector<Entry> points_;  // the points of a node are contiguous
};

}  // namespace selvedge::bench

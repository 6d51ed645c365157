#pragma once
// Signed distance to a body on a sparse grid: blocks of 8^3 cells where the surface is near, elsewhere only the sign.
// Trilinear between nodes, so that a sample costs some nanoseconds whatever the body.  (SPEC 3.3)
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/body/surface_bvh.h"
#include "sim/core/vec.h"

namespace selvedge {

struct DistanceFieldOptions {
    float cell = 0.003F;  // m
    float band = 0.012F;  // m, distances are known up to here on both sides
};

struct FieldSample {
    float distance = 0;              // m, negative inside; exactly +band or -band where it is farther than that
    Vec3f gradient = Vec3f::Zero();  // about unit, less at creases; zero out of the band
};

class DistanceField {
 public:
    // Deterministic for any thread count. Pre: the surface is closed; 0 < 2 cell <= band.
    explicit DistanceField(const SurfaceBvh& bvh, const DistanceFieldOptions& options = {});

    FieldSample sample(const Vec3f& p) const;

    float band() const { return band_; }
    // Largest error of sample() on the surface itself, m: measured at every vertex, edge and triangle. Off the surface
    // it is less outside convex places; outside concave ones the field reads low, and |gradient| < 1 tells.
    float max_error() const { return max_error_; }
    std::size_t bytes() const { return blocks_.size() * sizeof(std::int32_t) + nodes_.size() * sizeof(std::int16_t); }

 private:
    static constexpr int kCellBits = 3;
    static constexpr int kCells = 1 << kCellBits;  // per block and axis
    static constexpr int kNodes = kCells + 1;
    static constexpr int kBlockNodes = kNodes * kNodes * kNodes;
    static constexpr std::int32_t kOutside = -1;
    static constexpr std::int32_t kInside = -2;

    void lay_out(const SurfaceBvh& bvh);
    void classify_blocks(const SurfaceBvh& bvh);
    void fill_block(const SurfaceBvh& bvh, std::size_t block, std::int16_t* nodes) const;
    Vec3f block_corner(std::size_t block) const;
    float error_on(const SurfaceBvh& bvh) const;

    float cell_;
    float per_cell_;
    float band_;
    float limit_;      // m, node values are held to +-limit
    float to_metres_;  // of a node's value
    float max_error_ = 0;
    Vec3f origin_ = Vec3f::Zero();
    std::array<int, 3> size_{};         // blocks along each axis
    Vec3f cells_ = Vec3f::Zero();       // cells along each axis
    std::vector<std::int32_t> blocks_;  // place in nodes_ (in blocks), or kOutside, kInside
    std::vector<std::int16_t> nodes_;
};

}  // namespace selvedge

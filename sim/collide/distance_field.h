#pragma once
// Signed distance to a body on a sparse grid: blocks of 8^3 cells where the surface is near, elsewhere only the sign.
// Trilinear between nodes, so that a sample costs some nanoseconds whatever the body.  (SPEC 3.3)
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "sim/collide/collider.h"
#include "sim/collide/kernels.h"
#include "sim/collide/surface_bvh.h"
#include "sim/core/math.h"

namespace selvedge::sim {

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
    // Deterministic for any thread count. interrupt, when given, is called often meanwhile, on any thread: what it
    // throws ends the making. Pre: the surface is closed; 0 < 2 cell <= band.
    explicit DistanceField(const SurfaceBvh& bvh, const DistanceFieldOptions& options = {},
                           const std::function<void()>& interrupt = {});

    FieldSample sample(const Vec3f& p) const;

    // The same for every lane of every block, to the same bits at every SimdLevel; normals are gradients of unit length
    // where sample() gives any. doubtful[block] gets a bit for each lane (0 lowest) that lies nearer than `reach` (m)
    // and has no gradient that can be trusted: it is at a crease, or inside and out of the band.
    // Pre: as many places in doubtful as blocks.
    void sample(std::span<ContactBlock> blocks, float reach, std::span<std::uint16_t> doubtful) const;

    // A shorter gradient tells that the cell spans a crease.
    static constexpr float kTrustedGradient = 0.95F;

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
    // Blocks out of the band share these two, all of whose nodes lie at the limit.
    static constexpr std::int32_t kOutside = 0;
    static constexpr std::int32_t kInside = kBlockNodes;
    static constexpr std::int32_t kFirstNear = 2 * kBlockNodes;

    void lay_out(const SurfaceBvh& bvh);
    void classify_blocks(const SurfaceBvh& bvh);
    void fill_block(const SurfaceBvh& bvh, std::size_t block, std::int16_t* nodes) const;
    Vec3f block_corner(std::size_t block) const;
    float error_on(const SurfaceBvh& bvh) const;
    FieldView view() const;

    float cell_;
    float per_cell_;
    float band_;
    float limit_;      // m, node values are held to +-limit
    float to_metres_;  // of a node's value
    float max_error_ = 0;
    Vec3f origin_ = Vec3f::Zero();
    std::array<int, 3> size_{};         // blocks along each axis
    Vec3f cells_ = Vec3f::Zero();       // cells along each axis
    std::vector<std::int32_t> blocks_;  // first node of each
    std::vector<std::int16_t> nodes_;
};

}  // namespace selvedge::sim

#pragma once
// Signed distance to a body on a sparse grid: blocks of 8^3 cells near the surface, only the sign elsewhere. Trilinear
// interpolation between nodes: the cost of a sample does not depend on the body's triangle count.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/collide/collider.h"
#include "sim/collide/kernels.h"
#include "sim/collide/surface_bvh.h"
#include "sim/core/math.h"

namespace selvedge::sim {

struct DistanceFieldOptions {
    float cell = 0.003F;  // m
    float band = 0.012F;  // m, distances are stored up to this value on both sides
};

struct FieldSample {
    float distance = 0;              // m, negative inside; exactly +band or -band when farther than that
    Vec3f gradient = Vec3f::Zero();  // length about 1, less at creases; zero outside the band
};

class DistanceField {
 public:
    // Deterministic for any thread count. `interrupt`, when given, is called regularly during the construction, on any
    // thread; an exception from it aborts the construction. Pre: the surface is closed; 0 < 2 cell <= band.
    explicit DistanceField(const SurfaceBvh& bvh, const DistanceFieldOptions& options = {},
                           const std::function<void()>& interrupt = {});

    // All of it, as flat bytes (sim/core/flat_bytes.h); nullopt when the bytes are not a valid field.
    std::string to_bytes() const;
    static std::optional<DistanceField> from_bytes(std::string_view bytes);

    FieldSample sample(const Vec3f& p) const;

    // sample() for every slot of every block, with identical bits at every SimdLevel. Where sample() gives a gradient,
    // the normal is the normalised gradient. doubtful[block] gets a bit for each slot (bit 0 for slot 0) that is nearer
    // than `reach` (m) and has no reliable gradient: at a crease, or inside beyond the band. Pre: doubtful has an entry
    // for each block.
    void sample(std::span<ContactBlock> blocks, float reach, std::span<std::uint16_t> doubtful) const;

    // A gradient shorter than this indicates that the cell spans a crease.
    static constexpr float kTrustedGradient = 0.95F;

    float band() const { return band_; }
    // Maximum error of sample() on the surface, m, measured at all vertices, edge midpoints and triangle centroids. Off
    // the surface, the error is smaller near convex regions; near concave regions the field underestimates, and
    // |gradient| < 1 shows it.
    float max_error() const { return max_error_; }
    std::size_t bytes() const { return blocks_.size() * sizeof(std::int32_t) + nodes_.size() * sizeof(std::int16_t); }

 private:
    explicit DistanceField(const DistanceFieldOptions& options);

    static constexpr int kCellBits = 3;
    static constexpr int kCells = 1 << kCellBits;  // per block and axis
    static constexpr int kNodes = kCells + 1;
    static constexpr int kBlockNodes = kNodes * kNodes * kNodes;
    // All blocks beyond the band share these two; all of their nodes hold +limit or -limit.
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
    float limit_;      // m, node values are clamped to +-limit
    float to_metres_;  // scale of a node's value
    float max_error_ = 0;
    Vec3f origin_ = Vec3f::Zero();
    std::array<int, 3> size_{};         // blocks along each axis
    Vec3f cells_ = Vec3f::Zero();       // cells along each axis
    std::vector<std::int32_t> blocks_;  // index of each block's first node
    std::vector<std::int16_t> nodes_;
};

}  // namespace selvedge::sim

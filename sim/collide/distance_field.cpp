#include "sim/collide/distance_field.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

#include "sim/core/assert.h"
#include "sim/core/flat_bytes.h"
#include "sim/core/parallel.h"
#include "sim/core/simd_level.h"

namespace selvedge::sim {
namespace {

constexpr float kUnbounded = std::numeric_limits<float>::infinity();
constexpr float kRelativeSlack = 1.0001F;  // bounds are enlarged by this factor
constexpr float kAbsoluteSlack = 1e-6F;    // m, and by this amount, for rounding
constexpr float kHalfDiagonal = 0.8660254F;
constexpr std::int16_t kFarNode = 32767;  // stored at the limit

// Signed distances along a path of small steps. The surface point nearest to one point bounds the search for the next.
// Beyond `reach` only the sign is correct, and the magnitude is at least `reach`.
class DistanceWalk {
 public:
    DistanceWalk(const SurfaceBvh& bvh, float stride, float reach) : bvh_(bvh), stride_(stride), reach_(reach) {}

    // Pre: p is at most one stride away from the previous point.
    float next(const Vec3f& p) {
        if (known_ && std::abs(distance_) - stride_ > reach_) return distance_ -= std::copysign(stride_, distance_);
        const float nearest = has_nearest_ ? (p - nearest_).norm() : kUnbounded;
        const float reach = known_ ? reach_ : kUnbounded;
        const std::optional<ClosestPoint> closest =
            bvh_.closest(p, std::min(nearest, reach) * kRelativeSlack + kAbsoluteSlack);
        known_ = true;
        has_nearest_ = closest.has_value();
        if (closest) {
            nearest_ = closest->point;
            return distance_ = closest->distance;
        }
        // Nothing is within reach, and reach exceeds a stride, so the sign has not changed.
        return distance_ = std::copysign(reach_, distance_);
    }

 private:
    const SurfaceBvh& bvh_;
    float stride_;
    float reach_;
    float distance_ = 0;
    bool known_ = false;
    bool has_nearest_ = false;
    Vec3f nearest_ = Vec3f::Zero();  // a surface point near the current point
};

// Order of a block's nodes: layers of 3 x 3 nodes, up one column and down the next. So sixteen successive nodes are
// close together, and successive nodes are at most three cells apart.
constexpr int kNodesOfAxis = 9;

consteval auto order_of_nodes() {
    constexpr std::size_t kNodes = kNodesOfAxis;
    std::array<std::array<int, 3>, kNodes * kNodes * kNodes> order{};
    std::size_t count = 0;
    for (int column = 0; column < 9; ++column) {
        const int row = column / 3;
        const int left = 3 * (row % 2 == 0 ? column % 3 : 2 - column % 3);
        for (int layer = 0; layer < kNodesOfAxis; ++layer)
            for (int j = 0; j < 3; ++j)
                for (int i = 0; i < 3; ++i)
                    order[count++] = {left + i, 3 * row + j, column % 2 == 0 ? layer : kNodesOfAxis - 1 - layer};
    }
    return order;
}

constexpr auto kNodeOrder = order_of_nodes();

// Signed distances of groups of points, clamped to the limit. The surface point nearest to one point bounds the search
// for the next group.
class GroupWalk {
 public:
    GroupWalk(const SurfaceBvh& bvh, float limit) : bvh_(bvh), limit_(limit) {}

    void start(PointGroup& group, std::size_t lane, const Vec3f& p) {
        if (!is_known_) meet(p);
        const float nearest = (p - nearest_).norm() * kRelativeSlack + kAbsoluteSlack;
        group.start(lane, p, std::min(nearest, limit_ * kRelativeSlack + kAbsoluteSlack));
    }

    // Pre: successive points are nearer than the limit to each other.
    std::array<float, PointGroup::kPoints> finish(PointGroup& group) {
        bvh_.find_nearest(group);
        std::array<float, PointGroup::kPoints> distances;
        for (std::size_t i = 0; i < PointGroup::kPoints; ++i) {
            // No triangle within the limit: same side as the previous point.
            distances[i] = std::copysign(limit_, last_);
            if (group.triangle[i] != NearestTriangle::kNone) {
                const ClosestPoint closest = bvh_.closest_on(group.triangle[i], group.point(i));
                distances[i] = std::clamp(closest.distance, -limit_, limit_);
                nearest_ = closest.point;
            }
            last_ = distances[i];
        }
        return distances;
    }

 private:
    void meet(const Vec3f& p) {
        is_known_ = true;
        const std::optional<ClosestPoint> closest = bvh_.closest(p, kUnbounded);
        if (!closest) return;
        nearest_ = closest->point;
        last_ = closest->distance;
    }

    const SurfaceBvh& bvh_;
    float limit_;
    bool is_known_ = false;
    float last_ = 0;                 // signed distance of the previous point
    Vec3f nearest_ = Vec3f::Zero();  // a surface point near the current point
};

}  // namespace

DistanceField::DistanceField(const DistanceFieldOptions& options)
    : cell_(options.cell),
      per_cell_(1 / options.cell),
      band_(options.band),
      // If a cell contains a point in the band, its nodes are at most the cell's diagonal away from that point.
      limit_(options.band + 2 * kHalfDiagonal * options.cell),
      to_metres_(limit_ / float(kFarNode)) {}

DistanceField::DistanceField(const SurfaceBvh& bvh, const DistanceFieldOptions& options,
                             const std::function<void()>& interrupt)
    : DistanceField(options) {
    SELVEDGE_ASSERT(cell_ > 0 && 2 * cell_ <= band_);
    lay_out(bvh);
    classify_blocks(bvh);
    parallel_for(blocks_.size(), 16, [&](std::size_t first, std::size_t last) {
        if (interrupt) interrupt();
        for (std::size_t block = first; block < last; ++block)
            if (blocks_[block] >= kFirstNear) fill_block(bvh, block, &nodes_[std::size_t(blocks_[block])]);
    });
    max_error_ = error_on(bvh);
}

void DistanceField::lay_out(const SurfaceBvh& bvh) {
    const float edge = cell_ * kCells;
    const Vec3f margin = Vec3f::Constant(limit_);
    origin_ = bvh.low() - margin;
    const Vec3f extent = bvh.high() + margin - origin_;
    double count = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double blocks = std::ceil(double(extent[axis]) / double(edge));
        count *= blocks;
        SELVEDGE_ASSERT(count < 1e8);
        size_[std::size_t(axis)] = int(blocks);
        cells_[axis] = float(blocks) * kCells;
    }
    blocks_.assign(std::size_t(count), kOutside);
}

std::string DistanceField::to_bytes() const {
    FlatWriter writer;
    writer.value(cell_);
    writer.value(band_);
    writer.value(max_error_);
    for (const float coordinate : origin_) writer.value(coordinate);
    writer.value(size_);
    writer.list(blocks_);
    writer.list(nodes_);
    return writer.bytes();
}

std::optional<DistanceField> DistanceField::from_bytes(std::string_view bytes) {
    FlatReader reader(bytes);
    DistanceFieldOptions options;
    options.cell = reader.value<float>();
    options.band = reader.value<float>();
    if (!(options.cell > 0 && 2 * options.cell <= options.band && options.band < 1)) return std::nullopt;
    DistanceField field(options);
    field.max_error_ = reader.value<float>();
    for (float& coordinate : field.origin_) coordinate = reader.value<float>();
    field.size_ = reader.value<std::array<int, 3>>();
    field.blocks_ = reader.list<std::int32_t>();
    field.nodes_ = reader.list<std::int16_t>();
    if (!reader.is_sound() || !reader.is_at_end()) return std::nullopt;
    if (!field.origin_.allFinite() || !std::isfinite(field.max_error_)) return std::nullopt;
    std::size_t count = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (field.size_[axis] < 1 || std::size_t(field.size_[axis]) > field.blocks_.size()) return std::nullopt;
        count *= std::size_t(field.size_[axis]);
        field.cells_[Eigen::Index(axis)] = float(field.size_[axis]) * kCells;
    }
    const auto is_block = [&](std::int32_t first) {
        return first >= 0 && first % kBlockNodes == 0 && std::size_t(first) + kBlockNodes <= field.nodes_.size();
    };
    if (count != field.blocks_.size() || !std::ranges::all_of(field.blocks_, is_block)) return std::nullopt;
    return field;
}

Vec3f DistanceField::block_corner(std::size_t block) const {
    const std::size_t nx = std::size_t(size_[0]);
    const std::size_t ny = std::size_t(size_[1]);
    const Vec3f index(float(block % nx), float(block / nx % ny), float(block / nx / ny));
    return origin_ + index * (cell_ * kCells);
}

// A block whose centre is farther from the surface than the band plus half the block's diagonal is outside the band.
void DistanceField::classify_blocks(const SurfaceBvh& bvh) {
    const float edge = cell_ * kCells;
    const float reach = band_ + kHalfDiagonal * edge;
    constexpr std::int32_t kNear = -1;
    const std::size_t row = std::size_t(size_[0]);
    parallel_for(blocks_.size() / row, 8, [&](std::size_t first, std::size_t last) {
        for (std::size_t r = first; r < last; ++r) {
            DistanceWalk walk(bvh, edge, reach);
            for (std::size_t block = r * row; block < (r + 1) * row; ++block) {
                const float distance = walk.next(block_corner(block) + Vec3f::Constant(edge / 2));
                blocks_[block] = std::abs(distance) < reach ? kNear : (distance < 0 ? kInside : kOutside);
            }
        }
    });
    std::int32_t count = kFirstNear;
    for (std::int32_t& block : blocks_)
        if (block == kNear) {
            SELVEDGE_ASSERT(count < std::numeric_limits<std::int32_t>::max() - kBlockNodes);
            block = count;
            count += kBlockNodes;
        }
    nodes_.resize(std::size_t(count));
    std::fill_n(nodes_.begin() + kOutside, kBlockNodes, kFarNode);
    std::fill_n(nodes_.begin() + kInside, kBlockNodes, std::int16_t(-kFarNode));
}

// Signed distances of all nodes of a block, sixteen neighbouring nodes per search.
void DistanceField::fill_block(const SurfaceBvh& bvh, std::size_t block, std::int16_t* nodes) const {
    constexpr std::size_t kAtOnce = PointGroup::kPoints;
    const Vec3f corner = block_corner(block);
    GroupWalk walk(bvh, limit_);
    for (std::size_t first = 0; first < kNodeOrder.size(); first += kAtOnce) {
        PointGroup group;
        for (std::size_t i = 0; i < kAtOnce; ++i) {
            const auto& [x, y, z] = kNodeOrder[std::min(first + i, kNodeOrder.size() - 1)];
            walk.start(group, i, corner + Vec3f(float(x), float(y), float(z)) * cell_);
        }
        const std::array<float, kAtOnce> distances = walk.finish(group);
        for (std::size_t i = 0; i < std::min(kAtOnce, kNodeOrder.size() - first); ++i) {
            const auto& [x, y, z] = kNodeOrder[first + i];
            nodes[x + kNodes * (y + kNodes * z)] = std::int16_t(std::lrint(distances[i] / to_metres_));
        }
    }
}

FieldSample DistanceField::sample(const Vec3f& p) const {
    const Vec3f at = (p - origin_) * per_cell_;
    const FieldSample outside{band_, Vec3f::Zero()};
    // The condition is written so that NaN also counts as outside.
    if (!((at.array() >= 0).all() && (at.array() < cells_.array()).all())) return outside;
    const int i = int(at.x());
    const int j = int(at.y());
    const int k = int(at.z());
    const int place = (i >> kCellBits) + size_[0] * ((j >> kCellBits) + size_[1] * (k >> kCellBits));
    const std::int32_t block = blocks_[std::size_t(place)];
    if (block == kOutside) return outside;
    if (block == kInside) return {-band_, Vec3f::Zero()};

    constexpr int kWithin = kCells - 1;
    const int corner = (i & kWithin) + kNodes * ((j & kWithin) + kNodes * (k & kWithin));
    const std::int16_t* node = &nodes_[std::size_t(block + corner)];
    const float fx = at.x() - float(i);
    const float fy = at.y() - float(j);
    const float fz = at.z() - float(k);
    constexpr int kY = kNodes;
    constexpr int kZ = kNodes * kNodes;
    const auto value = [&](int offset) { return float(node[offset]); };
    // Differences along x on the cell's four x edges, then interpolated values there; then the same along y and z.
    const float dx00 = value(1) - value(0), dx10 = value(kY + 1) - value(kY);
    const float dx01 = value(kZ + 1) - value(kZ), dx11 = value(kZ + kY + 1) - value(kZ + kY);
    const float v00 = value(0) + fx * dx00, v10 = value(kY) + fx * dx10;
    const float v01 = value(kZ) + fx * dx01, v11 = value(kZ + kY) + fx * dx11;
    const float v0 = v00 + fy * (v10 - v00);
    const float v1 = v01 + fy * (v11 - v01);
    const float distance = (v0 + fz * (v1 - v0)) * to_metres_;
    if (std::abs(distance) >= band_) return {std::copysign(band_, distance), Vec3f::Zero()};

    const float dx0 = dx00 + fy * (dx10 - dx00);
    const float dx1 = dx01 + fy * (dx11 - dx01);
    const Vec3f steps(dx0 + fz * (dx1 - dx0), (v10 - v00) + fz * ((v11 - v01) - (v10 - v00)), v1 - v0);
    return {distance, steps * (to_metres_ * per_cell_)};
}

FieldView DistanceField::view() const {
    const auto last = [&](int axis) { return std::nextafter(cells_[axis], 0.0F); };
    return {.blocks = blocks_.data(),
            .nodes = nodes_.data(),
            .origin = {origin_.x(), origin_.y(), origin_.z()},
            .last = {last(0), last(1), last(2)},
            .size = {size_[0], size_[1]},
            .per_cell = per_cell_,
            .to_metres = to_metres_,
            .to_gradient = to_metres_ * per_cell_,
            .band = band_,
            .trusted = kTrustedGradient};
}

// Kernels address a ContactBlock as seven rows of floats.
static_assert(sizeof(ContactBlock) == 7 * sizeof(ContactBlock::Lanes) && offsetof(ContactBlock, x) == 0);

void DistanceField::sample(std::span<ContactBlock> blocks, float reach, std::span<std::uint16_t> doubtful) const {
    SELVEDGE_ASSERT(doubtful.size() >= blocks.size());
    if (blocks.empty()) return;
    float* rows = blocks.front().x.data();
    collide_kernels(simd_level()).sample_blocks(view(), rows, blocks.size(), reach, doubtful.data());
}

// The true distance on the surface is 0, and convex features are sharpest there.
float DistanceField::error_on(const SurfaceBvh& bvh) const {
    constexpr std::size_t kGrain = 4096;
    const std::span<const Vec3f> x = bvh.points();
    const std::span<const std::array<std::uint32_t, 3>> triangles = bvh.triangles();
    std::vector<float> worst(triangles.size() / kGrain + 1, 0.0F);
    parallel_for(worst.size(), 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t part = first; part < last; ++part)
            for (std::size_t t = part * kGrain; t < std::min(triangles.size(), (part + 1) * kGrain); ++t) {
                const Vec3f& a = x[triangles[t][0]];
                const Vec3f& b = x[triangles[t][1]];
                const Vec3f& c = x[triangles[t][2]];
                for (const Vec3f& p :
                     {a, b, c, Vec3f((a + b) / 2), Vec3f((b + c) / 2), Vec3f((c + a) / 2), Vec3f((a + b + c) / 3)})
                    worst[part] = std::max(worst[part], std::abs(sample(p).distance));
            }
    });
    return *std::max_element(worst.begin(), worst.end());
}

}  // namespace selvedge::sim

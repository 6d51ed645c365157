#include "sim/selfcontact/self_contact.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "sim/selfcontact/kernels.h"

namespace selvedge::sim {
namespace {

const SelfContactKernels& loops() {
    return self_contact_kernels(simd_level());
}

}  // namespace

void SelfContact::set_surface(ContactSurface surface, std::size_t vertices) {
    surface_ = std::move(surface);
    search_.set_surface(surface_, static_cast<std::uint32_t>(vertices));
    std::vector<bool> is_used(vertices, false);
    layers_.assign(vertices, 0);
    for (const ContactTriangle& triangle : surface_.triangles) {
        for (const std::uint32_t v : triangle.vertices) {
            is_used[v] = true;
            layers_[v] = surface_.sheets[triangle.sheet].layer;
        }
    }
    has_layers_ = std::ranges::any_of(
        surface_.sheets, [&](const ContactSheet& sheet) { return sheet.layer != surface_.sheets.front().layer; });
    used_.clear();
    for (std::uint32_t v = 0; v < vertices; ++v) {
        if (is_used[v]) used_.push_back(v);
    }
    if (!clean_.empty()) clean_.resize(vertices, Vec4f::Zero());
    has_detected_ = false;
}

void SelfContact::on_split(std::uint32_t centre, std::uint32_t a, std::uint32_t b) {
    if (clean_.empty()) return;
    if (centre >= clean_.size()) clean_.resize(centre + 1, Vec4f::Zero());
    clean_[centre] = (clean_[a] + clean_[b]) * 0.5F;
}

void SelfContact::forget() {
    clean_.clear();
    has_detected_ = is_clean_ = false;
    is_doubtful_ = true;
}

void SelfContact::begin_step(const MovingPoints& points, const SelfContactOptions& options) {
    ++counts_.steps;
    if (!has_detected_ || !is_clean_) detect(points, options);
}

void SelfContact::substep(const MovingPoints& points, const SelfContactOptions& options) {
    ++since_detection_;
    if (since_detection_ % options.refresh_interval == 0) {
        const float off = largest_deviation(points), radius = thickest(options);
        // Two vertices may leave their paths towards each other.
        if (off > 0.5F * options.margin + 0.25F * radius) {
            is_doubtful_ = is_doubtful_ || off > 0.5F * (options.margin + radius);
            certify(points, options);
            detect(points, options);
        } else {
            refresh(points, options);
        }
    }
    counts_.acted +=
        static_cast<long>(loops().solve_contacts(contacts_.data(), contacts_.size(), points.now, points.before));
}

void SelfContact::end_step(const MovingPoints& points, const SelfContactOptions& options) {
    if (is_clean_) {
        certify(points, options);
    } else {
        untangle(points, options);
    }
}

void SelfContact::detect(const MovingPoints& points, const SelfContactOptions& options) {
    ++counts_.detections;
    options_ = options;
    expect_motion(points);
    const Sweep sweep{.moves = moves_.front().data(), .substeps = 1.2F * static_cast<float>(options.horizon)};
    search_.find_triangles(loops(), surface_, points.now, sweep, reach(options));
    counts_.triangle_pairs += static_cast<long>(search_.triangle_pairs().size());
    look_for_crossings(points, options);
    for (const std::uint32_t v : used_) start_[v] = with_zero_w(points.at(v));
    search_.find_elements(loops(), surface_, points.now, sweep,
                          {.margin = options.margin, .least = has_layers_ && !is_clean_ ? reach(options) : 0},
                          options.thickness_scale, pairs_);
    counts_.pairs += static_cast<long>(pairs_.size());
    judge_sides();
    has_detected_ = true;
    since_detection_ = 0;
    refresh(points, options);
}

// Unless the planes vouch for all pairs, an exact test does. A crossing that is new goes back.
void SelfContact::look_for_crossings(const MovingPoints& points, const SelfContactOptions& options) {
    constexpr int kTestInterval = 8;  // detections: no plane vouches for pairs that were not found in time
    if (is_clean_ && !is_doubtful_ && ++since_test_ < kTestInterval) return;
    test_exactly(points);
    for (int round = 0; !clean_.empty() && !is_clean_ && round < options.untangling_rounds; ++round) {
        ++counts_.untangling_rounds;
        untangler_.separate(surface_, crossings_, clean_, points);
        test_exactly(points);
    }
    if (is_clean_) keep_clean_state(points);
}

void SelfContact::test_exactly(const MovingPoints& points) {
    ++counts_.exact_tests;
    since_test_ = 0;
    crossings_ = find_crossings(surface_, search_, points.now);
    is_clean_ = crossings_.empty();
    is_doubtful_ = false;
}

void SelfContact::keep_clean_state(const MovingPoints& points) {
    clean_.resize(points.count, Vec4f::Zero());
    for (const std::uint32_t v : used_) clean_[v] = with_zero_w(points.at(v));
}

// While the cloth crosses itself, sides are not always known. A pair whose sides both touch a crossing is neither
// pushed nor certified, but if its sides are of different layers and the cloth is flat there, it is known which of them
// belongs outside: sides on the wrong side of each other are pushed through.
void SelfContact::judge_sides() {
    swapped_.assign(layers_.size(), 0);
    if (is_clean_) return;
    std::vector<bool> is_tangled(layers_.size(), false);
    for (const Crossing& crossing : crossings_) {
        for (const std::uint32_t v : surface_.edges[crossing.edge].ends) is_tangled[v] = true;
        for (const std::uint32_t v : surface_.triangles[crossing.triangle].vertices) is_tangled[v] = true;
    }
    std::vector<Vec3f> normals(layers_.size(), Vec3f::Zero());
    if (has_layers_) {
        for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) {
            for (const std::uint32_t v : surface_.triangles[t].vertices) normals[v] += search_.normal_of(t);
        }
    }
    judge_sides(pairs_.vertex_triangle, is_tangled, normals);
    judge_sides(pairs_.edge_edge, is_tangled, normals);
}

void SelfContact::judge_sides(PairList& pairs, const std::vector<bool>& is_tangled, const std::vector<Vec3f>& normals) {
    constexpr float kUnclear = 0.3F;  // cosine: about 73 degrees from the normal on
    const std::size_t first = first_side(pairs.kind());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        PairBlock& block = pairs.blocks()[i / kBlock];
        const std::size_t at = i % kBlock;
        std::array<bool, 2> has{false, false};
        for (std::size_t k = 0; k < 4; ++k) {
            bool& side = has[k < first ? 0 : 1];
            side = side || is_tangled[block.vertices[k][at] / 4];
        }
        const bool is_between = has[0] && has[1];
        if (!is_ordered(block, at)) {
            if (is_between) block.side[at] = 0;
            continue;
        }
        const float cosine = facing(block, at, pairs.kind(), normals);
        if (cosine < -kUnclear) {
            block.side[at] = -1;
            for (const BlockPoints& vertices : block.vertices) ++swapped_[vertices[at] / 4];
        } else if (cosine < kUnclear && (has[0] || has[1])) {
            block.side[at] = 0;
        }
    }
}

// Whether the sides are of different layers, and no edge near them is bent sharply: normals of crumpled cloth do not
// say what is outside.
bool SelfContact::is_ordered(const PairBlock& block, std::size_t at) const {
    const auto vertex = [&](std::size_t k) { return block.vertices[k][at] / 4; };
    if (layers_[vertex(0)] == layers_[vertex(3)]) return false;
    return search_.is_flat(vertex(0)) && search_.is_flat(vertex(1)) && search_.is_flat(vertex(2)) &&
           search_.is_flat(vertex(3));
}

// The cosine between the direction from the inner side to the outer one and the outward normal of the inner side:
// positive if they are in order.
float SelfContact::facing(const PairBlock& block, std::size_t at, PairKind kind,
                          const std::vector<Vec3f>& normals) const {
    const std::size_t first = first_side(kind);
    const bool is_first_inner = layers_[block.vertices[0][at] / 4] < layers_[block.vertices[3][at] / 4];
    Vec3f outward = Vec3f::Zero();
    for (std::size_t k = is_first_inner ? 0 : first; k < (is_first_inner ? first : 4); ++k) {
        outward += normals[block.vertices[k][at] / 4];
    }
    const Vec3f to_first(block.divider[0][at], block.divider[1][at], block.divider[2][at]);
    const float length = outward.norm();
    if (!(length > 0)) return 0;
    return (is_first_inner ? -1.0F : 1.0F) * to_first.dot(outward) / length;
}

// m; layers that cross are looked for a little farther.
float SelfContact::reach(const SelfContactOptions& options) const {
    constexpr float kOrderReach = 0.005F;  // m
    const float near = thickest(options) + options.margin;
    return has_layers_ && !is_clean_ ? std::max(near, kOrderReach) : near;
}

void SelfContact::refresh(const MovingPoints& points, const SelfContactOptions& options) {
    ++counts_.refreshes;
    contacts_.clear();
    list_contacts(pairs_.vertex_triangle, points, options);
    list_contacts(pairs_.edge_edge, points, options);
    counts_.contacts += static_cast<long>(contacts_.size());
}

// Many pairs may push one vertex through: together no farther than one would.
float SelfContact::most_swapped(const PairBlock& block, std::size_t at) const {
    std::uint16_t most = 1;
    for (const BlockPoints& vertices : block.vertices) most = std::max(most, swapped_[vertices[at] / 4]);
    return static_cast<float>(most);
}

void SelfContact::list_contacts(PairList& pairs, const MovingPoints& points, const SelfContactOptions& options) {
    const float ahead = 1.2F * static_cast<float>(options.refresh_interval);
    for (std::size_t i = 0; i < pairs.block_count(); ++i) {
        PairBlock& block = pairs.blocks()[i];
        unsigned found = loops().refresh_pairs(pairs.kind(), block, points.now, points.before, options.margin, ahead);
        for (; found != 0; found &= found - 1) {
            const auto at = static_cast<std::size_t>(__builtin_ctz(found));
            SelfContactPlane contact{
                .radius = block.radius[at], .friction = block.friction[at], .longest_push = options.longest_push};
            float sum = 0;
            for (std::size_t k = 0; k < 4; ++k) {
                contact.vertices[k] = block.vertices[k][at];
                contact.weight[k] = block.side[at] * block.weight[k][at];
                sum += contact.weight[k] * contact.weight[k] * points.inverse_mass(contact.vertices[k] / 4);
            }
            for (std::size_t k = 0; k < 3; ++k) contact.normal[k] = block.normal[k][at];
            if (sum <= 0) continue;
            contact.inverse = 1 / sum;
            if (block.side[at] < 0) contact.longest_push /= most_swapped(block, at);
            contacts_.push_back(contact);
        }
    }
}

void SelfContact::certify(const MovingPoints& points, const SelfContactOptions& options) {
    if (!options.certifies || !has_detected_) return;
    const CertificateReport report =
        dividers_.certify(loops(), pairs_, start_, mean_displacement(points), mean_move_, points);
    counts_.parted += report.parted;
    counts_.truncated += report.truncated;
}

// When the last crossing is gone, contacts must hold at once, or the next sub-step draws the tangle shut again.
void SelfContact::untangle(const MovingPoints& points, const SelfContactOptions& options) {
    for (int round = 0; !is_clean_ && round < options.untangling_rounds; ++round) {
        ++counts_.untangling_rounds;
        untangler_.separate(surface_, crossings_, clean_, points);
        if (clean_.empty() || 2 * round >= options.untangling_rounds) untangler_.smooth(surface_, crossings_, points);
        test_exactly(points);
    }
    if (!is_clean_) return certify(points, options);
    keep_clean_state(points);
    detect(points, options);
}

void SelfContact::expect_motion(const MovingPoints& points) {
    start_.resize(points.count, Vec4f::Zero());
    moves_.assign(points.count + 1, Vec4f::Zero());
    Vec3f sum = Vec3f::Zero();
    for (const std::uint32_t v : used_) {
        const Vec3f move = points.at(v) - Eigen::Map<const Vec3f>(points.before + 4 * static_cast<std::size_t>(v));
        moves_[v] = with_zero_w(move);
        sum += move;
    }
    mean_move_ = used_.empty() ? Vec3f::Zero() : Vec3f(sum / static_cast<float>(used_.size()));
    for (const std::uint32_t v : used_) moves_[v] -= with_zero_w(mean_move_);
}

Vec3f SelfContact::mean_displacement(const MovingPoints& points) const {
    Vec3f sum = Vec3f::Zero();
    for (const std::uint32_t v : used_) sum += points.at(v) - start_[v].head<3>();
    return used_.empty() ? Vec3f::Zero() : Vec3f(sum / static_cast<float>(used_.size()));
}

// The largest distance by which a vertex will have left its expected path at the next refresh, m. Motion in common with
// all vertices does not count.
float SelfContact::largest_deviation(const MovingPoints& points) const {
    const auto ahead = static_cast<float>(options_.refresh_interval);
    const auto moved = [&](std::uint32_t v) -> Vec3f {
        const Vec3f now = points.at(v), was = Eigen::Map<const Vec3f>(points.before + 4 * static_cast<std::size_t>(v));
        return now + (now - was) * ahead - start_[v].head<3>();
    };
    Vec3f mean = Vec3f::Zero();
    for (const std::uint32_t v : used_) mean += moved(v);
    mean /= static_cast<float>(std::max<std::size_t>(1, used_.size()));
    float largest = 0;
    for (const std::uint32_t v : used_) largest = std::max(largest, off_path(v, moved(v) - mean));
    return std::sqrt(largest);
}

// The squared distance of a displacement since the last detection from the vertex' expected path, m^2.
float SelfContact::off_path(std::uint32_t v, const Vec3f& moved) const {
    const Vec3f move = moves_[v].head<3>();
    const float along = moved.dot(move) / std::max(1e-20F, move.squaredNorm());
    return (moved - move * std::clamp(along, 0.0F, static_cast<float>(options_.horizon))).squaredNorm();
}

std::vector<float> SelfContact::clearances(const MovingPoints& points) const {
    if (!has_detected_) return {};
    std::vector<float> clearances(points.count, std::numeric_limits<float>::max());
    limit_clearances(pairs_.vertex_triangle, points, clearances);
    limit_clearances(pairs_.edge_edge, points, clearances);
    return clearances;
}

void SelfContact::limit_clearances(const PairList& pairs, const MovingPoints& points,
                                   std::vector<float>& clearances) const {
    const std::size_t first = first_side(pairs.kind());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const PairBlock& block = pairs.blocks()[i / kBlock];
        const std::size_t at = i % kBlock;
        if (block.side[at] == 0) continue;
        const float half = std::max(0.0F, 0.5F * extremes_of(block, at, first, points).apart);
        for (const BlockPoints& vertices : block.vertices) {
            float& clearance = clearances[vertices[at] / 4];
            clearance = std::min(clearance, half);
        }
    }
}

float SelfContact::thickest(const SelfContactOptions& options) const {
    float thickest = 0;
    for (const ContactSheet& sheet : surface_.sheets) thickest = std::max(thickest, sheet.thickness);
    return options.thickness_scale * thickest;
}

}  // namespace selvedge::sim

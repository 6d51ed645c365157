#include "sim/selfcontact/self_contact.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <utility>

#include "sim/selfcontact/kernels.h"

namespace selvedge::sim {
namespace {

constexpr int kTestInterval = 96;  // sub-steps: no plane vouches for pairs that were not found in time

const SelfContactKernels& loops() {
    return self_contact_kernels(simd_level());
}

// Those of the pairs that have a vertex for which `is_wanted` holds.
template <class IsWanted>
std::vector<TrianglePair> pairs_with(const ContactSurface& surface, std::span<const TrianglePair> pairs,
                                     const IsWanted& is_wanted) {
    const auto has = [&](std::uint32_t triangle) {
        return std::ranges::any_of(surface.triangles[triangle].vertices, is_wanted);
    };
    std::vector<TrianglePair> wanted;
    std::ranges::copy_if(pairs, std::back_inserter(wanted),
                         [&](TrianglePair pair) { return has(pair.first) || has(pair.second); });
    return wanted;
}

// Which of the two sides of a pair has a vertex for which `is_wanted` holds.
template <class IsWanted>
std::array<bool, 2> sides_with(const PairBlock& block, std::size_t at, PairKind kind, const IsWanted& is_wanted) {
    const std::size_t first = first_side(kind);
    std::array<bool, 2> has{false, false};
    for (std::size_t k = 0; k < 4; ++k) {
        bool& side = has[k < first ? 0 : 1];
        side = side || is_wanted(block.vertices[k][at] / 4);
    }
    return has;
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
    if (has_detected_ && is_clean_) return;
    mean_moves_.clear();
    detect(points, expected(points), options);
}

void SelfContact::substep(const MovingPoints& points, const SelfContactOptions& options) {
    counts_.acted += static_cast<long>(loops().solve_contacts(contacts_.blocks(), points.now, points.before));
    ++since_detection_;
    ++since_test_;
    if (since_detection_ % options.refresh_interval == 0) {
        look_back(points, options.refresh_interval);
        const MovingPoints measured = expected(points);
        const auto [off_path, from_mark] = paths_.measure(measured, static_cast<float>(options.refresh_interval));
        // Two vertices may leave their paths towards each other.
        const float limit = 0.5F * options.margin + 0.25F * thickest(options);
        if (off_path <= limit) {
            if (from_mark > 0.125F * options.margin) refresh(points, measured, options);
        } else {
            const MovingPoints from = certify(points, options) ? expected(points) : measured;
            is_clean_ ? detect_where_off_path(points, from, limit, options) : detect(points, from, options);
        }
    }
}

void SelfContact::look_back(const MovingPoints& points, int substeps) {
    mean_moves_.resize(points.count, Vec4f::Zero());
    for (const std::uint32_t v : used_) {
        const Vec4f now = points.wide_at(v);
        mean_moves_[v] = (now - seen_[v]) / static_cast<float>(substeps);
        seen_[v] = now;
    }
}

// The points with the motion to be expected of them. Vertices that are pulled and pushed back within each sub-step have
// a speed and yet stay where they are; those that were parted were displaced and have no speed. So it is the smaller of
// the last displacement and the mean one since the last look.
MovingPoints SelfContact::expected(const MovingPoints& points) {
    if (mean_moves_.empty()) return points;
    expected_.resize(points.count + 1, Vec4f::Zero());
    for (const std::uint32_t v : used_) {
        const Vec4f now = points.wide_at(v), last = now - points.wide_was_at(v), &mean = mean_moves_[v];
        expected_[v] = now - (mean.squaredNorm() < last.squaredNorm() ? mean : last);
    }
    return {.now = points.now, .before = expected_.front().data(), .count = points.count};
}

void SelfContact::end_step(const MovingPoints& points, const SelfContactOptions& options) {
    if (is_clean_) {
        certify(points, options);
    } else {
        untangle(points, options);
    }
}

void SelfContact::detect(const MovingPoints& points, const MovingPoints& from, const SelfContactOptions& options) {
    ++counts_.detections;
    paths_.start(used_, from);
    search_.select_all();
    const Sweep sweep = paths_.sweep(points);
    search_.find_triangles(loops(), surface_, points.now, sweep, reach(options));
    look_for_crossings(points, options);
    list_pairs(sweep, points, expected(points), options);  // look_for_crossings() may have moved them
}

// Asks only packets of triangles with a vertex that is off its path by more than the limit (m). The others keep their
// paths and the pairs among them.
void SelfContact::detect_where_off_path(const MovingPoints& points, const MovingPoints& from, float limit,
                                        const SelfContactOptions& options) {
    ++counts_.local_detections;
    is_off_.assign(points.count, 0);
    for (const std::uint32_t v : used_) is_off_[v] = paths_.squared_deviation(v) > limit * limit ? 1 : 0;
    search_.select(surface_, is_off_);
    paths_.restart(search_.stays(), from);
    const Sweep sweep = paths_.sweep(points);
    search_.find_triangles(loops(), surface_, points.now, sweep, reach(options));
    if (has_new_crossing(points, options)) {
        is_doubtful_ = true;
        return detect(points, from, options);
    }
    list_pairs(sweep, points, from, options);
}

void SelfContact::list_pairs(const Sweep& sweep, const MovingPoints& points, const MovingPoints& from,
                             const SelfContactOptions& options) {
    counts_.asked += search_.share_asked();
    counts_.triangle_pairs += static_cast<long>(search_.new_triangle_pairs().size());
    start_.resize(points.count, Vec4f::Zero());
    seen_.resize(points.count, Vec4f::Zero());
    for (const std::uint32_t v : used_) seen_[v] = start_[v] = points.wide_at(v);
    start_frame_ = paths_.frame(points);
    search_.find_elements(loops(), surface_, points.now, sweep,
                          {.margin = options.margin, .least = has_layers_ && !is_clean_ ? reach(options) : 0},
                          options.thickness_scale, pairs_);
    counts_.pairs += static_cast<long>(pairs_.size());
    judge_sides();
    dividers_.forget();
    has_detected_ = true;
    since_detection_ = 0;
    refresh(points, from, options);
}

// Unless the planes vouch for all pairs, an exact test does. A crossing that is new goes back.
void SelfContact::look_for_crossings(const MovingPoints& points, const SelfContactOptions& options) {
    if (is_clean_ && !is_doubtful_ && since_test_ < kTestInterval) return;
    test_exactly(points);
    for (int i = 0; !clean_.empty() && !is_clean_ && i < options.untangling_iterations; ++i) {
        ++counts_.untangling_iterations;
        find_suspects(points);
        untangler_.separate(surface_, crossings_, clean_, points);
        test_suspects(points);
    }
    if (is_clean_) keep_clean_state(points);
}

// Untangling moves only vertices of crossings, so only pairs of triangles with such vertices can begin or cease to
// cross.
void SelfContact::find_suspects(const MovingPoints& points) {
    bool is_new = false;
    is_suspect_.resize(points.count, 0);
    for (const Crossing& crossing : crossings_) {
        for (const std::uint32_t v : vertices_of(crossing, surface_))
            is_new |= std::exchange(is_suspect_[v], std::uint8_t{1}) == 0;
    }
    if (is_new) suspects_ = pairs_with(surface_, search_.triangle_pairs(), [&](auto v) { return is_suspect_[v] != 0; });
}

void SelfContact::test_suspects(const MovingPoints& points) {
    ++counts_.local_tests;
    crossings_ = crossings_of(suspects_, points);
    is_clean_ = crossings_.empty();
}

// Tests the new pairs of triangles with a vertex so far off its path that the pairs of before do not cover it; from
// time to time, all.
bool SelfContact::has_new_crossing(const MovingPoints& points, const SelfContactOptions& options) {
    if (since_test_ >= kTestInterval) {
        test_exactly(points);
        if (is_clean_) keep_clean_state(points);
        return !is_clean_;
    }
    const float covered = 0.5F * (options.margin + thickest(options));
    const std::vector<TrianglePair> doubtful = pairs_with(surface_, search_.new_triangle_pairs(), [&](auto v) {
        return paths_.squared_deviation(v) > covered * covered;
    });
    if (doubtful.empty()) return false;
    ++counts_.local_tests;
    if (!crossings_of(doubtful, points).empty()) return true;
    keep_clean_state(points);
    return false;
}

std::vector<Crossing> SelfContact::crossings_of(std::span<const TrianglePair> pairs, const MovingPoints& points) {
    std::vector<Crossing> found =
        find_crossings(surface_, search_, search_.piercing(loops(), pairs, points.now), points.now);
    if (pairs.size() == search_.triangle_pairs().size()) keep_excuses(found);
    std::erase_if(found, [&](const Crossing& crossing) { return is_excused(crossing); });
    return found;
}

bool SelfContact::is_excused(std::uint32_t vertex) const {
    return (vertex < is_pinched_.size() && is_pinched_[vertex] != 0) ||
           (vertex < was_excused_.size() && was_excused_[vertex] != 0);
}

bool SelfContact::is_excused(const Crossing& crossing) const {
    if (is_pinched_.empty() && was_excused_.empty()) return false;
    const ContactEdge& edge = surface_.edges[crossing.edge];
    const ContactTriangle& triangle = surface_.triangles[crossing.triangle];
    const auto excused = [this](std::uint32_t v) { return is_excused(v); };
    return std::ranges::any_of(edge.ends, excused) && std::ranges::any_of(triangle.vertices, excused);
}

// After a test of all pairs: what crosses and was excused stays so, and nothing else but what is pinched now.
void SelfContact::keep_excuses(std::span<const Crossing> crossings) {
    if (is_pinched_.empty() && was_excused_.empty()) return;
    std::vector<std::uint8_t> kept;
    for (const Crossing& crossing : crossings) {
        if (!is_excused(crossing)) continue;
        kept.resize(layers_.size(), 0);
        for (const std::uint32_t v : vertices_of(crossing, surface_)) kept[v] = 1;
    }
    was_excused_ = std::move(kept);
}

void SelfContact::test_exactly(const MovingPoints& points) {
    ++counts_.exact_tests;
    since_test_ = 0;
    crossings_ = crossings_of(search_.triangle_pairs(), points);
    is_suspect_.assign(points.count, 0);
    is_clean_ = crossings_.empty();
    is_doubtful_ = false;
}

void SelfContact::keep_clean_state(const MovingPoints& points) {
    clean_.resize(points.count, Vec4f::Zero());
    for (const std::uint32_t v : used_) clean_[v] = points.wide_at(v);
}

// While the cloth crosses itself, sides are not always known. A pair whose sides both touch a crossing is neither
// pushed nor certified, but if its sides are of different layers and the cloth is flat there, it is known which of them
// belongs outside: sides on the wrong side of each other are pushed through.
void SelfContact::judge_sides() {
    swapped_.assign(layers_.size(), 0);
    if (!is_pinched_.empty() || !was_excused_.empty()) {
        judge_excused(pairs_.vertex_triangle);
        judge_excused(pairs_.edge_edge);
    }
    if (is_clean_) return;
    std::vector<bool> is_tangled(layers_.size(), false);
    for (const Crossing& crossing : crossings_) {
        for (const std::uint32_t v : vertices_of(crossing, surface_)) is_tangled[v] = true;
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

void SelfContact::judge_excused(PairList& pairs) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        PairBlock& block = pairs.blocks()[i / kBlock];
        const std::size_t at = i % kBlock;
        const std::array<bool, 2> has =
            sides_with(block, at, pairs.kind(), [this](std::uint32_t v) { return is_excused(v); });
        if (has[0] && has[1]) block.side[at] = 0;
    }
}

void SelfContact::judge_sides(PairList& pairs, const std::vector<bool>& is_tangled, const std::vector<Vec3f>& normals) {
    constexpr float kUnclear = 0.3F;  // cosine: about 73 degrees from the normal on
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        PairBlock& block = pairs.blocks()[i / kBlock];
        const std::size_t at = i % kBlock;
        const std::array<bool, 2> has =
            sides_with(block, at, pairs.kind(), [&](std::uint32_t v) { return is_tangled[v]; });
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

void SelfContact::refresh(const MovingPoints& points, const MovingPoints& from, const SelfContactOptions& options) {
    ++counts_.refreshes;
    paths_.mark(points);
    contacts_.clear();
    list_contacts(pairs_.vertex_triangle, from, options);
    list_contacts(pairs_.edge_edge, from, options);
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
            // Triangles around an edge or a vertex share it: one of them lists the contact.
            if (pairs.kind() == PairKind::VertexTriangle && !search_.owns_closest_point(block, at)) continue;
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
            contacts_.add(contact);
        }
    }
}

bool SelfContact::certify(const MovingPoints& points, const SelfContactOptions& options) {
    if (!has_detected_) return false;
    const CertificateReport report =
        dividers_.certify(loops(), pairs_, {used_, start_},
                          {paths_.frame(points) - start_frame_, paths_.mean_move(), options.is_carried}, points);
    if (report.undivided > 0) since_test_ = kTestInterval;  // they may cross: the next detection tests all
    counts_.parted += report.parted;
    counts_.truncated += report.truncated;
    return report.parted > 0 || report.truncated > 0;
}

// When the last crossing is gone, contacts must hold at once, or the next sub-step draws the tangle shut again.
void SelfContact::untangle(const MovingPoints& points, const SelfContactOptions& options) {
    for (int i = 0; !is_clean_ && i < options.untangling_iterations; ++i) {
        ++counts_.untangling_iterations;
        if (i > 0) find_suspects(points);
        untangler_.separate(surface_, crossings_, clean_, points);
        if (clean_.empty() || 2 * i >= options.untangling_iterations) untangler_.smooth(surface_, crossings_, points);
        i == 0 ? test_exactly(points) : test_suspects(points);
    }
    if (!is_clean_) {
        certify(points, options);
        return;
    }
    keep_clean_state(points);
    detect(points, expected(points), options);
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

#include "sim/selfcontact/pair_search.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

namespace selvedge::sim {
namespace {

constexpr std::size_t kPacket = kBlock;
constexpr float kSharpBend = 0.5F;  // cosine of the angle between two triangles above which their edge is sharp: 60 deg

constexpr std::uint8_t kInside = 1U << 7;  // as a bit of `owned_`: the set of all three corners

std::size_t padded_count(std::size_t count) {
    return (count + kPacket - 1) / kPacket * kPacket;
}

std::span<const ContactTriangle> triangles_of(const ContactSurface& surface, std::size_t packet) {
    const std::span all(surface.triangles);
    return all.subspan(packet * kPacket, std::min(kPacket, all.size() - packet * kPacket));
}

}  // namespace

void PairSearch::set_surface(const ContactSurface& surface, std::uint32_t dummy) {
    dummy_ = dummy;
    const std::size_t count = surface.triangles.size();
    padded_ = padded_count(count);
    owned_vertices_.assign(count, {kNoElement, kNoElement, kNoElement});
    owned_edges_.assign(count, {kNoElement, kNoElement, kNoElement});
    owned_.assign(count, kInside);
    shortest_edge_.resize(count);
    for (std::size_t k = 0; k < 3; ++k) {
        corner_[k].assign(padded_, 4 * dummy);
        sewn_[k].assign(padded_, kNoElement);
        for (auto* const row : {&low_[k], &high_[k], &normal_[k], &middle_[k]}) row->assign(padded_, 0);
        // Packets that do not exist have boxes that overlap none.
        packet_low_[k].assign(padded_count(padded_ / kPacket), std::numeric_limits<float>::max());
        packet_high_[k].assign(padded_count(padded_ / kPacket), std::numeric_limits<float>::lowest());
    }
    is_sharp_.assign(surface.edges.size(), 0);
    sharp_.assign(dummy + 1, 0);
    vertex_boxes_.resize(dummy);
    edge_boxes_.resize(surface.edges.size());
    triangle_boxes_.resize(count);
    triangle_pairs_.clear();
    select_all();
    sheet_.assign(padded_, kNoElement);
    flat_.assign(padded_, 0);
    u_.assign(padded_, 0);
    v_.assign(padded_, 0);
    assign_owners(surface);
}

// Each vertex and edge belongs to the first of its triangles.
void PairSearch::assign_owners(const ContactSurface& surface) {
    std::vector<std::uint8_t> vertex_seen(dummy_, 0), edge_seen(surface.edges.size(), 0);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const ContactTriangle& triangle = surface.triangles[t];
        sheet_[t] = triangle.sheet;
        u_[t] = triangle.middle.x();
        v_[t] = triangle.middle.y();
        shortest_edge_[t] = std::numeric_limits<float>::max();
        std::size_t vertices = 0, edges = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t v = triangle.vertices[k], e = triangle.edges[k];
            corner_[k][t] = 4 * v;
            sewn_[k][t] = surface.sewn_as(v);
            shortest_edge_[t] = std::min(shortest_edge_[t], surface.edges[e].rest_length);
            if (vertex_seen[v] == 0) {
                owned_vertices_[t][vertices++] = v;
                owned_[t] |= static_cast<std::uint8_t>(1U << (1U << k));
            }
            if (edge_seen[e] == 0) {
                owned_edges_[t][edges++] = e;
                owned_[t] |= static_cast<std::uint8_t>(1U << (1U << k | 1U << (k + 1) % 3));
            }
            vertex_seen[v] = edge_seen[e] = 1;
        }
    }
}

TriangleRows PairSearch::rows() {
    TriangleRows rows{
        .padded = padded_, .sheet = sheet_.data(), .u = u_.data(), .v = v_.data(), .is_flat = flat_.data()};
    for (std::size_t k = 0; k < 3; ++k) {
        rows.corner[k] = corner_[k].data();
        rows.sewn[k] = sewn_[k].data();
        rows.low[k] = low_[k].data();
        rows.high[k] = high_[k].data();
        rows.normal[k] = normal_[k].data();
        rows.middle[k] = middle_[k].data();
        rows.packet_low[k] = packet_low_[k].data();
        rows.packet_high[k] = packet_high_[k].data();
    }
    return rows;
}

void PairSearch::select_all() {
    asked_.assign(padded_count(padded_ / kPacket) / kPacket, 0xFFFFU);
    asked_packets_.resize(padded_ / kPacket);
    std::iota(asked_packets_.begin(), asked_packets_.end(), std::size_t{0});
    stays_.assign(dummy_, 0);
}

void PairSearch::select(const ContactSurface& surface, std::span<const std::uint8_t> is_off) {
    std::ranges::fill(asked_, 0U);
    asked_packets_.clear();
    stays_.assign(dummy_, 0);
    for (std::size_t packet = 0; packet < padded_ / kPacket; ++packet) {
        const std::span triangles = triangles_of(surface, packet);
        const bool is_asked = std::ranges::any_of(triangles, [&](const ContactTriangle& triangle) {
            return std::ranges::any_of(triangle.vertices, [&](std::uint32_t v) { return is_off[v] != 0; });
        });
        if (is_asked) {
            asked_[packet / kPacket] |= 1U << packet % kPacket;
            asked_packets_.push_back(packet);
        } else {
            for (const ContactTriangle& triangle : triangles) {
                for (const std::uint32_t v : triangle.vertices) stays_[v] = 1;
            }
        }
    }
}

bool PairSearch::asks(std::uint32_t triangle) const {
    const std::size_t packet = triangle / kPacket;
    return (asked_[packet / kPacket] >> packet % kPacket & 1U) != 0;
}

void PairSearch::find_triangles(const SelfContactKernels& loops, const ContactSurface& surface, const float* points,
                                const Sweep& sweep, float reach) {
    const TriangleRows all = rows();
    for (const std::size_t packet : asked_packets_) loops.bound_packet(all, packet, points, sweep, reach / 2);
    find_flat(surface);
    bound_elements(surface, points, sweep, reach / 2);
    std::erase_if(triangle_pairs_, [&](TrianglePair pair) { return asks(pair.first) || asks(pair.second); });
    known_ = triangle_pairs_.size();
    found_.resize(kPacket * padded_);
    const auto real = static_cast<std::uint32_t>(surface.triangles.size());
    for (const std::size_t packet : asked_packets_) {
        const std::size_t count = loops.find_pairs(all, packet, asked_.data(), found_.data());
        for (std::size_t i = 0; i < count; ++i) {
            if (found_[i].first < real && found_[i].second < real) triangle_pairs_.push_back(found_[i]);
        }
    }
}

// A vertex is flat if none of the triangles around it has a sharp edge.
void PairSearch::find_flat(const ContactSurface& surface) {
    for (const std::size_t packet : asked_packets_) {
        for (const ContactTriangle& triangle : triangles_of(surface, packet)) {
            for (const std::uint32_t e : triangle.edges) find_sharp(surface, e);
        }
    }
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const auto [a, b, c] = surface.triangles[t].vertices;
        flat_[t] = is_flat(a) && is_flat(b) && is_flat(c) ? ~0U : 0U;
    }
}

void PairSearch::find_sharp(const ContactSurface& surface, std::uint32_t edge) {
    const std::array<std::uint32_t, 2>& sides = surface.edges[edge].triangles;
    if (sides[1] == kNoElement) return;
    const bool is_sharp = normal_of(sides[0]).dot(normal_of(sides[1])) <= kSharpBend;
    if (is_sharp == (is_sharp_[edge] != 0)) return;
    is_sharp_[edge] = is_sharp ? 1 : 0;
    for (const std::uint32_t t : sides) {
        for (const std::uint32_t v : surface.triangles[t].vertices) is_sharp ? ++sharp_[v] : --sharp_[v];
    }
}

// Boxes of the elements that the asked triangles own, and of these. Elements that other triangles own have no vertex
// with a new path.
void PairSearch::bound_elements(const ContactSurface& surface, const float* points, const Sweep& sweep, float grow) {
    const Vec4f more(grow, grow, grow, 0), frame(sweep.frame[0], sweep.frame[1], sweep.frame[2], 0);
    const auto for_asked = [&](const auto& apply) {
        for (const std::size_t packet : asked_packets_) {
            const std::size_t end = std::min((packet + 1) * kPacket, surface.triangles.size());
            for (std::size_t t = packet * kPacket; t < end; ++t) apply(t);
        }
    };
    const auto bound_vertices = [&](std::size_t t) {
        for (const std::uint32_t v : owned_vertices_[t]) {
            if (v == kNoElement) return;
            const std::size_t at = 4 * static_cast<std::size_t>(v);
            const Vec4f x = Eigen::Map<const Vec4f>(points + at) - frame;
            const Vec4f end = x + Eigen::Map<const Vec4f>(sweep.moves + at) * sweep.substeps;
            vertex_boxes_[v] = {x.cwiseMin(end) - more, x.cwiseMax(end) + more};
        }
    };
    for_asked(bound_vertices);
    for_asked([&](std::size_t t) {
        for (const std::uint32_t e : owned_edges_[t]) {
            if (e == kNoElement) break;
            const auto [a, b] = surface.edges[e].ends;
            edge_boxes_[e] = around(vertex_boxes_[a], vertex_boxes_[b]);
        }
        const auto [a, b, c] = surface.triangles[t].vertices;
        triangle_boxes_[t] = around(around(vertex_boxes_[a], vertex_boxes_[b]), vertex_boxes_[c]);
    });
}

void PairSearch::find_elements(const SelfContactKernels& loops, const ContactSurface& surface, const float* points,
                               const Sweep& sweep, const PairReach& reach, float thickness_scale, ContactPairs& pairs) {
    constexpr std::size_t kAtOnce = 16;  // blocks of each kind to be measured: 40 kB, which a near cache holds
    for (PairList* const list : {&pairs.vertex_triangle, &pairs.edge_edge}) {
        keep_known(loops, points, sweep, reach, *list);
    }
    noted_vertices_.clear(dummy_);
    noted_edges_.clear(dummy_);
    for (const TrianglePair pair : new_triangle_pairs()) {
        note_elements(surface, pair, thickness_scale);
        if (noted_vertices_.block_count() > kAtOnce)
            measure(loops, noted_vertices_, points, sweep, reach, pairs.vertex_triangle);
        if (noted_edges_.block_count() > kAtOnce) measure(loops, noted_edges_, points, sweep, reach, pairs.edge_edge);
    }
    measure(loops, noted_vertices_, points, sweep, reach, pairs.vertex_triangle);
    measure(loops, noted_edges_, points, sweep, reach, pairs.edge_edge);
}

// Keeps the pairs that are not asked and still within reach, with dividers of now.
void PairSearch::keep_known(const SelfContactKernels& loops, const float* points, const Sweep& sweep,
                            const PairReach& reach, PairList& pairs) {
    if (known_ == 0) return pairs.clear(dummy_);
    gone_.clear();
    for (std::size_t i = 0; i < pairs.size(); i += kBlock) {
        PairBlock& block = pairs.blocks()[i / kBlock];
        const unsigned near = loops.measure_pairs(pairs.kind(), block, points, sweep, reach);
        for (std::size_t at = 0; at < kBlock && i + at < pairs.size(); ++at) {
            const bool is_near = (near >> at & 1U) != 0;
            if (!is_near || asks(block.triangles[0][at]) || asks(block.triangles[1][at])) gone_.push_back(i + at);
        }
    }
    pairs.remove(gone_);
}

// The pairs are copied in sixteens; those that fill up the last are pairs of a triangle with itself.
std::vector<TrianglePair> PairSearch::piercing(const SelfContactKernels& loops, std::span<const TrianglePair> pairs,
                                               const float* points) {
    const TriangleRows all = rows();
    std::vector<TrianglePair> found;
    for (std::size_t first = 0; first < pairs.size(); first += kBlock) {
        std::array<TrianglePair, kBlock> block{};
        const std::size_t count = std::min(kBlock, pairs.size() - first);
        std::copy_n(pairs.begin() + static_cast<std::ptrdiff_t>(first), count, block.begin());
        unsigned bits = loops.find_piercing(all, block.data(), points) & (0xFFFFU >> (kBlock - count));
        for (; bits != 0; bits &= bits - 1) found.push_back(block[static_cast<std::size_t>(__builtin_ctz(bits))]);
    }
    return found;
}

// Notes the pairs of elements of two triangles whose boxes overlap.
void PairSearch::note_elements(const ContactSurface& surface, TrianglePair pair, float thickness_scale) {
    const std::uint32_t a = pair.first, b = pair.second;
    std::optional<float> radius;
    const auto add = [&](PairList& noted, const std::array<std::uint32_t, 4>& vertices, TrianglePair of) {
        if (!radius) radius = radius_of(surface, pair, thickness_scale);
        const float friction = 0.5F * (surface.sheets[surface.triangles[a].sheet].friction +
                                       surface.sheets[surface.triangles[b].sheet].friction);
        noted.add({4 * vertices[0], 4 * vertices[1], 4 * vertices[2], 4 * vertices[3]}, of, *radius, friction);
    };
    const auto add_vertices = [&](std::uint32_t of, std::uint32_t t) {
        const ContactBox& box = triangle_boxes_[t];
        for (const std::uint32_t v : owned_vertices_[of]) {
            if (v == kNoElement) return;
            if (!overlap(vertex_boxes_[v], box) || is_sewn_to(surface, v, t)) continue;
            const std::array<std::uint32_t, 3>& corners = surface.triangles[t].vertices;
            add(noted_vertices_, {v, corners[0], corners[1], corners[2]}, {of, t});
        }
    };
    add_vertices(a, b);
    add_vertices(b, a);
    const ContactBox& box = triangle_boxes_[b];  // holds those of its edges
    for (const std::uint32_t e : owned_edges_[a]) {
        if (e == kNoElement) return;
        if (!overlap(edge_boxes_[e], box)) continue;
        for (const std::uint32_t f : owned_edges_[b]) {
            if (f == kNoElement) break;
            if (!overlap(edge_boxes_[e], edge_boxes_[f]) || have_common_end(surface, e, f)) continue;
            const std::array<std::uint32_t, 2>&mine = surface.edges[e].ends, &theirs = surface.edges[f].ends;
            add(noted_edges_, {mine[0], mine[1], theirs[0], theirs[1]}, pair);
        }
    }
}

// A set of corners of a triangle is a number of three bits; `owned_` has a bit for each set.
bool PairSearch::owns_closest_point(const PairBlock& block, std::size_t at) const {
    unsigned corners = 0;
    for (std::size_t k = 0; k < 3; ++k) corners |= block.weight[k + 1][at] != 0 ? 1U << k : 0U;
    return (owned_[block.triangles[1][at]] >> corners & 1U) != 0;
}

bool PairSearch::is_sewn_to(const ContactSurface& surface, std::uint32_t v, std::uint32_t t) const {
    const std::uint32_t sewn = surface.sewn_as(v);
    return sewn_[0][t] == sewn || sewn_[1][t] == sewn || sewn_[2][t] == sewn;
}

bool PairSearch::have_common_end(const ContactSurface& surface, std::uint32_t e, std::uint32_t f) {
    const std::uint32_t a = surface.sewn_as(surface.edges[e].ends[0]), b = surface.sewn_as(surface.edges[e].ends[1]);
    const std::uint32_t c = surface.sewn_as(surface.edges[f].ends[0]), d = surface.sewn_as(surface.edges[f].ends[1]);
    return a == c || a == d || b == c || b == d;
}

float PairSearch::radius_of(const ContactSurface& surface, TrianglePair pair, float thickness_scale) const {
    constexpr float kOfEdge = 0.25F;  // of the shortest edge, for elements whose triangles share a vertex
    const ContactTriangle &first = surface.triangles[pair.first], &second = surface.triangles[pair.second];
    const float radius =
        thickness_scale * 0.5F * (surface.sheets[first.sheet].thickness + surface.sheets[second.sheet].thickness);
    if (!surface.has_any(second, first.vertices)) return radius;
    return std::min(radius, kOfEdge * std::min(shortest_edge_[pair.first], shortest_edge_[pair.second]));
}

// Adds the noted pairs that are within reach, and clears the noted ones.
void PairSearch::measure(const SelfContactKernels& loops, PairList& noted, const float* points, const Sweep& sweep,
                         const PairReach& reach, PairList& pairs) {
    for (std::size_t i = 0; i < noted.block_count(); ++i) {
        PairBlock& block = noted.blocks()[i];
        unsigned found = loops.measure_pairs(noted.kind(), block, points, sweep, reach);
        for (; found != 0; found &= found - 1) pairs.add(block, static_cast<std::size_t>(__builtin_ctz(found)));
    }
    noted.clear(dummy_);
}

}  // namespace selvedge::sim

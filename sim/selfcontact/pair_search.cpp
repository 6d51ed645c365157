#include "sim/selfcontact/pair_search.h"

#include <algorithm>
#include <optional>

namespace selvedge::sim {
namespace {

constexpr std::size_t kPacket = kBlock;
constexpr float kSharpBend = 0.5F;  // cosine of the angle between two triangles above which their edge is sharp: 60 deg

std::size_t padded_count(std::size_t count) {
    return (count + kPacket - 1) / kPacket * kPacket;
}

}  // namespace

void PairSearch::set_surface(const ContactSurface& surface, std::uint32_t dummy) {
    dummy_ = dummy;
    const std::size_t count = surface.triangles.size();
    padded_ = padded_count(count);
    owned_vertices_.assign(count, {kNoElement, kNoElement, kNoElement});
    owned_edges_.assign(count, {kNoElement, kNoElement, kNoElement});
    shortest_edge_.resize(count);
    for (std::size_t k = 0; k < 3; ++k) {
        corner_[k].assign(padded_, 4 * dummy);
        sewn_[k].assign(padded_, kNoElement);
        for (auto* const row : {&low_[k], &high_[k], &normal_[k], &middle_[k]}) row->assign(padded_, 0);
        // Packets that do not exist have boxes that overlap none.
        packet_low_[k].assign(padded_count(padded_ / kPacket), std::numeric_limits<float>::max());
        packet_high_[k].assign(padded_count(padded_ / kPacket), std::numeric_limits<float>::lowest());
    }
    sheet_.assign(padded_, kNoElement);
    flat_.assign(padded_, 0);
    u_.assign(padded_, 0);
    v_.assign(padded_, 0);
    std::vector<std::uint8_t> vertex_seen(dummy, 0), edge_seen(surface.edges.size(), 0);
    for (std::size_t t = 0; t < count; ++t) {
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
            if (vertex_seen[v] == 0) owned_vertices_[t][vertices++] = v;
            if (edge_seen[e] == 0) owned_edges_[t][edges++] = e;
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

void PairSearch::find_triangles(const SelfContactKernels& loops, const ContactSurface& surface, const float* points,
                                const Sweep& sweep, float reach) {
    const TriangleRows all = rows();
    loops.bound_triangles(all, points, sweep, reach / 2);
    find_flat(surface);
    bound_elements(surface, points, sweep, reach / 2);
    triangle_pairs_.clear();
    found_.resize(kPacket * padded_);
    const auto real = static_cast<std::uint32_t>(surface.triangles.size());
    for (std::size_t packet = 0; packet < padded_ / kPacket; ++packet) {
        const std::size_t count = loops.find_pairs(all, packet, found_.data());
        for (std::size_t i = 0; i < count; ++i) {
            if (found_[i].second < real) triangle_pairs_.push_back(found_[i]);
        }
    }
}

// A vertex is flat if none of the triangles around it has a sharp edge.
void PairSearch::find_flat(const ContactSurface& surface) {
    flat_vertices_.assign(dummy_ + 1, 1);
    for (const ContactEdge& edge : surface.edges) {
        if (edge.triangles[1] == kNoElement) continue;
        if (normal_of(edge.triangles[0]).dot(normal_of(edge.triangles[1])) > kSharpBend) continue;
        for (const std::uint32_t t : edge.triangles) {
            for (const std::uint32_t v : surface.triangles[t].vertices) flat_vertices_[v] = 0;
        }
    }
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const auto flat = [&](std::uint32_t v) { return is_flat(v); };
        flat_[t] = std::ranges::all_of(surface.triangles[t].vertices, flat) ? ~0U : 0U;
    }
}

void PairSearch::bound_elements(const ContactSurface& surface, const float* points, const Sweep& sweep, float grow) {
    const Vec4f more(grow, grow, grow, 0);
    vertex_boxes_.resize(dummy_);
    for (std::size_t v = 0; v < dummy_; ++v) {
        const Vec4f x = Eigen::Map<const Vec4f>(points + 4 * v);
        const Vec4f end = x + Eigen::Map<const Vec4f>(sweep.moves + 4 * v) * sweep.substeps;
        vertex_boxes_[v] = {x.cwiseMin(end) - more, x.cwiseMax(end) + more};
    }
    edge_boxes_.resize(surface.edges.size());
    for (std::size_t e = 0; e < surface.edges.size(); ++e) {
        const auto [a, b] = surface.edges[e].ends;
        edge_boxes_[e] = around(vertex_boxes_[a], vertex_boxes_[b]);
    }
    triangle_boxes_.resize(surface.triangles.size());
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const auto [a, b, c] = surface.triangles[t].vertices;
        triangle_boxes_[t] = around(around(vertex_boxes_[a], vertex_boxes_[b]), vertex_boxes_[c]);
    }
}

void PairSearch::find_elements(const SelfContactKernels& loops, const ContactSurface& surface, const float* points,
                               const Sweep& sweep, const PairReach& reach, float thickness_scale, ContactPairs& pairs) {
    noted_vertices_.clear(dummy_);
    noted_edges_.clear(dummy_);
    for (const TrianglePair pair : triangle_pairs_) note_elements(surface, pair, thickness_scale);
    pairs.vertex_triangle.clear(dummy_);
    pairs.edge_edge.clear(dummy_);
    measure(loops, noted_vertices_, points, sweep, reach, pairs.vertex_triangle);
    measure(loops, noted_edges_, points, sweep, reach, pairs.edge_edge);
}

// Notes the pairs of elements of two triangles whose boxes overlap.
void PairSearch::note_elements(const ContactSurface& surface, TrianglePair pair, float thickness_scale) {
    const std::uint32_t a = pair.first, b = pair.second;
    std::optional<float> radius;
    const auto add = [&](PairList& noted, const std::array<std::uint32_t, 4>& vertices) {
        if (!radius) radius = radius_of(surface, pair, thickness_scale);
        const float friction = 0.5F * (surface.sheets[surface.triangles[a].sheet].friction +
                                       surface.sheets[surface.triangles[b].sheet].friction);
        noted.add({4 * vertices[0], 4 * vertices[1], 4 * vertices[2], 4 * vertices[3]}, *radius, friction);
    };
    const auto add_vertices = [&](std::uint32_t of, std::uint32_t t) {
        const std::array<std::uint32_t, 3>& corners = surface.triangles[t].vertices;
        for (const std::uint32_t v : owned_vertices_[of]) {
            if (v == kNoElement) return;
            if (is_near(surface, v, t)) add(noted_vertices_, {v, corners[0], corners[1], corners[2]});
        }
    };
    add_vertices(a, b);
    add_vertices(b, a);
    for (const std::uint32_t e : owned_edges_[a]) {
        if (e == kNoElement) return;
        for (const std::uint32_t f : owned_edges_[b]) {
            if (f == kNoElement) break;
            if (!are_near(surface, e, f)) continue;
            const std::array<std::uint32_t, 2>&mine = surface.edges[e].ends, &theirs = surface.edges[f].ends;
            add(noted_edges_, {mine[0], mine[1], theirs[0], theirs[1]});
        }
    }
}

bool PairSearch::is_near(const ContactSurface& surface, std::uint32_t v, std::uint32_t t) const {
    if (!overlap(vertex_boxes_[v], triangle_boxes_[t])) return false;
    const std::uint32_t sewn = surface.sewn_as(v);
    return sewn_[0][t] != sewn && sewn_[1][t] != sewn && sewn_[2][t] != sewn;
}

bool PairSearch::are_near(const ContactSurface& surface, std::uint32_t e, std::uint32_t f) const {
    if (!overlap(edge_boxes_[e], edge_boxes_[f])) return false;
    const std::uint32_t a = surface.sewn_as(surface.edges[e].ends[0]), b = surface.sewn_as(surface.edges[e].ends[1]);
    const std::uint32_t c = surface.sewn_as(surface.edges[f].ends[0]), d = surface.sewn_as(surface.edges[f].ends[1]);
    return a != c && a != d && b != c && b != d;
}

float PairSearch::radius_of(const ContactSurface& surface, TrianglePair pair, float thickness_scale) const {
    constexpr float kOfEdge = 0.25F;  // of the shortest edge, for elements whose triangles share a vertex
    const ContactTriangle &first = surface.triangles[pair.first], &second = surface.triangles[pair.second];
    const float radius =
        thickness_scale * 0.5F * (surface.sheets[first.sheet].thickness + surface.sheets[second.sheet].thickness);
    if (!surface.has_any(second, first.vertices)) return radius;
    return std::min(radius, kOfEdge * std::min(shortest_edge_[pair.first], shortest_edge_[pair.second]));
}

void PairSearch::measure(const SelfContactKernels& loops, PairList& noted, const float* points, const Sweep& sweep,
                         const PairReach& reach, PairList& pairs) {
    for (std::size_t i = 0; i < noted.block_count(); ++i) {
        PairBlock& block = noted.blocks()[i];
        unsigned found = loops.measure_pairs(noted.kind(), block, points, sweep, reach);
        for (; found != 0; found &= found - 1) pairs.add(block, static_cast<std::size_t>(__builtin_ctz(found)));
    }
}

}  // namespace selvedge::sim

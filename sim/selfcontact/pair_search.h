#pragma once
// Finds the pairs of mesh elements that can touch soon: boxes of triangles in packets of sixteen, overlapping boxes,
// then the vertices and edges of two triangles against each other. Every vertex and every edge is owned by one
// triangle, so that no pair is found twice. A search asks some of the packets, and keeps what is known of the others.
#include <emmintrin.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "sim/core/math.h"
#include "sim/selfcontact/kernels.h"
#include "sim/selfcontact/pairs.h"
#include "sim/selfcontact/surface.h"

namespace selvedge::sim {

// An axis-aligned box, with four floats per corner, of which the fourth is ignored: one comparison per corner.
struct ContactBox {
    Vec4f low = Vec4f::Constant(std::numeric_limits<float>::max());  // m
    Vec4f high = Vec4f::Constant(std::numeric_limits<float>::lowest());
};

inline ContactBox around(const ContactBox& a, const ContactBox& b) {
    return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
}

inline bool overlap(const ContactBox& a, const ContactBox& b) {
    constexpr int kXyz = 7;
    const __m128 above = _mm_cmpgt_ps(_mm_load_ps(a.low.data()), _mm_load_ps(b.high.data()));
    const __m128 below = _mm_cmplt_ps(_mm_load_ps(a.high.data()), _mm_load_ps(b.low.data()));
    return (_mm_movemask_ps(_mm_or_ps(above, below)) & kXyz) == 0;
}

// The candidates of self-contact.
struct ContactPairs {
    PairList vertex_triangle{PairKind::VertexTriangle};
    PairList edge_edge{PairKind::EdgeEdge};

    std::size_t size() const { return vertex_triangle.size() + edge_edge.size(); }
};

class PairSearch {
 public:
    // Prepares for a surface, which all later calls must be given; dummy: the index of the dummy vertex.
    void set_surface(const ContactSurface& surface, std::uint32_t dummy);

    // The next search asks all packets, or those that have a vertex whose `is_off` is not 0 (by vertex).
    void select_all();
    void select(const ContactSurface& surface, std::span<const std::uint8_t> is_off);
    bool asks(std::uint32_t triangle) const;
    double share_asked() const {
        return static_cast<double>(asked_packets_.size() * kBlock) / static_cast<double>(padded_);
    }
    // By vertex: 1 for vertices that packets have which are not asked.
    std::span<const std::uint8_t> stays() const { return stays_; }

    // Computes boxes and finds pairs of triangles. reach: the largest distance at which two sides matter, m.
    void find_triangles(const SelfContactKernels& loops, const ContactSurface& surface, const float* points,
                        const Sweep& sweep, float reach);

    // Of those, finds the pairs of elements within reach. `pairs` are those of the last search, of which the ones that
    // were not asked and are still within reach remain. The radius of a pair is the mean thickness of its sheets times
    // `thickness_scale`, but less for elements of triangles that share a vertex: a quarter of their shortest edge.
    void find_elements(const SelfContactKernels& loops, const ContactSurface& surface, const float* points,
                       const Sweep& sweep, const PairReach& reach, float thickness_scale, ContactPairs& pairs);

    // All pairs of triangles, and those that the last search found.
    std::span<const TrianglePair> triangle_pairs() const { return triangle_pairs_; }
    std::span<const TrianglePair> new_triangle_pairs() const { return triangle_pairs().subspan(known_); }

    // Those of the pairs that are near enough to cross, in their order.
    std::vector<TrianglePair> piercing(const SelfContactKernels& loops, std::span<const TrianglePair> pairs,
                                       const float* points);

    Vec3f normal_of(std::uint32_t triangle) const {
        return {normal_[0][triangle], normal_[1][triangle], normal_[2][triangle]};
    }
    // Of a vertex and a triangle: whether the point of the triangle that is closest to the vertex is inside of it, or
    // on one of its edges or corners that no other triangle owns.
    bool owns_closest_point(const PairBlock& block, std::size_t at) const;
    bool is_flat(std::uint32_t vertex) const { return sharp_[vertex] == 0; }
    const std::array<std::uint32_t, 3>& owned_edges(std::uint32_t triangle) const { return owned_edges_[triangle]; }

 private:
    TriangleRows rows();
    void assign_owners(const ContactSurface& surface);
    void find_flat(const ContactSurface& surface);
    void find_sharp(const ContactSurface& surface, std::uint32_t edge);
    void bound_elements(const ContactSurface& surface, const float* points, const Sweep& sweep, float grow);
    void note_elements(const ContactSurface& surface, TrianglePair pair, float thickness_scale);
    // Whether a vertex is, or is sewn to, a corner of the triangle.
    bool is_sewn_to(const ContactSurface& surface, std::uint32_t vertex, std::uint32_t triangle) const;
    // Whether two edges have an end in common, or ends that are sewn together.
    static bool have_common_end(const ContactSurface& surface, std::uint32_t edge, std::uint32_t other);
    float radius_of(const ContactSurface& surface, TrianglePair pair, float thickness_scale) const;
    void measure(const SelfContactKernels& loops, PairList& noted, const float* points, const Sweep& sweep,
                 const PairReach& reach, PairList& pairs);
    void keep_known(const SelfContactKernels& loops, const float* points, const Sweep& sweep, const PairReach& reach,
                    PairList& pairs);

    std::uint32_t dummy_ = 0;
    std::size_t padded_ = 0;
    std::vector<std::array<std::uint32_t, 3>> owned_vertices_, owned_edges_;  // by triangle, kNoElement at the end
    std::vector<std::uint8_t> owned_;                                         // by triangle, see owns_closest_point()
    std::vector<float> shortest_edge_;                                        // by triangle, m
    std::array<std::vector<std::uint32_t>, 3> corner_, sewn_;
    std::vector<std::uint32_t> sheet_, flat_;
    std::vector<std::uint8_t> is_sharp_;      // by edge
    std::vector<std::uint16_t> sharp_;        // by vertex: sharp edges of the triangles at it, times their number
    std::vector<std::uint32_t> asked_;        // a bit per packet, sixteen per number
    std::vector<std::size_t> asked_packets_;  // ascending
    std::vector<std::uint8_t> stays_;         // by vertex
    std::vector<float> u_, v_;
    std::array<std::vector<float>, 3> low_, high_, normal_, middle_, packet_low_, packet_high_;
    std::vector<ContactBox> vertex_boxes_, edge_boxes_, triangle_boxes_;  // over the sweep
    std::vector<TrianglePair> triangle_pairs_, found_;
    std::size_t known_ = 0;          // triangle pairs that the last search did not ask
    std::vector<std::size_t> gone_;  // scratch
    PairList noted_vertices_{PairKind::VertexTriangle}, noted_edges_{PairKind::EdgeEdge};  // to be measured
};

}  // namespace selvedge::sim

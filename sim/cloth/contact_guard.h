#pragma once
// Keeps adaptations from moving cloth through other cloth. A split puts a vertex in the middle of an edge and a rejoin
// removes one; both may exchange a diagonal of the triangles beside the edge. Each is a movement of the surface by at
// most h, which uses up the clearance to other cloth. Where that is less than h, a rejoin is refused, unless it is
// forced. A split is not, for cloth that may not bend stretches instead. The next detection then tests for crossings.
//
//        v          A rejoin moves the centre by its distance from the middle of its edge. The exchange of the diagonal
//       /|\         m_i v for m_j m_k moves the middle of that quadrilateral by half of |m_i + v - m_j - m_k|, and
//    m_j-+-m_k      what is farther from it less.
//       \|/
//       m_i
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "sim/adaptive/adaptive_mesh.h"
#include "sim/core/math.h"

namespace selvedge::sim {

class ContactGuard {
 public:
    // clearances: by vertex, m, see SelfContact::clearances(); without them everything is permitted. `x` outlives the
    // guard.
    ContactGuard(const AdaptiveMesh& mesh, const std::vector<Vec4f>& x, std::vector<float> clearances)
        : mesh_(mesh), x_(x), clearances_(std::move(clearances)) {}

    bool permits_rejoin(EdgeId e) const;
    void note_split(EdgeId e);                         // has been made
    void note_rejoin(EdgeId e);                        // will be made
    bool is_doubtful() const { return is_doubtful_; }  // whether cloth may have been moved through other cloth

 private:
    Vec3f at(VertexId v) const { return x_[v.value].head<3>(); }
    Vec3f middle_of(EdgeId e) const;  // of its ends
    Vec3f centre_of(EdgeId e) const;  // its centre's position, or the middle if it is not split
    float exchange_of_split(TriangleId t, EdgeId e) const;
    float exchange_of_rejoin(TriangleId t, EdgeId e) const;
    float exchange_of_medians(const AdaptiveTriangle& triangle, std::size_t changed) const;
    float way_of_rejoin(EdgeId e) const;
    struct Patch {
        std::array<std::uint32_t, 12> vertices{};  // of two triangles with three corners and three centres
        std::size_t count = 0;
        std::span<const std::uint32_t> all() const { return std::span(vertices).first(count); }
    };
    Patch patch_of(EdgeId e) const;
    bool is_free(const Patch& patch, float way) const;
    void spend(EdgeId e, float way);

    const AdaptiveMesh& mesh_;
    const std::vector<Vec4f>& x_;
    std::vector<float> clearances_;
    bool is_doubtful_ = false;
};

}  // namespace selvedge::sim

#pragma once
// The curve of an edge: a cubic from the normals at its ends, as curved PN triangles have it (Vlachos et al. 2001),
// bent further or less by a modifier, held as a Lagrange curve through four points.  (thesis figs. 6.1, 6.3; SPEC 5)
//
//            L1 ------ L2           a at t = 0, L1 at 1/3, L2 at 2/3, b at 1
//          /              \         .
//        a                  b
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::render {

// How far the curve of an edge leaves its chord.  (thesis ch. 6, figs. 6.4, 6.5, 6.7; SPEC 5)
//
// r = rest length / length of the chord: an edge that is shorter than its material must curve.

// M = SoftCap(K0 + K1 r + K2 r^2 + K3 r^3) times the offset of the curve that the end normals alone would give.
struct CurveModifier {
    std::array<float, 4> k{1, 0, 0, 0};
    float soft_cap = 1;            // above 0; beyond it M grows towards soft_cap + 1 only
    bool restores_length = false;  // instead: the M with which the curve is as long as the material
};

// The thesis' presets, and ours.
enum class SurfaceKind { Flat, Constant, Linear, Quadratic, Cubic, Restore };

inline constexpr const char* kSurfaceKindNames = "flat, constant, linear, quadratic, cubic, restore";
inline constexpr int kSurfaceKinds = 6;
std::optional<SurfaceKind> parse_surface_kind(std::string_view name);
const char* name(SurfaceKind kind);

CurveModifier curve_modifier(SurfaceKind kind);

// value up to cap, then cap + (value - cap) / value.
float soft_cap(float value, float cap);

// Pre: it does not restore length.
float modified(const CurveModifier& modifier, float r);

// M for a curve whose arc is s0 times its chord at M = 1: for small offsets the excess of arc over chord grows with
// their square, so sqrt((r - 1) / (s0 - 1)); none where the edge is not short of its material, at most kMostRestored.
float restoring(float r, float s0);
inline constexpr float kMostRestored = 5;  // nearly straight, s0 tends to 1

// All vectors have a fourth 0.
struct CurveEnds {
    Vec4f a, b;                // m
    Vec4f normal_a, normal_b;  // unit
    float rest_length = 0;     // m
};

struct EdgeCurve {
    Vec4f a, l1, l2, b;                        // m
    Vec4f normal_a, normal_between, normal_b;  // of a quadratic; unit
};

EdgeCurve make_edge_curve(const CurveEnds& ends, const CurveModifier& modifier);

// The same with other tangents: P1 = (2A + B + va) / 3, P2 = (A + 2B + vb) / 3.
EdgeCurve bent_curve(const CurveEnds& ends, const Vec4f& va, const Vec4f& vb, const CurveModifier& modifier);

// Arc over chord of the curve with M = 1, by Gauss' rule with three points. va, vb: where the ends' inner control
// points stand off the chord, three times, m.
float arc_over_chord(const Vec4f& chord, const Vec4f& va, const Vec4f& vb);

// The normal in the middle of an edge, before it is brought to unit length with the ends': the mean of the ends'
// mirrored at the plane that halves the edge.  (Vlachos et al. 2001, 3.3)
Vec4f normal_between(const CurveEnds& ends);

// Weights of a curve's points and of its normals at t = i / 2^max_level.  (thesis table 6.1; Vlachos et al. 2001, whose
// normals have no factor 2 in the middle: with it they are noisier, and no nearer to anything)
class CurveWeights {
 public:
    explicit CurveWeights(int max_level);

    const Vec4f& points(std::size_t i) const { return points_[i]; }    // of a, L1, L2, b
    const Vec4f& normals(std::size_t i) const { return normals_[i]; }  // of a's, the middle, b's
    std::size_t steps() const { return points_.size() - 1; }           // 2^max_level

    Vec4f point(const EdgeCurve& curve, std::size_t i) const {
        const Vec4f& w = points_[i];
        return curve.a * w[0] + curve.l1 * w[1] + curve.l2 * w[2] + curve.b * w[3];
    }
    Vec4f normal(const EdgeCurve& curve, std::size_t i) const {
        const Vec4f& w = normals_[i];
        return (curve.normal_a * w[0] + curve.normal_between * w[1] + curve.normal_b * w[2]).normalized();
    }

 private:
    std::vector<Vec4f> points_, normals_;
};

// Weights at any t.
Vec4f lagrange_weights(double t);

}  // namespace selvedge::render

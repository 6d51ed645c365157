#include "sim/cloth/constraints.h"

#include <algorithm>
#include <cmath>

namespace selvedge {
namespace {

constexpr float kTiny = 1e-12F;
constexpr int kMoreRounds = 8;  // for the few triangles that one pass leaves over their limit

// The two thread directions of a triangle, unit, and how long they are.
struct Threads {
    Vec4f warp;
    Vec4f weft;
    float warp_length;
    float weft_length;
};

Threads threads_of(const StretchElement& e, const Vec4f& x0, const Vec4f& x1, const Vec4f& x2) {
    const Vec4f e1 = x1 - x0;
    const Vec4f e2 = x2 - x0;
    Threads t{.warp = e1 * e.a[0] + e2 * e.a[1], .weft = e1 * e.b[0] + e2 * e.b[1], .warp_length = 0, .weft_length = 0};
    t.warp_length = std::sqrt(t.warp.squaredNorm() + kTiny);
    t.weft_length = std::sqrt(t.weft.squaredNorm() + kTiny);
    t.warp /= t.warp_length;
    t.weft /= t.weft_length;
    return t;
}

void solve_triangle(const StretchElement& e, std::span<const float> inverse_mass, std::span<Vec4f> x) {
    Vec4f& x0 = x[e.vertices[0]];
    Vec4f& x1 = x[e.vertices[1]];
    Vec4f& x2 = x[e.vertices[2]];
    const Threads t = threads_of(e, x0, x1, x2);
    const Vec4f along_warp = t.warp * ((1 - t.warp_length) * (t.warp_length < 1 ? e.push : 1));
    const Vec4f along_weft = t.weft * ((1 - t.weft_length) * (t.weft_length < 1 ? e.push : 1));
    // The shear condition is the cosine between the two directions; its gradients are taken at unit length.
    const float shear = -t.warp.dot(t.weft) * e.shear;
    const Vec4f shear1 = (t.weft * e.a[0] + t.warp * e.b[0]) * shear;
    const Vec4f shear2 = (t.weft * e.a[1] + t.warp * e.b[1]) * shear;
    x0 += along_warp * e.warp[0] + along_weft * e.weft[0] - (shear1 + shear2) * inverse_mass[e.vertices[0]];
    x1 += along_warp * e.warp[1] + along_weft * e.weft[1] + shear1 * inverse_mass[e.vertices[1]];
    x2 += along_warp * e.warp[2] + along_weft * e.weft[2] + shear2 * inverse_mass[e.vertices[2]];
}

// Takes back what warp and weft are longer than they may be, and returns the longer of the two as it was.
float limit_triangle(const StretchElement& e, std::span<Vec4f> x, float longest_warp, float longest_weft) {
    Vec4f& x0 = x[e.vertices[0]];
    Vec4f& x1 = x[e.vertices[1]];
    Vec4f& x2 = x[e.vertices[2]];
    const Threads t = threads_of(e, x0, x1, x2);
    const float longer = std::max(t.warp_length, t.weft_length);
    if (t.warp_length <= longest_warp && t.weft_length <= longest_weft) return longer;
    const Vec4f along_warp = t.warp * std::min(0.0F, longest_warp - t.warp_length);
    const Vec4f along_weft = t.weft * std::min(0.0F, longest_weft - t.weft_length);
    x0 += along_warp * e.warp[0] + along_weft * e.weft[0];
    x1 += along_warp * e.warp[1] + along_weft * e.weft[1];
    x2 += along_warp * e.warp[2] + along_weft * e.weft[2];
    return longer;
}

}  // namespace

void solve_stretch(std::span<const StretchElement> elements, std::span<const float> inverse_mass, std::span<Vec4f> x) {
    for (const StretchElement& e : elements) solve_triangle(e, inverse_mass, x);
}

void limit_stretch(std::span<const StretchElement> elements, std::span<Vec4f> x, std::vector<std::uint32_t>& over) {
    over.clear();
    for (std::uint32_t i = 0; i < elements.size(); ++i) {
        const StretchElement& e = elements[i];
        if (limit_triangle(e, x, e.slack_warp, e.slack_weft) > e.longest) over.push_back(i);
    }
    for (int round = 0; round < kMoreRounds; ++round) {
        for (const std::uint32_t i : over) limit_triangle(elements[i], x, elements[i].longest, elements[i].longest);
    }
}

void solve_bend(std::span<const BendElement> elements, std::span<Vec4f> x) {
    for (const BendElement& e : elements) {
        Vec4f bent = Vec4f::Zero();
        for (int i = 0; i < 4; ++i) bent += x[e.vertices[i]] * e.q[i];
        for (int i = 0; i < 4; ++i) x[e.vertices[i]] -= bent * e.move[i];
    }
}

void limit_lengths(std::span<const LengthLimit> limits, std::span<Vec4f> x) {
    for (const LengthLimit& limit : limits) {
        const Vec4f d = x[limit.b] - x[limit.a];
        const float squared = d.squaredNorm();
        if (squared <= limit.limit * limit.limit) continue;
        const Vec4f c = d * (1 - limit.limit / std::sqrt(squared));
        x[limit.a] += c * limit.share_a;
        x[limit.b] -= c * limit.share_b;
    }
}

void limit_parents(std::span<const ParentLevel> levels, std::span<Vec4f> x, std::vector<Vec4f>& before) {
    if (levels.empty() || levels.front().triangles.empty()) return;
    before.assign(x.begin(), x.end());
    for (const ParentLevel& level : levels) {
        for (const StretchElement& e : level.triangles) limit_triangle(e, x, e.slack_warp, e.slack_weft);
        for (const EdgeCentre& c : level.centres) {
            x[c.centre] += ((x[c.a] - before[c.a]) + (x[c.b] - before[c.b])) * (0.5F * c.moves);
        }
    }
}

}  // namespace selvedge

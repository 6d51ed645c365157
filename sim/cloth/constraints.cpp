#include "sim/cloth/constraints.h"

#include <cmath>

namespace selvedge {
namespace {

constexpr float kTiny = 1e-12F;
constexpr float kParentRelaxation = 0.5F;  // full steps overshoot where many parents meet

void shorten(const LengthLimit& limit, std::span<Vec4f> x, float relaxation) {
    const Vec4f d = x[limit.b] - x[limit.a];
    const float squared = d.squaredNorm();
    if (squared <= limit.limit * limit.limit) return;
    const Vec4f c = d * (relaxation * (1 - limit.limit / std::sqrt(squared)));
    x[limit.a] += c * limit.share_a;
    x[limit.b] -= c * limit.share_b;
}

}  // namespace

void solve_stretch(std::span<const StretchElement> elements, std::span<const float> inverse_mass, std::span<Vec4f> x) {
    for (const StretchElement& e : elements) {
        Vec4f& x0 = x[e.vertices[0]];
        Vec4f& x1 = x[e.vertices[1]];
        Vec4f& x2 = x[e.vertices[2]];
        const Vec4f e1 = x1 - x0;
        const Vec4f e2 = x2 - x0;
        Vec4f warp = e1 * e.a[0] + e2 * e.a[1];
        Vec4f weft = e1 * e.b[0] + e2 * e.b[1];
        const float warp_length = std::sqrt(warp.squaredNorm() + kTiny);
        const float weft_length = std::sqrt(weft.squaredNorm() + kTiny);
        warp /= warp_length;
        weft /= weft_length;
        const Vec4f along_warp = warp * (1 - warp_length);
        const Vec4f along_weft = weft * (1 - weft_length);
        // The shear condition is the cosine between the two directions; its gradients are taken at unit length.
        const float shear = -warp.dot(weft) * e.shear;
        const Vec4f shear1 = (weft * e.a[0] + warp * e.b[0]) * shear;
        const Vec4f shear2 = (weft * e.a[1] + warp * e.b[1]) * shear;
        x0 += along_warp * e.warp[0] + along_weft * e.weft[0] - (shear1 + shear2) * inverse_mass[e.vertices[0]];
        x1 += along_warp * e.warp[1] + along_weft * e.weft[1] + shear1 * inverse_mass[e.vertices[1]];
        x2 += along_warp * e.warp[2] + along_weft * e.weft[2] + shear2 * inverse_mass[e.vertices[2]];
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
    for (const LengthLimit& limit : limits) shorten(limit, x, 1.0F);
}

void limit_parents(std::span<const std::vector<ParentLimit>> levels, std::span<Vec4f> x, std::vector<Vec4f>& before) {
    if (levels.empty() || levels.front().empty()) return;
    before.assign(x.begin(), x.end());
    for (const std::vector<ParentLimit>& level : levels) {
        for (const ParentLimit& parent : level) shorten(parent.ends, x, kParentRelaxation);
        for (const ParentLimit& parent : level) {
            const Vec4f moved = (x[parent.ends.a] - before[parent.ends.a]) + (x[parent.ends.b] - before[parent.ends.b]);
            x[parent.centre] += moved * (0.5F * parent.centre_moves);
        }
    }
}

}  // namespace selvedge

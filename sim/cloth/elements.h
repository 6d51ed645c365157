#pragma once
// What the solver's inner loops read: flat lists of constraints with everything that does not change between two
// adaptions worked out beforehand, material compliance and masses included.
//
// Stretch and shear after Baraff and Witkin (1998), conditions on the deformed warp and weft directions of a triangle;
// bending after Bergou et al. (2006), isometric; both as compliant constraints, one iteration per sub-step (Macklin et
// al. 2019, "Small Steps"), so that stiffness has units. One iteration leaves light cloth longer than that; so what
// warp and weft are strained beyond the strain of a usual load is taken back besides, whatever the load
// (limit_stretch).
#include <array>
#include <cstdint>
#include <vector>

#include "sim/core/vec.h"

namespace selvedge {

// How a triangle's edges make up its warp and weft: with e1 = x1 - x0, e2 = x2 - x0 the deformed warp direction is
// a[0] e1 + a[1] e2, the deformed weft direction b[0] e1 + b[1] e2. Both have length 1 at rest.
struct MaterialFrame {
    std::array<float, 2> a{};
    std::array<float, 2> b{};
    float area = 0;  // m^2, at rest
};

// u: the corners' material coordinates, m, counter-clockwise; grain_angle: from the panel's +y to the warp, rad.
MaterialFrame material_frame(const std::array<Vec2f, 3>& u, float grain_angle);

// Warp, weft and shear of one leaf triangle.
struct StretchElement {
    std::array<std::uint32_t, 3> vertices{};
    std::array<float, 2> a{};  // see MaterialFrame
    std::array<float, 2> b{};
    std::array<float, 3> warp{};  // what each vertex moves along the warp per unit of strain, m
    std::array<float, 3> weft{};
    float slack_warp = 1;  // length of the warp direction under the load that garments usually carry
    float slack_weft = 1;
    float longest = 1;  // length of either at the fabric's strain limit
    float push = 1;     // how much of a compression is resisted: 0 where a seam gathers the cloth
    float shear = 0;    // gain of the shear condition, 1 / sum of w |grad|^2 + compliance
};

// One hinge: sum of q_i x_i vanishes where the cloth is flat.
struct BendElement {
    std::array<std::uint32_t, 4> vertices{};
    std::array<float, 4> q{};
    std::array<float, 4> move{};  // w_i q_i gain
};

// |x_a - x_b| may not exceed `limit`.
struct LengthLimit {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    float limit = 0;    // m
    float share_a = 0;  // 0..1, of the correction that a takes
    float share_b = 0;
};

// The centre of a split edge: it follows what the ends are moved.
struct EdgeCentre {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::uint32_t centre = 0;
    float moves = 0;  // 1, or 0 for a pinned vertex
};

// One level of the hierarchy as the levels below see it. However cloth folds, the mean of its deformation over a
// triangle stretches no thread by more than the threads themselves are: a refined triangle is a one-sided limit.
struct ParentLevel {
    std::vector<StretchElement> triangles;
    std::vector<EdgeCentre> centres;
};

struct ClothElements {
    std::vector<std::uint32_t> vertices;  // leaf vertices
    std::vector<StretchElement> stretch;  // one per leaf triangle
    std::vector<BendElement> bend;        // one per inner leaf edge
    std::vector<LengthLimit> limits;      // one per leaf edge: the fabric's strain limit
    std::vector<ParentLevel> parents;     // coarse to fine
};

struct Cloth;
ClothElements make_elements(const Cloth& cloth);

}  // namespace selvedge

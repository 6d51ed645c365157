#pragma once
// The thresholds of the criteria of a mesh's shape (sim/adaptive/criteria.h), and which criteria a cloth has. Apart
// from the criteria, so that who only stores options does not depend on the mesh.

namespace selvedge::sim {

// Which criteria may request splits of a cloth's edges (sim/cloth/adapt_cloth.h).
struct CriteriaOptions {
    bool collision = true;
    bool curvature = true;
    bool length = true;
    bool buckling = false;

    bool operator==(const CriteriaOptions&) const = default;
};

struct CurvatureOptions {
    float split_angle = 0.35F;   // rad, a larger angle between the normals of an edge's ends requests a split
    float rejoin_angle = 0.10F;  // rad, below split_angle (hysteresis)

    bool operator==(const CurvatureOptions&) const = default;
};

struct LengthOptions {
    // Share of the rest length; an edge compressed by more requests a split. Cloth that must buckle is never compressed
    // by much, because its edges turn aside instead: drops and a worn T-shirt reach 1 to 2 %, hardly ever 5 %.
    float split_compression = 0.01F;
    float rejoin_compression = 0.004F;  // below split_compression (hysteresis)
};

struct BucklingOptions {
    float split_ratio = 1.02F;   // rest length / length; a larger ratio requests a split
    float rejoin_ratio = 1.01F;  // 1 or more, below split_ratio
};

}  // namespace selvedge::sim

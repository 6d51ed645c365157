#pragma once
// How cloth meets a body and the floor (sim/cloth/contact.h). Apart from the contacts, whose state only the solver
// needs.

namespace selvedge::sim {

struct ContactOptions {
    float offset = 0.003F;          // m, distance kept from the body; not below the error of the collision field
    float friction_scale = 1.0F;    // factor on the fabrics' friction; 0 while sewing
    float sample_spacing = 0.025F;  // m, maximum distance between samples along an edge
    float sampled_edge = 0.02F;     // m: triangles with shorter edges dip less than the offset (L^2 / 8R, R over 2 cm)
    float floor = 0.0F;             // m, height of the floor

    bool operator==(const ContactOptions&) const = default;
};

}  // namespace selvedge::sim

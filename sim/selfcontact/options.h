#pragma once
// Options of the contact of cloth with itself (sim/selfcontact/self_contact.h).

namespace selvedge::sim {

struct SelfContactOptions {
    float margin = 0.004F;           // m, beyond the radius: pairs this near are kept although they do not approach
    float thickness_scale = 1;       // of all sheets; below 1 while the garment is sewn
    float longest_push = 0.0003F;    // m per sub-step, by which depth is removed without becoming speed
    int refresh_interval = 6;        // sub-steps between two refreshes of the contact planes
    int untangling_iterations = 12;  // per step
    bool is_carried = false;         // by a body that moves: parts of the cloth have a motion of their own

    bool operator==(const SelfContactOptions&) const = default;
};

}  // namespace selvedge::sim

#pragma once
// Linear-blend skinning of a body's surface: x = sum_b w_b G_b B_b x_bind. (thesis listing 5.1)
#include <cstdint>
#include <vector>

#include "sim/body/pose.h"
#include "sim/core/math.h"

namespace selvedge::sim {

// The surface of a body, prepared to be posed often. Single precision; identical bits on any processor.
class SkinnedSurface {
 public:
    // Pre: the body has a skin.
    explicit SkinnedSurface(const Body& body);

    // The positions of all vertices in that pose, m, in the order of Body::x.
    void positions(const Body& body, const Pose& pose, std::vector<Vec3f>& x) const;

 private:
    struct Influence {  // bind position times weight, and the weight
        float wx, wy, wz, w;
    };
    // Vertices with an equal number of bones, so that no weight of 0 is multiplied.
    struct Group {
        std::vector<std::uint32_t> vertices;
        std::vector<Influence> influences;  // bones_each of the first vertex, then of the next
        std::vector<std::uint16_t> bones;   // of each influence
    };
    template <int bones_each>
    static void pose_group(const Group& group, const float* columns, float* x);

    std::size_t count_ = 0;
    Group groups_[4];  // by number of bones - 1
};

// The positions of all vertices in that pose, m, in double precision: the definition that SkinnedSurface follows.
std::vector<Vec3d> skin(const Body& body, const Pose& pose);

// Velocity of each vertex from its positions at two times that are `seconds` apart, m/s.
std::vector<Vec3f> velocities(const std::vector<Vec3f>& before, const std::vector<Vec3f>& after, float seconds);

}  // namespace selvedge::sim

#pragma once
// What is wrong with cloth on a body that moves: stretch, depth in the body and pinches, over all frames.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

class MovingBodyCollider;
struct Cloth;
struct LeafTriangle;

// A vertex that the body pinches (sim/cloth/moving_contact.h) has no place outside of it. Its depth, and that of the
// faces at it, is not counted; the vertex is.
class MotionQuality {
 public:
    static constexpr float kDeep = 0.001F;          // m, from which a vertex or a face counts as deep
    static constexpr float kOverstretched = 0.15F;  // from which a triangle counts as overstretched

    // A frame that is shown, `seconds` after what was noted last. Pre: the body is where it was at the end of the last
    // step.
    void note(const Cloth& cloth, const MovingBodyCollider& body, double seconds);
    // The stretch between two frames that are far apart in time: how long a triangle is overstretched does not depend
    // on how often the cloth is shown.
    void note_stretch(const Cloth& cloth, double seconds);

    // What a person would see as wrong, a sentence each, with where it is worst. A face may dip as deep as in
    // FaultLimits. panels: the names of the cloth's panels, if they are known.
    std::vector<std::string> faults(std::span<const std::string> panels = {}) const;

    // Where and when something was worst.
    struct Event {
        double seconds = 0;           // since the first note
        Vec3f place = Vec3f::Zero();  // m
        std::uint16_t panel = 0;
    };

    int frames = 0;
    double p99_stretch = 0, max_stretch = 0;  // largest that was noted: of all triangles, along warp and weft
    double overstretched_seconds = 0;         // longest time for which one triangle is overstretched
    // m; of a face, at any place in it (sim/collide/penetration.h), from 0.1 mm on
    double deepest_vertex = 0, deepest_face = 0;
    int deep_vertices = 0, deep_faces = 0;  // sums over the frames
    Event deepest{}, most_overstretched{};  // where deepest_face, or deepest_vertex; and for longest
    int pinched = 0;                        // most in a frame
    bool has_bad_number = false;

 private:
    void note_depths(const Cloth& cloth, const MovingBodyCollider& body);
    Event event_at(const Cloth& cloth, const LeafTriangle& face) const;

    double seconds_ = 0;                   // since the first note
    std::vector<double> stretched_since_;  // by triangle id: s for which it has been overstretched
};

}  // namespace selvedge::sim

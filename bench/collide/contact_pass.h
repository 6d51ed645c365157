#pragma once
// All points of a ClothPoints asked at every step, in the ways that cloth could ask.
#include <vector>

#include "sim/collide/collider.h"
#include "sim/collide/surface_bvh.h"

namespace selvedge::bench {

// Points that move near a body as the vertices of a worn garment do: for measuring what it costs to keep them out.

struct ClothPointOptions {
    int points = 3100;
    int steps = 56;                 // sub-steps
    float substep = 1.0F / 840.0F;  // s
    float speed = 1.0F;             // m/s, root mean square of free points
    float offset = 0.003F;          // m, points are put back to this distance
    unsigned seed = 7;
};

struct ClothPoints {
    // [step][point]: where the point is when it is asked, and what is true there.
    std::vector<std::vector<Vec3f>> x;
    std::vector<std::vector<sim::ClosestPoint>> exact;
    double in_contact = 0;  // share of them nearer than the offset
};

// Over the trunk, upper arms and thighs, at first 0 to 30 mm from the surface; neighbours in space are about neighbours
// in the list. Each swings at random; three in ten also fall towards the body, and now and then one leaps in by up to a
// centimetre. After a step what is nearer than the offset is put back to it and loses its speed inward.
ClothPoints move_cloth_points(const sim::SurfaceBvh& surface, const ClothPointOptions& options = {});

enum class ContactWay {
    OneByOne,   // contact() for each
    InBlocks,   // contacts(), sixteen at once
    WithSlack,  // the same for those only that may have come too near since they were asked last
};

// The points in the order that passes read them.
class PassPoints {
 public:
    explicit PassPoints(const ClothPoints& points);

    std::size_t count() const { return count_; }  // of one step
    const std::vector<std::vector<sim::ContactBlock>>& steps() const { return steps_; }

 private:
    std::size_t count_ = 0;
    std::vector<std::vector<sim::ContactBlock>> steps_;  // spare lanes of the last block repeat its last point
};

struct PassReport {
    double queries = 0;  // points times steps
    double asked = 0;    // of which the collider
};

// answers, if wanted: [step * count + point]; what slack spared is said to be at infinity.
PassReport run_pass(const PassPoints& points, const sim::Collider& collider, ContactWay way, float offset,
                    std::vector<sim::Contact>* answers = nullptr);

}  // namespace selvedge::bench

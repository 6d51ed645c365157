#pragma once
// Points that move near a body like the vertices of a worn garment (ClothPoints), and run_queries(), which queries a
// collider for all of them at every step, one by one, in SIMD blocks, or only where a contact is possible.
#include <vector>

#include "sim/collide/collider.h"
#include "sim/collide/surface_bvh.h"

namespace selvedge::bench {

struct ClothPointOptions {
    int points = 3100;
    int steps = 56;                 // sub-steps
    float substep = 1.0F / 840.0F;  // s
    float speed = 1.0F;             // m/s, RMS of points without contact
    float offset = 0.003F;          // m, contact offset: points that come nearer are projected to this distance
    unsigned seed = 7;
};

struct ClothPoints {
    // [step][point]: the position at the query, and the exact closest point on the surface.
    std::vector<std::vector<Vec3f>> x;
    std::vector<std::vector<sim::ClosestPoint>> exact;
    double in_contact = 0;  // share of the queries nearer than the offset, 0..1
};

// The points cover the trunk, upper arms and thighs and start 0 to 30 mm from the surface, in Morton order. Each has a
// random velocity; 30 % of them also move towards the body, and with a probability of 0.2 % per step a point jumps up
// to 10 mm inward. After each step, points nearer than the offset are projected to it and lose their inward velocity.
ClothPoints move_cloth_points(const sim::SurfaceBvh& surface, const ClothPointOptions& options = {});

enum class ContactWay {
    OneByOne,   // contact() for each point
    InBlocks,   // contacts(), 16 points per block
    WithSlack,  // contacts(), only for points that may have come within the offset since their last query
};

// The points of all steps, packed into blocks for run_queries().
class QueryPoints {
 public:
    explicit QueryPoints(const ClothPoints& points);

    std::size_t count() const { return count_; }  // of points in one step
    const std::vector<std::vector<sim::ContactBlock>>& steps() const { return steps_; }

 private:
    std::size_t count_ = 0;
    std::vector<std::vector<sim::ContactBlock>> steps_;  // unused lanes of the last block repeat its last point
};

struct QueryReport {
    double queries = 0;  // points x steps
    double asked = 0;    // how many of them queried the collider
};

// answers, if not null: [step * count + point]. Points that needed no query have an infinite distance.
QueryReport run_queries(const QueryPoints& points, const sim::Collider& collider, ContactWay way, float offset,
                        std::vector<sim::Contact>* answers = nullptr);

}  // namespace selvedge::bench

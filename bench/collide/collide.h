#pragma once
// Compares the cost of contact queries against a dense body on the same moving points: the collision grid of the thesis
// (4.4.1), a bounding volume hierarchy (BVH) and the distance field, the last with and without its SIMD kernels and
// with and without cached slack distances (see ContactWay).
#include <cstddef>
#include <vector>

#include "bench/support/table.h"
#include "sim/body/body.h"
#include "sim/collide/collider.h"
#include "sim/collide/surface_bvh.h"
#include "sim/core/parallel.h"

namespace selvedge::bench {

// Points that move near a body like the vertices of a worn garment (ClothPoints), and run_queries(), which queries a
// collider for all of them at every step, one by one, in SIMD blocks, or only where a contact is possible.

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
    double queried = 0;  // how many of them queried the collider
};

// answers, if not null: [step * count + point]. Points that needed no query have an infinite distance.
QueryReport run_queries(const QueryPoints& points, const sim::Collider& collider, ContactWay way, float offset,
                        std::vector<sim::Contact>* answers = nullptr);

struct CollideOptions {
    std::vector<std::size_t> triangles{27000, 107000, 428000};  // of the body, each at least 17,184
    ClothPointOptions points{};
    int rounds = 7;  // repetitions; times are medians over them
};

// Two tables, with one row for each structure and body: the cost and errors of queries, and the cost of building.
std::vector<Table> bench_collide(const CollideOptions& options, const sim::Progress& progress = {});

// The standing mannequin with `triangles` triangles, or one fewer: its longest edges are split until it has that many.
// The surface stays closed, and new vertices follow its curvature. No bones. Pre: triangles >= 17,184, the count of the
// coarsest mannequin.
sim::Body dense_body(std::size_t triangles);

}  // namespace selvedge::bench

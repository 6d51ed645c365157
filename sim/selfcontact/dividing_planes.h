#pragma once
// Certifies that no pair of elements went through each other since the last detection: the plane that divided the pair
// then, moved along with the pair, still divides it. Two convex sets whose vertices are on the two sides of a plane at
// both ends of linear paths never met. What fails is parted, and if that fails too, its movement is truncated.
// (after "divide and truncate", planar variant, in Newton's vertex block descent)
#include <cstdint>
#include <span>
#include <vector>

#include "sim/core/math.h"
#include "sim/selfcontact/kernels.h"
#include "sim/selfcontact/moving_points.h"
#include "sim/selfcontact/pair_search.h"

namespace selvedge::sim {

// The two vertices of a pair that are nearest along its divider, and how far apart they are there, m: no more than the
// sides are.
struct DividerExtremes {
    std::uint32_t first = 0, second = 0;  // on the first and on the second side
    float apart = 0;
};

// Of the pair in slot `at`; first_side: number of vertices on its first side.
DividerExtremes extremes_of(const PairBlock& block, std::size_t at, std::size_t first_side, const MovingPoints& points);

struct CertificateReport {
    int parted = 0;     // pairs of vertices that were moved apart
    int truncated = 0;  // vertices whose movement was shortened
    int undivided = 0;  // pairs that are not certified: none, unless motion is shared by pair
};

class DividingPlanes {
 public:
    // The motion that vertices share, which is not truncated.
    struct Motion {
        Vec3f displacement = Vec3f::Zero();  // m, since the last detection
        Vec3f per_substep = Vec3f::Zero();   // m
        // Each pair has its own instead, the mean of its vertices: cloth on a foot that moves is much faster than the
        // garment, and would go back through the foot.
        bool is_by_pair = false;
    };

    // The positions at a detection, by vertex, and the vertices of the surface.
    struct Start {
        std::span<const std::uint32_t> vertices;
        std::span<const Vec4f> positions;
    };

    // To be called after each detection: the pairs are others, or have other planes.
    void forget() { slack_.clear(); }

    // Makes all pairs divided by their planes. start: of the last detection.
    CertificateReport certify(const SelfContactKernels& loops, const ContactPairs& pairs, const Start& start,
                              const Motion& mean, const MovingPoints& points);

 private:
    struct Undivided {
        const PairBlock* block;
        std::size_t at;
        std::size_t first_side;
    };
    std::size_t collect(const SelfContactKernels& loops, const ContactPairs& pairs, const Start& start,
                        const Motion& mean, const MovingPoints& points);
    float moved(const Start& start, const Motion& mean, const MovingPoints& points) const;
    void begin_full_test(const Start& start, const Motion& mean, const MovingPoints& points);
    bool part_all(const MovingPoints& points, CertificateReport& report);
    bool shorten_all(const Start& start, const Motion& mean, float most, const MovingPoints& points,
                     CertificateReport& report);
    void take_back(const Start& start, const Motion& mean, const MovingPoints& points, CertificateReport& report);
    bool part(const Undivided& pair, const MovingPoints& points, CertificateReport& report);
    bool shorten(const Undivided& pair, const Start& start, const Motion& mean, const MovingPoints& points, float most);
    Motion take_shared(std::uint32_t vertex, const Motion& mean);

    std::vector<Undivided> undivided_;

    // Of the last full test, of all pairs:
    std::vector<float> slack_;            // m, by block: the least of its pairs
    std::vector<Vec4f> tested_at_;        // by vertex: position
    Vec3f shared_then_ = Vec3f::Zero();   // m: Motion::displacement
    std::size_t tested_ = 0;              // blocks that the last collection after it tested
    std::vector<std::uint8_t> stopped_;   // by vertex: whether it is back where it started
    std::vector<float> share_;            // by vertex, of its movement that is kept
    std::vector<Motion> shared_;          // by vertex: sums over the pairs that shorten it, if motion is by pair
    std::vector<int> sharing_;            // by vertex: the number of these
    std::vector<std::uint32_t> touched_;  // vertices with a share below 1
};

}  // namespace selvedge::sim

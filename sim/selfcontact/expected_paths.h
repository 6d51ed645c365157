#pragma once
// Where each vertex was expected to go when it was last looked at: a straight path, in a frame that travels with the
// mean of all vertices, so that cloth which falls as a whole stays on its paths. A pair of elements needs no new search
// while its vertices are near their paths.
#include <cstdint>
#include <span>
#include <vector>

#include "sim/core/math.h"
#include "sim/selfcontact/kernels.h"
#include "sim/selfcontact/moving_points.h"

namespace selvedge::sim {

class ExpectedPaths {
 public:
    // substeps: the length of a path, in sub-steps of the motion at its start.
    explicit ExpectedPaths(float substeps = 12) : substeps_(substeps) {}

    // Starts a path for each of these vertices (ascending) where it is now, and a new frame.
    void start(std::span<const std::uint32_t> vertices, const MovingPoints& points);

    // Starts a new path for those of the vertices for which `stays` is 0 (by vertex).
    void restart(std::span<const std::uint8_t> stays, const MovingPoints& points);

    // Notes where the vertices are now.
    void mark(const MovingPoints& points);

    struct Distances {
        float off_path = 0;   // m, the largest distance of a vertex from its path
        float from_mark = 0;  // m, the largest distance from where it was at the last mark(), in the frame
    };
    // Computes where each vertex will be after `ahead` more sub-steps of its present motion.
    Distances measure(const MovingPoints& points, float ahead);
    float squared_deviation(std::uint32_t vertex) const { return deviations_[vertex]; }  // m^2, of the last measure()

    // The origin of the frame: the mean displacement of all vertices since start(), m.
    Vec3f frame(const MovingPoints& points) const;
    const Vec3f& mean_move() const { return mean_move_; }  // m per sub-step, at the last start() or restart()

    // What the paths cover, with a fifth to spare.
    Sweep sweep(const MovingPoints& points) const;

 private:
    template <class Position>
    Vec3f mean_of(const Position& position) const;
    void start_one(std::uint32_t vertex, const Vec3f& frame, const MovingPoints& points);

    float substeps_;
    std::vector<std::uint32_t> vertices_;
    std::vector<Vec4f> starts_;      // by vertex, in the frame
    std::vector<Vec4f> marks_;       // by vertex, in the frame
    std::vector<Vec4f> moves_;       // by vertex: displacement per sub-step, without the mean
    std::vector<float> deviations_;  // by vertex, squared
    Vec3f first_mean_ = Vec3f::Zero(), mean_move_ = Vec3f::Zero();
};

}  // namespace selvedge::sim

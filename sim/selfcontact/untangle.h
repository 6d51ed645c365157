#pragma once
// Takes cloth apart that went through itself. If the cloth was free of crossings a short way ago, the crossing parts go
// back along that way. Otherwise the contour along which they cross is shortened (Volino and Magnenat-Thalmann 2006,
// "Resolving Surface Collisions through Intersection Contour Minimization"), and crumpled cloth is smoothed.
#include <cstdint>
#include <span>
#include <vector>

#include "sim/core/math.h"
#include "sim/selfcontact/crossings.h"
#include "sim/selfcontact/moving_points.h"
#include "sim/selfcontact/surface.h"

namespace selvedge::sim {

class Untangler {
 public:
    // One iteration over the crossings: each edge and the triangle that it pierces move apart, weighted by inverse
    // masses. `clean`: positions in which nothing crossed, by vertex, or empty; crossing parts that have moved against
    // each other by less than kRewindReach since then go back, other contours are shortened.
    void separate(const ContactSurface& surface, std::span<const Crossing> crossings, std::span<const Vec4f> clean,
                  const MovingPoints& points);

    // Moves the vertices of crossing elements half way to the mean of their neighbours.
    void smooth(const ContactSurface& surface, std::span<const Crossing> crossings, const MovingPoints& points);

    static constexpr float kRewindReach = 0.015F;  // m

 private:
    void clear(std::size_t vertices);
    void add(std::uint32_t vertex, const Vec3f& move);
    bool rewind(const Crossing& crossing, const ContactSurface& surface, std::span<const Vec4f> clean,
                const MovingPoints& points);
    void shorten(const Crossing& crossing, const ContactSurface& surface, const MovingPoints& points);
    void move_apart(const Crossing& crossing, const ContactSurface& surface, const Vec3f& move,
                    const MovingPoints& points);
    void apply(const MovingPoints& points, float longest);

    std::vector<Vec3f> sums_;             // by vertex, m
    std::vector<std::uint32_t> counts_;   // by vertex
    std::vector<std::uint32_t> touched_;  // vertices with a count
};

}  // namespace selvedge::sim

#pragma once
// Finds edges and faces of a triangle mesh that are inside a body although their vertices may be outside. An edge
// enters the body where it meets the surface. A face with free edges is searched by bisection; it is pruned where the
// signed distance, which changes by no more than the way and is convex round convex parts of a body, cannot fall below
// the limit.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/collide/surface_bvh.h"
#include "sim/core/math.h"

namespace selvedge::sim {

struct PenetrationOptions {
    float depth = 0.0005F;       // m, what is less deep does not count
    float resolution = 0.0001F;  // m, of the depths
};

// An edge that enters and leaves the body on opposite sides, as through a wrist.
struct PassingEdge {
    std::uint32_t triangle = 0;  // with this edge
    Vec3f at = Vec3f::Zero();    // its deepest point, m
    float depth = 0;             // m
};

// A face that is deeper than the limit, at a vertex, an edge or within.
struct DeepFace {
    std::uint32_t triangle = 0;
    Vec3f at = Vec3f::Zero();  // its deepest point, m
    float depth = 0;           // m
};

struct Penetration {
    int vertices = 0;                  // inside by any depth
    float deepest_vertex = 0;          // m, 0 when none is inside
    std::uint32_t vertex = 0;          // the deepest one
    int edges = 0;                     // deeper than the limit
    int faces = 0;                     // deeper than the limit
    float deepest = 0;                 // m, of all vertices, edges and faces; 0 when none is deeper than the limit
    Vec3f at = Vec3f::Zero();          // of the deepest point, m
    std::uint32_t triangle = 0;        // of the deepest point
    std::vector<DeepFace> deep_faces;  // these, by ascending triangle
    std::vector<PassingEdge> passing;
};

// Pre: the surface is closed, the positions are finite and the indices in range.
Penetration find_penetration(std::span<const Vec3f> x, std::span<const std::array<std::uint32_t, 3>> triangles,
                             const SurfaceBvh& surface, const PenetrationOptions& options = {});

}  // namespace selvedge::sim

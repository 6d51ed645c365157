#pragma once
// The scene seen along parallel rays, as depths only: what the key light's shadow and the room's light are made of.
#include <array>
#include <cstdint>
#include <vector>

#include "render/gl/handle.h"
#include "render/gl/program.h"
#include "sim/core/vec.h"

namespace selvedge {

// A ball that holds all that casts shadows.
struct Bounds {
    Vec3f centre = Vec3f::Zero();
    float radius = 1;  // m
};

// All that casts shadows, as one mesh.
struct Casters {
    std::vector<Vec3f> x;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

Bounds bounds_of(const std::vector<Vec3f>& points);

// Room to -1..1 in all three, looking from `direction` (unit) towards the ball's centre; depth grows away from it.
Eigen::Matrix4f parallel_matrix(const Bounds& bounds, const Vec3f& direction);

class DepthPass {
 public:
    DepthPass(const GladGLContext& gl, const Casters& casters, int side_px);

    // Draws the casters' depths into the square texture.
    void draw(const Eigen::Matrix4f& matrix) const;
    std::vector<float> read() const;  // side_px * side_px depths, rows from the bottom

    unsigned texture() const { return depth_.id(); }

 private:
    const GladGLContext& gl_;
    int side_px_;
    int index_count_;
    Program program_;
    VertexArray vertex_array_;
    Buffer positions_;
    Buffer indices_;
    Texture depth_;
    Framebuffer framebuffer_;
};

}  // namespace selvedge

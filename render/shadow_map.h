#pragma once
// The scene's depths as the key light sees them, and how near its nearest part is round each place, coarsely: most
// of a picture is told by that alone that nothing stands before it.
#include "render/casters.h"
#include "render/gl/handle.h"
#include "render/gl/program.h"

namespace selvedge {

// How far across the light a blocker is looked for, which is the softest a shadow's edge becomes, m.
inline constexpr float kShadowReach = 0.07F;

class ShadowMap {
 public:
    explicit ShadowMap(const GladGLContext& gl);

    // Uploads what casts shadows from now on.
    void load(const Casters& casters);

    // Draws the depths. matrix: room to -1..1; reach: the greatest distance at which a shadow is looked for, as a
    // share of the map's width.
    void draw(const Eigen::Matrix4f& matrix, float reach) const;

    unsigned depth() const { return depth_.id(); }
    unsigned nearest() const { return nearest_.id(); }

 private:
    struct View {
        unsigned framebuffer;
        int side_px;
    };
    void draw_nearest(const Program& program, const View& to, unsigned from, int cells) const;

    const GladGLContext& gl_;
    int index_count_ = 0;
    Program depth_program_, tile_program_, spread_program_;
    VertexArray vertex_array_, no_vertices_;
    Buffer positions_, indices_;
    Texture depth_, nearest_, rows_;
    Framebuffer depth_frame_, nearest_frame_, rows_frame_;
};

}  // namespace selvedge

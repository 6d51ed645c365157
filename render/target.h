#pragma once
// Where a tile of a picture is drawn: our own framebuffer, multisampled and in linear half floats, resolved, finished
// to sRGB bytes and read back.
#include "render/gl/handle.h"
#include "render/gl/program.h"
#include "render/image/image.h"
#include "sim/core/vec.h"

namespace selvedge {

struct TargetSize {
    int width_px = 0;  // of the finished tile
    int height_px = 0;
    int samples = 4;
    int supersample = 1;  // pixels drawn per finished pixel, each way
};

class Target {
 public:
    Target(const GladGLContext& gl, const TargetSize& size);

    void begin() const;  // binds and clears to transparent

    // Resolves, finishes and reads. tile_origin_px: of this tile in the picture, from the lower left.
    // The result's first row is the lowest.
    Image finish(const Vec2f& tile_origin_px) const;

 private:
    void make_drawn(const TargetSize& size);

    const GladGLContext& gl_;
    TargetSize size_;
    Program program_;
    VertexArray no_vertices_;
    Renderbuffer drawn_colour_, drawn_depth_;
    Framebuffer drawn_;
    Texture resolved_colour_;
    Framebuffer resolved_;
    Texture finished_colour_;
    Framebuffer finished_;
};

}  // namespace selvedge

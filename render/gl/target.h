#pragma once
// The render target of one tile of a picture: a multisampled framebuffer in linear half floats. Its samples are
// averaged, blended over the backdrop, encoded as sRGB bytes and read back. Also make_program(), which builds programs
// from the embedded GLSL files.
#include <functional>
#include <initializer_list>
#include <string_view>

#include "render/gl/handle.h"
#include "render/image/image.h"

namespace selvedge::render {

struct TargetSize {
    int width_px = 0;  // of the finished tile
    int height_px = 0;
    int samples = 4;
    int supersample = 1;  // drawn pixels per finished pixel, in each direction

    bool operator==(const TargetSize&) const = default;
};

class Target {
 public:
    Target(const GladGLContext& gl, const TargetSize& size);

    const TargetSize& size() const { return size_; }

    void begin() const;  // binds and clears to transparent

    // Averages the samples, blends them over the backdrop and encodes. set_backdrop sets the uniforms of backdrop.glsl.
    void finish(const std::function<void(const Program&)>& set_backdrop) const;

    unsigned finished_framebuffer() const { return finished_.id(); }  // row 0 is the bottom row
    Image read() const;                                               // row 0 is the bottom row

 private:
    const GladGLContext& gl_;
    TargetSize size_;
    Program program_;
    VertexArray no_vertices_;
    Texture drawn_colour_;
    Renderbuffer drawn_depth_;
    Framebuffer drawn_;
    Texture finished_colour_;
    Framebuffer finished_;
};

// Programs from the GLSL files of shaders/, which are embedded in the executable.

// The stages' sources by file name, such as {"shadow.glsl", "place.frag"}, joined in that order.
Program make_program(const GladGLContext& gl, std::initializer_list<std::string_view> vertex,
                     std::initializer_list<std::string_view> fragment);

}  // namespace selvedge::render

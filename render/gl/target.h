#pragma once
// Where a tile of a picture is drawn: our own framebuffer, multisampled and in linear half floats; its samples are
// averaged, laid over the backdrop, encoded as sRGB bytes and read back.
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
    int supersample = 1;  // pixels drawn per finished pixel, each way

    bool operator==(const TargetSize&) const = default;
};

class Target {
 public:
    Target(const GladGLContext& gl, const TargetSize& size);

    const TargetSize& size() const { return size_; }

    void begin() const;  // binds and clears to transparent

    // Averages, lays over the backdrop and encodes. set_backdrop sets what backdrop.glsl asks of a program.
    void finish(const std::function<void(const Program&)>& set_backdrop) const;

    unsigned finished_framebuffer() const { return finished_.id(); }  // the first row is the lowest
    Image read() const;                                               // the first row is the lowest

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

// The GLSL files of shaders/, compiled into the program, put together to programs.

// Stages by file name, such as {"shadow.glsl", "place.frag"}, joined in that order.
Program make_program(const GladGLContext& gl, std::initializer_list<std::string_view> vertex,
                     std::initializer_list<std::string_view> fragment);

}  // namespace selvedge::render

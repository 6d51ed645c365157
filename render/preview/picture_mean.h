#pragma once
// The mean of several pictures of one view, each drawn at another offset within the pixel, in linear light. It grows
// picture by picture, so that no frame has to wait for all of them.
#include "render/gl/target.h"

namespace selvedge::render {

class PictureMean {
 public:
    explicit PictureMean(const GladGLContext& gl);

    // Forgets the pictures so far; the next ones have this size.
    void clear(int width_px, int height_px);

    // Pre: the picture has the size that clear() was given.
    void add(const PictureTexture& picture);

    // Pre: the texture has that size, and a picture was added.
    void draw(PictureTexture& to) const;

 private:
    void fill(const Program& program, unsigned texture, unsigned framebuffer) const;

    const GladGLContext& gl_;
    Program add_, mean_;
    VertexArray no_vertices_;
    Texture sum_;
    Framebuffer framebuffer_;
    int width_px_ = 0;
    int height_px_ = 0;
};

}  // namespace selvedge::render

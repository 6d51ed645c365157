#pragma once
// A picture that stays with GL: drawn into, shown, and read back only where someone asks for it. sRGB bytes.
#include "render/gl/handle.h"
#include "render/image/image.h"

namespace selvedge {

class PictureTexture {
 public:
    explicit PictureTexture(const GladGLContext& gl);  // empty

    // Forgets what was drawn, where the size is another.
    void resize(int width_px, int height_px);

    int width_px() const { return width_px_; }
    int height_px() const { return height_px_; }
    unsigned texture() const { return texture_.id(); }
    unsigned framebuffer() const { return framebuffer_.id(); }

    // Pre: not empty.
    Image read() const;              // the texture's first row is the picture's lowest, as GL draws
    Image read_upside_down() const;  // the texture's first row is the picture's first

 private:
    const GladGLContext& gl_;
    Texture texture_;
    Framebuffer framebuffer_;
    int width_px_ = 0;
    int height_px_ = 0;
};

}  // namespace selvedge

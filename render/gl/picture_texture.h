#pragma once
// A picture that stays with GL: drawn into, shown, and read back only where someone asks for it. sRGB bytes; the first
// row is the uppermost, as in an Image and in a window's memory, though GL would have it the lowest.
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

    Image read() const;  // Pre: not empty

 private:
    const GladGLContext& gl_;
    Texture texture_;
    Framebuffer framebuffer_;
    int width_px_ = 0;
    int height_px_ = 0;
};

}  // namespace selvedge

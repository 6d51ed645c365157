#include "render/draw/picture_texture.h"

#include <array>

#include "render/gl/context.h"
#include "render/scene/colour.h"
#include "sim/core/assert.h"

namespace selvedge::render {

Texture make_picture_texture(const GladGLContext& gl, const ClothPicture& picture, TexelLight light) {
    SELVEDGE_ASSERT(picture.image && !picture.image->pixels.empty());
    const Image& image = *picture.image;
    Texture texture(gl);
    gl.BindTexture(GL_TEXTURE_2D, texture.id());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TexImage2D(GL_TEXTURE_2D, 0, light == TexelLight::Linear ? GL_SRGB8_ALPHA8 : GL_RGBA8, image.width_px,
                  image.height_px, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
    gl.GenerateMipmap(GL_TEXTURE_2D);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    const GLint wrap = picture.is_repeated ? GL_REPEAT : GL_CLAMP_TO_BORDER;
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
    std::array<float, 4> around{0, 0, 0, 1};  // a border colour is not decoded from sRGB
    for (std::size_t i = 0; i < 3; ++i) {
        around[i] = light == TexelLight::Linear ? static_cast<float>(to_linear(picture.ground[i]))
                                                : float(picture.ground[i]) / 255;
    }
    gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, around.data());
    return texture;
}

}  // namespace selvedge::render

#pragma once
// The texture of a picture that is printed on cloth.
#include "render/gl/target.h"
#include "render/scene/scene.h"

namespace selvedge::render {

// What a shader gets of the texture: linear light, or sRGB as in the picture.
enum class TexelLight { Linear, Srgb };

// With all smaller levels. Binds the texture to the active unit. Pre: picture.image has pixels.
Texture make_picture_texture(const GladGLContext& gl, const ClothPicture& picture, TexelLight light);

}  // namespace selvedge::render

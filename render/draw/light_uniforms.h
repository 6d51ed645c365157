#pragma once
// The uniforms of shaders/light.glsl.
#include "render/gl/target.h"
#include "render/scene/scene.h"

namespace selvedge::render {

// Pre: the program is in use.
inline void set_light(const Program& program, const Light& light, const Vec3f& eye) {
    program.set("eye", eye);
    program.set("to_key", Vec3f(light.to_key.normalized()));
    program.set("to_fill", Vec3f(light.to_fill.normalized()));
    program.set("key_irradiance", light.key);
    program.set("fill_irradiance", light.fill);
    program.set("sky_irradiance", light.sky);
    program.set("bounce_irradiance", light.bounce);
}

}  // namespace selvedge::render

#pragma once
// The GLSL files of shaders/, compiled into the program, put together to programs.
#include <initializer_list>
#include <string_view>

#include "render/gl/program.h"

namespace selvedge {

// Stages by file name, such as {"shadow.glsl", "place.frag"}, joined in that order.
Program make_program(const GladGLContext& gl, std::initializer_list<std::string_view> vertex,
                     std::initializer_list<std::string_view> fragment);

}  // namespace selvedge

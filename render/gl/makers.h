#pragma once
// The makers of contexts. Each throws std::runtime_error with the reason why it cannot.
#include <memory>

#include "render/gl/context.h"

namespace selvedge {

std::unique_ptr<GlContext> make_osmesa_context();
std::unique_ptr<GlContext> make_egl_context();

}  // namespace selvedge

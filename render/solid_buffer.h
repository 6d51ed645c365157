#pragma once
// Solids on their way to GL.
#include "render/gl/handle.h"
#include "render/scene/scene.h"

namespace selvedge {

struct SolidBuffer {
    VertexArray vertex_array;
    Buffer vertices;
    Buffer indices;
    int index_count = 0;
};

SolidBuffer make_solid_buffer(const GladGLContext& gl, const SolidItem& item);

}  // namespace selvedge

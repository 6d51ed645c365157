#include "render/solid_buffer.h"

#include <cstddef>

#include "render/gl/gl.h"
#include "sim/core/assert.h"

namespace selvedge {
namespace {

struct SolidVertex {
    std::array<float, 3> position;
    std::array<float, 3> normal;
    std::array<std::uint8_t, 4> colour;  // sRGB
};

std::vector<SolidVertex> solid_vertices(const SolidItem& item) {
    SELVEDGE_ASSERT(item.normals.size() == item.x.size() && item.colours.size() == item.x.size());
    std::vector<SolidVertex> vertices;
    vertices.reserve(item.x.size());
    for (std::size_t i = 0; i < item.x.size(); ++i) {
        const Vec3f &x = item.x[i], &n = item.normals[i];
        const Rgb8& colour = item.colours[i];
        vertices.push_back({{x.x(), x.y(), x.z()}, {n.x(), n.y(), n.z()}, {colour[0], colour[1], colour[2], 255}});
    }
    return vertices;
}

const void* offset(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes);
}

}  // namespace

SolidBuffer make_solid_buffer(const GladGLContext& gl, const SolidItem& item) {
    const std::vector<SolidVertex> vertices = solid_vertices(item);
    SolidBuffer buffer{.vertex_array = VertexArray(gl), .vertices = Buffer(gl), .indices = Buffer(gl)};
    gl.BindVertexArray(buffer.vertex_array.id());
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer.vertices.id());
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(SolidVertex)), vertices.data(),
                  GL_STATIC_DRAW);
    for (GLuint attribute = 0; attribute < 3; ++attribute) gl.EnableVertexAttribArray(attribute);
    constexpr GLsizei stride = sizeof(SolidVertex);
    gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, offset(offsetof(SolidVertex, position)));
    gl.VertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, stride, offset(offsetof(SolidVertex, normal)));
    gl.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, offset(offsetof(SolidVertex, colour)));
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer.indices.id());
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(item.triangles.size() * sizeof(item.triangles[0])),
                  item.triangles.data(), GL_STATIC_DRAW);
    buffer.index_count = static_cast<int>(item.triangles.size() * 3);
    return buffer;
}

}  // namespace selvedge

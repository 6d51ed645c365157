#include "render/cloth_paint.h"

#include "render/colour.h"
#include "render/gl/gl.h"
#include "sim/core/assert.h"

namespace selvedge {
namespace {

constexpr GLuint kPlaceAttribute = 7;
constexpr int kPlainLook = 3, kPaintedLook = 4;  // as cloth.frag numbers them

void upload_places(const GladGLContext& gl, const PaintBuffer& buffer, const ClothPaint& paint) {
    static_assert(sizeof(paint.places.front()) == 3 * sizeof(float));
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer.places.id());
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(paint.places.size() * sizeof(paint.places.front())),
                  paint.places.data(), GL_STATIC_DRAW);
    gl.EnableVertexAttribArray(kPlaceAttribute);
    gl.VertexAttribPointer(kPlaceAttribute, 1, GL_FLOAT, GL_FALSE, sizeof(float), nullptr);
}

void upload_map(const GladGLContext& gl, const PaintBuffer& buffer, const ClothPaint& paint) {
    std::vector<Vec3f> linear;
    for (const Rgb8& colour : paint.map) linear.push_back(to_linear(colour));
    gl.BindTexture(GL_TEXTURE_2D, buffer.map.id());
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, static_cast<GLsizei>(linear.size()), 1, 0, GL_RGB, GL_FLOAT,
                  linear.data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

}  // namespace

PaintBuffer make_paint_buffer(const GladGLContext& gl, const ClothItem& item) {
    PaintBuffer buffer{.places = Buffer(gl), .map = Texture(gl), .ink = item.ink};
    if (!item.paint) return buffer;
    SELVEDGE_ASSERT(item.paint->places.size() == item.mesh.triangles.size() && item.paint->map.size() >= 2);
    upload_places(gl, buffer, *item.paint);
    upload_map(gl, buffer, *item.paint);
    buffer.colours = static_cast<int>(item.paint->map.size());
    return buffer;
}

int cloth_look(ShowMode show, const PaintBuffer& paint) {
    if (show <= ShowMode::Plain) return static_cast<int>(show);
    return paint.colours > 0 ? kPaintedLook : kPlainLook;
}

void bind_paint(const GladGLContext& gl, const Program& program, const PaintBuffer& paint, int unit) {
    program.set("edge_ink", paint.ink);
    program.set("paint_map", unit);
    program.set("paint_colours", paint.colours);
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl.BindTexture(GL_TEXTURE_2D, paint.map.id());
}

}  // namespace selvedge

#include "render/draw/cloth_vertices.h"

#include <algorithm>
#include <cmath>

#include "render/draw/edge_marks.h"
#include "render/gl/context.h"
#include "render/scene/colour.h"
#include "sim/core/assert.h"

namespace selvedge::render {

Vec2f place_on_fabric(const Vec2f& material, float grain, const Vec2f& sett_offset) {
    const float c = std::cos(grain), s = std::sin(grain);
    return {c * material.x() + s * material.y() + sett_offset.x(),
            -s * material.x() + c * material.y() + sett_offset.y()};
}

namespace {

float grain_of(const sim::DrawMesh& mesh, std::size_t triangle) {
    const std::size_t panel = panel_of(mesh, triangle);
    return panel < mesh.panel_grain_angles.size() ? mesh.panel_grain_angles[panel] : 0.0F;
}

Vec2f sett_offset_of(const sim::DrawMesh& mesh, std::size_t triangle) {
    const std::size_t panel = panel_of(mesh, triangle);
    return panel < mesh.panel_sett_offsets.size() ? mesh.panel_sett_offsets[panel] : Vec2f(0, 0);
}

std::array<float, 3> to_array(const Vec3f& v) {
    return {v.x(), v.y(), v.z()};
}

}  // namespace

std::vector<ClothVertex> make_cloth_vertices(const sim::DrawMesh& mesh, const std::vector<Vec3f>& normals,
                                             const std::vector<AmbientVisibility>& ambient_visibility) {
    SELVEDGE_ASSERT(normals.size() == mesh.x.size() && ambient_visibility.size() == mesh.x.size());
    SELVEDGE_ASSERT(mesh.u.empty() || mesh.u.size() == mesh.triangles.size());
    const std::vector<TriangleMarks> marks = mark_edges(mesh);
    const std::vector<std::array<TouchDistance, 3>> touches = touch_distances(mesh, marks);
    std::vector<ClothVertex> vertices;
    vertices.reserve(mesh.triangles.size() * 3);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const std::array<float, 3> heights = corner_heights({mesh.x[a], mesh.x[b], mesh.x[c]});
        const std::uint32_t level = mesh.level.empty() ? 0U : mesh.level[t];
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t v = mesh.triangles[t][corner];
            ClothVertex vertex{};
            vertex.position = to_array(mesh.x[v]);
            const bool is_turned = sim::is_turned(mesh, t, corner);
            vertex.normal = to_array(is_turned ? Vec3f(-normals[v]) : normals[v]);
            if (!mesh.u.empty()) {
                const Vec2f place = place_on_fabric(mesh.u[t][corner], grain_of(mesh, t), sett_offset_of(mesh, t));
                vertex.place = {place.x(), place.y()};
            }
            vertex.heights[corner] = heights[corner];
            vertex.ambient_visibility = {ambient_visibility[v].front, ambient_visibility[v].back};
            if (is_turned) std::swap(vertex.ambient_visibility[0], vertex.ambient_visibility[1]);
            vertex.touch = {touches[t][corner].seam, touches[t][corner].hem};
            vertex.marks = level | marks[t].seam << 8 | marks[t].hem << 11;
            vertices.push_back(vertex);
        }
    }
    return vertices;
}

namespace {

constexpr GLuint kPlaceAttribute = 7;
constexpr int kPlainLook = 3, kPaintedLook = 4;  // values of `show` in cloth.frag

void upload_places(const GladGLContext& gl, const PaintBuffer& buffer, const ClothPaint& paint) {
    static_assert(sizeof(paint.places.front()) == 3 * sizeof(float));
    upload(gl, GL_ARRAY_BUFFER, buffer.places, paint.places, GL_STATIC_DRAW);
    add_floats(gl, kPlaceAttribute, 1, sizeof(float), 0);
}

void upload_map(const GladGLContext& gl, const PaintBuffer& buffer, const ClothPaint& paint) {
    std::vector<Vec3f> linear;
    for (const sim::Rgb8& colour : paint.map) linear.push_back(to_linear(colour));
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

namespace {

SettSums sum_colours(const std::vector<sim::Rgb8>& colours) {
    SELVEDGE_ASSERT(!colours.empty());
    Vec3d mean = Vec3d::Zero();
    for (const sim::Rgb8& colour : colours) mean += to_linear(colour).cast<double>();
    mean /= static_cast<double>(colours.size());

    SettSums result;
    result.mean = mean.cast<float>();
    result.sums.push_back(Vec3f::Zero());
    Vec3d sum = Vec3d::Zero();
    for (const sim::Rgb8& colour : colours) {
        sum += to_linear(colour).cast<double>() - mean;
        result.sums.push_back(sum.cast<float>());
    }
    result.sums.back().setZero();
    return result;
}

}  // namespace

SettSums sum_warp(const sim::Sett& sett) {
    return sum_colours(thread_colours(sett));
}

SettSums sum_weft(const sim::Sett& sett) {
    return sum_colours(weft_thread_colours(sett));
}

}  // namespace selvedge::render

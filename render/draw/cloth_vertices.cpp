#include "render/draw/cloth_vertices.h"

#include <algorithm>
#include <cmath>

#include "render/gl/context.h"
#include "render/scene/colour.h"
#include "sim/core/assert.h"

namespace selvedge::render {
namespace {

// The warp's angle is `grain` (rad, anticlockwise from +y); the weft is a quarter turn clockwise from the warp. The
// sett's offset is added after the rotation.
std::array<float, 2> turned_to_grain(const Vec2f& u, float grain, const Vec2f& offset) {
    const float c = std::cos(grain), s = std::sin(grain);
    return {c * u.x() + s * u.y() + offset.x(), -s * u.x() + c * u.y() + offset.y()};
}

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
            vertex.normal = to_array(normals[v]);
            if (!mesh.u.empty()) {
                vertex.place = turned_to_grain(mesh.u[t][corner], grain_of(mesh, t), sett_offset_of(mesh, t));
            }
            vertex.heights[corner] = heights[corner];
            vertex.ambient_visibility = {ambient_visibility[v].front, ambient_visibility[v].back};
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

// One triangle's use of an edge, identified by the edge's vertices in ascending order.
struct EdgeUse {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    std::uint32_t triangle = 0;
    std::uint32_t edge = 0;

    auto operator<=>(const EdgeUse&) const = default;
    bool is_same_edge(const EdgeUse& other) const { return low == other.low && high == other.high; }
};

std::vector<EdgeUse> sorted_edge_uses(const sim::DrawMesh& mesh) {
    std::vector<EdgeUse> uses;
    uses.reserve(mesh.triangles.size() * 3);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::uint32_t edge = 0; edge < 3; ++edge) {
            const std::uint32_t a = mesh.triangles[t][(edge + 1) % 3];
            const std::uint32_t b = mesh.triangles[t][(edge + 2) % 3];
            uses.push_back({std::min(a, b), std::max(a, b), t, edge});
        }
    }
    std::sort(uses.begin(), uses.end());
    return uses;
}

Vec2f material_at(const sim::DrawMesh& mesh, std::uint32_t triangle, std::uint32_t vertex) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
        if (mesh.triangles[triangle][corner] == vertex) return mesh.u[triangle][corner];
    }
    return Vec2f::Zero();
}

bool jumps(const sim::DrawMesh& mesh, const EdgeUse& a, const EdgeUse& b) {
    if (panel_of(mesh, a.triangle) != panel_of(mesh, b.triangle)) return true;
    if (mesh.u.empty()) return false;
    constexpr float same = 1e-4F;  // m: rounding by the number of decimals in a file
    for (const std::uint32_t vertex : {a.low, a.high}) {
        if ((material_at(mesh, a.triangle, vertex) - material_at(mesh, b.triangle, vertex)).norm() > same) return true;
    }
    return false;
}

using MarkKind = std::uint32_t TriangleMarks::*;
using TouchKind = float TouchDistance::*;

// Distances of vertices from one kind of marked edge.
struct MarkedVertices {
    std::vector<bool> is_on;
    std::vector<float> distance;  // m; of vertices opposite to a marked edge, else kFar
};

MarkedVertices find_marked(const sim::DrawMesh& mesh, const std::vector<TriangleMarks>& marks, MarkKind kind) {
    MarkedVertices marked{.is_on = std::vector<bool>(mesh.x.size(), false),
                          .distance = std::vector<float>(mesh.x.size(), TouchDistance::kFar)};
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& vertices = mesh.triangles[t];
        const std::array<float, 3> heights =
            corner_heights({mesh.x[vertices[0]], mesh.x[vertices[1]], mesh.x[vertices[2]]});
        for (std::size_t edge = 0; edge < 3; ++edge) {
            if ((marks[t].*kind >> edge & 1U) == 0) continue;
            marked.is_on[vertices[(edge + 1) % 3]] = true;
            marked.is_on[vertices[(edge + 2) % 3]] = true;
            float& distance = marked.distance[vertices[edge]];
            distance = std::min(distance, heights[edge]);
        }
    }
    return marked;
}

void add_touches(const sim::DrawMesh& mesh, const std::vector<TriangleMarks>& marks, MarkKind mark_kind,
                 TouchKind touch_kind, std::vector<std::array<TouchDistance, 3>>& touches) {
    const MarkedVertices marked = find_marked(mesh, marks, mark_kind);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& vertices = mesh.triangles[t];
        const auto is_on = [&](std::uint32_t vertex) { return bool(marked.is_on[vertex]); };
        if (marks[t].*mark_kind != 0 || std::count_if(vertices.begin(), vertices.end(), is_on) != 1) continue;
        const Vec3f touched = mesh.x[*std::find_if(vertices.begin(), vertices.end(), is_on)];
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t v = vertices[corner];
            const float beside = std::min(marked.distance[v], (mesh.x[v] - touched).norm());
            touches[t][corner].*touch_kind = is_on(v) ? 0.0F : beside;
        }
    }
}

}  // namespace

std::array<float, 3> corner_heights(const std::array<Vec3f, 3>& x) {
    const float doubled_area = (x[1] - x[0]).cross(x[2] - x[0]).norm();
    std::array<float, 3> heights{};
    for (std::size_t i = 0; i < 3; ++i) {
        const float base = (x[(i + 2) % 3] - x[(i + 1) % 3]).norm();
        heights[i] = base > 0 ? doubled_area / base : 0;
    }
    return heights;
}

std::vector<TriangleMarks> mark_edges(const sim::DrawMesh& mesh) {
    std::vector<TriangleMarks> marks(mesh.triangles.size());
    const std::vector<EdgeUse> uses = sorted_edge_uses(mesh);
    for (std::size_t first = 0; first < uses.size();) {
        std::size_t last = first + 1;
        while (last < uses.size() && uses[last].is_same_edge(uses[first])) ++last;
        const bool is_hem = last == first + 1;
        const bool is_seam = !is_hem && jumps(mesh, uses[first], uses[first + 1]);
        for (std::size_t i = first; i < last; ++i) {
            const std::uint32_t bit = 1U << uses[i].edge;
            if (is_seam) marks[uses[i].triangle].seam |= bit;
            if (is_hem) marks[uses[i].triangle].hem |= bit;
        }
        first = last;
    }
    return marks;
}

std::vector<std::array<TouchDistance, 3>> touch_distances(const sim::DrawMesh& mesh,
                                                          const std::vector<TriangleMarks>& marks) {
    SELVEDGE_ASSERT(marks.size() == mesh.triangles.size());
    std::vector<std::array<TouchDistance, 3>> touches(mesh.triangles.size());
    add_touches(mesh, marks, &TriangleMarks::seam, &TouchDistance::seam, touches);
    add_touches(mesh, marks, &TriangleMarks::hem, &TouchDistance::hem, touches);
    return touches;
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

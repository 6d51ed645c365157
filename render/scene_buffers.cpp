#include "render/scene_buffers.h"

#include <cstddef>

#include "render/colour.h"
#include "render/gl/gl.h"
#include "render/room_light.h"
#include "render/sett_sums.h"

namespace selvedge {
namespace {

struct SurfaceVertex {
    std::array<float, 3> position;
    std::array<float, 3> normal;
    float openness;
};

// Everything that is lit, in the order cloths, bodies, ground.
struct LitPoints {
    std::vector<Vec3f> x;
    std::vector<Vec3f> normals;

    void add(const std::vector<Vec3f>& more_x, const std::vector<Vec3f>& more_normals) {
        x.insert(x.end(), more_x.begin(), more_x.end());
        normals.insert(normals.end(), more_normals.begin(), more_normals.end());
    }
};

class Opennesses {
 public:
    explicit Opennesses(std::vector<Openness> all) : all_(std::move(all)) {}
    std::vector<Openness> take(std::size_t count) {
        const auto first = all_.begin() + static_cast<std::ptrdiff_t>(taken_);
        taken_ += count;
        return {first, first + static_cast<std::ptrdiff_t>(count)};
    }

 private:
    std::vector<Openness> all_;
    std::size_t taken_ = 0;
};

constexpr std::uint32_t kGroundCells = 144;  // each way

// A fine square sheet, for the room's light is held by its vertices.
BodyItem make_ground(const Vec3f& centre, float radius) {
    constexpr std::uint32_t cells = kGroundCells;
    BodyItem ground;
    for (std::uint32_t j = 0; j <= cells; ++j) {
        for (std::uint32_t i = 0; i <= cells; ++i) {
            const Vec2f at = Vec2f(float(i), float(j)) * (2 * radius / float(cells)) - Vec2f(radius, radius);
            ground.x.emplace_back(centre.x() + at.x(), centre.y(), centre.z() - at.y());
        }
    }
    ground.normals.assign(ground.x.size(), Vec3f::UnitY());
    for (std::uint32_t j = 0; j < cells; ++j) {
        for (std::uint32_t i = 0; i < cells; ++i) {
            const std::uint32_t a = j * (cells + 1) + i, b = a + 1, c = a + cells + 1, d = c + 1;
            ground.triangles.push_back({a, b, d});
            ground.triangles.push_back({a, d, c});
        }
    }
    return ground;
}

// One step of [1 2 1]/4 along the ground's rows or columns.
void soften_ground(std::vector<Openness>& openness, std::size_t step) {
    constexpr std::size_t side = kGroundCells + 1;
    const std::vector<Openness> before = openness;
    for (std::size_t i = 0; i < openness.size(); ++i) {
        const std::size_t place = step == 1 ? i % side : i / side;
        if (place == 0 || place + 1 == side) continue;
        openness[i].front = 0.25F * (before[i - step].front + 2 * before[i].front + before[i + step].front);
    }
}

// Each of the finitely many directions throws a faint shadow of its own on the ground: melt them into one.
std::vector<Openness> softened_ground(std::vector<Openness> openness) {
    constexpr int rounds = 14;  // spreads by the square root of half of it, in cells
    for (int round = 0; round < rounds; ++round) {
        soften_ground(openness, 1);
        soften_ground(openness, kGroundCells + 1);
    }
    return openness;
}

template <class T>
void upload(const GladGLContext& gl, GLenum target, const Buffer& buffer, const std::vector<T>& data) {
    gl.BindBuffer(target, buffer.id());
    gl.BufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), GL_STATIC_DRAW);
}

void add_attribute(const GladGLContext& gl, GLuint index, int floats, std::size_t stride, std::size_t offset) {
    gl.EnableVertexAttribArray(index);
    gl.VertexAttribPointer(index, floats, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                           reinterpret_cast<const void*>(offset));
}

SurfaceBuffer make_surface_buffer(const GladGLContext& gl, const BodyItem& item,
                                  const std::vector<Openness>& openness) {
    std::vector<SurfaceVertex> vertices;
    vertices.reserve(item.x.size());
    for (std::size_t i = 0; i < item.x.size(); ++i) {
        const Vec3f &x = item.x[i], &n = item.normals[i];
        vertices.push_back({{x.x(), x.y(), x.z()}, {n.x(), n.y(), n.z()}, openness[i].front});
    }
    SurfaceBuffer buffer{.vertex_array = VertexArray(gl), .vertices = Buffer(gl), .indices = Buffer(gl)};
    gl.BindVertexArray(buffer.vertex_array.id());
    upload(gl, GL_ARRAY_BUFFER, buffer.vertices, vertices);
    add_attribute(gl, 0, 3, sizeof(SurfaceVertex), offsetof(SurfaceVertex, position));
    add_attribute(gl, 1, 3, sizeof(SurfaceVertex), offsetof(SurfaceVertex, normal));
    add_attribute(gl, 2, 1, sizeof(SurfaceVertex), offsetof(SurfaceVertex, openness));
    upload(gl, GL_ELEMENT_ARRAY_BUFFER, buffer.indices, item.triangles);
    buffer.index_count = static_cast<int>(item.triangles.size() * 3);
    buffer.colour = to_linear(item.colour);
    return buffer;
}

void upload_sett(const GladGLContext& gl, const ClothItem& item, ClothBuffer& buffer) {
    const SettSums sett = sum_sett(item.sett);
    buffer.sett_mean = sett.mean;
    buffer.sett_threads = thread_count(item.sett);
    buffer.thread_spacing = static_cast<float>(item.sett.thread_spacing) * item.sett_scale;
    buffer.sett_position = item.sett_position;
    buffer.sett_sums = Texture(gl);
    gl.BindTexture(GL_TEXTURE_2D, buffer.sett_sums.id());
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, static_cast<GLsizei>(sett.sums.size()), 1, 0, GL_RGB, GL_FLOAT,
                  sett.sums.data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

ClothBuffer make_cloth_buffer(const GladGLContext& gl, const ClothItem& item, const std::vector<Openness>& openness) {
    const std::vector<ClothVertex> vertices = make_cloth_vertices(item.mesh, vertex_normals(item.mesh), openness);
    ClothBuffer buffer{.vertex_array = VertexArray(gl), .vertices = Buffer(gl)};
    gl.BindVertexArray(buffer.vertex_array.id());
    upload(gl, GL_ARRAY_BUFFER, buffer.vertices, vertices);
    add_attribute(gl, 0, 3, sizeof(ClothVertex), offsetof(ClothVertex, position));
    add_attribute(gl, 1, 3, sizeof(ClothVertex), offsetof(ClothVertex, normal));
    add_attribute(gl, 2, 2, sizeof(ClothVertex), offsetof(ClothVertex, place));
    add_attribute(gl, 3, 3, sizeof(ClothVertex), offsetof(ClothVertex, heights));
    add_attribute(gl, 4, 2, sizeof(ClothVertex), offsetof(ClothVertex, openness));
    add_attribute(gl, 5, 2, sizeof(ClothVertex), offsetof(ClothVertex, touch));
    gl.EnableVertexAttribArray(6);
    gl.VertexAttribIPointer(6, 1, GL_UNSIGNED_INT, sizeof(ClothVertex),
                            reinterpret_cast<const void*>(offsetof(ClothVertex, marks)));
    buffer.paint = make_paint_buffer(gl, item);
    buffer.vertex_count = static_cast<int>(vertices.size());
    buffer.colour = to_linear(item.colour);
    const bool can_weave = !item.sett.stripes.empty() && !item.mesh.u.empty();
    buffer.show = item.show == ShowMode::Tartan && !can_weave ? ShowMode::Plain : item.show;
    if (buffer.show == ShowMode::Tartan) upload_sett(gl, item, buffer);
    return buffer;
}

}  // namespace

Casters casters_of(const Scene& scene) {
    Casters casters;
    const auto add = [&](const std::vector<Vec3f>& x, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
        const auto base = static_cast<std::uint32_t>(casters.x.size());
        casters.x.insert(casters.x.end(), x.begin(), x.end());
        for (const auto& [a, b, c] : triangles) casters.triangles.push_back({a + base, b + base, c + base});
    };
    for (const ClothItem& cloth : scene.cloths) add(cloth.mesh.x, cloth.mesh.triangles);
    for (const BodyItem& body : scene.bodies) add(body.x, body.triangles);
    return casters;
}

SceneBuffers make_scene_buffers(const GladGLContext& gl, const Scene& scene, const Casters& casters) {
    SceneBuffers buffers;
    const Bounds bounds = bounds_of(casters.x);
    buffers.ground_centre = {bounds.centre.x(), scene.ground_y, bounds.centre.z()};
    buffers.ground_radius = 1.8F * bounds.radius;
    const BodyItem ground = scene.has_ground ? make_ground(buffers.ground_centre, buffers.ground_radius) : BodyItem{};

    LitPoints points;
    for (const ClothItem& cloth : scene.cloths) points.add(cloth.mesh.x, vertex_normals(cloth.mesh));
    for (const BodyItem& body : scene.bodies) points.add(body.x, body.normals);
    points.add(ground.x, ground.normals);
    Opennesses openness(bake_room_light(gl, casters, points.x, points.normals));

    for (const ClothItem& cloth : scene.cloths) {
        buffers.cloths.push_back(make_cloth_buffer(gl, cloth, openness.take(cloth.mesh.x.size())));
    }
    for (const BodyItem& body : scene.bodies) {
        buffers.bodies.push_back(make_surface_buffer(gl, body, openness.take(body.x.size())));
    }
    for (const SolidItem& solid : scene.solids) buffers.solids.push_back(make_solid_buffer(gl, solid));
    if (scene.has_ground)
        buffers.ground = make_surface_buffer(gl, ground, softened_ground(openness.take(ground.x.size())));
    return buffers;
}

}  // namespace selvedge

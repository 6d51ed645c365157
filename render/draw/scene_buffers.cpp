#include "render/draw/scene_buffers.h"

#include <algorithm>
#include <cstddef>

#include "render/draw/picture_texture.h"
#include "render/gl/context.h"
#include "render/scene/colour.h"
#include "sim/core/assert.h"

namespace selvedge::render {
namespace {

struct SurfaceVertex {
    std::array<float, 3> position;
    std::array<float, 3> normal;
    float ambient_visibility;
};

class AmbientVisibilityReader {
 public:
    explicit AmbientVisibilityReader(const std::vector<AmbientVisibility>& all) : all_(all) {}
    std::vector<AmbientVisibility> take(std::size_t count) {
        const auto first = all_.begin() + static_cast<std::ptrdiff_t>(taken_);
        taken_ += count;
        return {first, first + static_cast<std::ptrdiff_t>(count)};
    }

 private:
    const std::vector<AmbientVisibility>& all_;
    std::size_t taken_ = 0;
};

SurfaceBuffer make_surface_buffer(const GladGLContext& gl, const BodyItem& item,
                                  const std::vector<AmbientVisibility>& ambient_visibility) {
    std::vector<SurfaceVertex> vertices;
    vertices.reserve(item.x.size());
    for (std::size_t i = 0; i < item.x.size(); ++i) {
        const Vec3f &x = item.x[i], &n = item.normals[i];
        vertices.push_back({{x.x(), x.y(), x.z()}, {n.x(), n.y(), n.z()}, ambient_visibility[i].front});
    }
    SurfaceBuffer buffer{.vertex_array = VertexArray(gl), .vertices = Buffer(gl), .indices = Buffer(gl)};
    gl.BindVertexArray(buffer.vertex_array.id());
    upload(gl, GL_ARRAY_BUFFER, buffer.vertices, vertices, GL_STATIC_DRAW);
    add_floats(gl, 0, 3, sizeof(SurfaceVertex), offsetof(SurfaceVertex, position));
    add_floats(gl, 1, 3, sizeof(SurfaceVertex), offsetof(SurfaceVertex, normal));
    add_floats(gl, 2, 1, sizeof(SurfaceVertex), offsetof(SurfaceVertex, ambient_visibility));
    upload(gl, GL_ELEMENT_ARRAY_BUFFER, buffer.indices, item.triangles, GL_STATIC_DRAW);
    buffer.index_count = static_cast<int>(item.triangles.size() * 3);
    buffer.is_closed = is_closed(item);
    buffer.colour = to_linear(item.colour);
    buffer.material = item.material;
    return buffer;
}

// A texture with two rows, warp and weft, as long as the longer of the two.
void upload_setts(const GladGLContext& gl, const ClothItem& item, ClothBuffer& buffer) {
    buffer.warp = sum_warp(item.sett);
    buffer.weft = sum_weft(item.sett);
    buffer.weave = item.sett.weave;
    buffer.thread_spacing = static_cast<float>(item.sett.thread_spacing) * item.sett_scale;
    buffer.sett_position = item.sett_position;
    const std::size_t width = std::max(buffer.warp.sums.size(), buffer.weft.sums.size());
    std::vector<Vec3f> rows(2 * width, Vec3f::Zero());
    std::copy(buffer.warp.sums.begin(), buffer.warp.sums.end(), rows.begin());
    std::copy(buffer.weft.sums.begin(), buffer.weft.sums.end(), rows.begin() + static_cast<std::ptrdiff_t>(width));
    buffer.sett_sums = Texture(gl);
    gl.BindTexture(GL_TEXTURE_2D, buffer.sett_sums.id());
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, static_cast<GLsizei>(width), 2, 0, GL_RGB, GL_FLOAT, rows.data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

ClothBuffer make_cloth_buffer(const GladGLContext& gl, const ClothItem& item,
                              const std::vector<AmbientVisibility>& ambient_visibility) {
    const std::vector<ClothVertex> vertices =
        make_cloth_vertices(item.mesh, vertex_normals(item.mesh), ambient_visibility);
    ClothBuffer buffer{.vertex_array = VertexArray(gl), .vertices = Buffer(gl)};
    gl.BindVertexArray(buffer.vertex_array.id());
    upload(gl, GL_ARRAY_BUFFER, buffer.vertices, vertices, GL_STATIC_DRAW);
    add_floats(gl, 0, 3, sizeof(ClothVertex), offsetof(ClothVertex, position));
    add_floats(gl, 1, 3, sizeof(ClothVertex), offsetof(ClothVertex, normal));
    add_floats(gl, 2, 2, sizeof(ClothVertex), offsetof(ClothVertex, place));
    add_floats(gl, 3, 3, sizeof(ClothVertex), offsetof(ClothVertex, heights));
    add_floats(gl, 4, 2, sizeof(ClothVertex), offsetof(ClothVertex, ambient_visibility));
    add_floats(gl, 5, 2, sizeof(ClothVertex), offsetof(ClothVertex, touch));
    gl.EnableVertexAttribArray(6);
    gl.VertexAttribIPointer(6, 1, GL_UNSIGNED_INT, sizeof(ClothVertex),
                            reinterpret_cast<const void*>(offsetof(ClothVertex, marks)));
    buffer.paint = make_paint_buffer(gl, item);
    buffer.vertex_count = static_cast<int>(vertices.size());
    buffer.colour = to_linear(item.colour);
    buffer.material = item.material;
    const bool can_show = (item.picture || !item.sett.stripes.empty()) && !item.mesh.u.empty();
    buffer.show = item.show == ShowMode::Tartan && !can_show ? ShowMode::Plain : item.show;
    if (buffer.show == ShowMode::Tartan && item.picture) {
        buffer.picture = make_picture_texture(gl, *item.picture, TexelLight::Linear);
        buffer.picture_rows = picture_rows(*item.picture);
        buffer.picture_ground = to_linear(item.picture->ground);
    } else if (buffer.show == ShowMode::Tartan) {
        upload_setts(gl, item, buffer);
    }
    return buffer;
}

}  // namespace

bool is_closed(const BodyItem& item) {
    Vec3d facing = Vec3d::Zero();
    double area = 0;
    for (const auto& [a, b, c] : item.triangles) {
        const Vec3f doubled = (item.x[b] - item.x[a]).cross(item.x[c] - item.x[a]);
        facing += doubled.cast<double>();
        area += double(doubled.norm());
    }
    return facing.norm() < 1e-4 * area;
}

SceneBuffers make_scene_buffers(const GladGLContext& gl, const Scene& scene, const Ground& ground,
                                const std::vector<AmbientVisibility>& ambient_visibility) {
    SceneBuffers buffers;
    buffers.ground_centre = ground.centre;
    buffers.ground_radius = ground.radius;
    AmbientVisibilityReader each(ambient_visibility);
    for (const ClothItem& cloth : scene.cloths) {
        buffers.cloths.push_back(make_cloth_buffer(gl, cloth, each.take(cloth.mesh.x.size())));
    }
    for (const BodyItem& body : scene.bodies) {
        buffers.bodies.push_back(make_surface_buffer(gl, body, each.take(body.x.size())));
    }
    if (scene.has_ground) {
        buffers.ground = make_surface_buffer(gl, ground.sheet, softened_ground(each.take(ground.sheet.x.size())));
    }
    for (const SolidItem& solid : scene.solids) buffers.solids.push_back(make_solid_buffer(gl, solid));
    return buffers;
}

namespace {

// Compares all but camera, light and background, which no buffer holds.
bool has_same_content(const Scene& a, const Scene& b) {
    return a.has_ground == b.has_ground && a.ground_y == b.ground_y && a.cloths == b.cloths && a.bodies == b.bodies &&
           a.solids == b.solids;
}

// In the order in which make_scene_buffers() reads their ambient visibility.
LitPoints lit_points(const Scene& scene, const Ground& ground) {
    LitPoints points;
    for (const ClothItem& cloth : scene.cloths) points.add(cloth.mesh.x, vertex_normals(cloth.mesh));
    points.two_sided = points.x.size();
    for (const BodyItem& body : scene.bodies) points.add(body.x, body.normals);
    points.add(ground.sheet.x, ground.sheet.normals);
    return points;
}

}  // namespace

PreparedScene::PreparedScene(const GladGLContext& gl) : gl_(gl), shadow_(gl) {}

void PreparedScene::prepare(const Scene& scene, PartClock& clock) {
    const bool is_same = scene_ && has_same_content(*scene_, scene);
    clock.lap(&PictureTimes::compare);
    if (!is_same) {
        build(scene, clock);
        scene_ = std::make_shared<const Scene>(scene);
        clock.lap(&PictureTimes::upload);
    }
    turn_light(scene.light, clock);
}

void PreparedScene::prepare(const SceneView& view, PartClock& clock) {
    const bool is_same = scene_ && (scene_ == view.scene || has_same_content(*scene_, *view.scene));
    clock.lap(&PictureTimes::compare);
    if (!is_same) build(*view.scene, clock);
    scene_ = view.scene;
    turn_light(view.light, clock);
}

void PreparedScene::build(const Scene& scene, PartClock& clock) {
    Casters casters = casters_of(scene);
    bounds_ = steady_bounds_of(casters.x);
    const Ground ground = make_ground(scene, bounds_);
    LitPoints points = lit_points(scene, ground);
    if (!(casters == casters_ && points == points_)) {
        ambient_visibility_ = ambient_occlusion_.bake(cloth_casters_of(scene), body_casters_of(scene), points);
    }
    clock.lap(&PictureTimes::ambient_occlusion);
    points_ = std::move(points);
    if (!(casters == casters_)) {
        casters_ = std::move(casters);
        shadow_.load(casters_);
        key_matrix_.setZero();
    }
    buffers_ = make_scene_buffers(gl_, scene, ground, ambient_visibility_);
    clock.lap(&PictureTimes::upload);
}

void PreparedScene::turn_light(const Light& light, PartClock& clock) {
    const Eigen::Matrix4f key_matrix = parallel_matrix(bounds_, light.to_key.normalized());
    if (key_matrix != key_matrix_) {
        key_matrix_ = key_matrix;
        shadow_.draw(key_matrix_, kShadowReach / shadow_width());
    }
    clock.lap(&PictureTimes::shadow);
}

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
        const sim::Rgb8& colour = item.colours[i];
        vertices.push_back({{x.x(), x.y(), x.z()}, {n.x(), n.y(), n.z()}, {colour[0], colour[1], colour[2], 255}});
    }
    return vertices;
}

}  // namespace

SolidBuffer make_solid_buffer(const GladGLContext& gl, const SolidItem& item) {
    const std::vector<SolidVertex> vertices = solid_vertices(item);
    SolidBuffer buffer{.vertex_array = VertexArray(gl), .vertices = Buffer(gl), .indices = Buffer(gl)};
    gl.BindVertexArray(buffer.vertex_array.id());
    upload(gl, GL_ARRAY_BUFFER, buffer.vertices, vertices, GL_STATIC_DRAW);
    add_floats(gl, 0, 3, sizeof(SolidVertex), offsetof(SolidVertex, position));
    add_floats(gl, 1, 3, sizeof(SolidVertex), offsetof(SolidVertex, normal));
    add_bytes(gl, 2, 4, sizeof(SolidVertex), offsetof(SolidVertex, colour));
    upload(gl, GL_ELEMENT_ARRAY_BUFFER, buffer.indices, item.triangles, GL_STATIC_DRAW);
    buffer.index_count = static_cast<int>(item.triangles.size() * 3);
    return buffer;
}

}  // namespace selvedge::render

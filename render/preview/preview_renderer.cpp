#include "render/preview/preview_renderer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <deque>
#include <optional>

#include "render/draw/cloth_vertices.h"
#include "render/draw/light_uniforms.h"
#include "render/draw/picture_texture.h"
#include "render/draw/renderer.h"
#include "render/draw/scene_buffers.h"
#include "render/gl/context.h"
#include "render/gl/target.h"
#include "render/preview/picture_mean.h"
#include "render/scene/colour.h"
#include "sim/core/assert.h"

namespace selvedge::render {

// The place of a body's soft shadow on the ground. Not in the unnamed namespace, because PreviewRenderer::Impl has it
// as a member: g++ warns of that in a batch of sources.
struct Footprint {
    Vec3f centre = Vec3f::Zero();
    Vec2f reach = Vec2f::Zero();  // m, half axes along x and z
};

namespace {

constexpr float kBodyAmbientVisibility = 0.85F;  // constant ambient visibility, because previews bake none
constexpr float kSeamInk = 0.28F, kEdgeInk = 0.6F;

std::optional<Footprint> footprint_of(const Scene& scene) {
    if (!scene.has_ground) return std::nullopt;
    constexpr float low = 0.25F, margin = 0.22F;  // m: higher parts of a body are ignored
    Eigen::AlignedBox3f box;
    for (const BodyItem& body : scene.bodies) {
        for (const Vec3f& x : body.x) {
            if (x.y() < scene.ground_y + low) box.extend(x);
        }
    }
    if (box.isEmpty()) return std::nullopt;
    return Footprint{.centre = {box.center().x(), scene.ground_y, box.center().z()},
                     .reach = {0.5F * box.sizes().x() + margin, 0.5F * box.sizes().z() + margin}};
}

// World space to clip space, upside down: the texture's row 0 is the picture's top row. The picture is shifted by
// `offset_px`.
Eigen::Matrix4f upside_down_matrix(const SceneView& view, const PictureTexture& to, const Vec2f& offset_px) {
    Eigen::Matrix4f matrix =
        projection_matrix(view.camera, float(to.width_px()) / float(to.height_px())) * view_matrix(view.camera);
    matrix.row(1) *= -1;
    const Eigen::RowVector4f w = matrix.row(3);
    matrix.row(0) += 2 * offset_px.x() / float(to.width_px()) * w;
    matrix.row(1) += 2 * offset_px.y() / float(to.height_px()) * w;
    return matrix;
}

// The digits of the number behind the point, in reverse order: 0..1.  (van der Corput 1935)
float reversed_digits(int number, int base) {
    float result = 0, place = 1;
    for (; number > 0; number /= base) {
        place /= float(base);
        result += place * float(number % base);
    }
    return result;
}

// What one picture of a view is, of several that are averaged.
struct Sample {
    Vec2f offset_px = Vec2f::Zero();  // within the pixel, -0.5 to 0.5
    float finer = 0;                  // by so many levels of a tartan's texture than its pixels ask for
};

// Within the pixel, -0.5 to 0.5 px: evenly spread, however many there are. Sample 0 is the pixel's centre. (Halton
// 1960)
Vec2f offset_of(int sample) {
    const auto centred = [](float x) { return x < 0.5F ? x : x - 1; };
    return {centred(reversed_digits(sample, 2)), centred(reversed_digits(sample, 3))};
}

void set_light(const Program& program, const SceneView& view, const Eigen::Matrix4f& camera) {
    set_light(program, view.light, view.camera.eye);
    program.set("camera", camera);
}

Vec3f as_floats(const sim::Rgb8& colour) {
    return Vec3f(float(colour[0]), float(colour[1]), float(colour[2])) / 255;
}

}  // namespace

struct PreviewRenderer::Impl {
    explicit Impl(GlContext& made_elsewhere)
        : context(made_elsewhere),
          gl(made_elsewhere.gl()),
          surface(make_program(gl, {"preview_key.glsl", "light.glsl", "encode.glsl", "preview_surface.vert"},
                               {"preview_surface.frag"})),
          cloth(make_program(gl, {"preview_key.glsl", "light.glsl", "encode.glsl", "preview_cloth.vert"},
                             {"preview_cloth.frag"})),
          ground(make_program(gl, {"preview_ground.vert"}, {"preview_ground.frag"})),
          backdrop_program(
              make_program(gl, {"screen.vert"}, {"backdrop.glsl", "encode.glsl", "preview_backdrop.frag"})),
          no_vertices(gl),
          depth(gl),
          backdrop(gl) {
        cloth.use();
        for (int level = 0; level < kLevelColours; ++level) {
            cloth.set(("level_colours[" + std::to_string(level) + "]").c_str(), as_floats(level_colour(level)));
        }
    }

    template <class Item, class Drawn>
    void update_all(const std::vector<Item>& items, const std::vector<Item>* before, std::deque<Drawn>& drawn) {
        while (drawn.size() > items.size()) drawn.pop_back();
        for (std::size_t i = 0; i < items.size(); ++i) {
            const bool is_known = i < drawn.size();
            if (!is_known) drawn.emplace_back(gl);
            drawn[i].update(items[i], is_known && before != nullptr ? &(*before)[i] : nullptr);
        }
    }

    void prepare(const std::shared_ptr<const Scene>& next) {
        if (scene == next) return;
        update_all(next->cloths, scene ? &scene->cloths : nullptr, cloths);
        update_all(next->bodies, scene ? &scene->bodies : nullptr, bodies);
        update_all(next->solids, scene ? &scene->solids : nullptr, solids);
        scene = next;
        footprint = footprint_of(*next);
    }

    // Draws the backdrop once, then copies it: it is most of a picture and the same in all pictures of a view.
    void draw_backdrop(const Background& requested, const PictureTexture& to) {
        const bool is_same_size = backdrop.width_px() == to.width_px() && backdrop.height_px() == to.height_px();
        if (!is_same_size || !background || background->centre != requested.centre ||
            background->edge != requested.edge) {
            background = requested;
            backdrop.resize(to.width_px(), to.height_px());
            gl.BindFramebuffer(GL_FRAMEBUFFER, backdrop.framebuffer());
            backdrop_program.use();
            backdrop_program.set("tile_origin_px", Vec2f(0, 0));
            backdrop_program.set("picture_size_px", Vec2f(float(to.width_px()), float(to.height_px())));
            backdrop_program.set("backdrop_centre", to_linear(requested.centre));
            backdrop_program.set("backdrop_edge", to_linear(requested.edge));
            gl.BindVertexArray(no_vertices.id());
            gl.DrawArrays(GL_TRIANGLES, 0, 3);
        }
        gl.BindFramebuffer(GL_READ_FRAMEBUFFER, backdrop.framebuffer());
        gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, to.framebuffer());
        gl.BlitFramebuffer(0, 0, to.width_px(), to.height_px(), 0, 0, to.width_px(), to.height_px(),
                           GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }

    void begin(const PictureTexture& to) {
        gl.Disable(GL_SCISSOR_TEST);
        gl.Disable(GL_BLEND);
        gl.Disable(GL_DEPTH_TEST);
        gl.Disable(GL_MULTISAMPLE);
        gl.Viewport(0, 0, to.width_px(), to.height_px());
    }

    // The depth buffer belongs to the view; it is attached to the texture while that is drawn.
    void attach_depth(const PictureTexture& to) {
        gl.BindFramebuffer(GL_FRAMEBUFFER, to.framebuffer());
        gl.BindRenderbuffer(GL_RENDERBUFFER, depth.id());
        if (depth_width_px != to.width_px() || depth_height_px != to.height_px()) {
            depth_width_px = to.width_px();
            depth_height_px = to.height_px();
            gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, depth_width_px, depth_height_px);
        }
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth.id());
        gl.Clear(GL_DEPTH_BUFFER_BIT);
    }

    void draw(const SceneView& view, const Sample& how, const PictureTexture& to) {
        context.make_current();
        prepare(view.scene);
        const Eigen::Matrix4f camera = upside_down_matrix(view, to, how.offset_px);
        begin(to);
        attach_depth(to);  // first: GL draws only to the size of the smallest attachment
        draw_backdrop(view.scene->background, to);
        gl.FrontFace(GL_CW);  // because the picture is upside down
        draw_ground(camera);
        gl.Enable(GL_DEPTH_TEST);
        draw_cloths(view, camera, how.finer);  // before bodies: parts of a body that it hides are not shaded
        draw_surfaces(view, camera);
        gl.Disable(GL_DEPTH_TEST);
        gl.FrontFace(GL_CCW);
    }

    void draw_ground(const Eigen::Matrix4f& camera) const {
        if (!footprint) return;
        ground.use();
        ground.set("camera", camera);
        ground.set("ground_centre", footprint->centre);
        ground.set("ground_reach", footprint->reach);
        gl.Enable(GL_BLEND);
        gl.BlendEquation(GL_FUNC_ADD);
        gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
        gl.Enable(GL_CULL_FACE);
        gl.BindVertexArray(no_vertices.id());
        gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
        gl.Disable(GL_CULL_FACE);
        gl.Disable(GL_BLEND);
    }

    void draw_cloths(const SceneView& view, const Eigen::Matrix4f& camera, float finer) const {
        if (cloths.empty()) return;
        cloth.use();
        set_light(cloth, view, camera);
        cloth.set("picture", 0);
        cloth.set("line_px", 0.6F);
        cloth.set("finer", finer);
        gl.ActiveTexture(GL_TEXTURE0);
        for (std::size_t i = 0; i < cloths.size(); ++i) draw_cloth(cloths[i], scene->cloths[i]);
    }

    void draw_cloth(const PreviewCloth& drawn, const ClothItem& item) const {
        const bool is_level = item.show == ShowMode::Level;
        const bool has_edges = is_level || item.show == ShowMode::Edges || item.ink > 0;
        const bool has_picture = drawn.is_woven() || drawn.is_printed() || drawn.is_painted();
        cloth.set("cloth_colour", has_picture ? Vec3f(1, 1, 1) : as_floats(item.colour));
        cloth.set("level_share", is_level ? 1.0F : 0.0F);
        cloth.set("all_lines", has_edges ? 1 : 0);
        cloth.set("ink", has_edges ? std::max(kEdgeInk * (item.ink > 0 ? item.ink : 1), kSeamInk) : kSeamInk);
        std::array<Vec3f, 2> rows{Vec3f(1, 0, 0), Vec3f(0, 1, 0)};
        if (drawn.is_printed()) {
            rows = picture_rows(*item.picture);
        } else if (drawn.is_woven()) {
            const float spacing = static_cast<float>(item.sett.thread_spacing) * item.sett_scale;
            const Vec2f scale(1 / (spacing * float(drawn.threads()[0])), 1 / (spacing * float(drawn.threads()[1])));
            rows = {Vec3f(scale.x(), 0, -item.sett_position.x() * scale.x()),
                    Vec3f(0, scale.y(), -item.sett_position.y() * scale.y())};
        } else if (drawn.is_painted()) {
            const auto colours = float(item.paint->map.size());
            rows[0] = Vec3f((colours - 1) / colours, 0, 0.5F / colours);
        }
        cloth.set("place_u", rows[0]);
        cloth.set("place_v", rows[1]);
        gl.BindTexture(GL_TEXTURE_2D, drawn.picture());
        gl.BindVertexArray(drawn.vertex_array());
        gl.DrawArrays(GL_TRIANGLES, 0, drawn.vertex_count());
    }

    void draw_surfaces(const SceneView& view, const Eigen::Matrix4f& camera) const {
        if (bodies.empty() && solids.empty()) return;
        surface.use();
        set_light(surface, view, camera);
        surface.set("body_share", 1.0F);
        surface.set("ambient_visibility", kBodyAmbientVisibility);
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            surface.set("body_colour", to_linear(scene->bodies[i].colour));
            set_material(scene->bodies[i].material);
            draw_surface(bodies[i]);
        }
        surface.set("body_share", 0.0F);
        surface.set("ambient_visibility", 1.0F);
        set_material({.gloss = 0.04F, .roughness = 0.3F, .sheen = 0});
        for (const PreviewSurface& solid : solids) draw_surface(solid);
    }

    void set_material(const Material& material) const {
        surface.set("gloss", material.gloss);
        surface.set("roughness", material.roughness);
        surface.set("sheen", material.sheen);
    }

    void draw_surface(const PreviewSurface& drawn) const {
        if (drawn.is_closed()) gl.Enable(GL_CULL_FACE);
        gl.BindVertexArray(drawn.vertex_array());
        gl.DrawElements(GL_TRIANGLES, drawn.index_count(), GL_UNSIGNED_INT, nullptr);
        gl.Disable(GL_CULL_FACE);
    }

    GlContext& context;
    const GladGLContext& gl;
    Program surface, cloth, ground, backdrop_program;
    VertexArray no_vertices;
    Renderbuffer depth;
    int depth_width_px = 0, depth_height_px = 0;
    PictureTexture backdrop;
    std::optional<Background> background;  // shown by `backdrop`
    std::shared_ptr<const Scene> scene;    // held by the buffers
    std::deque<PreviewCloth> cloths;
    std::deque<PreviewSurface> bodies, solids;
    std::optional<Footprint> footprint;
    std::optional<PictureMean> mean;  // both made when a view first rests
    std::optional<PictureTexture> sample;
};

PreviewRenderer::PreviewRenderer(GlContext& context) : impl_(std::make_unique<Impl>(context)) {}
PreviewRenderer::~PreviewRenderer() = default;

void PreviewRenderer::draw(const SceneView& view, PictureTexture& to) {
    impl_->draw(view, {}, to);
}

void PreviewRenderer::refine(const SceneView& view, int sample, PictureTexture& to) {
    SELVEDGE_ASSERT(sample >= 0);
    Impl& impl = *impl_;
    impl.context.make_current();
    if (!impl.mean) impl.mean.emplace(impl.gl);
    if (!impl.sample) impl.sample.emplace(impl.gl);
    if (sample == 0) impl.mean->clear(to.width_px(), to.height_px());
    impl.sample->resize(to.width_px(), to.height_px());
    constexpr float kFiner = 2;  // sixteen samples see each a sixteenth of the pixel
    impl.draw(view, {.offset_px = offset_of(sample), .finer = sample > 0 ? kFiner : 0}, *impl.sample);
    impl.mean->add(*impl.sample);
    impl.mean->draw(to);
}

namespace {

// Compares bytes, which is faster than comparing numbers. A false difference only costs an upload.
template <class T>
bool is_same(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

// Same triangles, material coordinates and panels.
bool has_same_topology(const sim::DrawMesh& a, const sim::DrawMesh& b) {
    return is_same(a.triangles, b.triangles) && is_same(a.u, b.u) && is_same(a.panel, b.panel);
}

bool is_same_fixed(const ClothItem& a, const ClothItem& b) {
    return is_same(a.mesh.level, b.mesh.level) && a.mesh.panel_grain_angles == b.mesh.panel_grain_angles &&
           a.mesh.panel_sett_offsets == b.mesh.panel_sett_offsets && a.show == b.show &&
           a.picture.has_value() == b.picture.has_value() && a.paint.has_value() == b.paint.has_value() &&
           (!a.paint || is_same(a.paint->places, b.paint->places));
}

bool is_same_picture(const ClothItem& a, const ClothItem& b) {
    return a.picture == b.picture && a.show == b.show && a.sett == b.sett &&
           a.paint.has_value() == b.paint.has_value() && a.mesh.u.empty() == b.mesh.u.empty() &&
           (!a.paint || a.paint->map == b.paint->map);
}

// For one panel: from material coordinates to the fabric's (weft, warp).
struct PanelTurn {
    float c = 1, s = 0;
    Vec2f offset{0, 0};

    std::array<float, 2> place_of(const Vec2f& u) const {
        return {c * u.x() + s * u.y() + offset.x(), -s * u.x() + c * u.y() + offset.y()};
    }
};

std::vector<PanelTurn> panel_turns(const sim::DrawMesh& mesh) {
    std::vector<PanelTurn> turns(
        std::max({std::size_t(1), mesh.panel_grain_angles.size(), mesh.panel_sett_offsets.size()}));
    for (std::size_t i = 0; i < mesh.panel_grain_angles.size(); ++i) {
        turns[i].c = std::cos(mesh.panel_grain_angles[i]);
        turns[i].s = std::sin(mesh.panel_grain_angles[i]);
    }
    for (std::size_t i = 0; i < mesh.panel_sett_offsets.size(); ++i) turns[i].offset = mesh.panel_sett_offsets[i];
    return turns;
}

Image image_of_map(const std::vector<sim::Rgb8>& map) {
    Image image(static_cast<int>(map.size()), 1);
    for (std::size_t i = 0; i < map.size(); ++i) image.pixels[i] = {map[i][0], map[i][1], map[i][2], 255};
    return image;
}

}  // namespace

PreviewCloth::PreviewCloth(const GladGLContext& gl) : gl_(gl), vertex_array_(gl), fixed_(gl), moving_(gl) {
    gl_.BindVertexArray(vertex_array_.id());
    gl_.BindBuffer(GL_ARRAY_BUFFER, moving_.id());
    add_floats(gl_, 0, 3, sizeof(corners_[0]), 0);
    add_floats(gl_, 1, 3, sizeof(corners_[0]), sizeof(Vec3f));
    gl_.BindBuffer(GL_ARRAY_BUFFER, fixed_.id());
    add_floats(gl_, 2, 2, sizeof(FixedVertex), offsetof(FixedVertex, place));
    gl_.EnableVertexAttribArray(3);
    gl_.VertexAttribIPointer(3, 1, GL_UNSIGNED_INT, sizeof(FixedVertex),
                             reinterpret_cast<const void*>(offsetof(FixedVertex, marks)));
}

void PreviewCloth::update(const ClothItem& item, const ClothItem* before) {
    const bool has_same_net = before != nullptr && has_same_topology(item.mesh, before->mesh);
    if (!has_same_net) marks_ = mark_edges(item.mesh);
    if (before == nullptr || !is_same_picture(item, *before)) fill_picture(item);
    if (!has_same_net || !is_same_fixed(item, *before)) fill_fixed(item);
    if (!has_same_net || !is_same(item.mesh.x, before->mesh.x) || !is_same(item.mesh.normals, before->mesh.normals)) {
        fill_moving(item);
    }
}

void PreviewCloth::fill_picture(const ClothItem& item) {
    const bool has_place = item.show == ShowMode::Tartan && !item.mesh.u.empty();
    is_printed_ = has_place && item.picture.has_value();
    is_woven_ = has_place && !is_printed_ && !item.sett.stripes.empty();
    is_painted_ = item.show > ShowMode::Plain && item.paint.has_value();
    if (is_printed_) {
        gl_.ActiveTexture(GL_TEXTURE0);
        picture_ = make_picture_texture(gl_, *item.picture, TexelLight::Srgb);
        return;
    }
    if (is_woven_) {
        threads_ = {sum_warp(item.sett).threads(), sum_weft(item.sett).threads()};
        picture_ = upload_preview_weave(gl_, preview_weave(item.sett));
        return;
    }
    picture_ = upload_preview_weave(
        gl_, {is_painted_ ? image_of_map(item.paint->map) : Image(1, 1, Rgba8{255, 255, 255, 255})});
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
}

void PreviewCloth::fill_fixed(const ClothItem& item) {
    const sim::DrawMesh& mesh = item.mesh;
    const std::vector<PanelTurn> turns = panel_turns(mesh);
    SELVEDGE_ASSERT(!is_painted_ || item.paint->places.size() == mesh.triangles.size());
    fixed_vertices_.clear();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::size_t panel = panel_of(mesh, t);
        const PanelTurn& turn = turns[panel < turns.size() ? panel : 0];
        const std::uint32_t level = mesh.level.empty() ? 0U : mesh.level[t];
        const std::uint32_t marks = level | marks_[t].seam << 8 | marks_[t].hem << 11;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            std::array<float, 2> place{0, 0};
            if (is_painted_) place = {item.paint->places[t][corner], 0.5F};
            if (is_woven_ || is_printed_) place = turn.place_of(mesh.u[t][corner]);
            fixed_vertices_.push_back({place, marks});
        }
    }
    upload(gl_, GL_ARRAY_BUFFER, fixed_, fixed_vertices_, GL_STREAM_DRAW);
}

void PreviewCloth::fill_moving(const ClothItem& item) {
    const sim::DrawMesh& mesh = item.mesh;
    const bool has_normals = mesh.normals.size() == mesh.x.size();
    const std::vector<Vec3f> own = has_normals ? std::vector<Vec3f>{} : sim::vertex_normals(mesh);
    const std::vector<Vec3f>& normals = has_normals ? mesh.normals : own;
    corners_.clear();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t v = mesh.triangles[t][k];
            corners_.push_back({mesh.x[v], sim::is_turned(mesh, t, k) ? Vec3f(-normals[v]) : normals[v]});
        }
    }
    upload(gl_, GL_ARRAY_BUFFER, moving_, corners_, GL_STREAM_DRAW);
    vertex_count_ = static_cast<int>(corners_.size());
}

PreviewSurface::PreviewSurface(const GladGLContext& gl)
    : gl_(gl), vertex_array_(gl), positions_(gl), normals_(gl), colours_(gl), indices_(gl) {
    gl_.BindVertexArray(vertex_array_.id());
    gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
    gl_.BindBuffer(GL_ARRAY_BUFFER, positions_.id());
    add_floats(gl_, 0, 3, sizeof(Vec3f), 0);
    gl_.BindBuffer(GL_ARRAY_BUFFER, normals_.id());
    add_floats(gl_, 1, 3, sizeof(Vec3f), 0);
}

void PreviewSurface::fill_points(const std::vector<Vec3f>& x, const std::vector<Vec3f>& normals) {
    SELVEDGE_ASSERT(normals.size() == x.size());
    upload(gl_, GL_ARRAY_BUFFER, positions_, x, GL_STREAM_DRAW);
    upload(gl_, GL_ARRAY_BUFFER, normals_, normals, GL_STREAM_DRAW);
}

void PreviewSurface::fill_triangles(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    gl_.BindVertexArray(vertex_array_.id());
    upload(gl_, GL_ELEMENT_ARRAY_BUFFER, indices_, triangles, GL_STREAM_DRAW);
    index_count_ = static_cast<int>(triangles.size() * 3);
}

void PreviewSurface::update(const BodyItem& item, const BodyItem* before) {
    const bool has_moved = before == nullptr || !is_same(item.x, before->x) || !is_same(item.normals, before->normals);
    const bool is_other_net = before == nullptr || !is_same(item.triangles, before->triangles);
    if (has_moved) fill_points(item.x, item.normals);
    if (is_other_net) fill_triangles(item.triangles);
    if (has_moved || is_other_net) is_closed_ = render::is_closed(item);
}

void PreviewSurface::update(const SolidItem& item, const SolidItem* before) {
    SELVEDGE_ASSERT(item.colours.size() == item.x.size());
    if (before == nullptr || !is_same(item.x, before->x) || !is_same(item.normals, before->normals)) {
        fill_points(item.x, item.normals);
    }
    if (before == nullptr || !is_same(item.triangles, before->triangles)) fill_triangles(item.triangles);
    if (before != nullptr && is_same(item.colours, before->colours)) return;
    gl_.BindVertexArray(vertex_array_.id());
    upload(gl_, GL_ARRAY_BUFFER, colours_, item.colours, GL_STREAM_DRAW);
    add_bytes(gl_, 2, 3, sizeof(sim::Rgb8), 0);
}

namespace {

constexpr unsigned kMaxTexels = 512;  // per side

int texels_for(const SettSums& sums) {
    return static_cast<int>(std::bit_ceil(std::min(static_cast<unsigned>(sums.threads()), kMaxTexels)));
}

Vec3f sum_at(const SettSums& sums, double thread) {
    const auto below = std::min(static_cast<std::size_t>(thread), sums.sums.size() - 2);
    const auto share = static_cast<float>(thread - static_cast<double>(below));
    return (1 - share) * sums.sums[below] + share * sums.sums[below + 1];
}

// Mean colours, in linear light, of `count` equal parts of the repeat.
std::vector<Vec3f> mean_colours(const SettSums& sums, int count) {
    std::vector<Vec3f> colours;
    const double width = double(sums.threads()) / double(count);
    for (int i = 0; i < count; ++i) {
        const Vec3f change = sum_at(sums, width * (i + 1)) - sum_at(sums, width * i);
        colours.emplace_back((sums.mean + change / float(width)).cwiseMax(0));
    }
    return colours;
}

;

using PreviewSrgb = SrgbTable<float, 4096>;

Image weave_of_size(const std::vector<Vec3f>& warp, const std::vector<Vec3f>& weft, float warp_direction_share,
                    const PreviewSrgb& srgb) {
    Image image(static_cast<int>(warp.size()), static_cast<int>(weft.size()));
    for (std::size_t y = 0; y < weft.size(); ++y) {
        for (std::size_t x = 0; x < warp.size(); ++x) {
            const Vec3f mixed = warp_direction_share * warp[x] + (1 - warp_direction_share) * weft[y];
            image.pixels[y * warp.size() + x] = {srgb.at(mixed.x()), srgb.at(mixed.y()), srgb.at(mixed.z()), 255};
        }
    }
    return image;
}

}  // namespace

std::vector<Image> preview_weave(const sim::Sett& sett) {
    const SettSums warp = sum_warp(sett), weft = sum_weft(sett);
    const float warp_direction_share = sett.weave == sim::Weave::Twill31 ? 0.75F : 0.5F;
    const PreviewSrgb srgb;
    std::vector<Image> sizes;
    for (int width = texels_for(warp), height = texels_for(weft);; width = (width + 1) / 2, height = (height + 1) / 2) {
        sizes.push_back(
            weave_of_size(mean_colours(warp, width), mean_colours(weft, height), warp_direction_share, srgb));
        if (width == 1 && height == 1) return sizes;
    }
}

Texture upload_preview_weave(const GladGLContext& gl, const std::vector<Image>& sizes) {
    Texture texture(gl);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, texture.id());
    for (std::size_t level = 0; level < sizes.size(); ++level) {
        gl.TexImage2D(GL_TEXTURE_2D, static_cast<GLint>(level), GL_RGBA8, sizes[level].width_px, sizes[level].height_px,
                      0, GL_RGBA, GL_UNSIGNED_BYTE, sizes[level].pixels.data());
    }
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(sizes.size()) - 1);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, sizes.size() > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return texture;
}

}  // namespace selvedge::render

#include "render/preview/preview_renderer.h"

#include <algorithm>
#include <deque>
#include <optional>

#include "render/draw/renderer.h"
#include "render/gl/context.h"
#include "render/gl/target.h"
#include "render/preview/preview_buffers.h"
#include "render/scene/colour.h"

namespace selvedge::render {
namespace {

constexpr float kBodyAmbientVisibility = 0.85F;  // constant ambient visibility, because previews bake none
constexpr float kSeamInk = 0.28F, kEdgeInk = 0.6F;

// The place of a body's soft shadow on the ground.
struct Footprint {
    Vec3f centre = Vec3f::Zero();
    Vec2f reach = Vec2f::Zero();  // m, half axes along x and z
};

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

// World space to clip space, upside down: the texture's row 0 is the picture's top row.
Eigen::Matrix4f upside_down_matrix(const SceneView& view, const PictureTexture& to) {
    Eigen::Matrix4f matrix =
        projection_matrix(view.camera, float(to.width_px()) / float(to.height_px())) * view_matrix(view.camera);
    matrix.row(1) *= -1;
    return matrix;
}

void set_light(const Program& program, const SceneView& view, const Eigen::Matrix4f& camera) {
    const Light& light = view.light;
    program.set("camera", camera);
    program.set("eye", view.camera.eye);
    program.set("to_key", Vec3f(light.to_key.normalized()));
    program.set("to_fill", Vec3f(light.to_fill.normalized()));
    program.set("key_irradiance", light.key);
    program.set("fill_irradiance", light.fill);
    program.set("sky_irradiance", light.sky);
    program.set("bounce_irradiance", light.bounce);
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
    void draw_backdrop(const Background& wished, const PictureTexture& to) {
        const bool is_same_size = backdrop.width_px() == to.width_px() && backdrop.height_px() == to.height_px();
        if (!is_same_size || !background || background->centre != wished.centre || background->edge != wished.edge) {
            background = wished;
            backdrop.resize(to.width_px(), to.height_px());
            gl.BindFramebuffer(GL_FRAMEBUFFER, backdrop.framebuffer());
            backdrop_program.use();
            backdrop_program.set("tile_origin_px", Vec2f(0, 0));
            backdrop_program.set("picture_size_px", Vec2f(float(to.width_px()), float(to.height_px())));
            backdrop_program.set("backdrop_centre", to_linear(wished.centre));
            backdrop_program.set("backdrop_edge", to_linear(wished.edge));
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

    void draw_cloths(const SceneView& view, const Eigen::Matrix4f& camera) const {
        if (cloths.empty()) return;
        cloth.use();
        set_light(cloth, view, camera);
        cloth.set("picture", 0);
        cloth.set("line_px", 0.6F);
        gl.ActiveTexture(GL_TEXTURE0);
        for (std::size_t i = 0; i < cloths.size(); ++i) draw_cloth(cloths[i], scene->cloths[i]);
    }

    void draw_cloth(const PreviewCloth& drawn, const ClothItem& item) const {
        const bool is_level = item.show == ShowMode::Level;
        const bool has_edges = is_level || item.show == ShowMode::Edges || item.ink > 0;
        const bool has_picture = drawn.is_woven() || drawn.is_painted();
        cloth.set("cloth_colour", has_picture ? Vec3f(1, 1, 1) : as_floats(item.colour));
        cloth.set("level_share", is_level ? 1.0F : 0.0F);
        cloth.set("all_lines", has_edges ? 1 : 0);
        cloth.set("ink", has_edges ? std::max(kEdgeInk * (item.ink > 0 ? item.ink : 1), kSeamInk) : kSeamInk);
        Vec2f scale(1, 1), offset(0, 0);
        if (drawn.is_woven()) {
            const float spacing = static_cast<float>(item.sett.thread_spacing) * item.sett_scale;
            scale = Vec2f(1 / (spacing * float(drawn.threads()[0])), 1 / (spacing * float(drawn.threads()[1])));
            offset = -item.sett_position.cwiseProduct(scale);
        } else if (drawn.is_painted()) {
            const auto colours = float(item.paint->map.size());
            scale = Vec2f((colours - 1) / colours, 1);
            offset = Vec2f(0.5F / colours, 0);
        }
        cloth.set("place_scale", scale);
        cloth.set("place_offset", offset);
        gl.BindTexture(GL_TEXTURE_2D, drawn.picture());
        gl.BindVertexArray(drawn.vertex_array());
        gl.DrawArrays(GL_TRIANGLES, 0, drawn.vertex_count());
    }

    void draw_surfaces(const SceneView& view, const Eigen::Matrix4f& camera) const {
        if (bodies.empty() && solids.empty()) return;
        surface.use();
        set_light(surface, view, camera);
        surface.set("body_share", 1.0F);
        surface.set("openness", kBodyAmbientVisibility);
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            surface.set("body_colour", to_linear(scene->bodies[i].colour));
            set_material(scene->bodies[i].material);
            draw_surface(bodies[i]);
        }
        surface.set("body_share", 0.0F);
        surface.set("openness", 1.0F);
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
};

PreviewRenderer::PreviewRenderer(GlContext& context) : impl_(std::make_unique<Impl>(context)) {}
PreviewRenderer::~PreviewRenderer() = default;

void PreviewRenderer::draw(const SceneView& view, PictureTexture& to) {
    Impl& impl = *impl_;
    impl.context.make_current();
    impl.prepare(view.scene);
    const Eigen::Matrix4f camera = upside_down_matrix(view, to);
    impl.begin(to);
    impl.attach_depth(to);  // first: GL draws only to the size of the smallest attachment
    impl.draw_backdrop(view.scene->background, to);
    impl.gl.FrontFace(GL_CW);  // because the picture is upside down
    impl.draw_ground(camera);
    impl.gl.Enable(GL_DEPTH_TEST);
    impl.draw_cloths(view, camera);  // before bodies: parts of a body that it hides are not shaded
    impl.draw_surfaces(view, camera);
    impl.gl.Disable(GL_DEPTH_TEST);
    impl.gl.FrontFace(GL_CCW);
}

}  // namespace selvedge::render

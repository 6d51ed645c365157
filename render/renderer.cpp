#include "render/renderer.h"

#include <algorithm>
#include <array>

#include "render/colour.h"
#include "render/depth_pass.h"
#include "render/gl/gl.h"
#include "render/image/png.h"
#include "render/scene_buffers.h"
#include "render/shaders.h"
#include "render/target.h"
#include "sim/core/assert.h"
#include "sim/core/error.h"

namespace selvedge {
namespace {

constexpr int kShadowSide = 2048;  // px

// Texture units.
constexpr int kShadowMapUnit = 0, kShadowDepthUnit = 1, kSettUnit = 2, kPaintUnit = 7;

constexpr std::array<Rgb8, kLevelColours> kLevels{{{0x3F, 0x6C, 0x9E},
                                                   {0x53, 0xB3, 0xA4},
                                                   {0xF1, 0xCB, 0x63},
                                                   {0xE7, 0x7B, 0x4E},
                                                   {0xB8, 0x47, 0x6E},
                                                   {0x74, 0x45, 0x8F},
                                                   {0x8C, 0x8C, 0x8C},
                                                   {0xE8, 0xE8, 0xE8}}};

void check_size(const RenderOptions& options) {
    const long pixels = static_cast<long>(options.width_px) * static_cast<long>(options.height_px);
    const int most = std::max(options.width_px, options.height_px);
    const int least = std::min(options.width_px, options.height_px);
    if (least >= 1 && most <= kMaxImageSide && pixels <= kMaxImagePixels) return;
    throw InputError("", "size",
                     "cannot draw " + std::to_string(options.width_px) + "x" + std::to_string(options.height_px) +
                         ": sides are from 1 to " + std::to_string(kMaxImageSide) + ", with at most " +
                         std::to_string(kMaxImagePixels / 1000000) + " million pixels");
}

void check_samples(const GlContext& context, const RenderOptions& options) {
    const int most = context.most_samples();
    if (options.samples <= most) return;
    throw InputError("", "samples",
                     std::string(name(context.maker())) + " takes at most " + std::to_string(most) +
                         " samples per pixel here, not " + std::to_string(options.samples));
}

// A part of the picture, px from its lower left.
struct Tile {
    int left = 0;
    int low = 0;
    TargetSize size;
};

// Clip space of the whole picture to that of the tile.
Eigen::Matrix4f tile_matrix(const Tile& tile, const RenderOptions& options) {
    const Vec2f scale(float(options.width_px) / float(tile.size.width_px),
                      float(options.height_px) / float(tile.size.height_px));
    const Vec2f centre((float(tile.left) + float(tile.size.width_px) / 2) / float(options.width_px) * 2 - 1,
                       (float(tile.low) + float(tile.size.height_px) / 2) / float(options.height_px) * 2 - 1);
    Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
    matrix(0, 0) = scale.x();
    matrix(1, 1) = scale.y();
    matrix(0, 3) = -centre.x() * scale.x();
    matrix(1, 3) = -centre.y() * scale.y();
    return matrix;
}

void copy_tile(Image& image, const Image& tile_image, const Tile& tile) {
    const int width = std::min(tile.size.width_px, image.width_px - tile.left);
    const int height = std::min(tile.size.height_px, image.height_px - tile.low);
    for (int y = 0; y < height; ++y) {
        const Rgba8* row = &tile_image.at(0, y);
        std::copy(row, row + width, &image.at(tile.left, image.height_px - 1 - (tile.low + y)));
    }
}

// One view of the scene, as the shaders ask for it.
struct Frame {
    const Scene& scene;
    const RenderOptions& options;
    Tile tile;
    Eigen::Matrix4f camera;         // room to the tile's clip space
    Eigen::Matrix4f shadow_matrix;  // room to 0..1
    float shadow_width = 1;         // m
};

Eigen::Matrix4f unit_cube_matrix() {
    Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity() * 0.5F;
    matrix.block<3, 1>(0, 3).setConstant(0.5F);
    matrix(3, 3) = 1;
    return matrix;
}

void set_backdrop(const Program& program, const Frame& frame) {
    const float supersample = float(frame.options.supersample);
    program.set("tile_origin_px", Vec2f(Vec2f(float(frame.tile.left), float(frame.tile.low)) * supersample));
    program.set("picture_size_px",
                Vec2f(Vec2f(float(frame.options.width_px), float(frame.options.height_px)) * supersample));
    program.set("backdrop_centre", to_linear(frame.scene.background.centre));
    program.set("backdrop_edge", to_linear(frame.scene.background.edge));
}

void set_light(const Program& program, const Frame& frame) {
    const Light& light = frame.scene.light;
    program.set("camera", frame.camera);
    program.set("eye", frame.scene.camera.eye);
    program.set("to_key", Vec3f(light.to_key.normalized()));
    program.set("to_fill", Vec3f(light.to_fill.normalized()));
    program.set("key_irradiance", light.key);
    program.set("fill_irradiance", light.fill);
    program.set("sky_irradiance", light.sky);
    program.set("bounce_irradiance", light.bounce);
    program.set("shadow_matrix", frame.shadow_matrix);
    program.set("shadow_width", frame.shadow_width);
    program.set("shadow_map", kShadowMapUnit);
    program.set("shadow_depth", kShadowDepthUnit);
}

}  // namespace

Rgb8 level_colour(int level) {
    return kLevels[static_cast<std::size_t>(std::clamp(level, 0, kLevelColours - 1))];
}

struct Renderer::Impl {
    explicit Impl(std::optional<ContextMaker> maker)
        : context(make_context(maker)),
          gl(context->gl()),
          cloth(make_program(gl, {"cloth.vert"}, {"light.glsl", "tartan.glsl", "cloth.frag"})),
          body(make_program(gl, {"body.vert"}, {"light.glsl", "body.frag"})),
          solid(make_program(gl, {"solid.vert"}, {"light.glsl", "solid.frag"})),
          ground(make_program(gl, {"body.vert"}, {"backdrop.glsl", "light.glsl", "ground.frag"})),
          backdrop(make_program(gl, {"screen.vert"}, {"backdrop.glsl", "backdrop.frag"})),
          no_vertices(gl),
          shadow_sampler(gl) {
        gl.SamplerParameteri(shadow_sampler.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        gl.SamplerParameteri(shadow_sampler.id(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        gl.SamplerParameteri(shadow_sampler.id(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        gl.SamplerParameteri(shadow_sampler.id(), GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    }

    void bind_shadow(const DepthPass& shadow) const {
        for (const int unit : {kShadowMapUnit, kShadowDepthUnit}) {
            gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
            gl.BindTexture(GL_TEXTURE_2D, shadow.texture());
        }
        gl.BindSampler(kShadowMapUnit, shadow_sampler.id());
    }

    void draw_backdrop(const Frame& frame) const {
        gl.Disable(GL_DEPTH_TEST);
        backdrop.use();
        set_backdrop(backdrop, frame);
        gl.BindVertexArray(no_vertices.id());
        gl.DrawArrays(GL_TRIANGLES, 0, 3);
    }

    // Drawn first and blended: nothing lies below it.
    void draw_ground(const Frame& frame, const SceneBuffers& buffers) const {
        gl.Enable(GL_DEPTH_TEST);
        gl.Enable(GL_BLEND);
        gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        ground.use();
        set_backdrop(ground, frame);
        set_light(ground, frame);
        ground.set("ground_centre", buffers.ground_centre);
        ground.set("ground_radius", buffers.ground_radius);
        ground.set("is_transparent", frame.scene.background.is_transparent ? 1 : 0);
        draw_surface(*buffers.ground);
        gl.Disable(GL_BLEND);
    }

    void draw_surface(const SurfaceBuffer& surface) const {
        gl.BindVertexArray(surface.vertex_array.id());
        gl.DrawElements(GL_TRIANGLES, surface.index_count, GL_UNSIGNED_INT, nullptr);
    }

    void draw_bodies(const Frame& frame, const SceneBuffers& buffers) const {
        gl.Enable(GL_DEPTH_TEST);
        body.use();
        set_light(body, frame);
        for (const SurfaceBuffer& surface : buffers.bodies) {
            body.set("body_colour", surface.colour);
            draw_surface(surface);
        }
    }

    void draw_cloths(const Frame& frame, const SceneBuffers& buffers) const {
        gl.Enable(GL_DEPTH_TEST);
        cloth.use();
        set_light(cloth, frame);
        cloth.set("sett_sums", kSettUnit);
        cloth.set("line_px", 0.55F * float(frame.options.supersample));
        for (int level = 0; level < kLevelColours; ++level) {
            cloth.set(("level_colours[" + std::to_string(level) + "]").c_str(), to_linear(level_colour(level)));
        }
        for (const ClothBuffer& buffer : buffers.cloths) draw_cloth(buffer);
    }

    void draw_cloth(const ClothBuffer& buffer) const {
        gl.ActiveTexture(GL_TEXTURE0 + kSettUnit);
        gl.BindTexture(GL_TEXTURE_2D, buffer.sett_sums.id());
        cloth.set("show", cloth_look(buffer.show, buffer.paint));
        bind_paint(gl, cloth, buffer.paint, kPaintUnit);
        cloth.set("cloth_colour", buffer.colour);
        cloth.set("sett_threads", std::max(buffer.sett_threads, 1));
        cloth.set("sett_mean", buffer.sett_mean);
        cloth.set("thread_spacing", buffer.thread_spacing);
        cloth.set("sett_position", buffer.sett_position);
        gl.BindVertexArray(buffer.vertex_array.id());
        gl.DrawArrays(GL_TRIANGLES, 0, buffer.vertex_count);
    }

    void draw_solids(const Frame& frame, const SceneBuffers& buffers) const {
        if (buffers.solids.empty()) return;
        solid.use();
        set_light(solid, frame);
        for (const SolidBuffer& buffer : buffers.solids) {
            gl.BindVertexArray(buffer.vertex_array.id());
            gl.DrawElements(GL_TRIANGLES, buffer.index_count, GL_UNSIGNED_INT, nullptr);
        }
    }

    void draw_tile(const Frame& frame, const SceneBuffers& buffers, const DepthPass& shadow) const {
        bind_shadow(shadow);
        if (!frame.scene.background.is_transparent) draw_backdrop(frame);
        if (buffers.ground) draw_ground(frame, buffers);
        draw_bodies(frame, buffers);
        draw_cloths(frame, buffers);
        draw_solids(frame, buffers);
        gl.BindSampler(kShadowMapUnit, 0);
    }

    std::unique_ptr<GlContext> context;
    const GladGLContext& gl;
    Program cloth, body, solid, ground, backdrop;
    VertexArray no_vertices;
    Sampler shadow_sampler;
};

Renderer::Renderer(std::optional<ContextMaker> maker) : impl_(std::make_unique<Impl>(maker)) {}
Renderer::~Renderer() = default;

const GlContext& Renderer::context() const {
    return *impl_->context;
}

Image Renderer::draw(const Scene& scene, const RenderOptions& options) {
    check_size(options);
    SELVEDGE_ASSERT(options.tile_px >= 1 && options.supersample >= 1 && options.samples >= 1);
    const GladGLContext& gl = impl_->gl;
    impl_->context->make_current();
    check_samples(*impl_->context, options);
    const Casters casters = casters_of(scene);
    const SceneBuffers buffers = make_scene_buffers(gl, scene, casters);

    const Bounds bounds = bounds_of(casters.x);
    const Eigen::Matrix4f key_matrix = parallel_matrix(bounds, scene.light.to_key.normalized());
    const DepthPass shadow(gl, casters, kShadowSide);
    shadow.draw(key_matrix);

    const Eigen::Matrix4f camera =
        projection_matrix(scene.camera, float(options.width_px) / float(options.height_px)) * view_matrix(scene.camera);
    const TargetSize size{.width_px = std::min(options.width_px, options.tile_px),
                          .height_px = std::min(options.height_px, options.tile_px),
                          .samples = options.samples,
                          .supersample = options.supersample};
    const Target target(gl, size);
    Image image(options.width_px, options.height_px);
    for (int low = 0; low < options.height_px; low += size.height_px) {
        for (int left = 0; left < options.width_px; left += size.width_px) {
            const Tile tile{.left = left, .low = low, .size = size};
            target.begin();
            impl_->draw_tile({.scene = scene,
                              .options = options,
                              .tile = tile,
                              .camera = tile_matrix(tile, options) * camera,
                              .shadow_matrix = unit_cube_matrix() * key_matrix,
                              .shadow_width = 2 * bounds.radius},
                             buffers, shadow);
            copy_tile(image, target.finish(Vec2f(float(left), float(low))), tile);
        }
    }
    return image;
}

}  // namespace selvedge

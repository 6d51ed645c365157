#include "render/draw/renderer.h"

#include <algorithm>
#include <array>

#include "render/draw/light_uniforms.h"
#include "render/draw/scene_buffers.h"
#include "render/draw/shadow.h"
#include "render/gl/context.h"
#include "render/gl/target.h"
#include "render/image/image.h"
#include "render/scene/colour.h"
#include "sim/core/assert.h"
#include "sim/core/error.h"

namespace selvedge::render {
namespace {

// m, more than the chords of cloth that lies on a body pass through its curved parts (0.5 mm)
constexpr float kBodyShrink = 0.001F;

// Texture units.
constexpr int kShadowMaskUnit = 0, kSettUnit = 1, kPaintUnit = 7, kPictureUnit = 8;

constexpr std::array<sim::Rgb8, kLevelColours> kLevels{{{0x3F, 0x6C, 0x9E},
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
    throw sim::InputError("", "size",
                          "cannot draw " + std::to_string(options.width_px) + "x" + std::to_string(options.height_px) +
                              ": sides are from 1 to " + std::to_string(kMaxImageSide) + ", with at most " +
                              std::to_string(kMaxImagePixels / 1000000) + " million pixels");
}

void check_samples(const GlContext& context, const RenderOptions& options) {
    const int most = context.max_samples();
    if (options.samples <= most) return;
    throw sim::InputError("", "samples",
                          std::string(name(context.maker())) + " takes at most " + std::to_string(most) +
                              " samples per pixel here, not " + std::to_string(options.samples));
}

// A part of the picture, px from its lower left corner.
struct Tile {
    int left = 0;
    int low = 0;
    TargetSize size;
};

// From clip space of the whole picture to clip space of the tile.
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

// With what the prepared scene is drawn.
struct ViewSettings {
    const Camera& camera;
    const Light& light;
    const Background& background;
};

// The values that the shaders need for one tile.
struct Frame {
    const ViewSettings& look;
    const RenderOptions& options;
    Tile tile;
    Eigen::Matrix4f camera;         // world space to the tile's clip space
    Eigen::Matrix4f shadow_matrix;  // world space to 0..1
    float shadow_width = 1;         // m, covered by the shadow map
};

Eigen::Matrix4f unit_cube_matrix() {
    Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity() * 0.5F;
    matrix.block<3, 1>(0, 3).setConstant(0.5F);
    matrix(3, 3) = 1;
    return matrix;
}

void set_backdrop(const Program& program, const Frame& frame) {
    program.set("is_transparent", frame.look.background.is_transparent ? 1 : 0);
    program.set("tile_origin_px", Vec2f(float(frame.tile.left), float(frame.tile.low)));
    program.set("picture_size_px", Vec2f(float(frame.options.width_px), float(frame.options.height_px)));
    program.set("backdrop_centre", to_linear(frame.look.background.centre));
    program.set("backdrop_edge", to_linear(frame.look.background.edge));
}

void set_light(const Program& program, const Frame& frame) {
    set_light(program, frame.look.light, frame.look.camera.eye);
    program.set("camera", frame.camera);
    program.set("shadow_matrix", frame.shadow_matrix);
    program.set("shadow_width", frame.shadow_width);
    program.set("shadow_map_side", float(kShadowMapSide));
    program.set("shadow_mask", kShadowMaskUnit);
}

void set_material(const Program& program, const Material& material) {
    program.set("gloss", material.gloss);
    program.set("roughness", material.roughness);
    program.set("sheen", material.sheen);
}

}  // namespace

sim::Rgb8 level_colour(int level) {
    return kLevels[static_cast<std::size_t>(std::clamp(level, 0, kLevelColours - 1))];
}

struct Renderer::Impl {
    explicit Impl(std::unique_ptr<GlContext> own) : Impl(*own) { owned = std::move(own); }

    explicit Impl(GlContext& shared)
        : context(shared),
          gl(shared.gl()),
          cloth_place(make_program(gl, {"cloth.vert"}, {"shadow.glsl", "place.frag"})),
          body_place(make_program(gl, {"body.vert"}, {"shadow.glsl", "place.frag"})),
          cloth(make_program(gl, {"cloth.vert"},
                             {"shadow.glsl", "light.glsl", "key_shadow.glsl", "tartan.glsl", "cloth.frag"})),
          body(make_program(gl, {"body.vert"}, {"shadow.glsl", "light.glsl", "key_shadow.glsl", "body.frag"})),
          solid(make_program(gl, {"solid.vert"}, {"shadow.glsl", "light.glsl", "key_shadow.glsl", "solid.frag"})),
          ground(make_program(gl, {"body.vert"},
                              {"backdrop.glsl", "shadow.glsl", "light.glsl", "key_shadow.glsl", "ground.frag"})),
          prepared(gl) {}

    void begin(const RenderOptions& options) const {
        check_size(options);
        SELVEDGE_ASSERT(options.tile_px >= 1 && options.supersample >= 1 && options.samples >= 1);
        context.make_current();
        check_samples(context, options);
    }

    // Copies the finished tile into the texture, upside down, because the texture's row 0 is the picture's top row.
    void lay_tile(const PictureTexture& to, const Tile& tile) const {
        const int width = std::min(tile.size.width_px, to.width_px() - tile.left);
        const int height = std::min(tile.size.height_px, to.height_px() - tile.low);
        const int top = to.height_px() - tile.low;
        gl.BindFramebuffer(GL_READ_FRAMEBUFFER, target->finished_framebuffer());
        gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, to.framebuffer());
        gl.BlitFramebuffer(0, 0, width, height, tile.left, top, tile.left + width, top - height, GL_COLOR_BUFFER_BIT,
                           GL_NEAREST);
    }

    // Keeps the targets of the previous picture if the size is the same.
    void make_targets(const TargetSize& size) {
        if (target && target->size() == size) return;
        target.reset();  // frees its memory before the next one is allocated
        mask.reset();
        target.emplace(gl, size);
        mask.emplace(gl, size.width_px * size.supersample, size.height_px * size.supersample);
    }

    // For every visible position: how much of the key light reaches it.
    void draw_mask(const Frame& frame) const {
        const SceneBuffers& buffers = prepared.buffers();
        mask->begin();
        body_place.use();
        set_light(body_place, frame);
        if (buffers.ground) draw_surface(*buffers.ground);
        body_place.set("shrink", kBodyShrink);
        for (const SurfaceBuffer& surface : buffers.bodies) draw_surface(surface);
        body_place.set("shrink", 0.0F);
        for (const SolidBuffer& buffer : buffers.solids) draw_solid(buffer);
        cloth_place.use();
        set_light(cloth_place, frame);
        cloth_place.set("is_two_sided", 1);
        for (const ClothBuffer& buffer : buffers.cloths) draw_triangles(buffer);
        mask->finish(prepared.shadow(), prepared.shadow_width());
    }

    // Drawn first: only the backdrop lies behind it, and Target::finish() blends the picture over that.
    void draw_ground(const Frame& frame, const SceneBuffers& buffers) const {
        ground.use();
        set_backdrop(ground, frame);
        set_light(ground, frame);
        ground.set("ground_centre", buffers.ground_centre);
        ground.set("ground_radius", buffers.ground_radius);
        ground.set("supersample", frame.options.supersample);
        draw_surface(*buffers.ground);
    }

    void draw_surface(const SurfaceBuffer& surface) const {
        if (surface.is_closed) gl.Enable(GL_CULL_FACE);
        gl.BindVertexArray(surface.vertex_array.id());
        gl.DrawElements(GL_TRIANGLES, surface.index_count, GL_UNSIGNED_INT, nullptr);
        gl.Disable(GL_CULL_FACE);
    }

    void draw_bodies(const Frame& frame, const SceneBuffers& buffers) const {
        body.use();
        set_light(body, frame);
        body.set("shrink", kBodyShrink);
        for (const SurfaceBuffer& surface : buffers.bodies) {
            body.set("body_colour", surface.colour);
            set_material(body, surface.material);
            draw_surface(surface);
        }
    }

    void draw_cloths(const Frame& frame, const SceneBuffers& buffers) const {
        cloth.use();
        set_light(cloth, frame);
        cloth.set("sett_sums", kSettUnit);
        cloth.set("cloth_picture", kPictureUnit);
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
        gl.ActiveTexture(GL_TEXTURE0 + kPictureUnit);
        gl.BindTexture(GL_TEXTURE_2D, buffer.picture.id());
        cloth.set("has_picture", buffer.picture.id() != 0 ? 1 : 0);
        cloth.set("picture_u", buffer.picture_rows[0]);
        cloth.set("picture_v", buffer.picture_rows[1]);
        cloth.set("picture_ground", buffer.picture_ground);
        cloth.set("cloth_colour", buffer.colour);
        cloth.set("warp_threads", std::max(buffer.warp.threads(), 1));
        cloth.set("weft_threads", std::max(buffer.weft.threads(), 1));
        cloth.set("warp_mean", buffer.warp.mean);
        cloth.set("weft_mean", buffer.weft.mean);
        cloth.set("weave", static_cast<int>(buffer.weave));
        cloth.set("thread_spacing", buffer.thread_spacing);
        cloth.set("sett_position", buffer.sett_position);
        set_material(cloth, buffer.material);
        draw_triangles(buffer);
    }

    void draw_triangles(const ClothBuffer& buffer) const {
        gl.BindVertexArray(buffer.vertex_array.id());
        gl.DrawArrays(GL_TRIANGLES, 0, buffer.vertex_count);
    }

    void draw_solids(const Frame& frame, const SceneBuffers& buffers) const {
        if (buffers.solids.empty()) return;
        solid.use();
        set_light(solid, frame);
        for (const SolidBuffer& buffer : buffers.solids) draw_solid(buffer);
    }

    void draw_solid(const SolidBuffer& buffer) const {
        gl.BindVertexArray(buffer.vertex_array.id());
        gl.DrawElements(GL_TRIANGLES, buffer.index_count, GL_UNSIGNED_INT, nullptr);
    }

    void draw_tile(const Frame& frame) const {
        const SceneBuffers& buffers = prepared.buffers();
        target->begin();
        gl.ActiveTexture(GL_TEXTURE0 + kShadowMaskUnit);
        gl.BindTexture(GL_TEXTURE_2D, mask->texture());
        gl.Enable(GL_DEPTH_TEST);
        if (buffers.ground) draw_ground(frame, buffers);
        draw_bodies(frame, buffers);
        draw_cloths(frame, buffers);
        draw_solids(frame, buffers);
    }

    // Draws the prepared scene. Calls `take` for each finished tile.
    template <class Take>
    void draw_tiles(const ViewSettings& look, const RenderOptions& options, PartClock& clock, const Take& take) {
        const Eigen::Matrix4f world_to_clip =
            projection_matrix(look.camera, float(options.width_px) / float(options.height_px)) *
            view_matrix(look.camera);
        const TargetSize size{.width_px = std::min(options.width_px, options.tile_px),
                              .height_px = std::min(options.height_px, options.tile_px),
                              .samples = options.samples,
                              .supersample = options.supersample};
        make_targets(size);
        for (int low = 0; low < options.height_px; low += size.height_px) {
            for (int left = 0; left < options.width_px; left += size.width_px) {
                const Tile tile{.left = left, .low = low, .size = size};
                const Frame frame{.look = look,
                                  .options = options,
                                  .tile = tile,
                                  .camera = tile_matrix(tile, options) * world_to_clip,
                                  .shadow_matrix = unit_cube_matrix() * prepared.key_matrix(),
                                  .shadow_width = prepared.shadow_width()};
                draw_mask(frame);
                clock.lap(&PictureTimes::mask);
                draw_tile(frame);
                clock.lap(&PictureTimes::draw);
                target->finish([&](const Program& program) { set_backdrop(program, frame); });
                clock.lap(&PictureTimes::finish);
                take(tile);
                clock.lap(&PictureTimes::read_back);
            }
        }
    }

    std::unique_ptr<GlContext> owned;  // declared first, so that it is destroyed last
    GlContext& context;
    const GladGLContext& gl;
    Program cloth_place, body_place;
    Program cloth, body, solid, ground;
    PreparedScene prepared;
    std::optional<Target> target;
    std::optional<ShadowMask> mask;
};

Renderer::Renderer(std::optional<ContextKind> maker) : impl_(std::make_unique<Impl>(make_context(maker))) {}
Renderer::Renderer(GlContext& shared) : impl_(std::make_unique<Impl>(shared)) {}

Renderer::~Renderer() {
    impl_->context.make_current();  // what it deletes is of this context
}

const GlContext& Renderer::context() const {
    return impl_->context;
}

Image Renderer::draw(const Scene& scene, const RenderOptions& options) {
    impl_->begin(options);
    PartClock clock(impl_->gl, options.times);
    impl_->prepared.prepare(scene, clock);
    Image image(options.width_px, options.height_px);
    const ViewSettings look{.camera = scene.camera, .light = scene.light, .background = scene.background};
    impl_->draw_tiles(look, options, clock, [&](const Tile& tile) { copy_tile(image, impl_->target->read(), tile); });
    return image;
}

void Renderer::draw(const SceneView& view, PictureTexture& to, const RenderOptions& requested) {
    RenderOptions options = requested;
    options.width_px = to.width_px();
    options.height_px = to.height_px();
    impl_->begin(options);
    PartClock clock(impl_->gl, options.times);
    impl_->prepared.prepare(view, clock);
    const ViewSettings look{.camera = view.camera, .light = view.light, .background = view.scene->background};
    impl_->draw_tiles(look, options, clock, [&](const Tile& tile) { impl_->lay_tile(to, tile); });
}

PartClock::PartClock(const GladGLContext& gl, PictureTimes* times)
    : gl_(gl), times_(times), last_(std::chrono::steady_clock::now()) {
    if (times_ != nullptr) *times_ = {};
}

void PartClock::lap(double PictureTimes::*part) {
    if (times_ == nullptr) return;
    gl_.Finish();
    const auto now = std::chrono::steady_clock::now();
    times_->*part += std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
}

}  // namespace selvedge::render

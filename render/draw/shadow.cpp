#include "render/draw/shadow.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/gl/context.h"
#include "render/gl/target.h"

namespace selvedge::render {
namespace {

constexpr int kTileSide = 128;  // px
constexpr int kTexelsOfTile = kShadowMapSide / kTileSide;

void set_nearest_filter(const GladGLContext& gl) {
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void make_depth(const GladGLContext& gl, const Texture& texture, const Framebuffer& framebuffer) {
    gl.BindTexture(GL_TEXTURE_2D, texture.id());
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, kShadowMapSide, kShadowMapSide, 0, GL_DEPTH_COMPONENT,
                  GL_FLOAT, nullptr);
    set_nearest_filter(gl);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture.id(), 0);
    gl.DrawBuffer(GL_NONE);
    gl.ReadBuffer(GL_NONE);
    require_framebuffer(gl);
}

void make_tiles(const GladGLContext& gl, const Texture& texture, const Framebuffer& framebuffer) {
    gl.BindTexture(GL_TEXTURE_2D, texture.id());
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R32F, kTileSide, kTileSide, 0, GL_RED, GL_FLOAT, nullptr);
    set_nearest_filter(gl);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(), 0);
    require_framebuffer(gl);
}

}  // namespace

ShadowMap::ShadowMap(const GladGLContext& gl)
    : gl_(gl),
      depth_program_(make_program(gl, {"depth.vert"}, {"depth.frag"})),
      tile_program_(make_program(gl, {"screen.vert"}, {"depth_tile.frag"})),
      spread_program_(make_program(gl, {"screen.vert"}, {"depth_spread.frag"})),
      vertex_array_(gl),
      no_vertices_(gl),
      positions_(gl),
      indices_(gl),
      depth_(gl),
      nearest_(gl),
      rows_(gl),
      depth_frame_(gl),
      nearest_frame_(gl),
      rows_frame_(gl) {
    make_depth(gl, depth_, depth_frame_);
    make_tiles(gl, nearest_, nearest_frame_);
    make_tiles(gl, rows_, rows_frame_);
}

void ShadowMap::load(const Casters& casters) {
    index_count_ = static_cast<int>(casters.triangles.size() * 3);
    gl_.BindVertexArray(vertex_array_.id());
    upload(gl_, GL_ARRAY_BUFFER, positions_, casters.x, GL_STATIC_DRAW);
    add_floats(gl_, 0, 3, sizeof(Vec3f), 0);
    upload(gl_, GL_ELEMENT_ARRAY_BUFFER, indices_, casters.triangles, GL_STATIC_DRAW);
}

void ShadowMap::draw(const Eigen::Matrix4f& matrix, float reach) const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, depth_frame_.id());
    gl_.Viewport(0, 0, kShadowMapSide, kShadowMapSide);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.Disable(GL_BLEND);
    gl_.Clear(GL_DEPTH_BUFFER_BIT);
    depth_program_.use();
    depth_program_.set("camera", matrix);
    gl_.BindVertexArray(vertex_array_.id());
    gl_.DrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);

    gl_.Disable(GL_DEPTH_TEST);
    gl_.ActiveTexture(GL_TEXTURE0);
    draw_nearest(tile_program_, {nearest_frame_.id(), kTileSide}, depth_.id(), kTexelsOfTile);
    const int spread = std::min(static_cast<int>(std::ceil(reach * kTileSide)) + 1, kTileSide);
    // Minimum over a square: along rows into rows_, then along columns back into nearest_, which is not read any more.
    spread_program_.use();
    spread_program_.set("along_columns", 0);
    draw_nearest(spread_program_, {rows_frame_.id(), kTileSide}, nearest_.id(), spread);
    spread_program_.set("along_columns", 1);
    draw_nearest(spread_program_, {nearest_frame_.id(), kTileSide}, rows_.id(), spread);
}

void ShadowMap::draw_nearest(const Program& program, const View& to, unsigned from, int cells) const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, to.framebuffer);
    gl_.Viewport(0, 0, to.side_px, to.side_px);
    program.use();
    program.set("depths", 0);
    program.set("cells", cells);
    gl_.BindTexture(GL_TEXTURE_2D, from);
    gl_.BindVertexArray(no_vertices_.id());
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

namespace {

enum Unit { Places, Map, Depth, Nearest };

void make_colour(const GladGLContext& gl, const Texture& texture, const Framebuffer& framebuffer, GLint format,
                 std::array<int, 2> size_px) {
    gl.BindTexture(GL_TEXTURE_2D, texture.id());
    gl.TexImage2D(GL_TEXTURE_2D, 0, format, size_px[0], size_px[1], 0, GL_RGBA, GL_FLOAT, nullptr);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(), 0);
}

}  // namespace

ShadowMask::ShadowMask(const GladGLContext& gl, int width_px, int height_px)
    : gl_(gl),
      width_px_(width_px),
      height_px_(height_px),
      program_(make_program(gl, {"screen.vert"}, {"shadow_mask.frag"})),
      no_vertices_(gl),
      compare_sampler_(gl),
      places_(gl),
      mask_(gl),
      depth_(gl),
      places_frame_(gl),
      mask_frame_(gl) {
    gl.SamplerParameteri(compare_sampler_.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.SamplerParameteri(compare_sampler_.id(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.SamplerParameteri(compare_sampler_.id(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    gl.SamplerParameteri(compare_sampler_.id(), GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    make_colour(gl, mask_, mask_frame_, GL_RG32F, {width_px, height_px});
    require_framebuffer(gl);
    make_colour(gl, places_, places_frame_, GL_RGBA32F, {width_px, height_px});
    gl.BindRenderbuffer(GL_RENDERBUFFER, depth_.id());
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, width_px, height_px);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
    require_framebuffer(gl);
}

void ShadowMask::begin() const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, places_frame_.id());
    gl_.Viewport(0, 0, width_px_, height_px_);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.Disable(GL_BLEND);
    gl_.ClearColor(0, 0, -1, -1);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void ShadowMask::finish(const ShadowMap& map, float shadow_width) const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, mask_frame_.id());
    gl_.Disable(GL_DEPTH_TEST);
    program_.use();
    program_.set("places", Places);
    program_.set("shadow_map", Map);
    program_.set("shadow_depth", Depth);
    program_.set("shadow_nearest", Nearest);
    program_.set("shadow_reach", kShadowReach);
    program_.set("shadow_width", shadow_width);
    const std::array<unsigned, 4> textures{places_.id(), map.depth(), map.depth(), map.nearest()};
    for (unsigned unit = 0; unit < textures.size(); ++unit) {
        gl_.ActiveTexture(GL_TEXTURE0 + unit);
        gl_.BindTexture(GL_TEXTURE_2D, textures[unit]);
    }
    gl_.BindSampler(Map, compare_sampler_.id());
    gl_.BindVertexArray(no_vertices_.id());
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    gl_.BindSampler(Map, 0);
}

}  // namespace selvedge::render

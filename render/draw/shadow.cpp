#include "render/draw/shadow.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/gl/context.h"
#include "render/gl/target.h"
#include "sim/core/assert.h"

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
    SELVEDGE_ASSERT(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
}

void make_tiles(const GladGLContext& gl, const Texture& texture, const Framebuffer& framebuffer) {
    gl.BindTexture(GL_TEXTURE_2D, texture.id());
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R32F, kTileSide, kTileSide, 0, GL_RED, GL_FLOAT, nullptr);
    set_nearest_filter(gl);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(), 0);
    SELVEDGE_ASSERT(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
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
    SELVEDGE_ASSERT(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
    make_colour(gl, places_, places_frame_, GL_RGBA32F, {width_px, height_px});
    gl.BindRenderbuffer(GL_RENDERBUFFER, depth_.id());
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, width_px, height_px);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.id());
    SELVEDGE_ASSERT(gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
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

namespace {

// -1..1 to texels, whose centres are integers, and depth 0..1.
Eigen::Matrix4f texel_matrix(int side_px) {
    const float half = static_cast<float>(side_px) / 2;
    Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
    matrix.diagonal() << half, half, 0.5F, 1;
    matrix.block<3, 1>(0, 3) << half - 0.5F, half - 0.5F, 0.5F;
    return matrix;
}

// Edge function of the line between two points: at() >= 0 inside a triangle whose orientation is `sign`.
struct Edge {
    float dx = 0, dy = 0, constant = 0;

    Edge(const Vec3f& from, const Vec3f& to, float sign)
        : dx(sign * (from.y() - to.y())), dy(sign * (to.x() - from.x())), constant(-(dx * from.x() + dy * from.y())) {}
    float at(float x, float y) const { return dx * x + dy * y + constant; }
};

void widen(DepthRange::Span& span, float depth) {
    span.nearest = std::min(span.nearest, depth);
    span.farthest = std::max(span.farthest, depth);
}

void draw_triangle(DepthRange& picture, const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    const float last = static_cast<float>(picture.side_px - 1);
    const int left = static_cast<int>(std::ceil(std::max(std::min({a.x(), b.x(), c.x()}), 0.0F)));
    const int right = static_cast<int>(std::floor(std::min(std::max({a.x(), b.x(), c.x()}), last)));
    const int low = static_cast<int>(std::ceil(std::max(std::min({a.y(), b.y(), c.y()}), 0.0F)));
    const int high = static_cast<int>(std::floor(std::min(std::max({a.y(), b.y(), c.y()}), last)));
    if (left > right || low > high) return;
    const float area = (b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y());
    if (std::abs(area) < 1e-9F) return;
    const float sign = area > 0 ? 1.0F : -1.0F;
    const Edge to_a(b, c, sign), to_b(c, a, sign), to_c(a, b, sign);
    const float inverse = sign / area;
    for (int y = low; y <= high; ++y) {
        DepthRange::Span* row = &picture.spans[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.side_px)];
        for (int x = left; x <= right; ++x) {
            const float s = to_a.at(float(x), float(y)), t = to_b.at(float(x), float(y)),
                        r = to_c.at(float(x), float(y));
            if (s < 0 || t < 0 || r < 0) continue;
            widen(row[x], (s * a.z() + t * b.z() + r * c.z()) * inverse);
        }
    }
}

}  // namespace

DepthRange empty_depth_range(const Bounds& bounds, const Vec3f& direction, int side_px) {
    DepthRange picture;
    picture.matrix = texel_matrix(side_px) * parallel_matrix(bounds, direction);
    picture.side_px = side_px;
    picture.spans.resize(static_cast<std::size_t>(side_px) * static_cast<std::size_t>(side_px));
    return picture;
}

void draw_casters(DepthRange& picture, const Casters& casters) {
    const Eigen::Matrix3f turn = picture.matrix.block<3, 3>(0, 0);
    const Vec3f shift = picture.matrix.block<3, 1>(0, 3);
    std::vector<Vec3f> seen;
    seen.reserve(casters.x.size());
    for (const Vec3f& point : casters.x) seen.emplace_back(turn * point + shift);
    for (const auto& [a, b, c] : casters.triangles) draw_triangle(picture, seen[a], seen[b], seen[c]);
}

namespace {

void add(Casters& casters, const std::vector<Vec3f>& x, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    const auto base = static_cast<std::uint32_t>(casters.x.size());
    casters.x.insert(casters.x.end(), x.begin(), x.end());
    for (const auto& [a, b, c] : triangles) casters.triangles.push_back({a + base, b + base, c + base});
}

}  // namespace

Casters cloth_casters_of(const Scene& scene) {
    Casters casters;
    for (const ClothItem& cloth : scene.cloths) add(casters, cloth.mesh.x, cloth.mesh.triangles);
    return casters;
}

Casters body_casters_of(const Scene& scene) {
    Casters casters;
    for (const BodyItem& body : scene.bodies) add(casters, body.x, body.triangles);
    return casters;
}

Casters casters_of(const Scene& scene) {
    Casters casters = cloth_casters_of(scene);
    const Casters bodies = body_casters_of(scene);
    add(casters, bodies.x, bodies.triangles);
    return casters;
}

Bounds bounds_of(const std::vector<Vec3f>& points) {
    SELVEDGE_ASSERT(!points.empty());
    Bounds bounds{.centre = sim::box_around(points).center(), .radius = 0};
    for (const Vec3f& point : points) bounds.radius = std::max(bounds.radius, (point - bounds.centre).norm());
    bounds.radius = std::max(bounds.radius * 1.02F, 0.01F);
    return bounds;
}

Bounds steady_bounds_of(const std::vector<Vec3f>& points) {
    const Bounds tight = bounds_of(points);
    const float step = std::exp2(std::floor(std::log2(tight.radius)) - 4);  // m: a sixteenth of the radius, or less
    return {.centre = step * (tight.centre / step).array().round().matrix(),
            .radius = step * std::ceil(tight.radius / step + 1)};  // rounding moves the centre by less than a step
}

Eigen::Matrix4f parallel_matrix(const Bounds& bounds, const Vec3f& direction) {
    const Vec3f helper = std::abs(direction.y()) < 0.9F ? Vec3f(Vec3f::UnitY()) : Vec3f(Vec3f::UnitX());
    const Vec3f right = helper.cross(direction).normalized();
    const Vec3f up = direction.cross(right);
    Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
    matrix.block<1, 3>(0, 0) = right.transpose() / bounds.radius;
    matrix.block<1, 3>(1, 0) = up.transpose() / bounds.radius;
    matrix.block<1, 3>(2, 0) = -direction.transpose() / bounds.radius;
    matrix.block<3, 1>(0, 3) = -matrix.block<3, 3>(0, 0) * bounds.centre;
    return matrix;
}

}  // namespace selvedge::render

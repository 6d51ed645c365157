#include "render/preview/preview_buffers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "render/draw/cloth_vertices.h"
#include "render/draw/scene_buffers.h"
#include "render/gl/context.h"
#include "render/scene/colour.h"
#include "sim/core/assert.h"

namespace selvedge::render {
namespace {

// Compares bytes, which is faster than comparing numbers. A false difference only costs an upload.
template <class T>
bool is_same(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

// Allocates new storage instead of overwriting, because GL may still draw the previous picture from the old one.
template <class T>
void upload(const GladGLContext& gl, GLenum target, const Buffer& buffer, const std::vector<T>& data) {
    gl.BindBuffer(target, buffer.id());
    gl.BufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), GL_STREAM_DRAW);
}

void add_floats(const GladGLContext& gl, GLuint index, int floats, std::size_t stride, std::size_t offset) {
    gl.EnableVertexAttribArray(index);
    gl.VertexAttribPointer(index, floats, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                           reinterpret_cast<const void*>(offset));
}

// Same triangles, material coordinates and panels.
bool has_same_topology(const sim::PlainMesh& a, const sim::PlainMesh& b) {
    return is_same(a.triangles, b.triangles) && is_same(a.u, b.u) && is_same(a.panel, b.panel);
}

bool is_same_fixed(const ClothItem& a, const ClothItem& b) {
    return is_same(a.mesh.level, b.mesh.level) && a.mesh.panel_grain_angles == b.mesh.panel_grain_angles &&
           a.mesh.panel_sett_offsets == b.mesh.panel_sett_offsets && a.show == b.show &&
           a.paint.has_value() == b.paint.has_value() && (!a.paint || is_same(a.paint->places, b.paint->places));
}

bool is_same_picture(const ClothItem& a, const ClothItem& b) {
    return a.show == b.show && a.sett == b.sett && a.paint.has_value() == b.paint.has_value() &&
           a.mesh.u.empty() == b.mesh.u.empty() && (!a.paint || a.paint->map == b.paint->map);
}

// For one panel: from material coordinates to the fabric's (weft, warp).
struct PanelTurn {
    float c = 1, s = 0;
    Vec2f offset{0, 0};

    std::array<float, 2> place_of(const Vec2f& u) const {
        return {c * u.x() + s * u.y() + offset.x(), -s * u.x() + c * u.y() + offset.y()};
    }
};

std::vector<PanelTurn> panel_turns(const sim::PlainMesh& mesh) {
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
    is_woven_ = item.show == ShowMode::Tartan && !item.sett.stripes.empty() && !item.mesh.u.empty();
    is_painted_ = item.show > ShowMode::Plain && item.paint.has_value();
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
    const sim::PlainMesh& mesh = item.mesh;
    const std::vector<PanelTurn> turns = panel_turns(mesh);
    SELVEDGE_ASSERT(!is_painted_ || item.paint->places.size() == mesh.triangles.size());
    fixed_vertices_.clear();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::size_t panel = mesh.panel.empty() ? 0 : mesh.panel[t];
        const PanelTurn& turn = turns[panel < turns.size() ? panel : 0];
        const std::uint32_t level = mesh.level.empty() ? 0U : mesh.level[t];
        const std::uint32_t marks = level | marks_[t].seam << 8 | marks_[t].hem << 11;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            std::array<float, 2> place{0, 0};
            if (is_painted_) place = {item.paint->places[t][corner], 0.5F};
            if (is_woven_) place = turn.place_of(mesh.u[t][corner]);
            fixed_vertices_.push_back({place, marks});
        }
    }
    upload(gl_, GL_ARRAY_BUFFER, fixed_, fixed_vertices_);
}

void PreviewCloth::fill_moving(const ClothItem& item) {
    const sim::PlainMesh& mesh = item.mesh;
    const bool has_normals = mesh.normals.size() == mesh.x.size();
    const std::vector<Vec3f> own = has_normals ? std::vector<Vec3f>{} : sim::vertex_normals(mesh.x, mesh.triangles);
    const std::vector<Vec3f>& normals = has_normals ? mesh.normals : own;
    corners_.clear();
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t v : triangle) corners_.push_back({mesh.x[v], normals[v]});
    }
    upload(gl_, GL_ARRAY_BUFFER, moving_, corners_);
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
    upload(gl_, GL_ARRAY_BUFFER, positions_, x);
    upload(gl_, GL_ARRAY_BUFFER, normals_, normals);
}

void PreviewSurface::fill_triangles(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    gl_.BindVertexArray(vertex_array_.id());
    upload(gl_, GL_ELEMENT_ARRAY_BUFFER, indices_, triangles);
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
    upload(gl_, GL_ARRAY_BUFFER, colours_, item.colours);
    gl_.EnableVertexAttribArray(2);
    gl_.VertexAttribPointer(2, 3, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(sim::Rgb8), nullptr);
}

namespace {

constexpr unsigned kMostTexels = 512;  // per side

int texels_for(const SettSums& sums) {
    return static_cast<int>(std::bit_ceil(std::min(static_cast<unsigned>(sums.threads()), kMostTexels)));
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

#include "app/ui_draw.h"

#include <imgui.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>

#include "render/gl/context.h"
#include "render/gl/target.h"
#include "sim/core/assert.h"

namespace selvedge::app {
namespace {

constexpr editor::UiTexture kFont = 0;

template <class T>
std::span<const std::byte> bytes_of(const ImVector<T>& data) {
    return std::as_bytes(std::span<const T>(data.Data, static_cast<std::size_t>(data.Size)));
}

render::Texture make_texture(const GladGLContext& gl, int width_px, int height_px, const void* rgba, GLint wrap) {
    render::Texture texture(gl);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, texture.id());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_px, height_px, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
    return texture;
}

bool is_upright(const UiTarget& to) {
    return to.framebuffer == 0;
}

// px of the framebuffer; `low` counts from GL's first row.
struct PixelBox {
    int left = 0, low = 0, width = 0, height = 0;
    bool is_empty() const { return width <= 0 || height <= 0; }
};

PixelBox clip_box(const ImVec4& clip, const ImDrawData& data, const UiTarget& to) {
    const auto pixel = [](float at, float from, float scale, int most) {
        return static_cast<int>(std::clamp((at - from) * scale, 0.0F, float(most)));
    };
    const ImVec2 low = data.DisplayPos, scale = data.FramebufferScale;
    const int left = pixel(clip.x, low.x, scale.x, to.width_px), right = pixel(clip.z, low.x, scale.x, to.width_px);
    const int top = pixel(clip.y, low.y, scale.y, to.height_px);
    const int bottom = pixel(clip.w, low.y, scale.y, to.height_px);
    return {.left = left,
            .low = is_upright(to) ? to.height_px - bottom : top,
            .width = right - left,
            .height = bottom - top};
}

}  // namespace

struct UiDraw::Impl {
    explicit Impl(render::GlContext& made_elsewhere)
        : context(made_elsewhere),
          gl(made_elsewhere.gl()),
          textured(render::make_program(gl, {"ui.vert"}, {"ui.frag"})),
          plain(render::make_program(gl, {"ui.vert"}, {"ui_plain.frag"})),
          vertex_array(gl),
          vertices(gl),
          indices(gl),
          nearest(gl) {
        gl.SamplerParameteri(nearest.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl.SamplerParameteri(nearest.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        gl.BindVertexArray(vertex_array.id());
        gl.BindBuffer(GL_ARRAY_BUFFER, vertices.id());
        gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.id());
        render::add_floats(gl, 0, 2, sizeof(ImDrawVert), offsetof(ImDrawVert, pos));
        render::add_floats(gl, 1, 2, sizeof(ImDrawVert), offsetof(ImDrawVert, uv));
        render::add_bytes(gl, 2, 4, sizeof(ImDrawVert), offsetof(ImDrawVert, col));
    }

    void take_font(ImFontAtlas& atlas) {
        if (atlas.TexPixelsAlpha8 == nullptr && atlas.TexPixelsRGBA32 == nullptr) return;
        unsigned char* pixels = nullptr;
        int width_px = 0, height_px = 0;
        atlas.GetTexDataAsRGBA32(&pixels, &width_px, &height_px);
        owned.insert_or_assign(kFont, make_texture(gl, width_px, height_px, pixels, GL_CLAMP_TO_EDGE));
        atlas.ClearTexData();
    }

    unsigned texture_of(editor::UiTexture number) const {
        const auto lent_one = lent.find(number);
        if (lent_one != lent.end()) return lent_one->second->texture();
        const auto own = owned.find(number);
        return own == owned.end() ? 0 : own->second.id();
    }

    void begin(const ImDrawData& data, const UiTarget& to) const {
        gl.BindFramebuffer(GL_FRAMEBUFFER, to.framebuffer);
        gl.Viewport(0, 0, to.width_px, to.height_px);
        gl.Disable(GL_DEPTH_TEST);
        gl.Disable(GL_CULL_FACE);
        gl.Disable(GL_MULTISAMPLE);
        gl.Disable(GL_SCISSOR_TEST);
        gl.ClearColor(0, 0, 0, 1);
        gl.Clear(GL_COLOR_BUFFER_BIT);
        gl.Enable(GL_SCISSOR_TEST);
        gl.Enable(GL_BLEND);
        gl.BlendEquation(GL_FUNC_ADD);
        gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);  // alpha stays 1
        for (const render::Program* program : {&plain, &textured}) {
            program->use();
            program->set("display_low", Vec2f(data.DisplayPos.x, data.DisplayPos.y));
            program->set("upwards", is_upright(to) ? 1.0F : -1.0F);
            program->set("display_size", Vec2f(data.DisplaySize.x, data.DisplaySize.y));
        }
        textured.set("picture", 0);
        gl.ActiveTexture(GL_TEXTURE0);
        gl.BindVertexArray(vertex_array.id());
    }

    void draw_list(const ImDrawList& list, const ImDrawData& data, const UiTarget& to) const {
        render::upload_bytes(gl, GL_ARRAY_BUFFER, vertices, bytes_of(list.VtxBuffer), GL_STREAM_DRAW);
        render::upload_bytes(gl, GL_ELEMENT_ARRAY_BUFFER, indices, bytes_of(list.IdxBuffer), GL_STREAM_DRAW);
        for (const ImDrawCmd& command : list.CmdBuffer) {
            if (command.UserCallback != nullptr) continue;  // only ImDrawCallback_ResetRenderState, which is not needed
            draw_command(list, command, data, to);
        }
    }

    void draw_command(const ImDrawList& list, const ImDrawCmd& command, const ImDrawData& data,
                      const UiTarget& to) const {
        const PixelBox box = clip_box(command.ClipRect, data, to);
        const auto number = static_cast<editor::UiTexture>(reinterpret_cast<std::uintptr_t>(command.GetTexID()));
        const unsigned texture = texture_of(number);
        if (box.is_empty() || texture == 0) return;
        gl.Scissor(box.left, box.low, box.width, box.height);
        gl.BindTexture(GL_TEXTURE_2D, texture);
        const float px_per_unit = data.FramebufferScale.x;  // the same in x and y
        if (number == kFont) {
            for (const UiRun& run : cut_into_runs(list, command, px_per_unit)) draw_run(command, run);
        } else {
            draw_picture(list, command, number, px_per_unit);
        }
    }

    void draw_picture(const ImDrawList& list, const ImDrawCmd& command, editor::UiTexture number,
                      float px_per_unit) const {
        const auto lent_one = lent.find(number);
        const bool is_plain =
            lent_one != lent.end() &&
            lies_pixel_on_pixel(list, command, {lent_one->second->width_px(), lent_one->second->height_px()},
                                px_per_unit);
        if (is_plain) {
            gl.Disable(GL_BLEND);
            gl.BindSampler(0, nearest.id());
        }
        draw_run(command, {.first_index = 0, .count = command.ElemCount});
        gl.BindSampler(0, 0);
        gl.Enable(GL_BLEND);
    }

    void draw_run(const ImDrawCmd& command, const UiRun& run) const {
        (run.kind == RunKind::Textured ? textured : plain).use();
        if (run.kind == RunKind::Opaque) gl.Disable(GL_BLEND);
        constexpr GLenum index_type = sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
        gl.DrawElementsBaseVertex(
            GL_TRIANGLES, static_cast<GLsizei>(run.count), index_type,
            reinterpret_cast<const void*>((command.IdxOffset + run.first_index) * sizeof(ImDrawIdx)),
            static_cast<GLint>(command.VtxOffset));
        if (run.kind == RunKind::Opaque) gl.Enable(GL_BLEND);
    }

    render::GlContext& context;
    const GladGLContext& gl;
    render::Program textured, plain;
    render::VertexArray vertex_array;
    render::Buffer vertices, indices;
    render::Sampler nearest;
    std::map<editor::UiTexture, render::Texture> owned;  // the font and pictures
    std::map<editor::UiTexture, const render::PictureTexture*> lent;
};

UiDraw::UiDraw(render::GlContext& context) : impl_(std::make_unique<Impl>(context)) {}
UiDraw::~UiDraw() = default;

void UiDraw::hold(const editor::TextureUpload& picture) {
    const render::Image& image = picture.picture;
    SELVEDGE_ASSERT(picture.texture != kFont && image.width_px >= 1 && image.height_px >= 1);
    impl_->lent.erase(picture.texture);
    const GladGLContext& gl = impl_->gl;
    impl_->owned.insert_or_assign(picture.texture,
                                  make_texture(gl, image.width_px, image.height_px, image.pixels.data(),
                                               picture.around ? GL_CLAMP_TO_BORDER : GL_REPEAT));
    if (picture.around) {
        const auto& [red, green, blue] = *picture.around;
        const std::array<float, 4> border{float(red) / 255, float(green) / 255, float(blue) / 255, 1};
        gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border.data());
    }
    if (!picture.has_levels) return;
    gl.GenerateMipmap(GL_TEXTURE_2D);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
}

void UiDraw::lend(editor::UiTexture number, const render::PictureTexture& picture) {
    SELVEDGE_ASSERT(number != kFont);
    impl_->owned.erase(number);
    impl_->lent.insert_or_assign(number, &picture);
}

void UiDraw::draw(const UiTarget& to) {
    impl_->context.make_current();
    impl_->take_font(*ImGui::GetIO().Fonts);
    const ImDrawData* data = ImGui::GetDrawData();
    SELVEDGE_ASSERT(data != nullptr && data->Valid);
    impl_->begin(*data, to);
    for (int i = 0; i < data->CmdListsCount; ++i) impl_->draw_list(*data->CmdLists[i], *data, to);
    impl_->gl.Disable(GL_SCISSOR_TEST);
    impl_->gl.Disable(GL_BLEND);
}

namespace {

constexpr float kLargeArea = 1500;  // px, of a triangle: above this, saving pixels outweighs an extra draw call

float area(const ImVec2& a, const ImVec2& b, const ImVec2& c) {
    return 0.5F * std::abs((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y));
}

bool is_same(const ImVec2& a, const ImVec2& b) {
    return a.x == b.x && a.y == b.y;
}

using Corners = std::array<const ImDrawVert*, 3>;

RunKind kind_of(const Corners& corners, const ImVec2& white, float min_area) {
    const auto is_white = [&](const ImDrawVert* vertex) { return is_same(vertex->uv, white); };
    const auto is_opaque = [](const ImDrawVert* vertex) { return vertex->col >> IM_COL32_A_SHIFT == 255; };
    if (area(corners[0]->pos, corners[1]->pos, corners[2]->pos) < min_area) return RunKind::Textured;
    if (!std::all_of(corners.begin(), corners.end(), is_white)) return RunKind::Textured;
    return std::all_of(corners.begin(), corners.end(), is_opaque) ? RunKind::Opaque : RunKind::Blended;
}

}  // namespace

bool lies_pixel_on_pixel(const ImDrawList& list, const ImDrawCmd& command, const PictureSize& size, float px_per_unit) {
    if (command.ElemCount != 6) return false;  // not one rectangle
    const ImDrawIdx* indices = list.IdxBuffer.Data + command.IdxOffset;
    const ImDrawVert* vertices = list.VtxBuffer.Data + command.VtxOffset;
    const auto offset_of = [&](const ImDrawVert& vertex) {
        return ImVec2(vertex.pos.x * px_per_unit - vertex.uv.x * float(size.width_px),
                      vertex.pos.y * px_per_unit - vertex.uv.y * float(size.height_px));
    };
    const ImVec2 first = offset_of(vertices[indices[0]]);
    constexpr float close = 0.01F;  // px
    if (std::abs(first.x - std::round(first.x)) > close || std::abs(first.y - std::round(first.y)) > close)
        return false;
    return std::all_of(indices, indices + 6, [&](ImDrawIdx index) {
        const ImVec2 offset = offset_of(vertices[index]);
        return std::abs(offset.x - first.x) < close && std::abs(offset.y - first.y) < close &&
               vertices[index].col == IM_COL32_WHITE;
    });
}

std::vector<UiRun> cut_into_runs(const ImDrawList& list, const ImDrawCmd& command, float px_per_unit) {
    const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
    const float min_area = kLargeArea / (px_per_unit * px_per_unit);
    const ImDrawIdx* indices = list.IdxBuffer.Data + command.IdxOffset;
    const ImDrawVert* vertices = list.VtxBuffer.Data + command.VtxOffset;
    std::vector<UiRun> runs;
    for (unsigned i = 0; i + 3 <= command.ElemCount; i += 3) {
        const Corners corners{vertices + indices[i], vertices + indices[i + 1], vertices + indices[i + 2]};
        const RunKind kind = kind_of(corners, white, min_area);
        if (runs.empty() || runs.back().kind != kind) runs.push_back({.kind = kind, .first_index = i, .count = 0});
        runs.back().count += 3;
    }
    return runs;
}

}  // namespace selvedge::app

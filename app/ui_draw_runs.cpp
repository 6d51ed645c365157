#include "app/ui_draw_runs.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace selvedge {
namespace {

constexpr float kLargeArea = 1500;  // px, of a triangle: more pixels than a draw call of its own is worth

float area(const ImVec2& a, const ImVec2& b, const ImVec2& c) {
    return 0.5F * std::abs((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y));
}

bool is_same(const ImVec2& a, const ImVec2& b) {
    return a.x == b.x && a.y == b.y;
}

using Corners = std::array<const ImDrawVert*, 3>;

RunKind kind_of(const Corners& corners, const ImVec2& white, float least_area) {
    const auto is_white = [&](const ImDrawVert* vertex) { return is_same(vertex->uv, white); };
    const auto is_opaque = [](const ImDrawVert* vertex) { return vertex->col >> IM_COL32_A_SHIFT == 255; };
    if (area(corners[0]->pos, corners[1]->pos, corners[2]->pos) < least_area) return RunKind::Textured;
    if (!std::all_of(corners.begin(), corners.end(), is_white)) return RunKind::Textured;
    return std::all_of(corners.begin(), corners.end(), is_opaque) ? RunKind::Opaque : RunKind::Blended;
}

}  // namespace

bool lies_pixel_on_pixel(const ImDrawList& list, const ImDrawCmd& command, const PictureSize& size, float px_per_unit) {
    if (command.ElemCount != 6) return false;  // one rectangle
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
    const float least_area = kLargeArea / (px_per_unit * px_per_unit);
    const ImDrawIdx* indices = list.IdxBuffer.Data + command.IdxOffset;
    const ImDrawVert* vertices = list.VtxBuffer.Data + command.VtxOffset;
    std::vector<UiRun> runs;
    for (unsigned i = 0; i + 3 <= command.ElemCount; i += 3) {
        const Corners corners{vertices + indices[i], vertices + indices[i + 1], vertices + indices[i + 2]};
        const RunKind kind = kind_of(corners, white, least_area);
        if (runs.empty() || runs.back().kind != kind) runs.push_back({.kind = kind, .first_index = i, .count = 0});
        runs.back().count += 3;
    }
    return runs;
}

}  // namespace selvedge

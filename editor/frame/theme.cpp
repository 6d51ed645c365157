#include "editor/frame/theme.h"

#include <imgui.h>
#include <algorithm>
#include <cmath>

namespace selvedge::editor {
namespace {

ImVec4 colour(const sim::Rgb8& rgb, float alpha = 1) {
    return {static_cast<float>(rgb[0]) / 255, static_cast<float>(rgb[1]) / 255, static_cast<float>(rgb[2]) / 255,
            alpha};
}

ImVec4 mixed(const sim::Rgb8& a, const sim::Rgb8& b, float share) {
    const ImVec4 x = colour(a), y = colour(b);
    return {x.x + (y.x - x.x) * share, x.y + (y.y - x.y) * share, x.z + (y.z - x.z) * share, 1};
}

using Ranges = ImVector<ImWchar>;  // as kBasicLetters

Ranges ranges_of(const Letters& letters, bool has_basic) {
    ImFontGlyphRangesBuilder builder;
    if (has_basic) builder.AddRanges(kBasicLetters.data());
    for (const char32_t letter : letters) builder.AddChar(static_cast<ImWchar>(letter));
    Ranges ranges;
    builder.BuildRanges(&ranges);
    return ranges;
}

ImFont* add_file(const std::string& bytes, float size_px, const Ranges& ranges, ImFontConfig config) {
    config.FontDataOwnedByAtlas = false;
    config.PixelSnapH = false;
    void* data = const_cast<char*>(bytes.data());  // ImGui only reads it
    return ImGui::GetIO().Fonts->AddFontFromMemoryTTF(data, static_cast<int>(bytes.size()), size_px, &config,
                                                      ranges.Data);
}

ImFont* add_font(const std::string& bytes, float size_px, const Ranges& ranges) {
    ImFontConfig config;
    config.SizePixels = size_px;
    if (bytes.empty()) return ImGui::GetIO().Fonts->AddFontDefault(&config);
    config.OversampleH = 2;
    config.OversampleV = 2;
    return add_file(bytes, size_px, ranges, config);
}

// The letters that the font added last lacks. One sample per pixel: there may be thousands of them.
void add_fallbacks(const std::vector<FallbackFont>& fallbacks, float size_px, const Ranges& ranges) {
    if (ranges.size() < 3) return;  // no range but the end
    for (const FallbackFont& fallback : fallbacks) {
        ImFontConfig config;
        config.MergeMode = true;
        config.FontNo = fallback.face;
        config.OversampleH = 1;
        config.OversampleV = 1;
        add_file(fallback.bytes, size_px, ranges, config);
    }
}

void set_sizes(ImGuiStyle& style, float scale) {
    style = ImGuiStyle();
    style.WindowPadding = {10, 10};
    style.FramePadding = {7, 4};
    style.ItemSpacing = {8, 6};
    style.ItemInnerSpacing = {6, 4};
    style.ScrollbarSize = 11;
    style.GrabMinSize = 10;
    style.WindowRounding = 6;
    style.ChildRounding = 0;
    style.FrameRounding = 4;
    style.PopupRounding = 6;
    style.GrabRounding = 4;
    style.TabRounding = 4;
    style.ScrollbarRounding = 6;
    style.WindowBorderSize = 1;
    style.ChildBorderSize = 0;
    style.FrameBorderSize = 1;
    style.PopupBorderSize = 1;
    style.WindowTitleAlign = {0, 0.5F};
    style.ScaleAllSizes(scale);
}

}  // namespace

Fonts load_fonts(const FontBytes& files, const Theme& theme, float scale, const Letters& letters) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    const float size = std::round(theme.font_px * scale);
    const std::string& bold = files.bold.empty() ? files.regular : files.bold;
    const Ranges all = ranges_of(letters, true), additional = ranges_of(letters, false);
    Fonts fonts;
    fonts.regular = add_font(files.regular, size, all);
    add_fallbacks(files.fallbacks, size, additional);
    fonts.bold = add_font(bold, size, all);
    add_fallbacks(files.fallbacks, size, additional);
    fonts.large = add_font(bold, std::round(size * 1.6F), all);
    atlas.Build();  // reads the ranges
    for (ImFont* font : {fonts.regular, fonts.bold}) make_digits_tabular(*font);
    return fonts;
}

Theme dark_theme() {
    return {.panel{0x2A, 0x2C, 0x30},
            .field{0x36, 0x39, 0x3E},
            .line{0x4A, 0x4D, 0x53},
            .ink{0xE8, 0xE6, 0xE1},
            .faint{0xA2, 0xA4, 0xA8},
            .accent{0x4F, 0xB0, 0xD0},
            .warning{0xE5, 0xB1, 0x5A},
            .question{0x4A, 0x3D, 0x24},
            .error{0xF0, 0x86, 0x7C}};
}

void apply_theme(const Theme& theme, float scale) {
    ImGuiStyle& style = ImGui::GetStyle();
    set_sizes(style, scale);
    const ImVec4 clear(0, 0, 0, 0);
    const auto set = [&](ImGuiCol which, const ImVec4& value) { style.Colors[which] = value; };
    set(ImGuiCol_Text, colour(theme.ink));
    set(ImGuiCol_TextDisabled, colour(theme.faint));
    set(ImGuiCol_WindowBg, colour(theme.panel));
    set(ImGuiCol_ChildBg, clear);
    set(ImGuiCol_PopupBg, colour(theme.field));
    set(ImGuiCol_Border, colour(theme.line));
    set(ImGuiCol_FrameBg, colour(theme.field));
    set(ImGuiCol_FrameBgHovered, mixed(theme.field, theme.accent, 0.06F));
    set(ImGuiCol_FrameBgActive, mixed(theme.field, theme.accent, 0.12F));
    set(ImGuiCol_TitleBg, colour(theme.panel));
    set(ImGuiCol_TitleBgActive, mixed(theme.panel, theme.accent, 0.12F));
    set(ImGuiCol_TitleBgCollapsed, colour(theme.panel));
    set(ImGuiCol_MenuBarBg, colour(theme.panel));
    set(ImGuiCol_ScrollbarBg, clear);
    set(ImGuiCol_ScrollbarGrab, mixed(theme.line, theme.faint, 0.2F));
    set(ImGuiCol_ScrollbarGrabHovered, mixed(theme.line, theme.faint, 0.5F));
    set(ImGuiCol_ScrollbarGrabActive, colour(theme.faint));
    set(ImGuiCol_CheckMark, colour(theme.accent));
    set(ImGuiCol_SliderGrab, colour(theme.accent));
    set(ImGuiCol_SliderGrabActive, colour(theme.accent));
    set(ImGuiCol_Button, colour(theme.field));
    set(ImGuiCol_ButtonHovered, mixed(theme.field, theme.accent, 0.12F));
    set(ImGuiCol_ButtonActive, mixed(theme.field, theme.accent, 0.25F));
    set(ImGuiCol_Header, mixed(theme.panel, theme.accent, 0.18F));
    set(ImGuiCol_HeaderHovered, mixed(theme.panel, theme.accent, 0.12F));
    set(ImGuiCol_HeaderActive, mixed(theme.panel, theme.accent, 0.28F));
    set(ImGuiCol_Separator, colour(theme.line));
    set(ImGuiCol_SeparatorHovered, colour(theme.accent));
    set(ImGuiCol_SeparatorActive, colour(theme.accent));
    set(ImGuiCol_ResizeGrip, clear);
    set(ImGuiCol_Tab, clear);
    set(ImGuiCol_TabHovered, mixed(theme.panel, theme.accent, 0.12F));
    set(ImGuiCol_TabActive, mixed(theme.panel, theme.accent, 0.18F));
    set(ImGuiCol_PlotLines, colour(theme.accent));
    set(ImGuiCol_PlotHistogram, colour(theme.accent));
    set(ImGuiCol_TableHeaderBg, mixed(theme.panel, theme.line, 0.5F));
    set(ImGuiCol_TableBorderStrong, colour(theme.line));
    set(ImGuiCol_TableBorderLight, mixed(theme.panel, theme.line, 0.5F));
    set(ImGuiCol_TextSelectedBg, mixed(theme.field, theme.accent, 0.35F));
    set(ImGuiCol_DragDropTarget, colour(theme.accent));
    set(ImGuiCol_NavHighlight, colour(theme.accent));
}

namespace {

bool is_digit(const ImFontGlyph& glyph) {
    return glyph.Codepoint >= '0' && glyph.Codepoint <= '9';
}

}  // namespace

void make_digits_tabular(ImFont& font) {
    float widest = 0;
    for (const ImFontGlyph& glyph : font.Glyphs) {
        if (is_digit(glyph)) widest = std::max(widest, glyph.AdvanceX);
    }
    for (ImFontGlyph& glyph : font.Glyphs) {
        if (!is_digit(glyph)) continue;
        const float shift = 0.5F * (widest - glyph.AdvanceX);
        glyph.X0 += shift;
        glyph.X1 += shift;
        glyph.AdvanceX = widest;
        font.IndexAdvanceX[static_cast<int>(glyph.Codepoint)] = widest;
    }
}

}  // namespace selvedge::editor

#include "editor/frame/tabular_digits.h"

#include <imgui.h>

#include <algorithm>

namespace selvedge {
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

}  // namespace selvedge

#pragma once
// The letters of text that are beyond those which the interface's fonts always hold, such as the Japanese or Cyrillic
// ones of a panel's name. They are added to the fonts when a text first needs them.
#include <set>
#include <string_view>

struct ImFont;

namespace selvedge::editor {

using Letters = std::set<char32_t>;  // Unicode code points

// Adds the letters of a UTF-8 text that are not in `kBasicLetters`. What is no UTF-8, and letters above U+FFFF, which
// ImGui cannot hold, are left out.
void add_letters(std::string_view text, Letters& letters);

// The letters for which the font has no glyph. Pre: the font atlas is built.
Letters without_glyph(const Letters& letters, const ImFont& font);

}  // namespace selvedge::editor

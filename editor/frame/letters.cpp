#include "editor/frame/letters.h"

#include <imgui.h>

#include <bit>
#include <cstddef>
#include <cstdint>

#include "editor/frame/theme.h"

namespace selvedge::editor {
namespace {

struct Decoded {
    char32_t letter = 0;  // 0: no UTF-8
    std::size_t bytes = 1;
};

// The first letter of a text that is not empty.
Decoded decode(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const auto length = static_cast<std::size_t>(std::countl_one(byte(0)));
    if (length == 0) return {.letter = byte(0)};
    if (length == 1 || length > 4 || length > text.size()) return {};
    char32_t letter = byte(0) & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) return {};
        letter = letter << 6U | (byte(i) & 0x3FU);
    }
    return {.letter = letter, .bytes = length};
}

bool is_basic(char32_t letter) {
    for (std::size_t i = 0; kBasicLetters[i] != 0; i += 2) {
        if (letter >= kBasicLetters[i] && letter <= kBasicLetters[i + 1]) return true;
    }
    return letter < 0x20;
}

}  // namespace

void add_letters(std::string_view text, Letters& letters) {
    constexpr char32_t kLast = 0xFFFF;
    while (!text.empty()) {
        const Decoded first = decode(text);
        text.remove_prefix(first.bytes);
        if (!is_basic(first.letter) && first.letter <= kLast) letters.insert(first.letter);
    }
}

Letters without_glyph(const Letters& letters, const ImFont& font) {
    Letters missing;
    for (const char32_t letter : letters) {
        if (font.FindGlyphNoFallback(static_cast<ImWchar>(letter)) == nullptr) missing.insert(letter);
    }
    return missing;
}

}  // namespace selvedge::editor

#pragma once
// The letters of legends, as pixels: drawn for this program, so that a picture's bits hang on no font of the machine.
#include <array>
#include <cstdint>

namespace selvedge {

inline constexpr int kGlyphWidth = 5;   // px, at most
inline constexpr int kGlyphHeight = 9;  // px, the lowest two below the line
inline constexpr int kCapitalHeight = 7;

// Rows from the top; bit 4 is the leftmost pixel. What is not in ASCII 32..126 looks like a question mark.
using Glyph = std::array<std::uint8_t, kGlyphHeight>;
Glyph find_glyph(char letter);

}  // namespace selvedge

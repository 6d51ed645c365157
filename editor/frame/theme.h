#pragma once
// The editor's appearance: colours, fonts and ImGui style. Light greys, dark text, one accent colour. All sizes scale
// with the font size, and so with the display scale. Also gives fonts tabular digits.
#include <array>
#include <string>
#include <vector>

#include "editor/frame/letters.h"
#include "sim/tartan/sett.h"

struct ImFont;

namespace selvedge::editor {

struct Theme {
    sim::Rgb8 panel{0xF7, 0xF6, 0xF3};   // panels and lists
    sim::Rgb8 field{0xFF, 0xFF, 0xFF};   // input fields
    sim::Rgb8 line{0xD5, 0xD2, 0xCB};    // separators and borders
    sim::Rgb8 ink{0x26, 0x29, 0x2E};     // text
    sim::Rgb8 faint{0x77, 0x78, 0x7A};   // secondary text
    sim::Rgb8 accent{0x1F, 0x6F, 0x8B};  // selected or active items
    sim::Rgb8 warning{0x9A, 0x66, 0x0E};
    sim::Rgb8 question{0xFB, 0xF1, 0xDC};  // behind a question to the user
    sim::Rgb8 error{0xAE, 0x2F, 0x27};
    float font_px = 15;  // px, at display scale 1
};

Theme dark_theme();

// A font for letters that the interface's own fonts lack.
struct FallbackFont {
    std::string bytes{};  // of a TrueType or OpenType file
    int face = 0;         // of a file with several
};

// The bytes of font files. Empty: ImGui's built-in font is used.
struct FontBytes {
    std::string regular{};
    std::string bold{};
    std::vector<FallbackFont> fallbacks{};  // for letters that those lack; the first one that has a letter is used
};

// The letters that the fonts always hold, as pairs of the first and the last one, ended by 0: Latin with accents,
// dashes and quotes, arrows, mathematical signs.
inline constexpr std::array<unsigned short, 9> kBasicLetters{0x20,   0x17F,  0x2010, 0x2044, 0x2190,
                                                             0x2193, 0x2200, 0x2265, 0};

struct Fonts {
    ImFont* regular = nullptr;
    ImFont* bold = nullptr;
    ImFont* large = nullptr;  // titles
};

// Builds the font atlas of the current ImGui context, with these letters beside the basic ones as far as a font has
// them. The bytes must outlive the atlas. Call between frames: pointers to the fonts before are no longer valid.
Fonts load_fonts(const FontBytes& files, const Theme& theme, float scale, const Letters& letters = {});

// Sets the style of the current ImGui context.
void apply_theme(const Theme& theme, float scale);

// Tabular digits: all digits have one width, so that numbers align in columns and do not shift while they change.
// Fonts such as Inter offer them as an OpenType feature (tnum), which ImGui does not support.

// Sets the advance of every digit to that of the widest digit and centres the glyphs. Pre: the font atlas is built.
void make_digits_tabular(ImFont& font);

}  // namespace selvedge::editor

#pragma once
// How the editor looks: calm paper greys, dark ink, one accent. All sizes follow the font, and so the screen's scale.
#include <string>

#include "sim/tartan/sett.h"

struct ImFont;

namespace selvedge::editor {

struct Theme {
    sim::Rgb8 desk{0xE9, 0xE7, 0xE2};    // behind all
    sim::Rgb8 panel{0xF7, 0xF6, 0xF3};   // boxes and lists
    sim::Rgb8 field{0xFF, 0xFF, 0xFF};   // what can be typed into
    sim::Rgb8 line{0xD5, 0xD2, 0xCB};    // between things
    sim::Rgb8 ink{0x26, 0x29, 0x2E};     // words
    sim::Rgb8 faint{0x77, 0x78, 0x7A};   // words that matter less
    sim::Rgb8 accent{0x1F, 0x6F, 0x8B};  // what is chosen or does something
    sim::Rgb8 warning{0x9A, 0x66, 0x0E};
    sim::Rgb8 error{0xAE, 0x2F, 0x27};
    float font_px = 15;  // at scale 1
};

// The bytes of font files; empty: ImGui's own is used.
struct FontBytes {
    std::string regular{};
    std::string bold{};
};

struct Fonts {
    ImFont* regular = nullptr;
    ImFont* bold = nullptr;
    ImFont* large = nullptr;  // titles
};

// Fills the current context's font atlas. The bytes must outlive it.
Fonts load_fonts(const FontBytes& files, const Theme& theme, float scale);

// Sets the current context's style.
void apply_theme(const Theme& theme, float scale);

}  // namespace selvedge::editor

// Digits of one width, so that numbers stand in columns and do not dance while they change: fonts such as Inter have
// them behind a switch that ImGui does not know.

struct ImFont;

namespace selvedge::editor {

// Gives each digit the widest one's width, in its middle. Pre: the font's atlas is built.
void make_digits_tabular(ImFont& font);

}  // namespace selvedge::editor

#pragma once
// Digits of one width, so that numbers stand in columns and do not dance while they change: fonts such as Inter have
// them behind a switch that ImGui does not know.
struct ImFont;

namespace selvedge {

// Gives each digit the widest one's width, in its middle. Pre: the font's atlas is built.
void make_digits_tabular(ImFont& font);

}  // namespace selvedge

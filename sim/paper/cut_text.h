#pragma once
// What the texts on a pattern say of how a part is cut: how often, mirrored, on the fold, of what. In English, German,
// French, Spanish and Dutch, as FreeSewing and Valentina write them and as labels of DXF do.
#include <string>
#include <string_view>
#include <vector>

#include "sim/paper/drawing.h"

namespace selvedge::sim {

// From "Fabric, Cut 2", "cut 2 mirrored from main fabric", "2x zuschneiden im Stoffbruch", "Quantity: 1,1" (as drawn,
// and mirrored), "2XFABRIC", "Material: lining", and "cut,2,mirrored,from,fabric" with or without the prefix of each
// key. Materials get their English names where they are known. "Place on fold" and "Stoffbruch" say the fold alone.
// Adds to what is known, of which main fabric goes before other materials; returns false for texts about other things,
// which change nothing.
bool read_cut_text(std::string_view text, CutInstructions& cut);

// Whether a text has a word for a fold, in any of these languages.
bool names_fold(std::string_view text);

// The words of texts and classes in drawings: runs of letters and digits; ASCII in small letters, other letters as they
// are.
std::vector<std::string> words_of(std::string_view text);

}  // namespace selvedge::sim

#pragma once
// What a panel is for, from its name and the names beside it: "left_sleeve_f" is the front of a left sleeve. Imported
// patterns say it nowhere else. Names may be in the languages of Europe that pattern programs are written in, Chinese
// or Japanese, joined by capitals, dots, blanks or underscores.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/pattern/pattern.h"
#include "sim/proposals/name_words.h"

namespace selvedge::sim {

// Accessory: what lies on or in other panels and does not hold the garment together, as pockets, facings, plackets.
enum class GarmentPart {
    Unknown,
    Torso,
    Yoke,
    Sleeve,
    Cuff,
    Collar,
    CollarStand,
    Hood,
    Skirt,
    Leg,
    Waistband,
    Binding,
    Accessory
};
enum class Face { None, Front, Back };
enum class Flank { None, Left, Right };  // of the wearer

struct PanelRole {
    GarmentPart part = GarmentPart::Unknown;
    Face face = Face::None;
    Flank flank = Flank::None;

    bool operator==(const PanelRole&) const = default;
};

std::string_view name_of(GarmentPart part);  // "collar stand"

// What one name says. A torso that is only called front or back has the part Unknown.
PanelRole role_of_name(std::string_view name);

// The roles of all panels. Fronts and backs that name no part belong to legs if the pattern's name or another panel
// says trousers, to a skirt if it says skirt, else to the torso; panels that look like trouser legs are taken for them.
// hints: further words about the whole garment, as a title.
std::vector<PanelRole> roles_of(const Pattern& pattern, std::string_view hints = {});

// Whether one of the panels is kept a mirror image of the other.
bool are_mirror_images(const Panel& a, const Panel& b);

// Whether a panel comes in pairs, one for each side of the body, when its drawing does not say: sleeves, cuffs, legs,
// and bindings of arms and legs.
bool comes_in_pairs(const PanelRole& role, std::string_view name);

}  // namespace selvedge::sim

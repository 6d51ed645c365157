#pragma once
// Where the texts of the sheet stand. The names of panels keep their places, shortened if they are too long for their
// panel; badges such as lengths stand where they cover no name and no other badge.
#include <imgui.h>
#include <span>
#include <string>
#include <vector>

#include "editor/sheet/sheet_pen.h"

namespace selvedge::editor {

// The boxes of the texts that stand on the sheet so far.
class LabelPlaces {
 public:
    void reserve(const LabelBox& box) { taken_.push_back(box); }

    // Reserves the box of this size (px) around the first of the centres (px) where it covers no other one; if it
    // covers some everywhere, around the one where it covers least. Returns the centre. Pre: there is one.
    ImVec2 place(const ImVec2& size, std::span<const ImVec2> centres);

    const std::vector<LabelBox>& taken() const { return taken_; }

 private:
    std::vector<LabelBox> taken_;
};

inline constexpr double kSmallestName = 0.7;  // smallest legible size, relative to the normal font size

// The name of a panel as it is drawn.
struct PanelName {
    std::string panel{};
    bool has_room = false;  // the panel is drawn large enough for its grainline
    std::string shown{};    // the name, or its beginning with dots behind it; empty: there is room for neither
    Vec2d middle{0, 0};     // of the text, in the panel's frame, m
    float size = 1;         // relative to the normal font size
    LabelBox box{};         // px, if something is shown

    bool is_whole() const { return shown == panel; }
};

// The name in the middle of its panel.
PanelName name_of(const SheetLook& look, const PanelShape& shape);

}  // namespace selvedge::editor

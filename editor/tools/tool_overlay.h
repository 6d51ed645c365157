#pragma once
// What a tool wants seen over the sheet, as plain data: the view draws it, tests read it. Points on the sheet, m.
#include <set>
#include <string>
#include <vector>

#include "editor/document/selection.h"
#include "sim/core/vec.h"

namespace selvedge {

enum class OverlayTone {
    Draft,    // what is being made
    Faint,    // what helps to make it
    Guide,    // what it snaps to
    Measure,  // lengths and angles
    Warning   // what is likely not meant
};

struct OverlayLine {
    std::vector<Vec2d> points;
    OverlayTone tone = OverlayTone::Draft;
    bool is_dashed = false;
    bool is_closed = false;  // and filled thinly
    bool has_ticks = false;  // small ticks and a triangle show which way it runs
};

enum class HandleShape { Square, Round, Diamond, Cross };

struct OverlayHandle {
    Vec2d at = Vec2d::Zero();
    HandleShape shape = HandleShape::Square;
    OverlayTone tone = OverlayTone::Draft;
    bool is_filled = false;
};

struct OverlayLabel {
    Vec2d at = Vec2d::Zero();  // of its middle
    std::string text;
    OverlayTone tone = OverlayTone::Measure;
};

struct ToolOverlay {
    std::vector<OverlayLine> lines{};
    std::vector<OverlayHandle> handles{};
    std::vector<OverlayLabel> labels{};
    std::set<PartRef> handle_edges{};    // edges whose curve handles are shown
    std::vector<std::string> readout{};  // beside the cursor, a line each
    bool shows_vertices = false;         // of panels that have something selected, as handles
    bool shows_sewing = false;           // seams stand out from the outlines
};

}  // namespace selvedge

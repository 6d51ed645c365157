#pragma once
// The interface of the sheet's tools. A tool is a small state machine: it receives mouse and key events, changes the
// document by commands, and returns an overlay to show; it draws nothing itself. Tools throw GeometryError, which
// ToolHost catches (tool_host.h). The tools are listed in tool_table.h. Also typed numbers and helpers for overlays.
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/frame/frame.h"
#include "editor/tools/sheet_geometry.h"
#include "editor/tools/sheet_pick.h"
#include "editor/tools/snap.h"
#include "editor/workspace/workspace.h"
#include "sim/core/math.h"

namespace selvedge::editor {

// What a tool shows over the sheet, as plain data: the view draws it, tests read it. Points on the sheet, m.

enum class OverlayTone {
    Draft,    // the part being made
    Faint,    // auxiliary lines
    Guide,    // snap targets
    Measure,  // lengths and angles
    Warning   // probable mistakes
};

struct OverlayLine {
    std::vector<Vec2d> points;
    OverlayTone tone = OverlayTone::Draft;
    bool is_dashed = false;
    bool is_closed = false;  // closed polygon, with a transparent fill
    bool has_ticks = false;  // ticks and a triangle show its direction
};

enum class HandleShape { Square, Round, Diamond, Cross };

struct OverlayHandle {
    Vec2d at = Vec2d::Zero();
    HandleShape shape = HandleShape::Square;
    OverlayTone tone = OverlayTone::Draft;
    bool is_filled = false;
};

struct OverlayLabel {
    Vec2d at = Vec2d::Zero();  // centre of the text
    std::string text;
    OverlayTone tone = OverlayTone::Measure;
};

struct ToolOverlay {
    std::vector<OverlayLine> lines{};
    std::vector<OverlayHandle> handles{};
    std::vector<OverlayLabel> labels{};
    std::set<PartRef> handle_edges{};    // edges with visible curve handles
    std::vector<std::string> readout{};  // lines of text beside the cursor
    std::string problem{};               // above them: why the pattern cannot be as it is dragged
    bool shows_vertices = false;         // of panels with a selected part, as handles
    bool shows_sewing = false;           // seams are highlighted
};

// The mouse position and modifier keys.
struct SheetPointer {
    Vec2d at = Vec2d::Zero();  // on the sheet, m
    Modifiers modifiers{};
};

struct ToolContext {
    Document& document;
    const SheetGeometry& geometry;
    Hover& hover;
    Messages& messages;
    const Drape* drape = nullptr;  // with the body that panels are placed around; null: there is none
    double px = 0.001;             // m, length of one interface px on the sheet
    double grid = 0.01;            // m, snapping step; 0: no grid
    bool is_snapping = true;
    std::optional<std::vector<double>> typed{};  // the numbers typed so far, if they can be parsed
    SheetPointer pointer{};                      // last mouse position
};

inline constexpr double kPickTolerance = 7;  // px
inline constexpr double kSnapTolerance = 9;  // px

// Shift enables snapping to directions; Ctrl disables all other snapping.
SnapOptions snap_options(const ToolContext& context, const Modifiers& modifiers);
PickOptions pick_options(const ToolContext& context);

class Tool {
 public:
    Tool() = default;
    Tool(const Tool&) = delete;
    Tool& operator=(const Tool&) = delete;
    virtual ~Tool() = default;

    // The mouse moves with no button held.
    virtual void hover(ToolContext& context, const SheetPointer& pointer);

    // The left button is pressed, then released within 3 px (click), or moved further and released (drag, drag, ...,
    // drop).
    virtual void press(ToolContext&, const SheetPointer&) {}
    virtual void click(ToolContext&, const SheetPointer&) {}
    virtual void drag(ToolContext&, const SheetPointer&) {}
    virtual void drop(ToolContext&, const SheetPointer&) {}
    virtual void double_click(ToolContext&, const SheetPointer&) {}  // called after the second click

    // Returns whether the tool used the key in its current state.
    virtual bool key(ToolContext&, Key, const Modifiers&) { return false; }

    // Called with the typed numbers when Enter is pressed. Returns whether the tool used them.
    virtual bool enter(ToolContext&, const std::vector<double>&) { return false; }

    // Cancels the operation in progress. Returns whether there was one.
    virtual bool cancel(ToolContext&) { return false; }

    virtual void draw(const ToolContext&, ToolOverlay&) const {}

    // One line of help: what to do next.
    virtual std::string hint(const ToolContext& context) const = 0;
};

// Text for readouts: cm with one or two decimals, signed mm with one, degrees with one.
std::string in_cm(double metres);
std::string in_mm(double metres);
std::string in_degrees(double radians);

// Numbers typed while a tool is active: 12, 92/4+1, 30 x 40. The unit depends on the tool: cm, degrees or a factor.
// 12 < 30 is a length and its direction in degrees: two numbers, across and up.

class TypedInput {
 public:
    // Appends the characters that can be part of a number; `x` separates numbers and is accepted only after the first
    // character. Other characters, and those beyond 64, are ignored. Returns whether any character was appended.
    bool add(std::string_view text);
    void remove_last();
    void clear() { text_.clear(); }

    bool is_empty() const { return text_.empty(); }
    const std::string& text() const { return text_; }

    // One number, or several separated by x. None: the text is empty or cannot be parsed (yet).
    std::optional<std::vector<double>> numbers() const;

 private:
    std::optional<std::vector<double>> polar(std::size_t sign) const;

    std::string text_;
};

// Overlay helpers shared by several tools.

void add_guides(ToolOverlay& overlay, const Snap& snapped);

// The polyline of an edge from one fraction of its length to another, in that direction, on the sheet, m.
std::vector<Vec2d> part_of_edge(const PanelShape& shape, int edge, double from, double to);

// Adds a line along a whole edge.
void add_edge(ToolOverlay& overlay, const SheetGeometry& geometry, const PartRef& edge, OverlayTone tone);

void add_box(ToolOverlay& overlay, const SheetBox& box, OverlayTone tone);

// The edges of these panels that have curve handles.
std::set<PartRef> curved_edges_of(const SheetGeometry& geometry, const std::set<std::string>& panels);

}  // namespace selvedge::editor

#pragma once
// What a tool of the sheet is: a small state machine that hears of mouse and keys and changes the document by commands.
// It says what is to be seen, and draws nothing. Tools throw GeometryError; their host catches it (tool_host.h).
#include <memory>
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

// What a tool wants seen over the sheet, as plain data: the view draws it, tests read it. Points on the sheet, m.

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

// Where the mouse is.
struct SheetPointer {
    Vec2d at = Vec2d::Zero();  // on the sheet, m
    Modifiers modifiers{};
};

struct ToolContext {
    Document& document;
    const SheetGeometry& geometry;
    Hover& hover;
    Messages& messages;
    double px = 0.001;   // m: what a px of the interface is on the sheet
    double grid = 0.01;  // m, to snap to; 0: none
    bool is_snapping = true;
    std::optional<std::vector<double>> typed{};  // what is being typed, where it can be read
    SheetPointer pointer{};                      // where the mouse was last
};

inline constexpr double kPickTolerance = 7;  // px
inline constexpr double kSnapTolerance = 9;  // px

// Shift asks for directions, Ctrl turns the rest off.
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

    // The left button goes down, and then either up again at once (click) or after a way (drag, drag, ..., drop).
    virtual void press(ToolContext&, const SheetPointer&) {}
    virtual void click(ToolContext&, const SheetPointer&) {}
    virtual void drag(ToolContext&, const SheetPointer&) {}
    virtual void drop(ToolContext&, const SheetPointer&) {}
    virtual void double_click(ToolContext&, const SheetPointer&) {}  // after its second click

    // Returns whether the key was meant for this tool as it stands.
    virtual bool key(ToolContext&, Key, const Modifiers&) { return false; }

    // Numbers were typed and Enter was pressed. Returns whether they meant something.
    virtual bool enter(ToolContext&, const std::vector<double>&) { return false; }

    // Gives up what was begun. Returns whether anything was.
    virtual bool cancel(ToolContext&) { return false; }

    virtual void draw(const ToolContext&, ToolOverlay&) const {}

    // One line: what to do next.
    virtual std::string hint(const ToolContext& context) const = 0;
};

enum class ToolKind {
    Select,
    EditPoint,
    AddPoint,
    CurvePoint,
    Polygon,
    Rectangle,
    Ellipse,
    InternalLine,
    Dart,
    Notch,
    Rotate,
    Scale,
    Mirror,
    Cut,
    Merge,
    Unfold,
    Measure,
    SegmentSewing,
    FreeSewing
};

struct ToolInfo {
    ToolKind kind = ToolKind::Select;
    std::string_view id;     // for scripts: edit_point
    std::string_view title;  // for people: Edit point
    Key key = Key::None;     // None: from a menu only
    std::string_view what;   // one sentence
};

// All tools, in the order of a toolbar.
const std::vector<ToolInfo>& all_tools();
const ToolInfo& info_of(ToolKind kind);
std::optional<ToolKind> tool_of_key(Key key);

std::unique_ptr<Tool> make_tool(ToolKind kind);

// 12.3 cm, -4.5 deg: at most one digit after the point unless the number has more to say; for readouts.
std::string in_cm(double metres);
std::string in_mm(double metres);
std::string in_degrees(double radians);

// Numbers that a person types while a tool is at work: 12, 92/4+1, 30 x 40. Centimetres or degrees, as the tool says.

class TypedInput {
 public:
    // Takes what can be part of a number; a letter only where it goes on with one that has begun: x between two.
    // Returns whether it was taken.
    bool add(std::string_view text);
    void remove_last();
    void clear() { text_.clear(); }

    bool is_empty() const { return text_.empty(); }
    const std::string& text() const { return text_; }

    // One number, or several with x between them. None: it cannot be read (so far), or is empty.
    std::optional<std::vector<double>> numbers() const;

 private:
    std::string text_;
};

// What several tools show alike.

void add_guides(ToolOverlay& overlay, const Snap& snapped);

// The part of an edge between two fractions of its length, in that direction, on the sheet.
std::vector<Vec2d> part_of_edge(const PanelShape& shape, int edge, double from, double to);

// A line over an edge.
void add_edge(ToolOverlay& overlay, const SheetGeometry& geometry, const PartRef& edge, OverlayTone tone);

void add_box(ToolOverlay& overlay, const SheetBox& box, OverlayTone tone);

// Edges of a panel whose handles are shown: of those that have any part selected.
std::set<PartRef> curved_edges_of(const SheetGeometry& geometry, const std::set<std::string>& panels);

}  // namespace selvedge::editor

#pragma once
// What a tool of the sheet is: a small state machine that hears of mouse and keys and changes the document by commands.
// It says what is to be seen, and draws nothing. Tools throw DraftError; their host catches it (tool_host.h).
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/document/document.h"
#include "editor/document/hover.h"
#include "editor/frame/input.h"
#include "editor/tools/sheet_camera.h"
#include "editor/tools/sheet_geometry.h"
#include "editor/tools/sheet_pick.h"
#include "editor/tools/snap.h"
#include "editor/tools/tool_overlay.h"
#include "editor/workspace/messages.h"

namespace selvedge {

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

}  // namespace selvedge

#pragma once
// What all boxes and lists are given: what is worked on, and whom they tell.
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/document/command.h"
#include "editor/frame/frame.h"
#include "editor/frame/theme.h"
#include "editor/inspectors/drape_inspector.h"
#include "editor/workspace/workspace.h"
#include "sim/body/body.h"
#include "sim/tartan/match.h"
#include "sim/tartan/sett.h"

namespace selvedge::editor {

// What the boxes and lists remember between two frames of the screen: what is typed and not yet applied, what is
// unfolded, pictures that are made once.

// Text that is being typed into a box.
struct TypedText {
    unsigned box = 0;  // ImGui's id; 0: none
    std::string text{};
    std::string text_before{};
    std::optional<double> before{};  // value of a number box, when it was entered
    std::string wrong{};             // why it cannot be applied, in words; empty: it can
    bool is_trying = false;          // a change is shown that is not kept yet
    int last_frame = 0;              // when the box was last drawn
};

// A number that is dragged by its label.
struct Scrub {
    unsigned box = 0;  // ImGui's id; 0: none
    double before = 0;
    double value = 0;
    bool is_trying = false;
    bool is_given_up = false;  // by Esc, until the button is let go
    int last_frame = 0;
};

struct BoxState {
    TypedText typed;
    TypedText left;  // another box was entered before this one could apply its text
    Scrub scrub;
};

// What is costly to know of a panel, as of a revision of the document.
struct PanelFacts {
    std::uint64_t revision = 0;
    double area = 0;       // m^2
    double perimeter = 0;  // m
};

// Angles as they were typed: a rotation has several.
struct TypedAngles {
    Vec3d angles = Vec3d::Zero();  // rad, about x, y, z
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
};

struct TartanPicture {
    std::string shown_as{};  // "Black Watch"
    sim::Sett sett{};
    UiTexture texture = 0;
};

struct MaterialState {
    std::string fabric{};  // whose values are shown; empty: the garment's
    std::string search{};
    std::vector<std::pair<std::string, TartanPicture>> tartans{};  // those that ship, by name
    UiTexture repeats = 0;                                         // the preview from afar,
    UiTexture threads = 0;                                         // and from near
    std::string previewed{};                                       // what they show
    std::vector<sim::SeamMatch> matched{};                         // what the last match came to
    std::uint64_t matched_revision = 0;
};

struct BodyState {
    std::string pending{};  // the body that is wanted and not yet the document's; empty: none
    bool is_kept = false;   // to become the document's once it is made
    int idle_frames = 0;    // that nothing was being made while it was pending
    std::string wrong{};    // why what was typed is no body
    std::string drafted{};  // text of the body that the document names, and that body
    std::shared_ptr<const sim::Body> drafted_body{};
};

struct DrapeState {
    DrapeTrace trace{};
    std::vector<std::string> kept{};  // names of drapes that the session keeps
    std::string name{};               // for the next
};

struct InspectorState {
    BoxState boxes{};
    std::map<std::string, PanelFacts> panels{};
    std::map<std::string, TypedAngles> angles{};
    MaterialState material{};
    BodyState body{};
    DrapeState drape{};
    std::optional<int> hovered_seam{};  // that the list lights up
};

struct InspectorContext {
    Workspace& workspace;
    FrameOutput& output;
    InspectorState& state;
    const Theme& theme;
    const Fonts* fonts = nullptr;               // none: all in the present font
    WidgetMap* widgets = nullptr;               // gets the boxes' places; none: nobody asks
    std::function<UiTexture()> take_texture{};  // a number that nobody else has
    std::function<void()> open_body{};          // lets a body's file be chosen; unset: no button for it
    std::function<std::string(std::string_view action)> key_of{};  // "Ctrl+Z" of an action's id; unset or empty: none

    const sim::Pattern& pattern() const { return workspace.document->pattern(); }
    const Selection& selection() const { return workspace.document->selection(); }
};

// Once per frame of the screen, whichever of the inspectors are seen: counts the drape's frames, takes over a body that
// is finished, and keeps what was being changed in a box that is gone.
void update_inspectors(InspectorContext& context);

// Each fills the present ImGui window from where it stands, as wide as it is; 17 times the font's size or more.
void draw_properties(InspectorContext& context);
void draw_seams(InspectorContext& context);
void draw_materials(InspectorContext& context);
void draw_body(InspectorContext& context);
void draw_drape(InspectorContext& context);
void draw_history(InspectorContext& context);

}  // namespace selvedge::editor

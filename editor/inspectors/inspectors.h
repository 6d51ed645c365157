#pragma once
// The interface of all inspectors: the state that they keep, the context that they receive, and their drawing
// functions.
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
#include "editor/inspectors/object_tree.h"
#include "editor/inspectors/pattern_measures.h"
#include "editor/workspace/workspace.h"
#include "sim/body/body.h"
#include "sim/tartan/match.h"
#include "sim/tartan/sett.h"

namespace selvedge::editor {

// State that the inspectors keep between two UI frames: typed text that is not applied yet, a drag in progress, cached
// values and textures.

// Text that is being typed into a box.
struct TypedText {
    unsigned box = 0;  // ImGui's id; 0: none
    std::string text{};
    std::string text_before{};
    std::optional<double> before{};  // value of a number box when editing began
    std::string wrong{};             // why the text cannot be applied; empty: it can
    bool has_preview = false;        // a preview is shown that is not committed yet
    int last_frame = 0;              // UI frame in which the box was last drawn
};

// A number that is being dragged by its label.
struct Scrub {
    unsigned box = 0;  // ImGui's id; 0: none
    double before = 0;
    double value = 0;
    bool has_preview = false;
    bool is_given_up = false;  // cancelled by Esc; lasts until the button is released
    int last_frame = 0;
};

struct BoxState {
    TypedText typed;
    TypedText left;  // text of the previous box, if another box was entered before it was applied
    Scrub scrub;
    bool gives_keys_back = false;  // a box was left by Enter or Esc: the next keys are for the sheet
};

// Expensive values of a panel, valid for one revision of the document.
struct PanelMeasures {
    std::uint64_t revision = 0;
    double area = 0;       // m^2
    double perimeter = 0;  // m
};

// Euler angles as the user typed them, because several triples give the same rotation.
struct TypedAngles {
    Vec3d angles = Vec3d::Zero();  // rad, about x, y, z
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
};

struct TartanPicture {
    std::string shown_as{};  // for example "Black Watch"
    sim::Sett sett{};
    UiTexture texture = 0;
};

struct MaterialState {
    std::string search{};
    std::vector<std::pair<std::string, TartanPicture>> tartans{};  // built-in tartans, by name
    UiTexture repeats = 0;                                         // texture of the preview that shows repeats
    UiTexture threads = 0;                                         // texture of the preview that shows single threads
    std::string previewed{};                                       // key of the preview that the textures hold
    std::vector<sim::SeamMatch> matched{};                         // result of the last seam matching
    std::uint64_t matched_revision = 0;
};

struct BodyState {
    std::string pending{};            // requested body that is not yet the document's; empty: none
    bool is_commit = false;           // the body is set in the document when it is ready
    int idle_frames = 0;              // frames since the request in which no body was being built
    std::string wrong{};              // why the typed text is not a valid body
    std::string pattern_body_text{};  // text of the document's body, and that body
    std::shared_ptr<const sim::Body> pattern_body{};
};

struct DrapeState {
    DrapeTrace trace{};
    std::vector<std::string> kept{};                   // names of the drapes that the session keeps
    std::string name{};                                // name for the next one
    std::shared_ptr<const sim::DressReport> report{};  // of which findings are listed
    std::size_t motion_faults = 0;                     // listed before them
    std::optional<std::size_t> lit_finding{}, hovered_finding{};
};

// Which row of the tab Objects gets another name.
struct RowNaming {
    std::string row{};       // its widget; empty: none
    bool has_begun = false;  // its box has had the keyboard
};

// What the ObjectTree was made of.
struct ObjectListing {
    std::uint64_t revision = 0;
    PanelGrouping grouping = PanelGrouping::Garments;
    std::string wanted{};

    bool operator==(const ObjectListing&) const = default;
};

struct ObjectsState {
    std::string wanted{};  // words that names must have
    PanelGrouping grouping = PanelGrouping::Garments;
    bool wants_find = false;    // the Find box is to take the keyboard
    bool wants_naming = false;  // the selected panel or seam is to get another name
    RowNaming naming{};
    std::optional<ObjectListing> listing{};
    ObjectTree tree{};           // of this listing
    std::optional<Hover> lit{};  // what the hovered row stands for
};

struct InspectorState {
    BoxState boxes{};
    std::map<std::string, PanelMeasures> panels{};
    std::map<std::string, TypedAngles> angles{};
    MaterialState material{};
    BodyState body{};
    DrapeState drape{};
    ObjectsState objects{};
    LengthMove length_move = LengthMove::End;  // of edges whose length is typed
    std::optional<int> hovered_seam{};         // the seam whose row in the list is hovered
};

struct InspectorContext {
    Workspace& workspace;
    FrameOutput& output;
    InspectorState& state;
    const Theme& theme;
    const Fonts* fonts = nullptr;               // none: use the current font
    WidgetMap* widgets = nullptr;               // receives the positions of the widgets; may be null
    std::function<UiTexture()> take_texture{};  // returns an unused texture number
    bool shows_times = true;                    // what a frame took, which differs from run to run
    std::function<void()> open_body{};          // opens a file dialog for a body; unset: no button is shown
    std::function<void()> open_motion{};        // the same for a motion
    std::function<void()> open_pose{};          // the same for a pose
    std::function<void()> save_pose{};          // opens a file dialog to save the pose of the body
    std::function<void()> open_picture{};       // opens a file dialog for a picture that the panels show; may be unset
    std::function<void()> open_fabric{};        // opens a file dialog for a fabric, which is then shown; may be unset
    std::function<void(const std::string& name)> open_fabric_picture{};  // the same for what its draft shows
    std::function<void(const std::string& name)> save_fabric{};     // writes its draft to its own file; may be unset
    std::function<void(const std::string& name)> save_fabric_as{};  // opens a file dialog to do so; may be unset
    std::function<void()> fit_photo{};        // chooses the tool that fits photos under the sheet; may be unset
    std::function<void()> frame_selection{};  // shows what is selected on the sheet; may be unset
    std::function<void()> show_timeline{};    // shows the timeline of the motion; may be unset
    std::function<std::string(std::string_view action)> key_of{};  // "Ctrl+Z" for an action's id; unset or empty: none

    const sim::Pattern& pattern() const { return workspace.document->pattern(); }
    const Selection& selection() const { return workspace.document->selection(); }
};

// Call once per UI frame, even if no inspector is visible. Records the drape's statistics, takes over a finished body,
// and commits edits of boxes that are no longer drawn.
void update_inspectors(InspectorContext& context);

// Each draws into the current ImGui window from the current cursor position, over the available width; needs at least
// 17 font heights.
void draw_properties(InspectorContext& context);
void draw_seams(InspectorContext& context);
void draw_materials(InspectorContext& context);
void draw_body(InspectorContext& context);
void draw_drape(InspectorContext& context);
void draw_history(InspectorContext& context);
void draw_objects(InspectorContext& context);

}  // namespace selvedge::editor

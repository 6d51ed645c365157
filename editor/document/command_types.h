#pragma once
// The command types (see command.h) and the types that they contain: commands on outlines, on whole panels, on the
// whole pattern and on seams. Metres and radians.
#include <optional>
#include <string>
#include <vector>

#include "editor/document/selection.h"
#include "sim/core/math.h"
#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// An affine map of the sheet: p -> x_axis * p.x + y_axis * p.y + shift.
struct PlaneMap {
    Vec2d x_axis{1, 0};
    Vec2d y_axis{0, 1};
    Vec2d shift{0, 0};  // m

    bool operator==(const PlaneMap&) const = default;
};

// The part of an edge between two fractions of its length.
struct SpanRef {
    std::string panel;
    int edge = 0;
    double from = 0;
    double to = 1;

    bool operator==(const SpanRef&) const = default;
};

// A panel's placement in world space: see Panel.
struct PanelPlacement {
    std::string panel{};
    Vec3d translation = Vec3d::Zero();
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    double wrap_radius = 0;

    bool operator==(const PanelPlacement&) const = default;
};

// Commands that change outlines, internal lines and notches.

struct MoveVertices {
    static constexpr const char* name = "move_vertices";
    std::vector<PartRef> vertices{};
    Vec2d by = Vec2d::Zero();

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("vertices", vertices);
        visit("by", by);
    }
};

// `map` is in sheet coordinates. `what`: the verb of the history label.
struct TransformVertices {
    static constexpr const char* name = "transform_vertices";
    std::vector<PartRef> vertices{};
    PlaneMap map{};
    std::string what = "Transform";

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("vertices", vertices);
        visit("map", map);
        visit("what", what);
    }
};

// Sets the edge's kind and its control points or arc from `curve`; its ends and label stay.
struct SetCurve {
    static constexpr const char* name = "set_curve";
    std::string panel{};
    int edge = 0;
    sim::OutlineEdge curve{};

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panel", panel);
        visit("edge", edge);
        visit("curve", curve);
    }
};

// At the fraction t of the edge's length.
struct AddVertex {
    static constexpr const char* name = "add_vertex";
    std::string panel{};
    int edge = 0;
    double t = 0.5;

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panel", panel);
        visit("edge", edge);
        visit("t", t);
    }
};

struct AddDart {
    static constexpr const char* name = "add_dart";
    std::string panel{};
    int edge = 0;
    double t = 0.5;
    double width = 0.03;
    double depth = 0.1;

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panel", panel);
        visit("edge", edge);
        visit("t", t);
        visit("width", width);
        visit("depth", depth);
    }
};

struct AddInternalLine {
    static constexpr const char* name = "add_internal_line";
    std::string panel{};
    sim::InternalLine line{};

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panel", panel);
        visit("line", line);
    }
};

struct SetInternalLine {
    static constexpr const char* name = "set_internal_line";
    std::string panel{};
    int index = 0;
    sim::InternalLine line{};

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panel", panel);
        visit("index", index);
        visit("line", line);
    }
};

struct AddNotch {
    static constexpr const char* name = "add_notch";
    std::string panel{};
    int edge = 0;
    double t = 0.5;

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panel", panel);
        visit("edge", edge);
        visit("t", t);
    }
};

struct MoveNotch {
    static constexpr const char* name = "move_notch";
    std::string panel{};
    int index = 0;
    int edge = 0;
    double t = 0.5;

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panel", panel);
        visit("index", index);
        visit("edge", edge);
        visit("t", t);
    }
};

// Commands that change whole panels.

// Adds panels under their names; a name in use gets a number. `seams`: between them; a side's panel is a position in
// `panels`.
struct AddPanels {
    static constexpr const char* name = "add_panels";
    std::vector<sim::Panel> panels{};
    std::vector<sim::Seam> seams{};

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panels", panels);
        visit("seams", seams);
    }
};

struct RenamePanel {
    static constexpr const char* name = "rename_panel";
    std::string panel{};
    std::string to{};

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panel", panel);
        visit("to", to);
    }
};

// Copies panels with the seams among them. `shift` is on the sheet, `move` in world space, m. is_linked: what is
// changed on one is changed on both, but for where they lie.
struct DuplicatePanels {
    static constexpr const char* name = "duplicate_panels";
    std::vector<std::string> panels{};
    Vec2d shift = Vec2d::Zero();
    Vec3d move = Vec3d::Zero();
    bool is_linked = false;

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panels", panels);
        visit("shift", shift);
        visit("move", move);
        visit("is_linked", is_linked);
    }
};

// Mirror images for the other side of the body; see symmetric_copies in panel_edit.h.
struct SymmetricCopy {
    static constexpr const char* name = "symmetric_copy";
    std::vector<std::string> panels{};
    bool is_linked = true;
    Vec2d shift = Vec2d::Zero();

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panels", panels);
        visit("is_linked", is_linked);
        visit("shift", shift);
    }
};

// Ends the links of the panel: to the one that it is derived from, of those that are derived from it, and of its
// halves.
struct UnlinkPanel {
    static constexpr const char* name = "unlink_panel";
    std::string panel{};

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panel", panel);
    }
};

// Moves panels on the sheet, m.
struct MovePanels {
    static constexpr const char* name = "move_panels";
    std::vector<std::string> panels{};
    Vec2d by = Vec2d::Zero();

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panels", panels);
        visit("by", by);
    }
};

// Rotates, scales or mirrors panels; `map` is in sheet coordinates. `what`: the verb of the history label.
struct TransformPanels {
    static constexpr const char* name = "transform_panels";
    std::vector<std::string> panels{};
    PlaneMap map{};
    std::string what = "Transform";

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panels", panels);
        visit("map", map);
        visit("what", what);
    }
};

// Sets the panel's placement in world space.
struct PlacePanel {
    static constexpr const char* name = "place_panel";
    std::string panel{};
    Vec3d translation = Vec3d::Zero();
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    double wrap_radius = 0;

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panel", panel);
        visit("translation", translation);
        visit("rotation", rotation);
        visit("wrap_radius", wrap_radius);
    }
};

// Places several panels at once.
struct PlacePanels {
    static constexpr const char* name = "place_panels";
    std::vector<PanelPlacement> places{};

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("places", places);
    }
};

// Sets the grain angle, rad; see Panel::grain_angle.
struct SetGrain {
    static constexpr const char* name = "set_grain";
    std::string panel{};
    double angle = 0;

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panel", panel);
        visit("angle", angle);
    }
};

// Sets the sett offset, m; see Panel::sett_offset.
struct SetSettOffset {
    static constexpr const char* name = "set_sett_offset";
    std::string panel{};
    Vec2d offset = Vec2d::Zero();

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panel", panel);
        visit("offset", offset);
    }
};

struct SetPins {
    static constexpr const char* name = "set_pins";
    std::string panel{};
    std::vector<int> vertices{};

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panel", panel);
        visit("vertices", vertices);
    }
};

struct SetLayer {
    static constexpr const char* name = "set_layer";
    std::string panel{};
    int layer = 0;

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panel", panel);
        visit("layer", layer);
    }
};

struct CutPanel {
    static constexpr const char* name = "cut_panel";
    std::string panel{};
    std::vector<Vec2d> path{};
    bool is_sewn = true;

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panel", panel);
        visit("path", path);
        visit("is_sewn", is_sewn);
    }
};

// Merges the two panels that the seam joins. `stays`: the one of them that stays where it lies; empty: the larger one.
struct MergePanels {
    static constexpr const char* name = "merge_panels";
    int seam = 0;
    std::string stays = {};

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("seam", seam);
        visit("stays", stays);
    }
};

// Unfolds the panel over a straight edge.
struct UnfoldPanel {
    static constexpr const char* name = "unfold_panel";
    std::string panel{};
    int edge = 0;
    bool is_linked = false;  // its halves stay mirror images of each other

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panel", panel);
        visit("edge", edge);
        visit("is_linked", is_linked);
    }
};

// Commands that change the pattern as a whole.

// Puts the garments of a file over those of the pattern (sim/pattern/garments.h). `text` is the file's, with the panels
// placed for the pattern's body.
struct PutOver {
    static constexpr const char* name = "put_over";
    std::string file{};
    std::string text{};

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("file", file);
        visit("text", text);
    }
};

// Removes a garment with its panels and all seams to them.
struct TakeOff {
    static constexpr const char* name = "take_off";
    std::string garment{};

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("garment", garment);
    }
};

// Sets the pattern's name.
struct RenamePattern {
    static constexpr const char* name = "rename_pattern";
    std::string to{};

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("to", to);
    }
};

// `panel` empty: sets the pattern's fabric. `fabric` empty: the default fabric.
struct SetFabric {
    static constexpr const char* name = "set_fabric";
    std::string panel{};
    std::string fabric{};

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panel", panel);
        visit("fabric", fabric);
    }
};

// Whatever is made of one fabric is made of another: the pattern, panels and their interlinings.
struct ReplaceFabric {
    static constexpr const char* name = "replace_fabric";
    std::string from{};
    std::string to{};

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("from", from);
        visit("to", to);
    }
};

// `tartan`: a name or a threadcount; empty: the default. `size` and `position`: see sett_size and sett_position of
// Pattern.
struct SetTartan {
    static constexpr const char* name = "set_tartan";
    std::string tartan{};
    std::optional<double> size{};
    Vec2d position = Vec2d::Zero();

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("tartan", tartan);
        visit("size", size);
        visit("position", position);
    }
};

// Sets the seam allowance, m, of an edge, of a panel (`edge` none) or of the pattern (`panel` empty). `width` none: an
// edge has the panel's, a panel the pattern's; the pattern has 0. `corner`: of an edge only.
struct SetAllowance {
    static constexpr const char* name = "set_allowance";
    std::string panel{};
    std::optional<int> edge{};
    std::optional<double> width{};
    sim::AllowanceCorner corner = sim::AllowanceCorner::Mitred;

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panel", panel);
        visit("edge", edge);
        visit("width", width);
        visit("corner", corner);
    }
};

// Sets what the panel shows; `panel` empty: the pattern. `surface` none: what its fabric, or the tartan, says.
struct SetSurface {
    static constexpr const char* name = "set_surface";
    std::string panel{};
    std::optional<sim::SurfaceDesign> surface{};

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panel", panel);
        visit("surface", surface);
    }
};

// Sets all photos under the sheet. `what`: the label in the history.
struct SetUnderlays {
    static constexpr const char* name = "set_underlays";
    std::vector<sim::Underlay> underlays{};
    std::string what = "Change photo";

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("underlays", underlays);
        visit("what", what);
    }
};

// Sets the body that the panels are placed around, such as mannequin:sex=female,bust=92.
struct SetBody {
    static constexpr const char* name = "set_body";
    std::string body{};
    std::vector<Vec3d> shifts{};  // m, one per panel, to fit the new body; or empty

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("body", body);
        visit("shifts", shifts);
    }
};

// m, edge length of the base mesh; none: the mesher's default.
struct SetEdgeLength {
    static constexpr const char* name = "set_edge_length";
    std::optional<double> length{};

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("length", length);
    }
};

// Sets the panels' sett offsets so that stripes continue across seams.
struct MatchSetts {
    static constexpr const char* name = "match_setts";
    std::vector<int> first_seams{};  // seams matched first

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("first_seams", first_seams);
    }
};

// Moves the whole garment in world space (GT XYZ in the thesis).
struct TranslateAll {
    static constexpr const char* name = "translate_all";
    Vec3d by = Vec3d::Zero();

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("by", by);
    }
};

// Removes all the parts listed; seams by index.
struct RemoveParts {
    static constexpr const char* name = "remove";
    std::vector<std::string> panels{};
    std::vector<PartRef> vertices{};
    std::vector<PartRef> internal_lines{};
    std::vector<PartRef> notches{};
    std::vector<int> seams{};

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panels", panels);
        visit("vertices", vertices);
        visit("internal_lines", internal_lines);
        visit("notches", notches);
        visit("seams", seams);
    }
};

// Commands that change seams. `seam` is an index into Pattern::seams and stands for its whole sewing
// (editor/geometry/sewing.h).

// Sews two whole edges. is_reversed: see Seam.
struct SewEdges {
    static constexpr const char* name = "sew_edges";
    PartRef first{};
    PartRef second{};
    bool is_reversed = true;

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("first", first);
        visit("second", second);
        visit("is_reversed", is_reversed);
    }
};

// Sews runs of parts of edges, one to many; see sew_runs in seam_edit.h.
struct SewRuns {
    static constexpr const char* name = "sew_runs";
    std::vector<SpanRef> first{};
    std::vector<SpanRef> second{};
    bool is_reversed = true;

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("first", first);
        visit("second", second);
        visit("is_reversed", is_reversed);
    }
};

struct ReverseSeam {
    static constexpr const char* name = "reverse_seam";
    int seam = 0;

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("seam", seam);
    }
};

struct NameSeam {
    static constexpr const char* name = "name_seam";
    int seam = 0;
    std::string to{};

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("seam", seam);
        visit("to", to);
    }
};

struct AcceptEase {
    static constexpr const char* name = "accept_ease";
    int seam = 0;
    bool is_eased = true;

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("seam", seam);
        visit("is_eased", is_eased);
    }
};

// Slides one run of the seam's sewing along its outline by `by`, m; see slide_sewing in sewing.h.
struct SlideSewing {
    static constexpr const char* name = "slide_sewing";
    int seam = 0;
    bool is_second = false;
    double by = 0;

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("seam", seam);
        visit("is_second", is_second);
        visit("by", by);
    }
};

// Makes the seam's second side as long as the first.
struct EvenSeam {
    static constexpr const char* name = "even_seam";
    int seam = 0;

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("seam", seam);
    }
};

}  // namespace selvedge::editor

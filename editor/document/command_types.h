#pragma once
// What several commands are made of.
#include <optional>
#include <string>
#include <vector>

#include "editor/document/selection.h"
#include "sim/core/math.h"
#include "sim/pattern/pattern.h"

namespace selvedge::editor {

// A map of the drafting sheet: p -> x_axis p.x + y_axis p.y + shift.
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

// Where a panel stands in the room: see Panel.
struct PanelPlace {
    std::string panel{};
    Vec3d translation = Vec3d::Zero();
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    double wrap_radius = 0;

    bool operator==(const PanelPlace&) const = default;
};

// Commands that change outlines and what lies in them. See command.h.

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

// The map is of the sheet.
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

// Kind, controls and arc of `curve`.
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

// At a fraction of the edge's length.
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

// Commands that change whole panels. See command.h.

// Under their names, or others where those are taken.
struct AddPanels {
    static constexpr const char* name = "add_panels";
    std::vector<sim::Panel> panels{};

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panels", panels);
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

// `shift` on the sheet.
struct DuplicatePanel {
    static constexpr const char* name = "duplicate_panel";
    std::string panel{};
    Vec2d shift = Vec2d::Zero();

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panel", panel);
        visit("shift", shift);
    }
};

// For the body's other side.
struct SymmetricCopy {
    static constexpr const char* name = "symmetric_copy";
    std::string panel{};
    bool is_linked = true;
    Vec2d shift = Vec2d::Zero();

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panel", panel);
        visit("is_linked", is_linked);
        visit("shift", shift);
    }
};

// It and its mirror image go their own ways.
struct UnlinkPanel {
    static constexpr const char* name = "unlink_panel";
    std::string panel{};

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panel", panel);
    }
};

// On the sheet.
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

// Rotates, scales or mirrors; the map is of the sheet. `what`: the word for the history.
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

// In the room.
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

// Several at once.
struct PlacePanels {
    static constexpr const char* name = "place_panels";
    std::vector<PanelPlace> places{};

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("places", places);
    }
};

// rad, see Panel::grain_angle.
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

// m, see Panel::sett_offset.
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

// The two that the seam joins.
struct MergePanels {
    static constexpr const char* name = "merge_panels";
    int seam = 0;

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("seam", seam);
    }
};

// Over a straight edge.
struct UnfoldPanel {
    static constexpr const char* name = "unfold_panel";
    std::string panel{};
    int edge = 0;

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("panel", panel);
        visit("edge", edge);
    }
};

// Commands that change a pattern as a whole. See command.h.

// The pattern's name.
struct RenamePattern {
    static constexpr const char* name = "rename_pattern";
    std::string to{};

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("to", to);
    }
};

// `panel` empty: the whole pattern's; `fabric` empty: the default.
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

// A name or a threadcount; empty: the default. Its size and position: see Pattern.
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

// What the panels are placed for, such as mannequin:sex=female,bust=92.
struct SetBody {
    static constexpr const char* name = "set_body";
    std::string body{};
    std::vector<Vec3d> shifts{};  // m, of each panel, so that it stands about the new body as about the old; or none

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("body", body);
        visit("shifts", shifts);
    }
};

// m, of the base mesh; none: the usual.
struct SetEdgeLength {
    static constexpr const char* name = "set_edge_length";
    std::optional<double> length{};

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("length", length);
    }
};

// Moves the tartan under the panels so that its stripes go on across seams.
struct MatchSetts {
    static constexpr const char* name = "match_setts";
    std::vector<int> first_seams{};  // matched before the others

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("first_seams", first_seams);
    }
};

// The whole garment in the room: the thesis' GT XYZ.
struct TranslateAll {
    static constexpr const char* name = "translate_all";
    Vec3d by = Vec3d::Zero();

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("by", by);
    }
};

// All that is named, seams by index.
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

// Commands that change seams. Seams are named by their index in Pattern::seams. See command.h.

// See Seam::is_reversed.
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

// Parts of edges, one to many.
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

// Makes its second side as long as the first.
struct EvenSeam {
    static constexpr const char* name = "even_seam";
    int seam = 0;

    template <class Visitor>
    void fields(Visitor&& visit) {
        visit("seam", seam);
    }
};

}  // namespace selvedge::editor

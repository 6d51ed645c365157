#pragma once
// Commands that change whole panels. See command.h.
#include <optional>
#include <string>
#include <vector>

#include "editor/document/command_parts.h"
#include "editor/document/selection.h"
#include "sim/pattern/pattern.h"

namespace selvedge {

// Under their names, or others where those are taken.
struct AddPanels {
    static constexpr const char* name = "add_panels";
    std::vector<Panel> panels{};

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

}  // namespace selvedge

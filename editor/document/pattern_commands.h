#pragma once
// Commands that change a pattern as a whole. See command.h.
#include <optional>
#include <string>
#include <vector>

#include "editor/document/command_parts.h"
#include "editor/document/selection.h"
#include "sim/pattern/pattern.h"

namespace selvedge {

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

}  // namespace selvedge

#pragma once
// Commands that change outlines and what lies in them. See command.h.
#include <optional>
#include <string>
#include <vector>

#include "editor/document/command_parts.h"
#include "editor/document/selection.h"
#include "sim/pattern/pattern.h"

namespace selvedge {

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
    OutlineEdge curve{};

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
    InternalLine line{};

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
    InternalLine line{};

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

}  // namespace selvedge

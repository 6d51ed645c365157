#pragma once
// A garment as a person draws it: panels in the plane, seams between runs of their outlines, and where each panel
// stands round a body.  (SPEC 3.1; the file format is patterns/FORMAT.md)
//
// Metres and radians. Every panel is held as seen from its fabric's right side, counter-clockwise: GarmentCode draws
// back panels clockwise, so their material x is mirrored on loading (Panel::is_mirrored) and back on saving.
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/math.h"

namespace selvedge::sim {

enum class CurveKind { Line, Quadratic, Cubic, Arc };

// One edge of an outline, from vertex `start` to vertex `end` of its panel.
struct OutlineEdge {
    int start = 0;
    int end = 0;
    CurveKind kind = CurveKind::Line;
    std::array<Vec2d, 2> control{Vec2d::Zero(), Vec2d::Zero()};  // Bezier control points, panel coordinates, m
    double arc_radius = 0;                                       // Arc only, m
    bool is_large_arc = false;                                   // Arc only
    bool turns_right = false;  // Arc only: in the held (counter-clockwise) frame, seen along the edge
    std::string label = {};

    bool operator==(const OutlineEdge&) const = default;
};

struct InternalLine {
    std::string name;
    std::vector<Vec2d> points;  // panel coordinates, m

    bool operator==(const InternalLine&) const = default;
};

// A mark on the outline that is matched to another's when a seam is sewn.
struct Notch {
    int edge = 0;    // index into Panel::edges
    double t = 0.5;  // 0..1, fraction of the edge's length from its start

    bool operator==(const Notch&) const = default;
};

struct Panel {
    std::string name;
    std::vector<Vec2d> vertices;        // m, held frame
    std::vector<OutlineEdge> edges;     // one chained, counter-clockwise loop: edges[i].end == edges[i+1].start.
                                        // Same order and indices as seams use; see `edge_order` in pattern_file.cpp
    Vec3d translation = Vec3d::Zero();  // m
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  // world = rotation * local + translation
    bool is_mirrored = false;                                // local = (-x, y, 0) instead of (x, y, 0)
    double grain_angle = 0;             // rad, from the panel's +y to the warp, counter-clockwise in the held frame
    Vec2d sett_offset = Vec2d::Zero();  // m, how far the sett is moved under the panel: added to its points, turned to
                                        // the grain, (weft, warp), on the fabric's right side
    std::string fabric;                 // empty: the pattern's
    int layer = 0;                      // higher is further out
    std::vector<int> pins;              // vertices of the outline that do not move
    std::vector<InternalLine> internal_lines;
    std::vector<Notch> notches = {};
    double wrap_radius = 0;  // m; 0: flat, else the panel is bent round an upright of its own, parallel to its y, that
                             // stands so far behind x = 0 on the fabric's wrong side: it starts as part of a cylinder
    std::string mirror_of = {};                // the panel that this one is kept a mirror image of; empty: none
    std::optional<Vec2d> sheet_position = {};  // m, of the panel's origin on the drafting sheet; none: laid out

    // The panel point u (held frame) in the room, m.
    Vec3d place(const Vec2d& u) const;

    bool operator==(const Panel&) const = default;
};

struct SeamSide {
    int panel = 0;
    int edge = 0;  // index into Panel::edges

    auto operator<=>(const SeamSide&) const = default;
};

// Joins two outline edges of the same or of two panels.
// is_reversed: the held start of `first` meets the held end of `second` (both outlines run counter-clockwise, so this
// is how two panels that face the same way join); otherwise start meets start.
struct Seam {
    SeamSide first;
    SeamSide second;
    bool is_reversed = true;
    std::string name = {};  // the pattern's own; empty: see seam_name
    bool is_eased = false;  // sides of different length are meant to be

    bool operator==(const Seam&) const = default;
};

// What the panels' sett offsets were found for.
struct MatchedSett {
    std::string tartan;            // name or threadcount
    Vec2d repeat = Vec2d::Zero();  // m, of the warp and of the weft

    bool operator==(const MatchedSett&) const = default;
};

inline constexpr double kSmallestSett = 0.001, kLargestSett = 5;  // m, of a repeat that is asked for

struct Pattern {
    std::string name;
    std::vector<Panel> panels;
    std::vector<Seam> seams;
    std::string fabric;                            // name of a shipped fabric or file; empty: the default
    std::string tartan;                            // name or threadcount; empty: the default
    std::optional<double> sett_size = {};          // m, of the warp's repeat; none: the tartan's own
    Vec2d sett_position = Vec2d::Zero();           // m, (weft, warp): where the sett begins under all panels
    std::optional<MatchedSett> matched_sett = {};  // none: nobody matched it
    std::string body;             // what the panels were placed for, e.g. "mannequin:sex=female"; empty: GarmentCode's
    double body_height = 1.7199;  // m, stature of that body, feet at y = 0
    std::optional<double> edge_length;  // m, of the base mesh; none: the mesher's usual one

    bool operator==(const Pattern&) const = default;
};

// The panel that a side of a seam lies on. Pre: the pattern has it.
const Panel& panel_of(const Pattern& pattern, const SeamSide& side);

// What a seam is called. Files need not name their seams, so every seam has a name that follows from its edges, in the
// order of its stitch: "front.3+back.1".

// The seam's own name, else the one that follows from its edges.
std::string seam_name(const Pattern& pattern, const Seam& seam);

// The seams (indices into pattern.seams, ascending) that go by a name: their own, that of their edges in either order,
// or the label of one of their edges, which several may share. Empty: none does.
std::vector<int> find_seams(const Pattern& pattern, std::string_view name);

}  // namespace selvedge::sim

#pragma once
// The sewing pattern of a garment: 2D panels, seams between edges of their outlines, and the placement of each panel
// around a body.  (thesis 4.2.1; the file format is patterns/FORMAT.md)
//
// Units are metres and radians. Panel coordinates are in the panel frame (also called held frame): the panel as seen
// from the right side of its fabric, where its outline is counter-clockwise. GarmentCode draws back panels clockwise,
// so their x is mirrored on loading (Panel::is_mirrored) and mirrored back on saving.
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/math.h"
#include "sim/pattern/surface_design.h"

namespace selvedge::sim {

enum class CurveKind { Line, Quadratic, Cubic, Arc };

// How the seam allowance of an edge ends at both of its corners. Mitred: both cut lines go on to where they meet, and a
// sharp corner is cut off. Squared: the cut line ends at a right angle to the edge. Mirrored: it is cut so that the
// allowance, turned over about the edge, covers the panel, as at a hem.
enum class AllowanceCorner { Mitred, Squared, Mirrored };

struct Thread {
    std::string colour = "#FFFFFF";  // #RRGGBB
    double thickness = 0.0004;       // m

    bool operator==(const Thread&) const = default;
};

// Rows of stitches beside a line: an edge, an internal line or a seam. Distances are from the line to its left, which
// is inside along an outline and on the first panel of a seam; negative ones are to its right.
struct Topstitch {
    Vec2d distances{0.006, 0.006};  // m: of the first row from the line, and of each further row from the one before
    int rows = 1;
    double stitch_length = 0.003;  // m
    Thread thread = {};

    bool operator==(const Topstitch&) const = default;
};

// Drawn: the edge was drawn. Image: it is the mirror image of an edge of the half that was unfolded.
enum class EdgeRole { Drawn, Image };

// What an outline edge is known by from one state of a pattern to the next, whatever its index is there. The first part
// of an edge that is split keeps the key, and the second gets a new one; of edges that are joined, the first one's
// stays. A panel that is copied or mirrored has the keys of its source. Functions: sim/pattern/edge_keys.h.
struct EdgeKey {
    int number = 0;  // from 1 on, given once in a panel; 0: not given yet
    EdgeRole role = EdgeRole::Drawn;

    auto operator<=>(const EdgeKey&) const = default;
};

// An elastic that is sewn along an edge, stretched to its length. It pulls with stiffness times its strain; cloth that
// it draws together is gathered.
struct Elastic {
    double share = 0.7;     // of the edge's length that it has at rest
    double stiffness = 30;  // N, its tension per unit of strain

    bool operator==(const Elastic&) const = default;
};

// One edge of an outline, from vertex `start` to vertex `end` of its panel.
struct OutlineEdge {
    int start = 0;
    int end = 0;
    CurveKind kind = CurveKind::Line;
    std::array<Vec2d, 2> control{Vec2d::Zero(), Vec2d::Zero()};  // Bezier control points, panel frame, m
    double arc_radius = 0;                                       // Arc only, m
    bool is_large_arc = false;                                   // Arc only
    bool turns_right = false;  // Arc only: it turns right from start to end, in the panel frame
    std::string label = {};
    std::optional<double> allowance = {};  // m, between this edge and the cut line; none: the panel's
    AllowanceCorner allowance_corner = AllowanceCorner::Mitred;
    std::optional<Topstitch> topstitch = {};
    std::optional<Elastic> elastic = {};
    EdgeKey key = {};

    bool operator==(const OutlineEdge&) const = default;
};

// Fold: the panel is folded here, as a waistband along its middle, or was drawn as one half of it.
enum class LineUse { Mark, Fold };

struct InternalLine {
    std::string name;
    std::vector<Vec2d> points;  // panel frame, m
    LineUse use = LineUse::Mark;
    std::optional<Topstitch> topstitch = {};

    bool operator==(const InternalLine&) const = default;
};

enum class NotchKind { Slit, V, T, Castle, U };

// A mark on the outline that the tailor aligns with a mark on the other panel when sewing a seam.
struct Notch {
    int edge = 0;    // index into Panel::edges
    double t = 0.5;  // 0..1, fraction of the edge's length from its start
    NotchKind kind = NotchKind::Slit;
    int count = 1;  // of notches side by side: two often mark the back

    bool operator==(const Notch&) const = default;
};

// A cone to which a panel is bent without stretching it, as the sector of a disc is for a skirt. It opens downwards, or
// upwards if its sine is negative; its axis is parallel to y, through the apex. The ray along the axis stays in place.
struct WrapCone {
    Vec2d apex = Vec2d::Zero();  // panel frame, m
    double sine = 1;             // of the angle between axis and cloth, 0.01 to 1 or -0.01 to -1; 1: flat

    bool operator==(const WrapCone&) const = default;
};

struct Panel {
    std::string name;
    std::vector<Vec2d> vertices;        // m, panel frame
    std::vector<OutlineEdge> edges;     // one counter-clockwise loop: edges[i].end == edges[i+1].start. Order, indices
                                        // and directions are those of the file, so seams refer to the same edges
    Vec3d translation = Vec3d::Zero();  // m
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  // world = rotation * local + translation
    bool is_mirrored = false;                                // local = (-x, y, 0) instead of (x, y, 0)
    double grain_angle = 0;                      // rad, from the panel's +y to the warp direction, counter-clockwise
    Vec2d sett_offset = Vec2d::Zero();           // m, (weft, warp), seen from the right side: position in the sett =
                                                 // panel point rotated into the yarn directions + sett_offset
    std::string fabric;                          // empty: the pattern's fabric
    std::vector<std::string> interlinings = {};  // fabrics that are fused to it, with the same grain
    int layer = 0;                               // higher: farther from the body, where panels lie on each other
    std::string garment = {};                    // of which this panel is a part; empty: of the one named Pattern::name
    std::vector<int> pins;                       // indices of outline vertices that are pinned
    std::vector<InternalLine> internal_lines;
    std::vector<Notch> notches = {};
    std::vector<Vec2d> drill_points = {};  // m, panel frame: where a hole marks a pocket or the end of a dart
    std::optional<double> allowance = {};  // m, between the outline and the cut line; none: the pattern's
    int pieces = 1;                        // how often the panel is cut
    bool is_worn = true;                   // false: it is cut, but takes no part in the drape, as a pocket or a facing
    double wrap_radius = 0;  // m; 0: the panel starts flat. Otherwise it starts bent to a cylinder of this radius, with
                             // the axis parallel to the panel's y, behind x = 0 on the fabric's wrong side
    std::optional<WrapCone> wrap_cone = {};     // the panel starts bent to this cone; none: flat, or to the cylinder
    std::string mirror_of = {};                 // this panel is kept a mirror image of that panel; empty: of none
    std::string copy_of = {};                   // it is kept a copy of that panel, placed on its own; empty: of none
    int last_key = 0;                           // the last number that its edges were given as a key; 0: none has one
    int fold_key = 0;                           // it was unfolded over the edge with this number, which is no more, and
                                                // its halves are kept mirror images (sim/pattern/halves.h); 0: not so
    std::string label = {};                     // GarmentCode's part of the body: "body", "leg", "arm"; or anything
    std::optional<SurfaceDesign> surface = {};  // what it shows; none: its fabric's or the pattern's
    std::optional<Vec2d> sheet_position = {};   // m, of the panel's origin on the 2D sheet; none: automatic layout

    // The world position, m, of the panel point u (panel frame, m).
    Vec3d place(const Vec2d& u) const;

    bool operator==(const Panel&) const = default;
};

struct SeamSide {
    int panel = 0;
    int edge = 0;  // index into Panel::edges

    auto operator<=>(const SeamSide&) const = default;
};

// Joins two outline edges, of one panel or of two panels.
// is_reversed: the start of `first` is sewn to the end of `second`. Both outlines run counter-clockwise seen from the
// right side, so the right side of one panel continues that of the other. Otherwise start is sewn to start, and the
// right side of one panel continues the wrong side of the other, as at a lapel ("right_wrong" in the file). There is no
// third way: the direction of sewing and the sides that meet determine each other.
struct Seam {
    SeamSide first;
    SeamSide second;
    bool is_reversed = true;
    std::string name = {};    // name in the file; empty: see seam_name()
    bool is_eased = false;    // the sides differ in length on purpose
    std::string sewing = {};  // the 1:N or M:N sewing of which the seam is a part, by name; empty: it stands alone
    std::optional<Topstitch> topstitch = {};

    bool operator==(const Seam&) const = default;
};

// Whether the right side of one panel continues the wrong side of the other.
constexpr bool joins_right_to_wrong(const Seam& seam) {
    return !seam.is_reversed;
}

// The sett for which the panels' sett offsets were computed.
struct MatchedSett {
    std::string tartan;            // name or threadcount
    Vec2d repeat = Vec2d::Zero();  // m, repeat of the warp and of the weft

    bool operator==(const MatchedSett&) const = default;
};

// A photo or scan that lies under the panels on the 2D sheet, to be traced.
struct Underlay {
    std::string file;                // PNG or JPEG: canonical path, or as it was named
    Vec2d position = Vec2d::Zero();  // m, of its centre on the sheet
    double pixel_size = 0.001;       // m, side of one of its pixels
    double rotation = 0;             // rad, counter-clockwise
    double opacity = 0.6;            // 0..1

    bool operator==(const Underlay&) const = default;
};

inline constexpr std::size_t kMostUnderlays = 64;
inline constexpr double kSmallestPixel = 1e-6, kLargestPixel = 1;  // m, of Underlay::pixel_size
inline constexpr std::size_t kMostInterlinings = 16;               // of a panel
inline constexpr int kHighestLayer = 1000;                         // of Panel::layer; the lowest is -kHighestLayer
inline constexpr int kMostPieces = 1000;                           // of Panel::pieces
inline constexpr int kMostKeys = 1'000'000'000;                    // of EdgeKey::number
inline constexpr int kMostNotchesTogether = 9;                     // of Notch::count
inline constexpr double kWidestAllowance = 0.5;                    // m
inline constexpr double kSmallestSett = 0.001, kLargestSett = 5;   // m, accepted range of Pattern::sett_size

struct Pattern {
    std::string name;
    std::vector<Panel> panels;
    std::vector<Seam> seams;
    std::string fabric;                            // name of a shipped fabric, or file; empty: the default
    std::string tartan;                            // name or threadcount; empty: the default
    std::optional<double> sett_size = {};          // m, warp repeat; none: the size in the tartan
    Vec2d sett_position = Vec2d::Zero();           // m, (weft, warp): origin of the sett, for all panels
    std::optional<SurfaceDesign> surface = {};     // of all panels without their own; none: the tartan
    std::optional<MatchedSett> matched_sett = {};  // none: the sett was not matched
    std::string body;             // of this placement: "mannequin:sex=female", or the canonical path of a file, in
                                  // whose own frame the panels are placed; empty: GarmentCode's
    double body_height = 1.7199;  // m, stature of that body, feet at y = 0
    std::optional<double> edge_length;  // m, of the base mesh; none: the mesher's default
    double allowance = 0;               // m, between outlines and cut lines
    std::vector<Underlay> underlays = {};
    std::string size = {};  // for which it was drafted: "40", "M"; empty: not named

    bool operator==(const Pattern&) const = default;
};

// Whether the text, as in Pattern::body, names a file and not a mannequin.
bool is_body_file(std::string_view body);

// The panel that a side of a seam lies on. Pre: the pattern has it.
const Panel& panel_of(const Pattern& pattern, const SeamSide& side);

// The seam's name: Seam::name, or if that is empty a name made of its two edges, first side first: "front.3+back.1".
std::string seam_name(const Pattern& pattern, const Seam& seam);

// A name for a sewing (Seam::sewing) that the pattern does not use yet.
std::string free_sewing_name(const Pattern& pattern);

// The seams (indices into pattern.seams, ascending) with this name. The name can be Seam::name, the name made of the
// two edges in either order, or the label of one of the edges; several seams can share a label.
std::vector<int> find_seams(const Pattern& pattern, std::string_view name);

}  // namespace selvedge::sim

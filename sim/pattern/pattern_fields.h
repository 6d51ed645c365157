#pragma once
// The fields of a pattern's parts, one list for each part. A field that is added to a part is added here as well, or
// the program does not compile; what follows the lists, from files to undo, then knows it.
//
// The order is that in which garment files get new keys.
#include "sim/pattern/fault.h"
#include "sim/pattern/field.h"
#include "sim/pattern/limits.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

inline constexpr Range kAllowanceRange{0, kWidestAllowance, "an allowance is from 0 to 50 cm"};

inline constexpr std::tuple kThreadFields{
    Field<&Thread::colour>{
        .name = "colour", .measure = Measure::Colour, .row = {"Thread", "The colour of the sewing thread."}},
    Field<&Thread::thickness>{.name = "thickness",
                              .measure = Measure::SmallLength,
                              .range = {0.0001, 0.003, "a thread is 0.1 to 3 mm thick"},
                              .row = {"Thickness", "Of the sewing thread."}},
};

inline constexpr std::tuple kTopstitchFields{
    Field<&Topstitch::distances>{
        .name = "distances",
        .measure = Measure::LeftOfLine,
        .range = {-0.1, 0.1, "a row of stitches is at most 10 cm from its line or the row before"},
        .row = {"Distances", "Of the first row from the line, and of each further row from the one before."}},
    Field<&Topstitch::rows>{.name = "rows", .range = {1, 9}, .row = {"Rows", "How many rows of stitches."}},
    Field<&Topstitch::stitch_length>{.name = "stitch_length",
                                     .measure = Measure::SmallLength,
                                     .range = {0.0005, 0.02, "a stitch is 0.5 to 20 mm long"},
                                     .row = {"Stitch length", "Of one stitch."}},
    Field<&Topstitch::thread>{.name = "thread", .row = {"Thread", "The sewing thread."}},
};

inline constexpr FieldRow kTopstitchRow{"Topstitch", "Rows of stitches beside the line."};

inline constexpr std::tuple kKeyFields{
    Field<&EdgeKey::number, FileForm::ByHand>{.name = "number", .range = {0, kMostKeys}},
    Field<&EdgeKey::role, FileForm::ByHand>{.name = "role"},
};

inline constexpr std::tuple kElasticFields{
    Field<&Elastic::share>{.name = "share",
                           .range = {0.2, 1, "an elastic is 0.2 to 1 times as long as its edge"},
                           .row = {"Share", "Its length at rest, as a share of the edge's."}},
    Field<&Elastic::stiffness>{.name = "stiffness",
                               .range = {0.1, 1000, "an elastic pulls with 0.1 to 1000 N per unit of strain"},
                               .row = {"Stiffness", "N per unit of strain."}},
};

inline constexpr std::tuple kEdgeFields{
    Field<&OutlineEdge::start, FileForm::ByHand>{
        .name = "start", .measure = Measure::VertexIndex, .descent = Descent::Shape},
    Field<&OutlineEdge::end, FileForm::ByHand>{
        .name = "end", .measure = Measure::VertexIndex, .descent = Descent::Shape},
    Field<&OutlineEdge::kind, FileForm::ByHand>{.name = "kind", .descent = Descent::Shape},
    Field<&OutlineEdge::control, FileForm::ByHand>{
        .name = "control", .measure = Measure::Point, .descent = Descent::Shape},
    Field<&OutlineEdge::arc_radius, FileForm::ByHand>{
        .name = "radius", .measure = Measure::Length, .descent = Descent::Shape},
    Field<&OutlineEdge::is_large_arc, FileForm::ByHand>{
        .name = "is_large_arc", .journal = "is_large", .descent = Descent::Shape},
    Field<&OutlineEdge::turns_right, FileForm::ByHand>{.name = "turns_right", .descent = Descent::Shape},
    Field<&OutlineEdge::label, FileForm::ByHand>{.name = "label"},
    Field<&OutlineEdge::allowance>{.name = "allowance",
                                   .measure = Measure::Length,
                                   .range = kAllowanceRange,
                                   .row = {"Allowance", "Between this edge and the cut line. Empty: the panel's."}},
    Field<&OutlineEdge::allowance_corner>{
        .name = "allowance_corner",
        .row = {"Its corners",
                "Mitred: both cut lines go on to where they meet. Squared: at a right angle to the edge. Mirrored: "
                "turned up, the allowance covers the panel, as at a hem."}},
    Field<&OutlineEdge::topstitch>{.name = "topstitch", .record = "topstitch", .row = kTopstitchRow},
    Field<&OutlineEdge::elastic>{
        .name = "elastic", .record = "elastic", .row = {"Elastic", "A band along the edge that draws it together."}},
    Field<&OutlineEdge::key, FileForm::ByHand>{.name = "key", .descent = Descent::Key, .is_in_python = false},
};

inline constexpr std::tuple kLineFields{
    Field<&InternalLine::name>{.name = "name", .row = {"Name", "What the line is called.", "unnamed"}},
    Field<&InternalLine::use>{.name = "use", .row = {"Use", "Mark: drawn only. Fold: the panel is folded here."}},
    Field<&InternalLine::points, FileForm::Required>{
        .name = "points", .measure = Measure::Point, .descent = Descent::Place, .least_count = 2},
    Field<&InternalLine::topstitch>{.name = "topstitch", .record = "topstitch", .row = kTopstitchRow},
};

inline constexpr std::tuple kNotchFields{
    Field<&Notch::edge, FileForm::Required>{.name = "edge", .measure = Measure::EdgeIndex, .descent = Descent::Place},
    Field<&Notch::t, FileForm::Required>{.name = "at",
                                         .measure = Measure::EdgeShare,
                                         .range = {0, 1, "a notch lies from 0 to 1 along its edge"},
                                         .descent = Descent::Place},
    Field<&Notch::kind>{.name = "kind", .journal = "notch_kind", .row = {"Kind", "The form of the cut."}},
    Field<&Notch::count>{.name = "count",
                         .range = {1, kMostNotchesTogether},
                         .row = {"Count", "Of notches side by side: two often mark the back."}},
};

inline constexpr std::tuple kConeFields{
    Field<&WrapCone::apex, FileForm::Required>{.name = "apex", .measure = Measure::Point},
    Field<&WrapCone::sine, FileForm::Required>{.name = "sine"},
};

inline constexpr std::tuple kDesignFields{
    Field<&SurfaceDesign::kind, FileForm::ByHand>{.name = "kind", .journal = "design_kind"},
    Field<&SurfaceDesign::source, FileForm::ByHand>{.name = "source"},
    Field<&SurfaceDesign::size, FileForm::ByHand>{.name = "size", .measure = Measure::Length},
    Field<&SurfaceDesign::position, FileForm::ByHand>{.name = "position", .measure = Measure::Length},
    Field<&SurfaceDesign::rotation, FileForm::ByHand>{.name = "rotation", .measure = Measure::Angle},
    Field<&SurfaceDesign::is_repeated, FileForm::ByHand>{.name = "repeats"},
    Field<&SurfaceDesign::ground, FileForm::ByHand>{.name = "ground", .measure = Measure::Colour},
};

inline constexpr std::tuple kUnderlayFields{
    Field<&Underlay::file, FileForm::ByHand>{.name = "file", .measure = Measure::File},
    Field<&Underlay::position, FileForm::ByHand>{.name = "position", .measure = Measure::Length},
    Field<&Underlay::pixel_size, FileForm::ByHand>{.name = "pixel_size", .measure = Measure::Length},
    Field<&Underlay::rotation, FileForm::ByHand>{.name = "rotation", .measure = Measure::Angle},
    Field<&Underlay::opacity, FileForm::ByHand>{.name = "opacity"},
};

inline constexpr std::tuple kPanelFields{
    Field<&Panel::name, FileForm::ByHand>{.name = "name", .descent = Descent::Own},
    Field<&Panel::vertices, FileForm::ByHand>{.name = "vertices", .measure = Measure::Point, .descent = Descent::Shape},
    Field<&Panel::edges, FileForm::ByHand>{.name = "edges", .descent = Descent::Shape},
    Field<&Panel::translation, FileForm::ByHand>{
        .name = "translation", .measure = Measure::Length, .placing = Placing::OnBody},
    Field<&Panel::rotation, FileForm::ByHand>{.name = "rotation", .placing = Placing::OnBody},
    Field<&Panel::is_mirrored, FileForm::None>{.name = "is_mirrored", .placing = Placing::Side},
    Field<&Panel::label, FileForm::ByHand>{.name = "label"},
    Field<&Panel::grain_angle>{
        .name = "grain_angle",
        .key = "grainline",
        .measure = Measure::Direction,
        .row = {"Grain", "From the panel's upward direction to the warp, counter-clockwise. 45: cut on the bias."}},
    Field<&Panel::sett_offset>{.name = "sett_offset", .measure = Measure::ClothShift, .placing = Placing::OnCloth},
    Field<&Panel::fabric>{.name = "fabric", .measure = Measure::Fabric},
    Field<&Panel::interlinings, FileForm::ByHand>{.name = "interlinings", .measure = Measure::Fabric},
    Field<&Panel::surface, FileForm::ByHand>{.name = "surface", .is_in_python = false},
    Field<&Panel::layer>{
        .name = "layer",
        .range = {-kHighestLayer, kHighestLayer, "a layer is a whole number from -1000 to 1000"},
        .placing = Placing::Layer,
        .row = {"Layer", "Higher layers lie further out."},
    },
    Field<&Panel::garment>{.name = "garment"},
    Field<&Panel::pins>{.name = "pins", .measure = Measure::VertexIndex},
    Field<&Panel::internal_lines>{.name = "internal_lines", .descent = Descent::Gathered},
    Field<&Panel::notches>{.name = "notches"},
    Field<&Panel::wrap_radius>{.name = "wrap_radius",
                               .measure = Measure::Length,
                               .range = {0, kMaxCoordinate, "wrap_radius must not be negative"},
                               .placing = Placing::OnBody},
    Field<&Panel::wrap_cone, FileForm::ByHand>{.name = "wrap_cone", .is_in_python = false, .placing = Placing::OnBody},
    Field<&Panel::mirror_of, FileForm::ByHand>{.name = "mirror_of", .descent = Descent::Own},
    Field<&Panel::copy_of, FileForm::ByHand>{.name = "copy_of", .descent = Descent::Own},
    Field<&Panel::last_key, FileForm::ByHand>{.name = "last_key",
                                              .key = "edge_keys",
                                              .range = {0, kMostKeys},
                                              .descent = Descent::Key,
                                              .is_in_python = false},
    Field<&Panel::fold_key, FileForm::ByHand>{
        .name = "fold_key", .range = {0, kMostKeys - 1}, .descent = Descent::Key, .is_in_python = false},
    Field<&Panel::sheet_position>{.name = "sheet_position", .measure = Measure::Length, .descent = Descent::Own},
    Field<&Panel::allowance>{.name = "allowance",
                             .measure = Measure::Length,
                             .range = kAllowanceRange,
                             .row = {"Allowance", "Between the outline and the cut line. Empty: the garment's."}},
    Field<&Panel::pieces>{
        .name = "pieces", .range = {1, kMostPieces}, .row = {"Pieces", "How often the panel is cut."}},
    Field<&Panel::is_worn>{.name = "is_worn",
                           .key = "worn",
                           .row = {"Worn", "Takes part in the drape. A pocket or a facing is only cut."}},
    Field<&Panel::drill_points>{.name = "drill_points", .measure = Measure::Point, .descent = Descent::Gathered},
};

inline constexpr std::tuple kSideFields{
    Field<&SeamSide::panel, FileForm::ByHand>{.name = "panel"},
    Field<&SeamSide::edge, FileForm::ByHand>{.name = "edge", .measure = Measure::EdgeIndex},
};

inline constexpr std::tuple kSeamFields{
    Field<&Seam::first, FileForm::ByHand>{.name = "first", .descent = Descent::Shape},
    Field<&Seam::second, FileForm::ByHand>{.name = "second", .descent = Descent::Shape},
    Field<&Seam::is_reversed, FileForm::ByHand>{.name = "is_reversed", .descent = Descent::Shape},
    Field<&Seam::name, FileForm::ByHand>{.name = "name", .key = "seam_names", .descent = Descent::Own},
    Field<&Seam::is_eased, FileForm::ByHand>{.name = "is_eased", .key = "eased"},
    Field<&Seam::sewing, FileForm::ByHand>{.name = "sewing", .key = "sewings", .descent = Descent::Own},
    Field<&Seam::topstitch>{.name = "topstitch", .record = "topstitch", .row = kTopstitchRow},
};

inline constexpr std::tuple kMatchedFields{
    Field<&MatchedSett::tartan, FileForm::ByHand>{.name = "tartan"},
    Field<&MatchedSett::repeat, FileForm::ByHand>{.name = "repeat", .measure = Measure::Length},
};

inline constexpr std::tuple kPatternFields{
    Field<&Pattern::name, FileForm::None>{.name = "name"},
    Field<&Pattern::panels, FileForm::ByHand>{.name = "panels"},
    Field<&Pattern::fabric>{.name = "fabric", .measure = Measure::Fabric},
    Field<&Pattern::tartan>{.name = "tartan"},
    Field<&Pattern::sett_size>{
        .name = "sett_size",
        .measure = Measure::Length,
        .range = {kSmallestSett, kLargestSett, "# is no size of a sett's repeat: 0.1 to 500 cm are"}},
    Field<&Pattern::sett_position>{.name = "sett_position", .measure = Measure::ClothShift},
    Field<&Pattern::surface, FileForm::ByHand>{.name = "surface", .is_in_python = false},
    Field<&Pattern::matched_sett, FileForm::ByHand>{.name = "matched_sett", .is_in_python = false},
    Field<&Pattern::seams, FileForm::ByHand>{.name = "seams"},
    Field<&Pattern::body, FileForm::ByHand>{.name = "body"},
    Field<&Pattern::underlays, FileForm::ByHand>{.name = "underlays", .is_in_python = false},
    Field<&Pattern::body_height>{
        .name = "body_height",
        .measure = Measure::Length,
        .range = {kLeastBodyHeight, kGreatestBodyHeight, "# is not a body height: 30 to 300 cm"}},
    Field<&Pattern::allowance>{.name = "allowance",
                               .measure = Measure::Length,
                               .range = kAllowanceRange,
                               .row = {"Allowance", "Seam allowance of all panels that have none of their own."}},
    Field<&Pattern::size>{.name = "size"},
    Field<&Pattern::edge_length>{
        .name = "edge_length",
        .measure = Measure::Length,
        .range = {kShortestMeshEdge, kLongestMeshEdge, "# is no edge length of a mesh: 0.5 to 30 cm are"},
        .row = {"Mesh edges", "How far points of the coarsest mesh lie apart. Empty: 5 cm."}},
};

// The one description of each part: fields(&part), or for_each_field<Part>() and visit_fields(part).
constexpr const auto& fields(const Thread*) {
    return kThreadFields;
}
constexpr const auto& fields(const Topstitch*) {
    return kTopstitchFields;
}
constexpr const auto& fields(const EdgeKey*) {
    return kKeyFields;
}
constexpr const auto& fields(const Elastic*) {
    return kElasticFields;
}
constexpr const auto& fields(const OutlineEdge*) {
    return kEdgeFields;
}
constexpr const auto& fields(const InternalLine*) {
    return kLineFields;
}
constexpr const auto& fields(const Notch*) {
    return kNotchFields;
}
constexpr const auto& fields(const WrapCone*) {
    return kConeFields;
}
constexpr const auto& fields(const SurfaceDesign*) {
    return kDesignFields;
}
constexpr const auto& fields(const Underlay*) {
    return kUnderlayFields;
}
constexpr const auto& fields(const SeamSide*) {
    return kSideFields;
}
constexpr const auto& fields(const Panel*) {
    return kPanelFields;
}
constexpr const auto& fields(const Seam*) {
    return kSeamFields;
}
constexpr const auto& fields(const MatchedSett*) {
    return kMatchedFields;
}
constexpr const auto& fields(const Pattern*) {
    return kPatternFields;
}

// Each names as many members as its struct has, or it does not compile: so none is missing above.
inline auto members(const Thread& part) {
    const auto& [a, b] = part;
    return counted(a, b);
}
inline auto members(const Topstitch& part) {
    const auto& [a, b, c, d] = part;
    return counted(a, b, c, d);
}
inline auto members(const EdgeKey& part) {
    const auto& [a, b] = part;
    return counted(a, b);
}
inline auto members(const Elastic& part) {
    const auto& [a, b] = part;
    return counted(a, b);
}
inline auto members(const OutlineEdge& part) {
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = part;
    return counted(a, b, c, d, e, f, g, h, i, j, k, l, m);
}
inline auto members(const InternalLine& part) {
    const auto& [a, b, c, d] = part;
    return counted(a, b, c, d);
}
inline auto members(const Notch& part) {
    const auto& [a, b, c, d] = part;
    return counted(a, b, c, d);
}
inline auto members(const WrapCone& part) {
    const auto& [a, b] = part;
    return counted(a, b);
}
inline auto members(const SurfaceDesign& part) {
    const auto& [a, b, c, d, e, f, g] = part;
    return counted(a, b, c, d, e, f, g);
}
inline auto members(const Underlay& part) {
    const auto& [a, b, c, d, e] = part;
    return counted(a, b, c, d, e);
}
inline auto members(const SeamSide& part) {
    const auto& [a, b] = part;
    return counted(a, b);
}
inline auto members(const Panel& part) {
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z, a2, b2] = part;
    return counted(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z, a2, b2);
}
inline auto members(const Seam& part) {
    const auto& [a, b, c, d, e, f, g] = part;
    return counted(a, b, c, d, e, f, g);
}
inline auto members(const MatchedSett& part) {
    const auto& [a, b] = part;
    return counted(a, b);
}
inline auto members(const Pattern& part) {
    const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o] = part;
    return counted(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o);
}

template <class Part>
inline constexpr bool describes_all = decltype(members(std::declval<const Part&>()))::size() ==
                                      std::tuple_size_v<std::remove_cvref_t<decltype(fields_of<Part>())>>;
static_assert(describes_all<Thread> && describes_all<Topstitch> && describes_all<EdgeKey> && describes_all<Elastic> &&
              describes_all<OutlineEdge> && describes_all<InternalLine> && describes_all<Notch> &&
              describes_all<WrapCone> && describes_all<SurfaceDesign> && describes_all<Underlay> &&
              describes_all<MatchedSett> && describes_all<SeamSide> && describes_all<Panel> && describes_all<Seam> &&
              describes_all<Pattern>);

}  // namespace selvedge::sim

#include "editor/document/command.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <type_traits>
#include <utility>

#include "sim/pattern/enum_names.h"

namespace selvedge::editor {
namespace {

std::string counted(const std::string& verb, std::size_t count, const std::string& one) {
    if (count == 1) return verb + " " + one;
    return verb + " " + std::to_string(count) + " " + (one.ends_with("ch") ? one + "es" : one + "s");
}

std::string label(const PutOver&) {
    return "Wear over";
}
std::string label(const TakeOff& command) {
    return "Take off '" + command.garment + "'";
}
std::string label(const RenamePattern&) {
    return "Rename the garment";
}
std::string label(const SetFabric&) {
    return "Change fabric";
}
std::string label(const ReplaceFabric&) {
    return "Replace fabric";
}
std::string label(const SetTartan&) {
    return "Change tartan";
}
std::string label(const SetUnderlays& command) {
    return command.what;
}
std::string label(const SetAllowance&) {
    return "Change allowance";
}
std::string label(const SetSurface&) {
    return "Change surface";
}
std::string label(const SetBody&) {
    return "Change body";
}
std::string label(const SetEdgeLength&) {
    return "Change mesh size";
}
std::string label(const MatchSetts&) {
    return "Match at seams";
}
std::string label(const TranslateAll&) {
    return "Move the garment";
}
std::string label(const RemoveParts& command) {
    const std::size_t others = command.internal_lines.size() + command.notches.size() + command.seams.size();
    if (!command.panels.empty()) return counted("Delete", command.panels.size(), "panel");
    if (!command.vertices.empty()) return counted("Delete", command.vertices.size(), "point");
    if (others == command.seams.size()) return counted("Delete", others, "seam");
    if (others == command.notches.size()) return counted("Delete", others, "notch");
    return "Delete";
}
std::string label(const AddPanels& command) {
    return counted("Add", command.panels.size(), "panel");
}
std::string label(const RenamePanel&) {
    return "Rename panel";
}
std::string label(const DuplicatePanels& command) {
    return counted("Duplicate", command.panels.size(), "panel");
}
std::string label(const SymmetricCopy& command) {
    return counted("Mirror", command.panels.size(), "panel");
}
std::string label(const UnlinkPanel&) {
    return "Unlink panel";
}
std::string label(const MovePanels& command) {
    return counted("Move", command.panels.size(), "panel");
}
std::string label(const TransformPanels& command) {
    return counted(command.what, command.panels.size(), "panel");
}
std::string label(const PlacePanel&) {
    return "Place panel";
}
std::string label(const PlacePanels& command) {
    return counted("Place", command.places.size(), "panel");
}
std::string label(const SetGrain&) {
    return "Turn grain";
}
std::string label(const SetSettOffset&) {
    return "Move sett";
}
std::string label(const SetPins&) {
    return "Pin points";
}
std::string label(const SetLayer&) {
    return "Change layer";
}
std::string label(const CutPanel&) {
    return "Cut panel";
}
std::string label(const MergePanels&) {
    return "Merge panels";
}
std::string label(const UnfoldPanel&) {
    return "Unfold panel";
}
std::string label(const MoveVertices& command) {
    return counted("Move", command.vertices.size(), "point");
}
std::string label(const TransformVertices& command) {
    return counted(command.what, command.vertices.size(), "point");
}
std::string label(const SetCurve&) {
    return "Bend edge";
}
std::string label(const AddVertex&) {
    return "Add point";
}
std::string label(const AddDart&) {
    return "Add dart";
}
std::string label(const AddInternalLine&) {
    return "Add internal line";
}
std::string label(const SetInternalLine&) {
    return "Change internal line";
}
std::string label(const AddNotch&) {
    return "Add notch";
}
std::string label(const MoveNotch&) {
    return "Move notch";
}
std::string label(const SewEdges&) {
    return "Sew";
}
std::string label(const SewRuns&) {
    return "Sew freely";
}
std::string label(const ReverseSeam&) {
    return "Reverse seam";
}
std::string label(const NameSeam&) {
    return "Name seam";
}
std::string label(const AcceptEase&) {
    return "Accept ease";
}
std::string label(const SlideSewing&) {
    return "Slide seam";
}
std::string label(const EvenSeam&) {
    return "Even seam";
}

}  // namespace

SetUnderlays set_underlay(const sim::Pattern& pattern, std::size_t index, const sim::Underlay& changed,
                          const std::string& what) {
    SetUnderlays command{.underlays = pattern.underlays, .what = what};
    command.underlays[index] = changed;
    return command;
}

std::string label_of(const Command& command) {
    return std::visit([](const auto& given) { return label(given); }, command);
}

namespace {

constexpr double kMaxCoordinate = 1000;  // m or rad, limit of all numbers in commands

// Types with fields. Numbers, strings, Eigen vectors and std::vector are not aggregates.
template <class T>
concept Record = std::is_aggregate_v<T>;

// The fields of the types that commands contain, in the form of a command's own `fields`.
template <class Visitor>
void visit_fields(PartRef& part, Visitor&& visit) {
    visit("panel", part.panel);
    visit("index", part.index);
}

template <class Visitor>
void visit_fields(SpanRef& span, Visitor&& visit) {
    visit("panel", span.panel);
    visit("edge", span.edge);
    visit("from", span.from);
    visit("to", span.to);
}

template <class Visitor>
void visit_fields(PanelPlacement& place, Visitor&& visit) {
    visit("panel", place.panel);
    visit("translation", place.translation);
    visit("rotation", place.rotation);
    visit("wrap_radius", place.wrap_radius);
}

template <class Visitor>
void visit_fields(PlaneMap& map, Visitor&& visit) {
    visit("x_axis", map.x_axis);
    visit("y_axis", map.y_axis);
    visit("shift", map.shift);
}

template <class Visitor>
void visit_fields(sim::OutlineEdge& edge, Visitor&& visit) {
    visit("start", edge.start);
    visit("end", edge.end);
    visit("kind", edge.kind);
    visit("control", edge.control[0]);
    visit("control_2", edge.control[1]);
    visit("radius", edge.arc_radius);
    visit("is_large", edge.is_large_arc);
    visit("turns_right", edge.turns_right);
    visit("label", edge.label);
    visit("allowance", edge.allowance);
    visit("allowance_corner", edge.allowance_corner);
}

template <class Visitor>
void visit_fields(sim::Underlay& underlay, Visitor&& visit) {
    visit("file", underlay.file);
    visit("position", underlay.position);
    visit("pixel_size", underlay.pixel_size);
    visit("rotation", underlay.rotation);
    visit("opacity", underlay.opacity);
}

template <class Visitor>
void visit_fields(sim::SurfaceDesign& design, Visitor&& visit) {
    visit("design_kind", design.kind);
    visit("source", design.source);
    visit("size", design.size);
    visit("position", design.position);
    visit("rotation", design.rotation);
    visit("repeats", design.is_repeated);
    visit("ground", design.ground);
}

template <class Visitor>
void visit_fields(sim::SeamSide& side, Visitor&& visit) {
    visit("panel", side.panel);
    visit("edge", side.edge);
}

template <class Visitor>
void visit_fields(sim::Seam& seam, Visitor&& visit) {
    visit("first", seam.first);
    visit("second", seam.second);
    visit("is_reversed", seam.is_reversed);
    visit("name", seam.name);
    visit("is_eased", seam.is_eased);
    visit("sewing", seam.sewing);
}

template <class Visitor>
void visit_fields(sim::WrapCone& cone, Visitor&& visit) {
    visit("apex", cone.apex);
    visit("sine", cone.sine);
}

template <class Visitor>
void visit_fields(sim::InternalLine& line, Visitor&& visit) {
    visit("name", line.name);
    visit("points", line.points);
    visit("use", line.use);
}

template <class Visitor>
void visit_fields(sim::Notch& notch, Visitor&& visit) {
    visit("edge", notch.edge);
    visit("at", notch.t);
    visit("notch_kind", notch.kind);
    visit("count", notch.count);
}

template <class Visitor>
void visit_fields(sim::Panel& panel, Visitor&& visit) {
    visit("name", panel.name);
    visit("vertices", panel.vertices);
    visit("edges", panel.edges);
    visit("translation", panel.translation);
    visit("rotation", panel.rotation);
    visit("is_mirrored", panel.is_mirrored);
    visit("grain_angle", panel.grain_angle);
    visit("sett_offset", panel.sett_offset);
    visit("fabric", panel.fabric);
    visit("interlinings", panel.interlinings);
    visit("layer", panel.layer);
    visit("garment", panel.garment);
    visit("label", panel.label);
    visit("pins", panel.pins);
    visit("internal_lines", panel.internal_lines);
    visit("notches", panel.notches);
    visit("drill_points", panel.drill_points);
    visit("allowance", panel.allowance);
    visit("pieces", panel.pieces);
    visit("is_worn", panel.is_worn);
    visit("wrap_radius", panel.wrap_radius);
    visit("wrap_cone", panel.wrap_cone);
    visit("mirror_of", panel.mirror_of);
    visit("surface", panel.surface);
    visit("sheet_position", panel.sheet_position);
}

template <class T>
requires requires {
    T::name;
}
void visit_fields(T& command, auto&& visit) {
    command.fields(visit);
}

template <class Vector>
sim::Json numbers_json(const Vector& v) {
    sim::Json list = sim::Json::array();
    for (Eigen::Index i = 0; i < v.size(); ++i) list.push_back(sim::Json(v.data()[i]));
    return list;
}

sim::Json encode(bool value) {
    return sim::Json(value);
}
sim::Json encode(int value) {
    return sim::Json(value);
}
sim::Json encode(double value) {
    return sim::Json(value);
}
sim::Json encode(const std::string& value) {
    return sim::Json(value);
}
sim::Json encode(const Vec2d& value) {
    return numbers_json(value);
}
sim::Json encode(const Vec3d& value) {
    return numbers_json(value);
}
sim::Json encode(const Eigen::Matrix3d& value) {
    return numbers_json(value);
}  // column by column
template <class T>
requires std::is_enum_v<T> sim::Json encode(T value) {
    return sim::Json(sim::name_of_value(value));
}

template <Record T>
sim::Json encode(const T& value);

template <class T>
sim::Json encode(const std::optional<T>& value) {
    return value ? encode(*value) : sim::Json();
}

template <class T>
sim::Json encode_fields(const T& value);
template <class T>
sim::Json encode(const std::vector<T>& values);

template <Record T>
sim::Json encode(const T& value) {
    return encode_fields(value);
}

template <class T>
sim::Json encode(const std::vector<T>& values) {
    sim::Json list = sim::Json::array();
    for (const T& value : values) list.push_back(encode(value));
    return list;
}

template <class T>
sim::Json all_fields(T value) {
    sim::Json object = sim::Json::object();
    visit_fields(value, [&](const char* key, const auto& field) { object[key] = encode(field); });
    return object;
}

// Without fields that have their default value.
template <class T>
sim::Json encode_fields(const T& value) {
    sim::Json object = all_fields(value);
    const sim::Json usual = all_fields(T{});
    std::erase_if(object.members(), [&](const sim::Json::Member& member) {
        return write_json(member.value, -1) == write_json(*usual.find(member.key), -1);
    });
    return object;
}

template <class T>
void decode(const sim::JsonView& view, std::vector<T>& values);
template <class T>
void decode(const sim::JsonView& view, std::optional<T>& value);
template <Record T>
void decode(const sim::JsonView& view, T& value);

void decode(const sim::JsonView& view, bool& value) {
    value = view.boolean();
}
void decode(const sim::JsonView& view, int& value) {
    value = view.integer();
}
void decode(const sim::JsonView& view, double& value) {
    value = view.number_between(-kMaxCoordinate, kMaxCoordinate);
}
void decode(const sim::JsonView& view, std::string& value) {
    value = view.string();
}

template <class Scalar, int rows, int columns>
void decode(const sim::JsonView& view, Eigen::Matrix<Scalar, rows, columns>& value) {
    constexpr std::size_t count = static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
    if (view.size() != count) view.fail(std::to_string(count) + " numbers should be here");
    for (std::size_t i = 0; i < count; ++i) decode(view.at(i), value.data()[i]);
}

template <class T>
requires std::is_enum_v<T>
void decode(const sim::JsonView& view, T& value) {
    std::string known;
    constexpr auto names = names_of(T{});
    for (std::size_t i = 0; i < names.texts.size(); ++i) {
        if (view.string() == names.texts[i]) {
            value = static_cast<T>(i);
            return;
        }
        known += (known.empty() ? "" : ", ") + std::string(names.texts[i]);
    }
    view.fail("'" + view.string() + "' is none of " + known);
}

template <class T>
void decode(const sim::JsonView& view, std::optional<T>& value) {
    value.reset();
    if (!view.value().is_null()) decode(view, value.emplace());
}

template <Record T>
void decode(const sim::JsonView& view, T& value) {
    for (const std::string& key : view.keys()) {
        bool is_known = false;
        visit_fields(value, [&](const char* field, const auto&) { is_known = is_known || key == field; });
        if (!is_known) view.at(key).fail("there is no such field");
    }
    visit_fields(value, [&](const char* key, auto& field) {
        if (view.has(key)) decode(view.at(key), field);
    });
}

template <class T>
void decode(const sim::JsonView& view, std::vector<T>& values) {
    values.clear();
    for (std::size_t i = 0; i < view.size(); ++i) decode(view.at(i), values.emplace_back());
}

// Decodes the alternative T if `name` is its name; otherwise returns false.
template <class T>
bool decode_if_named(const sim::JsonView& view, const std::string& name, Command& command) {
    if (name != T::name) return false;
    decode(view, command.emplace<T>());
    return true;
}

template <std::size_t... i>
bool decode_any(const sim::JsonView& view, const std::string& name, Command& command, std::index_sequence<i...>) {
    return (decode_if_named<std::variant_alternative_t<i, Command>>(view, name, command) || ...);
}

}  // namespace

sim::Json to_json(const Command& command) {
    sim::Json object = sim::Json::object();
    std::visit([&](const auto& given) { object[given.name] = encode_fields(given); }, command);
    return object;
}

Command parse_command(const sim::JsonView& view) {
    const std::vector<std::string> names = view.keys();
    if (names.size() != 1) view.fail("one command should be here, as {\"name\": {...}}");
    Command command;
    constexpr auto all = std::make_index_sequence<std::variant_size_v<Command>>();
    if (!decode_any(view.at(names[0]), names[0], command, all)) view.fail("there is no command '" + names[0] + "'");
    return command;
}

}  // namespace selvedge::editor

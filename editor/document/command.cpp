#include "editor/document/command.h"

#include <algorithm>
#include <utility>

#include "editor/document/field_json.h"

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
std::string label(const SetFields& command) {
    const bool has_one = command.values.is_object() && !command.values.members().empty();
    std::string what = has_one ? command.values.members().front().key : "properties";
    std::ranges::replace(what, '_', ' ');
    return "Change " + what;
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

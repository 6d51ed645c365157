#include "sim/pattern/surface_design.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "sim/core/json.h"
#include "sim/pattern/enum_names.h"
#include "sim/pattern/fault.h"

namespace selvedge::sim {

bool is_colour_text(std::string_view text) {
    const auto is_hexadecimal = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
    };
    return text.size() == 7 && text[0] == '#' && std::ranges::all_of(text.substr(1), is_hexadecimal);
}

namespace {

std::string read_colour(FaultReader& reader, const JsonNode& node) {
    const std::string text = reader.text(node).value_or("");
    if (node.value->is_string() && !is_colour_text(text)) reader.error(node, "'" + text + "' is no colour: #RRGGBB is");
    return text;
}

std::string read_source(FaultReader& reader, const JsonNode& node, DesignKind kind) {
    if (kind == DesignKind::Test) return {};
    const char* key = kind == DesignKind::Tartan ? "tartan" : kind == DesignKind::Colour ? "colour" : "file";
    const JsonNode source = node.member(key);
    if (kind == DesignKind::Colour && source) return read_colour(reader, source);
    if (source) return reader.text(source).value_or("");
    if (kind != DesignKind::Tartan) reader.error(node, "no key '" + std::string(key) + "'");
    return {};
}

constexpr std::array<std::string_view, 9> kDesignKeys{"kind",     "tartan",   "colour",  "file",  "size",
                                                      "position", "rotation", "repeats", "ground"};

}  // namespace

SurfaceDesign read_design(FaultReader& reader, const JsonNode& node) {
    SurfaceDesign design;
    if (!reader.expect(node, Json::Kind::Object)) return design;
    const JsonNode kind = node.member("kind");
    if (!kind) return reader.error(node, "no key 'kind'"), design;
    const auto chosen = reader.choice(kind, names_of(DesignKind{}).texts);
    if (!chosen) return design;
    design.kind = static_cast<DesignKind>(*chosen);
    reader.warn_of_unknown_keys(node, kDesignKeys);
    design.source = read_source(reader, node, design.kind);
    if (const JsonNode size = node.member("size")) {
        design.size = reader.length(size);
        if (design.size && !(*design.size >= kSmallestDesign && *design.size <= kLargestDesign))
            reader.error(size, size.value->number_text() + " is no size of a repeat: 0.1 to 500 cm are");
    }
    if (const JsonNode position = node.member("position"))
        design.position = reader.point(position).value_or(Vec2d::Zero());
    if (const JsonNode rotation = node.member("rotation"))
        design.rotation = reader.number(rotation).value_or(0) * std::numbers::pi / 180;
    if (const JsonNode repeats = node.member("repeats")) design.is_repeated = reader.flag(repeats).value_or(true);
    if (const JsonNode ground = node.member("ground")) design.ground = read_colour(reader, ground);
    return design;
}

}  // namespace selvedge::sim

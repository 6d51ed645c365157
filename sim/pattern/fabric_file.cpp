#include "sim/pattern/fabric_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim/core/assert.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/json.h"
#include "sim/pattern/enum_names.h"
#include "sim/pattern/fabric_fields.h"
#include "sim/pattern/named_file.h"

namespace selvedge::sim {
namespace {

constexpr auto kKeys = [] {
    std::array<FabricKey, std::tuple_size_v<std::remove_cvref_t<decltype(kFabricFields)>>> keys{};
    std::size_t count = 0;
    for_each_field<Fabric>([&]<class SomeField>(const SomeField& field) {
        if constexpr (SomeField::is_key)
            keys[count++] = {.key = field.key.data(),
                             .value = SomeField::member,
                             .least = field.range.least,
                             .most = field.range.most,
                             .is_required = SomeField::form == FileForm::Required};
    });
    return std::pair(keys, count);
}();

constexpr std::size_t kMaxBytes = std::size_t{64} << 20;  // as of every JSON file

const EmbeddedFile* shipped_fabric(std::string_view name) {
    const std::span<const EmbeddedFile> all = embedded_fabrics();
    const auto found = std::ranges::find_if(
        all, [&](const EmbeddedFile& file) { return std::filesystem::path(file.name).stem().string() == name; });
    return found == all.end() ? nullptr : &*found;
}

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

// Keeps the digits of a number that is the same.
void set_exact_number(Json& place, double value) {
    if (!place.is_number() || place.number() != value) place = Json(value);
}

void set_text(Json& object, const char* key, const std::string& text) {
    if (text.empty()) return object.erase(key);
    object[key] = text;
}

// The angle in degrees that is read as exactly these radians, with as few digits as possible; if there is none, the
// nearest.
double degrees_read_as(double radians) {
    const auto read = [](double degrees) { return degrees * std::numbers::pi / 180; };  // as read_design does
    const double nearest = radians * 180 / std::numbers::pi;
    const double rounded = std::round(nearest * 1e6) / 1e6;
    for (const double degrees :
         {rounded, nearest, std::nextafter(nearest, -HUGE_VAL), std::nextafter(nearest, HUGE_VAL)}) {
        if (read(degrees) == radians) return degrees;
    }
    return nearest;
}

void set_surface(Json& root, const std::optional<SurfaceDesign>& surface, const std::string& file) {
    if (!surface) return root.erase("surface");
    Json& place = root["surface"];
    if (!place.is_object()) place = Json::object();
    place["kind"] = std::string(name_of_value(surface->kind));
    set_text(place, "tartan", surface->kind == DesignKind::Tartan ? surface->source : "");
    set_text(place, "colour", surface->kind == DesignKind::Colour ? surface->source : "");
    if (surface->kind == DesignKind::Picture) set_named_file(place["file"], surface->source, file);
    if (surface->kind != DesignKind::Picture) place.erase("file");
    if (!surface->size) place.erase("size");
    if (surface->size) set_exact_number(place["size"], *surface->size);
    if (place.find("position") || !surface->position.isZero(0)) {
        Json& position = place["position"];
        if (!position.is_array() || position.elements().size() != 2) position = Json::array({Json(), Json()});
        for (int i = 0; i < 2; ++i)
            set_exact_number(position.elements()[static_cast<std::size_t>(i)], surface->position[i]);
    }
    if (place.find("rotation") || surface->rotation != 0)
        set_exact_number(place["rotation"], degrees_read_as(surface->rotation));
    if (place.find("repeats") || !surface->is_repeated) place["repeats"] = Json(surface->is_repeated);
    set_text(place, "ground", surface->ground);
}

}  // namespace

std::span<const FabricKey> fabric_keys() {
    return std::span(kKeys.first).first(kKeys.second);
}

const FabricKey& fabric_key(double Fabric::*value) {
    const std::span<const FabricKey> keys = fabric_keys();
    const auto found = std::ranges::find(keys, value, &FabricKey::value);
    SELVEDGE_ASSERT(found != keys.end());
    return *found;
}

bool is_shipped_fabric(std::string_view name) {
    return shipped_fabric(name) != nullptr;
}

bool is_fabric_file(std::string_view name) {
    return name.ends_with(".json");
}

std::string fabric_title(std::string_view name_or_file) {
    if (!is_fabric_file(name_or_file)) return std::string(name_or_file);
    return std::filesystem::path(name_or_file).stem().string();
}

FabricFile read_fabric_file(std::string_view name_or_file) {
    const std::string name(name_or_file.empty() ? Fabric().name : name_or_file);
    if (const EmbeddedFile* shipped = shipped_fabric(name))
        return {parse_fabric(shipped->text, std::string(shipped->name)), std::string(shipped->text)};
    if (!is_fabric_file(name)) {
        throw InputError("", "",
                         "no fabric '" + name + "': known are " + joined(fabric_names()) + ", or name a .json file");
    }
    FabricFile read{.text = read_file(name, kMaxBytes)};
    read.fabric = parse_fabric(read.text, name);
    return read;
}

std::string write_fabric(const Fabric& fabric, const std::string& file, std::string_view before) {
    Json root = before.empty() ? Json::object() : parse_json(before, file);
    if (!root.is_object()) root = Json::object();
    root["name"] = fabric.name;
    const Fabric usual;
    for (const FabricKey& key : fabric_keys()) {
        const double value = fabric.*key.value;
        if (key.is_required || root.find(key.key) || value != usual.*key.value) set_exact_number(root[key.key], value);
    }
    set_surface(root, fabric.surface, file);
    std::string text = write_json(root);
    parse_fabric(text, file);  // throws if a value is out of range
    return text;
}

}  // namespace selvedge::sim

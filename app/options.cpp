#include "app/options.h"

#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "app/arguments.h"
#include "sim/core/error.h"
#include "sim/core/file_extension.h"
#include "sim/core/file_path.h"
#include "sim/core/numbers.h"
#include "sim/mannequin/mannequin.h"
#include "sim/pattern/pattern.h"

namespace selvedge::app {
namespace {

// Returns the value with this name; the error for an unknown name lists the known ones.
template <class T>
T named(const std::map<std::string, T>& values, const std::string& option, const std::string& text) {
    const auto found = values.find(text);
    if (found != values.end()) return found->second;
    std::string names;
    for (const auto& [name, value] : values) names += (names.empty() ? "" : ", ") + name;
    throw sim::InputError("", option, "'" + text + "' is none of " + names);
}

const std::map<std::string, sim::LengthUnit> kUnits{
    {"auto", sim::LengthUnit::Auto},      {"m", sim::LengthUnit::Metres},       {"dm", sim::LengthUnit::Decimetres},
    {"cm", sim::LengthUnit::Centimetres}, {"mm", sim::LengthUnit::Millimetres}, {"in", sim::LengthUnit::Inches},
    {"ft", sim::LengthUnit::Feet},        {"poser", sim::LengthUnit::Poser}};
const std::map<std::string, sim::UpAxis> kUpAxes{
    {"auto", sim::UpAxis::Auto}, {"y", sim::UpAxis::Y}, {"z", sim::UpAxis::Z}};

}  // namespace

bool BodyOptions::is_file() const {
    return sim::is_body_file(source);
}

void add_body_options(Command& command, BodyOptions& options, const std::string& help) {
    using Text = const std::string&;
    const auto add = [&](const char* name, const std::string& text, const char* type,
                         const std::function<void(Text)>& read) {
        add_text_option(command, name, text, {.type = type, .group = "Body"}, read);
    };
    add("-b,--body", help, "BODY", [&](const std::string& text) {
        if (!text.empty() && !sim::is_body_file(text)) sim::parse_mannequin(text);
        options.source = text;
    });
    add("--body-unit", "Unit of a body's file: auto, m, dm, cm, mm, in, ft, poser (default auto: by its size)", "UNIT",
        [&](const std::string& text) { options.load.unit = named(kUnits, "--body-unit", text); });
    add("--body-up", "Axis of a body's file that points up: auto, y, z (default auto)", "AXIS",
        [&](const std::string& text) { options.load.up = named(kUpAxes, "--body-up", text); });
}

sim::MadeBody make_body(const BodyOptions& options, const sim::ContentStore* store) {
    return sim::make_body(options.source, options.load, store);
}

namespace {

std::optional<int> parse_level(const std::string& text) {
    if (text == "adaptive") return std::nullopt;
    int level = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), level);
    if (error != std::errc() || end != text.data() + text.size() || level < 0 || level > render::kMaxSurfaceLevel) {
        throw sim::InputError(
            "", "--surface-level",
            "'" + text + "' is neither adaptive nor a level from 0 to " + std::to_string(render::kMaxSurfaceLevel));
    }
    return level;
}

float parse_soft_cap(const std::string& text) {
    const auto numbers = sim::parse_number_list(text);
    if (!numbers || numbers->size() != 1 || numbers->front() < 0.001 || numbers->front() > render::kMaxCoefficient)
        throw sim::InputError("", "--surface-soft-cap", "'" + text + "' is not a number from 0.001 to 100");
    return static_cast<float>(numbers->front());
}

render::LightNormals parse_normals(const std::string& text) {
    if (text == "recomputed") return render::LightNormals::Recomputed;
    if (text == "interpolated") return render::LightNormals::Interpolated;
    throw sim::InputError("", "--surface-normals", "'" + text + "' is none of recomputed, interpolated");
}

}  // namespace

void add_surface_options(Command& command, SurfaceChoice& choice) {
    using Text = const std::string&;
    const auto add = [&](const char* name, Text help, const char* type, const std::function<void(Text)>& read) {
        add_text_option(command, name, help, {.type = type, .group = "Surface", .needs = {"--surface"}}, read);
    };
    add_text_option(command, "--surface",
                    std::string("Draw the cloth as a curved surface over its triangles: ") + render::kSurfaceKindNames +
                        ", or the curve modifier's K0,K1,K2,K3 (default: the triangles themselves)",
                    {.type = "KIND|K0,K1,K2,K3", .group = "Surface"},
                    [&](const std::string& text) { choice.modifier = render::parse_modifier(text); });
    add("--surface-soft-cap", "The curve modifier grows slowly above this (default 1)", "SC",
        [&](const std::string& text) { choice.soft_cap = parse_soft_cap(text); });
    add("--surface-level", "How often its edges are halved: 0 to 6, or adaptive (default adaptive, to 3)", "N|adaptive",
        [&](const std::string& text) { choice.level = parse_level(text); });
    add("--surface-normals", "What lights it: recomputed from the surface, or interpolated (default recomputed)",
        "WHICH", [&](const std::string& text) { choice.light_normals = parse_normals(text); });
    add_flag(command, "--back-face-coarsening", choice.coarsens_back_faces,
             "Keep coarse what is turned away, in pictures of an adaptive surface",
             {.group = "Surface", .needs = {"--surface"}});
}

namespace {

namespace fs = std::filesystem;

void check_extension(const fs::path& path, std::span<const std::string_view> extensions) {
    const std::string extension = sim::lower_extension(path);
    if (std::find(extensions.begin(), extensions.end(), extension) != extensions.end()) return;
    std::string known;
    for (const std::string_view name : extensions) known += (known.empty() ? "" : " or ") + std::string(name);
    throw sim::InputError(path.string(), "", "cannot write: the name should end in " + known);
}

}  // namespace

void check_output(const fs::path& path, std::span<const std::string_view> extensions) {
    if (!extensions.empty()) check_extension(path, extensions);
    if (sim::file_exists(path) && !sim::is_file(path))
        throw sim::InputError(path.string(), "", "cannot write: it is no regular file");
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0 && errno != ENOENT)  // a name that is too long, links in a circle
        throw sim::InputError(path.string(), "", std::string("cannot write: ") + std::strerror(errno));
    const fs::path folder = sim::canonical_path(path).parent_path();
    if (access(folder.c_str(), W_OK | X_OK) != 0)
        throw sim::InputError(path.string(), "", std::string("cannot write: ") + std::strerror(errno));
    if (!path.has_filename()) throw sim::InputError(path.string(), "", "cannot write: this names a folder");
}

void check_distinct(const std::vector<fs::path>& outputs, const std::vector<fs::path>& inputs) {
    std::set<fs::path> taken;
    for (const fs::path& input : inputs) taken.insert(sim::canonical_path(input));
    for (const fs::path& output : outputs) {
        if (!taken.insert(sim::canonical_path(output)).second)
            throw sim::InputError(output.string(), "", "cannot write: the same command reads or writes it already");
    }
}

}  // namespace selvedge::app

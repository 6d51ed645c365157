#include "sim/pattern/named_file.h"

#include <optional>
#include <system_error>

#include "sim/pattern/fabric_file.h"

namespace selvedge::sim {
namespace {

namespace fs = std::filesystem;

// A path that is not absolute is relative to the working directory.
fs::path canonical_path(const fs::path& path) {
    std::error_code error;
    const fs::path whole = fs::absolute(path, error);
    const fs::path found = fs::weakly_canonical(whole, error);
    return error ? whole.lexically_normal() : found;
}

fs::path folder_of(const fs::path& file) {
    return canonical_path(fs::absolute(file).parent_path());
}

void resolve(std::string& name, const fs::path& file) {
    name = resolve_named_file(name, file);
}

void resolve_fabric(std::string& name, const fs::path& file) {
    if (is_fabric_file(name)) resolve(name, file);
}

void resolve_picture(std::optional<SurfaceDesign>& surface, const fs::path& file) {
    if (surface && surface->kind == DesignKind::Picture) resolve(surface->source, file);
}

}  // namespace

std::string resolve_named_file(const std::string& name, const fs::path& file) {
    return file.empty() || name.empty() ? name : canonical_path(fs::absolute(file).parent_path() / name).string();
}

void resolve_named_files(Pattern& pattern, const fs::path& file) {
    if (is_body_file(pattern.body)) resolve(pattern.body, file);
    resolve_fabric(pattern.fabric, file);
    resolve_picture(pattern.surface, file);
    for (Underlay& underlay : pattern.underlays) resolve(underlay.file, file);
    for (Panel& panel : pattern.panels) {
        resolve_fabric(panel.fabric, file);
        for (std::string& interlining : panel.interlinings) resolve_fabric(interlining, file);
        resolve_picture(panel.surface, file);
    }
}

void set_named_file(Json& name, const std::string& path, const fs::path& file) {
    const bool is_as_given = file.empty() || path.empty();
    const fs::path whole = is_as_given ? fs::path(path) : canonical_path(path);
    if (name.is_string() && resolve_named_file(name.string(), file) == whole.string()) return;
    const fs::path relative = is_as_given ? fs::path() : whole.lexically_relative(folder_of(file));
    const bool is_below = !relative.empty() && *relative.begin() != "..";
    name = (is_below ? relative : whole).string();
}

}  // namespace selvedge::sim

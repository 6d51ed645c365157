#include "sim/pattern/named_file.h"

#include <optional>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/file_path.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/fabric_file.h"

namespace selvedge::sim {
namespace {

namespace fs = std::filesystem;

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
    return file.empty() || name.empty() ? name : canonical_path(absolute_path(file).parent_path() / name).string();
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

std::vector<NamedFileUse> named_file_uses(const Pattern& pattern) {
    std::vector<NamedFileUse> files;
    const auto add_picture = [&](const std::optional<SurfaceDesign>& surface) {
        if (surface && surface->kind == DesignKind::Picture) files.push_back({surface->source, FileUse::Picture});
    };
    const auto add_fabric = [&](const std::string& name) {
        if (!is_fabric_file(name)) return;
        files.push_back({name, FileUse::Fabric});
        try {
            add_picture(find_fabric(name).surface);
        } catch (const InputError&) {  // the fabric is reported where it is used
        }
    };
    if (is_body_file(pattern.body)) files.push_back({pattern.body, FileUse::Body});
    add_fabric(pattern.fabric);
    add_picture(pattern.surface);
    for (const Underlay& underlay : pattern.underlays) files.push_back({underlay.file, FileUse::Underlay});
    for (const Panel& panel : pattern.panels) {
        add_fabric(panel.fabric);
        for (const std::string& interlining : panel.interlinings) add_fabric(interlining);
        add_picture(panel.surface);
    }
    return files;
}

std::vector<std::string> named_files(const Pattern& pattern) {
    std::vector<std::string> files;
    for (NamedFileUse& named : named_file_uses(pattern)) files.push_back(std::move(named.file));
    return files;
}

void set_named_file(Json& name, const std::string& path, const fs::path& file) {
    const bool is_as_given = file.empty() || path.empty();
    const fs::path whole = is_as_given ? fs::path(path) : canonical_path(path);
    if (name.is_string() && resolve_named_file(name.string(), file) == whole.string()) return;
    const fs::path relative =
        is_as_given ? fs::path() : whole.lexically_relative(canonical_path(absolute_path(file).parent_path()));
    const bool is_below = !relative.empty() && *relative.begin() != "..";
    name = (is_below ? relative : whole).string();
}

}  // namespace selvedge::sim

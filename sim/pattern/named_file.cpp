#include "sim/pattern/named_file.h"

#include <optional>
#include <type_traits>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/file_path.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/fabric_file.h"
#include "sim/pattern/field_visit.h"
#include "sim/pattern/pattern_fields.h"

namespace selvedge::sim {
namespace {

namespace fs = std::filesystem;

// visit(name, use) for each file that the pattern names, its own before those of its panels.
template <class MaybeConst, class Visit>
void visit_named_files(MaybeConst& pattern, const Visit& visit) {
    if (is_body_file(pattern.body)) visit(pattern.body, FileUse::Body);
    const auto visit_name = [&]<class T>(const auto& field, T& value) {
        if constexpr (std::is_same_v<std::remove_const_t<T>, SurfaceDesign>) {
            if (value.kind == DesignKind::Picture) visit(value.source, FileUse::Picture);
        } else if constexpr (std::is_same_v<std::remove_const_t<T>, std::string>) {
            if (field.measure == Measure::Fabric && is_fabric_file(value)) visit(value, FileUse::Fabric);
            if (field.measure == Measure::File) visit(value, FileUse::Underlay);
        }
    };
    visit_fields(pattern, [&]<class T>(const auto& field, T& value) {
        if constexpr (!std::is_same_v<std::remove_const_t<T>, std::vector<Panel>>)
            visit_value(field, value, visit_name);
    });
    for (auto& panel : pattern.panels) visit_values(panel, visit_name);
}

}  // namespace

std::string resolve_named_file(const std::string& name, const fs::path& file) {
    return file.empty() || name.empty() ? name : canonical_path(absolute_path(file).parent_path() / name).string();
}

void resolve_named_files(Pattern& pattern, const fs::path& file) {
    visit_named_files(pattern, [&](std::string& name, FileUse) { name = resolve_named_file(name, file); });
}

std::vector<NamedFileUse> named_file_uses(const Pattern& pattern) {
    std::vector<NamedFileUse> files;
    visit_named_files(pattern, [&](const std::string& name, FileUse use) {
        files.push_back({name, use});
        if (use != FileUse::Fabric) return;
        try {
            const std::optional<SurfaceDesign> surface = find_fabric(name).surface;
            if (surface && surface->kind == DesignKind::Picture) files.push_back({surface->source, FileUse::Picture});
        } catch (const InputError&) {  // the fabric is reported where it is used
        }
    });
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

#include "editor/document/file_names.h"

#include "sim/pattern/pattern_write.h"

namespace selvedge {
namespace {

// A name that no panel has while names change places.
std::string between(const std::string& name) {
    return "\x01" + name;
}

void forget_panel(Json& specification, const std::string& name) {
    Json* garment = specification.find("pattern");
    if (Json* panels = garment ? garment->find("panels") : nullptr; panels && panels->is_object()) panels->erase(name);
}

}  // namespace

FileNames renamed(FileNames names, const std::string& from, const std::string& to) {
    const auto found = names.find(from);
    const std::string in_file = found == names.end() ? from : found->second;
    if (found != names.end()) names.erase(found);
    names.insert_or_assign(to, in_file);
    return names;
}

Json with_present_names(Json specification, const FileNames& names) {
    for (const auto& [present, in_file] : names) rename_panel_in_file(specification, in_file, between(present));
    for (const auto& [present, in_file] : names) {
        forget_panel(specification, present);
        rename_panel_in_file(specification, between(present), present);
    }
    return specification;
}

}  // namespace selvedge

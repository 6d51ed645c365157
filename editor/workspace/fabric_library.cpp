#include "editor/workspace/fabric_library.h"

#include <utility>

#include "sim/core/error.h"

namespace selvedge::editor {

FabricLibrary::Entry FabricLibrary::read(const std::string& name) const {
    try {
        return {.file = reader_(name)};
    } catch (const sim::InputError& error) {
        return {.problem = error.what()};
    }
}

const FabricLibrary::Entry& FabricLibrary::find(const std::string& name) {
    const auto known = entries_.find(name);
    return known != entries_.end() ? known->second : entries_.emplace(name, read(name)).first->second;
}

void FabricLibrary::read_again(const std::string& name) {
    Entry entry = read(name);
    entry.draft = std::move(entries_[name].draft);
    entries_[name] = std::move(entry);
    ++version_;
}

void FabricLibrary::open(const std::string& file) {
    const auto known = entries_.find(file);
    if (known == entries_.end() || !known->second.has_changes()) {
        entries_[file] = {.file = reader_(file)};
        ++version_;
    }
    shown_ = file;
}

void FabricLibrary::begin_draft(const std::string& name) {
    const Entry& entry = find(name);
    if (entry.problem.empty() && !entry.draft) entries_[name].draft = entry.file.fabric;
}

void FabricLibrary::set_draft(const std::string& name, const sim::Fabric& draft) {
    entries_.at(name).draft = draft;
}

void FabricLibrary::drop_draft(const std::string& name) {
    const auto known = entries_.find(name);
    if (known != entries_.end()) known->second.draft.reset();
}

void FabricLibrary::take_written(const std::string& file, sim::FabricFile content) {
    Entry& entry = entries_[file];
    entry.file = std::move(content);
    entry.problem.clear();
    ++version_;
}

std::vector<std::string> FabricLibrary::files() const {
    std::vector<std::string> names;
    for (const auto& [name, entry] : entries_) {
        if (name.ends_with(".json") && (entry.problem.empty() || entry.draft)) names.push_back(name);
    }
    return names;
}

std::vector<std::string> FabricLibrary::changed() const {
    std::vector<std::string> names;
    for (const auto& [name, entry] : entries_) {
        if (entry.has_changes()) names.push_back(name);
    }
    return names;
}

}  // namespace selvedge::editor

#include "editor/workspace/fabric_library.h"

#include <utility>

#include "editor/document/journal.h"
#include "sim/core/error.h"
#include "sim/core/json.h"

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
    note(name);
}

void FabricLibrary::drop_draft(const std::string& name) {
    const auto known = entries_.find(name);
    if (known == entries_.end() || !known->second.draft) return;
    known->second.draft.reset();
    note(name);
}

bool FabricLibrary::recover_draft(const std::string& name, const sim::Fabric& draft) {
    if (find(name).has_changes()) return false;
    entries_[name].draft = draft;
    note(name);
    return true;
}

namespace {

// None: the draft has a value that no fabric file may have, and a later change of it is awaited.
std::optional<std::string> draft_line(const std::string& name, const sim::Fabric& draft) {
    try {
        return write_json(journal_draft(name, draft), -1);
    } catch (const sim::InputError&) {
        return std::nullopt;
    }
}

}  // namespace

void FabricLibrary::note(const std::string& name) const {
    if (!journal_) return;
    const Entry& entry = entries_.at(name);
    if (!entry.has_changes()) return journal_(write_json(journal_no_draft(name), -1));
    if (const auto line = draft_line(name, *entry.draft)) journal_(*line);
}

std::vector<std::string> FabricLibrary::journal_lines() const {
    std::vector<std::string> lines;
    for (const std::string& name : changed()) {
        if (auto line = draft_line(name, *entries_.at(name).draft)) lines.push_back(std::move(*line));
    }
    return lines;
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

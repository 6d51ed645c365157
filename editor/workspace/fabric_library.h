#pragma once
// The fabrics that the user looks at and edits: what was read of each, and values that are edited but not saved yet
// (drafts). A draft belongs to its fabric, not to the document: it stays until it is saved or dropped.
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/pattern/fabric_file.h"

namespace selvedge::editor {

// Reads a shipped fabric or a fabric file. Throws InputError. The host program provides this function.
using FabricReader = std::function<sim::FabricFile(const std::string& name_or_file)>;

class FabricLibrary {
 public:
    struct Entry {
        sim::FabricFile file{};
        std::string problem{};               // why it cannot be read; empty: it was read
        std::optional<sim::Fabric> draft{};  // its values while they are edited

        bool has_changes() const { return draft && *draft != file.fabric; }
    };

    explicit FabricLibrary(FabricReader reader = sim::read_fabric_file) : reader_(std::move(reader)) {}

    // Reads the fabric when it is first asked for. Valid until read_again().
    const Entry& find(const std::string& name);

    // Reads it again; a draft stays.
    void read_again(const std::string& name);

    // The fabric whose values the inspector shows; empty: the garment's.
    const std::string& shown() const { return shown_; }
    void show(const std::string& name) { shown_ = name; }

    // Shows a fabric file, read again unless it has a draft with changes. Throws InputError; then nothing changes.
    void open(const std::string& file);

    // Receives one line per change of a draft (editor/document/journal.h). Must not throw.
    using Journal = std::function<void(std::string_view line)>;
    void set_journal(Journal journal) { journal_ = std::move(journal); }

    // The lines of all drafts with changes, for the start of a journal.
    std::vector<std::string> journal_lines() const;

    // Takes up a draft of an earlier run, also of a fabric that cannot be read any more. False: the fabric has a draft
    // with changes, which stays.
    bool recover_draft(const std::string& name, const sim::Fabric& draft);

    void begin_draft(const std::string& name);                          // of one that was read; keeps a draft
    void set_draft(const std::string& name, const sim::Fabric& draft);  // Pre: it has one
    void drop_draft(const std::string& name);

    // Its file was written with this content. A draft stays: the caller drops the one that was saved.
    void take_written(const std::string& file, sim::FabricFile content);

    std::vector<std::string> files() const;    // the fabric files that were read, in alphabetical order
    std::vector<std::string> changed() const;  // the fabrics whose drafts have changes, in alphabetical order

    // How often a file was written or read again: what was made of fabrics before is outdated.
    std::uint64_t version() const { return version_; }

 private:
    Entry read(const std::string& name) const;
    void note(const std::string& name) const;

    FabricReader reader_;
    std::map<std::string, Entry> entries_;
    std::string shown_;
    std::uint64_t version_ = 0;
    Journal journal_;
};

}  // namespace selvedge::editor

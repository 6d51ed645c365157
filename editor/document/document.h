#pragma once
// The truth of the editor: the pattern that is being edited, what of it is selected, and how it came to be. Views read
// it; whoever wants a change runs a command.
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "editor/document/command.h"
#include "editor/document/journal.h"
#include "editor/document/selection.h"
#include "sim/core/json.h"
#include "sim/pattern/pattern_file.h"

namespace selvedge::editor {

// What panels that were renamed are called in the file that a document came from: so they keep their place there, and
// what else the file says of them.

// By a panel's present name, where the file has another.
using FileNames = std::map<std::string, std::string>;

FileNames renamed(FileNames names, const std::string& from, const std::string& to);

// The file with the present names. What the file has under a name that now is another panel's goes: its own panel went.
sim::Json with_present_names(sim::Json specification, const FileNames& names);

struct HistoryEntry {
    std::string label;
    PatternPatch patch;
    std::optional<std::pair<FileNames, FileNames>> file_names = {};  // before and after, where a panel was renamed
    Selection before;                                                // what was selected then
    Selection after = {};
};

class Document {
 public:
    // Gets a line for each change (journal.h); never fails a change.
    using Journal = std::function<void(std::string_view line)>;

    explicit Document(sim::PatternDocument source = {});

    const sim::Pattern& pattern() const { return source_.pattern; }
    const Selection& selection() const { return selection_; }

    // Counts up with every change of the pattern, undone and tried ones included.
    std::uint64_t revision() const { return revision_; }

    // Goes on counting where the one that it takes the place of is: who remembers a revision sees that all is new.
    void replace_panel(const Document& before) { revision_ = before.revision_ + 1; }

    // Parts that are not there are left out.
    void select(Selection selection);

    // Throws GeometryError, with nothing changed, when the command cannot be carried out. What it made is selected.
    void run(const Command& command);

    // Shows what a command would do, as long as a drag lasts: the next one takes its place, `keep` makes it history,
    // `drop` takes it back. Any other change drops it first. Throws as run; what was shown before it then stays.
    void preview(const Command& command);
    void keep();
    void drop();
    bool is_previewing() const { return is_previewing_; }

    bool can_undo() const { return position_ > 0; }
    bool can_redo() const { return position_ < history_.size(); }
    void undo();  // nothing where there is nothing to undo
    void redo();

    // Entries before the position are done, those from it on are undone.
    const std::vector<HistoryEntry>& history() const { return history_; }
    std::size_t position() const { return position_; }
    void go_to(std::size_t position);  // undoes or redoes so far. Pre: at most history().size()

    // The pattern as a file.
    std::string text() const;

    bool has_unsaved_changes() const;
    void mark_saved();
    void mark_changed() { saved_position_.reset(); }  // what is shown is saved nowhere

    void set_journal(Journal journal) { journal_ = std::move(journal); }

 private:
    void note(const sim::Json& line) const;
    void show(sim::Pattern pattern, const Selection& selected);
    void remember(HistoryEntry entry);

    sim::PatternDocument source_;
    FileNames file_names_;
    Selection selection_;
    std::vector<HistoryEntry> history_;
    std::size_t position_ = 0;
    std::optional<std::size_t> saved_position_ = 0;  // none: what was saved can no longer be reached
    std::uint64_t revision_ = 0;
    bool is_previewing_ = false;
    sim::Pattern before_preview_;
    Selection selected_before_;
    std::string previewed_;  // its label; empty: nothing that could be carried out yet
    Journal journal_;
};

}  // namespace selvedge::editor

#pragma once
// The edited document: the sources of the pattern, which the pattern is evaluated from, the selection, hidden and
// locked panels, and the undo history. Views read it; every change of the pattern is a command. Also maps renamed
// panels to their names in the source file.
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "editor/document/apply.h"
#include "editor/document/command.h"
#include "editor/document/journal.h"
#include "editor/document/selection.h"
#include "editor/document/sources_patch.h"
#include "sim/core/json.h"
#include "sim/pattern/pattern_file.h"
#include "sim/pattern/sources.h"

namespace selvedge::editor {

// Renamed panels keep their position in the source file and the file's additional data about them. For this the
// document stores their names in the file.

// Maps a panel's current name to its name in the file, where the two differ.
using FileNames = std::map<std::string, std::string>;

FileNames renamed(FileNames names, const std::string& from, const std::string& to);

// The file with the current names. If a current name belongs to another panel in the file, that panel was removed and
// its entry is deleted.
sim::Json with_present_names(sim::Json specification, const FileNames& names);

struct HistoryEntry {
    std::string label;
    SourcesPatch patch;
    std::optional<std::pair<FileNames, FileNames>> file_names = {};  // before, after; only for a rename
    std::optional<PanelRename> rename = {};
    Selection before;  // selection before the command
    Selection after = {};
};

class Document {
 public:
    // Receives one line per change (journal.h). Must not throw.
    using Journal = std::function<void(std::string_view line)>;

    explicit Document(sim::PatternDocument source = {});

    const sim::Sources& sources() const { return sources_; }
    const sim::Pattern& pattern() const { return source_.pattern; }  // evaluate(sources())
    const Selection& selection() const { return selection_; }

    // Increases with every change of the pattern, including undo, redo and previews.
    std::uint64_t revision() const { return revision_; }

    // Call when this document replaces `before`: continues its revision count, so that cached revisions become invalid.
    void continue_revisions(const Document& before) { revision_ = before.revision_ + 1; }

    // Parts that do not exist are left out.
    void select(Selection selection);

    // Which panels are hidden and locked. They follow renames; removed panels leave them. Parts of panels that cannot
    // be picked any more leave the selection. changeable() is what the views may change of it: what can be picked.
    const PanelStates& panel_states() const { return panel_states_; }
    void set_panel_states(PanelStates states);
    Selection changeable() const { return pickable(selection_, panel_states_, pattern()); }

    // What a command, or opening the file, did besides what it is for, such as the end of a link. Each is told once.
    std::vector<std::string> take_notes() { return std::exchange(notes_, {}); }

    // Why the document must not be saved: a newer program wrote its file. None: it may.
    std::optional<std::string> read_only_reason() const { return newer_format(source_.json); }

    // Applies a command, adds it to the history and selects what it made. Throws GeometryError, with nothing changed,
    // if the command is not possible, or if a locked panel would follow its linked mirror image.
    void run(const Command& command) { run_together({command}); }

    // Several commands, in their order, as one step of the history. It has the label of the first. Pre: they are not
    // empty. A panel is renamed by a command that stands alone.
    void run_together(const std::vector<Command>& commands);

    // Previews a command during a drag. The next preview replaces it, `commit` adds it to the history, `rollback`
    // undoes it; any other change rolls it back first. Throws as `run`; the preview shown before then stays.
    void preview(const Command& command);
    void commit();
    void rollback();
    bool is_previewing() const { return is_previewing_; }

    bool can_undo() const { return position_ > 0; }
    bool can_redo() const { return position_ < history_.size(); }
    void undo();  // no effect if there is nothing to undo
    void redo();

    // Entries before position() are applied, those from it on are undone.
    const std::vector<HistoryEntry>& history() const { return history_; }
    std::size_t position() const { return position_; }
    void go_to(std::size_t position);  // undoes or redoes up to there. Pre: position <= history().size()

    // The document as the text of a pattern file.
    std::string text(const std::string& file = {}) const;

    bool has_unsaved_changes() const;
    void mark_saved();
    void mark_changed() { saved_position_.reset(); }  // the current state is in no file

    // Texts of the drawing that the garment was imported from, about the whole garment: further evidence for proposed
    // seams. Neither a file nor the journal has them.
    const std::string& hints() const { return hints_; }
    void set_hints(std::string hints) { hints_ = std::move(hints); }

    void set_journal(Journal journal) { journal_ = std::move(journal); }

 private:
    void note(const sim::Json& line) const;
    void show(sim::Sources sources, sim::Pattern pattern, const Selection& selected);
    void remember(HistoryEntry entry);

    sim::Sources sources_;
    sim::PatternDocument source_;  // its pattern is what sources_ give
    std::vector<std::string> notes_;
    FileNames file_names_;
    std::string hints_;
    Selection selection_;
    PanelStates panel_states_;
    std::vector<HistoryEntry> history_;
    std::size_t position_ = 0;
    std::optional<std::size_t> saved_position_ = 0;  // none: undo and redo cannot reach the saved state
    std::uint64_t revision_ = 0;
    bool is_previewing_ = false;
    sim::Sources before_preview_;
    Selection selected_before_;
    std::string previewed_;  // label of the previewed command
    Journal journal_;
};

}  // namespace selvedge::editor

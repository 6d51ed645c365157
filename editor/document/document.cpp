#include "editor/document/document.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>
#include <variant>

#include "editor/document/apply.h"
#include "editor/document/command.h"
#include "editor/document/journal.h"
#include "editor/document/selection.h"
#include "editor/geometry/draft.h"
#include "editor/geometry/linked_panels.h"
#include "editor/geometry/panel_edit.h"
#include "sim/core/assert.h"
#include "sim/pattern/field_moves.h"
#include "sim/pattern/halves.h"
#include "sim/pattern/limits.h"
#include "sim/pattern/pattern_file.h"

namespace selvedge::editor {
namespace {

struct Changed {
    sim::Sources sources = {};
    sim::Pattern pattern;
    Outcome outcome = {};
};

bool is_drawn_alike(const sim::Pattern& a, const sim::Pattern& b) {
    return std::ranges::equal(a.panels, b.panels, sim::has_same_outline);
}

// Keeps panels at their position on the sheet when outlines change or panels are added or removed: a panel that the
// automatic layout had placed gets that position as its sheet_position.
void keep_sheet_positions(sim::Pattern& pattern, const sim::Pattern& before) {
    if (is_drawn_alike(pattern, before)) return;
    const std::vector<Vec2d> places = sheet_positions(before);
    for (sim::Panel& panel : pattern.panels) {
        const auto old = std::find_if(before.panels.begin(), before.panels.end(),
                                      [&](const sim::Panel& other) { return other.name == panel.name; });
        if (panel.sheet_position || old == before.panels.end()) continue;
        panel.sheet_position = places[static_cast<std::size_t>(old - before.panels.begin())];
    }
}

// The other panel of the link, with what it is to the panel. Empty: the panel has none.
std::string linked_to(const sim::Pattern& pattern, const sim::Panel& panel) {
    const auto link = sim::link_with(pattern, panel);
    if (!link) return "";
    return (link->kind == sim::Derivation::Mirror ? "its mirror image '" : "its copy '") + link->source + "'";
}

std::vector<sim::Seam> dart_seams(const sim::Pattern& pattern, int panel) {
    std::vector<sim::Seam> darts;
    for (const int dart : sim::darts_of(pattern, panel)) darts.push_back(pattern.seams[as_size(dart)]);
    return darts;
}

// Updates linked panels. Throws if a locked panel would follow; `changed` is then partly changed. A command that is
// about all panels, such as a move of the garment, may change locked ones.
void follow_links(sim::Pattern& changed, const sim::Pattern& before, const std::set<std::string>& locked) {
    if (locked.empty()) return update_links(changed, before);
    const sim::Pattern applied = changed;
    update_links(changed, before);
    for (std::size_t i = 0; i < applied.panels.size(); ++i) {
        const sim::Panel& panel = applied.panels[i];
        const int index = static_cast<int>(i);
        if (!locked.contains(panel.name)) continue;
        const bool follows = !(changed.panels[i] == panel) || dart_seams(changed, index) != dart_seams(applied, index);
        const auto was = std::ranges::find(before.panels, panel.name, &sim::Panel::name);
        if (!follows || was == before.panels.end() || !(*was == panel)) continue;
        throw GeometryError(
            "'" + panel.name + "' is locked and linked to " + linked_to(applied, panel) + ": unlock or unlink it first",
            {{.panel = panel.name}});
    }
}

// Of the panels and seams that changed: a file with such values could not be opened again.
void require_limits(const sim::Pattern& changed, const sim::Pattern& before) {
    for (const sim::Panel& panel : changed.panels) {
        const auto was = std::ranges::find(before.panels, panel.name, &sim::Panel::name);
        if (was != before.panels.end() && *was == panel) continue;
        for (const sim::LimitFault& fault : limit_faults(panel))
            throw GeometryError("'" + panel.name + "': " + fault.place + ": " + fault.problem, {{.panel = panel.name}});
    }
    for (const sim::Seam& seam : changed.seams) {
        for (const sim::LimitFault& fault : limit_faults(seam)) throw GeometryError(fault.place + ": " + fault.problem);
    }
}

// Ends broken links, and tells of them and of those that the command ended.
void tell_ended_links(sim::Pattern& changed, const sim::Pattern& before, const Command& command,
                      std::vector<std::string>& notes) {
    std::set<std::string> told;
    for (sim::EndedLink& link : end_broken_links(changed)) {
        notes.push_back(std::move(link.problem));
        told.insert(std::move(link.panel));
    }
    if (std::holds_alternative<UnlinkPanel>(command)) return;  // that is what was asked for
    for (const sim::Panel& was : before.panels) {
        const auto now = std::ranges::find(changed.panels, was.name, &sim::Panel::name);
        if (now == changed.panels.end() || told.contains(was.name)) continue;
        const auto link = sim::link_of(was);
        if (link && !sim::link_of(*now))
            notes.push_back("'" + was.name + "' is no longer linked to '" + link->source + "'");
        if (sim::has_linked_halves(was) && was.fold_key != now->fold_key)
            notes.push_back("the halves of '" + was.name + "' are no longer linked");
    }
}

Changed changed_by(const sim::Pattern& before, const Command& command, const PanelStates& states) {
    Changed changed{.pattern = before};
    sim::Pattern& pattern = changed.pattern;
    changed.outcome = apply(pattern, command);
    std::optional<Selection>& selection = changed.outcome.selection;
    const sim::Pattern applied = pattern;
    follow_links(pattern, before, states.locked);
    tell_ended_links(pattern, before, command, changed.outcome.notes);
    keep_sheet_positions(pattern, before);
    require_limits(pattern, before);
    changed.sources = sources_of(pattern);
    pattern = evaluate(changed.sources);
    if (selection) selection = carried(std::move(*selection), applied, pattern);
    return changed;
}

Changed changed_by(const sim::Pattern& before, const std::vector<Command>& commands, const PanelStates& states) {
    SELVEDGE_ASSERT(!commands.empty());
    Changed changed = changed_by(before, commands.front(), states);
    for (std::size_t i = 1; i < commands.size(); ++i) {
        Changed next = changed_by(changed.pattern, commands[i], states);
        if (changed.outcome.rename || next.outcome.rename)
            throw GeometryError("A panel is renamed by a command that stands alone");
        if (!next.outcome.selection && changed.outcome.selection)
            next.outcome.selection = carried(std::move(*changed.outcome.selection), changed.pattern, next.pattern);
        std::ranges::move(next.outcome.notes, std::back_inserter(changed.outcome.notes));
        next.outcome.notes = std::move(changed.outcome.notes);
        changed = std::move(next);
    }
    return changed;
}

// Of mirror images that a file places otherwise than their sources do.
std::vector<std::string> moved_images(const sim::Pattern& in_file, const sim::Pattern& evaluated) {
    constexpr double kMoved = 1e-4;  // m
    std::vector<std::string> notes;
    for (std::size_t i = 0; i < in_file.panels.size(); ++i) {
        const sim::Panel& was = in_file.panels[i];
        const sim::Panel& now = evaluated.panels[i];
        const bool has_moved = sim::link_of(now) && std::ranges::any_of(now.vertices, [&](const Vec2d& u) {
                                   return (was.place(u) - now.place(u)).norm() > kMoved;
                               });
        if (has_moved) notes.push_back("'" + now.name + "' was moved to where the mirror image of its source stands");
    }
    return notes;
}

}  // namespace

Document::Document(sim::PatternDocument source) : source_(std::move(source)) {
    const auto newer = read_only_reason();  // which is told otherwise
    std::erase_if(source_.warnings, [&](const sim::Fault& warning) { return warning.problem == newer; });
    notes_ = take_up(source_);
    sources_ = sources_of(source_.pattern);
    sim::Pattern evaluated = evaluate(sources_);
    std::ranges::move(moved_images(source_.pattern, evaluated), std::back_inserter(notes_));
    source_.pattern = std::move(evaluated);
}

void Document::select(Selection selection) {
    selection_ = clean_selection(std::move(selection), source_.pattern);
}

void Document::set_panel_states(PanelStates states) {
    panel_states_ = clean_states(std::move(states), source_.pattern);
    selection_ = changeable();
}

void Document::run_together(const std::vector<Command>& commands) {
    rollback();
    Changed changed = changed_by(source_.pattern, commands, panel_states_);
    HistoryEntry entry{
        .label = label_of(commands.front()), .patch = difference(sources_, changed.sources), .before = selection_};
    if (const auto& rename = changed.outcome.rename) {
        FileNames names = renamed(file_names_, rename->from, rename->to);
        entry.file_names.emplace(std::exchange(file_names_, names), std::move(names));
        entry.rename = rename;
        panel_states_ = renamed(std::move(panel_states_), rename->from, rename->to);
    }
    const Selection selected =
        changed.outcome.selection ? *changed.outcome.selection : carried(selection_, source_.pattern, changed.pattern);
    std::ranges::move(changed.outcome.notes, std::back_inserter(notes_));
    show(std::move(changed.sources), std::move(changed.pattern), selected);
    note(journal_line(commands));
    remember(std::move(entry));
}

void Document::preview(const Command& command) {
    const sim::Pattern before = is_previewing_ ? evaluate(before_preview_) : source_.pattern;
    Changed changed = changed_by(before, command, panel_states_);
    SELVEDGE_ASSERT(!changed.outcome.rename);  // a drag never renames
    if (!is_previewing_) {
        before_preview_ = sources_;
        selected_before_ = selection_;
        is_previewing_ = true;
    }
    previewed_ = label_of(command);
    const Selection selected =
        changed.outcome.selection ? *changed.outcome.selection : carried(selected_before_, before, changed.pattern);
    show(std::move(changed.sources), std::move(changed.pattern), selected);
    note(journal_preview(command));
}

void Document::commit() {
    if (!is_previewing_) return;
    is_previewing_ = false;
    note(journal_action(JournalAction::Commit));
    remember({.label = previewed_, .patch = difference(before_preview_, sources_), .before = selected_before_});
}

void Document::rollback() {
    if (!is_previewing_) return;
    is_previewing_ = false;
    sim::Pattern pattern = evaluate(before_preview_);
    show(std::move(before_preview_), std::move(pattern), selected_before_);
    note(journal_action(JournalAction::Rollback));
}

// A command without effect gets no history entry.
void Document::remember(HistoryEntry entry) {
    if (entry.patch.is_empty()) return;
    entry.after = selection_;
    history_.erase(history_.begin() + static_cast<std::ptrdiff_t>(position_), history_.end());
    if (saved_position_ && *saved_position_ > position_) saved_position_.reset();
    history_.push_back(std::move(entry));
    ++position_;
}

void Document::undo() {
    rollback();
    if (!can_undo()) return;
    const HistoryEntry& entry = history_[--position_];
    sim::Sources sources = std::move(sources_);
    selvedge::editor::undo(sources, entry.patch);
    if (entry.file_names) file_names_ = entry.file_names->first;
    if (entry.rename) panel_states_ = renamed(std::move(panel_states_), entry.rename->to, entry.rename->from);
    sim::Pattern pattern = evaluate(sources);
    show(std::move(sources), std::move(pattern), entry.before);
    note(journal_action(JournalAction::Undo));
}

void Document::redo() {
    rollback();
    if (!can_redo()) return;
    const HistoryEntry& entry = history_[position_++];
    sim::Sources sources = std::move(sources_);
    apply(sources, entry.patch);
    if (entry.file_names) file_names_ = entry.file_names->second;
    if (entry.rename) panel_states_ = renamed(std::move(panel_states_), entry.rename->from, entry.rename->to);
    sim::Pattern pattern = evaluate(sources);
    show(std::move(sources), std::move(pattern), entry.after);
    note(journal_action(JournalAction::Redo));
}

void Document::go_to(std::size_t position) {
    SELVEDGE_ASSERT(position <= history_.size());
    rollback();
    while (position_ > position) undo();
    while (position_ < position) redo();
}

std::string Document::text(const std::string& file) const {
    return write_json(pattern_as_json(source_.pattern, with_present_names(source_.json, file_names_), file));
}

bool Document::has_unsaved_changes() const {
    return is_previewing_ || saved_position_ != position_;
}

void Document::mark_saved() {
    saved_position_ = position_;
}

void Document::show(sim::Sources sources, sim::Pattern pattern, const Selection& selected) {
    sources_ = std::move(sources);
    source_.pattern = std::move(pattern);
    panel_states_ = clean_states(std::move(panel_states_), source_.pattern);
    select(selected);
    ++revision_;
}

void Document::note(const sim::Json& line) const {
    if (journal_) journal_(write_json(line, -1));
}

namespace {

// A temporary name that no panel has, for exchanging names.
std::string between(const std::string& name) {
    return "\x01" + name;
}

void forget_panel(sim::Json& specification, const std::string& name) {
    sim::Json* garment = specification.find("pattern");
    if (sim::Json* panels = garment ? garment->find("panels") : nullptr; panels && panels->is_object())
        panels->erase(name);
}

}  // namespace

FileNames renamed(FileNames names, const std::string& from, const std::string& to) {
    const auto found = names.find(from);
    const std::string in_file = found == names.end() ? from : found->second;
    if (found != names.end()) names.erase(found);
    names.insert_or_assign(to, in_file);
    return names;
}

sim::Json with_present_names(sim::Json specification, const FileNames& names) {
    for (const auto& [present, in_file] : names) rename_panel_in_file(specification, in_file, between(present));
    for (const auto& [present, in_file] : names) {
        forget_panel(specification, present);
        rename_panel_in_file(specification, between(present), present);
    }
    return specification;
}

}  // namespace selvedge::editor

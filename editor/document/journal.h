#pragma once
// The journal of a document: a line of JSON for each change, from which the document can be made again after a program
// was killed. What keeps the lines is not known here.
//
//   {"selvedge_journal": 1, "file": "shirt.json", "text": "..."}    the first line: what was opened, as it was then
//   {"do": {"move_vertices": {...}}}                                 a command
//   {"try": {...}}, then {"keep": true} or {"drop": true}            a drag, with each of its moves
//   {"undo": true}, {"redo": true}
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "editor/document/command.h"
#include "sim/core/json.h"
#include "sim/pattern/pattern.h"

namespace selvedge::editor {

class Document;

enum class JournalWord { Keep, Drop, Undo, Redo };

sim::Json journal_line(const Command& command);
sim::Json journal_preview(const Command& command);
sim::Json journal_word(JournalWord word);

// The first line. `file`: where the document is saved; empty: nowhere yet. `text`: the document when the journal
// begins.
std::string journal_head(std::string_view file, std::string_view text);

// What can be had from a journal. Lines that are torn or unknown end it: what came before them holds.
struct Recovery {
    std::string file;
    std::string text = {};  // of the document as it was when the journal ended, a drag that was under way included
    int changes = 0;        // that were made since its first line
};

// None: it has no sound first line.
std::optional<Recovery> recover(std::string_view journal);

// The difference between two states of a pattern, small where the change is small: what a history keeps.

struct PatternPatch {
    // Panels by index: in `before` and `after` they have in common the first and the last ones; these lie between.
    std::size_t first_panel = 0;
    std::vector<sim::Panel> panels_before;
    std::vector<sim::Panel> panels_after;
    std::optional<std::pair<std::vector<sim::Seam>, std::vector<sim::Seam>>> seams;  // before, after
    std::optional<std::pair<sim::Pattern, sim::Pattern>> rest;  // the same, without panels and seams

    bool is_empty() const { return panels_before.empty() && panels_after.empty() && !seams && !rest; }
};

PatternPatch difference(const sim::Pattern& before, const sim::Pattern& after);

// Pre: the pattern is what the patch was made from: `before` to apply it, `after` to undo it.
void apply(sim::Pattern& pattern, const PatternPatch& patch);
void undo(sim::Pattern& pattern, const PatternPatch& patch);

}  // namespace selvedge::editor

#pragma once
// The journal of a document: one line of JSON per change, from which the document can be recovered after a crash. The
// caller stores the lines.
//
//   {"selvedge_journal": 1, "file": "shirt.json", "text": "..."}    first line: the opened file and its text; with
//   "unsaved": true if that text is in no file, as after a recovery; with "file_hash": the SHA-256 of what the file
//   held
//   {"do": {"move_vertices": {...}}}                                 a command
//   {"do": [{"set_fabric": {...}}, {"set_fabric": {...}}]}           several, as one step of the history
//   {"try": {...}}, then {"keep": true} or {"drop": true}            a drag: one line per preview
//   {"undo": true}, {"redo": true}
//   {"draft": {"fabric": "silk", "text": "..."}}    values of a fabric that are edited and not saved; the last one
//   counts
//   {"no_draft": "silk"}                            they were saved or dropped
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/document/command.h"
#include "sim/core/json.h"
#include "sim/pattern/fabric.h"

namespace selvedge::editor {

class Document;

enum class JournalAction { Commit, Rollback, Undo, Redo };

sim::Json journal_line(const Command& command);
sim::Json journal_line(const std::vector<Command>& commands);  // Pre: not empty
sim::Json journal_preview(const Command& command);
sim::Json journal_action(JournalAction action);

// fabric: its name or file. Throws InputError if a value of the draft is out of range.
sim::Json journal_draft(const std::string& fabric, const sim::Fabric& draft);
sim::Json journal_no_draft(const std::string& fabric);

// How the document at the start of a journal and its file differ.
struct JournalStart {
    bool is_unsaved = false;     // the document has changes that are in no file
    std::string file_hash = {};  // SHA-256 of what the file held when it was last read or written; empty: not known
};

// The first line. `file`: the document's file; empty: not saved yet. `text`: the document at the start of the journal.
std::string journal_head(std::string_view file, std::string_view text, const JournalStart& start = {});

// The result of a recovery. It stops at the first incomplete or invalid line and keeps the changes before it.
struct Recovery {
    std::string file;
    std::string text = {};     // the document at the end of the journal, with an unfinished drag committed
    bool has_lines = false;    // lines were applied to the document
    int changes = 0;           // that made it so, as its history counts them: a drag is one
    int unread_lines = 0;      // complete lines from the first invalid one on: the journal is damaged
    bool was_unsaved = false;  // the journal began with changes that are in no file
    std::optional<std::string> file_hash = {};       // of what the file held then; none: not known
    std::map<std::string, sim::Fabric> drafts = {};  // by the fabric's name or file

    bool has_changes() const { return has_lines || was_unsaved; }  // of the garment
};

// None: the first line is missing or invalid.
std::optional<Recovery> recover(std::string_view journal);

}  // namespace selvedge::editor

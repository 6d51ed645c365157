#include "editor/document/journal.h"

#include <algorithm>
#include <stdexcept>

#include "editor/document/command.h"
#include "editor/document/document.h"
#include "editor/geometry/draft.h"
#include "sim/core/error.h"
#include "sim/pattern/fabric_file.h"

namespace selvedge::editor {
namespace {

constexpr const char* kHead = "selvedge_journal";
constexpr int kVersion = 1;
constexpr const char* kFile = "a journal";  // file name in errors, which are caught here

const char* name(JournalAction action) {
    switch (action) {
        case JournalAction::Commit:
            return "keep";
        case JournalAction::Rollback:
            return "drop";
        case JournalAction::Undo:
            return "undo";
        case JournalAction::Redo:
            return "redo";
    }
    return "";
}

sim::Json one_member(const char* key, sim::Json value) {
    sim::Json line = sim::Json::object();
    line[key] = std::move(value);
    return line;
}

// Removes and returns the next complete line. None: no line break is left (an incomplete last line).
std::optional<std::string_view> take_line(std::string_view& rest) {
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end + 1);
    return line;
}

std::vector<Command> parse_commands(const sim::JsonView& view) {
    if (!view.value().is_array()) return {parse_command(view)};
    std::vector<Command> commands;
    for (std::size_t i = 0; i < view.size(); ++i) commands.push_back(parse_command(view.at(i)));
    if (commands.empty()) view.fail("no command");
    return commands;
}

Command parse_preview(const sim::JsonView& view) {
    Command command = parse_command(view);
    if (std::holds_alternative<RenamePanel>(command)) view.fail("a drag never renames");
    return command;
}

// Replays one line. Throws InputError or GeometryError if that is not possible.
void play(Document& document, const sim::JsonView& view) {
    if (view.has("do")) return document.run_together(parse_commands(view.at("do")));
    if (view.has("try")) return document.preview(parse_preview(view.at("try")));
    if (view.has("keep")) return document.commit();
    if (view.has("drop")) return document.rollback();
    if (view.has("undo")) return document.undo();
    if (view.has("redo")) return document.redo();
    view.fail("no line of a journal");
}

// Whether the line is about a draft, which is then taken. Throws InputError.
bool take_draft(std::map<std::string, sim::Fabric>& drafts, const sim::JsonView& view) {
    if (view.has("no_draft")) {
        drafts.erase(view.at("no_draft").string());
        return true;
    }
    if (!view.has("draft")) return false;
    const sim::JsonView draft = view.at("draft");
    drafts[draft.at("fabric").string()] = sim::parse_fabric(draft.at("text").string(), "");
    return true;
}

}  // namespace

sim::Json journal_line(const Command& command) {
    return one_member("do", to_json(command));
}

sim::Json journal_line(const std::vector<Command>& commands) {
    if (commands.size() == 1) return journal_line(commands.front());
    sim::Json list = sim::Json::array();
    for (const Command& command : commands) list.push_back(to_json(command));
    return one_member("do", std::move(list));
}

sim::Json journal_preview(const Command& command) {
    return one_member("try", to_json(command));
}

sim::Json journal_action(JournalAction action) {
    return one_member(name(action), sim::Json(true));
}

// The text is that of a fabric file without a place, so that it names a picture by its whole path.
sim::Json journal_draft(const std::string& fabric, const sim::Fabric& draft) {
    sim::Json content = one_member("fabric", sim::Json(fabric));
    content["text"] = write_fabric(draft, "");
    return one_member("draft", std::move(content));
}

sim::Json journal_no_draft(const std::string& fabric) {
    return one_member("no_draft", sim::Json(fabric));
}

std::string journal_head(std::string_view file, std::string_view text, const JournalStart& start) {
    sim::Json head = one_member(kHead, sim::Json(kVersion));
    head["file"] = file;
    head["text"] = text;
    if (start.is_unsaved) head["unsaved"] = true;
    if (!start.file_hash.empty()) head["file_hash"] = sim::Json(start.file_hash);
    return write_json(head, -1);
}

std::optional<Recovery> recover(std::string_view journal) {
    const auto head_line = take_line(journal);
    if (!head_line) return std::nullopt;
    try {
        const sim::Json head = sim::parse_json(*head_line, kFile);
        const sim::JsonView view(head, kFile);
        if (view.at(kHead).integer() != kVersion) return std::nullopt;
        std::string_view unread = journal;  // from the line that is being played on
        Recovery recovery{.file = view.at("file").string()};
        recovery.was_unsaved = view.has("unsaved");
        if (view.has("file_hash")) recovery.file_hash = view.at("file_hash").string();
        Document document(sim::parse_pattern(view.at("text").string(), recovery.file));
        try {
            while (const auto line = take_line(journal)) {
                const sim::Json json = sim::parse_json(*line, kFile);
                const sim::JsonView change(json, kFile);
                if (!take_draft(recovery.drafts, change)) {
                    play(document, change);
                    recovery.has_lines = true;
                }
                unread = journal;
            }
        } catch (const std::runtime_error&) {  // invalid line: keep the changes before it
            recovery.unread_lines = static_cast<int>(std::ranges::count(unread, '\n'));
        }
        document.commit();
        recovery.changes = static_cast<int>(document.position());
        recovery.text = document.text(recovery.file);
        return recovery;
    } catch (const sim::InputError&) {
        return std::nullopt;
    }
}

}  // namespace selvedge::editor

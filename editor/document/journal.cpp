#include "editor/document/journal.h"

#include <stdexcept>

#include "editor/document/command_json.h"
#include "editor/document/document.h"
#include "editor/drafting/draft_error.h"
#include "sim/core/error.h"

namespace selvedge {
namespace {

constexpr const char* kHead = "selvedge_journal";
constexpr int kVersion = 1;
constexpr const char* kFile = "a journal";  // in errors that nobody sees

const char* name(JournalWord word) {
    switch (word) {
        case JournalWord::Keep:
            return "keep";
        case JournalWord::Drop:
            return "drop";
        case JournalWord::Undo:
            return "undo";
        case JournalWord::Redo:
            return "redo";
    }
    return "";
}

Json one_member(const char* key, Json value) {
    Json line = Json::object();
    line[key] = std::move(value);
    return line;
}

// Takes the next whole line off the front; a last one without its end is torn.
std::optional<std::string_view> take_line(std::string_view& rest) {
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end + 1);
    return line;
}

// Plays one line. Throws InputError or DraftError where it cannot be.
void play(Document& document, std::string_view line) {
    const Json json = parse_json(line, kFile);
    const JsonView view(json, kFile);
    if (view.has("do")) return document.run(parse_command(view.at("do")));
    if (view.has("try")) return document.attempt(parse_command(view.at("try")));
    if (view.has("keep")) return document.keep();
    if (view.has("drop")) return document.drop();
    if (view.has("undo")) return document.undo();
    if (view.has("redo")) return document.redo();
    view.fail("no line of a journal");
}

}  // namespace

Json journal_line(const Command& command) {
    return one_member("do", to_json(command));
}

Json journal_attempt(const Command& command) {
    return one_member("try", to_json(command));
}

Json journal_word(JournalWord word) {
    return one_member(name(word), Json(true));
}

std::string journal_head(std::string_view file, std::string_view text) {
    Json head = one_member(kHead, Json(kVersion));
    head["file"] = file;
    head["text"] = text;
    return write_json(head, -1);
}

std::optional<Recovery> recover(std::string_view journal) {
    const auto head_line = take_line(journal);
    if (!head_line) return std::nullopt;
    try {
        const Json head = parse_json(*head_line, kFile);
        const JsonView view(head, kFile);
        if (view.at(kHead).integer() != kVersion) return std::nullopt;
        Recovery recovery{.file = view.at("file").string()};
        Document document(parse_pattern(view.at("text").string(), recovery.file));
        try {
            while (const auto line = take_line(journal)) {
                play(document, *line);
                ++recovery.changes;
            }
        } catch (const std::runtime_error&) {  // torn, or of another version: what came before holds
        }
        document.keep();
        recovery.text = document.text();
        return recovery;
    } catch (const InputError&) {
        return std::nullopt;
    }
}

}  // namespace selvedge

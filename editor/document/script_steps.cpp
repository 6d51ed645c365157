#include "editor/document/script_steps.h"

#include <algorithm>
#include <array>

#include "sim/core/error.h"
#include "sim/core/trimmed.h"

namespace selvedge::editor {
namespace {

constexpr std::array<std::string_view, 23> kVerbs{"where",      "expect", "open", "new",    "save",   "do",
                                                  "action",     "key",    "type", "move",   "press",  "release",
                                                  "click",      "double", "drag", "wheel",  "frames", "settle",
                                                  "screenshot", "export", "wear", "import", "print"};

// Splits at blanks; quoted text keeps its blanks.
std::vector<std::string> split_words(std::string_view text) {
    std::vector<std::string> words;
    std::string word;
    bool is_quoted = false, has_word = false;
    for (const char c : text) {
        if (c == '"') {
            is_quoted = !is_quoted;
            has_word = true;
        } else if (c == ' ' && !is_quoted) {
            if (has_word) words.push_back(word);
            word.clear();
            has_word = false;
        } else {
            word += c;
            has_word = true;
        }
    }
    if (has_word) words.push_back(word);
    return words;
}

}  // namespace

std::vector<ScriptStep> parse_script(std::string_view text, const std::string& file) {
    std::vector<ScriptStep> steps;
    int number = 0;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = sim::trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        ++number;
        if (line.empty() || line.front() == '#') continue;
        const std::size_t blank = std::min(line.find(' '), line.size());
        ScriptStep step{.line = number, .verb = std::string(line.substr(0, blank)), .arguments = {}, .rest = {}};
        step.rest = sim::trimmed(line.substr(blank));
        step.arguments = split_words(step.rest);
        if (std::find(kVerbs.begin(), kVerbs.end(), step.verb) == kVerbs.end()) {
            throw sim::InputError(file, "line " + std::to_string(number), "there is no step '" + step.verb + "'");
        }
        steps.push_back(std::move(step));
    }
    return steps;
}

}  // namespace selvedge::editor

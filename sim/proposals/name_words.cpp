#include "sim/proposals/name_words.h"

#include <glib.h>
#include <algorithm>
#include <memory>

namespace selvedge::sim {
namespace {

struct Free {
    void operator()(gchar* text) const { g_free(text); }
};
using Text = std::unique_ptr<gchar, Free>;

bool is_mark(gunichar letter) {
    const GUnicodeType type = g_unichar_type(letter);
    return type == G_UNICODE_NON_SPACING_MARK || type == G_UNICODE_SPACING_MARK || type == G_UNICODE_ENCLOSING_MARK;
}

void append(std::string& text, gunichar letter) {
    char bytes[6];
    text.append(bytes, static_cast<std::size_t>(g_unichar_to_utf8(letter, bytes)));
}

// Letters that Unicode does not divide into a letter and a mark, in lower case.
gunichar plain(gunichar letter) {
    switch (letter) {
        case 0x142:  // l with stroke
            return 'l';
        case 0xF8:  // o with stroke
            return 'o';
        case 0x111:  // d with stroke
            return 'd';
        case 0x131:  // dotless i
            return 'i';
        default:
            return letter;
    }
}

// In lower case and without accents; the short i of Cyrillic loses its mark, too.
std::string folded(std::string_view word) {
    const Text apart(g_utf8_normalize(word.data(), static_cast<gssize>(word.size()), G_NORMALIZE_ALL));
    std::string out;
    for (const gchar* at = apart.get(); *at != 0; at = g_utf8_next_char(at)) {
        const gunichar letter = g_utf8_get_char(at);
        if (!is_mark(letter)) append(out, plain(g_unichar_tolower(letter)));
    }
    return out;
}

std::size_t letters_of(std::string_view word) {
    return static_cast<std::size_t>(g_utf8_strlen(word.data(), static_cast<gssize>(word.size())));
}

// Chinese and Japanese: from the kana on.
bool is_written_together(std::string_view word) {
    constexpr gunichar kFirst = 0x3040;
    return !word.empty() && g_utf8_get_char(word.data()) >= kFirst;
}

}  // namespace

std::vector<std::string> words_of_name(std::string_view name) {
    if (name.empty()) return {};  // it may have no address
    const Text valid(g_utf8_make_valid(name.data(), static_cast<gssize>(name.size())));
    std::vector<std::string> words;
    gunichar last = ' ';
    for (const gchar* at = valid.get(); *at != 0; at = g_utf8_next_char(at)) {
        const gunichar letter = g_utf8_get_char(at);
        const bool is_letter = (g_unichar_isalpha(letter) || is_mark(letter)) && letter != 0xFFFD;
        if (is_letter || g_unichar_isdigit(letter)) {
            const bool goes_on =
                is_letter ? (g_unichar_isalpha(last) || is_mark(last)) && last != 0xFFFD : g_unichar_isdigit(last) != 0;
            const bool is_capital = g_unichar_isupper(letter) && g_unichar_islower(last);
            if (!goes_on || is_capital) words.emplace_back();
            append(words.back(), letter);
        }
        last = letter;
    }
    for (std::string& word : words) word = folded(word);
    std::erase(words, "");
    return words;
}

bool names_any(const std::vector<std::string>& words, std::string_view list) {
    constexpr std::size_t kCompound = 5;  // letters
    std::string together;
    for (const std::string& word : words) together += word;
    const auto is_named = [&](std::string_view known) {
        if (known.starts_with('=')) return std::ranges::find(words, known.substr(1)) != words.end();
        const std::string plain_known = folded(known);
        const std::size_t letters = letters_of(plain_known);
        const bool may_be_within = is_written_together(plain_known) || letters >= kCompound;
        if (may_be_within && together.find(plain_known) != std::string::npos) return true;
        return std::ranges::any_of(words, [&](const std::string& word) {
            return letters <= 2 ? word == plain_known : word.starts_with(plain_known);
        });
    };
    for (std::size_t from = 0; from < list.size();) {
        const std::size_t to = std::min(list.find(' ', from), list.size());
        if (is_named(list.substr(from, to - from))) return true;
        from = to + 1;
    }
    return false;
}

}  // namespace selvedge::sim

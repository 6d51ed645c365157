// The reading of threadcounts: words, then stripes, then the mirrored or plain repeat.
#include <algorithm>
#include <charconv>
#include <utility>

#include "sim/core/error.h"
#include "sim/tartan/sett.h"

namespace selvedge {
namespace {

struct Word {
    std::string text;
    std::string place;  // for errors
};

struct ReadStripe {
    SettStripe stripe;
    bool is_pivot = false;
};

bool is_letter(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
char upper(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

// Words end at blanks, commas, semicolons and, as threadcounts are also written "B24W4", where a letter follows a
// count. A colour's digits are none.
std::vector<Word> split_words(std::string_view text) {
    std::vector<std::string> words;
    std::string word;
    const auto finish = [&] {
        if (!word.empty()) words.push_back(std::exchange(word, {}));
    };
    for (const char c : text) {
        if (c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ',' || c == ';') {
            finish();
            continue;
        }
        const bool is_colour = word.find('=') != std::string::npos;
        if (!is_colour && is_letter(c) && !word.empty() && is_digit(word.back())) finish();
        word += c;
    }
    finish();
    std::vector<Word> result;
    for (std::size_t i = 0; i < words.size(); ++i) {
        result.push_back({words[i], "stripe " + std::to_string(i + 1) + " '" + words[i].substr(0, 32) + "'"});
    }
    return result;
}

[[noreturn]] void fail(const Word& word, const std::string& problem) {
    throw InputError("threadcount", word.place, problem);
}

Rgb8 colour_of(const Word& word, const std::string& code, const Palette& palette) {
    if (const auto own = palette.find(code); own != palette.end()) return own->second;
    const Palette& standard = standard_palette();
    if (const auto usual = standard.find(code); usual != standard.end()) return usual->second;
    fail(word, "no colour '" + code + "': give it before the stripes, as " + code + "=#RRGGBB");
}

int parse_count(const Word& word, std::string_view digits) {
    int count = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
    if (error != std::errc() || end != digits.data() + digits.size()) {
        fail(word, "a stripe is letters and a count, such as B24, or B/24 for a pivot");
    }
    if (count < 1 || count > kMaxSettThreads) {
        fail(word, "the count must be from 1 to " + std::to_string(kMaxSettThreads));
    }
    return count;
}

ReadStripe parse_stripe(const Word& word, const Palette& palette) {
    const auto letters_end = std::find_if_not(word.text.begin(), word.text.end(), is_letter);
    std::string code(word.text.begin(), letters_end);
    std::transform(code.begin(), code.end(), code.begin(), upper);
    std::string_view rest = std::string_view(word.text).substr(code.size());
    const bool is_pivot = rest.starts_with('/');
    if (is_pivot) rest.remove_prefix(1);
    if (code.empty()) fail(word, "a stripe starts with the letters of its colour, such as B24");
    const int count = parse_count(word, rest);
    return {{code, colour_of(word, code, palette), count}, is_pivot};
}

// "CODE=#RRGGBB"
void add_colour(const Word& word, Palette& palette) {
    const std::size_t equals = word.text.find('=');
    std::string code = word.text.substr(0, equals);
    if (code.empty() || !std::all_of(code.begin(), code.end(), is_letter)) {
        fail(word, "a colour is given as CODE=#RRGGBB, its code in letters");
    }
    std::transform(code.begin(), code.end(), code.begin(), upper);
    palette[code] = parse_colour(std::string_view(word.text).substr(equals + 1), "threadcount", word.place);
}

void check_pivots(const std::vector<ReadStripe>& stripes, const std::vector<Word>& words) {
    for (std::size_t i = 1; i + 1 < stripes.size(); ++i) {
        if (stripes[i].is_pivot) fail(words[i], "a pivot within the sett: only the first and the last stripe may be");
    }
    if (stripes.front().is_pivot != stripes.back().is_pivot) {
        const Word& lacking = stripes.front().is_pivot ? words.back() : words.front();
        fail(lacking, "one pivot alone: mark the first and the last stripe with a slash, or neither");
    }
}

}  // namespace

Sett parse_threadcount(std::string_view text, const Palette& palette) {
    Palette colours = palette;
    std::vector<Word> words;
    for (const Word& word : split_words(text)) {
        if (word.text.find('=') != std::string::npos) {
            add_colour(word, colours);
        } else if (word.text != "...") {  // some write the dots of "and so on" round a repeat
            words.push_back(word);
        }
    }
    if (words.empty()) throw InputError("threadcount", "", "no stripes: write, for example, B/24 W4 B24 R/2");

    std::vector<ReadStripe> read;
    for (const Word& word : words) read.push_back(parse_stripe(word, colours));
    check_pivots(read, words);

    Sett sett;
    sett.is_mirrored = read.front().is_pivot;
    for (const ReadStripe& stripe : read) sett.stripes.push_back(stripe.stripe);
    for (std::size_t i = read.size() - 1; sett.is_mirrored && i-- > 1;) sett.stripes.push_back(read[i].stripe);
    if (thread_count(sett) > kMaxSettThreads) {
        throw InputError("threadcount", "", "more than " + std::to_string(kMaxSettThreads) + " threads in a repeat");
    }
    return sett;
}

}  // namespace selvedge

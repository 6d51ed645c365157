#include "sim/tartan/sett.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "sim/core/assert.h"
#include "sim/core/error.h"

namespace selvedge::sim {
namespace {

int count_threads(const std::vector<SettStripe>& stripes) {
    int count = 0;
    for (const SettStripe& stripe : stripes) count += stripe.threads;
    return count;
}

std::vector<Rgb8> colours_of(const std::vector<SettStripe>& stripes) {
    std::vector<Rgb8> colours;
    for (const SettStripe& stripe : stripes) {
        colours.insert(colours.end(), static_cast<std::size_t>(stripe.threads), stripe.colour);
    }
    return colours;
}

}  // namespace

const std::vector<SettStripe>& weft_stripes(const Sett& sett) {
    return sett.weft_stripes.empty() ? sett.stripes : sett.weft_stripes;
}

int thread_count(const Sett& sett) {
    return count_threads(sett.stripes);
}

int weft_thread_count(const Sett& sett) {
    return count_threads(weft_stripes(sett));
}

double repeat_size(const Sett& sett) {
    return thread_count(sett) * sett.thread_spacing;
}

double weft_repeat_size(const Sett& sett) {
    return weft_thread_count(sett) * sett.thread_spacing;
}

std::vector<Rgb8> thread_colours(const Sett& sett) {
    return colours_of(sett.stripes);
}

std::vector<Rgb8> weft_thread_colours(const Sett& sett) {
    return colours_of(weft_stripes(sett));
}

Sett with_repeat_size(Sett sett, double size) {
    SELVEDGE_ASSERT(size > 0 && !sett.stripes.empty());
    const int threads = thread_count(sett);
    const int most = std::max(1, kMaxSettThreads / std::max(threads, weft_thread_count(sett)));
    const int factor = std::clamp(static_cast<int>(std::lround(size / (threads * sett.thread_spacing))), 1, most);
    for (SettStripe& stripe : sett.stripes) stripe.threads *= factor;
    for (SettStripe& stripe : sett.weft_stripes) stripe.threads *= factor;
    sett.thread_spacing = size / (threads * factor);
    return sett;
}

// The most frequent colours for these codes in the Scottish Register of Tartans.
const Palette& standard_palette() {
    static const Palette palette{
        {"A", {0x5C, 0x8C, 0xA8}},  {"AA", {0x78, 0x94, 0x84}}, {"B", {0x2C, 0x2C, 0x80}},  {"BL", {0x14, 0x74, 0xB4}},
        {"C", {0xA0, 0x00, 0x48}},  {"DB", {0x20, 0x20, 0x60}}, {"DG", {0x00, 0x38, 0x20}}, {"DN", {0x5C, 0x5C, 0x5C}},
        {"DP", {0x44, 0x00, 0x44}}, {"DR", {0x88, 0x00, 0x00}}, {"DT", {0x44, 0x18, 0x00}}, {"G", {0x00, 0x68, 0x18}},
        {"GO", {0xBC, 0x8C, 0x00}}, {"HG", {0x28, 0x58, 0x00}}, {"K", {0x10, 0x10, 0x10}},  {"LB", {0x28, 0x88, 0xC4}},
        {"LG", {0x28, 0x9C, 0x18}}, {"LN", {0xC0, 0xC0, 0xC0}}, {"LP", {0xB4, 0x68, 0xAC}}, {"LT", {0xA0, 0x88, 0x58}},
        {"M", {0x90, 0x1C, 0x38}},  {"MY", {0xD0, 0x98, 0x00}}, {"N", {0x88, 0x88, 0x88}},  {"NB", {0x00, 0x3C, 0x64}},
        {"O", {0xD8, 0x7C, 0x00}},  {"OG", {0x5C, 0x64, 0x28}}, {"P", {0x78, 0x00, 0x78}},  {"R", {0xC8, 0x00, 0x00}},
        {"RB", {0x1C, 0x00, 0x70}}, {"SB", {0xA8, 0xAC, 0xE8}}, {"T", {0x60, 0x40, 0x00}},  {"W", {0xE0, 0xE0, 0xE0}},
        {"WG", {0x40, 0x80, 0x60}}, {"WW", {0xFC, 0xFC, 0xFC}}, {"Y", {0xE8, 0xC0, 0x00}},  {"YT", {0xD8, 0xB0, 0x00}}};
    return palette;
}

Rgb8 parse_colour(std::string_view text, const std::string& file, const std::string& place) {
    const auto fail = [&] {
        throw InputError(file, place, "a colour is # and six hexadecimal digits, such as #2C2C80");
    };
    if (text.size() != 7 || text[0] != '#') fail();
    unsigned value = 0;
    const auto [end, error] = std::from_chars(text.data() + 1, text.data() + 7, value, 16);
    if (error != std::errc() || end != text.data() + 7) fail();
    return {static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>((value >> 8) & 0xFF),
            static_cast<std::uint8_t>(value & 0xFF)};
}

// The parser of threadcounts: splits the text into words, the words into sections (warp, weft, weave), parses the
// stripes, and expands them to a mirrored or plain repeat.

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

// A word ends at a blank, comma or semicolon, after a colon, and before a letter that follows a count ("B24W4"). In a
// colour definition ("S=#A09060") letters after digits do not end the word.
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
        if (c == ':') finish();
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

std::string lower(std::string text) {
    for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return text;
}

// The words before "weft:" or "weave:" (the warp), and those after each of them, with the palette.
struct Sections {
    std::vector<Word> warp;
    std::vector<Word> weft;
    bool has_weft = false;
    std::vector<Word> weave;
    bool has_weave = false;
    Palette colours;
};

Sections split_sections(std::string_view text, const Palette& palette) {
    Sections sections;
    sections.colours = palette;
    std::vector<Word>* section = &sections.warp;
    const auto begin = [&](const Word& word, bool& is_there, std::vector<Word>& words) {
        if (std::exchange(is_there, true)) fail(word, "given twice");
        section = &words;
    };
    for (const Word& word : split_words(text)) {
        if (word.text.ends_with(':')) {
            const std::string name = lower(word.text);
            if (name == "weft:") {
                begin(word, sections.has_weft, sections.weft);
            } else if (name == "weave:") {
                begin(word, sections.has_weave, sections.weave);
            } else {
                fail(word, "only weft: and weave: end in a colon");
            }
        } else if (word.text.find('=') != std::string::npos) {
            add_colour(word, sections.colours);
        } else if (word.text != "...") {  // some threadcounts have "..." before and after the repeat
            section->push_back(word);
        }
    }
    return sections;
}

struct Repeat {
    std::vector<SettStripe> stripes;
    bool is_mirrored = false;
};

Repeat expand(const std::vector<Word>& words, const Palette& colours, const std::string& whose) {
    if (words.empty()) {
        throw InputError("threadcount", "", "no stripes" + whose + ": write, for example, B/24 W4 B24 R/2");
    }
    std::vector<ReadStripe> read;
    read.reserve(words.size());
    for (const Word& word : words) read.push_back(parse_stripe(word, colours));
    check_pivots(read, words);
    Repeat repeat;
    repeat.is_mirrored = read.front().is_pivot;
    int threads = 0;
    const auto lay = [&](const SettStripe& stripe) {
        repeat.stripes.push_back(stripe);
        threads = std::min(threads + stripe.threads, kMaxSettThreads + 1);
    };
    for (const ReadStripe& stripe : read) lay(stripe.stripe);
    for (std::size_t i = read.size() - 1; repeat.is_mirrored && i-- > 1;) lay(read[i].stripe);
    if (threads > kMaxSettThreads) {
        throw InputError("threadcount", "",
                         "more than " + std::to_string(kMaxSettThreads) + " threads in a repeat" + whose);
    }
    return repeat;
}

}  // namespace

std::optional<Weave> parse_weave(std::string_view name) {
    const std::string plain = lower(std::string(name));
    if (plain == "plain") return Weave::Plain;
    if (plain == "twill") return Weave::Twill22;
    if (plain == "denim") return Weave::Twill31;
    return {};
}

Sett parse_threadcount(std::string_view text, const Palette& palette) {
    const Sections sections = split_sections(text, palette);
    Sett sett;
    Repeat warp = expand(sections.warp, sections.colours, "");
    sett.stripes = std::move(warp.stripes);
    sett.is_mirrored = warp.is_mirrored;
    if (sections.has_weft) {
        Repeat weft = expand(sections.weft, sections.colours, " of the weft");
        sett.weft_stripes = std::move(weft.stripes);
        sett.is_weft_mirrored = weft.is_mirrored;
    }
    if (!sections.has_weave) return sett;
    const std::optional<Weave> weave =
        sections.weave.size() == 1 ? parse_weave(sections.weave.front().text) : std::nullopt;
    if (!weave) throw InputError("threadcount", "weave", std::string("one word is wanted: ") + kWeaveNames);
    sett.weave = *weave;
    return sett;
}

}  // namespace selvedge::sim

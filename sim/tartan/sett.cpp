#include "sim/tartan/sett.h"

#include <algorithm>
#include <array>
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

Rgb8 parse_named_colour(std::string_view text, const std::string& file, const std::string& place) {
    if (text.starts_with('#')) return parse_colour(text, file, place);
    return parse_colour('#' + std::string(text.substr(0, 6)), file, place);
}

// The parser of threadcounts: splits the text into words, the words into sections (warp, weft, weave), parses the
// stripes, and expands them to a mirrored or plain repeat.

namespace {

enum class WordKind {
    Stripe,    // or what should be one
    Colour,    // "B=#2C2C80", "B=2C2C80BLUE"
    Heading,   // "weft:"
    Dot,       // alone: the weft follows
    Ellipsis,  // before and after what repeats
    Remark,    // "Threadcount given over a half sett with full count at the pivots."
};

struct Word {
    std::string text;
    std::string place{};  // for errors
    WordKind kind = WordKind::Stripe;
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
bool is_line_end(char c) {
    return c == '\n' || c == '\r';
}
bool is_gap(char c) {
    return c == ' ' || c == '\t' || is_line_end(c) || c == ',' || c == ';' || c == '"';
}
char upper(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

std::string lower(std::string text) {
    for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return text;
}

// Words without a colour, which the registers write over the parts of an entry, with a colon or on a line of their own.
bool is_heading(std::string_view word) {
    constexpr std::array<std::string_view, 9> kHeadings{"thread",  "threadcount", "count",   "sett",  "warp",
                                                        "palette", "pallet",      "colours", "colors"};
    return std::ranges::find(kHeadings, lower(std::string(word))) != kHeadings.end();
}

// Splits a text into words. Words end at blanks, commas and semicolons, after a colon, at dots, and before a letter
// that follows a count ("B24W4"). A colour's name belongs to its word: it goes on to the semicolon, the line's end, or
// the next stripe or colour ("LT=E8CCB8LIGHT BROWN;").
class WordSplitter {
 public:
    explicit WordSplitter(std::string_view text) : rest_(text) {}

    std::vector<Word> words() {
        while (skip_gaps()) add_word();
        for (std::size_t i = 0; i < words_.size(); ++i) {
            words_[i].place = "stripe " + std::to_string(i + 1) + " '" + words_[i].text.substr(0, 32) + "'";
        }
        return std::move(words_);
    }

 private:
    bool skip_gaps() {
        while (!rest_.empty() && is_gap(rest_.front())) rest_.remove_prefix(1);
        return !rest_.empty();
    }

    void take(std::size_t count, WordKind kind) {
        words_.push_back({.text = std::string(rest_.substr(0, count)), .kind = kind});
        rest_.remove_prefix(count);
    }

    void add_word() {
        constexpr std::string_view kEllipsis = "\xE2\x80\xA6";
        if (rest_.starts_with(kEllipsis)) return take(kEllipsis.size(), WordKind::Ellipsis);
        if (rest_.front() == '.') {
            const std::size_t dots = std::min(rest_.find_first_not_of('.'), rest_.size());
            return take(dots, dots == 1 ? WordKind::Dot : WordKind::Ellipsis);
        }
        constexpr std::string_view kRemark = "threadcount given";
        if (lower(std::string(rest_.substr(0, kRemark.size()))) == kRemark)
            return take(std::min(rest_.find_first_of(".\r\n"), rest_.size() - 1) + 1, WordKind::Remark);
        const std::size_t end = end_of_word();
        const std::string_view word = rest_.substr(0, end);
        if (word.find('=') != word.npos) {
            take(end, WordKind::Colour);
            return skip_name();
        }
        take(end, word.ends_with(':') || is_heading(word) ? WordKind::Heading : WordKind::Stripe);
    }

    // Of a colour: after its digits, and the letters that follow them without a blank.
    std::size_t end_of_word() const {
        bool is_colour = false;
        for (std::size_t i = 0; i < rest_.size(); ++i) {
            const char c = rest_[i];
            if (is_gap(c)) return i;
            is_colour |= c == '=';
            if (is_colour) continue;
            if (c == ':') return i + 1;
            const bool follows_count = i > 0 && is_digit(rest_[i - 1]);
            if (i > 0 && (c == '.' || c == '\xE2' || (is_letter(c) && follows_count))) return i;
        }
        return rest_.size();
    }

    // Passes over further words of a colour's name, or a name that a semicolon parts from the colour
    // ("G=006818;GREEN;").
    void skip_name() {
        const std::string& colour = words_.back().text;
        const std::size_t digits = colour.find('=') + (colour.find('#') == colour.npos ? 1 : 2);
        const bool has_name = colour.size() > digits + 6;
        if (!has_name && rest_.starts_with(';')) {
            const std::size_t end = rest_.find(';', 1);
            const std::string_view name = rest_.substr(1, end == rest_.npos ? 0 : end - 1);
            if (std::ranges::all_of(name, [](char c) { return is_letter(c) || c == ' '; }))
                rest_.remove_prefix(1 + name.size());
        }
        while (rest_.starts_with(' ')) {
            const std::size_t begin = std::min(rest_.find_first_not_of(' '), rest_.size());
            const std::string_view word = rest_.substr(begin, rest_.find_first_of(" ;,\t\r\n", begin) - begin);
            if (word.empty() || word.find_first_of("=:./") != word.npos || is_heading(word)) return;
            const bool is_stripe = is_letter(word.front()) && std::ranges::any_of(word, is_digit);
            if (is_stripe) return;
            rest_.remove_prefix(begin + word.size());
        }
    }

    std::string_view rest_;
    std::vector<Word> words_;
};

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

// "CODE=#RRGGBB" or "CODE=RRGGBBNAME"
void add_colour(const Word& word, Palette& palette) {
    const std::size_t equals = word.text.find('=');
    std::string code = word.text.substr(0, equals);
    if (code.empty() || !std::all_of(code.begin(), code.end(), is_letter)) {
        fail(word, "a colour is given as CODE=#RRGGBB, its code in letters");
    }
    std::transform(code.begin(), code.end(), code.begin(), upper);
    palette[code] = parse_named_colour(std::string_view(word.text).substr(equals + 1), "threadcount", word.place);
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

// The words before the weft or "weave:" (the warp), and those after each of them, with the palette.
struct Sections {
    std::vector<Word> warp;
    std::vector<Word> weft;
    bool has_weft = false;
    std::vector<Word> weave;
    bool has_weave = false;
    Palette colours;
    bool is_half_sett = false;     // stripes without slashes are mirrored too
    bool has_half_pivots = false;  // pivots count half their threads
};

class SectionSplitter {
 public:
    explicit SectionSplitter(const Palette& palette) { sections_.colours = palette; }

    Sections split(std::string_view text) {
        std::vector<Word> words = WordSplitter(text).words();
        while (!words.empty() && words.back().kind == WordKind::Dot) words.pop_back();  // the end of a sentence
        for (const Word& word : words) add(word);
        return std::move(sections_);
    }

 private:
    void add(const Word& word) {
        switch (word.kind) {
            case WordKind::Colour:
                return add_colour(word, sections_.colours);
            case WordKind::Heading:
                return begin_section(word);
            case WordKind::Dot:
                return begin(word, sections_.has_weft, sections_.weft);
            case WordKind::Ellipsis:
                return end_repeat(word);
            case WordKind::Remark:
                return take_remark(lower(word.text));
            case WordKind::Stripe:
                break;
        }
        if (is_ended_) fail(word, "'...' stands before the first and after the last stripe");
        section_->push_back(word);
    }

    void begin(const Word& word, bool& is_there, std::vector<Word>& words) {
        if (std::exchange(is_there, true)) fail(word, "given twice");
        section_ = &words;
        is_ended_ = false;
    }

    void begin_section(const Word& word) {
        const std::string name = lower(word.text);
        if (name == "weft:") return begin(word, sections_.has_weft, sections_.weft);
        if (name == "weave:") return begin(word, sections_.has_weave, sections_.weave);
        const bool is_of_colours = name.starts_with("palle") || name.starts_with("colo");
        const bool is_known = is_heading(std::string_view(name).substr(0, name.find(':')));
        const bool begins_warp = sections_.warp.empty() && !sections_.has_weft && !sections_.has_weave;
        if (!is_known || (!is_of_colours && !begins_warp))
            fail(word, "only weft: and weave: end in a colon, and before the stripes threadcount: and warp:");
    }

    void take_remark(const std::string& remark) {
        const auto says = [&](const char* words) { return remark.find(words) != remark.npos; };
        sections_.is_half_sett |= says("half sett") || says("half-sett");
        sections_.has_half_pivots |= says("half count") || says("half-count");
    }

    // The second of two in a row starts the weft: "...B24 W4... ...K24 G24..."
    void end_repeat(const Word& word) {
        if (section_->empty()) return;
        if (is_ended_) return begin(word, sections_.has_weft, sections_.weft);
        is_ended_ = true;
    }

    Sections sections_;
    std::vector<Word>* section_ = &sections_.warp;
    bool is_ended_ = false;  // the section's stripes
};

struct Repeat {
    std::vector<SettStripe> stripes;
    bool is_mirrored = false;
};

Repeat expand(const std::vector<Word>& words, const Sections& sections, const std::string& whose) {
    if (words.empty()) {
        throw InputError("threadcount", "", "no stripes" + whose + ": write, for example, B/24 W4 B24 R/2");
    }
    std::vector<ReadStripe> read;
    read.reserve(words.size());
    for (const Word& word : words) read.push_back(parse_stripe(word, sections.colours));
    const bool has_slash = std::ranges::any_of(read, &ReadStripe::is_pivot);
    if (sections.is_half_sett && !has_slash) read.front().is_pivot = read.back().is_pivot = true;
    check_pivots(read, words);
    for (ReadStripe& stripe : read) stripe.stripe.threads *= sections.has_half_pivots && stripe.is_pivot ? 2 : 1;
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

Palette parse_palette(std::string_view text) {
    Sections sections = SectionSplitter({}).split(text);
    if (!sections.warp.empty()) fail(sections.warp.front(), "no colour: colours are given as CODE=#RRGGBB");
    return std::move(sections.colours);
}

std::optional<Weave> parse_weave(std::string_view name) {
    const std::string plain = lower(std::string(name));
    if (plain == "plain") return Weave::Plain;
    if (plain == "twill") return Weave::Twill22;
    if (plain == "denim") return Weave::Twill31;
    return {};
}

Sett parse_threadcount(std::string_view text, const Palette& palette) {
    const Sections sections = SectionSplitter(palette).split(text);
    Sett sett;
    Repeat warp = expand(sections.warp, sections, "");
    sett.stripes = std::move(warp.stripes);
    sett.is_mirrored = warp.is_mirrored;
    if (sections.has_weft) {
        Repeat weft = expand(sections.weft, sections, " of the weft");
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

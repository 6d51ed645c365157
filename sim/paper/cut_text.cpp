#include "sim/paper/cut_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <optional>
#include <string>
#include <vector>

namespace selvedge::sim {
namespace {

// What a word says. From comes before the material, Filler says nothing.
enum class CutWord { Cut, Quantity, MaterialKey, Mirrored, Fold, From, Times, Length, Filler, Material };

struct Meaning {
    CutWord word;
    std::string_view material;  // its English name; of Material only
    std::string_view words;     // small letters, separated by blanks
};

constexpr std::array kMeanings = std::to_array<Meaning>({
    {CutWord::Cut, "", "cut zuschneiden schneiden zuschnitt couper coupez cortar corta corte knippen knip"},
    {CutWord::Quantity, "", "quantity anzahl menge quantité cantidad aantal"},
    {CutWord::MaterialKey, "", "material matériau matière materiaal"},
    {CutWord::Mirrored, "", "mirrored gespiegelt gegengleich miroir espejo reflejado gespiegeld"},
    {CutWord::Fold, "", "fold onfold bruch stoffbruch pli pliure doblez pliegue vouw stofvouw"},
    {CutWord::From, "", "from of aus de dans uit"},
    {CutWord::Times, "", "x × mal fois veces keer"},
    {CutWord::Length, "", "mm cm inch inches"},
    {CutWord::Filler, "", "plugin annotations main the each these"},
    {CutWord::Material, "fabric", "fabric stoff oberstoff hauptstoff tissu tela stof hoofdstof"},
    {CutWord::Material, "lining", "lining futter futterstoff doublure forro voering"},
    {CutWord::Material, "interfacing",
     "interfacing einlage vlieseline entoilage thermocollant entretela tussenvoering"},
    {CutWord::Material, "interlining", "interlining"},
    {CutWord::Material, "canvas", "canvas"},
    {CutWord::Material, "ribbing", "ribbing rib bündchen boordstof"},
});

bool has_word(std::string_view words, std::string_view word) {
    while (!words.empty()) {
        const std::size_t stop = std::min(words.find(' '), words.size());
        if (words.substr(0, stop) == word) return true;
        words.remove_prefix(std::min(stop + 1, words.size()));
    }
    return false;
}

class CutText {
 public:
    explicit CutText(std::string_view text) : text_(text), words_(words_of(text)) {}

    bool read(CutInstructions& cut) const {
        const std::optional<std::size_t> key = find(CutWord::Quantity);
        if (key == 0U) return read_quantity(cut);
        if (find(CutWord::MaterialKey) == 0U && has_colon()) return read_material(cut);
        if (read_times(cut)) return true;
        const std::optional<std::size_t> at = find(CutWord::Cut);
        const std::optional<int> count = at ? count_beside(*at) : std::nullopt;
        const bool is_on_fold = find(CutWord::Fold).has_value();
        if (is_on_fold && is_negated()) return false;
        if (!at && is_fold_phrase()) {
            cut.is_on_fold = true;  // "Cut 1" beside it does not say that it is not
            return true;
        }
        // "Cut on fold" says nothing of the number; "cut here" nothing at all.
        if (!count && !(at && is_on_fold)) return false;
        if (!count) {
            if (!cut.is_on_fold) cut.is_on_fold = true;
            return true;
        }
        const std::string material = material_after(*at);
        const bool is_main = material == "fabric" && !cut.material.empty() && cut.material != "fabric";
        if (cut.pieces && !is_main) {
            if (is_on_fold && !cut.is_on_fold) cut.is_on_fold = true;  // the number stands on a line of its own
            return true;
        }
        cut.pieces = count;
        cut.is_on_fold = is_on_fold || (!is_main && cut.is_on_fold.value_or(false));
        // Only FreeSewing, which says "cut 2 from", always says whether pieces are mirrored.
        const bool is_mirrored = find(CutWord::Mirrored).has_value();
        const bool is_freesewing = std::ranges::find(words_, "from") != words_.end();
        if (is_mirrored || is_freesewing) cut.are_mirrored = is_mirrored;
        if (is_main || cut.material.empty()) cut.material = material;
        return true;
    }

 private:
    static const Meaning* meaning_of(const std::string& word) {
        const auto found =
            std::ranges::find_if(kMeanings, [&](const Meaning& one) { return has_word(one.words, word); });
        return found == kMeanings.end() ? nullptr : &*found;
    }

    bool is(std::size_t at, CutWord word) const {
        const Meaning* meaning = at < words_.size() ? meaning_of(words_[at]) : nullptr;
        return meaning != nullptr && meaning->word == word;
    }

    std::optional<std::size_t> find(CutWord word) const {
        for (std::size_t i = 0; i < words_.size(); ++i) {
            if (is(i, word)) return i;
        }
        return std::nullopt;
    }

    // "Do not cut on fold": a no beside the word that it is about. "On fold, no seam allowance" says yes.
    bool is_negated() const {
        constexpr std::size_t kBeside = 2;  // words
        for (std::size_t i = 0; i < words_.size(); ++i) {
            if (!has_word("not don dont never nicht kein niet geen", words_[i])) continue;
            for (std::size_t k = i + 1; k <= i + kBeside; ++k) {
                if (is(k, CutWord::Cut) || is(k, CutWord::Fold)) return true;
            }
        }
        return false;
    }

    // "Place on fold", "C.F. fold", "1 x im Bruch", "sur la pliure": words that only say where the fold lies. A lone
    // "fold" may be a line along which the part is folded.
    bool is_fold_phrase() const {
        constexpr std::string_view where =
            "place on the at im am auf an sur la le au à en al op de het aan den tegen center centre front back cf cb "
            "c f b "
            "vordere hintere mitte vm hm milieu devant dos medio centro lomo";
        constexpr std::string_view whole = "onfold stoffbruch stofvouw";  // say it alone
        bool has_fold = false, is_placed = false;
        for (std::size_t i = 0; i < words_.size(); ++i) {
            const std::string& word = words_[i];
            const bool is_fold = is(i, CutWord::Fold);
            has_fold = has_fold || is_fold;
            is_placed = is_placed || has_word(where, word) || has_word(whole, word);
            const bool is_count = std::isdigit(static_cast<unsigned char>(word.front())) != 0 || word == "x1";
            if (!is_fold && !is_count && !has_word(where, word) && !is(i, CutWord::Times)) return false;
        }
        return has_fold && is_placed;
    }

    // "2xfabric": 2, and what stands behind it.
    struct Begun {
        int count;
        std::string_view rest;
    };
    static std::optional<Begun> begun_with_number(const std::string& word) {
        Begun begun{};
        const char* end = word.data() + word.size();
        const auto [stop, error] = std::from_chars(word.data(), end, begun.count);
        if (error != std::errc() || begun.count < 0 || begun.count > kMostPieces) return std::nullopt;
        begun.rest = {stop, static_cast<std::size_t>(end - stop)};
        return begun;
    }

    bool has_colon() const { return text_.find(':') != std::string_view::npos; }

    // "2", "2x": no length, as in "cut 1 cm away".
    std::optional<int> number_at(std::size_t at) const {
        if (at >= words_.size() || is(at + 1, CutWord::Length)) return std::nullopt;
        const auto begun = begun_with_number(words_[at]);
        if (!begun || !(begun->rest.empty() || begun->rest == "x" || begun->rest == "×")) return std::nullopt;
        return begun->count;
    }

    // Behind the word for cutting, or before it where nothing else is: "cut 2", "2 x zuschneiden". "Piece 5 cut on
    // fold" says no number.
    std::optional<int> count_beside(std::size_t at) const {
        if (const auto count = number_at(at + 1)) return count;
        const bool is_times = at > 0 && is(at - 1, CutWord::Times);
        const std::size_t number = at - (is_times ? 2 : 1);
        if (at < (is_times ? 2U : 1U)) return std::nullopt;
        const bool is_plain = std::isdigit(static_cast<unsigned char>(words_[number].back())) != 0;
        if (number > 0 && is_plain && !is_times) return std::nullopt;
        return number_at(number);
    }

    // A known material; else the word behind "from".
    std::string material_after(std::size_t at) const {
        for (const std::string& word : words_) {
            const Meaning* meaning = meaning_of(word);
            if (meaning != nullptr && meaning->word == CutWord::Material) return std::string(meaning->material);
        }
        bool is_after = false;
        for (std::size_t i = at; i < words_.size(); ++i) {
            if (is_after && meaning_of(words_[i]) == nullptr) return words_[i];
            is_after = is_after || is(i, CutWord::From);
        }
        return {};
    }

    // "2", or "1,1": as drawn, and mirrored.
    bool read_quantity(CutInstructions& cut) const {
        const std::optional<int> first = number_at(1);
        const std::optional<int> second = text_.find(',') != std::string_view::npos ? number_at(2) : std::nullopt;
        if (!first) return false;
        const int pieces = std::clamp(*first + second.value_or(0), 1, kMostPieces);
        cut.pieces = second ? pieces : std::max(pieces, cut.pieces.value_or(1));
        if (second) cut.are_mirrored = *second > 0;
        return true;
    }

    // "ANNOTATION: 2XFABRIC", "1X RIB": nothing but the number and the material, as Gerber AccuMark writes them beside
    // a quantity that is 0 or 1 for every piece.
    bool read_times(CutInstructions& cut) const {
        const std::size_t at = !words_.empty() && words_[0] == "annotation" ? 1 : 0;
        if (at >= words_.size() || words_.size() > at + 2) return false;
        const auto begun = begun_with_number(words_[at]);
        if (!begun || begun->count < 1 || !begun->rest.starts_with('x')) return false;
        const std::string joined(begun->rest.substr(1));  // "2XL" is a size: the material must be known
        if (joined.empty() != (words_.size() == at + 2)) return false;
        const Meaning* meaning = meaning_of(joined.empty() ? words_[at + 1] : joined);
        if (meaning == nullptr || meaning->word != CutWord::Material) return false;
        if (!cut.are_mirrored) cut.pieces = std::max(begun->count, cut.pieces.value_or(1));
        if (cut.material.empty()) cut.material = std::string(meaning->material);
        return true;
    }

    bool read_material(CutInstructions& cut) const {
        std::string_view name = text_.substr(text_.find(':') + 1);
        while (!name.empty() && name.front() == ' ') name.remove_prefix(1);
        while (!name.empty() && name.back() == ' ') name.remove_suffix(1);
        const std::vector<std::string> words = words_of(name);
        const Meaning* meaning = words.size() == 1 ? meaning_of(words[0]) : nullptr;
        const bool is_known = meaning != nullptr && meaning->word == CutWord::Material;
        cut.material = is_known ? std::string(meaning->material) : std::string(name);
        return true;
    }

    std::string_view text_;
    std::vector<std::string> words_;
};

}  // namespace

namespace {

// The instructions of a text, each from its "cut 2" on: FreeSewing writes all of a part on one label.
std::vector<std::string_view> instructions_of(std::string_view text) {
    const auto is_letter = [&](std::size_t i) {
        return std::isalnum(static_cast<unsigned char>(text[i])) || static_cast<unsigned char>(text[i]) >= 0x80;
    };
    constexpr std::string_view kCut = "cut,";
    std::vector<std::size_t> starts;
    for (std::size_t at = text.find(kCut); at != std::string_view::npos; at = text.find(kCut, at + kCut.size())) {
        const std::size_t number = at + kCut.size();
        const bool has_number = number < text.size() && std::isdigit(static_cast<unsigned char>(text[number])) != 0;
        if (has_number && (at == 0 || !is_letter(at - 1))) starts.push_back(at);
    }
    if (starts.empty()) starts.push_back(0);
    starts.front() = 0;
    std::vector<std::string_view> parts;
    for (std::size_t i = 0; i < starts.size(); ++i)
        parts.push_back(text.substr(starts[i], i + 1 < starts.size() ? starts[i + 1] - starts[i] : text.npos));
    return parts;
}

}  // namespace

bool read_cut_text(std::string_view text, CutInstructions& cut) {
    bool is_read = false;
    for (const std::string_view one : instructions_of(text)) is_read = CutText(one).read(cut) || is_read;
    return is_read;
}

bool names_fold(std::string_view text) {
    return std::ranges::any_of(words_of(text), [](const std::string& word) {
        return std::ranges::any_of(
            kMeanings, [&](const Meaning& one) { return one.word == CutWord::Fold && has_word(one.words, word); });
    });
}

std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    bool is_inside = false;
    for (const char c : text) {
        const bool is_letter = std::isalnum(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) >= 0x80;
        if (is_letter && !is_inside) words.emplace_back();
        if (is_letter) words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        is_inside = is_letter;
    }
    return words;
}

}  // namespace selvedge::sim

#include "sim/paper/page_labels.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <regex>
#include <set>

#include "sim/core/lower_case.h"

namespace selvedge::sim {
namespace {

constexpr std::size_t kLongestLabel = 120;  // bytes: regular expressions take long for long texts

// 0 for "A", 25 for "Z", 26 for "AA".
int number_of_letters(const std::string& letters) {
    int number = 0;
    for (const char c : letters) number = 26 * number + (std::toupper(static_cast<unsigned char>(c)) - 'A' + 1);
    return number - 1;
}

using NumberPair = std::pair<int, int>;

enum class LabelForm { Letter, Words, Numbers };

// "A1", "A-1", "B 12"; also where other words follow, as in "A1   page 1 of 9".
std::optional<NumberPair> letter_label(const std::string& text) {
    static const std::regex form("([A-Za-z]{1,2}) ?-?([0-9]{1,2})(?:$|[ ,;:|-].*)");
    static const std::regex turned("([0-9]{1,2})-?([A-Z])");
    std::smatch match;
    if (std::regex_match(text, match, form)) return NumberPair(number_of_letters(match[1]), std::stoi(match[2]) - 1);
    if (std::regex_match(text, match, turned)) return NumberPair(number_of_letters(match[2]), std::stoi(match[1]) - 1);
    return std::nullopt;
}

// "row 1, column 2", "Spalte 2 Reihe 1".
std::optional<NumberPair> word_label(const std::string& text) {
    static const std::regex rows("(?:row|reihe|zeile|rang|fila|rij|r)[ .:]*([0-9]{1,2})");
    static const std::regex columns("(?:column|col|spalte|colonne|columna|kolom|c)[ .:]*([0-9]{1,2})");
    const std::string small = lower_case(text);
    std::smatch row, column;
    if (!std::regex_search(small, row, rows) || !std::regex_search(small, column, columns)) return std::nullopt;
    return NumberPair(std::stoi(column[1]) - 1, std::stoi(row[1]) - 1);
}

// "1-2", "(1,2)", "1.2", "1x2", "1/2".
std::optional<NumberPair> number_label(const std::string& text) {
    static const std::regex form("\\(?([0-9]{1,2}) ?[-,.x/|:] ?([0-9]{1,2})\\)?");
    std::smatch match;
    if (!std::regex_match(text, match, form)) return std::nullopt;
    return NumberPair(std::stoi(match[1]) - 1, std::stoi(match[2]) - 1);
}

std::optional<NumberPair> label_of(const std::string& text, LabelForm form) {
    if (text.empty() || text.size() > kLongestLabel) return std::nullopt;
    switch (form) {
        case LabelForm::Letter:
            return letter_label(text);
        case LabelForm::Words:
            return word_label(text);
        case LabelForm::Numbers:
            return number_label(text);
    }
    return std::nullopt;
}

// The label in the largest letters: marks at the borders name neighbours, too, in small ones.
std::optional<NumberPair> label_on(const std::vector<PdfText>& texts, LabelForm form) {
    std::optional<NumberPair> found;
    double height = 0;
    for (const PdfText& text : texts) {
        if (text.height <= height) continue;
        const std::optional<NumberPair> label = label_of(text.text, form);
        if (!label || label->first < 0 || label->second < 0) continue;
        found = label;
        height = text.height;
    }
    return found;
}

}  // namespace

std::vector<std::pair<int, int>> page_labels(const std::vector<const std::vector<PdfText>*>& pages) {
    for (const LabelForm form : {LabelForm::Words, LabelForm::Letter, LabelForm::Numbers}) {
        std::vector<NumberPair> labels;
        std::set<int> seconds;
        for (const std::vector<PdfText>* texts : pages) {
            const std::optional<NumberPair> label = label_on(*texts, form);
            if (!label) break;
            labels.push_back(*label);
            seconds.insert(label->second);
        }
        if (labels.size() != pages.size()) continue;
        if (std::set<NumberPair>(labels.begin(), labels.end()).size() != labels.size()) continue;
        // "3/12" counts the pages.
        if (form == LabelForm::Numbers && seconds.size() == 1 && *seconds.begin() + 1 >= static_cast<int>(pages.size()))
            continue;
        return labels;
    }
    return {};
}

bool is_page_text(const std::string& text) {
    if (text.size() > kLongestLabel) return false;
    static const std::regex counted("(?:.*[^0-9])?[0-9]{1,3} ?(?:of|/|von|de|sur|di|van) ?[0-9]{1,3}(?:[^0-9].*)?");
    static const std::regex page("(?:page|seite|blatt|pagina|página|sheet|feuille) ?[0-9]{1,3}.*");
    const std::string small = lower_case(text);
    const bool has_page_word = std::regex_match(small, page);
    if (letter_label(text) || number_label(text) || has_page_word) return true;
    static const std::regex only_count("[0-9]{1,3} ?(?:of|/|von|de|sur|di|van) ?[0-9]{1,3}");
    if (std::regex_match(small, only_count)) return true;
    const bool names_page = small.find("page") != std::string::npos || small.find("seite") != std::string::npos;
    return (names_page && std::regex_match(small, counted)) || (small.size() < 40 && word_label(text));
}

}  // namespace selvedge::sim

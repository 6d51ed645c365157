#include "sim/paper/size_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <map>
#include <set>

#include "sim/core/lower_case.h"

namespace selvedge::sim {
namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == ':' || c == '.' || c == '_' || c == '-' || c == '=' || c == '#';
}

std::string_view without_blanks(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

// Takes a word for size from the front of a text in small letters; false: there is none.
bool take_size_word(std::string_view& text) {
    constexpr std::array<std::string_view, 14> words{"size name", "sizes", "size",   "größe", "groesse", "gr", "taille",
                                                     "talla",     "maat",  "taglia", "eu",    "us",      "uk", "de"};
    for (const std::string_view word : words) {
        if (!text.starts_with(word) || text.size() == word.size()) continue;
        const char next = text[word.size()];
        if (!is_blank(next) && (next < '0' || next > '9')) continue;
        text = without_blanks(text.substr(word.size()));
        return true;
    }
    return false;
}

// The place of "s", "m", "xl" and "3xl" in the order of sizes; none: it is no such word.
std::optional<int> letter_rank(std::string_view word) {
    if (word == "m") return 0;
    if (word.empty() || (word.back() != 's' && word.back() != 'l')) return std::nullopt;
    const int side = word.back() == 's' ? -1 : 1;
    word.remove_suffix(1);
    int number = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error == std::errc()) {
        constexpr int kMostX = 9;
        const bool is_x = std::string_view(stop, static_cast<std::size_t>(word.data() + word.size() - stop)) == "x";
        if (is_x && number > 0 && number <= kMostX) return side * (1 + number);
        return std::nullopt;
    }
    constexpr std::size_t kMost = 5;
    if (word.size() > kMost || !std::ranges::all_of(word, [](char c) { return c == 'x'; })) return std::nullopt;
    return side * (1 + static_cast<int>(word.size()));
}

std::optional<int> number_of(std::string_view word) {
    int number = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    return error == std::errc() && stop == word.data() + word.size() ? std::optional(number) : std::nullopt;
}

bool is_bare_number(int number) {
    return (number >= 24 && number <= 66) || (number >= 80 && number <= 194 && number % 2 == 0);
}

bool is_size_word(std::string_view word, bool is_told) {
    if (letter_rank(word)) return true;
    constexpr int kMost = 300;
    const std::optional<int> number = number_of(word);
    return number && (is_told ? *number >= 0 && *number <= kMost : is_bare_number(*number));
}

double rank_of(const std::string& size) {
    const std::string small = lower_case(size);
    const std::string_view first = std::string_view(small).substr(0, small.find_first_of("/-"));
    if (const auto rank = letter_rank(first)) return *rank;
    constexpr double kBehind = 1000;
    if (const auto number = number_of(first)) return *number;
    return kBehind;
}

}  // namespace

std::optional<std::string> size_of_name(std::string_view name) {
    const std::string small = lower_case(name);
    std::string_view rest = without_blanks(small);
    const bool is_told = take_size_word(rest);
    if (is_told) take_size_word(rest);  // "Size EU 38"
    constexpr std::size_t kLongest = 16;
    if (rest.empty() || rest.size() > kLongest) return std::nullopt;
    // "34/36" and "S-M" are one size; of "EU 38 / UK 10" the first is its name.
    std::string size;
    std::string_view words = rest;
    while (!words.empty()) {
        const std::size_t stop = std::min(words.find_first_of("/-"), words.size());
        std::string_view word = without_blanks(words.substr(0, stop));
        const bool is_of_region = take_size_word(word);
        if (!is_size_word(word, is_told || is_of_region)) return std::nullopt;
        if (size.empty()) {
            size = word;
        } else if (!is_of_region) {
            size += words.data()[-1];
            size += word;
        }
        words.remove_prefix(std::min(stop + 1, words.size()));
    }
    std::ranges::transform(size, size.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return size;
}

std::optional<std::pair<std::string, std::string>> split_size(std::string_view name) {
    const std::size_t at = name.find_last_of(" _-");
    if (at == std::string_view::npos || at == 0) return std::nullopt;
    const std::optional<std::string> size = size_of_name(name.substr(at + 1));
    std::string_view stem = name.substr(0, at);
    for (const std::string_view word : {"size", "Size", "SIZE", "gr", "Gr"}) {
        if (stem.ends_with(word) && stem.size() > word.size() && is_blank(stem[stem.size() - word.size() - 1]))
            stem.remove_suffix(word.size());
    }
    while (!stem.empty() && is_blank(stem.back())) stem.remove_suffix(1);
    if (size && !stem.empty()) return std::pair(std::string(stem), *size);
    const std::size_t first = name.find_first_of(" _-");
    const std::optional<std::string> before = size_of_name(name.substr(0, first));
    const std::string_view behind = name.substr(first + 1);
    if (!before || behind.empty() || size_of_name(behind)) return std::nullopt;
    return std::pair(std::string(behind), *before);
}

bool has_size_word(std::string_view text) {
    const std::string small = lower_case(text);
    for (std::string_view rest = without_blanks(small); !rest.empty();) {
        std::string_view word = rest;
        if (take_size_word(word)) return true;
        const std::size_t blank = rest.find(' ');
        rest = blank == std::string_view::npos ? std::string_view() : without_blanks(rest.substr(blank));
    }
    return false;
}

std::string size_of_shape(const PlainShape& shape) {
    if (const auto size = size_of_name(shape.path.name)) return *size;
    for (auto group = shape.groups.rbegin(); group != shape.groups.rend(); ++group) {
        for (const std::string& name : {group->label, group->id}) {
            if (const auto size = size_of_name(name)) return *size;
        }
    }
    return {};
}

std::vector<std::optional<std::pair<std::string, std::string>>> split_sizes(const std::vector<std::string>& names) {
    std::vector<std::optional<std::pair<std::string, std::string>>> splits;
    std::map<std::string, std::set<std::string>> sizes;  // by the name without them
    for (const std::string& name : names) {
        splits.push_back(split_size(name));
        if (splits.back()) sizes[splits.back()->first].insert(splits.back()->second);
    }
    const auto nests = std::ranges::count_if(sizes, [](const auto& one) { return one.second.size() > 1; });
    for (auto& split : splits) {
        if (nests < 2 || (split && sizes[split->first].size() < 2)) split.reset();
    }
    return splits;
}

void sort_sizes(std::vector<std::string>& sizes) {
    std::ranges::stable_sort(sizes, {}, rank_of);
}

}  // namespace selvedge::sim

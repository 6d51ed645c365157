#include "sim/pattern/spelling.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace selvedge::sim {
namespace {

char lower_letter(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// How many letters are to be added, left out, replaced or exchanged with the next one to make one word of the other.
// (the restricted distance of Damerau and Levenshtein)
std::size_t spelling_distance(std::string_view one, std::string_view other) {
    std::vector<std::size_t> before, last(other.size() + 1), row(other.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t{0});
    const auto is_same = [&](std::size_t i, std::size_t j) {
        return lower_letter(one[i - 1]) == lower_letter(other[j - 1]);
    };
    for (std::size_t i = 1; i <= one.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= other.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (is_same(i, j) ? 0 : 1)});
            if (i > 1 && j > 1 && is_same(i, j - 1) && is_same(i - 1, j)) row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before = std::exchange(last, row);
    }
    return last.back();
}

}  // namespace

std::string_view nearly_spelt(std::string_view word, std::span<const std::string_view> words) {
    std::string_view nearest;
    std::size_t least = 0;
    for (const std::string_view one : words) {
        const std::size_t most = std::max<std::size_t>(one.size() / 3, 1);
        if (word.size() > one.size() + most || one.size() > word.size() + most) continue;
        const std::size_t distance = spelling_distance(word, one);
        if (distance > most || (!nearest.empty() && distance >= least)) continue;
        nearest = one;
        least = distance;
    }
    return nearest;
}

}  // namespace selvedge::sim

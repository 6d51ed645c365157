#include "sim/paper/drawing_words.h"

#include <cctype>

namespace selvedge::sim {

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

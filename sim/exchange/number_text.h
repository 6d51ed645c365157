#pragma once
// Numbers in text files: the shortest text that reads back as the same number; std::to_chars does not depend on the
// locale.
#include <charconv>
#include <string>
#include <string_view>

namespace selvedge::sim {

template <class Number>
void append_number(std::string& text, Number number) {
    char digits[32];
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, number);
    static_cast<void>(error);  // 32 characters hold any float
    text.append(digits, end);
}

// "KEYWORD X Y ...", on a line of its own.
template <class Vector>
void append_vector(std::string& text, std::string_view keyword, const Vector& v) {
    text += keyword;
    for (const float number : v) {
        text += ' ';
        append_number(text, number + 0.0F);  // + 0.0F: writes 0 instead of -0
    }
    text += '\n';
}

}  // namespace selvedge::sim

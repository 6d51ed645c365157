#include "sim/paper/decimal_text.h"

#include <array>
#include <charconv>

namespace selvedge::sim {

std::string decimal_text(double value) {
    std::array<char, 64> text{};
    const auto [stop, error] =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, 6);
    std::string digits(text.data(), error == std::errc() ? stop : text.data());
    while (digits.find('.') != std::string::npos && (digits.back() == '0' || digits.back() == '.')) {
        const bool is_point = digits.back() == '.';
        digits.pop_back();
        if (is_point) break;
    }
    return digits.empty() || digits == "-0" ? "0" : digits;
}

}  // namespace selvedge::sim

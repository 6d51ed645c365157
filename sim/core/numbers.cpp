#include "sim/core/numbers.h"

#include <charconv>
#include <system_error>

namespace selvedge::sim {

std::optional<std::vector<double>> parse_number_list(std::string_view text) {
    std::vector<double> numbers;
    const char *at = text.data(), *last = text.data() + text.size();
    while (true) {
        double value = 0;
        const auto [end, error] = std::from_chars(at, last, value);
        if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
        numbers.push_back(value);
        if (end == last) return numbers;
        if (*end != ',') return std::nullopt;
        at = end + 1;
    }
}

std::string short_text(double number) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

}  // namespace selvedge::sim

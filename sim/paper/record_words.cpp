#include "sim/paper/record_words.h"

#include <charconv>
#include <cmath>

#include "sim/paper/dxf_text.h"

namespace selvedge::sim {

std::string_view RecordWords::word() {
    while (rest_.starts_with(' ')) rest_.remove_prefix(1);
    const std::string_view found = rest_.substr(0, rest_.find(' '));
    rest_.remove_prefix(found.size());
    return found;
}

double RecordWords::real() {
    constexpr double kLargest = 1e6;
    const auto value = dxf_number(word());
    if (!value || !(std::abs(*value) < kLargest)) is_good_ = false;
    return is_good_ ? *value : 0;
}

int RecordWords::whole() {
    return whole_of(word());
}

Vec2d RecordWords::point() {
    const double x = real();
    return {x, real()};
}

Vec3d RecordWords::point_in_space() {
    const Vec2d xy = point();
    return {xy.x(), xy.y(), real()};
}

SeamSide RecordWords::side() {
    const std::string_view text = word();
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) is_good_ = false;
    if (!is_good_) return {};
    return {whole_of(text.substr(0, colon)), whole_of(text.substr(colon + 1))};
}

std::string RecordWords::rest() const {
    const std::size_t at = rest_.find_first_not_of(' ');
    return at == std::string_view::npos ? std::string() : std::string(rest_.substr(at));
}

int RecordWords::whole_of(std::string_view text) {
    constexpr int kMost = 100000;
    int value = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || stop != text.data() + text.size() || value < 0 || value > kMost) is_good_ = false;
    return is_good_ ? value : 0;
}

}  // namespace selvedge::sim

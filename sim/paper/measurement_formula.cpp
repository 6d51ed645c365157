#include "sim/paper/measurement_formula.h"

#include <charconv>
#include <cmath>
#include <string_view>

namespace selvedge::sim {
namespace {

constexpr int kDeepestFormula = 64;         // parentheses and names within names
constexpr int kMostTerms = 10000;           // names that name others twice and more would take ages
constexpr std::size_t kLongestNumber = 64;  // letters

bool is_digit_at(std::string_view text, std::size_t at) {
    return at < text.size() && text[at] >= '0' && text[at] <= '9';
}

class Reader {
 public:
    Reader(const Formulas& formulas, std::string_view text, int depth, int& terms)
        : formulas_(formulas), rest_(text), depth_(depth), terms_(terms) {}

    std::optional<double> whole() {
        const std::optional<double> value = sum();
        skip_blanks();
        return rest_.empty() ? value : std::nullopt;
    }

 private:
    void skip_blanks() {
        while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\t' || rest_.front() == '\n'))
            rest_.remove_prefix(1);
    }

    bool take(char c) {
        skip_blanks();
        if (!rest_.starts_with(c)) return false;
        rest_.remove_prefix(1);
        return true;
    }

    std::optional<double> sum() {
        std::optional<double> value = product();
        while (value) {
            if (take('+')) {
                const auto other = product();
                value = other ? std::optional(*value + *other) : std::nullopt;
            } else if (take('-')) {
                const auto other = product();
                value = other ? std::optional(*value - *other) : std::nullopt;
            } else {
                break;
            }
        }
        return value;
    }

    std::optional<double> product() {
        std::optional<double> value = factor();
        while (value) {
            if (take('*')) {
                const auto other = factor();
                value = other ? std::optional(*value * *other) : std::nullopt;
            } else if (take('/')) {
                const auto other = factor();
                value = other && *other != 0 ? std::optional(*value / *other) : std::nullopt;
            } else {
                break;
            }
        }
        return value;
    }

    std::optional<double> factor() {
        if (++depth_ > kDeepestFormula || ++terms_ > kMostTerms) return std::nullopt;
        std::optional<double> value;
        if (take('-')) {
            const auto other = factor();
            if (other) value = -*other;
        } else if (take('(')) {
            value = sum();
            if (!take(')')) value.reset();
        } else {
            value = atom();
        }
        --depth_;
        return value;
    }

    static bool is_part_of_name(char c) {
        return c == '_' || c == '@' || c == '#' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
               (c >= 'A' && c <= 'Z') || (static_cast<unsigned char>(c) & 0x80U) != 0;
    }

    std::optional<double> atom() {
        skip_blanks();
        const std::string digits = with_decimal_point(std::string(rest_.substr(0, kLongestNumber)));
        double number = 0;
        const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
        if (error == std::errc() && std::isfinite(number)) {
            rest_.remove_prefix(static_cast<std::size_t>(stop - digits.data()));
            return number;
        }
        std::size_t length = 0;
        while (length < rest_.size() && is_part_of_name(rest_[length])) ++length;
        const std::string name(rest_.substr(0, length));
        rest_.remove_prefix(length);
        const auto found = formulas_.find(name);
        if (found == formulas_.end() || depth_ > kDeepestFormula) return std::nullopt;
        return Reader(formulas_, found->second, depth_ + 1, terms_).whole();
    }

    const Formulas& formulas_;
    std::string_view rest_;
    int depth_;
    int& terms_;
};

}  // namespace

std::string with_decimal_point(std::string text) {
    std::size_t at = text.starts_with('-') ? 1 : 0;
    const std::size_t begin = at;
    while (is_digit_at(text, at)) ++at;
    if (at > begin && at < text.size() && text[at] == ',' && is_digit_at(text, at + 1)) text[at] = '.';
    return text;
}

std::optional<double> value_of_formula(const Formulas& formulas, const std::string& name) {
    const auto found = formulas.find(name);
    if (found == formulas.end()) return std::nullopt;
    int terms = 0;
    const std::optional<double> value = Reader(formulas, found->second, 0, terms).whole();
    return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace selvedge::sim

#include "editor/geometry/expression.h"

#include <cmath>
#include <string>

namespace selvedge::editor {
namespace {

constexpr int kMaxDepth = 64;
constexpr std::size_t kMaxLength = 1000;

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

// sum = term {(+|-) term}; term = factor {(*|/) factor}; factor = [+|-] (number | "(" sum ")");
// number = decimal, or whole blank whole "/" whole. Each function returns none if the text does not match.
class Evaluator {
 public:
    explicit Evaluator(std::string_view text) : text_(text) {}

    std::optional<double> evaluate() {
        const auto value = sum(0);
        skip_blanks();
        if (!value || at_ != text_.size() || !std::isfinite(*value)) return {};
        return *value;
    }

 private:
    char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }

    void skip_blanks() {
        while (next() == ' ' || next() == '\t') ++at_;
    }

    bool take(char wanted) {
        skip_blanks();
        if (next() != wanted) return false;
        ++at_;
        return true;
    }

    std::optional<double> sum(int depth) {
        auto value = term(depth);
        while (value) {
            const bool is_plus = take('+');
            if (!is_plus && !take('-')) break;
            const auto other = term(depth);
            if (!other) return {};
            *value += is_plus ? *other : -*other;
        }
        return value;
    }

    std::optional<double> term(int depth) {
        auto value = factor(depth);
        while (value) {
            const bool is_times = take('*');
            if (!is_times && !take('/')) break;
            const auto other = factor(depth);
            if (!other || (!is_times && *other == 0)) return {};
            *value = is_times ? *value * *other : *value / *other;
        }
        return value;
    }

    std::optional<double> factor(int depth) {
        if (depth >= kMaxDepth) return {};
        const bool is_negative = take('-');
        if (!is_negative) take('+');
        std::optional<double> value;
        if (take('(')) {
            value = sum(depth + 1);
            if (!value || !take(')')) return {};
        } else {
            value = number();
        }
        if (value && is_negative) *value = -*value;
        return value;
    }

    std::optional<double> whole() {
        if (!is_digit(next())) return {};
        double value = 0;
        while (is_digit(next())) value = 10 * value + (text_[at_++] - '0');
        return value;
    }

    std::optional<double> number() {
        skip_blanks();
        const std::size_t begin = at_;
        std::string digits;
        int points = 0;
        while (is_digit(next()) || next() == '.' || next() == ',') {
            const char c = text_[at_++];
            points += is_digit(c) ? 0 : 1;
            digits += c == ',' ? '.' : c;
        }
        if (points > 1 || static_cast<int>(digits.size()) == points) return {};
        if (points == 1) return decimal(digits);
        at_ = begin;
        const auto value = whole();
        const auto rest = fraction();
        return rest ? *value + *rest : value;
    }

    // " 1/2" after a whole number. Returns none and consumes nothing if the text does not match.
    std::optional<double> fraction() {
        const std::size_t begin = at_;
        skip_blanks();
        const bool has_blank = at_ > begin;
        const auto upper = has_blank ? whole() : std::nullopt;
        const bool has_line = upper && take('/');
        skip_blanks();
        const auto lower = has_line ? whole() : std::nullopt;
        if (lower && *lower != 0 && next() != '.' && next() != ',') return *upper / *lower;
        at_ = begin;
        return {};
    }

    // Digits with one decimal point, parsed by hand so that the result does not depend on the locale.
    static double decimal(const std::string& digits) {
        double value = 0;
        double scale = 1;
        bool is_after_point = false;
        for (const char c : digits) {
            if (c == '.') {
                is_after_point = true;
                continue;
            }
            value = 10 * value + (c - '0');
            if (is_after_point) scale *= 10;
        }
        return value / scale;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace

std::optional<double> evaluate(std::string_view text) {
    if (text.size() > kMaxLength) return {};
    return Evaluator(text).evaluate();
}

}  // namespace selvedge::editor

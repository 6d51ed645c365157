#include "editor/tools/typed_input.h"

#include "editor/drafting/expression.h"

namespace selvedge {
namespace {

constexpr std::size_t kMaxLength = 64;
constexpr std::string_view kBegins = "0123456789.,-(";
constexpr std::string_view kGoesOn = "0123456789.,-+*/() xX";

}  // namespace

bool TypedInput::add(std::string_view text) {
    bool is_taken = false;
    for (const char c : text) {
        const std::string_view known = text_.empty() ? kBegins : kGoesOn;
        if (known.find(c) == std::string_view::npos || text_.size() >= kMaxLength) continue;
        text_ += c == 'X' ? 'x' : c;
        is_taken = true;
    }
    return is_taken;
}

void TypedInput::remove_last() {
    if (!text_.empty()) text_.pop_back();
}

std::optional<std::vector<double>> TypedInput::numbers() const {
    if (text_.empty()) return {};
    std::vector<double> numbers;
    std::string_view rest = text_;
    while (true) {
        const std::size_t cross = rest.find('x');
        const std::optional<double> number = evaluate(rest.substr(0, cross));
        if (!number) return {};
        numbers.push_back(*number);
        if (cross == std::string_view::npos) return numbers;
        rest.remove_prefix(cross + 1);
    }
}

}  // namespace selvedge

#include "sim/paper/grade_rules.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>

#include "sim/core/error.h"
#include "sim/core/lower_case.h"
#include "sim/core/trimmed.h"

namespace selvedge::sim {
namespace {

constexpr std::size_t kMostRules = 100000, kMostSizes = 100;
constexpr double kFarthest = 1e5;  // units of the table

// What stands behind "KEY:"; none: the line begins otherwise.
std::optional<std::string_view> value_of(std::string_view line, std::string_view key) {
    if (!lower_case(line.substr(0, key.size())).starts_with(key)) return std::nullopt;
    line = trimmed(line.substr(key.size()));
    if (!line.starts_with(':')) return std::nullopt;
    return trimmed(line.substr(1));
}

class RuleReader {
 public:
    RuleReader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    GradeRules read() {
        while (!text_.empty()) {
            ++line_;
            const std::size_t end = std::min(text_.find('\n'), text_.size());
            const std::string_view whole = text_.substr(0, end);
            text_.remove_prefix(std::min(end + 1, text_.size()));
            const std::string_view line = trimmed(whole.substr(0, whole.find('#')));  // a comment follows
            if (lower_case(line) == "end") break;
            read_line(line);
        }
        finish_rule();
        if (rules_.sizes.empty()) fail("it lists no sizes");
        if (std::ranges::find(rules_.sizes, rules_.sample_size) == rules_.sizes.end())
            fail("the sample size '" + rules_.sample_size.substr(0, 40) + "' is none of its sizes");
        return std::move(rules_);
    }

 private:
    [[noreturn]] void fail(const std::string& problem) const {
        throw InputError(file_, "line " + std::to_string(line_), problem);
    }

    void read_line(std::string_view line) {
        if (const auto units = value_of(line, "units")) {
            rules_.metres_per_unit = lower_case(*units).starts_with("eng") ? 0.0254 : 0.001;
        } else if (const auto sizes = value_of(line, "size list")) {
            std::istringstream words{std::string(*sizes)};
            for (std::string size; words >> size;) rules_.sizes.push_back(size);
            if (rules_.sizes.size() > kMostSizes) fail("more than 100 sizes");
        } else if (const auto sample = value_of(line, "sample size")) {
            rules_.sample_size = *sample;
        } else if (const auto rule = value_of(line, "rule")) {
            finish_rule();
            begin_rule(*rule);
        } else if (number_ && !line.empty()) {
            read_moves(line);
        }
    }

    // "DELTA 12", "12"
    void begin_rule(std::string_view text) {
        const std::string_view digits = text.substr(text.find_last_of(" \t") + 1);  // all of it where there is none
        int number = 0;
        const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
        if (error != std::errc() || stop != digits.data() + digits.size() || number < 0)
            fail("'" + std::string(text.substr(0, 40)) + "' is no number of a rule");
        if (rules_.moves.size() >= kMostRules) fail("more than 100,000 rules");
        number_ = number;
    }

    // Pairs of numbers, between blanks and commas.
    void read_moves(std::string_view line) {
        while (true) {
            const std::size_t first = line.find_first_not_of(" \t,;");
            if (first == std::string_view::npos) return;
            line.remove_prefix(first);
            if (line.front() == '+') line.remove_prefix(1);
            double value = 0;
            const auto [stop, error] = std::from_chars(line.data(), line.data() + line.size(), value);
            if (error != std::errc() || !(std::abs(value) < kFarthest))
                fail("'" + std::string(line.substr(0, 40)) + "' is no move of a point");
            values_.push_back(value);
            line.remove_prefix(static_cast<std::size_t>(stop - line.data()));
            if (values_.size() > 2 * kMostSizes) fail("more moves than sizes");
        }
    }

    void finish_rule() {
        if (!number_) return;
        if (values_.size() != 2 * rules_.sizes.size())
            fail("rule " + std::to_string(*number_) + " has " + std::to_string(values_.size() / 2) + " moves for " +
                 std::to_string(rules_.sizes.size()) + " sizes");
        std::vector<Vec2d>& moves = rules_.moves[*number_];
        moves.clear();
        for (std::size_t i = 0; i + 1 < values_.size(); i += 2) moves.emplace_back(values_[i], values_[i + 1]);
        values_.clear();
        number_.reset();
    }

    std::string_view text_;
    const std::string& file_;
    int line_ = 0;
    std::optional<int> number_ = {};  // of the rule that is read
    std::vector<double> values_ = {};
    GradeRules rules_ = {};
};

}  // namespace

GradeRules parse_grade_rules(std::string_view text, const std::string& file) {
    return RuleReader(text, file).read();
}

void grade_line(std::vector<Vec2d>& points, const std::map<std::size_t, Vec2d>& moves, bool is_closed) {
    // Distances along the line; of a closed one, once round and on.
    std::vector<double> along{0};
    for (std::size_t i = 1; i < points.size(); ++i) along.push_back(along.back() + (points[i] - points[i - 1]).norm());
    const double around = along.back() + (points.front() - points.back()).norm();
    std::vector<Vec2d> graded = points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        auto next = moves.lower_bound(i);
        auto before = next == moves.begin() ? moves.end() : std::prev(next);
        if (next != moves.end() && next->first == i) {
            graded[i] += next->second;
            continue;
        }
        double from = 0, to = 0;
        if (before == moves.end()) {
            if (is_closed) before = std::prev(moves.end());
            from = is_closed ? along[before->first] - around : 0;
        } else {
            from = along[before->first];
        }
        if (next == moves.end()) {
            if (is_closed) next = moves.begin();
            to = is_closed ? along[next->first] + around : 0;
        } else {
            to = along[next->first];
        }
        if (before == moves.end()) before = next;
        if (next == moves.end()) next = before;
        const double t = to > from ? std::clamp((along[i] - from) / (to - from), 0.0, 1.0) : 0;
        graded[i] += (1 - t) * before->second + t * next->second;
    }
    points = std::move(graded);
}

}  // namespace selvedge::sim

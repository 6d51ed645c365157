#include "sim/pattern/fault.h"

#include <algorithm>
#include <cmath>

#include "sim/core/printable.h"
#include "sim/pattern/spelling.h"

namespace selvedge::sim {

std::string describe(const Fault& fault) {
    return fault_line(fault.file, fault.place,
                      (fault.severity == Severity::Warning ? "warning: " : "") + fault.problem);
}

bool has_error(const std::vector<Fault>& faults) {
    return std::any_of(faults.begin(), faults.end(),
                       [](const Fault& fault) { return fault.severity == Severity::Error; });
}

JsonNode JsonNode::member(std::string_view key) const {
    return {value ? value->find(key) : nullptr, json_path(path, key)};
}

JsonNode JsonNode::element(std::size_t index) const {
    return {&value->elements()[index], json_path(path, index)};
}

void FaultReader::error(const JsonNode& node, const std::string& problem) {
    add(Severity::Error, node, problem, ++errors_);
}

void FaultReader::warn(const JsonNode& node, const std::string& problem) {
    add(Severity::Warning, node, problem, ++warnings_);
}

void FaultReader::warn_of_unknown_keys(const JsonNode& object, std::span<const std::string_view> known) {
    for (const Json::Member& member : object.value->members()) {
        if (warnings_ > kMostFaults) return;  // none of the others is listed
        if (std::ranges::find(known, member.key) != known.end()) continue;
        const std::string_view near = nearly_spelt(member.key, known);
        warn({&member.value, json_path(object.path, member.key)},
             "unknown key '" + member.key + "'" + (near.empty() ? "" : ": is '" + std::string(near) + "' meant?"));
    }
}

void FaultReader::add(Severity severity, const JsonNode& node, const std::string& problem, std::size_t count) {
    if (count <= kMostFaults) {
        faults_.push_back({severity, file_, node.path, problem});
    } else if (count == kMostFaults + 1) {
        faults_.push_back({severity, file_, "", "more than " + std::to_string(kMostFaults) + ": no others are listed"});
    }
}

bool FaultReader::expect(const JsonNode& node, Json::Kind kind) {
    if (node.value->kind() == kind) return true;
    error(node, std::string(describe(node.value->kind())) + " where " + describe(kind) + " should be");
    return false;
}

bool FaultReader::expect_array(const JsonNode& node, std::size_t size) {
    if (!expect(node, Json::Kind::Array)) return false;
    if (node.size() == size) return true;
    error(node, count_text(node.size(), "value") + " where " + std::to_string(size) + " should be");
    return false;
}

std::optional<double> FaultReader::number(const JsonNode& node) {
    if (!expect(node, Json::Kind::Number)) return {};
    return node.value->number();
}

std::optional<int> FaultReader::index(const JsonNode& node, std::size_t count, const char* of_what) {
    const auto value = number(node);
    if (!value) return {};
    if (*value >= 0 && *value < static_cast<double>(count) && *value == std::floor(*value)) {
        return static_cast<int>(*value);
    }
    error(node,
          "no " + std::string(of_what) + " " + node.value->number_text() + ": there are " + std::to_string(count));
    return {};
}

std::optional<std::string> FaultReader::text(const JsonNode& node) {
    if (!expect(node, Json::Kind::String)) return {};
    return node.value->string();
}

std::optional<int> FaultReader::whole_number(const JsonNode& node, int least, int most) {
    const auto value = number(node);
    if (!value) return std::nullopt;
    if (*value == std::floor(*value) && *value >= least && *value <= most) return static_cast<int>(*value);
    error(node, node.value->number_text() + " is not a whole number from " + std::to_string(least) + " to " +
                    std::to_string(most));
    return std::nullopt;
}

std::optional<std::size_t> FaultReader::choice(const JsonNode& node, std::span<const std::string_view> names) {
    const auto word = text(node);
    if (!word) return std::nullopt;
    const auto found = std::ranges::find(names, *word);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    std::string known;
    for (const std::string_view name : names) known += (known.empty() ? "" : ", ") + std::string(name);
    error(node, "'" + *word + "' is none of " + known);
    return std::nullopt;
}

std::optional<bool> FaultReader::flag(const JsonNode& node) {
    if (node.value->is_bool()) return node.value->boolean();
    if (!node.value->is_number()) {
        error(node, std::string(describe(node.value->kind())) + " where true or false should be");
        return {};
    }
    const double value = node.value->number();
    if (value == 0 || value == 1) return value == 1;
    error(node, "expected 0 or 1");
    return {};
}

std::optional<Vec2d> FaultReader::pair(const JsonNode& node) {
    if (!expect_array(node, 2)) return {};
    const auto x = number(node.element(0));
    const auto y = number(node.element(1));
    if (!x || !y) return {};
    return Vec2d(*x, *y);
}

std::optional<Vec3d> FaultReader::triple(const JsonNode& node) {
    if (!expect_array(node, 3)) return {};
    const auto x = number(node.element(0));
    const auto y = number(node.element(1));
    const auto z = number(node.element(2));
    if (!x || !y || !z) return {};
    return Vec3d(*x, *y, *z);
}

std::optional<double> FaultReader::length(const JsonNode& node) {
    const auto value = number(node);
    if (!value) return {};
    if (std::abs(*value) <= kMaxCoordinate * units_in_meter) return *value / units_in_meter;
    error(node, "further than 100 m");
    return {};
}

std::optional<Vec2d> FaultReader::point(const JsonNode& node) {
    const auto values = pair(node);
    if (!values) return {};
    if (values->cwiseAbs().maxCoeff() <= kMaxCoordinate * units_in_meter) return Vec2d(*values / units_in_meter);
    error(node, "further than 100 m");
    return {};
}

}  // namespace selvedge::sim

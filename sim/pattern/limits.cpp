#include "sim/pattern/limits.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

#include "sim/core/json.h"
#include "sim/pattern/fault.h"
#include "sim/pattern/field.h"
#include "sim/pattern/pattern_fields.h"

namespace selvedge::sim {
namespace {

bool is_near(double value) {
    return std::abs(value) <= kMaxCoordinate;  // false for NaN
}

bool is_near(const Vec2d& point) {
    return is_near(point.x()) && is_near(point.y());
}

bool is_near(const Vec3d& point) {
    return is_near(point.x()) && is_near(point.y()) && is_near(point.z());
}

}  // namespace

std::string layer_problem() {
    const std::string most = std::to_string(kHighestLayer);
    return "a layer is a whole number from -" + most + " to " + most;
}

namespace {

const char* const kFar = "further than 100 m";

// Checks values by the descriptions of their fields, and values in them.
class FieldChecker {
 public:
    std::vector<LimitFault> take() { return std::move(faults_); }

    // All but the shape.
    template <Described Part>
    void check_part(const std::string& place, const Part& part) {
        visit_fields(part, [&](const auto& field, const auto& value) {
            if (field.descent != Descent::Shape) check(place + std::string(field.key), field, value);
        });
    }

    void check(const std::string& place, const auto& field, double value) {
        const bool is_on_plane = is_length(field.measure);
        if (is_on_plane && !is_near(value)) return add(place, kFar);
        if (!is_on_plane && !std::isfinite(value)) return add(place, "not finite");
        check_range(place, field.range, value);
    }
    void check(const std::string& place, const auto& field, int value) { check_range(place, field.range, value); }
    void check(const std::string& place, const auto& field, const Vec2d& value) {
        if (!is_near(value)) return add(place, kFar);
        check_range(place, field.range, value.minCoeff());
        if (value.maxCoeff() != value.minCoeff()) check_range(place, field.range, value.maxCoeff());
    }
    void check(const std::string& place, const auto&, const Vec3d& value) {
        if (!is_near(value)) add(place, kFar);
    }
    void check(const std::string& place, const auto& field, const std::string& value) {
        if (field.measure == Measure::Colour && !value.empty() && !is_colour_text(value))
            add(place, "'" + value + "' is no colour: #RRGGBB is");
    }
    template <Described Part>
    void check(const std::string& place, const auto&, const Part& part) {
        check_part(place + ".", part);
    }
    template <class T>
    void check(const std::string& place, const auto& field, const std::optional<T>& value) {
        if (value) check(place, field, *value);
    }
    // Of a list, the first fault, at the list.
    template <class T>
    void check(const std::string& place, const auto& field, const std::vector<T>& values) {
        FieldChecker inner;
        for (const T& value : values) inner.check("", field, value);
        if (!inner.faults_.empty()) add(place, inner.faults_.front().problem);
    }
    template <class T>
    void check(const std::string&, const auto&, const T&) {}  // a flag, word or matrix

 private:
    void check_range(const std::string& place, const Range& range, double value) {
        if (range.holds(value)) return;
        std::string problem(range.problem.empty() ? "# is out of range" : range.problem);
        if (const std::size_t number = problem.find('#'); number != std::string::npos)
            problem.replace(number, 1, "the value");
        add(place, problem);
    }
    void add(const std::string& place, const std::string& problem) { faults_.push_back({place, problem}); }

    std::vector<LimitFault> faults_;
};

}  // namespace

std::vector<LimitFault> limit_faults(const Panel& panel) {
    FieldChecker checker;
    const auto place_of = [](const auto& field) {
        const bool is_garmentcodes = field.key == "translation" || field.key == "label";
        return (is_garmentcodes ? "" : "selvedge.") + std::string(field.key);
    };
    visit_fields(panel, [&](const auto& field, const auto& value) {
        if (field.descent != Descent::Shape) checker.check(place_of(field), field, value);
    });
    for (std::size_t e = 0; e < panel.edges.size(); ++e)
        checker.check_part(json_path("edges", e) + ".selvedge.", panel.edges[e]);
    std::vector<LimitFault> faults = checker.take();
    if (!panel.rotation.allFinite()) faults.push_back({"rotation", "not finite"});
    return faults;
}

std::vector<LimitFault> limit_faults(const Seam& seam) {
    FieldChecker checker;
    checker.check_part("", seam);
    return checker.take();
}

std::vector<LimitFault> limit_faults(const Pattern& pattern) {
    FieldChecker checker;
    visit_fields(pattern, [&]<class SomeField>(const SomeField& field, const auto& value) {
        if constexpr (SomeField::is_key) checker.check(std::string(field.key), field, value);
    });
    return checker.take();
}

}  // namespace selvedge::sim

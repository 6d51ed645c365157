#pragma once
// Reads the fields of a pattern's parts from garment files, by their descriptions (sim/pattern/field.h): the fields
// that are keys of the part's own object.
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim/core/math.h"
#include "sim/core/printable.h"
#include "sim/pattern/enum_names.h"
#include "sim/pattern/fault.h"
#include "sim/pattern/field.h"
#include "sim/pattern/pattern_fields.h"

namespace selvedge::sim {

// Records a warning if no fabric that ships has this name. Empty if it is no text.
std::string read_fabric_name(FaultReader& reader, const JsonNode& node);

class FieldReader {
 public:
    // `panel`: the part or its panel, for indices of vertices and edges.
    explicit FieldReader(FaultReader& reader, const Panel* panel = nullptr) : reader_(reader), panel_(panel) {}

    // Values that are wrong keep their defaults, and their faults are recorded; so are keys that are neither those of
    // the part nor `others`. False: a required key is missing.
    template <Described Part>
    bool read(const JsonNode& object, Part& part, std::span<const std::string_view> others = {}) const {
        bool has_required = true;
        visit_fields(part, [&]<class SomeField>(const SomeField& field, auto& value) {
            if constexpr (SomeField::is_key) has_required = read_field(object, field, value) && has_required;
        });
        auto known = keys_of<Part>([]<class SomeField>(const SomeField&) { return SomeField::is_key; });
        known.insert(known.end(), others.begin(), others.end());
        reader_.warn_of_unknown_keys(object, known);
        return has_required;
    }

    template <class SomeField, class T>
    bool read_field(const JsonNode& object, const SomeField& field, T& value) const {
        const JsonNode node = object.member(field.key);
        if (node) {
            read_value(node, field, value);
        } else if (SomeField::form == FileForm::Required) {
            reader_.error(object, "no key '" + std::string(field.key) + "'");
            return false;
        }
        return true;
    }

 private:
    // One value. None where a fault was recorded.
    std::optional<bool> one(const JsonNode& node, const auto&, bool) const { return reader_.flag(node); }

    std::optional<double> one(const JsonNode& node, const auto& field, double) const {
        std::optional<double> value = is_length(field.measure) ? reader_.length(node) : reader_.number(node);
        if (value && is_angle(field.measure)) *value *= kDegree;
        if (value && !field.range.holds(*value)) return refuse(node, field.range);
        return value;
    }

    std::optional<int> one(const JsonNode& node, const auto& field, int) const {
        if (field.measure == Measure::EdgeIndex) return reader_.index(node, panel_->edges.size(), "edge");
        if (field.measure == Measure::VertexIndex) return reader_.index(node, panel_->vertices.size(), "vertex");
        if (field.range.problem.empty())
            return reader_.whole_number(node, static_cast<int>(field.range.least), static_cast<int>(field.range.most));
        const std::optional<double> value = reader_.number(node);
        if (!value) return std::nullopt;
        if (*value != std::floor(*value) || !field.range.holds(*value)) return refuse(node, field.range);
        return static_cast<int>(*value);
    }

    std::optional<std::string> one(const JsonNode& node, const auto& field, const std::string&) const {
        if (field.measure == Measure::Fabric) return read_fabric_name(reader_, node);
        std::optional<std::string> value = reader_.text(node);
        if (value && field.measure == Measure::Colour && !is_colour_text(*value)) {
            reader_.error(node, "'" + *value + "' is no colour: #RRGGBB is");
            return std::nullopt;
        }
        return value;
    }

    std::optional<Vec2d> one(const JsonNode& node, const auto& field, const Vec2d&) const {
        const std::optional<Vec2d> value = reader_.point(node);
        if (value && !(field.range.holds(value->x()) && field.range.holds(value->y())))
            return refuse(node, field.range);
        return value;
    }

    template <class T>
    requires std::is_enum_v<T> std::optional<T> one(const JsonNode& node, const auto&, T)
    const {
        constexpr auto names = names_of(T{});
        const auto index = reader_.choice(node, names.texts);
        return index ? std::optional(static_cast<T>(*index)) : std::nullopt;
    }

    template <Described T>
    std::optional<T> one(const JsonNode& node, const auto&, T part) const {
        if (!reader_.expect(node, Json::Kind::Object) || !read(node, part)) return std::nullopt;
        return part;
    }

    template <class SomeField, class T>
    void read_value(const JsonNode& node, const SomeField& field, T& value) const {
        if (auto read = one(node, field, T{})) value = std::move(*read);
    }
    template <class SomeField, class T>
    void read_value(const JsonNode& node, const SomeField& field, std::optional<T>& value) const {
        value = one(node, field, T{});
    }
    template <class SomeField, class T>
    void read_value(const JsonNode& node, const SomeField& field, std::vector<T>& values) const {
        if (!reader_.expect(node, Json::Kind::Array)) return;
        if (node.size() < field.least_count) {
            reader_.error(node, count_text(node.size(), "value") + " where at least " +
                                    std::to_string(field.least_count) + " should be");
        }
        for (std::size_t i = 0; i < node.size(); ++i) {
            if (auto read = one(node.element(i), field, T{})) values.push_back(std::move(*read));
        }
    }

    std::nullopt_t refuse(const JsonNode& node, const Range& range) const;

    FaultReader& reader_;
    const Panel* panel_;
};

}  // namespace selvedge::sim

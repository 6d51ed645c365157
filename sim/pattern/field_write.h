#pragma once
// Writes the fields of a pattern's parts to garment files, by their descriptions (sim/pattern/field.h): the fields that
// are keys of the part's own object. Values that are unchanged keep their text, and keys that are unknown stay.
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "sim/core/json.h"
#include "sim/core/math.h"
#include "sim/pattern/enum_names.h"
#include "sim/pattern/field.h"
#include "sim/pattern/pattern_fields.h"

namespace selvedge::sim {

// Keeps the number's text in the file if its value is unchanged (to 1e-9); otherwise writes at most nine decimals.
void set_number(Json& place, double value);

// The name of a shipped fabric, or of a fabric's file as named from the garment's `file`.
void set_fabric(Json& place, const std::string& fabric, const std::filesystem::path& file);

class FieldWriter {
 public:
    // units: file units in a metre. is_mirrored: the part is of a panel that is drawn clockwise in the file.
    FieldWriter(double units, bool is_mirrored, const std::filesystem::path& file)
        : units_(units), is_mirrored_(is_mirrored), file_(file) {}

    template <Described Part>
    void write(Json& object, const Part& part) const {
        const Part usual{};
        visit_fields(part, [&]<class SomeField>(const SomeField& field, const auto& value) {
            if constexpr (SomeField::is_key) write_field(object, field, value, usual.*SomeField::member);
        });
    }

    // Does not add a key whose value is the default `usual`; updates a key that exists.
    template <class SomeField, class T>
    void write_field(Json& object, const SomeField& field, const T& value, const T& usual) const {
        if (SomeField::form != FileForm::Required && value == usual && !object.find(field.key)) return;
        put(object[field.key], field, value);
    }
    template <class SomeField, class T>
    void write_field(Json& object, const SomeField& field, const std::optional<T>& value,
                     const std::optional<T>&) const {
        if (!value) return object.erase(field.key);
        put(object[field.key], field, *value);
    }

 private:
    double in_file(Measure measure, double value) const {
        if (is_length(measure)) return units_ * value;
        const bool turns = is_mirrored_ && measure == Measure::Direction;
        return is_angle(measure) ? (turns ? -1 : 1) * value / kDegree : value;
    }

    static void put(Json& place, const auto&, bool value) { place = Json(value); }
    static void put(Json& place, const auto&, int value) { set_number(place, value); }
    void put(Json& place, const auto& field, double value) const { set_number(place, in_file(field.measure, value)); }
    void put(Json& place, const auto& field, const std::string& value) const {
        if (field.measure == Measure::Fabric) return set_fabric(place, value, file_);
        place = Json(value);
    }
    void put(Json& place, const auto& field, const Vec2d& value) const {
        if (!place.is_array()) place = Json::array();
        place.elements().resize(2);
        const bool turns = is_mirrored_ && field.measure == Measure::Point;
        set_number(place.elements()[0], units_ * (turns ? -value.x() : value.x()));
        set_number(place.elements()[1], units_ * value.y());
    }
    template <class T>
    requires std::is_enum_v<T>
    static void put(Json& place, const auto&, T value) { place = Json(name_of_value(value)); }
    template <Described T>
    void put(Json& place, const auto&, const T& value) const {
        if (!place.is_object()) place = Json::object();
        write(place, value);
    }
    template <class T>
    void put(Json& place, const auto& field, const std::vector<T>& values) const {
        if (!place.is_array()) place = Json::array();
        place.elements().resize(values.size());
        for (std::size_t i = 0; i < values.size(); ++i) put(place.elements()[i], field, values[i]);
    }

    double units_;
    bool is_mirrored_;
    const std::filesystem::path& file_;
};

}  // namespace selvedge::sim

#pragma once
// The properties of a part in records of SVG and DXF files, by the descriptions of its fields (sim/pattern/field.h). A
// phrase is the word of the field (Field::record), then its values in the order of their list, lengths in mm, angles in
// degrees; texts have no blanks, and "-" is the empty one.
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "sim/core/math.h"
#include "sim/paper/decimal_text.h"
#include "sim/paper/record_words.h"
#include "sim/pattern/enum_names.h"
#include "sim/pattern/field.h"
#include "sim/pattern/pattern_fields.h"

namespace selvedge::sim {

// The unit of a record in SI units.
constexpr double record_unit(Measure measure) {
    return is_length(measure) ? 0.001 : is_angle(measure) ? kDegree : 1;
}

template <class SomeField, class T>
void append_value(std::string& phrase, const SomeField& field, const T& value) {
    if constexpr (Described<T>) {
        visit_fields(value, [&](const auto& inner, const auto& one) { append_value(phrase, inner, one); });
    } else if constexpr (std::is_enum_v<T>) {
        phrase += " " + std::string(name_of_value(value));
    } else if constexpr (std::is_same_v<T, std::string>) {
        phrase += " " + (value.empty() ? "-" : value);
    } else if constexpr (std::is_same_v<T, Vec2d>) {
        for (const double one : value) phrase += " " + decimal_text(one / record_unit(field.measure));
    } else {
        phrase += " " + decimal_text(static_cast<double>(value) / record_unit(field.measure));
    }
}

// A value that is out of its range makes the words bad.
template <class SomeField, class T>
void take_value(RecordWords& words, const SomeField& field, T& value) {
    if constexpr (Described<T>) {
        visit_fields(value, [&](const auto& inner, auto& one) { take_value(words, inner, one); });
    } else if constexpr (std::is_enum_v<T>) {
        const std::string_view word = words.word();
        constexpr auto names = names_of(T{});
        const auto found = std::ranges::find(names.texts, word);
        if (found == names.texts.end()) return words.refuse();
        value = static_cast<T>(found - names.texts.begin());
    } else if constexpr (std::is_same_v<T, std::string>) {
        value = words.word();
        if (value == "-") value.clear();
        if (field.measure == Measure::Colour && !is_colour_text(value)) words.refuse();
    } else if constexpr (std::is_same_v<T, Vec2d>) {
        value = words.point() * record_unit(field.measure);
        if (!field.range.holds(value.x()) || !field.range.holds(value.y())) words.refuse();
    } else {
        const double read = words.real() * record_unit(field.measure);
        if (!field.range.holds(read)) return words.refuse();
        value = static_cast<T>(read);
    }
}

// The phrases of all fields that have a word and a value.
template <Described Part>
std::vector<std::string> record_phrases(const Part& part) {
    std::vector<std::string> phrases;
    visit_fields(part, [&](const auto& field, const auto& value) {
        if constexpr (requires { value.has_value(); }) {
            if (field.record.empty() || !value) return;
            append_value(phrases.emplace_back(field.record), field, *value);
        }
    });
    return phrases;
}

// The same as one text, "; " between them, each after the prefix.
template <Described Part>
std::string record_of_fields(const Part& part, const std::string& prefix = "") {
    std::string record;
    for (const std::string& phrase : record_phrases(part)) record += (record.empty() ? "" : "; ") + prefix + phrase;
    return record;
}

// Reads one phrase. False: it is of no field of the part, or is broken; the part is then unchanged.
template <Described Part>
bool read_record_phrase(std::string_view phrase, Part& part) {
    RecordWords words(phrase);
    const std::string_view word = words.word();
    bool is_read = false;
    visit_fields(part, [&]<class SomeField>(const SomeField& field, auto& value) {
        if constexpr (requires { value.has_value(); }) {
            if (is_read || field.record.empty() || field.record != word) return;
            typename std::remove_cvref_t<decltype(value)>::value_type read{};
            take_value(words, field, read);
            is_read = words.is_good() && words.is_at_end();
            if (is_read) value = std::move(read);
        }
    });
    return is_read;
}

// Reads what record_of_fields() wrote; phrases that are broken are left out.
template <Described Part>
void read_record_of_fields(std::string_view record, Part& part) {
    while (!record.empty()) {
        const std::string_view phrase = record.substr(0, record.find(';'));
        read_record_phrase(phrase, part);
        record.remove_prefix(std::min(record.size(), phrase.size() + 1));
    }
}

}  // namespace selvedge::sim

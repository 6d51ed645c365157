#pragma once
// The description of one field of a pattern's part: its names, what it measures, its range, and what becomes of it when
// panels are turned, mirrored, cut, joined and copied. Whatever reads, writes, checks, copies or shows parts follows
// these descriptions. Lists: sim/pattern/pattern_fields.h.
#include <cstddef>
#include <limits>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace selvedge::sim {

// What a value is. It decides its unit in files and in boxes, and how it follows its panel (sim/pattern/field_moves.h).
enum class Measure {
    Plain,        // a text, word, number, flag or part: the same wherever the panel lies
    Length,       // m; file units; boxes show cm
    SmallLength,  // m; file units; boxes show mm
    Angle,        // rad; degrees
    Point,        // m, panel frame: mapped with the panel; mirrored in the file of a panel that is drawn clockwise
    Direction,    // rad from the panel's +y, counter-clockwise: turned and mirrored as a Point is
    ClothShift,   // m, (weft, warp) from the right side: x is negated with the panel; not mirrored in the file
    LeftOfLine,   // m, from a line to its left: negated when the line is mirrored and when it is reversed
    EdgeIndex,    // of the part's panel
    VertexIndex,  // of the part's panel
    EdgeShare,    // 0..1 of an edge's length from its start: 1 - t when it is reversed
    Colour,       // #RRGGBB
    Fabric,       // a shipped fabric or a file
    File,         // a file that the garment names
};

constexpr bool is_length(Measure measure) {
    return measure == Measure::Length || measure == Measure::SmallLength || measure == Measure::LeftOfLine;
}
constexpr bool is_angle(Measure measure) {
    return measure == Measure::Angle || measure == Measure::Direction;
}

// The accepted values, SI. `problem`: what is said of another one; "#" stands for the number as written.
struct Range {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    std::string_view problem = {};

    constexpr bool holds(double value) const { return value >= least && value <= most; }  // false for NaN
};

enum class FileForm {
    Key,       // a key of the part's own object in a garment file; a new key is left out if the value is the default
    Required,  // a key that must be there
    ByHand,    // code of its own in pattern_read.cpp and pattern_file.cpp
    None,      // not in the file
};

// What becomes of a value where one part becomes two, two become one, or a part is copied.
enum class Descent {
    Kept,      // both have it; of two that are joined, the first's
    Gathered,  // of panels that are joined, those of both; of a panel that is cut, each where it lies
    Own,       // names: a copy has the default
    Key,       // what a part is known by: of the parts that one becomes, the first has it, and of those that become
               // one, the first's stays; a copy has it too
    Place,     // where a part lies: it follows its panel; a part that is made anew has its own
    Shape,     // of an outline and of what is sewn: set by sim/pattern/edge_shape.h and the editor's geometry
};

// Where a panel lies. A linked copy has its own placement and layer, and any derived panel its own place on the cloth.
enum class Placing {
    None,
    OnBody,   // how it starts round the body
    Side,     // the same, but a linked copy has its source's
    Layer,    // in which order panels lie on each other
    OnCloth,  // from which part of the cloth it is cut
};
constexpr bool is_placement(Placing placing) {
    return placing == Placing::OnBody || placing == Placing::Side;
}

// A row of the inspector (editor/inspectors/field_rows.h).
struct FieldRow {
    std::string_view label = {};  // empty: it has none, or one by hand
    std::string_view tip = {};
    std::string_view hint = {};  // shown in grey where a text is empty
};

template <auto kMember, FileForm kForm = FileForm::Key>
struct Field;

// The default is the member's own initialiser, in a part that is made without arguments.
template <class Part, class T, T Part::*kMember, FileForm kForm>
struct Field<kMember, kForm> {
    static constexpr T Part::*member = kMember;
    static constexpr FileForm form = kForm;
    static constexpr bool is_key = kForm == FileForm::Key || kForm == FileForm::Required;

    std::string_view name;            // in Python
    std::string_view key = name;      // in garment files
    std::string_view journal = name;  // in commands
    Measure measure = Measure::Plain;
    Range range = {};
    Descent descent = Descent::Kept;
    bool is_in_python = true;
    Placing placing = Placing::None;
    std::string_view record = {};  // its word in SVG and DXF; empty: what is drawn says it, or nothing does
    FieldRow row = {};
    std::size_t least_count = 0;  // of a list
};

// A type with a list of fields: fields(const T*), found in the namespace of T.
template <class T>
concept Described = requires {
    fields(static_cast<const T*>(nullptr));
};

template <Described Part>
constexpr const auto& fields_of() {
    return fields(static_cast<const Part*>(nullptr));
}

// visit(field) for each field.
template <Described Part, class Visit>
constexpr void for_each_field(Visit&& visit) {
    std::apply([&](const auto&... field) { (visit(field), ...); }, fields_of<Part>());
}

// visit(field, value) for each field, in the order of the list.
template <class Part, class Visit>
requires Described<std::remove_const_t<Part>>
constexpr void visit_fields(Part& part, Visit&& visit) {
    for_each_field<std::remove_const_t<Part>>([&](const auto& field) { visit(field, part.*field.member); });
}

// The keys of those fields of which `is_one` is true.
template <Described Part, class IsOne>
std::vector<std::string_view> keys_of(IsOne&& is_one) {
    std::vector<std::string_view> keys;
    for_each_field<Part>([&](const auto& field) {
        if (is_one(field)) keys.push_back(field.key);
    });
    return keys;
}

// A type with as many values as there are arguments. Not defined: for decltype.
template <class... Members>
std::index_sequence_for<Members...> counted(const Members&...);

}  // namespace selvedge::sim

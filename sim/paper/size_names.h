#pragma once
// Names of garment sizes in the names of layers, blocks and pieces.
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/paper/plain_drawing.h"

namespace selvedge::sim {

// "M" of "Size M", "SIZE NAME: m" and "m"; "38" of "Gr. 38"; "34/36" and "2XL" as they are; "38" of "EU 38 / UK 10". A
// bare number is a size from 24 to 66, and from 80 to 194 by twos, as children's are; behind a word for size any number
// is. None: no size.
std::optional<std::string> size_of_name(std::string_view name);

// Whether a text has a word for size: "size", "Gr.", "EU".
bool has_size_word(std::string_view text);

// The size in a shape's own name, or in that of its nearest group that has one; empty: none has.
std::string size_of_shape(const PlainShape& shape);

// "Front" and "M" of "Front_M", "Front-M", "Front M" and "M_Front"; none: the name neither ends nor begins so.
std::optional<std::pair<std::string, std::string>> split_size(std::string_view name);

// Of names that end in sizes, how they divide; none for the others, and for all of them unless two names at least have
// two sizes each.
std::vector<std::optional<std::pair<std::string, std::string>>> split_sizes(const std::vector<std::string>& names);

// Sorts names as sizes run: XS, S, M; 36, 38. Equal names and those that are no sizes keep their order.
void sort_sizes(std::vector<std::string>& sizes);

}  // namespace selvedge::sim

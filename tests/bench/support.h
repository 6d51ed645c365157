#pragma once
// Shared by the tests of the thesis' tables, figures and page.
#include <cstddef>
#include <string>

#include "bench/thesis/thesis.h"

namespace selvedge::bench {

inline const ThesisOptions kQuick{.is_quick = true};

inline double number(const Table& table, std::size_t row, std::size_t column) {
    return table.rows[row][column].to_json().number();
}

inline std::size_t occurrences(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

}  // namespace selvedge::bench

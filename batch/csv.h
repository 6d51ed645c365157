#pragma once
// Tables of comma-separated values (RFC 4180): a first row of names, then a row per record. Fields with commas, quotes
// or line ends stand in quotes. In what is read, semicolons or tabs may stand for commas.
#include <string>
#include <string_view>
#include <vector>

namespace selvedge::batch {

struct CsvRow {
    std::size_t line = 0;  // in the file, from 1, where it begins
    std::vector<std::string> fields;
};

// Rows without any text, such as those of commas alone, are left out. Lines may end as on Windows; a byte-order mark is
// skipped. Throws InputError with `file` and the line for a quote that is not closed, or text behind a closing one, and
// for UTF-16.
std::vector<CsvRow> parse_csv(std::string_view text, const std::string& file);

// The fields of a row as text, with its line end.
std::string csv_line(const std::vector<std::string>& fields);

}  // namespace selvedge::batch

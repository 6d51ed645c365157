#pragma once
// The text of a DXF file: pairs of a group code and a value, one per line; and entities, as runs of groups that begin
// with code 0.  (Autodesk, "DXF Reference")
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace selvedge::sim {

struct DxfGroup {
    int code = 0;
    std::string_view value;  // without blanks at its ends
    int line = 0;            // of the code, from 1
};

bool looks_like_dxf(std::string_view text);

// Throws InputError that names the line for a code that is no number, a binary file, and a file beyond the limits
// (64 MB, 4 million groups). The values are parts of the text. A file that ends early gives what it has.
std::vector<DxfGroup> parse_dxf(std::string_view text, const std::string& file);

// An entity with its groups, without the one of code 0 that names it.
struct DxfEntity {
    std::string_view type;
    int line = 0;
    std::vector<DxfGroup> groups;

    std::optional<std::string_view> text(int code) const;  // the first value of that code
    std::optional<double> number(int code) const;
};

// The text as UTF-8, where it is in the code page that its header names ($DWGCODEPAGE); none: it is ASCII or UTF-8, or
// names no page that is known.
std::optional<std::string> decoded_dxf(std::string_view text);

// Latin-1 or UTF-8 as UTF-8; \U+XXXX as the character that it names.
std::string dxf_string(std::string_view value);

std::optional<double> dxf_number(std::string_view value);

}  // namespace selvedge::sim

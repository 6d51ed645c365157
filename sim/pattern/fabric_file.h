#pragma once
// Fabric files as text: their keys with the range of each value, and a writer that keeps what else a file holds. The
// format is in patterns/FORMAT.md.
#include <span>
#include <string>
#include <string_view>

#include "sim/pattern/fabric.h"

namespace selvedge::sim {

// A key of a fabric file, the value that it sets, and the smallest and largest value that is accepted, in the units of
// Fabric: of the fields in sim/pattern/fabric_fields.h, those that are keys.
struct FabricKey {
    const char* key;
    double Fabric::*value;
    double least;
    double most;
    bool is_required;
};

std::span<const FabricKey> fabric_keys();

// The key of that value.
const FabricKey& fabric_key(double Fabric::*value);

// A fabric with the text that it was read from.
struct FabricFile {
    Fabric fabric = {};
    std::string text = {};  // empty: there is no file yet
};

// Finds a fabric as find_fabric does, with the same errors.
FabricFile read_fabric_file(std::string_view name_or_file);

bool is_shipped_fabric(std::string_view name);

// Whether the text names a file and not a shipped fabric.
bool is_fabric_file(std::string_view name);

// What a reader calls the fabric: the name of a shipped one; of a file its name without folder and ending.
std::string fabric_title(std::string_view name_or_file);

// The text of a fabric file at `file`, to which the path of a picture is relative. parse_fabric reads the same values
// back, to the bit. The other keys of `before`, the text of a fabric file or nothing, are kept, as are the order of all
// keys and the digits of unchanged numbers; a value that `before` does not have is left out if it is the default and
// optional. Throws InputError if `before` is not JSON, or if a value is out of range.
std::string write_fabric(const Fabric& fabric, const std::string& file, std::string_view before = {});

}  // namespace selvedge::sim

#pragma once
// Garment files: the GarmentCode specification with our additions under the key `selvedge`.  (patterns/FORMAT.md)
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/json.h"
#include "sim/pattern/fault.h"
#include "sim/pattern/pattern.h"

namespace selvedge {

// A pattern and the file that it came from: what we do not know or do not change is written back as it stood.
struct PatternDocument {
    Pattern pattern;
    Json json;  // null for a pattern that never was a file
};

// Throws InputError for the first fault that is an error; warnings pass (check_pattern_file lists them).
PatternDocument load_pattern(const std::filesystem::path& path);
PatternDocument parse_pattern(std::string_view text, const std::string& file);

// Every fault of a file, in its order; a file that cannot be read or is not JSON has one. Throws nothing of its own.
std::vector<Fault> check_pattern_file(const std::filesystem::path& path);
std::vector<Fault> check_pattern_text(std::string_view text, const std::string& file);

// The document as JSON text: keys, order and the text of numbers that did not change survive.
std::string write_pattern(const PatternDocument& document);

// Atomic. Throws InputError when the file cannot be written.
void save_pattern(const PatternDocument& document, const std::filesystem::path& path);

}  // namespace selvedge

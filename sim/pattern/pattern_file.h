#pragma once
// Garment files: the GarmentCode specification with our additions under the key `selvedge`.  (patterns/FORMAT.md)
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/json.h"
#include "sim/pattern/fault.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

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

// From a Pattern back to its GarmentCode specification.  (patterns/FORMAT.md)

// `base` with what differs in the pattern written over it; a null base gives a new specification, in centimetres.
// Panels are found by name: those that the pattern no longer has go, new ones are added at the end.
Json pattern_as_json(const Pattern& pattern, const Json& base);

// Gives a panel of a specification another name, in its place and with all that it holds; stitches and what we add that
// speak of it follow. For a pattern whose panel was renamed, so that pattern_as_json finds it again. Nothing happens
// when there is no panel `from`, or a panel `to` already.
void rename_panel_in_file(Json& specification, const std::string& from, const std::string& to);

}  // namespace selvedge::sim

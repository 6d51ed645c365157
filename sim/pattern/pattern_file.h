#pragma once
// Loads, checks and saves garment files: GarmentCode specifications with additions under the key `selvedge`. Saving
// preserves everything in the file that did not change.  (patterns/FORMAT.md)
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/json.h"
#include "sim/pattern/fault.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// A pattern and the JSON that it was read from. Unknown or unchanged parts of the JSON are written back as they were.
struct PatternDocument {
    Pattern pattern;
    Json json;                         // null for a pattern that was not read from a file
    std::vector<Fault> warnings = {};  // of reading it: the program and the editor tell them, Python by its check()
};

// The number of the format that is written where a file uses what an older program would misread. The first one has no
// number in the file.
inline constexpr int kGarmentFormat = 2;

// Why the file is not written anew: a newer program wrote it. None: this program knows the format.
std::optional<std::string> newer_format(const Json& root);

// Throws InputError for the first fault that is an error. A garment that was only begun may have no panels.
PatternDocument load_pattern(const std::filesystem::path& path);
PatternDocument parse_pattern(std::string_view text, const std::string& file);

// All faults of a file: first those found while reading it, then those of outlines and seams as shapes, then links that
// are broken (end_broken_links()), if no fault is an error. A file that cannot be read or is not JSON gives one fault.
// Do not throw InputError.
std::vector<Fault> check_pattern_file(const std::filesystem::path& path);
std::vector<Fault> check_pattern_text(std::string_view text, const std::string& file);

// The document as JSON text. Keys, their order and the text of unchanged numbers are preserved. file: where the text
// will be stored; a body in its folder is named relative to it.
std::string write_pattern(const PatternDocument& document, const std::filesystem::path& file = {});

// Replaces the file atomically. Throws InputError if it cannot be written, or if newer_format() has a reason.
void save_pattern(const PatternDocument& document, const std::filesystem::path& path);

// The pattern as a GarmentCode specification: a copy of `base` in which everything that differs from the pattern is
// overwritten. A null base gives a new specification in centimetres. Panels are matched by name: those that are not in
// the pattern are removed, new ones are added at the end.
Json pattern_as_json(const Pattern& pattern, const Json& base, const std::filesystem::path& file = {});

// Renames a panel in a specification, and all references to it in stitches, in the panel order and under `selvedge`.
// Call it when a panel of the pattern is renamed, so that pattern_as_json() matches the panel. Does nothing if panel
// `from` does not exist or panel `to` already exists.
void rename_panel_in_file(Json& specification, const std::string& from, const std::string& to);

}  // namespace selvedge::sim

#pragma once
// What would stop a garment from being dressed, besides what its file alone shows (check_pattern_file in
// sim/pattern/pattern_file.h): fabrics and a body that are missing or wrong, and seams that cannot be closed. `check`
// and `dress` share it, so that `check` reports what `dress` refuses.
#include <optional>
#include <string>
#include <vector>

#include "sim/pattern/fault.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

struct DressCheck {
    bool has_fabrics = true;                 // false: another fabric replaces those of the pattern and its panels
    bool makes_body_and_mesh = true;         // to see whether they can be; false: whoever dresses it makes them anyway
    std::optional<double> edge_length = {};  // m, of the base mesh; none: the pattern's
};

// Errors only, each with its path in the file `file`. Pre: the pattern was loaded, so that its parts exist. A garment
// that was only begun, without panels, has no fault.
std::vector<Fault> dress_faults(const Pattern& pattern, const std::string& file, const DressCheck& check = {});

// Throws InputError for the first of them, and for a garment without panels.
void refuse_undressable(const Pattern& pattern, const std::string& file, const DressCheck& check);

}  // namespace selvedge::sim

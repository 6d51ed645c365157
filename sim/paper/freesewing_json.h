#pragma once
// Reads FreeSewing's drafts as data: a JSON object with `design`, `measurements` (mm, degrees), `sa` (mm) and `parts`,
// each with `paths` (lists of move, line, curve and close), `snippets` and `points`; y points down.
#include <string>

#include "sim/core/json.h"
#include "sim/paper/drawing.h"

namespace selvedge::sim {

bool looks_like_freesewing(const Json& root);

// Throws InputError that names the key if the data are not what the format asks for.
Drawing read_freesewing(const Json& root, const std::string& file);

}  // namespace selvedge::sim

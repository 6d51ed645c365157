#pragma once
// What a seam is called. Files need not name their seams, so every seam has a name that follows from its edges, in the
// order of its stitch: "front.3+back.1".
#include <string>
#include <string_view>
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge {

// The seam's own name, else the one that follows from its edges.
std::string seam_name(const Pattern& pattern, const Seam& seam);

// The seams (indices into pattern.seams, ascending) that go by a name: their own, that of their edges in either order,
// or the label of one of their edges, which several may share. Empty: none does.
std::vector<int> find_seams(const Pattern& pattern, std::string_view name);

}  // namespace selvedge

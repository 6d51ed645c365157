#pragma once
// Garments that are worn over each other, as one pattern.
#include <span>
#include <string>
#include <vector>

#include "sim/pattern/pattern.h"

namespace selvedge::sim {

// The body that is dressed if neither the pattern nor who dresses names one.
inline constexpr const char* kDefaultBody = "mannequin:sex=female";

// The garment with these over it, from the inside out. `file`: its name in messages. Notes: one sentence per change.
// Throws InputError.
Pattern worn_together(Pattern pattern, std::span<const Pattern> over, const std::string& file,
                      std::vector<std::string>& notes);

}  // namespace selvedge::sim

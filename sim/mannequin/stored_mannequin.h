#pragma once
// Mannequins that are made once and kept in a store on disk, by their measurements.
#include "sim/core/content_store.h"
#include "sim/mannequin/mannequin.h"

namespace selvedge::sim {

// The mannequin of make_mannequin(). store: null for none. Throws InputError as make_mannequin() does.
Mannequin stored_mannequin(const MannequinOptions& options, const ContentStore* store);

}  // namespace selvedge::sim

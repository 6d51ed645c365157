#pragma once
// Mannequins that are made once and kept in a store on disk, by their measurements.
#include "sim/core/content_store.h"
#include "sim/mannequin/mannequin.h"
#include "sim/repair/stored_body.h"

namespace selvedge::sim {

// The body of make_mannequin() and the messages of its report. store: null for none. Throws InputError as
// make_mannequin() does.
MadeBody stored_mannequin(const MannequinOptions& options, const ContentStore* store);

}  // namespace selvedge::sim

#pragma once
// Bodies of files that are read once and kept in a store on disk.
#include <filesystem>
#include <string>
#include <vector>

#include "sim/core/content_store.h"
#include "sim/repair/load_body.h"

namespace selvedge::sim {

// The body and the clips of load_moving_body(), kept by the content of the file; appends the notes of its report. A
// .gltf, whose buffers are other files, is read each time. store: null for none. Throws InputError as
// load_moving_body() does.
BodyClips load_stored_body(const std::filesystem::path& path, const LoadBodyOptions& options, const ContentStore* store,
                           std::vector<std::string>& notes);

}  // namespace selvedge::sim

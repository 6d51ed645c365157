#pragma once
// Bodies that are made once and kept in a store on disk, by what they are made from.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim/body/body.h"
#include "sim/core/content_store.h"
#include "sim/repair/load_body.h"

namespace selvedge::sim {

// A body, with one sentence per deviation from what was asked for, or per change.
struct MadeBody {
    Body body;
    std::vector<std::string> notes;
};

// The body with the same bits, whether it is made or found in the store; a new one is kept there. store: null for none.
MadeBody stored_body(const std::string& made_from, const ContentStore* store, const std::function<MadeBody()>& make);

// The body of load_body() and the notes of its report, kept by the content of its file. A .gltf, whose buffers are
// other files, is read each time. Throws InputError as load_body() does.
MadeBody load_stored_body(const std::filesystem::path& path, const LoadBodyOptions& options, const ContentStore* store);

}  // namespace selvedge::sim

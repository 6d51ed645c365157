#pragma once
// A body with what is known of where it came from. It is made here from a text or a file, for whoever dresses, moves or
// draws it.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/body/body.h"
#include "sim/body/clip.h"
#include "sim/core/content_store.h"
#include "sim/mannequin/mannequin.h"
#include "sim/repair/load_body.h"

namespace selvedge::sim {

struct MadeBody {
    std::string source{};  // "mannequin:sex=female,bust=92", or a file; empty: made of what has no text
    std::shared_ptr<const Body> body{};
    std::vector<std::string> notes{};             // one sentence per deviation from what was asked for, or per change
    std::optional<MannequinReadings> readings{};  // of a mannequin
    std::vector<Clip> clips{};                    // motions of its file
};

// From the text of a mannequin, or a file. store: where it may be found and is kept; null for none. Throws InputError
// as parse_mannequin(), make_mannequin() and load_moving_body() do.
MadeBody make_body(const std::string& source, const LoadBodyOptions& load = {}, const ContentStore* store = nullptr);

// A mannequin; its source is empty. Reads no file.
MadeBody make_body(const MannequinOptions& options, const ContentStore* store = nullptr);

}  // namespace selvedge::sim

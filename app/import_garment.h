#pragma once
// From files of other programs to a garment that can be dressed: panels, seams, placement. For the command and the
// editor.
#include <filesystem>
#include <string>
#include <vector>

#include "app/underlay_files.h"
#include "sim/paper/import_options.h"
#include "sim/pattern/pattern.h"
#include "sim/proposals/seam_proposals.h"

namespace selvedge::app {

using sim::ImportOptions;

struct ImportedGarment {
    sim::Pattern pattern;
    std::vector<std::string> notes;      // what was read, guessed, repaired and left out, one line each
    std::vector<std::string> body;       // what the body's measurements were made of; empty: it has none
    std::vector<std::string> panels;     // "left_sleeve: sleeve, 8 edges, 45.3 x 17.9 cm"
    std::vector<std::string> sewn;       // the proposals that became seams, as describe() tells them
    std::vector<std::string> possible;   // those that did not
    std::vector<std::string> sizes;      // that the files have, in their order
    std::vector<UnderlayFile> pictures;  // of the pattern's underlays, not yet named and written
    std::string hints;                   // texts of the drawing about the whole garment, for roles_of()
};

// Several files make one garment. Of files that hold only scans it has no panels, but pictures to trace. Throws
// InputError; the place is in the file that is at fault.
ImportedGarment import_garment(const std::vector<std::filesystem::path>& files, const ImportOptions& options);

}  // namespace selvedge::app

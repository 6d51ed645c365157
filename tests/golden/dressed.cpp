#include "tests/golden/dressed.h"

#include <filesystem>

#include "sim/mannequin/mannequin.h"
#include "sim/pattern/pattern_file.h"

namespace selvedge {

Body coarse_mannequin() {
    return make_mannequin(parse_mannequin("mannequin:sex=female,resolution=1")).body;
}

DressedGarment dress_shipped(const std::string& garment, const DressOptions& options) {
    const auto path = std::filesystem::path(SELVEDGE_SOURCE_DIR) / "patterns" / (garment + ".json");
    return dress(load_pattern(path).pattern, coarse_mannequin(), options);
}

}  // namespace selvedge

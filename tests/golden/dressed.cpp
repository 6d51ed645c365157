#include "tests/golden/dressed.h"

#include <filesystem>

#include "sim/mannequin/mannequin.h"
#include "sim/pattern/pattern_file.h"

namespace selvedge::test {

sim::Body coarse_mannequin() {
    return sim::make_mannequin(sim::parse_mannequin("mannequin:sex=female,resolution=1")).body;
}

sim::DressedGarment dress_shipped(const std::string& garment, const sim::DressOptions& options) {
    const auto path = std::filesystem::path(SELVEDGE_SOURCE_DIR) / "patterns" / (garment + ".json");
    return dress(sim::load_pattern(path).pattern, coarse_mannequin(), options);
}

}  // namespace selvedge::test

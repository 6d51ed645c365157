#include "app/version_text.h"

#include "sim/core/simd_level.h"
#include "sim/core/version.h"

namespace selvedge::app {

std::string version_text(const Build& build) {
    const sim::SimdLevel used = sim::simd_level(), detected = sim::detected_simd_level();
    std::string text = "selvedge " + std::string(sim::program_version()) + "\n";
    text += build.commit.empty() ? "commit unknown: not built from git" : "commit " + std::string(build.commit);
    text += "; " + std::string(build.compiler) + ", " + std::string(build.type) + "\n";
    text += "SIMD " + std::string(name_of(used));
    if (used != detected) text += ", of " + std::string(name_of(detected));
    return text;
}

}  // namespace selvedge::app

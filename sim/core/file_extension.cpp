#include "sim/core/file_extension.h"

#include "sim/core/lower_case.h"

namespace selvedge::sim {

std::string lower_extension(const std::filesystem::path& path) {
    return lower_case(path.extension().string());
}

}  // namespace selvedge::sim

#include "sim/core/file_extension.h"

#include <cctype>

namespace selvedge::sim {

std::string lower_extension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

}  // namespace selvedge::sim

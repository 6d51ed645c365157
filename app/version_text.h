#pragma once
// What --version prints: the version, what it was built from and how, and the kernels that this computer uses.
#include <string>
#include <string_view>

namespace selvedge::app {

struct Build {
    std::string_view commit;    // for example "d5a9ef47a0b1", or "d5a9ef47a0b1, changed"; empty: not built from git
    std::string_view compiler;  // for example "GNU 12.2.0"
    std::string_view type;      // of CMake, for example "Release"
};

// The program's own. Defined in a source that the build writes (cmake/write_build.cmake), in the program alone: another
// commit compiles nothing else.
Build program_build();

// Three lines. Throws InputError if SELVEDGE_SIMD names no level.
std::string version_text(const Build& build);

}  // namespace selvedge::app

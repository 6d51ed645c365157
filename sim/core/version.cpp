#include "sim/core/version.h"

namespace selvedge::sim {

std::string_view program_version() {
    return SELVEDGE_VERSION;
}

}  // namespace selvedge::sim

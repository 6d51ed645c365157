#include "selvedge/version.h"

#include "sim/core/version.h"

namespace selvedge {

std::string_view version() noexcept {
    return sim::program_version();
}

}  // namespace selvedge

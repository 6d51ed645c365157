#include "tests/support/checkout.h"

namespace selvedge {

const std::string& source_folder() {
    static const std::string folder = SELVEDGE_SOURCE_FOLDER;
    return folder;
}

const std::string& program_folder() {
    static const std::string folder = SELVEDGE_PROGRAM_FOLDER;
    return folder;
}

}  // namespace selvedge

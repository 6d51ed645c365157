#pragma once
// Shared by the tests of editor/document.
#include <string>

#include "sim/pattern/pattern_file.h"
#include "tests/support/checkout.h"

namespace selvedge::editor {

inline sim::PatternDocument shipped(const std::string& name) {
    return sim::load_pattern(source_folder() + "/patterns/" + name);
}

}  // namespace selvedge::editor

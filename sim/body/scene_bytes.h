#pragma once
// What the importing child sends to its parent: an ImportedScene, or why there is none.
#include <optional>
#include <string>
#include <string_view>

#include "sim/body/guarded_import.h"

namespace selvedge {

struct ImportAnswer {
    std::string failure;  // empty when there is a scene
    ImportedScene scene;
};

std::string to_bytes(const ImportAnswer& answer);

// Nothing when the bytes are no such answer.
std::optional<ImportAnswer> from_bytes(std::string_view bytes);

}  // namespace selvedge

#pragma once
// GLFW's keys and letters as the editor has them.
#include <cstdint>
#include <string>

#include "editor/frame/input.h"

namespace selvedge {

// code: as GLFW numbers keys, by their place on an American keyboard. printed: what the key writes in the layout that
// is in use, or empty; a letter goes before the place. None for keys that the editor does not know.
Key key_of_code(int code, const std::string& printed);

std::string utf8_of(std::uint32_t code_point);

}  // namespace selvedge

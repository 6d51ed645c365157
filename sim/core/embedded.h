#pragma once
// Files compiled into the program (cmake/SelvedgeEmbed.cmake), so that it runs from any folder.
#include <string_view>

namespace selvedge {

struct EmbeddedFile {
    std::string_view name;  // path from the source root
    std::string_view text;
};

}  // namespace selvedge

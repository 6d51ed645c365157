#include "sim/core/percent_decoded.h"

#include <charconv>
#include <cstddef>

namespace selvedge::sim {

std::string percent_decoded(const std::string& text) {
    std::string decoded;
    for (std::size_t i = 0; i < text.size(); ++i) {
        unsigned char byte = 0;
        const char* const digits = text.data() + i + 1;
        const bool is_code =
            text[i] == '%' && i + 2 < text.size() && std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2;
        decoded += is_code ? static_cast<char>(byte) : text[i];
        if (is_code) i += 2;
    }
    return decoded;
}

}  // namespace selvedge::sim

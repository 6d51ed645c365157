#pragma once
// The names of files that formats write as parts of an address, as glTF does.
#include <string>

namespace selvedge::sim {

// "my body.bin" of "my%20body.bin" (RFC 3986, 2.1). A percent sign without two hexadecimal digits stays.
std::string percent_decoded(const std::string& text);

}  // namespace selvedge::sim

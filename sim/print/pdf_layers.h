#pragma once
// Layers (optional content groups) in a PDF that Cairo wrote: Cairo knows none, but draws each of its groups as a form
// object, and these become the content of layers.  (ISO 32000-1, 8.10 and 8.11)
#include <string>
#include <string_view>
#include <vector>

namespace selvedge::sim {

// names: of the layers, as viewers list them. used: per page, the layer of each group in the order in which they
// were drawn. A file that is not as Cairo 1.16 and 1.18 write it is returned as it is: it looks the same, without
// layers.
std::string with_layers(std::string pdf, const std::vector<std::string>& names,
                        const std::vector<std::vector<int>>& used);

}  // namespace selvedge::sim

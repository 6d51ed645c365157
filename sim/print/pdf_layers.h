#pragma once
// Layers (optional content groups) in a PDF that Cairo wrote: Cairo knows none, but marks content by structure tags,
// and these become layers.  (ISO 32000-1, 8.11 and 14.6)
#include <string>
#include <string_view>
#include <vector>

namespace selvedge::sim {

// The tag that stands for content of a layer. It may be any that Cairo accepts.
inline constexpr const char* kPdfLayerTag = "Div";

// names: of the layers, as viewers list them. used: per page, the layer of each tag in the order in which they began.
// A file that is not as Cairo 1.16 writes it is returned as it is: it looks the same, without layers.
std::string with_layers(std::string pdf, const std::vector<std::string>& names,
                        const std::vector<std::vector<int>>& used);

}  // namespace selvedge::sim

#include "sim/pattern/field_read.h"

#include <algorithm>

#include "sim/pattern/fabric.h"
#include "sim/pattern/fabric_file.h"

namespace selvedge::sim {

std::string read_fabric_name(FaultReader& reader, const JsonNode& node) {
    const auto name = reader.text(node);
    if (!name || name->empty() || is_fabric_file(*name)) return name.value_or("");
    const std::vector<std::string> known = fabric_names();
    if (std::find(known.begin(), known.end(), *name) == known.end()) {
        reader.warn(node, "no fabric '" + *name + "' ships with the program");
    }
    return *name;
}

std::nullopt_t FieldReader::refuse(const JsonNode& node, const Range& range) const {
    std::string problem(range.problem);
    if (problem.empty()) problem = "# is out of range";
    const std::size_t number = problem.find('#');
    if (number != std::string::npos)
        problem.replace(number, 1, node.value->is_number() ? node.value->number_text() : "the value");
    reader_.error(node, problem);
    return std::nullopt;
}

}  // namespace selvedge::sim

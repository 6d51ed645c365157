#include "sim/pattern/field_write.h"

#include <algorithm>
#include <cmath>

#include "sim/pattern/fabric_file.h"
#include "sim/pattern/named_file.h"

namespace selvedge::sim {

void set_number(Json& place, double value) {
    if (place.is_number() && std::abs(place.number() - value) <= 1e-9 * std::max(1.0, std::abs(value))) return;
    place = Json(std::round(value * 1e9) / 1e9 + 0.0);
}

void set_fabric(Json& place, const std::string& fabric, const std::filesystem::path& file) {
    if (is_fabric_file(fabric)) return set_named_file(place, fabric, file);
    place = Json(fabric);
}

}  // namespace selvedge::sim

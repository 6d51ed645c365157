#include "sim/paper/import_options.h"

#include "sim/core/error.h"

namespace selvedge::sim {

double metres_of_unit(const std::string& unit) {
    if (unit == "mm") return 0.001;
    if (unit == "cm") return 0.01;
    if (unit == "m") return 1;
    if (unit == "in") return 0.0254;
    if (unit == "pt") return 0.0254 / 72;
    if (unit == "px") return 0.0254 / 96;
    throw InputError("", "--unit", "'" + unit + "' is none of mm, cm, m, in, pt, px");
}

}  // namespace selvedge::sim

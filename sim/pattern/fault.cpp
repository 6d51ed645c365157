#include "sim/pattern/fault.h"

#include <algorithm>

namespace selvedge {

std::string describe(const Fault& fault) {
    return fault.file + ": " + (fault.place.empty() ? "" : fault.place + ": ") +
           (fault.severity == Severity::Warning ? "warning: " : "") + fault.problem;
}

bool has_error(const std::vector<Fault>& faults) {
    return std::any_of(faults.begin(), faults.end(),
                       [](const Fault& fault) { return fault.severity == Severity::Error; });
}

}  // namespace selvedge

#pragma once
// Shared by the tests of sim/dress.
#include <string>

#include "sim/inspection/report.h"

namespace selvedge::sim::test {

// One fault per line, for the message of a failing test.
inline std::string list_faults(const DressReport& report) {
    std::string text;
    for (const DressFault& fault : report.faults) {
        text += fault.kind + ": " + fault.place + " (" + std::to_string(fault.value) + ")\n";
    }
    return text;
}

}  // namespace selvedge::sim::test

#pragma once
// What is wrong in a file: where, and how badly.
#include <string>
#include <vector>

namespace selvedge {

enum class Severity { Warning, Error };

struct Fault {
    Severity severity = Severity::Error;
    std::string file;
    std::string place;    // JSON path, e.g. pattern.panels.front.edges[3]
    std::string problem;  // in words
};

// "garment.json: pattern.panels.front.edges[3]: warning: ..."
std::string describe(const Fault& fault);

bool has_error(const std::vector<Fault>& faults);

}  // namespace selvedge

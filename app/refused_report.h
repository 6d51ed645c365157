#pragma once
// The report of a command that is refused before it has what its own report needs: an older report of that name would
// be taken for its result.
#include <string>

#include "sim/core/error.h"

namespace selvedge::app {

class Command;

// Wrong input of which the command itself wrote a report.
class ReportedError : public sim::InputError {
 public:
    explicit ReportedError(const sim::InputError& error) : sim::InputError(error) {}
};

// Writes it to the file that `--report` names, if the command that was parsed has that option. Does nothing if it
// cannot be written, or there is a file that is no report.
void write_refused_report(const Command& app, const std::string& problem);

}  // namespace selvedge::app

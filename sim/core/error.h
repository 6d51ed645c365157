#pragma once
// The exception for wrong input. It is thrown where the fault is found and caught once, in main, which prints it on one
// line and exits with code 2.
#include <stdexcept>
#include <string>

#include "sim/core/printable.h"

namespace selvedge::sim {

// what() returns "file: place: problem" as one line (sim/core/printable.h); an empty file or place is omitted. `place`
// is the location in the file, such as a JSON path. The members are exact.
class InputError : public std::runtime_error {
 public:
    InputError(std::string file, std::string place, std::string problem)
        : std::runtime_error(fault_line(file, place, problem)),
          file_(std::move(file)),
          place_(std::move(place)),
          problem_(std::move(problem)) {}

    const std::string& file() const { return file_; }
    const std::string& place() const { return place_; }
    const std::string& problem() const { return problem_; }

 private:
    std::string file_;
    std::string place_;
    std::string problem_;
};

}  // namespace selvedge::sim

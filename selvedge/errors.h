#pragma once
// What the library's functions throw, and faults that they list.
//
// A function throws InputError for wrong input, Cancelled if the caller ended a dressing, std::bad_alloc if memory runs
// out, and what a function of the caller throws that it calls. Nothing else leaves it. A broken invariant of the
// library itself is no exception: it prints the condition and aborts.
#include <exception>
#include <stdexcept>
#include <string>

#include "selvedge/export.h"

namespace selvedge {

// Wrong input. what() is "file: place: problem" on one line; an empty file or place is left out.
class SELVEDGE_API InputError : public std::runtime_error {
 public:
    enum class Lasting {
        Always,   // the same input fails again
        ThisTime  // no process was left, it took too long, no OpenGL was found: another try may succeed
    };

    InputError(std::string file, std::string place, std::string problem, Lasting lasting = Lasting::Always);
    InputError(const InputError& other);
    InputError& operator=(const InputError&) = delete;
    ~InputError() override;

    const std::string& file() const noexcept { return file_; }    // with the fault; empty: none
    const std::string& place() const noexcept { return place_; }  // in the file (a JSON path), or the name of an option
    const std::string& problem() const noexcept { return problem_; }
    bool may_pass() const noexcept { return lasting_ == Lasting::ThisTime; }

 private:
    std::string file_;
    std::string place_;
    std::string problem_;
    Lasting lasting_;
};

// DressOptions::progress returned false.
class SELVEDGE_API Cancelled : public std::exception {
 public:
    Cancelled() noexcept = default;
    Cancelled(const Cancelled&) noexcept = default;
    Cancelled& operator=(const Cancelled&) = delete;
    ~Cancelled() override;
    const char* what() const noexcept override;
};

enum class Severity { Warning, Error };

// A fault of a garment file.
struct Fault {
    Severity severity = Severity::Error;
    std::string file;
    std::string place;    // JSON path, such as pattern.panels.front.edges[3]
    std::string problem;  // a sentence
};

}  // namespace selvedge

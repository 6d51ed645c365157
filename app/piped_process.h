#pragma once
// A program that reads what we write to it. It is started without a shell.
#include <sys/types.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace selvedge {

// Whether PATH has a program of that name.
bool has_program(const std::string& name);

class PipedProcess {
 public:
    // arguments: the program's name first; it is looked for in PATH. Its output goes nowhere.
    // Throws std::runtime_error when it cannot be started.
    explicit PipedProcess(const std::vector<std::string>& arguments);
    ~PipedProcess();  // one that was not waited for is killed
    PipedProcess(const PipedProcess&) = delete;
    PipedProcess& operator=(const PipedProcess&) = delete;

    // False when it does not read any more.
    bool write(std::string_view bytes);

    // Closes the pipe and waits. Whether it ended well.
    bool finish();

    // The first line that it complained with, so far.
    std::string complaint() const;

 private:
    void close_pipe();

    std::FILE* complaints_ = nullptr;  // a file without a name
    int pipe_ = -1;
    pid_t process_ = -1;
};

}  // namespace selvedge

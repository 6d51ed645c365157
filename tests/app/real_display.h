#pragma once
// Runs a program in a window on its own X server, with synthetic mouse and keyboard input from X11, and takes
// screenshots. Tests wait for results by wait_until().
#include <sys/types.h>

#include <memory>
#include <string>
#include <vector>

#include "render/image/image.h"
#include "sim/core/math.h"
#include "tests/app/run_program.h"

namespace selvedge::app {

// A child process beside the test; the destructor kills it if it still runs.
class RunningProgram {
 public:
    // words: the program and its arguments. environment: "NAME=value", added to the test's own environment.
    RunningProgram(const std::vector<std::string>& text, const std::vector<std::string>& environment,
                   const std::string& out_file);
    ~RunningProgram();
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;

    bool has_ended();
    int exit_code() const { return exit_code_; }  // from 128 on: a signal. Pre: has_ended()
    void kill_hard();                             // kill -9

 private:
    pid_t pid_ = -1;  // -1: it has ended
    int exit_code_ = 0;
};

class RealDisplay {
 public:
    // Returns the name of a required program that is missing; empty: all are installed.
    static std::string missing_program();

    RealDisplay(int width_px, int height_px);

    bool is_ready() const { return is_ready_; }
    std::string environment() const { return "DISPLAY=:" + number_; }

    // The title of the only window; empty: there is none (yet).
    std::string title() const;
    render::Image screenshot() const;

    void move(const Vec2d& px) const;
    void press() const { xdotool("mousedown 1"); }
    void release() const { xdotool("mouseup 1"); }
    void turn_wheel_up() const { xdotool("click 4"); }
    void key(const std::string& name) const;                                // for example "space"
    void key_with(const std::string& held, const std::string& name) const;  // "ctrl", "s"

 private:
    std::string xdotool(const std::string& text) const;

    ScratchFolder scratch_;
    std::unique_ptr<RunningProgram> server_;
    std::string number_;
    bool is_ready_ = false;
};

}  // namespace selvedge::app

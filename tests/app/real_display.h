#pragma once
// A display of its own with a program's window on it, and hands that X11 brings: what a person does and sees, from
// outside. What takes time is waited for by asking, for as long as a busy machine may need.
#include <sys/types.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "render/image/image.h"
#include "sim/core/math.h"
#include "tests/app/run_program.h"

namespace selvedge::app {

// A program that runs beside the test; killed at the latest when this goes.
class RunningProgram {
 public:
    // words: the program and its arguments. environment: "NAME=value", on top of the test's own.
    RunningProgram(const std::vector<std::string>& words, const std::vector<std::string>& environment,
                   const std::string& out_file);
    ~RunningProgram();
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;

    bool has_ended();
    int exit_code() const { return exit_code_; }  // 128 and more: of a signal. Pre: has_ended()
    void kill_hard();                             // as by kill -9

 private:
    pid_t pid_ = -1;  // -1: it has ended
    int exit_code_ = 0;
};

// Asks again and again until it holds. False: it did not within a minute and a half.
bool wait_until(const std::function<bool()>& holds);

class RealDisplay {
 public:
    // Empty: all that it needs is there; else what is absent.
    static std::string missing_program();

    RealDisplay(int width_px, int height_px);

    bool is_ready() const { return !number_.empty(); }
    std::string environment() const { return "DISPLAY=:" + number_; }

    // The title of the one window; empty: there is none (yet).
    std::string title() const;
    render::Image screenshot() const;

    void move(const Vec2d& px) const;
    void press() const { hand("mousedown 1"); }
    void release() const { hand("mouseup 1"); }
    void turn_wheel_up() const { hand("click 4"); }
    void key(const std::string& name) const;                                // "space"
    void key_with(const std::string& held, const std::string& name) const;  // "ctrl", "s"

 private:
    std::string hand(const std::string& words) const;

    ScratchFolder scratch_;
    std::unique_ptr<RunningProgram> server_;
    std::string number_;
};

}  // namespace selvedge::app

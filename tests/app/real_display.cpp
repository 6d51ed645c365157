#include "tests/app/real_display.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <sstream>

#include "render/image/image.h"
#include "tests/support/wait_until.h"

namespace selvedge::app {

RunningProgram::RunningProgram(const std::vector<std::string>& text, const std::vector<std::string>& environment,
                               const std::string& out_file) {
    pid_ = fork();
    if (pid_ != 0) return;
    const int out = open(out_file.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
    dup2(out, STDOUT_FILENO);
    dup2(out, STDERR_FILENO);
    for (const std::string& setting : environment) putenv(const_cast<char*>(setting.c_str()));
    std::vector<char*> arguments;
    for (const std::string& word : text) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
    _exit(127);
}

RunningProgram::~RunningProgram() {
    kill_hard();
}

bool RunningProgram::has_ended() {
    if (pid_ < 0) return true;
    int status = 0;
    if (waitpid(pid_, &status, WNOHANG) != pid_) return false;
    pid_ = -1;
    exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return true;
}

void RunningProgram::kill_hard() {
    if (has_ended()) return;
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
    pid_ = -1;
    exit_code_ = 128 + SIGKILL;
}

std::string RealDisplay::missing_program() {
    for (const char* program : {"Xvfb", "xdotool", "import"}) {
        if (run_command(std::string("command -v ") + program).exit_code != 0) return program;
    }
    return "";
}

// Without -noreset the server restarts when its last client disconnects, and refuses connections meanwhile.
RealDisplay::RealDisplay(int width_px, int height_px) {
    const std::string size = std::to_string(width_px) + "x" + std::to_string(height_px) + "x24";
    const std::string said = scratch_ / "server";
    server_ = std::make_unique<RunningProgram>(
        std::vector<std::string>{"Xvfb", "-displayfd", "1", "-screen", "0", size, "-nolisten", "tcp", "-noreset"},
        std::vector<std::string>{}, said);
    const auto has_number = [&] {  // a line of digits; the server's other messages go to the same file
        std::istringstream lines(content_of(said));
        for (std::string line; std::getline(lines, line) && !lines.eof();) {
            if (!line.empty() && line.find_first_not_of("0123456789") == std::string::npos) number_ = line;
        }
        return !number_.empty() || server_->has_ended();
    };
    is_ready_ = wait_until(has_number) && !number_.empty();
}

std::string RealDisplay::xdotool(const std::string& text) const {
    return run_command(environment() + " xdotool " + text).out;
}

std::string RealDisplay::title() const {
    const std::string name = xdotool("search --onlyvisible --name . getwindowname");
    return name.substr(0, name.find('\n'));
}

render::Image RealDisplay::screenshot() const {
    const std::string file = scratch_ / "shot.png";
    run_command(environment() + " import -silent -window root png24:'" + file + "'");
    return render::read_png(file);
}

void RealDisplay::move(const Vec2d& px) const {
    xdotool("mousemove " + std::to_string(std::lround(px.x())) + " " + std::to_string(std::lround(px.y())));
}

void RealDisplay::key(const std::string& name) const {
    xdotool("keydown " + name + " keyup " + name);
}

void RealDisplay::key_with(const std::string& held, const std::string& name) const {
    xdotool("keydown " + held + " keydown " + name + " keyup " + name + " keyup " + held);
}

}  // namespace selvedge::app

#include "app/stop_signal.h"

namespace selvedge::app {
namespace {

volatile std::sig_atomic_t raised = 0;

void note(int number) {
    raised = number;
    struct sigaction usual {};
    usual.sa_handler = SIG_DFL;
    ::sigaction(number, &usual, nullptr);
}

}  // namespace

StopSignal::StopSignal() {
    raised = 0;
    struct sigaction noting {};
    noting.sa_handler = note;
    ::sigaction(SIGINT, &noting, &interrupt_);
    ::sigaction(SIGTERM, &noting, &terminate_);
}

StopSignal::~StopSignal() {
    ::sigaction(SIGINT, &interrupt_, nullptr);
    ::sigaction(SIGTERM, &terminate_, nullptr);
}

bool StopSignal::is_raised() const {
    return raised != 0;
}

int StopSignal::exit_code() const {
    return 128 + raised;
}

}  // namespace selvedge::app

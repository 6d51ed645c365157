#include "sim/dress/session.h"

#include "sim/core/assert.h"
#include "sim/dress/session_worker.h"

namespace selvedge::sim {
bool SessionOptions::operator==(const SessionOptions&) const = default;

Session::Session(SessionDrive drive) : worker_(std::make_unique<Worker>(drive)) {}
Session::~Session() = default;

void Session::set_body(std::shared_ptr<const Body> body) {
    worker_->put(ask::SetBody{std::move(body)});
}

void Session::set_pattern(const Pattern& pattern) {
    worker_->put(ask::SetPattern{pattern});
}

void Session::set_options(const SessionOptions& options) {
    worker_->put(ask::SetOptions{options});
}

void Session::start() {
    worker_->put(ask::Start{});
}

void Session::pause() {
    worker_->put(ask::Pause{});
}

void Session::reset() {
    worker_->put(ask::Reset{});
}

void Session::pull(const ClothPoint& point, const Vec3f& to) {
    if (const auto at = worker_->find(point)) {
        worker_->put(ask::Pull{*at, to});
    } else {
        worker_->put(ask::Say{"what was taken hold of is no longer there"});
    }
}

void Session::pull_to(const Vec3f& to) {
    worker_->put(ask::PullTo{to});
}

void Session::let_go() {
    worker_->put(ask::LetGo{});
}

void Session::pin(const ClothPoint& point) {
    if (const auto at = worker_->find(point)) {
        worker_->put(ask::Pin{*at});
    } else {
        worker_->put(ask::Say{"what was to be pinned is no longer there"});
    }
}

void Session::unpin_all() {
    worker_->put(ask::UnpinAll{});
}

std::shared_ptr<const SessionFrame> Session::frame() const {
    return worker_->frame();
}

void Session::keep(const std::string& name) {
    worker_->put(ask::Keep{name});
}

void Session::restore(const std::string& name) {
    worker_->put(ask::Restore{name});
}

void Session::advance(int frames) {
    SELVEDGE_ASSERT(frames >= 0);
    worker_->advance(frames);
}

}  // namespace selvedge::sim

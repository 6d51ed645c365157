#include "editor/workspace/messages.h"

namespace selvedge {

void Messages::say(Message message) {
    constexpr std::size_t kMost = 200;
    all_.push_back(std::move(message));
    if (all_.size() > kMost) all_.erase(all_.begin());
    ++count_;
    is_shown_ = true;
}

void Messages::error(const DraftError& error) {
    say({.kind = MessageKind::Error, .words = error.what(), .places = error.places()});
}

}  // namespace selvedge

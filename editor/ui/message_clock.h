#pragma once
// How long words stay in the status line: notes a while, warnings twice as long, errors until something else is done.
#include <cstddef>

#include "editor/workspace/messages.h"

namespace selvedge {

class MessageClock {
 public:
    // Once per frame; `seconds` since the last one. Takes the message away when its time is over.
    void follow(Messages& messages, double seconds);

 private:
    std::size_t count_ = 0;  // of the message whose time runs
    double shown_for_ = 0;   // s
};

}  // namespace selvedge

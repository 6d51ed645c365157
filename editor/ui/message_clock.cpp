#include "editor/ui/message_clock.h"

namespace selvedge {

void MessageClock::follow(Messages& messages, double seconds) {
    constexpr double kNoteStays = 6, kWarningStays = 12;  // s
    if (messages.count() != count_) {
        count_ = messages.count();
        shown_for_ = 0;
        return;
    }
    const Message* shown = messages.shown();
    if (shown == nullptr || shown->kind == MessageKind::Error) return;
    shown_for_ += seconds;
    if (shown_for_ >= (shown->kind == MessageKind::Note ? kNoteStays : kWarningStays)) messages.dismiss();
}

}  // namespace selvedge

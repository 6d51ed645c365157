#pragma once
// What the editor has to say to the person at it: words in the status line, and places that are lit up with them.
#include <cstddef>
#include <string>
#include <vector>

#include "editor/drafting/draft_error.h"

namespace selvedge {

enum class MessageKind { Note, Warning, Error };

struct Message {
    MessageKind kind = MessageKind::Note;
    std::string words;
    std::vector<DraftPlace> places;
};

// The newest is last. Old ones are forgotten.
class Messages {
 public:
    void say(Message message);
    void note(const std::string& words) { say({.kind = MessageKind::Note, .words = words, .places = {}}); }
    void warn(const std::string& words) { say({.kind = MessageKind::Warning, .words = words, .places = {}}); }
    void error(const DraftError& error);

    // Takes the newest off the screen; the list keeps it.
    void dismiss() { is_shown_ = false; }

    const Message* shown() const { return is_shown_ && !all_.empty() ? &all_.back() : nullptr; }
    const std::vector<Message>& all() const { return all_; }
    std::size_t count() const { return count_; }  // ever said

 private:
    std::vector<Message> all_;
    std::size_t count_ = 0;
    bool is_shown_ = false;
};

}  // namespace selvedge

#pragma once
// Passes input events to ImGui. ImGui samples its input once per frame, so events that would hide each other, such as a
// press and its release, are spread over several frames.
#include <deque>
#include <vector>

#include "editor/frame/frame.h"

struct ImGuiIO;

namespace selvedge::editor {

class UiInput {
 public:
    void add(const std::vector<InputEvent>& events);

    // Passes as many events as one frame can take. Returns the events that ImGui does not handle: dropped files, close
    // requests.
    std::vector<InputEvent> begin_frame(ImGuiIO& io);

    bool has_more() const { return !waiting_.empty(); }

 private:
    std::deque<InputEvent> waiting_;
};

}  // namespace selvedge::editor

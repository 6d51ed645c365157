#pragma once
// Hands what a person does to ImGui, which looks once per frame: what would be lost between two looks, such as a press
// and its release, waits for the next frame.
#include <deque>
#include <vector>

#include "editor/frame/frame.h"

struct ImGuiIO;

namespace selvedge::editor {

class UiInput {
 public:
    // Tells ImGui which keys are which. Once per context.
    static void map_keys(ImGuiIO& io);

    void add(const std::vector<InputEvent>& events);

    // Hands over as much as one frame can take. Returns what ImGui has no place for: dropped files, a wish to close.
    std::vector<InputEvent> begin_frame(ImGuiIO& io);

    bool has_more() const { return !waiting_.empty(); }

 private:
    std::deque<InputEvent> waiting_;
};

}  // namespace selvedge::editor

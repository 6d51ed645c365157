#pragma once
// Finding an action by typing some of its letters (Ctrl+K).
#include <string>

namespace selvedge {

struct Desk;

class ActionFinder {
 public:
    void open();
    bool is_open() const { return is_open_; }
    void show(Desk& desk);

 private:
    bool is_open_ = false;
    bool takes_focus_ = false;
    std::string wanted_;
    int chosen_ = 0;
};

}  // namespace selvedge

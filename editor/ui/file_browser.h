#pragma once
// Choosing a file, in a window that nothing waits for.
#include <functional>
#include <string>
#include <vector>

#include "editor/ui/services.h"

namespace selvedge {

struct Desk;

struct BrowseRequest {
    std::string title;
    std::string verb;                  // on its button
    std::vector<std::string> endings;  // of files that are listed: ".json"
    bool is_saving = false;            // a new name may be typed
    std::string name{};                // proposed
    std::function<void(Desk&, const std::string& file)> choose;
};

class FileBrowser {
 public:
    void open(BrowseRequest request, const Services& services);
    bool is_open() const { return is_open_; }

    void show(Desk& desk);

 private:
    void show_entries(Desk& desk);
    void enter(const std::string& folder, const Services& services);
    void choose(Desk& desk);

    bool is_open_ = false;
    bool takes_focus_ = false;
    BrowseRequest request_;
    FolderListing listing_;
    std::string name_;
    std::string folder_;  // of the last time
};

}  // namespace selvedge

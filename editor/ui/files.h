#pragma once
// Opening, saving and leaving documents. What would lose work asks first, in a bar; what fails says so in words.
#include <functional>
#include <string>
#include <vector>

#include "editor/ui/services.h"

namespace selvedge::editor {

struct AppState;

void new_document(AppState& desk);
void open_loaded(AppState& desk, sim::PatternDocument source, const std::string& file);
void open_file(AppState& desk, const std::string& file);
void open_example(AppState& desk, const Example& example);
void recover_journal(AppState& desk, const LeftJournal& journal);

// A garment file is opened, a body is put on; anything else is said to be neither.
void take_dropped_file(AppState& desk, const std::string& file);

bool save(AppState& desk);  // asks for a name where there is none; false: not saved (yet)
void save_as(AppState& desk, const std::string& file);
void export_to(AppState& desk, const std::string& file);
void close(AppState& desk);

// What the browser is opened for.
void browse_to_open(AppState& desk);
void browse_to_save(AppState& desk);
void browse_to_export(AppState& desk, const std::string& ending);
void browse_for_body(AppState& desk);

// Asks about what earlier runs left.
void offer_recovery(AppState& desk);

// "tshirt.json", "untitled"
std::string document_name(const AppState& desk);

// Choosing a file, in a window that nothing waits for.

struct AppState;

struct BrowseRequest {
    std::string title;
    std::string verb;                  // on its button
    std::vector<std::string> endings;  // of files that are listed: ".json"
    bool is_saving = false;            // a new name may be typed
    std::string name{};                // proposed
    std::function<void(AppState&, const std::string& file)> choose;
};

class FileBrowser {
 public:
    void open(BrowseRequest request, const Services& services);
    bool is_open() const { return is_open_; }

    void show(AppState& desk);

 private:
    void show_entries(AppState& desk);
    void enter(const std::string& folder, const Services& services);
    void choose(AppState& desk);

    bool is_open_ = false;
    bool takes_focus_ = false;
    BrowseRequest request_;
    FolderListing listing_;
    std::string name_;
    std::string folder_;  // of the last time
};

}  // namespace selvedge::editor

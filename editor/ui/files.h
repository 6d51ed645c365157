#pragma once
// Opening, saving and closing documents, and the file browser. Operations that would discard unsaved changes ask first,
// in a bar; errors are shown as messages.
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/ui/services.h"

namespace selvedge::editor {

struct AppState;

void new_document(AppState& state);
void open_loaded(AppState& state, sim::PatternDocument source, const std::string& file);
void load_and_open(AppState& state, const std::string& file);  // asks nothing; throws InputError
void open_file(AppState& state, const std::string& file);
void open_example(AppState& state, const Example& example);
// A drawing of another program, or a photo. Of a drawing with several sizes, the editor asks which one.
void import_file(AppState& state, const std::string& file, const sim::ImportOptions& options = {});
void lay_photo(AppState& state, const std::string& file);               // under the sheet, to be traced
void wear_over(AppState& state, const std::string& file);               // puts another garment over the document's
void recover_journal(AppState& state, const OrphanedJournal& journal);  // Pre: it has something to recover

// Opens a garment file, imports a drawing, lays a photo under the sheet or puts on a body file; reports any other file
// as unknown.
void take_dropped_file(AppState& state, const std::string& file);

// Writes the document to its file, then runs `then`. Asks for a name if there is none, and what to do if another
// program changed the file since it was read or written.
void save(AppState& state, std::function<void(AppState&)> then = {});
// What becomes of a file that is there already.
enum class IfExists { Ask, Replace };

void save_as(AppState& state, const std::string& file, IfExists if_exists = IfExists::Ask);
void export_to(AppState& state, const std::string& file, const ExportThickness& thickness = {},
               IfExists if_exists = IfExists::Ask);
// The pattern, at true size.
void print_to(AppState& state, const std::string& file, const sim::PrintSettings& settings = {},
              IfExists if_exists = IfExists::Ask);
void save_pose(AppState& state, const std::string& file);  // the body's, which is then the file's
void close(AppState& state);

// These open the file browser for a purpose.
void browse_to_open(AppState& state);
void browse_to_import(AppState& state);
void browse_to_wear_over(AppState& state);
void browse_to_save(AppState& state);
void browse_to_export(AppState& state, const std::string& ending);
void browse_to_print(AppState& state, const std::string& ending);
void browse_for_picture(AppState& state);  // that the selected panels show, or the garment
void browse_for_body(AppState& state);
void browse_for_motion(AppState& state);
void browse_for_pose(AppState& state);
void browse_to_save_pose(AppState& state);

// What saving has in common. try_to runs a function that may throw InputError, which is then shown; it returns false.
bool try_to(AppState& state, const std::function<void()>& function);
void ask_to_replace(AppState& state, const std::string& file, std::function<void(AppState&)> write);
void ask_to_replace(AppState& state, const std::vector<std::string>& files, std::function<void(AppState&)> write);
std::string with_ending(const std::string& file, const std::string& ending);

// Offers to recover the journals that earlier runs left.
void offer_recovery(AppState& state);

// Of a garment's file: "tshirt" of "tshirt.json" and of "tshirt.garment.json".
std::string name_without_ending(std::string name);

// For example "tshirt.json"; "untitled" without a file.
std::string document_name(const AppState& state);

// A non-modal window to choose a file.

struct BrowseRequest {
    std::string title;
    std::string verb;                               // label of the confirm button
    std::vector<std::string> endings;               // extensions of the files to list: ".json"
    bool is_saving = false;                         // a new name may be typed
    std::string name{};                             // proposed file name
    std::function<void(AppState&)> show_options{};  // draws rows of controls above the name; unset: none
    int option_rows = 1;                            // that it draws
    std::function<void(AppState&, const std::string& file)> choose;
};

class FileBrowser {
 public:
    void open(BrowseRequest request, const Services& services);
    bool is_open() const { return is_open_; }

    void show(AppState& state);

    // The names that are listed, if it is open.
    void visit_text(const std::function<void(std::string_view)>& visit) const;

 private:
    void show_entries(AppState& state);
    void enter(const std::string& folder, const Services& services);
    void choose(AppState& state);

    bool is_open_ = false;
    bool takes_focus_ = false;
    BrowseRequest request_;
    FolderListing listing_;
    std::string name_;
    std::string folder_;  // the folder that was shown last
};

}  // namespace selvedge::editor

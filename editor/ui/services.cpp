#include "editor/ui/services.h"

#include "sim/core/error.h"

namespace selvedge::editor {

Services no_services() {
    Services services;
    services.load = [](const std::string& file) -> sim::PatternDocument {
        throw sim::InputError(file, "", "cannot be read");
    };
    services.save = [](const std::string& file, const std::string&) {
        throw sim::InputError(file, "", "cannot be written");
    };
    services.list_folder = [](const std::string&) { return FolderListing{}; };
    services.exists = [](const std::string&) { return false; };
    services.write_export = [](const ExportRequest& request) {
        throw sim::InputError(request.file, "", "cannot be written");
    };
    services.recent_files = [] { return std::vector<std::string>(); };
    services.remember_file = [](const std::string&) {};
    services.begin_journal = [](const std::string&) {};
    services.note_in_journal = [](std::string_view) {};
    services.end_journal = [] {};
    services.orphaned_journals = [] { return std::vector<OrphanedJournal>(); };
    services.discard_journal = [](const std::string&) {};
    return services;
}

}  // namespace selvedge::editor

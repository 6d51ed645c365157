#pragma once
// What an editor asks of the program around it, without files: no folder has any, and nothing is remembered.
#include <string>
#include <string_view>
#include <vector>

#include "editor/ui/files.h"
#include "editor/ui/services.h"

namespace selvedge::editor {

inline Services services_without_files() {
    Services services;
    services.list_folder = [](const std::string&) { return FolderListing{}; };
    services.remove = [](const std::string&) {};
    services.exists = [](const std::string&) { return false; };
    services.is_photo = [](const std::string&) { return false; };
    services.full_path = [](const std::string& file) { return file; };
    services.recent_files = [] { return std::vector<std::string>(); };
    services.remember_file = [](const std::string&) {};
    services.begin_journal = [](const std::string&) {};
    services.note_in_journal = [](std::string_view) {};
    services.end_journal = [] {};
    services.orphaned_journals = [] { return std::vector<OrphanedJournal>(); };
    services.discard_journal = [](const std::string&) {};
    services.set_aside_journal = [](const std::string& id) { return id; };
    return services;
}

}  // namespace selvedge::editor

#include "sim/core/file_path.h"

namespace selvedge::sim {

namespace fs = std::filesystem;

bool file_exists(const fs::path& path) {
    std::error_code error;
    return fs::exists(path, error);
}

bool is_file(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error);
}

bool is_folder(const fs::path& path) {
    std::error_code error;
    return fs::is_directory(path, error);
}

fs::path absolute_path(const fs::path& path) {
    std::error_code error;
    fs::path whole = fs::absolute(path, error);
    return error ? path : whole;
}

fs::path canonical_path(const fs::path& path) {
    const fs::path whole = absolute_path(behind_links(path));
    std::error_code error;
    fs::path found = fs::weakly_canonical(whole, error);
    return error ? whole.lexically_normal() : found;
}

fs::path behind_links(const fs::path& path) {
    constexpr int kMostLinks = 40;  // as many as Linux follows
    fs::path target = path;
    for (int i = 0; i < kMostLinks; ++i) {
        std::error_code error;
        const fs::path next = fs::read_symlink(target, error);
        if (error) return target;  // not a link
        target = folder_of(target) / next;
    }
    return path;
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

std::vector<fs::path> entries_of(const fs::path& folder, std::error_code& error) {
    std::vector<fs::path> entries;
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        entries.push_back(entry->path());
    }
    return entries;
}

}  // namespace selvedge::sim

#include "app/recent_files.h"

#include <algorithm>

#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/json.h"

namespace selvedge {

std::vector<std::string> RecentFiles::list() const {
    std::vector<std::string> files;
    try {
        const Json json = read_json(file_);
        const JsonView view(json, file_.string());
        for (std::size_t i = 0; i < view.size(); ++i) {
            if (std::filesystem::exists(view.at(i).string())) files.push_back(view.at(i).string());
        }
    } catch (const InputError&) {  // none yet, or not ours: nothing was opened
    }
    return files;
}

void RecentFiles::add(const std::string& path) const {
    constexpr std::size_t kMost = 12;
    std::vector<std::string> files = list();
    const std::string whole = std::filesystem::absolute(path).lexically_normal().string();
    std::erase(files, whole);
    files.insert(files.begin(), whole);
    if (files.size() > kMost) files.resize(kMost);
    Json json = Json::array();
    for (const std::string& file : files) json.push_back(Json(file));
    try {
        write_file_atomically(file_, write_json(json));
    } catch (const InputError&) {  // a list of files is not worth an error
    }
}

}  // namespace selvedge

#include "app/output_files.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <set>
#include <string>

#include "sim/core/error.h"

namespace selvedge {
namespace {

namespace fs = std::filesystem;

void check_extension(const fs::path& path, std::span<const std::string_view> extensions) {
    std::string extension = path.extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (std::find(extensions.begin(), extensions.end(), extension) != extensions.end()) return;
    std::string known;
    for (const std::string_view name : extensions) known += (known.empty() ? "" : " or ") + std::string(name);
    throw InputError(path.string(), "", "cannot write: the name should end in " + known);
}

// One name for a file, whichever way it is spelt; it need not be there.
fs::path one_name(const fs::path& path) {
    std::error_code error;
    const fs::path name = fs::weakly_canonical(fs::absolute(path), error);
    return error ? path : name;
}

}  // namespace

void check_output(const fs::path& path, std::span<const std::string_view> extensions) {
    if (!extensions.empty()) check_extension(path, extensions);
    std::error_code ignored;
    if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored))
        throw InputError(path.string(), "", "cannot write: what stands there is not a file");
    const fs::path folder = one_name(path).parent_path();
    if (access(folder.c_str(), W_OK | X_OK) != 0)
        throw InputError(path.string(), "", std::string("cannot write: ") + std::strerror(errno));
    if (!path.has_filename()) throw InputError(path.string(), "", "cannot write: this names a folder");
}

void check_apart(const std::vector<fs::path>& outputs, const std::vector<fs::path>& inputs) {
    std::set<fs::path> taken;
    for (const fs::path& input : inputs) taken.insert(one_name(input));
    for (const fs::path& output : outputs) {
        if (!taken.insert(one_name(output)).second)
            throw InputError(output.string(), "", "cannot write: the same command reads or writes it already");
    }
}

}  // namespace selvedge

#include "render/output/shipped_files.h"

#include <dlfcn.h>
#include <link.h>
#include <sys/auxv.h>

#include <cstdlib>

#include "sim/core/file_path.h"

namespace selvedge::render {
namespace {

// Of the program or the module that holds this function.
std::filesystem::path own_file() {
    Dl_info info{};
    void* found = nullptr;
    const bool is_known = ::dladdr1(reinterpret_cast<void*>(&own_file), &info, &found, RTLD_DL_LINKMAP) != 0;
    const auto* const map = static_cast<const link_map*>(found);
    const bool is_module = is_known && map != nullptr && map->l_name != nullptr && *map->l_name != '\0';
    if (is_module) return sim::canonical_path(map->l_name);  // the loader gives a program no name
    constexpr const char* kProgram = "/proc/self/exe";
    if (sim::is_file(kProgram)) return sim::canonical_path(kProgram);
    const auto* const started = reinterpret_cast<const char*>(::getauxval(AT_EXECFN));  // where /proc is not mounted
    return started == nullptr ? std::filesystem::path() : sim::canonical_path(started);
}

}  // namespace

std::filesystem::path shipped_folder() {
    const std::filesystem::path beside = sim::folder_of(own_file());
    for (const std::filesystem::path& tree : {sim::folder_of(beside), beside}) {
        if (sim::is_folder(tree / "share" / "selvedge")) return tree / "share" / "selvedge";
    }
    return {};
}

void use_shipped_fonts() {
    const std::filesystem::path folder = shipped_folder();
    if (folder.empty() || std::getenv("FONTCONFIG_FILE") != nullptr || std::getenv("FONTCONFIG_PATH") != nullptr)
        return;
    const std::filesystem::path configuration = folder / "fonts" / "fonts.conf";
    constexpr int kReplace = 1;
    if (sim::is_file(configuration)) ::setenv("FONTCONFIG_FILE", configuration.c_str(), kReplace);
}

}  // namespace selvedge::render

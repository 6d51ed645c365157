#include "sim/core/content_store.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <system_error>
#include <utility>
#include <vector>

#include "sim/core/atomic_file.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/file_path.h"
#include "sim/core/sha256.h"

namespace selvedge::sim {
namespace {

using Path = std::filesystem::path;

constexpr std::string_view kExtension = ".stored";
constexpr std::size_t kHashDigits = 64;
constexpr double kKeptShare = 0.8;  // of the limit, when entries go: so that not every new one makes others go

struct Entry {
    Path path;
    std::filesystem::file_time_type used;
    std::uint64_t bytes = 0;
};

// The entries, and what writers that were killed have left, which takes room too: AtomicFile removes only what is known
// to be left by the same user. A writer that lives is done within seconds.
std::vector<Entry> stored_in(const Path& folder) {
    constexpr std::chrono::hours kLongestWrite(1);
    const auto now = std::filesystem::file_time_type::clock::now();
    std::vector<Entry> entries;
    std::error_code error;
    for (const Path& path : entries_of(folder, error)) {
        const bool is_temporary = is_temporary_name(path.filename().native());
        if (path.extension() != kExtension && !is_temporary) continue;
        std::error_code error_of_entry;  // another process may have removed it
        const std::uint64_t bytes = std::filesystem::file_size(path, error_of_entry);
        if (error_of_entry) continue;
        const auto used = std::filesystem::last_write_time(path, error_of_entry);
        if (error_of_entry || (is_temporary && now - used < kLongestWrite)) continue;
        entries.push_back({path, used, bytes});
    }
    return entries;
}

}  // namespace

ContentStore::ContentStore(Path folder, std::string maker, std::uint64_t most_bytes)
    : folder_(std::move(folder)), maker_(std::move(maker)), most_bytes_(most_bytes) {
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error) throw InputError(folder_.string(), "", "cannot be made: " + error.message());
    if (!is_folder(folder_)) throw InputError(folder_.string(), "", "is no folder");
}

Path ContentStore::path_of(std::string_view kind, std::string_view made_from) const {
    std::string text(maker_);
    text += '\0';
    text += kind;
    text += '\0';
    text += made_from;
    return folder_ / (std::string(kind) + "-" + sha256(text) + std::string(kExtension));
}

std::optional<std::string> ContentStore::find(std::string_view kind, std::string_view made_from) const {
    const Path path = path_of(kind, made_from);
    if (!file_exists(path)) return std::nullopt;
    std::error_code error;
    try {
        std::string content = read_file(path, most_bytes_ + kHashDigits);
        if (content.size() >= kHashDigits) {
            const std::string hash = content.substr(content.size() - kHashDigits);
            content.resize(content.size() - kHashDigits);
            if (hash == sha256(content)) {
                std::filesystem::last_write_time(path, std::filesystem::file_time_type::clock::now(), error);
                return content;
            }
        }
        std::filesystem::remove(path, error);
    } catch (const InputError&) {  // gone meanwhile, or not ours: it is made again
    }
    return std::nullopt;
}

void ContentStore::keep(std::string_view kind, std::string_view made_from, std::string_view content) const {
    if (content.size() + kHashDigits > most_bytes_) return;
    try {
        write_file_atomically(path_of(kind, made_from), std::string(content) + sha256(content));
    } catch (const InputError&) {
        return;
    }
    make_room();
}

void ContentStore::make_room() const {
    std::vector<Entry> entries = stored_in(folder_);
    std::uint64_t total = 0;
    for (const Entry& entry : entries) total += entry.bytes;
    if (total <= most_bytes_) return;
    std::ranges::sort(entries, {}, &Entry::used);
    const auto kept = static_cast<std::uint64_t>(kKeptShare * static_cast<double>(most_bytes_));
    for (const Entry& entry : entries) {
        if (total <= kept) break;
        std::error_code error;
        std::filesystem::remove(entry.path, error);
        total -= entry.bytes;
    }
}

}  // namespace selvedge::sim

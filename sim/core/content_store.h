#pragma once
// A store on disk for what is slow to make, such as bodies and their distance fields. Each entry is named by the hash
// of what it is made from, so it is never out of date. Any number of processes may use one store at a time, also over a
// network file system: entries appear whole, and what is read is checked against its own hash.
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace selvedge::sim {

class ContentStore {
 public:
    // Entries made by another `maker`, such as another build of the program, are not found. When the store grows beyond
    // most_bytes, the entries that were used longest ago go. Throws InputError if the folder cannot be made. One that
    // can only be read is used as it is.
    ContentStore(std::filesystem::path folder, std::string maker, std::uint64_t most_bytes);

    // What was kept under the kind (a word) and the text that says what it is made from; nullopt if there is none, or
    // if it is broken.
    std::optional<std::string> find(std::string_view kind, std::string_view made_from) const;

    // If it cannot be written, for example on a full disk, it is not kept.
    void keep(std::string_view kind, std::string_view made_from, std::string_view content) const;

    const std::filesystem::path& folder() const { return folder_; }

 private:
    std::filesystem::path path_of(std::string_view kind, std::string_view made_from) const;
    void make_room() const;

    std::filesystem::path folder_;
    std::string maker_;
    std::uint64_t most_bytes_;
};

// What make() gives, with the same bits whether it is made or found in the store; what is new is kept there. store:
// null for none. from_bytes() gives nullopt for bytes that are broken.
template <class Make, class ToBytes, class FromBytes>
auto find_or_make(const ContentStore* store, std::string_view kind, std::string_view made_from, const Make& make,
                  const ToBytes& to_bytes, const FromBytes& from_bytes) -> decltype(make()) {
    if (store == nullptr) return make();
    if (const std::optional<std::string> bytes = store->find(kind, made_from)) {
        if (auto found = from_bytes(*bytes)) return *std::move(found);
    }
    auto made = make();
    store->keep(kind, made_from, to_bytes(made));
    return made;
}

}  // namespace selvedge::sim

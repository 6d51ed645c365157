#pragma once
// Files that are written in parts and appear whole: until commit() there is only a temporary file in the same folder.
// It has no name where the file system has such files (O_TMPFILE), else a random one that nobody else had (O_EXCL). So
// nobody can have laid a link there, and a program that is killed leaves nothing, or a file that a later one removes.
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace selvedge::sim {

enum class TemporaryName {
    None,    // if the file system can
    Random,  // for another program that writes the file, see temporary(); or for what a killed program leaves to be
             // read
};

// write_file_atomically() (sim/core/file.h) in parts. All functions throw InputError that names `path` if the file
// cannot be written. A link stays, and its target is written, also if that is missing. A file that is replaced keeps
// its permissions, and its owner and group if the system lets us: what a group that cannot be kept could do is not
// allowed to the new one. A new file has the permissions of the umask.
class AtomicFile {
 public:
    // Also removes temporary files that killed programs of the same user left in the folder more than a minute ago.
    explicit AtomicFile(const std::filesystem::path& path, TemporaryName name = TemporaryName::None);
    ~AtomicFile() = default;  // without commit(): deletes the temporary file
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::uint64_t size() const { return size_; }                                // bytes written so far by append()
    const std::filesystem::path& temporary() const { return temporary_.path; }  // empty: it has no name

    void append(std::string_view content);
    void overwrite(std::uint64_t offset, std::string_view content);  // pre: these bytes have been written
    void commit();                                                   // once, last

 private:
    // Closed and deleted also if the constructor throws.
    struct Temporary {
        Temporary() = default;
        ~Temporary();
        Temporary(const Temporary&) = delete;
        Temporary& operator=(const Temporary&) = delete;

        int fd = -1;
        std::filesystem::path path = {};
    };

    void open_temporary(TemporaryName name);
    void take_rights_of_old();
    void give_name();
    void write_at(std::uint64_t offset, std::string_view content);

    std::filesystem::path path_;
    std::filesystem::path target_;  // behind links
    Temporary temporary_;
    std::uint64_t size_ = 0;
};

// Whether a file of that name, without its folder, is one that an AtomicFile has not completed.
bool is_temporary_name(std::string_view name);

// Throws InputError that names both numbers if the file system of `path` has fewer than that many bytes free.
void require_free_space(const std::filesystem::path& path, std::uint64_t bytes);

// "1.2 GB", "340 kB": three digits at most, powers of 1000.
std::string bytes_text(std::uint64_t bytes);

}  // namespace selvedge::sim

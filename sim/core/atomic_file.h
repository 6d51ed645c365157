#pragma once
// Files that are written in parts and appear whole: until commit() there is only a temporary file in the same folder.
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace selvedge::sim {

// write_file_atomically() (sim/core/file.h) in parts. All functions throw InputError that names `path` if the file
// cannot be written.
class AtomicFile {
 public:
    explicit AtomicFile(const std::filesystem::path& path);
    ~AtomicFile();  // without commit(): deletes the temporary file
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::uint64_t size() const { return size_; }  // bytes written so far

    void append(std::string_view content);
    void overwrite(std::uint64_t offset, std::string_view content);  // pre: these bytes have been written
    void commit();                                                   // once, last

 private:
    void write_at(std::uint64_t offset, std::string_view content);

    std::filesystem::path path_;
    std::filesystem::path target_;  // behind links
    std::filesystem::path temporary_;
    int fd_ = -1;
    std::uint64_t size_ = 0;
};

// Throws InputError that names both figures if the file system of `path` has fewer than that many bytes free.
void require_free_space(const std::filesystem::path& path, std::uint64_t bytes);

// "1.2 GB", "340 kB": three digits at most, powers of 1000.
std::string bytes_text(std::uint64_t bytes);

}  // namespace selvedge::sim

#pragma once
// Locks of files, by which processes keep out of each other's way, on this machine or, over NFS, on another. The system
// gives a lock free when its process ends, however that comes about; its child processes do not have it (POSIX record
// locks). A process that closes another handle of a file that it has locked loses the lock.
#include <filesystem>

namespace selvedge::batch {

// Has the lock of a file while it exists, unless another process has it. On a file system without locks, no process
// keeps another out.
class FileLock {
 public:
    // Makes the file if it is not there. Throws InputError if it cannot be written.
    explicit FileLock(const std::filesystem::path& path);
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

    bool is_taken() const { return is_taken_; }  // by another process

 private:
    int fd_;
    bool is_taken_;
};

// Whether another process has the lock of the file. False if there is no such file, or if it cannot be written.
bool is_locked_by_another(const std::filesystem::path& path);

}  // namespace selvedge::batch

#pragma once
// Journals on disk: one file per running editor, locked as long as it lives, so that the next one finds what a kill
// left. A line is with the system before its change is seen, and on the disk within a second.
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace selvedge::app {

struct StoredJournal {
    std::filesystem::path path;
    std::string text;
    double age_seconds = 0;  // since its last line
};

class JournalStore {
 public:
    // Makes the folder where it is missing. Throws InputError when that cannot be.
    explicit JournalStore(std::filesystem::path folder);
    ~JournalStore();  // leaves the journal; see end()
    JournalStore(const JournalStore&) = delete;
    JournalStore& operator=(const JournalStore&) = delete;

    // A new journal takes the place of the present one, whole. Throws InputError.
    void begin(std::string_view head);

    // Adds a line. Nothing without a journal; what cannot be written is passed over, and said once by `problem`.
    void note(std::string_view line);

    // Nothing is left to recover.
    void end();

    // Empty: all lines were written.
    std::string problem() const { return problem_; }

    // Those of editors that no longer run, newest first.
    std::vector<StoredJournal> left() const;
    static void discard(const std::filesystem::path& path);

 private:
    void sync_now_and_then();
    void close_file();

    std::filesystem::path folder_;
    std::filesystem::path path_;
    int file_ = -1;
    std::string problem_;

    std::mutex mutex_;  // guards file_ and what follows
    std::condition_variable wake_;
    bool is_dirty_ = false;
    bool is_ending_ = false;
    std::thread syncing_;
};

// Where programs keep what they need to go on, not what they are set to: $XDG_STATE_HOME/selvedge, or
// ~/.local/state/selvedge.
std::filesystem::path state_folder();

}  // namespace selvedge::app

#pragma once
// Journals on disk: one file per running editor, locked while the editor runs, so that the next editor finds the
// journals of crashed ones. A line is written to the operating system before note() returns, and synced to disk within
// a second. What a full disk does not take is kept in memory and tried again with every line and every second, so that
// the journal never has a hole.
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
    // Creates the folder if it is missing. Throws InputError if that fails.
    explicit JournalStore(std::filesystem::path folder);
    ~JournalStore();  // keeps the journal file; see end()
    JournalStore(const JournalStore&) = delete;
    JournalStore& operator=(const JournalStore&) = delete;

    // Replaces the current journal by a new one that begins with these lines, atomically. Throws InputError.
    void begin(std::string_view lines);

    // Appends a line; does nothing without a journal. Write errors are not thrown: see problem().
    void note(std::string_view line);

    // Deletes the journal: nothing is left to recover.
    void end();

    // Why lines are missing on disk now; empty: all are there. After a failed sync it stays until a journal begins.
    std::string problem() const;

    // Journals of editors that no longer run, newest first.
    std::vector<StoredJournal> left() const;
    static void discard(const std::filesystem::path& path);

    // Gives a journal that cannot be read another name, under which it is not left any more, and returns it. Throws
    // InputError.
    static std::filesystem::path set_aside(const std::filesystem::path& path);

 private:
    void sync_periodically();
    void write_pending();  // pre: mutex_ is held
    void close_file();

    std::filesystem::path folder_;
    std::filesystem::path path_;
    int file_ = -1;

    mutable std::mutex mutex_;  // guards file_ and the members below
    std::string pending_;       // not written yet
    std::string write_problem_;
    std::string sync_problem_;
    std::condition_variable wake_;
    bool is_dirty_ = false;
    bool is_ending_ = false;
    std::thread syncing_;
};

// The folder for state that persists between runs (not settings): $XDG_STATE_HOME/selvedge, or ~/.local/state/selvedge,
// where ~ is $HOME or else the user's home as the system knows it. None: the user has no home.
std::optional<std::filesystem::path> state_folder();

}  // namespace selvedge::app

// Journals on disk: those of running editors are not touched, those of killed ones are found.
#include "app/journal_store.h"

#include <gtest/gtest.h>
#include <pwd.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <set>
#include <utility>

#include "sim/core/error.h"
#include "tests/app/run_program.h"

namespace selvedge::app {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_of(const fs::path& folder) {
    return {fs::directory_iterator(folder), fs::directory_iterator()};
}

void write(const fs::path& file, const std::string& text) {
    std::ofstream(file) << text;
}

// A process that holds a journal with two lines until it is killed.
class OtherEditor {
 public:
    explicit OtherEditor(const fs::path& folder) {
        int ready[2] = {-1, -1};
        if (pipe(ready) != 0) return;
        pid_ = fork();
        if (pid_ == 0) {
            JournalStore store(folder);
            store.begin("head");
            store.note("line");
            if (::write(ready[1], "!", 1) == 1) pause();
            _exit(0);
        }
        char sign = 0;
        is_ready_ = read(ready[0], &sign, 1) == 1;
        close(ready[0]);
        close(ready[1]);
    }
    ~OtherEditor() { kill_hard(); }
    OtherEditor(const OtherEditor&) = delete;
    OtherEditor& operator=(const OtherEditor&) = delete;

    bool is_ready() const { return is_ready_; }
    void kill_hard() {
        if (pid_ < 0) return;
        kill(pid_, SIGKILL);
        waitpid(pid_, nullptr, 0);
        pid_ = -1;
    }

 private:
    pid_t pid_ = -1;
    bool is_ready_ = false;
};

TEST(JournalStore, a_living_editors_journal_is_its_own_and_a_killed_ones_is_found_whole) {
    const ScratchFolder folder;
    const JournalStore store(folder.path());
    OtherEditor other(folder.path());
    ASSERT_TRUE(other.is_ready());
    EXPECT_TRUE(store.left().empty()) << "it lives";
    EXPECT_EQ(files_of(folder.path()).size(), 1U);
    other.kill_hard();
    const std::vector<StoredJournal> left = store.left();
    ASSERT_EQ(left.size(), 1U);
    EXPECT_EQ(left[0].text, "head\nline\n");
    JournalStore::discard(left[0].path);
    EXPECT_TRUE(store.left().empty());
    EXPECT_TRUE(files_of(folder.path()).empty());
}

TEST(JournalStore, lines_are_with_the_system_as_soon_as_they_are_noted) {
    const ScratchFolder folder;
    JournalStore store(folder.path());
    store.note("before a journal begins");
    EXPECT_TRUE(files_of(folder.path()).empty());
    store.begin("head");
    store.note("first");
    ASSERT_EQ(files_of(folder.path()).size(), 1U);
    EXPECT_EQ(content_of(files_of(folder.path())[0]), "head\nfirst\n");
    EXPECT_EQ(store.problem(), "");
}

TEST(JournalStore, a_journal_that_begins_takes_the_place_of_the_one_before) {
    const ScratchFolder folder;
    JournalStore store(folder.path());
    store.begin("old");
    store.note("line");
    store.begin("new");
    ASSERT_EQ(files_of(folder.path()).size(), 1U) << "nothing half written lies beside it";
    EXPECT_EQ(content_of(files_of(folder.path())[0]), "new\n");
    store.end();
    EXPECT_TRUE(files_of(folder.path()).empty());
    store.note("after the end");
    EXPECT_TRUE(files_of(folder.path()).empty());
}

TEST(JournalStore, one_that_cannot_begin_anew_goes_on_as_it_was) {
    const ScratchFolder folder;
    JournalStore store(folder.path());
    store.begin("old");
    const fs::path journal = files_of(folder.path()).at(0);
    fs::create_directory(journal.string() + ".new");  // blocks the path of the new journal
    EXPECT_THROW(store.begin("new"), sim::InputError);
    store.note("line");
    EXPECT_EQ(content_of(journal), "old\nline\n");
}

TEST(JournalStore, what_is_left_comes_newest_first_and_half_written_ones_are_passed_over) {
    const ScratchFolder folder;
    write(folder / "1.journal", "older");
    write(folder / "2.journal", "newer\n{\"torn");
    write(folder / "3.journal.new", "never finished");
    fs::create_directory(folder / "4.journal");
    fs::last_write_time(folder / "1.journal", fs::file_time_type::clock::now() - std::chrono::hours(2));
    const std::vector<StoredJournal> left = JournalStore(folder.path()).left();
    ASSERT_EQ(left.size(), 2U);
    EXPECT_EQ(left[0].text, "newer\n{\"torn");
    EXPECT_EQ(left[1].text, "older");
    EXPECT_GT(left[1].age_seconds, 7000);
}

TEST(JournalStore, a_damaged_journal_is_kept_under_another_name) {
    const ScratchFolder folder;
    JournalStore store(folder.path());
    std::set<fs::path> kept;
    for (const char* text : {"damaged", "damaged too"}) {
        write(folder / "1.journal", text);
        const fs::path file = JournalStore::set_aside(folder / "1.journal");
        EXPECT_EQ(content_of(file), text);
        kept.insert(file);
        EXPECT_TRUE(store.left().empty());
    }
    EXPECT_EQ(kept.size(), 2U) << "each has a name of its own";
    EXPECT_THROW(JournalStore::set_aside(folder / "1.journal"), sim::InputError) << "there is none";
}

// Files of this process may grow no further until it is destroyed, as on a full disk.
class FullDisk {
 public:
    explicit FullDisk(rlim_t bytes) {
        std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

 private:
    rlimit before_{};
};

TEST(JournalStore, tells_of_a_full_disk_and_writes_all_lines_when_there_is_room_again) {
    const ScratchFolder folder;
    JournalStore store(folder.path());
    store.begin("head");
    const fs::path journal = files_of(folder.path()).at(0);
    {
        const FullDisk disk(7);
        store.note("first");
        EXPECT_NE(store.problem().find(journal.string()), std::string::npos) << store.problem();
        store.note("second");
        EXPECT_THROW(store.begin(std::string(100, 'n')), sim::InputError);
        EXPECT_NE(store.problem(), "");
        EXPECT_EQ(content_of(journal).rfind("head\nfi", 0), 0U) << "the old one goes on";
    }
    store.note("third");
    EXPECT_EQ(store.problem(), "");
    EXPECT_EQ(content_of(journal), "head\nfirst\nsecond\nthird\n");
    EXPECT_EQ(files_of(folder.path()).size(), 1U);
}

TEST(JournalStore, is_not_led_elsewhere_by_a_link) {
    const ScratchFolder folder;
    write(folder / "mine", "mine");
    JournalStore store(folder / "journals");
    store.begin("head");
    const fs::path journal = files_of(folder / "journals").at(0);
    fs::create_symlink(folder / "mine", journal.string() + ".new");
    store.begin("new");
    EXPECT_EQ(content_of(folder / "mine"), "mine");
    EXPECT_EQ(content_of(journal), "new\n");
    EXPECT_FALSE(fs::is_symlink(journal));
    EXPECT_EQ(fs::status(folder / "journals").permissions(), fs::perms::owner_all) << "nobody else reads it";
}

TEST(JournalStore, removes_what_a_killed_editor_had_only_begun) {
    const ScratchFolder folder;
    for (const char* name : {"1.journal.new", "2.journal.new", "3.journal.new.txt"}) write(folder / name, "half");
    for (const char* name : {"1.journal.new", "3.journal.new.txt"})
        fs::last_write_time(folder / name, fs::file_time_type::clock::now() - std::chrono::hours(2));
    EXPECT_TRUE(JournalStore(folder.path()).left().empty());
    EXPECT_FALSE(fs::exists(folder / "1.journal.new"));
    EXPECT_TRUE(fs::exists(folder / "2.journal.new")) << "it may be another editor's in a moment";
    EXPECT_TRUE(fs::exists(folder / "3.journal.new.txt"));
}

class StateFolder : public testing::Test {
 protected:
    StateFolder() {
        for (const char* name : {"HOME", "XDG_STATE_HOME"}) {
            const char* value = std::getenv(name);
            before_.emplace_back(name, value == nullptr ? std::optional<std::string>() : value);
            unsetenv(name);
        }
    }
    ~StateFolder() override {
        for (const auto& [name, value] : before_)
            value ? setenv(name.c_str(), value->c_str(), 1) : unsetenv(name.c_str());
    }

 private:
    std::vector<std::pair<std::string, std::optional<std::string>>> before_;
};

TEST_F(StateFolder, is_the_users_own_also_without_a_home_in_the_environment) {
    const passwd* user = getpwuid(geteuid());
    if (user == nullptr) {
        EXPECT_FALSE(state_folder());
    } else {
        EXPECT_EQ(state_folder(), fs::path(user->pw_dir) / ".local/state/selvedge");
    }
    setenv("HOME", "/somebody", 1);
    EXPECT_EQ(state_folder(), "/somebody/.local/state/selvedge");
    setenv("XDG_STATE_HOME", "/state", 1);
    EXPECT_EQ(state_folder(), "/state/selvedge");
}

TEST(JournalStore, a_folder_that_cannot_be_made_is_an_input_error) {
    const ScratchFolder folder;
    write(folder / "file", "");
    EXPECT_THROW(JournalStore(fs::path(folder / "file") / "journals"), sim::InputError);
}

}  // namespace
}  // namespace selvedge::app

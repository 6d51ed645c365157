// main() of all test programs. Beyond GoogleTest's: a crash names the test that it happened in, and each test that is
// skipped goes with its reason to the file that SELVEDGE_TEST_SKIPS names, of which scripts/test makes a summary. A
// test that is skipped for want of test data fails where SELVEDGE_TEST_DATA is set.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <array>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

std::array<char, 512> running{};  // the name of the test that runs, for a signal handler

[[maybe_unused]] void name_crash(int signal) {
    constexpr char kCrashed[] = "crashed in the test ";
    // Nothing can be done about a message that cannot be written.
    [[maybe_unused]] ssize_t written = write(STDERR_FILENO, kCrashed, sizeof kCrashed - 1);
    written = write(STDERR_FILENO, running.data(), std::strlen(running.data()));
    written = write(STDERR_FILENO, "\n", 1);
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

std::string name_of(const testing::TestInfo& test) {
    return std::string(test.test_suite_name()) + "." + test.name();
}

// A record is one write to a file opened for appending, so that programs that run at once do not mix theirs.
void record_skip(const std::string& name, std::string reason) {
    const char* path = std::getenv("SELVEDGE_TEST_SKIPS");
    if (path == nullptr) return;
    for (char& c : reason)
        if (c == '\n') c = ' ';
    const std::string line = name + ": " + reason + "\n";
    const int file = open(path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
    if (file < 0 || write(file, line.data(), line.size()) != static_cast<ssize_t>(line.size()))
        std::fprintf(stderr, "cannot record a skipped test in %s\n", path);
    if (file >= 0) close(file);
}

class Observer : public testing::EmptyTestEventListener {
 public:
    bool skipped_in_spite_of_data() const { return skipped_in_spite_of_data_; }

 private:
    void OnTestStart(const testing::TestInfo& test) override {
        const std::string name = name_of(test);
        running.fill('\0');
        std::strncpy(running.data(), name.c_str(), running.size() - 1);
    }

    void OnTestEnd(const testing::TestInfo& test) override {
        running.fill('\0');
        const testing::TestResult& result = *test.result();
        if (!result.Skipped()) return;
        std::string reason;
        for (int i = 0; i < result.total_part_count(); ++i)
            if (result.GetTestPartResult(i).skipped()) reason += result.GetTestPartResult(i).message();
        record_skip(name_of(test), reason);
        if (std::getenv("SELVEDGE_TEST_DATA") == nullptr || reason.find("SELVEDGE_TEST_DATA") == std::string::npos)
            return;
        std::fprintf(stderr, "%s is skipped in spite of SELVEDGE_TEST_DATA: %s\n", name_of(test).c_str(),
                     reason.c_str());
        skipped_in_spite_of_data_ = true;
    }

    bool skipped_in_spite_of_data_ = false;
};

}  // namespace

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    auto* observer = new Observer;  // GoogleTest deletes it
    testing::UnitTest::GetInstance()->listeners().Append(observer);
#ifndef SELVEDGE_SANITIZED  // sanitizers have handlers of their own, which say more
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) std::signal(signal, name_crash);
#endif
    const int failed = RUN_ALL_TESTS();
    return failed != 0 || observer->skipped_in_spite_of_data() ? 1 : 0;
}

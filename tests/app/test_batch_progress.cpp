// Progress of a batch that is written into a file.
#include "app/batch_progress.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace selvedge::app {
namespace {

std::string shown_of_batch(const ProgressBarOptions& options, const std::vector<std::size_t>& done) {
    char* text = nullptr;
    std::size_t size = 0;
    std::FILE* stream = open_memstream(&text, &size);
    {
        BatchProgress progress(options, stream);
        for (const std::size_t count : done) progress.show({.jobs = 4, .done = count, .dressed = count});
    }
    std::fclose(stream);
    std::string result(text, size);
    std::free(text);
    return result;
}

TEST(BatchProgress, ends_with_the_last_state_where_there_is_no_terminal) {
    EXPECT_EQ(shown_of_batch({}, {0, 1, 2, 4, 4}), "[--------------------] 0 of 4\n[####################] 4 of 4\n");
    EXPECT_EQ(shown_of_batch({}, {0, 1, 2}), "[--------------------] 0 of 4\n[##########----------] 2 of 4\n");
    EXPECT_EQ(shown_of_batch({}, {}), "");
    EXPECT_EQ(shown_of_batch({.is_quiet = true}, {0, 4}), "");
}

TEST(BatchProgress, leaves_the_line_of_a_terminal_clean) {
    const std::string text = shown_of_batch({.is_terminal = true}, {0, 2});
    EXPECT_TRUE(text.ends_with("\r\033[K")) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos);
}

}  // namespace
}  // namespace selvedge::app

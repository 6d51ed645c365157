// The list of recent files.
#include "app/editor_services.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/app/run_program.h"

namespace selvedge::app {
namespace {

using Files = std::vector<std::string>;

TEST(RecentFiles, come_newest_first_each_once_and_only_while_they_are_there) {
    const ScratchFolder folder;
    const RecentFiles recent(folder / "recent.json");
    EXPECT_TRUE(recent.list().empty());
    for (const char* name : {"a", "b"}) std::ofstream(folder / name) << name;
    recent.add(folder / "a");
    recent.add(folder / "b");
    recent.add((folder.path() / "." / "a").string());
    EXPECT_EQ(recent.list(), (Files{folder / "a", folder / "b"}));
    std::filesystem::remove(folder / "a");
    EXPECT_EQ(recent.list(), Files{folder / "b"});
}

TEST(RecentFiles, are_a_dozen_at_most) {
    const ScratchFolder folder;
    const RecentFiles recent(folder / "recent.json");
    for (int i = 0; i < 15; ++i) {
        std::ofstream(folder / std::to_string(i)) << i;
        recent.add(folder / std::to_string(i));
    }
    EXPECT_EQ(recent.list().size(), 12U);
    EXPECT_EQ(recent.list().front(), folder / "14");
}

TEST(RecentFiles, a_list_that_is_none_is_an_empty_one_and_is_written_anew) {
    const ScratchFolder folder;
    const RecentFiles recent(folder / "recent.json");
    std::ofstream(folder / "shirt") << "";
    for (const char* text : {"", "[1, 2]", "{\"a\": [", "null"}) {
        std::ofstream(folder / "recent.json") << text;
        EXPECT_TRUE(recent.list().empty()) << text;
        recent.add(folder / "shirt");
        EXPECT_EQ(recent.list(), Files{folder / "shirt"}) << text;
    }
}

TEST(RecentFiles, what_cannot_be_written_is_forgotten) {
    const ScratchFolder folder;
    const RecentFiles recent(folder.path() / "no" / "such" / "recent.json");
    EXPECT_NO_THROW(recent.add("shirt"));
    EXPECT_TRUE(recent.list().empty());
}

}  // namespace
}  // namespace selvedge::app

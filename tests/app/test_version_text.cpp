// What --version says of the build, and how the build finds out.
#include "app/version_text.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/app/run_program.h"
#include "tests/support/checkout.h"

namespace selvedge::app {
namespace {

TEST(VersionText, tells_the_commit_and_that_there_is_none) {
    const Build built{.commit = "d5a9ef47a0b1", .compiler = "GNU 12.2.0", .type = "Release"};
    EXPECT_NE(version_text(built).find("\ncommit d5a9ef47a0b1; GNU 12.2.0, Release\n"), std::string::npos);
    const Build unpacked{.commit = "", .compiler = "GNU 12.2.0", .type = "Release"};
    EXPECT_NE(version_text(unpacked).find("\ncommit unknown: not built from git; GNU 12.2.0"), std::string::npos);
}

// A folder that is a checkout of its own, whatever this one is.
class WriteBuild : public testing::Test {
 protected:
    // Of the source that cmake/write_build.cmake writes.
    std::string written_of(const std::string& source) const {
        const ProgramResult result =
            run_command("cmake -DOUTPUT='" + folder_ / "build.cpp" + "' -DSOURCE='" + source +
                        "' -DTYPE=Release '-DCOMPILER=GNU 12' -P '" + source_folder() + "/cmake/write_build.cmake'");
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return content_of(folder_ / "build.cpp");
    }
    void in_checkout(const std::string& command) const {
        const ProgramResult result =
            run_command("mkdir -p '" + checkout_ + "' && cd '" + checkout_ + "' && " + command);
        ASSERT_EQ(result.exit_code, 0) << result.err;
    }
    void commit() const {
        in_checkout(
            "echo one > file && git init -q . && git add file && "
            "git -c user.name=a -c user.email=a@b commit -q -m one");
    }

    ScratchFolder folder_;
    std::string checkout_ = folder_ / "checkout";
};

TEST_F(WriteBuild, names_the_commit_and_that_files_differ_from_it) {
    commit();
    const std::string hash = run_command("git -C '" + checkout_ + "' rev-parse --short=12 HEAD").out.substr(0, 12);
    EXPECT_NE(written_of(checkout_).find("\"" + hash + "\""), std::string::npos);
    in_checkout("echo two > file");
    EXPECT_NE(written_of(checkout_).find("\"" + hash + ", changed\""), std::string::npos);
}

TEST_F(WriteBuild, names_no_commit_of_a_checkout_around_it) {
    commit();
    in_checkout("mkdir unpacked");
    EXPECT_NE(written_of(checkout_ + "/unpacked").find(".commit = \"\""), std::string::npos);
}

TEST_F(WriteBuild, keeps_the_source_when_its_content_is_the_same) {
    commit();
    written_of(checkout_);
    const std::string time = "stat -c %y '" + folder_ / "build.cpp" + "'", before = run_command(time).out;
    written_of(checkout_);
    EXPECT_EQ(run_command(time).out, before);
}

}  // namespace
}  // namespace selvedge::app

// scripts/install_dependencies on other operating systems.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/app/run_program.h"
#include "tests/support/checkout.h"

namespace selvedge::app {
namespace {

const std::string kScript = "bash '" + source_folder() + "/scripts/install_dependencies'";

// A system whose packages the script does not know.
std::string on_another_system(const ScratchFolder& folder, const std::string& command) {
    std::ofstream(folder / "os-release") << "ID=fedora\nVERSION_ID=40\n";
    return "SELVEDGE_OS_RELEASE='" + folder / "os-release" + "' " + command;
}

std::string with_a_bare_shell(const ScratchFolder& folder) {
    const auto result = run_command("ln -s \"$(command -v bash)\" '" + folder / "bash" + "'");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return "PATH='" + folder.path().string() + "' ";
}

TEST(InstallDependencies, names_all_missing_packages_on_one_line_when_it_does_not_know_the_system) {
    const ScratchFolder folder;
    const ProgramResult result = run_command(on_another_system(folder, with_a_bare_shell(folder) + kScript + " test"));
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(count_lines(result.err), 1) << result.err;
    EXPECT_EQ(result.out, "");
    for (const char* package : {"g++", "cmake", "ninja-build", "libcgal-dev", "libassimp-dev", "libgtest-dev"})
        EXPECT_NE(result.err.find(package), std::string::npos) << package << " in " << result.err;
}

TEST(InstallDependencies, goes_on_elsewhere_when_all_is_found) {
    const ScratchFolder folder;
    const ProgramResult result = run_command(on_another_system(folder, kScript + " test"));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out + result.err, "");
}

// With a dpkg-query that knows no package, and nothing that could install one.
TEST(InstallDependencies, names_the_packages_to_install_when_it_knows_the_system_but_may_not_install) {
    for (const char* system : {"ID=debian\nVERSION_ID=\"12\"\n", "ID=debian\nVERSION_ID=\"13\"\n",
                               "ID=ubuntu\nID_LIKE=debian\nVERSION_ID=\"24.04\"\n"}) {
        const ScratchFolder folder;
        std::ofstream(folder / "os-release") << system;
        const ProgramResult result = run_command("SELVEDGE_OS_RELEASE='" + folder / "os-release" + "' " +
                                                 with_a_bare_shell(folder) + kScript + " build");
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_EQ(result.err.find("neither Debian"), std::string::npos) << result.err;
        EXPECT_NE((result.out + result.err).find("libcgal-dev"), std::string::npos) << result.out + result.err;
    }
}

TEST(InstallDependencies, refuses_a_purpose_it_does_not_know) {
    const ProgramResult result = run_command(kScript + " cake");
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(count_lines(result.err), 1) << result.err;
}

}  // namespace
}  // namespace selvedge::app

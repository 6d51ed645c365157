// Contents are named by the hash that other programs compute.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "sim/core/error.h"
#include "sim/core/sha256.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim::test {
namespace {

TEST(Sha256, gives_the_published_values) {  // FIPS 180-4, examples
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256(std::string(1'000'000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, of_a_file_is_that_of_its_content) {
    const TemporaryFolder folder;
    const std::string content(200'001, 'x');
    std::ofstream(folder / "x.bin") << content;
    std::ofstream(folder / "empty.bin");
    EXPECT_EQ(sha256_of_file(folder / "x.bin"), sha256(content));
    EXPECT_EQ(sha256_of_file(folder / "empty.bin"), sha256(""));
}

TEST(Sha256, of_what_is_no_file_is_refused) {
    const TemporaryFolder folder;
    EXPECT_THROW(sha256_of_file(folder / "none"), InputError);
    EXPECT_THROW(sha256_of_file(folder / ""), InputError);
}

}  // namespace
}  // namespace selvedge::sim::test

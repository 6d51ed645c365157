#pragma once
// Texts that must stay the same from one version to the next, in tests/reference.
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include "tests/support/checkout.h"

namespace selvedge {

// Fails if the text differs from tests/reference/NAME. If SELVEDGE_RENEW_GOLDENS is this name, writes the file.
inline void expect_reference(const std::string& name, const std::string& text) {
    const std::string path = source_folder() + "/tests/reference/" + name;
    const char* renewed = std::getenv("SELVEDGE_RENEW_GOLDENS");
    if (renewed && name == renewed) std::ofstream(path, std::ios::binary) << text;
    std::ifstream file(path, std::ios::binary);
    ASSERT_TRUE(file) << path;
    std::stringstream reference;
    reference << file.rdbuf();
    std::string expected, found;
    std::stringstream now(text);
    for (int line = 1; std::getline(reference, expected); ++line) {
        ASSERT_TRUE(std::getline(now, found)) << path << " has more than " << line - 1 << " lines";
        ASSERT_EQ(found, expected) << path << ":" << line;
    }
    EXPECT_EQ(text, reference.str()) << path;
}

}  // namespace selvedge

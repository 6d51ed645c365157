#pragma once
// Compares results with the golden references in tests/golden/reference. If a picture fails, NAME.out.png and
// NAME.diff.png are written to the test's working directory. How to renew references: tests/golden/README.md.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "render/image/image.h"

namespace selvedge::test {

// Path of a reference; `file` includes the extension.
std::filesystem::path reference_path(const std::string& file);

// Whether SELVEDGE_RENEW_GOLDENS, a comma-separated list of names, contains this name.
bool is_to_be_renewed(const std::string& name);

// Fails if the reference is missing or the pictures are not alike (render/image/image.h). If SELVEDGE_RENEW_GOLDENS
// contains the name, writes the picture as the new reference instead.
testing::AssertionResult matches_golden(const render::Image& image, const std::string& name);

// The same with the rule for pictures of a drape (tests/golden/fourier.h).
testing::AssertionResult matches_golden_by_blocks(const render::Image& image, const std::string& name);

// The stored reference. Throws InputError if it is missing.
render::Image read_reference(const std::string& name);

}  // namespace selvedge::test

#pragma once
// Golden references: tests/golden/reference/NAME against what comes out now. A failing picture leaves NAME.out.png and
// NAME.diff.png in the folder the test runs in. How to renew them: tests/golden/README.md.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "render/image/compare.h"
#include "render/image/image.h"

namespace selvedge::test {

// Where a reference is kept; `file` with its extension.
std::filesystem::path reference_path(const std::string& file);

// Whether SELVEDGE_RENEW_GOLDENS, names with commas between, holds this one.
bool is_to_be_renewed(const std::string& name);

// Fails when the reference is missing or the pictures are not alike (render/image/compare.h). Where
// SELVEDGE_RENEW_GOLDENS names the picture, it becomes the reference instead.
testing::AssertionResult matches_golden(const render::Image& image, const std::string& name);

// The same by the rule for pictures of a drape (tests/golden/blocks.h).
testing::AssertionResult matches_golden_by_blocks(const render::Image& image, const std::string& name);

// The reference as it is stored. Throws InputError when it is missing.
render::Image read_reference(const std::string& name);

}  // namespace selvedge::test

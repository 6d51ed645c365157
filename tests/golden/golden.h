#pragma once
// Golden pictures: tests/golden/reference/NAME.png against what is drawn now. A failing one leaves NAME.out.png and
// NAME.diff.png in the folder the test runs in. How to renew them: tests/golden/README.md.
#include <gtest/gtest.h>

#include <string>

#include "render/image/compare.h"
#include "render/image/image.h"

namespace selvedge {

// Fails when the reference is missing or the pictures are not alike (render/image/compare.h). Where
// SELVEDGE_RENEW_GOLDENS names the picture, it becomes the reference instead.
testing::AssertionResult matches_golden(const Image& image, const std::string& name);

// The reference as it is stored. Throws InputError when it is missing.
Image read_reference(const std::string& name);

}  // namespace selvedge

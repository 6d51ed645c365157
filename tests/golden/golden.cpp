#include "tests/golden/golden.h"

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "render/image/png.h"

namespace selvedge {
namespace {

std::filesystem::path reference_path(const std::string& name) {
    return std::filesystem::path(SELVEDGE_SOURCE_DIR) / "tests/golden/reference" / (name + ".png");
}

// SELVEDGE_RENEW_GOLDENS holds names with commas between.
bool is_to_be_renewed(const std::string& name) {
    const char* names = std::getenv("SELVEDGE_RENEW_GOLDENS");
    std::istringstream list(names == nullptr ? "" : names);
    for (std::string listed; std::getline(list, listed, ',');) {
        if (listed == name) return true;
    }
    return false;
}

}  // namespace

Image read_reference(const std::string& name) {
    return read_png(reference_path(name));
}

testing::AssertionResult matches_golden(const Image& image, const std::string& name) {
    if (is_to_be_renewed(name)) {
        write_png(reference_path(name), image);
        return testing::AssertionSuccess() << "renewed: look at " << reference_path(name);
    }
    const std::string out = name + ".out.png", diff = name + ".diff.png";
    if (!std::filesystem::exists(reference_path(name))) {
        write_png(out, image);
        return testing::AssertionFailure() << "no reference " << reference_path(name) << "; wrote " << out;
    }
    const Image reference = read_reference(name);
    const Comparison comparison = compare(reference, image);
    if (is_alike(comparison)) return testing::AssertionSuccess();
    write_png(out, image);
    write_png(diff, difference_picture(reference, image));
    return testing::AssertionFailure() << name << ": " << describe(comparison) << "; wrote " << out << " and " << diff;
}

}  // namespace selvedge

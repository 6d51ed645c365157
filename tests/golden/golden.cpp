#include "tests/golden/golden.h"

#include <cstdlib>
#include <functional>
#include <optional>
#include <sstream>

#include "render/image/image.h"
#include "tests/golden/fourier.h"

namespace selvedge::test {
namespace {

// Compares reference and picture: a description of what is wrong, or nullopt if they are alike.
using Judge = std::function<std::optional<std::string>(const render::Image&, const render::Image&)>;

testing::AssertionResult matches(const render::Image& image, const std::string& name, const Judge& judge) {
    const std::filesystem::path path = reference_path(name + ".png");
    if (is_to_be_renewed(name)) {
        write_png(path, image);
        return testing::AssertionSuccess() << "renewed: look at " << path;
    }
    const std::string out = name + ".out.png", diff = name + ".diff.png";
    if (!std::filesystem::exists(path)) {
        write_png(out, image);
        return testing::AssertionFailure() << "no reference " << path << "; wrote " << out;
    }
    const render::Image reference = render::read_png(path);
    const std::optional<std::string> problem = judge(reference, image);
    if (!problem) return testing::AssertionSuccess();
    write_png(out, image);
    write_png(diff, difference_picture(reference, image));
    return testing::AssertionFailure() << name << ": " << *problem << "; wrote " << out << " and " << diff;
}

}  // namespace

std::filesystem::path reference_path(const std::string& file) {
    return std::filesystem::path(SELVEDGE_SOURCE_DIR) / "tests/golden/reference" / file;
}

bool is_to_be_renewed(const std::string& name) {
    const char* names = std::getenv("SELVEDGE_RENEW_GOLDENS");
    std::istringstream list(names == nullptr ? "" : names);
    for (std::string listed; std::getline(list, listed, ',');) {
        if (listed == name) return true;
    }
    return false;
}

render::Image read_reference(const std::string& name) {
    return render::read_png(reference_path(name + ".png"));
}

testing::AssertionResult matches_golden(const render::Image& image, const std::string& name) {
    return matches(image, name,
                   [](const render::Image& reference, const render::Image& now) -> std::optional<std::string> {
                       const render::Comparison comparison = compare(reference, now);
                       if (is_alike(comparison)) return std::nullopt;
                       return describe(comparison);
                   });
}

testing::AssertionResult matches_golden_by_blocks(const render::Image& image, const std::string& name) {
    return matches(image, name,
                   [](const render::Image& reference, const render::Image& now) -> std::optional<std::string> {
                       const BlockComparison comparison = compare_blocks(reference, now);
                       if (is_alike(comparison)) return std::nullopt;
                       return describe(comparison);
                   });
}

}  // namespace selvedge::test

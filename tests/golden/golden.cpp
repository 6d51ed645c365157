#include "tests/golden/golden.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <optional>
#include <sstream>

#include "render/image/image.h"
#include "tests/support/checkout.h"

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
    return std::filesystem::path(source_folder()) / "tests/golden/reference" / file;
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

namespace {

using Mean = std::array<double, 4>;

// Mean of the block with the upper left corner (left, top); blocks at the picture's border may be smaller.
Mean mean_colour(const render::Image& image, int left, int top, int side_px) {
    Mean sum{};
    int count = 0;
    for (int y = top; y < std::min(top + side_px, image.height_px); ++y) {
        for (int x = left; x < std::min(left + side_px, image.width_px); ++x, ++count) {
            for (std::size_t channel = 0; channel < sum.size(); ++channel) sum[channel] += image.at(x, y)[channel];
        }
    }
    for (double& channel : sum) channel /= count;
    return sum;
}

double largest_step(const Mean& a, const Mean& b) {
    double step = 0;
    for (std::size_t i = 0; i < a.size(); ++i) step = std::max(step, std::abs(a[i] - b[i]));
    return step;
}

}  // namespace

BlockComparison compare_blocks(const render::Image& a, const render::Image& b, const BlockOptions& options) {
    BlockComparison result;
    result.has_same_size = a.width_px == b.width_px && a.height_px == b.height_px;
    if (!result.has_same_size) return result;
    for (int top = 0; top < a.height_px; top += options.side_px) {
        for (int left = 0; left < a.width_px; left += options.side_px) {
            const double step =
                largest_step(mean_colour(a, left, top, options.side_px), mean_colour(b, left, top, options.side_px));
            ++result.blocks;
            result.beyond += step > options.tolerance ? 1 : 0;
            result.largest_step = std::max(result.largest_step, step);
        }
    }
    return result;
}

bool is_alike(const BlockComparison& comparison, const BlockOptions& options) {
    return comparison.has_same_size && comparison.share_beyond() <= options.share_beyond;
}

std::string describe(const BlockComparison& comparison, const BlockOptions& options) {
    if (!comparison.has_same_size) return "the sizes differ";
    std::ostringstream text;
    text.precision(3);
    text << 100 * comparison.share_beyond() << " % of the blocks differ by more than " << options.tolerance
         << "/255, at most " << comparison.largest_step << "/255";
    return text.str();
}

}  // namespace selvedge::test

#include "editor/workspace/sett_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "render/scene/colour.h"

namespace selvedge::editor {
namespace {

using Linear = std::array<double, 3>;  // linear RGB, 0..1

constexpr double kMinPxPerThread = 2;  // px per thread, minimum for drawing single threads
constexpr int kSamples = 3;            // samples per px and direction, if threads are drawn

std::vector<Linear> in_light(const std::vector<sim::Rgb8>& colours) {
    std::vector<Linear> light;
    light.reserve(colours.size());
    for (const sim::Rgb8& c : colours)
        light.push_back({render::to_linear(c[0]), render::to_linear(c[1]), render::to_linear(c[2])});
    return light;
}

render::Rgba8 to_pixel(const Linear& light) {
    return {render::to_srgb(light[0]), render::to_srgb(light[1]), render::to_srgb(light[2]), 255};
}

// The mean colour per pixel across the threads: a box filter over the threads that the pixel covers.
std::vector<Linear> means(const std::vector<Linear>& threads, int count_px, double px_per_thread) {
    std::vector<Linear> result(static_cast<std::size_t>(count_px), Linear{});
    for (int px = 0; px < count_px; ++px) {
        const double from = px / px_per_thread, to = (px + 1) / px_per_thread;
        Linear& sum = result[static_cast<std::size_t>(px)];
        for (auto thread = static_cast<long>(std::floor(from)); static_cast<double>(thread) < to; ++thread) {
            const auto at = static_cast<double>(thread);
            const double share = (std::min(to, at + 1) - std::max(from, at)) / (to - from);
            const Linear& colour = threads[static_cast<std::size_t>(thread) % threads.size()];
            for (std::size_t i = 0; i < 3; ++i) sum[i] += share * colour[i];
        }
    }
    return result;
}

double warp_direction_share(sim::Weave weave) {
    return weave == sim::Weave::Twill31 ? 0.75 : 0.5;
}

render::Image mean_picture(const sim::Sett& sett, const SettPictureOptions& options, double px_per_thread) {
    const auto warp = means(in_light(thread_colours(sett)), options.width_px, px_per_thread);
    const auto weft = means(in_light(weft_thread_colours(sett)), options.height_px, px_per_thread);
    const double share = warp_direction_share(sett.weave);
    render::Image image(options.width_px, options.height_px);
    for (int y = 0; y < options.height_px; ++y) {
        for (int x = 0; x < options.width_px; ++x) {
            const Linear& a = warp[static_cast<std::size_t>(x)];
            const Linear& b = weft[static_cast<std::size_t>(y)];
            Linear mixed{};
            for (std::size_t i = 0; i < 3; ++i) mixed[i] = share * a[i] + (1 - share) * b[i];
            image.at(x, y) = to_pixel(mixed);
        }
    }
    return image;
}

// Brightness factor across a thread's width, 0.62 to 1.08: a round profile lit from above, dark at the edges.
double roundness(double across) {
    const double from_middle = 2 * across - 1;
    return 0.62 + 0.46 * std::sqrt(std::max(0.0, 1 - from_middle * from_middle));
}

// Brightness factor along a crossing, 0.7 to 1: darker near an end where the thread passes under the next one.
double dip(double along, bool goes_under_before, bool goes_under_after) {
    constexpr double kLength = 0.3, kDepth = 0.3;
    double light = 1;
    if (goes_under_before && along < kLength) light -= kDepth * (1 - along / kLength);
    if (goes_under_after && along > 1 - kLength) light -= kDepth * (1 - (1 - along) / kLength);
    return light;
}

class WovenCloth {
 public:
    explicit WovenCloth(const sim::Sett& sett)
        : weave_(sett.weave), warp_(in_light(thread_colours(sett))), weft_(in_light(weft_thread_colours(sett))) {}

    // Colour at a position given in threads from the upper left.
    Linear at(double x, double y) const {
        const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
        const bool is_warp = is_warp_on_top(weave_, i, j);
        const double across = is_warp ? x - i : y - j, along = is_warp ? y - j : x - i;
        const bool before = is_warp ? !is_warp_on_top(weave_, i, j - 1) : is_warp_on_top(weave_, i - 1, j);
        const bool after = is_warp ? !is_warp_on_top(weave_, i, j + 1) : is_warp_on_top(weave_, i + 1, j);
        const double light = roundness(across) * dip(along, before, after);
        const std::vector<Linear>& threads = is_warp ? warp_ : weft_;
        Linear colour = threads[static_cast<std::size_t>(is_warp ? i : j) % threads.size()];
        for (double& channel : colour) channel *= light;
        return colour;
    }

 private:
    sim::Weave weave_;
    std::vector<Linear> warp_;
    std::vector<Linear> weft_;
};

render::Image thread_picture(const sim::Sett& sett, const SettPictureOptions& options, double px_per_thread) {
    const WovenCloth cloth(sett);
    render::Image image(options.width_px, options.height_px);
    for (int y = 0; y < options.height_px; ++y) {
        for (int x = 0; x < options.width_px; ++x) {
            Linear sum{};
            for (int sample = 0; sample < kSamples * kSamples; ++sample) {
                const double u = options.first_thread + (x + (sample % kSamples + 0.5) / kSamples) / px_per_thread;
                const double v = options.first_thread + (y + (sample / kSamples + 0.5) / kSamples) / px_per_thread;
                const Linear colour = cloth.at(u, v);
                for (std::size_t i = 0; i < 3; ++i) sum[i] += colour[i] / (kSamples * kSamples);
            }
            image.at(x, y) = to_pixel(sum);
        }
    }
    return image;
}

}  // namespace

bool is_warp_on_top(sim::Weave weave, int warp_thread, int weft_thread) {
    const auto turn = [&](int period) { return ((warp_thread + weft_thread) % period + period) % period; };
    switch (weave) {
        case sim::Weave::Plain:
            return turn(2) == 0;
        case sim::Weave::Twill22:
            return turn(4) < 2;
        case sim::Weave::Twill31:
            break;
    }
    return turn(4) < 3;
}

render::Image sett_picture(const sim::Sett& sett, const SettPictureOptions& options) {
    const double px_per_thread = options.px_per_thread > 0
                                     ? options.px_per_thread
                                     : std::min(options.width_px, options.height_px) / double(thread_count(sett));
    return px_per_thread < kMinPxPerThread ? mean_picture(sett, options, px_per_thread)
                                           : thread_picture(sett, options, px_per_thread);
}

}  // namespace selvedge::editor

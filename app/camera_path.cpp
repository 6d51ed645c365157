#include "app/camera_path.h"

#include <algorithm>
#include <cmath>

#include "sim/body/skin.h"

namespace selvedge::app {
namespace {

// The middle of a body over the floor, m.
Vec3f place_of(const std::vector<Vec3f>& body) {
    const Vec3f middle = sim::box_around(body).center();
    return {middle.x(), 0, middle.z()};
}

}  // namespace

CameraPath::CameraPath(const sim::Animation& animation) {
    constexpr double kInterval = 0.1;  // s
    constexpr double kMostKeys = 5000;
    const sim::BodyTimeline& timeline = animation.timeline();
    const sim::SkinnedSurface surface(animation.body());
    interval_ = std::max(kInterval, timeline.seconds() / kMostKeys);
    std::vector<Vec3f> places, x;
    for (int key = 0; (key - 1) * interval_ < timeline.seconds(); ++key) {
        surface.positions(animation.body(), timeline.pose(std::min(key * interval_, timeline.seconds())), x);
        places.push_back(place_of(x));
    }
    const int window = static_cast<int>(std::lround(kAhead / interval_));
    const int last = static_cast<int>(places.size()) - 1;
    for (int key = 0; key <= last; ++key) {
        const int reach = std::min({window, key, last - key});  // as far back as ahead: at both ends it is at rest
        Vec3f sum = Vec3f::Zero();
        for (int k = key - reach; k <= key + reach; ++k) sum += places[static_cast<std::size_t>(k)];
        keys_.push_back(sum / static_cast<float>(2 * reach + 1));
    }
}

Vec3f CameraPath::at(double seconds) const {
    const double key = std::clamp(seconds / interval_, 0.0, static_cast<double>(keys_.size() - 1));
    const auto before = static_cast<std::size_t>(key);
    const std::size_t behind = std::min(before + 1, keys_.size() - 1);
    return keys_[before] + static_cast<float>(key - static_cast<double>(before)) * (keys_[behind] - keys_[before]);
}

}  // namespace selvedge::app

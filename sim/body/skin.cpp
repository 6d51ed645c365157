#include "sim/body/skin.h"

#include <cstddef>
#include <cstring>

#include "sim/core/assert.h"

namespace selvedge::sim {
namespace {

const Vec3d& bind_of(const Body& body, std::size_t v) {
    return body.bind.empty() ? body.x[v] : body.bind[v];
}

// Four floats in one register of any x86-64.
using Four [[gnu::vector_size(16)]] = float;

Four load(const float* from) {
    Four four;
    std::memcpy(&four, from, sizeof four);
    return four;
}

}  // namespace

SkinnedSurface::SkinnedSurface(const Body& body) : count_(body.x.size()) {
    SELVEDGE_ASSERT(body.skin.size() == body.x.size());
    for (std::size_t v = 0; v < count_; ++v) {
        const SkinWeights& skin = body.skin[v];
        const Vec3d& x = bind_of(body, v);
        std::size_t used = 0;
        for (const float weight : skin.weights) used += weight > 0 ? 1 : 0;
        SELVEDGE_ASSERT(used > 0);
        Group& group = groups_[used - 1];
        group.vertices.push_back(std::uint32_t(v));
        for (std::size_t k = 0; k < 4; ++k) {
            if (!(skin.weights[k] > 0)) continue;
            const double w = double(skin.weights[k]);
            group.influences.push_back({float(w * x.x()), float(w * x.y()), float(w * x.z()), float(w)});
            group.bones.push_back(skin.bones[k]);
        }
    }
}

template <int bones_each>
void SkinnedSurface::pose_group(const Group& group, const float* columns, float* x) {
    const Influence* influence = group.influences.data();
    const std::uint16_t* bone = group.bones.data();
    for (const std::uint32_t vertex : group.vertices) {
        Four sum{};
        for (int k = 0; k < bones_each; ++k, ++influence, ++bone) {
            const float* column = columns + std::size_t{16} * *bone;
            sum += load(column) * influence->wx + load(column + 4) * influence->wy + load(column + 8) * influence->wz +
                   load(column + 12) * influence->w;
        }
        std::memcpy(x + std::size_t{3} * vertex, &sum, 3 * sizeof(float));
    }
}

void SkinnedSurface::positions(const Body& body, const Pose& pose, std::vector<Vec3f>& x) const {
    const std::vector<Eigen::Affine3d> transforms = skin_transforms(body, pose);
    std::vector<Eigen::Matrix4f> columns;  // four floats per column
    columns.reserve(transforms.size());
    for (const Eigen::Affine3d& transform : transforms) columns.push_back(transform.matrix().cast<float>());
    x.resize(count_);
    if (count_ == 0) return;
    const float* from = columns.front().data();
    pose_group<1>(groups_[0], from, x.front().data());
    pose_group<2>(groups_[1], from, x.front().data());
    pose_group<3>(groups_[2], from, x.front().data());
    pose_group<4>(groups_[3], from, x.front().data());
}

std::vector<Vec3d> skin(const Body& body, const Pose& pose) {
    SELVEDGE_ASSERT(body.skin.size() == body.x.size());
    const std::vector<Eigen::Affine3d> transforms = skin_transforms(body, pose);
    std::vector<Vec3d> x(body.x.size(), Vec3d::Zero());
    for (std::size_t v = 0; v < x.size(); ++v)
        for (std::size_t k = 0; k < 4; ++k)
            if (body.skin[v].weights[k] > 0)
                x[v] += double(body.skin[v].weights[k]) * (transforms[body.skin[v].bones[k]] * bind_of(body, v));
    return x;
}

std::vector<Vec3f> velocities(const std::vector<Vec3f>& before, const std::vector<Vec3f>& after, float seconds) {
    SELVEDGE_ASSERT(before.size() == after.size() && seconds > 0);
    std::vector<Vec3f> v(before.size());
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = (after[i] - before[i]) / seconds;
    return v;
}

}  // namespace selvedge::sim

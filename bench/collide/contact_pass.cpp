#include "bench/collide/contact_pass.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "bench/support/timing.h"

namespace selvedge::bench {
namespace {

const sim::Contact kSkipped{std::numeric_limits<float>::infinity(), Vec3f::Zero()};

sim::Contact answer_in(const sim::ContactBlock& block, std::size_t lane) {
    return {block.distance[lane], {block.nx[lane], block.ny[lane], block.nz[lane]}};
}

// For each point, the position and the slack distance of its last query.
struct Known {
    explicit Known(std::size_t count) : x(count), y(count), z(count), slack(count, -1.0F) {}

    std::vector<float> x, y, z;  // position at the last query, m
    std::vector<float> slack;    // m, distance it may move before a contact is possible

    bool spares(std::size_t i, const sim::ContactBlock& block, std::size_t lane) const {
        const float dx = block.x[lane] - x[i];
        const float dy = block.y[lane] - y[i];
        const float dz = block.z[lane] - z[i];
        const float free = std::max(slack[i], 0.0F);
        return dx * dx + dy * dy + dz * dz < free * free;
    }
    void learn(std::size_t i, const sim::ContactBlock& block, std::size_t lane, float surely_free) {
        x[i] = block.x[lane];
        y[i] = block.y[lane];
        z[i] = block.z[lane];
        slack[i] = block.distance[lane] - surely_free;
    }
};

class Pass {
 public:
    Pass(const QueryPoints& points, const sim::Collider& collider, float offset)
        : points_(points),
          collider_(collider),
          offset_(offset),
          known_(points.count()),
          work_(points.count() / sim::kContactLanes + 1),
          active_(points.count() + 1) {}

    void step_one_by_one(const std::vector<sim::ContactBlock>& asked, sim::Contact* answers) {
        for (std::size_t i = 0; i < points_.count(); ++i) {
            const sim::Contact contact = collider_.contact(asked[i / sim::kContactLanes].point(i % sim::kContactLanes));
            keep(contact);
            if (answers) answers[i] = contact;
        }
    }

    void step_in_blocks(const std::vector<sim::ContactBlock>& asked, sim::Contact* answers) {
        for (std::size_t b = 0; b < asked.size(); ++b) {
            work_[b].x = asked[b].x;
            work_[b].y = asked[b].y;
            work_[b].z = asked[b].z;
        }
        collider_.contacts({work_.data(), asked.size()}, offset_);
        keep(work_);
        if (!answers) return;
        for (std::size_t i = 0; i < points_.count(); ++i)
            answers[i] = answer_in(work_[i / sim::kContactLanes], i % sim::kContactLanes);
    }

    // Returns the number of points that were queried.
    std::size_t step_with_slack(const std::vector<sim::ContactBlock>& asked, sim::Contact* answers) {
        const std::size_t count = list_active(asked);
        for (std::size_t k = 0; k < count; ++k) {
            const Vec3f p = asked[active_[k] / sim::kContactLanes].point(active_[k] % sim::kContactLanes);
            work_[k / sim::kContactLanes].set_point(k % sim::kContactLanes, p);
        }
        collider_.contacts({work_.data(), (count + sim::kContactLanes - 1) / sim::kContactLanes}, offset_);
        const float surely_free = offset_ + collider_.max_error();
        for (std::size_t k = 0; k < count; ++k)
            known_.learn(active_[k], work_[k / sim::kContactLanes], k % sim::kContactLanes, surely_free);
        if (!answers) return count;
        std::fill_n(answers, points_.count(), kSkipped);
        for (std::size_t k = 0; k < count; ++k)
            answers[active_[k]] = answer_in(work_[k / sim::kContactLanes], k % sim::kContactLanes);
        return count;
    }

 private:
    std::size_t list_active(const std::vector<sim::ContactBlock>& asked) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < points_.count(); ++i) {
            active_[count] = std::uint32_t(i);
            count += !known_.spares(i, asked[i / sim::kContactLanes], i % sim::kContactLanes);
        }
        return count;
    }

    const QueryPoints& points_;
    const sim::Collider& collider_;
    float offset_;
    Known known_;
    std::vector<sim::ContactBlock> work_;
    std::vector<std::uint32_t> active_;
};

}  // namespace

QueryPoints::QueryPoints(const ClothPoints& points) {
    for (const std::vector<Vec3f>& x : points.x) {
        count_ = x.size();
        std::vector<sim::ContactBlock>& blocks =
            steps_.emplace_back((x.size() + sim::kContactLanes - 1) / sim::kContactLanes);
        for (std::size_t i = 0; i < blocks.size() * sim::kContactLanes; ++i) {
            blocks[i / sim::kContactLanes].set_point(i % sim::kContactLanes, x[std::min(i, x.size() - 1)]);
        }
    }
}

QueryReport run_queries(const QueryPoints& points, const sim::Collider& collider, ContactWay way, float offset,
                        std::vector<sim::Contact>* answers) {
    Pass pass(points, collider, offset);
    if (answers) answers->assign(points.steps().size() * points.count(), kSkipped);
    QueryReport report;
    for (std::size_t step = 0; step < points.steps().size(); ++step) {
        sim::Contact* to = answers ? &(*answers)[step * points.count()] : nullptr;
        const std::vector<sim::ContactBlock>& asked = points.steps()[step];
        report.queries += double(points.count());
        report.asked += double(points.count());
        switch (way) {
            case ContactWay::OneByOne:
                pass.step_one_by_one(asked, to);
                break;
            case ContactWay::InBlocks:
                pass.step_in_blocks(asked, to);
                break;
            case ContactWay::WithSlack:
                report.asked -= double(points.count() - pass.step_with_slack(asked, to));
                break;
        }
    }
    return report;
}

namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();
constexpr float kThickness = 0.03F;  // m, of the layer over the surface in which the points stay

struct MovingPoint {
    Vec3f x;
    Vec3f v = Vec3f::Zero();        // m/s
    Vec3f outward = Vec3f::Zero();  // surface normal at the closest point of its last position
    float fall = 0;                 // m/s, speed towards the body
};

// Uniform numbers in 0..1 and approximately normal ones (a sum of 12), the same on every machine.
struct Random {
    std::mt19937 engine;
    float share() { return float(double(engine()) / 4294967296.0); }
    float normal() {
        float sum = -6;
        for (int i = 0; i < 12; ++i) sum += share();
        return sum;
    }
    Vec3f normals() {
        const float x = normal();
        const float y = normal();
        return {x, y, normal()};
    }
};

// Whether a point is about on the trunk, the upper arms or the thighs.
bool is_clad(const sim::SurfaceBvh& surface, const Vec3f& p) {
    const float stature = surface.high().y() - surface.low().y();
    const float height = (p.y() - surface.low().y()) / stature;
    return height > 0.3F && height < 0.82F && std::abs(p.x()) < 0.2F * stature;
}

// By triangle: cumulative double area of the clad triangles up to it.
std::vector<double> summed_areas(const sim::SurfaceBvh& surface) {
    std::vector<double> sums;
    double sum = 0;
    const auto x = surface.points();
    for (const auto& [a, b, c] : surface.triangles()) {
        if (is_clad(surface, (x[a] + x[b] + x[c]) / 3)) sum += double((x[b] - x[a]).cross(x[c] - x[a]).norm());
        sums.push_back(sum);
    }
    return sums;
}

Vec3f random_point_over(const sim::SurfaceBvh& surface, const std::vector<double>& areas, Random& random) {
    const double at = double(random.share()) * areas.back();
    const auto t = std::size_t(std::upper_bound(areas.begin(), areas.end(), at) - areas.begin());
    const auto [a, b, c] = surface.triangles()[std::min(t, areas.size() - 1)];
    const auto x = surface.points();
    const float u = std::sqrt(random.share());
    const float w = random.share();
    const Vec3f on = x[a] * (1 - u) + x[b] * (u * (1 - w)) + x[c] * (u * w);
    return on + (x[b] - x[a]).cross(x[c] - x[a]).stableNormalized() * (kThickness * random.share());
}

// Morton code of a point on a grid of 4 mm cells. Sorted by it, points near in space are near in the list.
std::uint32_t morton_code(const Vec3f& p) {
    std::uint32_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto cell = std::uint32_t(std::clamp((p[axis] + 2) * 250, 0.0F, 1023.0F));
        for (unsigned bit = 0; bit < 10; ++bit) code |= (cell >> bit & 1U) << (3 * bit + unsigned(axis));
    }
    return code;
}

std::vector<MovingPoint> start(const sim::SurfaceBvh& surface, const ClothPointOptions& options, Random& random) {
    const std::vector<double> areas = summed_areas(surface);
    std::vector<MovingPoint> points;
    while (points.size() < std::size_t(options.points)) {
        const Vec3f p = random_point_over(surface, areas, random);
        const sim::ClosestPoint closest = *surface.closest(p, kFar);
        if (closest.distance >= 0) points.push_back({.x = p, .outward = closest.normal});
    }
    std::sort(points.begin(), points.end(),
              [](const MovingPoint& a, const MovingPoint& b) { return morton_code(a.x) < morton_code(b.x); });
    for (MovingPoint& point : points) {
        point.v = random.normals() * (options.speed / std::sqrt(3.0F));
        point.fall = random.share() < 0.3F ? 1.5F * options.speed : 0.0F;
    }
    return points;
}

void move(MovingPoint& point, const ClothPointOptions& options, Random& random) {
    constexpr float kKept = 0.98F;
    const float fresh = options.speed / std::sqrt(3.0F) * std::sqrt(1 - kKept * kKept);
    point.v = point.v * kKept + random.normals() * fresh;
    point.x += (point.v - point.outward * point.fall) * options.substep;
    if (random.share() < 0.002F) point.x -= point.outward * (0.01F * random.share());
}

// Projects the point to the offset, and reflects its velocity at the outer limit of the layer.
void hold(MovingPoint& point, const sim::ClosestPoint& closest, float offset) {
    point.outward = closest.normal;
    const float outward_speed = point.v.dot(closest.normal);
    const bool is_in = closest.distance < offset;
    if (is_in) point.x = closest.point + closest.normal * offset;
    if (is_in && outward_speed < 0) point.v -= closest.normal * outward_speed;
    if (closest.distance > kThickness && outward_speed > 0) point.v -= closest.normal * (2 * outward_speed);
}

}  // namespace

ClothPoints move_cloth_points(const sim::SurfaceBvh& surface, const ClothPointOptions& options) {
    Random random{std::mt19937(options.seed)};
    std::vector<MovingPoint> points = start(surface, options, random);
    ClothPoints path;
    double touches = 0;
    for (int step = 0; step < options.steps; ++step) {
        path.x.emplace_back();
        path.exact.emplace_back();
        for (MovingPoint& point : points) {
            move(point, options, random);
            const sim::ClosestPoint closest = *surface.closest(point.x, kFar);
            path.x.back().push_back(point.x);
            path.exact.back().push_back(closest);
            touches += closest.distance < options.offset;
            hold(point, closest, options.offset);
        }
    }
    path.in_contact = touches / (double(options.steps) * double(options.points));
    return path;
}

}  // namespace selvedge::bench

#include "bench/collide/collide.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "bench/collide/grid_collider.h"
#include "bench/support/cloth_run.h"
#include "sim/collide/body_collider.h"
#include "sim/core/assert.h"
#include "sim/core/math.h"
#include "sim/core/parallel.h"
#include "sim/core/simd_level.h"
#include "sim/mannequin/mannequin.h"

namespace selvedge::bench {
namespace {

// A structure and the way in which it is queried.
struct Baseline {
    std::string name;
    const sim::Collider* collider = nullptr;
    ContactWay way = ContactWay::OneByOne;
    sim::SimdLevel level = sim::SimdLevel::Avx512;
    std::vector<double> seconds{};
};

// The structures built for one body, and the time to build each.
struct Structures {
    Structures(const sim::Body& body, float offset);

    std::unique_ptr<sim::SurfaceBvh> surface;
    std::unique_ptr<GridCollider> grid;
    std::unique_ptr<BvhCollider> unlimited;
    std::unique_ptr<BvhCollider> near;
    std::unique_ptr<sim::BodyCollider> field;
    double tree_seconds = 0, grid_seconds = 0, field_seconds = 0;
    float reach;
};

constexpr float kSearchReach = 0.01F;  // m, search distance of the grid and of the limited BVH

Structures::Structures(const sim::Body& body, float offset) : reach(offset) {
    const sim::ThreadLimit one(1);
    tree_seconds = time_once([&] { surface = std::make_unique<sim::SurfaceBvh>(body); });
    grid_seconds = time_once([&] { grid = std::make_unique<GridCollider>(*surface, kSearchReach); });
    unlimited = std::make_unique<BvhCollider>(*surface, std::numeric_limits<float>::infinity());
    near = std::make_unique<BvhCollider>(*surface, kSearchReach);
    field_seconds = time_once([&] { field = std::make_unique<sim::BodyCollider>(body); }) - tree_seconds;
}

std::vector<Baseline> baselines_of(const Structures& structures) {
    std::vector<Baseline> baselines{
        {"grid 32^3", structures.grid.get()},
        {"tree", structures.unlimited.get()},
        {"tree, 10 mm", structures.near.get()},
        {"field, one by one", structures.field.get()},
    };
    for (const sim::SimdLevel level : {sim::SimdLevel::Plain, sim::SimdLevel::Avx2, sim::SimdLevel::Avx512}) {
        if (level > sim::simd_level()) continue;
        const std::string name = "field, " + std::string(name_of(level));
        baselines.push_back({name, structures.field.get(), ContactWay::InBlocks, level});
        baselines.push_back({name + ", slack", structures.field.get(), ContactWay::WithSlack, level});
    }
    return baselines;
}

// Errors of the answers for points in contact, that is, nearer than the offset.
struct Errors {
    std::vector<double> distance;  // m
    std::vector<double> angle;     // rad, of the normal
    int missed = 0;                // answered as more than 0.5 mm beyond the offset
    int touching = 0;
};

Errors errors_of(const std::vector<sim::Contact>& answers, const std::vector<sim::ClosestPoint>& exact, float offset) {
    constexpr float kMissed = 0.0005F;
    Errors errors;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        if (exact[i].distance >= offset) continue;
        ++errors.touching;
        errors.missed += answers[i].distance > offset + kMissed;
        if (answers[i].distance >= offset) continue;
        errors.distance.push_back(std::abs(double(answers[i].distance) - double(exact[i].distance)));
        errors.angle.push_back(std::acos(std::clamp(double(answers[i].normal.dot(exact[i].normal)), -1.0, 1.0)));
    }
    return errors;
}

void add_row(Table& table, std::size_t triangles, const Baseline& baseline, const QueryReport& report,
             const Errors& errors) {
    const double queries = report.queries;
    table.add_row({triangles,
                   baseline.name,
                   {1e9 * timing_of(baseline.seconds).median / queries, 1},
                   {1e9 * timing_of(baseline.seconds).least / queries, 1},
                   {100 * report.queried / queries, 1},
                   {1e3 * sim::quantile(errors.distance, 0.99), 3},
                   {1e3 * sim::quantile(errors.distance, 1), 3},
                   {180 / std::numbers::pi * sim::quantile(errors.angle, 0.99), 1},
                   errors.missed,
                   errors.touching});
}

void measure(Table& table, std::size_t triangles, const Structures& structures, const CollideOptions& options) {
    const ClothPoints points = move_cloth_points(*structures.surface, options.points);
    const QueryPoints queried(points);
    std::vector<Baseline> baselines = baselines_of(structures);
    for (int round = 0; round < options.rounds; ++round)
        for (Baseline& baseline : baselines) {
            const sim::SimdLimit limit(baseline.level);
            baseline.seconds.push_back(
                time_once([&] { run_queries(queried, *baseline.collider, baseline.way, options.points.offset); }));
        }
    std::vector<sim::ClosestPoint> exact;
    for (const auto& step : points.exact) exact.insert(exact.end(), step.begin(), step.end());
    for (const Baseline& baseline : baselines) {
        const sim::SimdLimit limit(baseline.level);
        std::vector<sim::Contact> answers;
        const QueryReport report =
            run_queries(queried, *baseline.collider, baseline.way, options.points.offset, &answers);
        add_row(table, triangles, baseline, report, errors_of(answers, exact, options.points.offset));
    }
}

void add_builds(Table& table, std::size_t triangles, const Structures& structures) {
    const auto add = [&](const char* name, double seconds, std::size_t bytes) {
        table.add_row({triangles, name, {1e3 * seconds, 0}, {1e-6 * double(bytes), 1}});
    };
    add("tree", structures.tree_seconds, structures.surface->bytes());
    add("grid 32^3", structures.grid_seconds, structures.grid->bytes());
    add("field", structures.field_seconds, structures.field->field().bytes());
}

std::string note_of(const CollideOptions& options) {
    return std::to_string(options.points.points) + " points over trunk, upper arms and thighs, " +
           std::to_string(options.points.steps) +
           " sub-steps, three in ten nearer than the contact offset of 3 mm; one thread, median and least of " +
           std::to_string(options.rounds) +
           " rounds in turns. asked: share of points that slack did not spare. Errors are those of points that touch; "
           "missed: said to be half a millimetre farther off than the offset.";
}

}  // namespace

std::vector<Table> bench_collide(const CollideOptions& options, const sim::Progress& progress) {
    Table queries{.name = "collide", .title = "Finding what cloth touches", .note = note_of(options)};
    queries.columns = {"body triangles", "structure",    "ns per query",   "least",  "asked %",
                       "error p99 mm",   "error max mm", "normal p99 deg", "missed", "of"};
    Table builds{.name = "collide-build",
                 .title = "What it is found with",
                 .note = "Grid and field are built over the tree and ask it where they know nothing; one thread."};
    builds.columns = {"body triangles", "structure", "build ms", "MB"};
    double done = 0;
    for (const std::size_t triangles : options.triangles) {
        sim::report(progress, "bodies", done++ / double(options.triangles.size()));
        const sim::Body body = dense_body(triangles);
        const Structures structures(body, options.points.offset);
        measure(queries, body.triangles.size(), structures, options);
        add_builds(builds, body.triangles.size(), structures);
    }
    return {queries, builds};
}

namespace {

std::vector<Vec3d> vertex_normals(const sim::Body& body) {
    std::vector<Vec3d> normals(body.x.size(), Vec3d::Zero());
    const auto at = [&](int v) { return body.x[std::size_t(v)]; };
    for (const auto& [a, b, c] : body.triangles)
        for (const int v : {a, b, c}) normals[std::size_t(v)] += (at(b) - at(a)).cross(at(c) - at(a));
    for (Vec3d& normal : normals) normal.stableNormalize();
    return normals;
}

// An edge and its two triangles, each with the corner index where the edge starts in it.
struct SharedEdge {
    double length = 0;
    int low = 0, high = 0;
    std::array<std::size_t, 2> triangle{};
    std::array<std::size_t, 2> corner{};
};

std::vector<SharedEdge> longest_first(const sim::Body& body) {
    struct Side {
        int low, high;
        std::size_t triangle, corner;
    };
    std::vector<Side> sides;
    for (std::size_t t = 0; t < body.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(body.triangles[t][k], body.triangles[t][(k + 1) % 3]);
            sides.push_back({low, high, t, k});
        }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    std::vector<SharedEdge> edges;
    for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
        const Side& a = sides[i];
        const Side& b = sides[i + 1];
        SELVEDGE_ASSERT(a.low == b.low && a.high == b.high);
        const double length = (body.x[std::size_t(a.low)] - body.x[std::size_t(a.high)]).norm();
        edges.push_back({length, a.low, a.high, {a.triangle, b.triangle}, {a.corner, b.corner}});
    }
    std::stable_sort(edges.begin(), edges.end(),
                     [](const SharedEdge& a, const SharedEdge& b) { return a.length > b.length; });
    return edges;
}

// The midpoint of the edge, displaced to follow the curvature given by the end normals. (curved PN triangles, Vlachos
// et al. 2001)
Vec3d bent_middle(const sim::Body& body, const std::vector<Vec3d>& normals, const SharedEdge& edge) {
    const Vec3d& a = body.x[std::size_t(edge.low)];
    const Vec3d& b = body.x[std::size_t(edge.high)];
    const Vec3d& at_a = normals[std::size_t(edge.low)];
    const Vec3d& at_b = normals[std::size_t(edge.high)];
    const Vec3d along = b - a;
    return (a + b) / 2 + (at_a * along.dot(at_a) - at_b * along.dot(at_b)) / 8;
}

// Splits both triangles of the edge in two.
void split(sim::Body& body, const SharedEdge& edge, const Vec3d& middle) {
    const int m = int(body.x.size());
    body.x.push_back(middle);
    for (std::size_t side = 0; side < 2; ++side) {
        std::array<int, 3>& half = body.triangles[edge.triangle[side]];
        std::array<int, 3> other = half;
        half[(edge.corner[side] + 1) % 3] = m;
        other[edge.corner[side]] = m;
        body.triangles.push_back(other);
    }
}

// Splits edges in order of length, up to `triangles` triangles. Skips edges of a triangle that this call has split.
void split_round(sim::Body& body, std::size_t triangles) {
    const std::vector<Vec3d> normals = vertex_normals(body);
    std::vector<bool> is_split(body.triangles.size(), false);
    for (const SharedEdge& edge : longest_first(body)) {
        if (body.triangles.size() + 2 > triangles) return;
        if (is_split[edge.triangle[0]] || is_split[edge.triangle[1]]) continue;
        is_split[edge.triangle[0]] = is_split[edge.triangle[1]] = true;
        split(body, edge, bent_middle(body, normals, edge));
    }
}

}  // namespace

sim::Body dense_body(std::size_t triangles) {
    constexpr std::array<std::size_t, 3> kResolutions{17184, 68736, 274944};
    SELVEDGE_ASSERT(triangles >= kResolutions.front());
    const auto above = std::upper_bound(kResolutions.begin(), kResolutions.end(), triangles);
    sim::Body body = sim::make_mannequin({.subdivisions = int(above - kResolutions.begin())}).body;
    body.bones.clear();
    body.skin.clear();
    while (body.triangles.size() + 2 <= triangles) split_round(body, triangles);
    return body;
}

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
    void store(std::size_t i, const sim::ContactBlock& block, std::size_t lane, float surely_free) {
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

    void step_one_by_one(const std::vector<sim::ContactBlock>& queried, sim::Contact* answers) {
        for (std::size_t i = 0; i < points_.count(); ++i) {
            const sim::Contact contact =
                collider_.contact(queried[i / sim::kContactLanes].point(i % sim::kContactLanes));
            keep(contact);
            if (answers) answers[i] = contact;
        }
    }

    void step_in_blocks(const std::vector<sim::ContactBlock>& queried, sim::Contact* answers) {
        for (std::size_t b = 0; b < queried.size(); ++b) {
            work_[b].x = queried[b].x;
            work_[b].y = queried[b].y;
            work_[b].z = queried[b].z;
        }
        collider_.contacts({work_.data(), queried.size()}, offset_);
        keep(work_);
        if (!answers) return;
        for (std::size_t i = 0; i < points_.count(); ++i)
            answers[i] = answer_in(work_[i / sim::kContactLanes], i % sim::kContactLanes);
    }

    // Returns the number of points that were queried.
    std::size_t step_with_slack(const std::vector<sim::ContactBlock>& queried, sim::Contact* answers) {
        const std::size_t count = list_active(queried);
        for (std::size_t k = 0; k < count; ++k) {
            const Vec3f p = queried[active_[k] / sim::kContactLanes].point(active_[k] % sim::kContactLanes);
            work_[k / sim::kContactLanes].set_point(k % sim::kContactLanes, p);
        }
        collider_.contacts({work_.data(), (count + sim::kContactLanes - 1) / sim::kContactLanes}, offset_);
        const float surely_free = offset_ + collider_.max_error();
        for (std::size_t k = 0; k < count; ++k)
            known_.store(active_[k], work_[k / sim::kContactLanes], k % sim::kContactLanes, surely_free);
        if (!answers) return count;
        std::fill_n(answers, points_.count(), kSkipped);
        for (std::size_t k = 0; k < count; ++k)
            answers[active_[k]] = answer_in(work_[k / sim::kContactLanes], k % sim::kContactLanes);
        return count;
    }

 private:
    std::size_t list_active(const std::vector<sim::ContactBlock>& queried) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < points_.count(); ++i) {
            active_[count] = std::uint32_t(i);
            count += !known_.spares(i, queried[i / sim::kContactLanes], i % sim::kContactLanes);
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
        const std::vector<sim::ContactBlock>& queried = points.steps()[step];
        report.queries += double(points.count());
        report.queried += double(points.count());
        switch (way) {
            case ContactWay::OneByOne:
                pass.step_one_by_one(queried, to);
                break;
            case ContactWay::InBlocks:
                pass.step_in_blocks(queried, to);
                break;
            case ContactWay::WithSlack:
                report.queried -= double(points.count() - pass.step_with_slack(queried, to));
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

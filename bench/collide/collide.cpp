#include "bench/collide/collide.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "bench/collide/contact_pass.h"
#include "bench/collide/grid_collider.h"
#include "bench/support/timing.h"
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
                   {100 * report.asked / queries, 1},
                   {1e3 * sim::quantile(errors.distance, 0.99), 3},
                   {1e3 * sim::quantile(errors.distance, 1), 3},
                   {180 / std::numbers::pi * sim::quantile(errors.angle, 0.99), 1},
                   errors.missed,
                   errors.touching});
}

void measure(Table& table, std::size_t triangles, const Structures& structures, const CollideOptions& options) {
    const ClothPoints points = move_cloth_points(*structures.surface, options.points);
    const QueryPoints asked(points);
    std::vector<Baseline> baselines = baselines_of(structures);
    for (int round = 0; round < options.rounds; ++round)
        for (Baseline& baseline : baselines) {
            const sim::SimdLimit limit(baseline.level);
            baseline.seconds.push_back(
                time_once([&] { run_queries(asked, *baseline.collider, baseline.way, options.points.offset); }));
        }
    std::vector<sim::ClosestPoint> exact;
    for (const auto& step : points.exact) exact.insert(exact.end(), step.begin(), step.end());
    for (const Baseline& baseline : baselines) {
        const sim::SimdLimit limit(baseline.level);
        std::vector<sim::Contact> answers;
        const QueryReport report =
            run_queries(asked, *baseline.collider, baseline.way, options.points.offset, &answers);
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

}  // namespace selvedge::bench

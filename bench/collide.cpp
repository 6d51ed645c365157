#include "bench/collide.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <string>

#include "bench/contact_pass.h"
#include "bench/dense_body.h"
#include "bench/timing.h"
#include "sim/body/body_collider.h"
#include "sim/body/grid_collider.h"
#include "sim/core/parallel.h"
#include "sim/core/quantile.h"
#include "sim/core/simd_level.h"

namespace selvedge {
namespace {

// A structure and a way to ask it.
struct Rival {
    std::string name;
    const Collider* collider = nullptr;
    ContactWay way = ContactWay::OneByOne;
    SimdLevel level = SimdLevel::Avx512;
    std::vector<double> seconds{};
};

// What is built over one body, and what building took.
struct Structures {
    Structures(const Body& body, float offset);

    std::unique_ptr<SurfaceBvh> surface;
    std::unique_ptr<GridCollider> grid;
    std::unique_ptr<BvhCollider> unlimited;
    std::unique_ptr<BvhCollider> near;
    std::unique_ptr<BodyCollider> field;
    double tree_seconds = 0, grid_seconds = 0, field_seconds = 0;
    float reach;
};

constexpr float kSearchReach = 0.01F;  // m, as far as grid and limited tree look

Structures::Structures(const Body& body, float offset) : reach(offset) {
    const ThreadLimit one(1);
    tree_seconds = time_once([&] { surface = std::make_unique<SurfaceBvh>(body); });
    grid_seconds = time_once([&] { grid = std::make_unique<GridCollider>(*surface, kSearchReach); });
    unlimited = std::make_unique<BvhCollider>(*surface, std::numeric_limits<float>::infinity());
    near = std::make_unique<BvhCollider>(*surface, kSearchReach);
    field_seconds = time_once([&] { field = std::make_unique<BodyCollider>(body); }) - tree_seconds;
}

std::vector<Rival> rivals_of(const Structures& structures) {
    std::vector<Rival> rivals{
        {"grid 32^3", structures.grid.get()},
        {"tree", structures.unlimited.get()},
        {"tree, 10 mm", structures.near.get()},
        {"field, one by one", structures.field.get()},
    };
    for (const SimdLevel level : {SimdLevel::Plain, SimdLevel::Avx2, SimdLevel::Avx512}) {
        if (level > simd_level()) continue;
        const std::string name = "field, " + std::string(name_of(level));
        rivals.push_back({name, structures.field.get(), ContactWay::InBlocks, level});
        rivals.push_back({name + ", slack", structures.field.get(), ContactWay::WithSlack, level});
    }
    return rivals;
}

// How far the answers are off where cloth touches: of points nearer than the offset.
struct Errors {
    std::vector<double> distance;  // m
    std::vector<double> angle;     // rad, of the normal
    int missed = 0;                // said to be off by more than half a millimetre
    int touching = 0;
};

Errors errors_of(const std::vector<Contact>& answers, const std::vector<ClosestPoint>& exact, float offset) {
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

void add_row(Table& table, std::size_t triangles, const Rival& rival, const PassReport& report, const Errors& errors) {
    const double queries = report.queries;
    table.add_row({triangles,
                   rival.name,
                   {1e9 * timing_of(rival.seconds).median / queries, 1},
                   {1e9 * timing_of(rival.seconds).least / queries, 1},
                   {100 * report.asked / queries, 1},
                   {1e3 * quantile(errors.distance, 0.99), 3},
                   {1e3 * quantile(errors.distance, 1), 3},
                   {180 / std::numbers::pi * quantile(errors.angle, 0.99), 1},
                   errors.missed,
                   errors.touching});
}

void measure(Table& table, std::size_t triangles, const Structures& structures, const CollideOptions& options) {
    const ClothPoints points = move_cloth_points(*structures.surface, options.points);
    const PassPoints asked(points);
    std::vector<Rival> rivals = rivals_of(structures);
    for (int round = 0; round < options.rounds; ++round)
        for (Rival& rival : rivals) {
            const SimdLimit limit(rival.level);
            rival.seconds.push_back(
                time_once([&] { run_pass(asked, *rival.collider, rival.way, options.points.offset); }));
        }
    std::vector<ClosestPoint> exact;
    for (const auto& step : points.exact) exact.insert(exact.end(), step.begin(), step.end());
    for (const Rival& rival : rivals) {
        const SimdLimit limit(rival.level);
        std::vector<Contact> answers;
        const PassReport report = run_pass(asked, *rival.collider, rival.way, options.points.offset, &answers);
        add_row(table, triangles, rival, report, errors_of(answers, exact, options.points.offset));
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

std::vector<Table> bench_collide(const CollideOptions& options, const Progress& progress) {
    Table queries{.name = "collide", .title = "Finding what cloth touches", .note = note_of(options)};
    queries.columns = {"body triangles", "structure",    "ns per query",   "least",  "asked %",
                       "error p99 mm",   "error max mm", "normal p99 deg", "missed", "of"};
    Table builds{.name = "collide-build",
                 .title = "What it is found with",
                 .note = "Grid and field are built over the tree and ask it where they know nothing; one thread."};
    builds.columns = {"body triangles", "structure", "build ms", "MB"};
    double done = 0;
    for (const std::size_t triangles : options.triangles) {
        report(progress, "bodies", done++ / double(options.triangles.size()));
        const Body body = dense_body(triangles);
        const Structures structures(body, options.points.offset);
        measure(queries, body.triangles.size(), structures, options);
        add_builds(builds, body.triangles.size(), structures);
    }
    return {queries, builds};
}

}  // namespace selvedge

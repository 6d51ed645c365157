#include "bench/thesis/thesis_drop.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "bench/support/cloth_run.h"
#include "bench/support/measured_mesh.h"
#include "bench/thesis/provot_cloth.h"
#include "bench/thesis/thesis.h"
#include "render/marks/show.h"
#include "sim/adaptive/criteria.h"
#include "sim/cloth/contact.h"
#include "sim/cloth/standoff.h"
#include "sim/cloth/step.h"
#include "sim/collide/collider.h"
#include "sim/core/parallel.h"
#include "sim/dress/drape.h"
#include "sim/inspection/report.h"
#include "sim/mesh/square.h"

namespace selvedge::bench {
namespace {

constexpr double kFrameSeconds = 1.0 / 30;
constexpr int kGridSide = 33;
constexpr double kDropSide = 1.0;          // m, of the cloth
constexpr double kBeside = 0.15;           // m, start distance from the centre of a cloth that falls off
constexpr float kSlipperyFriction = 0.2F;  // times the fabric's friction, so that the cloth does fall off
constexpr float kNoFloor = -1000.0F;       // m
constexpr float kNoSamples = 10;           // m, longer than any edge
constexpr int kProvotSubsteps = 4;         // of a step of the mass-spring cloth
constexpr int kDropLevels = 3;

sim::Cloth make_drop_cloth(const ThesisDropOptions& options) {
    sim::GarmentMesh base = sim::make_square(
        {.columns = 4, .rows = 4, .width = kDropSide, .depth = kDropSide, .height = kDropRadius + 0.1});
    for (Vec3d& x : base.x) x += Vec3d(0, 0, options.shift + (options.falls_off ? kBeside : 0.0));
    return make_cloth(base, {sim::find_fabric("cotton_shirting")}, {.max_level = kDropLevels});
}

// The settings of a drape for cloth that falls on a body (DrapeRun).
struct ThesisDropScene {
    sim::Cloth cloth;
    std::unique_ptr<sim::Collider> object;
    sim::StepOptions stepping{};
    sim::AdaptClothOptions adapting{};
    sim::StandoffOptions standoffs{};
    std::optional<ProvotOptions> provot{};  // of the mass-spring cloth
    sim::StepTimes times{};
    ThesisDropRun run{};
};

// A disc that contains the whole cloth.
sim::MinimumLevelDisc everywhere(int level) {
    return {.panel = 0, .centre = Vec2f::Zero(), .radius = 10.0F * static_cast<float>(kDropSide), .level = level};
}

void refine_uniformly(ThesisDropScene& scene, int level) {
    const sim::MinimumLevelDisc disc = everywhere(level);
    adapt_cloth(scene.cloth, *scene.object,
                {.criteria = {.collision = false, .curvature = false, .length = false},
                 .minimum_levels = {&disc, 1},
                 .shortest_edge = 0},
                scene.stepping.contact);
}

// The mass-spring cloth keeps the whole contact offset at its vertices and has no standoffs.
void make_mass_spring(ThesisDropScene& scene) {
    const sim::Fabric& fabric = scene.cloth.material.fabrics.front();
    sim::set_substep(scene.cloth, step_seconds(scene.cloth, scene.stepping) / kProvotSubsteps);
    const double bending = (fabric.bending_warp + fabric.bending_weft) / 2;
    const float finest = static_cast<float>(kDropSide) / (4 << kDropLevels);  // m
    scene.stepping.contact.offset = sim::ContactOptions{}.offset;
    scene.provot = {.substeps = kProvotSubsteps,
                    .spring = stable_spring(static_cast<float>(fabric.area_density), finest, scene.cloth.substep),
                    .bending = static_cast<float>(bending),
                    .damping = static_cast<float>(fabric.damping),
                    .friction = static_cast<float>(fabric.friction) * scene.stepping.contact.friction_scale,
                    .offset = scene.stepping.contact.offset};
}

ThesisDropScene make_scene(const ThesisDropOptions& options) {
    ThesisDropScene scene{.cloth = make_drop_cloth(options), .object = make_drop_object(options.object)};
    const sim::DrapeOptions drape;
    const float usual_offset = scene.stepping.contact.offset;
    scene.stepping.contact.offset = std::min(drape.rest_offset, usual_offset);
    scene.stepping.contact.floor = kNoFloor;
    if (options.falls_off) scene.stepping.contact.friction_scale = kSlipperyFriction;
    scene.standoffs = {.free = std::min(sim::kMaxStandoff, usual_offset - scene.stepping.contact.offset),
                       .lowering = drape.offset_speed * static_cast<float>(kFrameSeconds)};
    if (options.cloth == DropCloth::VerticesOnly) scene.stepping.contact.sample_spacing = kNoSamples;
    if (options.cloth == DropCloth::VerticesOnly) scene.stepping.contact.sampled_edge = kNoSamples;
    scene.adapting.criteria = options.criteria;
    if (options.cloth == DropCloth::MassSpring) make_mass_spring(scene);
    refresh_contacts(scene.cloth, scene.stepping.contact);
    if (options.uniform_level) refine_uniformly(scene, *options.uniform_level);
    if (!scene.provot) free_standoffs(scene.cloth, scene.standoffs);
    return scene;
}

// With a uniform level, this checks every edge and changes nothing.
void adapt_frame(ThesisDropScene& scene, const ThesisDropOptions& options) {
    if (options.uniform_level) {
        sim::NoState none;
        set_uniform_level(scene.cloth.mesh, none, *options.uniform_level);
    } else {
        scene.adapting.diagonal_cost = diagonal_cost(scene.cloth, options.diagonal);
        adapt_cloth(scene.cloth, *scene.object, scene.adapting, scene.stepping.contact);
    }
}

void step_frame(ThesisDropScene& scene) {
    scene.times = {};
    if (!scene.provot) {
        scene.times.collision = time_both([&] { update_standoffs(scene.cloth, *scene.object, scene.standoffs); }).wall;
    }
    scene.stepping.times = &scene.times;
    for (int i = 0; i < kStepsPerFrame; ++i) {
        if (scene.provot) {
            provot_step(scene.cloth, *scene.object, *scene.provot, &scene.times);
        } else {
            step(scene.cloth, *scene.object, scene.stepping);
        }
    }
}

// The least distance of a vertex from the object, m.
double gap_of(const ThesisDropScene& scene) {
    float least = 1000;
    for (const sim::VertexId v : scene.cloth.mesh.leaf_vertices())
        least = std::min(least, scene.object->contact(scene.cloth.x[v.value].head<3>()).distance);
    return static_cast<double>(least);
}

ThesisDropFrame run_frame(ThesisDropScene& scene, const ThesisDropOptions& options) {
    ThesisDropFrame frame;
    frame.gap = gap_of(scene);
    const Duration adaptation = time_both([&] { adapt_frame(scene, options); });
    frame.triangles = scene.cloth.mesh.leaf_triangles().size();
    const Duration steps = time_both([&] { step_frame(scene); });
    frame.wall = {.adaptation = 1e3 * adaptation.wall,
                  .simulation = 1e3 * (steps.wall - scene.times.collision),
                  .collision = 1e3 * scene.times.collision};
    frame.update_cpu = 1e3 * (adaptation.cpu + steps.cpu);
    if (options.painter != nullptr &&
        scene.run.frames.size() % static_cast<std::size_t>(options.frames_per_picture) == 0)
        frame.wall.rendering = 1e3 * time_both([&] { keep(options.painter->draw(scene.cloth, options.object)); }).wall;
    return frame;
}

// Barycentric coordinates of p in a triangle with material coordinates u.
Vec3f barycentric(const std::array<Vec2f, 3>& u, const Vec2f& p) {
    const auto area = [](const Vec2f& a, const Vec2f& b) { return a.x() * b.y() - a.y() * b.x(); };
    const float whole = area(u[1] - u[0], u[2] - u[0]);
    const float b = area(p - u[0], u[2] - u[0]) / whole, c = area(u[1] - u[0], p - u[0]) / whole;
    return {1 - b - c, b, c};
}

// Pre: the material coordinates cover a square of side kDropSide, as those of sim::make_square() do.
std::vector<Vec3f> sample_grid(const sim::Cloth& cloth) {
    std::vector<Vec3f> grid(std::size_t{kGridSide} * kGridSide, Vec3f::Zero());
    Vec2f low = Vec2f::Constant(1e6F);
    for (const sim::LeafTriangle& t : cloth.mesh.leaf_triangles())
        for (const Vec2f& u : t.u) low = low.cwiseMin(u);
    const float spacing = static_cast<float>(kDropSide) / (kGridSide - 1);
    for (const sim::LeafTriangle& t : cloth.mesh.leaf_triangles()) {
        const Vec2f from = (t.u[0].cwiseMin(t.u[1]).cwiseMin(t.u[2]) - low) / spacing;
        const Vec2f to = (t.u[0].cwiseMax(t.u[1]).cwiseMax(t.u[2]) - low) / spacing;
        for (int row = static_cast<int>(std::lround(from.y())); row <= std::lround(to.y()); ++row) {
            for (int column = static_cast<int>(std::lround(from.x())); column <= std::lround(to.x()); ++column) {
                const Vec2f u = low + spacing * Vec2f(static_cast<float>(column), static_cast<float>(row));
                const Vec3f share = barycentric(t.u, u);
                if (share.minCoeff() < -1e-4F) continue;
                Vec3f& x = grid[static_cast<std::size_t>(row * kGridSide + column)];
                x.setZero();
                for (std::size_t k = 0; k < 3; ++k) x += share[static_cast<int>(k)] * cloth.x[t.v[k].value].head<3>();
            }
        }
    }
    return grid;
}

}  // namespace

std::unique_ptr<sim::Collider> make_drop_object(ThesisDropObject object) {
    if (object == ThesisDropObject::Sphere) return std::make_unique<sim::SphereCollider>(Vec3f::Zero(), kDropRadius);
    return std::make_unique<sim::CylinderCollider>(
        sim::CylinderShape{.radius = kDropRadius, .half_length = kDropHalfLength});
}

const char* name_of(ThesisDropObject object) {
    return object == ThesisDropObject::Sphere ? "sphere" : "cylinder";
}

ThesisDropRun run_thesis_drop(const ThesisDropOptions& options) {
    const sim::ThreadLimit one_thread(1);
    ThesisDropScene scene = make_scene(options);
    scene.adapting.transitions = &scene.run.transitions;
    const int frames = static_cast<int>(std::lround(options.seconds / kFrameSeconds));
    for (int i = 0; i < frames; ++i) {
        ThesisDropFrame frame = run_frame(scene, options);
        frame.time = (i + 1) * kFrameSeconds;
        scene.run.frames.push_back(frame);
        if (options.watch) options.watch(scene.cloth, frame.time);
    }
    scene.run.grid = sample_grid(scene.cloth);
    return std::move(scene.run);
}

ThesisDropRun run_thesis_drop_repeatedly(const ThesisDropOptions& options, int runs) {
    ThesisDropRun run = run_thesis_drop(options);
    ThesisDropOptions unpainted = options;
    unpainted.painter = nullptr;
    for (int i = 1; i < runs; ++i) {
        const ThesisDropRun again = run_thesis_drop(unpainted);
        for (std::size_t f = 0; f < run.frames.size(); ++f) {
            ThesisDropFrame &best = run.frames[f], other = again.frames[f];
            best.update_cpu = other.update_cpu = std::min(best.update_cpu, other.update_cpu);
            other.wall.rendering = best.wall.rendering;
            if (other.wall.total_update() < best.wall.total_update()) best = other;
        }
    }
    return run;
}

double mean_distance(const ThesisDropRun& a, const ThesisDropRun& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.grid.size(); ++i) sum += static_cast<double>((a.grid[i] - b.grid[i]).norm());
    return sum / static_cast<double>(a.grid.size());
}

double mean_bend(const ThesisDropRun& run) {
    constexpr int kInner = kGridSide - 2;
    const double spacing = kDropSide / (kGridSide - 1);
    const auto x = [&](int row, int column) { return run.grid[static_cast<std::size_t>(row * kGridSide + column)]; };
    double sum = 0;
    for (int row = 1; row <= kInner; ++row)
        for (int column = 1; column <= kInner; ++column)
            sum += static_cast<double>(
                (x(row - 1, column) + x(row + 1, column) + x(row, column - 1) + x(row, column + 1) - 4 * x(row, column))
                    .norm());
    return sum / (kInner * kInner * spacing * spacing);
}

namespace {

constexpr std::uint32_t kSegments = 48;

// A surface of revolution about the x or y axis. profile: points (position along the axis, radius) from end to end.
render::BodyItem revolve(const std::vector<Vec2f>& profile, bool about_x) {
    render::BodyItem item;
    for (const Vec2f& p : profile) {
        for (std::uint32_t i = 0; i < kSegments; ++i) {
            const float turn = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / kSegments;
            const float c = p.y() * std::cos(turn), s = p.y() * std::sin(turn);
            item.x.emplace_back(about_x ? Vec3f(p.x(), c, s) : Vec3f(s, p.x(), c));
        }
    }
    for (std::uint32_t ring = 0; ring + 1 < profile.size(); ++ring) {
        for (std::uint32_t i = 0; i < kSegments; ++i) {
            const std::uint32_t a = ring * kSegments + i, b = ring * kSegments + (i + 1) % kSegments;
            item.triangles.push_back({a, b, b + kSegments});
            item.triangles.push_back({a, b + kSegments, a + kSegments});
        }
    }
    item.normals = sim::vertex_normals(item.x, item.triangles);
    return item;
}

}  // namespace

render::BodyItem drop_object_item(ThesisDropObject object) {
    if (object == ThesisDropObject::Cylinder)
        return revolve({{-kDropHalfLength, 0.001F},
                        {-kDropHalfLength, 0.999F * kDropRadius},
                        {-0.999F * kDropHalfLength, kDropRadius},
                        {0.999F * kDropHalfLength, kDropRadius},
                        {kDropHalfLength, 0.999F * kDropRadius},
                        {kDropHalfLength, 0.001F}},
                       true);
    std::vector<Vec2f> profile;
    for (int i = 0; i <= 24; ++i) {
        const float angle = std::numbers::pi_v<float> * (static_cast<float>(i) / 24 - 0.5F);
        profile.emplace_back(kDropRadius * std::sin(angle), std::max(1e-4F, kDropRadius * std::cos(angle)));
    }
    return revolve(profile, false);
}

namespace {

// llvmpipe reads this when a context is made.
int with_one_drawing_thread(int side_px) {
    ::setenv("LP_NUM_THREADS", "0", 0);
    return side_px;
}

}  // namespace

DropPainter::DropPainter(int side_px) : side_px_(with_one_drawing_thread(side_px)) {}

render::Image DropPainter::draw(const sim::Cloth& cloth, ThesisDropObject object) {
    render::Scene scene;
    scene.cloths.push_back({.mesh = draw_mesh(cloth, {"cloth"}), .sett = {}, .show = render::ShowMode::Level});
    scene.bodies.push_back(drop_object_item(object));
    scene.camera = {.eye = Vec3f(1.45F, 1.0F, 3.3F), .target = Vec3f(0, -0.16F, 0)};
    scene.light = studio_light(scene.camera);
    scene.has_ground = false;
    render::Image image = renderer_.draw(scene, {.width_px = side_px_, .height_px = side_px_});
    draw_legend(image, render::level_legend(scene.cloths.front().mesh), render::Corner::LowerLeft);
    return image;
}

using sim::Diagonal;

std::function<float(const Diagonal&)> diagonal_cost(const sim::Cloth& cloth, DiagonalChoice choice) {
    switch (choice) {
        case DiagonalChoice::Length:
            return [&x = cloth.x](const Diagonal& d) {
                return (x[d.b.value].head<3>() - x[d.a.value].head<3>()).squaredNorm();
            };
        case DiagonalChoice::RestLength:
            return [](const Diagonal& d) { return (d.u_b - d.u_a).squaredNorm(); };
        case DiagonalChoice::Curvature:
            return
                [&normals = cloth.normals](const Diagonal& d) { return -normals[d.a.value].dot(normals[d.b.value]); };
        case DiagonalChoice::MinimalChange:
            break;
    }
    return {};
}

}  // namespace selvedge::bench

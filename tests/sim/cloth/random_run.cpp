#include "tests/sim/cloth/random_run.h"

#include <algorithm>
#include <cmath>

#include "sim/adaptive/check.h"
#include "sim/cloth/cloth.h"
#include "sim/cloth/curvature_map.h"
#include "sim/cloth/solver_state.h"
#include "sim/cloth/triangle_bending.h"
#include "sim/mesh/square.h"

namespace selvedge::sim::test {
namespace {

constexpr float kRadius = 0.12F;  // m, of the body
constexpr double kGravity = 9.81;

// Upper bound of the energy of warp, weft and shear of each leaf, with the bias added to the strain or not.
double strain_energy(const Cloth& cloth) {
    const Constraints& constraints = cloth.solver->constraints;
    const std::vector<TriangleStrain> strains = measure_strain(cloth);
    const std::span<const LeafTriangle> leaves = cloth.mesh.leaf_triangles();
    double sum = 0;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        const std::uint32_t slot = constraints.stretch.slot_of(leaves[i].triangle);
        const auto& bias = constraints.stretch.blocks[slot / kBlock].bias;
        const auto energy = [&](double value, std::size_t k, double stiffness) {
            const double most = std::abs(value) + std::abs(double(bias[k][slot % kBlock]));
            return 0.5 * material_area(leaves[i].u) * stiffness * most * most;
        };
        const Fabric& fabric = cloth.material.fabrics[leaves[i].panel];
        sum += energy(double(strains[i].warp), 0, fabric.stretch_warp) +
               energy(double(strains[i].weft), 1, fabric.stretch_weft) +
               energy(std::sin(double(strains[i].shear)), 2, fabric.shear);
    }
    return sum;
}

// A strain limit corrects the excess strain `over` within one sub-step, which turns it into velocity: an energy of
// 1/2 m (over length / substep)^2. Returns twice that, because limits are solved one after the other and undo each
// other's corrections.
double taken_back(double over, double mass, double area, float substep) {
    const double speed = std::max(0.0, over) * std::sqrt(2 * area) / double(substep);
    return mass * speed * speed;
}

double limit_energy(const Cloth& cloth, const LimitBlock& block, std::size_t at) {
    if (block.vertices[0][at] / 4 == cloth.mesh.vertex_capacity()) return 0;
    const auto x = [&](std::size_t i) { return cloth.x[block.vertices[i][at] / 4]; };
    const Vec4f e1 = x(1) - x(0), e2 = x(2) - x(0);
    const double warp = double((block.a[0][at] * e1 + block.a[1][at] * e2).norm() - block.longest_warp[at]);
    const double weft = double((block.b[0][at] * e1 + block.b[1][at] * e2).norm() - block.longest_weft[at]);
    const float cross = block.a[0][at] * block.b[1][at] - block.a[1][at] * block.b[0][at];
    const double area = 0.5 / std::abs(double(cross));
    const double mass = area * cloth.material.fabrics.front().area_density;
    return taken_back(warp, mass, area, cloth.substep) + taken_back(weft, mass, area, cloth.substep);
}

// The sum over leaves beyond the fabric's strain limit and over coarse strain limits.
double limit_energy(const Cloth& cloth) {
    const Fabric& fabric = cloth.material.fabrics.front();
    double sum = 0;
    const std::vector<TriangleStrain> strains = measure_strain(cloth);
    for (std::size_t i = 0; i < strains.size(); ++i) {
        const double area = double(material_area(cloth.mesh.leaf_triangles()[i].u));
        for (const float strain : {strains[i].warp, strains[i].weft}) {
            sum += taken_back(double(strain) - fabric.strain_limit, area * fabric.area_density, area, cloth.substep);
        }
    }
    for (const ParentLevel& level : cloth.solver->constraints.parents) {
        for (const LimitBlock& block : level.limits.blocks) {
            for (std::size_t at = 0; at < kBlock; ++at) sum += limit_energy(cloth, block, at);
        }
    }
    return sum;
}

// 1/2 B k^2 with the larger rigidity, times 1.5 because curvatures are averages over neighbours.
double bending_energy(const Cloth& cloth, const LeafTriangle& leaf) {
    const BendSlot slot = bend_slot(cloth, leaf.triangle);
    const Vec3f curvature = curvature_now(cloth, *slot.block, slot.at);
    const Fabric& fabric = cloth.material.fabrics.front();
    return 0.75 * double(material_area(leaf.u)) * std::max(fabric.bending_warp, fabric.bending_weft) *
           double(curvature.squaredNorm());
}

double mass_of(const Cloth& cloth) {
    double sum = 0;
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const double own = double(cloth.mesh.vertex_areas()[v.value]) * cloth.material.fabrics.front().area_density;
        sum += cloth.inverse_mass[v.value] > 0 ? 1 / double(cloth.inverse_mass[v.value]) : own;
    }
    return sum;
}

Cloth any_patch(Choices& choices) {
    const int quads = 2 + static_cast<int>(choices.next(4));
    const double side = choices.log_between(0.1, 0.8);
    const GarmentMesh square =
        sim::make_square({.columns = quads, .rows = quads, .width = side, .depth = side, .height = 0.45});
    Cloth cloth = make_cloth(square, {any_fabric(choices)}, {.max_level = 1 + static_cast<int>(choices.next(3))});
    cloth.material.grain_angles = {choices.between(-3, 3)};
    refresh_solver(cloth);
    refresh_contacts(cloth);
    return cloth;
}

std::string statistics(const char* what, double value, double most) {
    return std::string(what) + " " + std::to_string(value) + " of " + std::to_string(most);
}

}  // namespace

double Choices::log_between(double low, double high) {
    return low * std::pow(high / low, double(next(256)) / 255);
}

Fabric any_fabric(Choices& choices) {
    const auto from_zero = [&](double most) {
        return choices.one_in(8) ? 0.0 : choices.log_between(1e-6 * most, most);
    };
    Fabric fabric;
    fabric.area_density = choices.log_between(0.005, 5);
    fabric.stretch_warp = choices.log_between(10, 1e6);
    fabric.stretch_weft = choices.log_between(10, 1e6);
    fabric.shear = choices.log_between(0.1, 1e5);
    fabric.bending_warp = from_zero(0.1);
    fabric.bending_weft = from_zero(0.1);
    fabric.bending_hysteresis = from_zero(1);
    fabric.shear_hysteresis = from_zero(1e3);
    fabric.thickness = choices.log_between(1e-5, 0.02);
    fabric.friction = from_zero(2);
    fabric.damping = from_zero(100);
    fabric.air_drag = from_zero(100);
    fabric.strain_limit = choices.log_between(1e-4, 2);
    return fabric;
}

Energy energy_of(const Cloth& cloth) {
    Energy energy{.kinetic = 0, .elastic = strain_energy(cloth) + limit_energy(cloth), .lift = 0};
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        if (cloth.inverse_mass[v.value] <= 0) continue;
        const double mass = 1 / double(cloth.inverse_mass[v.value]);
        const double moved = double((cloth.x[v.value] - cloth.x_prev[v.value]).squaredNorm());
        energy.kinetic += 0.5 * mass * moved / (double(cloth.substep) * double(cloth.substep));
        energy.lift += mass * kGravity * double(cloth.x[v.value].y());
    }
    for (const LeafTriangle& leaf : cloth.mesh.leaf_triangles()) energy.elastic += bending_energy(cloth, leaf);
    return energy;
}

RandomRun::RandomRun(Choices& choices)
    : choices_(choices),
      cloth_(any_patch(choices)),
      mass_(mass_of(cloth_)),
      sphere_(Vec3f(0, 0.3F, 0), kRadius),
      visibility_({.eye = Vec3f(0, 1, 0.5F).normalized(), .is_orthographic = true}) {
    change_time();
    change_criteria();
}

// Only pins base vertices, because a rejoined vertex loses its pin.
void RandomRun::change_pins() {
    const VertexId v(choices_.next(static_cast<std::uint32_t>(cloth_.mesh.base_vertex_count())));
    cloth_.is_pinned[v.value] = !cloth_.is_pinned[v.value];
    cloth_.x_prev[v.value] = cloth_.x[v.value];
    forget_contacts(cloth_);
    refresh_solver(cloth_);
}

void RandomRun::change_body() {
    is_away_ = choices_.one_in(2);
    const Vec3f centre(choices_.between(-0.15F, 0.15F), choices_.between(0, 0.4F), choices_.between(-0.15F, 0.15F));
    std::destroy_at(&sphere_);
    std::construct_at(&sphere_, centre, kRadius);
    forget_contacts(cloth_);
}

// Velocities are kept.
void RandomRun::change_time() {
    const double seconds = choices_.log_between(1.0 / 500, 1.0 / 5);
    stepping_.substeps = 1 + static_cast<int>(choices_.next(24));
    set_substep(cloth_, static_cast<float>(seconds) / static_cast<float>(stepping_.substeps));
}

void RandomRun::change_criteria() {
    options_.criteria = {.collision = choices_.one_in(2),
                         .curvature = choices_.one_in(2),
                         .length = choices_.one_in(2),
                         .buckling = choices_.one_in(2)};
    options_.max_level = static_cast<int>(choices_.next(4));
    options_.shortest_edge = choices_.between(0, 0.03F);
    options_.may_rejoin = !choices_.one_in(4);
    options_.visibility = choices_.one_in(4) ? &visibility_ : nullptr;
    options_.budget = choices_.one_in(4) ? &budget_ : nullptr;
    budget_.set_target(20 + choices_.next(400));
    stepping_.contact.sampled_edge = choices_.one_in(2) ? ContactOptions{}.sampled_edge : 0.0F;
    disc_ = {.panel = 0,
             .centre = Vec2f(choices_.between(-0.4F, 0.4F), choices_.between(-0.4F, 0.4F)),
             .radius = choices_.between(0, 0.2F),
             .level = static_cast<int>(choices_.next(4))};
    options_.minimum_levels = choices_.one_in(2) ? std::span(&disc_, 1) : std::span<const MinimumLevelDisc>();
}

void RandomRun::change_something() {
    switch (choices_.next(8)) {
        case 0:
            return change_pins();
        case 1:
            return change_body();
        case 2:
            return change_time();
        case 3:
        case 4:
            return change_criteria();
        default:
            return;
    }
}

const Collider& RandomRun::body() const {
    return is_away_ ? static_cast<const Collider&>(nothing_) : sphere_;
}

bool RandomRun::is_inside_body() const {
    const auto leaves = cloth_.mesh.leaf_vertices();
    return std::any_of(leaves.begin(), leaves.end(), [&](VertexId v) {
        return cloth_.inverse_mass[v.value] > 0 &&
               body().contact(cloth_.x[v.value].head<3>()).distance < stepping_.contact.offset - 1e-4F;
    });
}

double RandomRun::depth() const {
    float least = stepping_.contact.offset;
    const auto look = [&](const Vec4f& x) {
        least = std::min({least, body().contact(x.head<3>()).distance, x.y() - stepping_.contact.floor});
    };
    for (const VertexId v : cloth_.mesh.leaf_vertices()) look(cloth_.x[v.value]);
    for (std::size_t lane = 0; lane < kBlock * cloth_.solver->contacts.samples.size(); ++lane) {
        const std::optional<Vec3f> sample = sample_at(cloth_.solver->contacts, lane, cloth_.x);
        if (sample) look(with_zero_w(*sample));
    }
    return double(stepping_.contact.offset - least);
}

std::optional<std::string> RandomRun::fault() const {
    if (const auto bad = find_bad_vertex(cloth_)) return "vertex " + std::to_string(bad->value) + " is a bad number";
    for (const VertexId v : cloth_.mesh.leaf_vertices()) {
        if (!cloth_.x_prev[v.value].allFinite()) return "a speed is no number";
    }
    const double mass = mass_of(cloth_);
    if (!(std::abs(mass - mass_) < 1e-5 * mass_)) return statistics("the mass is", mass, mass_);
    return std::nullopt;
}

// Kinetic energy may come from the previous kinetic and elastic energy, from gravity, and from contacts. A contact
// corrects a depth within one sub-step, so it adds at most the speed depth / substep.
std::optional<std::string> RandomRun::energy_fault(const Energy& before, double depth) {
    const Energy now = energy_of(cloth_);
    const double pushed = depth / double(cloth_.substep);
    const double margin = 0.5 * mass_ * 0.2 * 0.2;
    const double most = before.kinetic + before.elastic + std::max(0.0, before.lift - now.lift) +
                        0.5 * mass_ * pushed * pushed + margin;
    if (now.kinetic <= most) return std::nullopt;
    return statistics("kinetic energy (J)", now.kinetic, most);
}

void RandomRun::adapt() {
    const AdaptReport report = adapt_cloth(cloth_, body(), options_, stepping_.contact);
    changes_ += report.splits + report.rejoins;
}

std::optional<std::string> RandomRun::make_step() {
    const Energy before = energy_of(cloth_);
    const double deepest = depth();
    step(cloth_, body(), stepping_);
    for (const VertexId v : cloth_.mesh.leaf_vertices()) cloth_.x_prev[v.value].y() += kick_ * cloth_.substep;
    if (auto broken = fault()) return broken;
    if (is_inside_body()) return "a vertex is inside the body";
    return energy_fault(before, deepest);
}

std::optional<std::string> RandomRun::act() {
    change_something();
    adapt();
    if (const auto broken = check(cloth_.mesh); !broken.empty()) return broken.front();
    if (auto broken = fault()) return broken;
    const int steps = 1 + static_cast<int>(choices_.next(4));
    for (int i = 0; i < steps; ++i) {
        if (auto broken = make_step()) return broken;
    }
    return std::nullopt;
}

}  // namespace selvedge::sim::test

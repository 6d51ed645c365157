#include "sim/inspection/contact_pressure.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "sim/cloth/contact.h"
#include "sim/cloth/solver_state.h"
#include "sim/collide/collider.h"
#include "sim/simulation/simulation.h"

namespace selvedge::sim {
namespace {

// The positions after one sub-step of what the body holds, where it meets it or nothing.
std::vector<Vec4f> after_substep(Simulation simulation, const Collider& met, const Collider& body) {
    Schedule schedule = hanging();
    schedule.substeps = 1;
    schedule.held_by = &body;
    schedule.meets_itself = false;  // it would follow what the body does
    if (&met != &body) {
        simulation.cloth().solver->contacts.faces.clear();
        forget_contacts(simulation.cloth());
    }
    simulation.step(met, schedule);
    return std::move(simulation.cloth().x);
}

// A third of the present area of the adjacent leaves, m^2, by vertex.
std::vector<float> present_areas(const Cloth& cloth) {
    std::vector<float> areas(cloth.x.size(), 0);
    for (const LeafTriangle& t : cloth.mesh.leaf_triangles()) {
        const Vec3f a = cloth.x[t.v[0].value].head<3>(), b = cloth.x[t.v[1].value].head<3>(),
                    c = cloth.x[t.v[2].value].head<3>();
        const float third = (b - a).cross(c - a).norm() / 6;
        for (const VertexId v : t.v) areas[v.value] += third;
    }
    return areas;
}

}  // namespace

ContactPressure measure_contact_pressure(Simulation simulation, const Collider& body,
                                         const ContactPressureOptions& measuring) {
    Cloth& cloth = simulation.cloth();
    reactivate(cloth);
    for (int i = 0; i < measuring.settling_steps; ++i) simulation.step(body, hanging());
    std::vector<Vec3d> sum(cloth.x.size(), Vec3d::Zero());
    for (int i = 0; i < measuring.measured_steps; ++i) {
        const std::vector<Vec4f> with = after_substep(simulation, body, body);
        const std::vector<Vec4f> without = after_substep(simulation, NoBody(), body);
        for (std::size_t v = 0; v < sum.size(); ++v) sum[v] += (with[v] - without[v]).head<3>().cast<double>();
        simulation.step(body, hanging());
    }
    ContactPressure measured;
    const std::vector<float> areas = present_areas(cloth);
    const double per_motion = 1.0 / (measuring.measured_steps * double(cloth.substep) * double(cloth.substep));
    for (const VertexId v : cloth.mesh.leaf_vertices()) {
        const double mass = cloth.inverse_mass[v.value] > 0 ? 1.0 / cloth.inverse_mass[v.value] : 0.0;
        const Vec3f force = (sum[v.value] * (mass * per_motion)).cast<float>();
        const Vec3f normal = body.contact(cloth.x[v.value].head<3>()).normal;
        const float pressing = std::max(0.0F, force.dot(normal));
        measured.force.push_back(force);
        measured.pressure.push_back(areas[v.value] > 0 ? pressing / areas[v.value] : 0.0F);
    }
    return measured;
}

}  // namespace selvedge::sim

#include "sim/dress/contact_pressure.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "sim/cloth/contact.h"
#include "sim/cloth/solver_state.h"
#include "sim/cloth/step.h"
#include "sim/dress/drape.h"

namespace selvedge::sim {
namespace {

constexpr float kDamping = 40;  // 1/s, as in the last phase of a drape

// Steps of a cloth that hangs as a drape left it.
StepOptions hanging_steps(const DrapeOptions& drape) {
    StepOptions stepping{.gravity = drape.gravity, .extra_damping = kDamping, .contact = drape.contact};
    stepping.contact.offset = std::min(drape.rest_offset, drape.contact.offset);
    stepping.stretch_bias_rate = stepping.shear_bias_rate = 0;
    stepping.self_contact = drape.self_contact;
    return stepping;
}

// The positions after one sub-step.
std::vector<Vec4f> after_substep(Cloth cloth, const Collider& body, StepOptions stepping, bool is_other_body) {
    stepping.substeps = 1;
    stepping.self_contact.reset();  // it would follow what the body does
    if (is_other_body) {
        cloth.solver->contacts.faces.clear();
        forget_contacts(cloth);
    }
    step(cloth, body, stepping);
    return cloth.x;
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

ContactPressure measure_contact_pressure(Cloth cloth, const Collider& body, const DressOptions& options,
                                         const ContactPressureOptions& measuring) {
    const StepOptions stepping = hanging_steps(drape_options(options));
    reactivate(cloth);
    for (int i = 0; i < measuring.settling_steps; ++i) step(cloth, body, stepping);
    std::vector<Vec3d> sum(cloth.x.size(), Vec3d::Zero());
    for (int i = 0; i < measuring.measured_steps; ++i) {
        const std::vector<Vec4f> with = after_substep(cloth, body, stepping, false);
        const std::vector<Vec4f> without = after_substep(cloth, NoBody(), stepping, true);
        for (std::size_t v = 0; v < sum.size(); ++v) sum[v] += (with[v] - without[v]).head<3>().cast<double>();
        step(cloth, body, stepping);
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

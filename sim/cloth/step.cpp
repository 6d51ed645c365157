#include "sim/cloth/step.h"

#include <algorithm>
#include <cmath>

#include "sim/cloth/constraints.h"

namespace selvedge {
namespace {

void predict(Cloth& cloth, const StepOptions& options) {
    const float h = cloth.substep;
    const Vec4f fall = padded(options.gravity) * (h * h);
    const float damping = cloth.damping + options.extra_damping;
    const float keep = std::max(0.0F, 1 - damping * h);
    for (const std::uint32_t v : cloth.elements.vertices) {
        const Vec4f moved = (cloth.x[v] - cloth.x_prev[v]) * keep + fall;
        cloth.x_prev[v] = cloth.x[v];
        if (cloth.inverse_mass[v] > 0) cloth.x[v] += moved;
    }
}

// Contacts see thin parts of the body only if no vertex jumps over them.
void limit_moves(Cloth& cloth, float max_move) {
    for (const std::uint32_t v : cloth.elements.vertices) {
        const Vec4f moved = cloth.x[v] - cloth.x_prev[v];
        const float length = moved.norm();
        if (length > max_move) cloth.x[v] = cloth.x_prev[v] + moved * (max_move / length);
    }
}

void pull_seams(Cloth& cloth, std::span<const SeamPull> seams, float gap) {
    for (const SeamPull& pull : seams) {
        const float wa = cloth.inverse_mass[pull.a];
        const float wb = cloth.inverse_mass[pull.b];
        const Vec4f d = cloth.x[pull.b] - cloth.x[pull.a];
        const float length = d.norm();
        if (length <= gap || wa + wb <= 0) continue;
        const Vec4f c = d * ((length - gap) / length / (wa + wb));
        cloth.x[pull.a] += c * wa;
        cloth.x[pull.b] -= c * wb;
    }
}

// Threads rub against each other: neighbours lose part of what they move against one another, which stills the tremble
// of single vertices and leaves what the cloth does as a whole. Momentum is kept.
void rub(Cloth& cloth, float rate, float seconds) {
    const float lost = 1 - std::exp(-rate * seconds);
    for (const LengthLimit& edge : cloth.elements.limits) {
        const Vec4f against = (cloth.x[edge.b] - cloth.x_prev[edge.b]) - (cloth.x[edge.a] - cloth.x_prev[edge.a]);
        cloth.x_prev[edge.a] -= against * (lost * edge.share_a);
        cloth.x_prev[edge.b] += against * (lost * edge.share_b);
    }
}

}  // namespace

void step(Cloth& cloth, const Collider& body, const StepOptions& options) {
    for (int i = 0; i < options.substeps; ++i) {
        const float to_go = static_cast<float>(options.substeps - 1 - i);
        predict(cloth, options);
        limit_parents(cloth.elements.parents, cloth.x, cloth.scratch);
        solve_bend(cloth.elements.bend, cloth.x);
        solve_stretch(cloth.elements.stretch, cloth.inverse_mass, cloth.x);
        limit_stretch(cloth.elements.stretch, cloth.x, cloth.over_limit);
        limit_lengths(cloth.elements.limits, cloth.x);
        limit_moves(cloth, options.max_move_per_substep);
        push_out_between(cloth, body, options.contact);
        pull_seams(cloth, options.seams, options.seam_gap + to_go * options.seam_gap_rate);
        limit_moves(cloth, options.max_move_per_substep);
        push_out_vertices(cloth, body, options.contact);
    }
    rub(cloth, options.internal_damping, cloth.substep * static_cast<float>(options.substeps));
}

}  // namespace selvedge

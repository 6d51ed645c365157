#include "render/surface/adapt_surface.h"

#include <algorithm>
#include <cmath>

#include "sim/adaptive/criteria.h"

namespace selvedge::render {
namespace {

struct Observer : SurfaceObserver {
    Observer(CurvedSurface& surface, SpawnPosition position, sim::Visibility* seen)
        : SurfaceObserver(surface, position), visibility(seen) {}

    void on_capacity(std::size_t capacity) {
        SurfaceObserver::on_capacity(capacity);
        if (visibility != nullptr) visibility->on_capacity(capacity);
    }
    void on_split(sim::VertexId c, sim::VertexId a, sim::VertexId b) {
        SurfaceObserver::on_split(c, a, b);
        if (visibility != nullptr) visibility->on_split(c, a, b);
    }

    sim::Visibility* visibility;
};

// Keeps edges coarse that are hidden, too short or at the maximum level.
struct CoarseVeto {
    static constexpr bool is_veto = true;
    const sim::Visibility* visibility;  // null: everything counts as visible
    float shortest_edge;
    int max_level;

    bool vetoes(const sim::AdaptiveMesh& mesh, sim::EdgeId e) const {
        return mesh.level(e) >= max_level || mesh.rest_length(e) < shortest_edge ||
               (visibility != nullptr && visibility->is_hidden(mesh, e));
    }
};

// All criteria that request splits, combined to one, so that look-ahead covers all of them.
template <sim::EdgeCriterion Shape>
struct SplitRequest {
    const Shape& shape;
    const CurvedSurface& surface;
    const CoarseVeto& veto;  // without it, look-ahead would split neighbours of edges that the veto keeps coarse
    float min_bulge;         // m

    bool wants_split(const sim::AdaptiveMesh& mesh, sim::EdgeId e) const {
        return shape.wants_split(mesh, e) && bulge(mesh.edge(e)) > min_bulge && !veto.vetoes(mesh, e);
    }
    bool allows_rejoin(const sim::AdaptiveMesh& mesh, sim::EdgeId e) const {
        return shape.allows_rejoin(mesh, e) || bulge(mesh.edge(e)) < 0.5F * min_bulge;
    }

    // m, upper bound of the distance by which the middle of a curve with M = 1 leaves its chord.
    float bulge(const sim::AdaptiveEdge& e) const {
        const auto [a, b] = e.ends;
        const Vec4f d = surface.x[b.value] - surface.x[a.value];
        return (std::abs(d.dot(surface.normals[a.value])) + std::abs(d.dot(surface.normals[b.value]))) / 8;
    }
};
template <sim::EdgeCriterion Shape>
SplitRequest(const Shape&, const CurvedSurface&, const CoarseVeto&, float) -> SplitRequest<Shape>;

// No edge rejoins before its vertex has reached the midpoint, neither by a veto nor by agreement. No edge splits before
// its ends have reached their curves, because its present length is not final.
struct VetoOnArrival {
    static constexpr bool is_veto = true;
    const CurvedSurface& surface;
    const CoarseVeto& veto;

    bool vetoes(const sim::AdaptiveMesh& mesh, sim::EdgeId e) const {
        const sim::AdaptiveEdge& edge = mesh.edge(e);
        if (mesh.is_split(e)) return shown(edge.centre) <= 0 && veto.vetoes(mesh, e);
        return !stands(edge.ends[0]) || !stands(edge.ends[1]) || veto.vetoes(mesh, e);
    }
    float shown(sim::VertexId v) const { return surface.shown[v.value]; }
    bool stands(sim::VertexId v) const { return shown(v) >= 1 && !surface.is_leaving[v.value]; }
};
struct RejoinOnArrival {
    const CurvedSurface& surface;

    bool wants_split(const sim::AdaptiveMesh&, sim::EdgeId) const { return false; }
    bool allows_rejoin(const sim::AdaptiveMesh& mesh, sim::EdgeId e) const {
        return surface.shown[mesh.centre(e).value] <= 0;
    }
};

// Marks the vertices that have to move to the midpoints of their edges: those whose edges may rejoin and should.
template <class Criterion>
void note_leaving(CurvedSurface& surface, const CoarseVeto& veto, const Criterion& criterion) {
    const sim::AdaptiveMesh& mesh = surface.mesh;
    const auto is_to_go = [&](sim::EdgeId e) {
        return mesh.has_leaf_children(e) && (criterion.allows_rejoin(mesh, e) || veto.vetoes(mesh, e)) &&
               mesh.may_rejoin(e);
    };
    for (int level = 0; level < mesh.max_level(); ++level) {
        for (const sim::EdgeId e : mesh.split_edges(level)) surface.is_leaving[mesh.centre(e).value] = is_to_go(e);
    }
}

template <class Criterion>
sim::AdaptReport adapt_with(CurvedSurface& surface, const AdaptSurfaceOptions& options, const CoarseVeto& veto,
                            const Criterion& criterion) {
    using SpawnPosition = SurfaceObserver::SpawnPosition;
    Observer observer(surface, options.glides ? SpawnPosition::Middle : SpawnPosition::Curve, options.visibility);
    if (!options.glides) return adapt(surface.mesh, observer, {}, veto, criterion);
    note_leaving(surface, veto, criterion);
    return adapt(surface.mesh, observer, {}, VetoOnArrival{surface, veto}, RejoinOnArrival{surface}, criterion);
}

}  // namespace

sim::AdaptReport adapt_surface(CurvedSurface& surface, const AdaptSurfaceOptions& options) {
    const SurfaceCriteria& on = options.criteria;
    if (options.visibility != nullptr) options.visibility->look(surface.mesh, surface.x, surface.normals);
    const CoarseVeto veto{options.visibility, on.shortest_edge, options.max_level};
    const sim::CurvatureCriterion curvature(surface.normals, on.curvature_angles);
    const sim::BucklingCriterion<Vec4f> buckling(surface.x, on.buckling_ratios);
    const sim::LengthCriterion<Vec4f> length(surface.x, on.compressions);
    const sim::AnyOf shape(sim::OptionalCriterion(on.curvature, curvature),
                           sim::OptionalCriterion(on.buckling, buckling), sim::OptionalCriterion(on.length, length));
    const SplitRequest request{shape, surface, veto, on.min_bulge};
    const sim::AdaptReport report = adapt_with(surface, options, veto, sim::LookAheadCriterion(request));
    if (report.changed()) plan_surface(surface);
    return report;
}

void settle_surface(CurvedSurface& surface, std::span<const Vec4f> x, std::span<const Vec4f> normals,
                    const AdaptSurfaceOptions& options, const MoveOptions& move) {
    constexpr int kMaxIterations = 12;
    AdaptSurfaceOptions at_once = options;
    at_once.glides = false;
    std::fill(surface.shown.begin(), surface.shown.end(), 1.0F);
    std::fill(surface.is_leaving.begin(), surface.is_leaving.end(), false);
    move_surface(surface, x, normals, move);
    for (int i = 0; i < kMaxIterations && adapt_surface(surface, at_once).changed(); ++i) {
        move_surface(surface, x, normals, move);
    }
    update_light_normals(surface);
}

}  // namespace selvedge::render

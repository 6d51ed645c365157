#include "render/surface/curved_surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/adaptive/criteria.h"
#include "sim/adaptive/surface_normals.h"
#include "sim/collide/collider.h"
#include "sim/core/assert.h"

namespace selvedge::render {
namespace {

constexpr float kNoArea = 1e-30F;

Vec4f area_of(const std::array<sim::VertexId, 3>& v, const std::vector<Vec4f>& x) {
    const Vec4f& a = x[v[0].value];
    return (x[v[1].value] - a).cross3(x[v[2].value] - a);
}

void size_arrays(CurvedSurface& surface, std::size_t capacity) {
    surface.x.resize(capacity, Vec4f::Zero());
    surface.normals.resize(capacity, Vec4f::UnitY());
    surface.light_normals.resize(capacity, Vec4f::UnitY());
    surface.shown.resize(capacity, 1.0F);
    surface.is_leaving.resize(capacity, false);
}

void make_root(CurvedSurface& surface, sim::EdgeId e) {
    if (surface.places.size() <= e.value) surface.places.resize(surface.mesh.edges().capacity());
    surface.places[e.value] = {.root = e, .from = 0, .span = static_cast<std::uint16_t>(surface.weights.steps())};
}

CurveEnds ends_of(const CurvedSurface& surface, sim::VertexId a, sim::VertexId b, float rest_length) {
    return {surface.x[a.value], surface.x[b.value], surface.normals[a.value], surface.normals[b.value], rest_length};
}

// Moves the vertex by one step and returns its position between the midpoint of its edge (0) and its curve (1).
float glided(CurvedSurface& surface, const SurfacePlan::Point& point, float way, float max_step) {
    float& shown = surface.shown[point.v.value];
    const float step = way > max_step ? max_step / way : 1.0F;
    if (surface.is_leaving[point.v.value]) {
        shown = std::max(0.0F, shown - step);
    } else if (surface.shown[point.a.value] >= 1 && surface.shown[point.b.value] >= 1) {
        shown = std::min(1.0F, shown + step);
    }
    return shown;
}

Vec4f glide(CurvedSurface& surface, const SurfacePlan::Point& point, const Vec4f& where, float max_step) {
    if (surface.shown[point.v.value] >= 1 && !surface.is_leaving[point.v.value]) return where;
    const Vec4f middle = (surface.x[point.a.value] + surface.x[point.b.value]) * 0.5F;
    const Vec4f way = where - middle;
    return middle + way * glided(surface, point, way.norm(), max_step);
}

// The curve's ends, with the normals seen from one side of the root edge.
CurveEnds ends_from(const CurvedSurface& surface, const SurfacePlan::Curve& curve, sim::TriangleId side) {
    const Creases& creases = surface.creases;
    const auto normal = [&](sim::VertexId v) {
        const auto vertex = sided(creases, surface.mesh, v, root_of(surface, v), creases.base_of[side.value]);
        return vertex ? creases.normals.at(*vertex) : surface.normals[v.value];
    };
    return {surface.x[curve.a.value], surface.x[curve.b.value], normal(curve.a), normal(curve.b), curve.rest_length};
}

// The curve of a root edge if the surface has creases.
EdgeCurve creased_curve(CurvedSurface& surface, const SurfacePlan::Curve& curve) {
    const std::array<sim::TriangleId, 2>& sides = surface.mesh.edge(curve.root).sides;
    const bool is_crease =
        curve.root.value < surface.creases.is_crease.size() && surface.creases.is_crease[curve.root.value];
    if (!is_crease) return make_edge_curve(ends_from(surface, curve, sides[0] ? sides[0] : sides[1]), surface.modifier);
    return make_crease_curve(ends_from(surface, curve, sides[0]), ends_from(surface, curve, sides[1]),
                             surface.modifier);
}

void note_crease_normals(CurvedSurface& surface, const SurfacePlan::Point& point) {
    const SurfacePlan::Curve& curve = surface.plan.curves[point.curve];
    const sim::EdgeId root = curve.root;
    if (root.value >= surface.creases.is_crease.size() || !surface.creases.is_crease[root.value]) return;
    Vec4f sum = Vec4f::Zero();
    for (std::uint32_t side = 0; side < 2; ++side) {
        const sim::TriangleId triangle = surface.mesh.edge(root).sides[side];
        const EdgeCurve seen = make_edge_curve(ends_from(surface, curve, triangle), surface.modifier);
        const Vec4f normal = surface.weights.normal(seen, point.step);
        surface.creases.normals[{point.v, side}] = normal;
        sum += surface.mesh.is_cut(root) && sum.dot(normal) < 0 ? Vec4f(-normal) : normal;
    }
    if (sum.squaredNorm() > 0) surface.normals[point.v.value] = sum.normalized();
}

void move_level(CurvedSurface& surface, std::size_t level, const Lift& lift, float max_step) {
    const SurfacePlan& plan = surface.plan;
    const bool has_creases = !surface.creases.empty();
    const auto first = [level](const std::vector<std::size_t>& ends) { return level == 0 ? 0 : ends[level - 1]; };
    for (std::size_t i = first(plan.curve_ends); i < plan.curve_ends[level]; ++i) {
        const SurfacePlan::Curve& curve = plan.curves[i];
        if (has_creases) {
            surface.curves[i] = creased_curve(surface, curve);
        } else {
            surface.curves[i] =
                make_edge_curve(ends_of(surface, curve.a, curve.b, curve.rest_length), surface.modifier);
        }
    }
    for (std::size_t i = first(plan.point_ends); i < plan.point_ends[level]; ++i) {
        const SurfacePlan::Point& point = plan.points[i];
        const EdgeCurve& curve = surface.curves[point.curve];
        const Vec4f where = surface.weights.point(curve, point.step);
        surface.normals[point.v.value] = surface.weights.normal(curve, point.step);
        if (has_creases) note_crease_normals(surface, point);
        const Vec4f lifted = lift.lifted(point, where);
        surface.x[point.v.value] = glide(surface, point, lifted, max_step);
        lift.note_moved(point.v, (surface.x[point.v.value] - lifted).norm());
    }
}

}  // namespace

sim::EdgeId root_of(const CurvedSurface& surface, sim::VertexId v) {
    const sim::EdgeId parent = surface.mesh.vertex(v).parent;
    return parent ? surface.places[parent.value].root : sim::EdgeId{};
}

CurvedSurface make_curved_surface(const sim::GarmentMesh& base, const SurfaceOptions& options) {
    SELVEDGE_ASSERT(base.links.empty());
    std::vector<Vec4f> x;
    x.reserve(base.x.size());
    for (const Vec3d& at : base.x) x.push_back(sim::with_zero_w(at.cast<float>()));
    return make_curved_surface(x, base.triangles, options);
}

CurvedSurface make_curved_surface(std::span<const Vec4f> x, std::span<const sim::GarmentTriangle> triangles,
                                  const SurfaceOptions& options) {
    CurvedSurface surface{.mesh = sim::AdaptiveMesh(x.size(), triangles, {.max_level = options.max_level}),
                          .modifier = options.modifier,
                          .weights = CurveWeights(options.max_level)};
    size_arrays(surface, surface.mesh.vertex_capacity());
    std::copy(x.begin(), x.end(), surface.x.begin());
    surface.places.resize(surface.mesh.edges().capacity());
    for (std::uint32_t e = 0; e < surface.mesh.base_edge_count(); ++e) make_root(surface, sim::EdgeId(e));
    surface.creases = find_creases(surface.mesh, options.creases);
    if (!surface.creases.empty()) update_base_normals(surface.creases, surface.mesh, surface.x);
    leaf_normals(surface.mesh, surface.x, surface.normals);
    surface.light_normals = surface.normals;
    plan_surface(surface);
    return surface;
}

void SurfaceObserver::on_capacity(std::size_t capacity) {
    size_arrays(surface_, capacity);
}

// The vertex gets position and normal from its root's curve as it is now, because criteria of deeper edges read them.
void SurfaceObserver::on_split(sim::VertexId c, sim::VertexId a, sim::VertexId b) {
    const sim::AdaptiveMesh& mesh = surface_.mesh;
    const sim::EdgeId e = mesh.vertex(c).parent;
    if (surface_.places.size() < mesh.edges().capacity()) surface_.places.resize(mesh.edges().capacity());
    const CurveInterval place = surface_.places[e.value];
    const auto half = static_cast<std::uint16_t>(place.span / 2);
    const auto middle = static_cast<std::uint16_t>(place.from + half);
    const auto [first, second] = mesh.edge(e).children;
    surface_.places[first.value] = {place.root, place.from, half};
    surface_.places[second.value] = {place.root, middle, half};

    const sim::AdaptiveEdge& root = mesh.edge(place.root);
    CurveEnds ends = ends_of(surface_, root.ends[0], root.ends[1], root.rest_length);
    if (mesh.has_cuts() && ends.normal_a.dot(ends.normal_b) < 0) {  // the sign of a normal on a cut means nothing
        if (mesh.vertex(root.ends[0]).on_cut) {
            ends.normal_a *= -1;
        } else if (mesh.vertex(root.ends[1]).on_cut) {
            ends.normal_b *= -1;
        }
    }
    const EdgeCurve curve = make_edge_curve(ends, surface_.modifier);
    const bool is_whole = spawn_ == SpawnPosition::Curve;
    surface_.shown[c.value] = is_whole ? 1.0F : 0.0F;
    surface_.is_leaving[c.value] = false;
    surface_.normals[c.value] = surface_.weights.normal(curve, middle);
    surface_.light_normals[c.value] = surface_.normals[c.value];
    surface_.x[c.value] =
        is_whole ? surface_.weights.point(curve, middle) : Vec4f((surface_.x[a.value] + surface_.x[b.value]) * 0.5F);
}

void SurfaceObserver::after(sim::TriangleId t) {
    const sim::AdaptiveTriangle& owner = surface_.mesh.triangle(t);
    for (std::size_t i = 0; i < layout(owner.configuration).edge_count; ++i)
        make_root(surface_, owner.internal_edges[i]);
    if (!surface_.creases.empty()) note_children(surface_.creases, surface_.mesh, t);
}

void plan_surface(CurvedSurface& surface) {
    const sim::AdaptiveMesh& mesh = surface.mesh;
    SurfacePlan& plan = surface.plan;
    plan.curves.clear();
    plan.points.clear();
    plan.curve_ends.clear();
    plan.point_ends.clear();
    std::vector<std::uint32_t>& curve_of = plan.curve_of;
    curve_of.resize(mesh.edges().capacity());
    for (int level = 0; level < mesh.max_level(); ++level) {
        for (const sim::EdgeId e : mesh.split_edges(level)) {
            const sim::AdaptiveEdge& edge = mesh.edge(e);
            const CurveInterval& place = surface.places[e.value];
            if (place.root == e) {
                curve_of[e.value] = static_cast<std::uint32_t>(plan.curves.size());
                plan.curves.push_back({edge.ends[0], edge.ends[1], edge.rest_length, e});
            }
            plan.points.push_back({.v = edge.centre,
                                   .a = edge.ends[0],
                                   .b = edge.ends[1],
                                   .curve = curve_of[place.root.value],
                                   .step = place.from + place.span / 2U});
        }
        plan.curve_ends.push_back(plan.curves.size());
        plan.point_ends.push_back(plan.points.size());
    }
    surface.curves.resize(plan.curves.size());
}

void move_surface(CurvedSurface& surface, std::span<const Vec4f> x, std::span<const Vec4f> normals,
                  const MoveOptions& options) {
    const std::size_t base = surface.mesh.base_vertex_count();
    SELVEDGE_ASSERT(x.size() >= base && normals.size() >= base);
    std::copy_n(x.begin(), base, surface.x.begin());
    std::copy_n(normals.begin(), base, surface.normals.begin());
    if (!surface.creases.empty()) update_base_normals(surface.creases, surface.mesh, surface.x);
    const Lift lift(surface, options);
    for (std::size_t level = 0; level < surface.plan.point_ends.size(); ++level)
        move_level(surface, level, lift, options.max_step);
}

void leaf_normals(const sim::AdaptiveMesh& mesh, const std::vector<Vec4f>& x, std::vector<Vec4f>& normals) {
    normals.resize(mesh.vertex_capacity());
    sum_normals(mesh, normals, [&](const std::array<sim::VertexId, 3>& v) { return area_of(v, x); });
    for (const sim::VertexId v : mesh.leaf_vertices()) {
        Vec4f& normal = normals[v.value];
        const float squared = normal.squaredNorm();
        normal = squared > kNoArea ? Vec4f(normal / std::sqrt(squared)) : Vec4f(Vec4f::UnitY());
    }
}

void update_light_normals(CurvedSurface& surface) {
    leaf_normals(surface.mesh, surface.x, surface.light_normals);
    if (surface.creases.empty()) return;
    std::vector<sim::EdgeId> roots(surface.mesh.vertex_capacity());
    for (const sim::VertexId v : surface.mesh.leaf_vertices()) roots[v.value] = root_of(surface, v);
    update_light_normals(surface.creases, surface.mesh, roots, surface.x);
}

void update_surface(CurvedSurface& surface, std::span<const Vec4f> x, std::span<const Vec4f> normals,
                    const MoveOptions& options) {
    move_surface(surface, x, normals, options);
    update_light_normals(surface);
}

sim::AdaptReport set_surface_level(CurvedSurface& surface, int level) {
    SurfaceObserver observer(surface, SurfaceObserver::SpawnPosition::Curve);
    const sim::AdaptReport report = set_uniform_level(surface.mesh, observer, level);
    std::fill(surface.shown.begin(), surface.shown.end(), 1.0F);
    std::fill(surface.is_leaving.begin(), surface.is_leaving.end(), false);
    plan_surface(surface);
    return report;
}

namespace {

constexpr int kIterations = 3;  // because the contact normal changes with the position
constexpr float kNear = 1e-5F;  // m, tolerance of the offset surface

}  // namespace

Lift::Lift(CurvedSurface& surface, const MoveOptions& options)
    : surface_(surface), body_(options.body), offset_(options.offset) {
    if (body_ == nullptr) return;
    surface_.clear.resize(surface_.mesh.vertex_capacity());
    for (std::size_t v = 0; v < surface_.mesh.base_vertex_count(); ++v) {
        surface_.clear[v] = body_->contact(surface_.x[v].head<3>()).distance;
    }
}

// Distances change by no more than the vertex moves. So `where` is clear if the distance at an end of the edge, minus
// the way from that end, exceeds the offset.
Vec4f Lift::lifted(const SurfacePlan::Point& point, const Vec4f& where) const {
    if (body_ == nullptr) return where;
    float& clear = surface_.clear[point.v.value];
    const auto still_clear = [&](sim::VertexId end) {
        return surface_.clear[end.value] - (where - surface_.x[end.value]).norm();
    };
    clear = std::max(still_clear(point.a), still_clear(point.b));
    if (clear > offset_ + body_->max_error()) return where;
    Vec4f x = where;
    for (int i = 0; i < kIterations; ++i) {
        const sim::Contact contact = body_->contact(x.head<3>());
        clear = contact.distance;
        const float lacking = offset_ - contact.distance;
        if (lacking <= kNear) break;
        x += sim::with_zero_w(contact.normal * lacking);
        clear = offset_;
    }
    return x;
}

namespace {

// Union-find over corners of base triangles: corners are joined where the surface is smooth across an edge.
class SmoothParts {
 public:
    explicit SmoothParts(std::size_t corners) : joined_(corners) { std::iota(joined_.begin(), joined_.end(), 0U); }
    std::uint32_t find(std::uint32_t corner) {
        while (joined_[corner] != corner) corner = joined_[corner] = joined_[joined_[corner]];
        return corner;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = find(a), b = find(b);
        joined_[std::max(a, b)] = std::min(a, b);
    }

 private:
    std::vector<std::uint32_t> joined_;
};

std::uint32_t corner_of(const sim::AdaptiveMesh& mesh, sim::TriangleId t, sim::VertexId v) {
    return 3 * t.value + static_cast<std::uint32_t>(corner_at(mesh.triangle(t), v));
}

void make_unit(std::map<SidedVertex, Vec4f>& normals) {
    for (auto& [vertex, normal] : normals) {
        const float length = normal.norm();
        normal = length > 0 ? Vec4f(normal / length) : Vec4f(Vec4f::UnitY());
    }
}

Vec4f area_of(const sim::AdaptiveTriangle& t, const std::vector<Vec4f>& x) {
    const Vec4f area = area_of(t.vertices, x);
    return t.turned ? Vec4f(-area) : area;
}

// The component of d along the line in which the planes of two normals meet; in the plane of their mean if the normals
// are nearly equal.
Vec4f along_both(const Vec4f& d, const Vec4f& first, const Vec4f& second) {
    constexpr float kNearlyOne = 1e-3F;
    const Vec4f line = first.cross3(second);
    const float squared = line.squaredNorm();
    if (squared > kNearlyOne * kNearlyOne) return line * (d.dot(line) / squared);
    const Vec4f mean = (first.dot(second) < 0 ? Vec4f(first - second) : Vec4f(first + second)).normalized();
    return d - mean * d.dot(mean);
}

}  // namespace

Creases find_creases(const sim::AdaptiveMesh& mesh, std::span<const CreaseEdge> edges) {
    Creases creases;
    if (edges.empty() && !mesh.has_cuts()) return creases;
    creases.is_crease.resize(mesh.base_edge_count());
    creases.is_creased.resize(mesh.base_vertex_count());
    std::vector<CreaseEdge> wanted(edges.begin(), edges.end());
    for (CreaseEdge& edge : wanted) std::sort(edge.begin(), edge.end());
    std::sort(wanted.begin(), wanted.end());
    SmoothParts parts(3 * mesh.base_triangle_count());
    for (std::uint32_t i = 0; i < mesh.base_edge_count(); ++i) {
        const sim::AdaptiveEdge& edge = mesh.edge(sim::EdgeId(i));
        CreaseEdge ends{static_cast<int>(edge.ends[0].value), static_cast<int>(edge.ends[1].value)};
        std::sort(ends.begin(), ends.end());
        creases.is_crease[i] = std::binary_search(wanted.begin(), wanted.end(), ends) || mesh.is_cut(sim::EdgeId(i));
        SELVEDGE_ASSERT(!creases.is_crease[i] || (edge.sides[0] && edge.sides[1]));
        for (const sim::VertexId v : edge.ends) {
            if (creases.is_crease[i]) {
                creases.is_creased[v.value] = true;
            } else if (edge.sides[0] && edge.sides[1]) {
                parts.join(corner_of(mesh, edge.sides[0], v), corner_of(mesh, edge.sides[1], v));
            }
        }
    }
    for (std::uint32_t t = 0; t < mesh.base_triangle_count(); ++t) {
        creases.corner_side.push_back({parts.find(3 * t), parts.find(3 * t + 1), parts.find(3 * t + 2)});
        creases.base_of.emplace_back(t);
    }
    return creases;
}

void note_children(Creases& creases, const sim::AdaptiveMesh& mesh, sim::TriangleId t) {
    creases.base_of.resize(std::max(creases.base_of.size(), mesh.triangles().capacity()));
    const sim::AdaptiveTriangle& owner = mesh.triangle(t);
    for (std::size_t i = 0; i < layout(owner.configuration).triangle_count; ++i)
        creases.base_of[owner.internal_triangles[i].value] = creases.base_of[t.value];
}

std::optional<SidedVertex> sided(const Creases& creases, const sim::AdaptiveMesh& mesh, sim::VertexId v,
                                 sim::EdgeId root, sim::TriangleId base) {
    if (v.value < mesh.base_vertex_count()) {
        if (!creases.is_creased[v.value]) return {};
        return SidedVertex{v, creases.corner_side[base.value][corner_at(mesh.triangle(base), v)]};
    }
    if (root.value >= creases.is_crease.size() || !creases.is_crease[root.value]) return {};
    return SidedVertex{v, mesh.edge(root).sides[0] == base ? 0U : 1U};
}

void update_base_normals(Creases& creases, const sim::AdaptiveMesh& mesh, const std::vector<Vec4f>& x) {
    creases.normals.clear();
    for (std::uint32_t t = 0; t < mesh.base_triangle_count(); ++t) {
        const sim::AdaptiveTriangle& triangle = mesh.triangle(sim::TriangleId(t));
        const std::array<sim::VertexId, 3>& vertices = triangle.vertices;
        for (std::size_t k = 0; k < 3; ++k) {
            if (!creases.is_creased[vertices[k].value]) continue;
            Vec4f& sum =
                creases.normals.try_emplace({vertices[k], creases.corner_side[t][k]}, Vec4f::Zero()).first->second;
            sum += area_of(triangle, x);
        }
    }
    make_unit(creases.normals);
}

void update_light_normals(Creases& creases, const sim::AdaptiveMesh& mesh, const std::vector<sim::EdgeId>& roots,
                          const std::vector<Vec4f>& x) {
    creases.light_normals.clear();
    for (const sim::LeafTriangle& t : mesh.leaf_triangles()) {
        const Vec4f area = area_of(mesh.triangle(t.triangle), x);
        for (const sim::VertexId v : t.v) {
            const auto vertex = sided(creases, mesh, v, roots[v.value], creases.base_of[t.triangle.value]);
            if (vertex) creases.light_normals.try_emplace(*vertex, Vec4f::Zero()).first->second += area;
        }
    }
    make_unit(creases.light_normals);
}

EdgeCurve make_crease_curve(const CurveEnds& first, const CurveEnds& second, const CurveModifier& modifier) {
    const Vec4f d = first.b - first.a;
    return bent_curve(first, along_both(d, first.normal_a, second.normal_a) - d,
                      d - along_both(d, first.normal_b, second.normal_b), modifier);
}

}  // namespace selvedge::render

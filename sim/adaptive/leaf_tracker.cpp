#include "sim/adaptive/leaf_tracker.h"

#include <algorithm>
#include <limits>

#include "sim/adaptive/adaptive_mesh.h"

namespace selvedge::sim {
namespace {

// Per edge of a triangle: the unit vector along the edge, and the opposite corner in a frame with its origin in the
// middle of the edge and x along it. Four SIMD lanes; the last repeats the first.
struct Unfolded {
    Eigen::Array4f along_x, along_y, at_x, at_y;
};

Unfolded unfold(const std::array<Vec2f, 3>& u) {
    const Eigen::Array4f ax(u[0].x(), u[1].x(), u[2].x(), u[0].x()), ay(u[0].y(), u[1].y(), u[2].y(), u[0].y());
    const Eigen::Array4f bx(u[1].x(), u[2].x(), u[0].x(), u[1].x()), by(u[1].y(), u[2].y(), u[0].y(), u[1].y());
    const Eigen::Array4f cx(u[2].x(), u[0].x(), u[1].x(), u[2].x()), cy(u[2].y(), u[0].y(), u[1].y(), u[2].y());
    const Eigen::Array4f dx = bx - ax, dy = by - ay;
    const Eigen::Array4f length = (dx * dx + dy * dy).max(std::numeric_limits<float>::min()).sqrt();
    const Eigen::Array4f along_x = dx / length, along_y = dy / length;
    const Eigen::Array4f arm_x = cx - 0.5F * (ax + bx), arm_y = cy - 0.5F * (ay + by);
    return {along_x, along_y, along_x * arm_x + along_y * arm_y, along_x * arm_y - along_y * arm_x};
}

// The index for a new entry: a gap if there is one, else a new one at the end.
template <class Entry>
std::uint32_t next_place(std::vector<Entry>& list, std::vector<std::uint32_t>& gaps) {
    if (gaps.empty()) {
        list.emplace_back();
        return static_cast<std::uint32_t>(list.size() - 1);
    }
    const std::uint32_t at = gaps.back();
    gaps.pop_back();
    return at;
}

// Moves entries from the end into the remaining gaps; each entry moves at most once. Returns the new number of entries.
template <class IsGap, class Move>
std::uint32_t close(std::size_t size, std::vector<std::uint32_t>& gaps, IsGap&& is_gap, Move&& move) {
    auto left = static_cast<std::uint32_t>(size);
    for (const std::uint32_t gap : gaps) {
        while (left > 0 && is_gap(left - 1)) --left;
        if (gap < left) move(--left, gap);
    }
    gaps.clear();
    return left;
}

bool has_hinge(const AdaptiveEdge& edge) {
    return edge.sides[0] && edge.sides[1];
}

}  // namespace

// Reserves all scratch memory for that many elements, so that refresh() allocates only when the lists themselves grow.
void LeafTracker::grow(std::size_t vertices, std::size_t edges, std::size_t triangles) {
    const auto enlarge = [](auto& places, std::size_t size) {
        if (places.by_id.size() < size) places.by_id.resize(size, kUnlisted);
    };
    const auto reserve = [](std::size_t size, auto&... lists) {
        (lists.reserve(lists.capacity() < size ? std::max(size, 2 * lists.capacity()) : 0), ...);
    };
    enlarge(vertices_, vertices);
    enlarge(edges_, edges);
    enlarge(triangles_, triangles);
    reserve(vertices, vertices_.noted, changes_.vertices_removed, changes_.vertices_added, gaps_.vertices);
    reserve(edges, edges_.noted, changes_.edges_removed, changes_.edges_added, changes_.hinges_changed, fresh_,
            gaps_.hinges, gaps_.boundary);
    reserve(triangles, triangles_.noted, changes_.triangles_removed, changes_.triangles_added, changes_.refined_changed,
            refined_noted_, gaps_.triangles);
}

void LeafTracker::refresh(const AdaptiveMesh& mesh) {
    changes_.clear();
    for (const TriangleId t : refined_noted_) triangles_.by_id[t.value] &= ~kIsRefinedNoted;
    changes_.refined_changed.swap(refined_noted_);
    if (vertices_.noted.empty() && edges_.noted.empty() && triangles_.noted.empty()) return;
    lists_.vertex_areas.resize(mesh.vertex_capacity(), 0.0F);
    area_sums_.resize(mesh.vertex_capacity(), 0.0);
    old_hinges_ = lists_.hinges.size();
    lists_.edges.resize(old_hinges_);
    erase_triangles();
    erase_edges();
    erase_vertices();
    insert_edges(mesh);
    insert_triangles(mesh);
    for (const EdgeId e : fresh_) edges_.by_id[e.value] &= ~kIsFresh;
    fresh_.clear();
    close_gaps();
    lists_.edges.insert(lists_.edges.end(), boundary_.begin(), boundary_.end());
    vertices_.noted.clear();
    edges_.noted.clear();
    triangles_.noted.clear();
}

void LeafTracker::erase_triangles() {
    for (const TriangleId t : triangles_.noted) {
        Place& place = triangles_.by_id[t.value];
        place &= ~kNoted;
        if (!is_listed(place)) continue;
        changes_.triangles_removed.push_back(t);
        const Place at = place & kPosition;
        add_areas(lists_.triangles[at], -1.0);
        lists_.triangles[at].triangle = {};
        gaps_.triangles.push_back(at);
        place = kUnlisted | (place & kIsReleased);
    }
}

void LeafTracker::erase_edges() {
    for (const EdgeId e : edges_.noted) {
        Place& place = edges_.by_id[e.value];
        place &= ~kNoted;
        if (!is_listed(place)) continue;
        changes_.edges_removed.push_back(e);
        const bool is_boundary = (place & kIsBoundary) != 0;
        const Place at = place & kPosition;
        (is_boundary ? boundary_ : lists_.edges)[at].edge = {};
        (is_boundary ? gaps_.boundary : gaps_.hinges).push_back(at);
        place = kUnlisted | (place & kIsReleased);
    }
}

void LeafTracker::erase_vertices() {
    for (const VertexId v : vertices_.noted) {
        Place& place = vertices_.by_id[v.value];
        const bool is_released = (place & kIsReleased) != 0;
        if (is_listed(place)) {
            const Place at = place & kPosition;
            changes_.vertices_removed.push_back(v);
            lists_.vertices[at] = {};
            gaps_.vertices.push_back(at);
        }
        place = kUnlisted;
        if (!is_released) insert(v);
    }
}

void LeafTracker::insert_edges(const AdaptiveMesh& mesh) {
    for (const EdgeId e : edges_.noted) {
        if (was_released(edges_, e)) continue;
        const AdaptiveEdge& edge = mesh.edge(e);
        insert(mesh, e);
        if (!edge.centre) continue;
        insert(edge.centre);
        for (const EdgeId child : edge.children) insert(mesh, child);
    }
    for (const TriangleId t : triangles_.noted) {
        if ((triangles_.by_id[t.value] & kIsReleased) != 0) continue;
        const AdaptiveTriangle& owner = mesh.triangle(t);
        const std::size_t count = layout(owner.configuration).edge_count;
        for (std::size_t i = 0; i < count; ++i) insert(mesh, owner.internal_edges[i]);
    }
}

void LeafTracker::insert_triangles(const AdaptiveMesh& mesh) {
    for (const TriangleId t : triangles_.noted) {
        if (was_released(triangles_, t)) continue;
        const AdaptiveTriangle& owner = mesh.triangle(t);
        insert(mesh, t);
        const std::size_t count = layout(owner.configuration).triangle_count;
        for (std::size_t i = 0; i < count; ++i) insert(mesh, owner.internal_triangles[i]);
    }
}

void LeafTracker::insert(VertexId v) {
    Place& place = vertices_.by_id[v.value];
    if (is_listed(place)) return;
    place = next_place(lists_.vertices, gaps_.vertices);
    lists_.vertices[place] = v;
    changes_.vertices_added.push_back(v);
}

void LeafTracker::insert(const AdaptiveMesh& mesh, EdgeId e) {
    Place& place = edges_.by_id[e.value];
    const AdaptiveEdge& edge = mesh.edge(e);
    if (is_listed(place) || edge.centre) return;
    changes_.edges_added.push_back(e);
    if (!has_hinge(edge)) {
        const Place at = next_place(boundary_, gaps_.boundary);
        boundary_[at] = {edge.ends[0], edge.ends[1], edge.rest_length, e};
        place = at | kIsBoundary;
        return;
    }
    place = next_place(lists_.edges, gaps_.hinges);
    lists_.edges[place] = {edge.ends[0], edge.ends[1], edge.rest_length, e};
    if (place == lists_.hinges.size()) lists_.hinges.emplace_back();
    Hinge& hinge = lists_.hinges[place];
    hinge.a = edge.ends[0];
    hinge.b = edge.ends[1];
    hinge.rest_length = edge.rest_length;
    hinge.edge = e;
    hinge.right_wrong = edge.right_wrong;
    if (place < old_hinges_) mark_fresh(e, place);
}

void LeafTracker::insert(const AdaptiveMesh& mesh, TriangleId id) {
    Place& place = triangles_.by_id[id.value];
    const AdaptiveTriangle& t = mesh.triangle(id);
    if (is_listed(place) || !is_leaf(t)) return;
    changes_.triangles_added.push_back(id);
    place = next_place(lists_.triangles, gaps_.triangles);
    LeafTriangle& leaf = lists_.triangles[place];
    leaf.v = t.vertices;
    leaf.u = t.u;
    leaf.triangle = id;
    leaf.panel = t.panel;
    leaf.level = t.level;
    leaf.turned = t.turned;
    add_areas(leaf, 1.0);
    write_hinges(mesh, id);
}

// Each triangle writes its own half of the hinges at its edges: the left half if the edge is directed anticlockwise in
// the triangle, else the right half, rotated by 180 degrees about the middle of the edge. At a right_wrong edge the
// right half is mirrored at the edge instead.
void LeafTracker::write_hinges(const AdaptiveMesh& mesh, TriangleId id) {
    const AdaptiveTriangle& t = mesh.triangle(id);
    const Unfolded unfolded = unfold(t.u);
    for (std::size_t k = 0; k < 3; ++k) {
        Place& place = edges_.by_id[t.edges[k].value];
        if ((place & kIsBoundary) != 0 || !is_listed(place)) continue;
        Hinge& hinge = lists_.hinges[place & kPosition];
        const auto lane = static_cast<Eigen::Index>(k);
        const bool is_left = hinge.right_wrong ? mesh.side_of(id, k) == 0 : hinge.a == t.vertices[k];
        const float sign_x = is_left || hinge.right_wrong ? 1.0F : -1.0F, sign_y = is_left ? 1.0F : -1.0F;
        (is_left ? hinge.left : hinge.right) = t.vertices[(k + 2) % 3];
        (is_left ? hinge.left_at : hinge.right_at) = Vec2f(sign_x * unfolded.at_x[lane], sign_y * unfolded.at_y[lane]);
        hinge.along[is_left ? 0 : 1] = sign_x * Vec2f(unfolded.along_x[lane], unfolded.along_y[lane]);
        if ((place & kPosition) >= old_hinges_ || (place & kIsFresh) != 0) continue;
        changes_.hinges_changed.push_back(t.edges[k]);
        mark_fresh(t.edges[k], place);
    }
}

void LeafTracker::mark_fresh(EdgeId e, Place& place) {
    place |= kIsFresh;
    fresh_.push_back(e);
}

void LeafTracker::add_areas(const LeafTriangle& triangle, double sign) {
    const double third = sign * static_cast<double>(material_area(triangle.u) / 3.0F);
    for (const VertexId v : triangle.v) {
        area_sums_[v.value] += third;
        lists_.vertex_areas[v.value] = static_cast<float>(area_sums_[v.value]);
    }
}

void LeafTracker::close_gaps() {
    const auto close_list = [](auto& list, std::vector<Place>& gaps, auto&& id_of, auto& places, Place marks) {
        const std::uint32_t left = close(
            list.size(), gaps, [&](Place at) { return !id_of(list[at]); },
            [&](Place from, Place to) {
                list[to] = list[from];
                places.by_id[id_of(list[to]).value] = to | marks;
            });
        list.resize(left);
    };
    close_list(
        lists_.vertices, gaps_.vertices, [](VertexId v) { return v; }, vertices_, 0);
    close_list(
        lists_.triangles, gaps_.triangles, [](const LeafTriangle& t) { return t.triangle; }, triangles_, 0);
    close_list(
        boundary_, gaps_.boundary, [](const LeafEdge& e) { return e.edge; }, edges_, kIsBoundary);
    close_hinges();
}

void LeafTracker::close_hinges() {
    const std::uint32_t left = close(
        lists_.edges.size(), gaps_.hinges, [&](Place at) { return !lists_.edges[at].edge; },
        [&](Place from, Place to) {
            lists_.edges[to] = lists_.edges[from];
            lists_.hinges[to] = lists_.hinges[from];
            edges_.by_id[lists_.edges[to].edge.value] = to;
        });
    lists_.edges.resize(left);
    lists_.hinges.resize(left);
}

void LeafChanges::clear() {
    for (std::vector<VertexId>* list : {&vertices_removed, &vertices_added}) list->clear();
    for (std::vector<EdgeId>* list : {&edges_removed, &edges_added, &hinges_changed}) list->clear();
    for (std::vector<TriangleId>* list : {&triangles_removed, &triangles_added, &refined_changed}) list->clear();
}

}  // namespace selvedge::sim

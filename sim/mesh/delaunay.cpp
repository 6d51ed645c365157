#include "sim/mesh/delaunay.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <algorithm>
#include <bit>

#include "sim/core/assert.h"

namespace selvedge::sim {
namespace {

constexpr int kNoVertex = -1;

struct Corners {
    std::array<int, 3> vertex{kNoVertex, kNoVertex, kNoVertex};  // our vertex index at each corner of the face
    bool is_inside = false;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<Corners, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Vertex = Triangulation::Vertex_handle;
using Face = Triangulation::Face_handle;

int& corner(Face face, int index) {
    return face->info().vertex[static_cast<std::size_t>(index)];
}

Kernel::Point_2 point(const Vec2d& p) {
    return {p.x(), p.y()};
}

// Calls insert(i, near) for each of `count` points along a line or in rows, near: one of those before, or itself for
// the first. They come in the order of a binary tree: all that are a multiple of some power of two, then those halfway
// between them. One after the other, the points of a circle would each flip all triangles of those before.
template <class Insert>
void insert_spread(std::size_t count, const Insert& insert) {
    if (count > 0) insert(0, 0);
    for (std::size_t step = std::bit_floor(count); step > 0; step /= 2)
        for (std::size_t i = step; i < count; i += 2 * step) insert(i, i - step);
}

// Inserts the outline's points, and its segments as constraints.
std::vector<Vertex> insert_outline(Triangulation& plane, std::span<const Vec2d> outline) {
    std::vector<Vertex> handles(outline.size());
    insert_spread(outline.size(), [&](std::size_t i, std::size_t near) {
        handles[i] = plane.insert(point(outline[i]), i == near ? Face() : handles[near]->face());
        handles[i]->info() = kNoVertex;
    });
    for (std::size_t i = 0; i < handles.size(); ++i) {
        plane.insert_constraint(handles[i], handles[(i + 1) % handles.size()]);
    }
    return handles;
}

bool insert_interior(Triangulation& plane, std::span<const Vec2d> interior, std::size_t first) {
    const std::size_t before = plane.number_of_vertices();
    std::vector<Vertex> handles(interior.size());
    insert_spread(interior.size(), [&](std::size_t i, std::size_t near) {
        handles[i] = plane.insert(point(interior[i]), i == near ? Face() : handles[near]->face());
        handles[i]->info() = static_cast<int>(first + i);
    });
    return plane.number_of_vertices() == before + interior.size();
}

// The face to the left of the edge from a to b; null if ab is not an edge or that side is outside the convex hull.
Face left_of(const Triangulation& plane, Vertex a, Vertex b) {
    Face face;
    int opposite = 0;
    if (!plane.is_edge(a, b, face, opposite)) return {};
    if (face->vertex(Triangulation::ccw(opposite)) != a) face = face->neighbor(opposite);
    return plane.is_infinite(face) ? Face() : face;
}

// Sets our index `vertex` in the corners at `handle` of a sector of faces: from `face`, left of the outgoing outline
// edge, counter-clockwise to the incoming outline edge, which comes from `previous`. Returns false if another outline
// edge is in between.
//
//        \  ^  /
//     f2  \ | /  f1       the sector of this outline vertex at the point v; if the outline passes the same point again,
//   -------v------->      that outline vertex has another sector
//          ^  face
bool claim_sector(const Triangulation& plane, Face face, Vertex handle, Vertex previous, int vertex) {
    while (true) {
        const int at = face->index(handle);
        if (corner(face, at) != kNoVertex) return false;
        corner(face, at) = vertex;
        face->info().is_inside = true;
        const int across = Triangulation::ccw(at);
        if (face->is_constrained(across)) return face->vertex(Triangulation::cw(at)) == previous;
        face = face->neighbor(across);
        if (plane.is_infinite(face)) return false;
    }
}

// Flood fill: marks all faces as inside that can be reached from an inside face without crossing the outline.
void flood(Triangulation& plane) {
    std::vector<Face> open;
    for (Face face : plane.finite_face_handles()) {
        if (face->info().is_inside) open.push_back(face);
    }
    while (!open.empty()) {
        const Face face = open.back();
        open.pop_back();
        for (int i = 0; i < 3; ++i) {
            const Face next = face->neighbor(i);
            if (face->is_constrained(i) || plane.is_infinite(next) || next->info().is_inside) continue;
            next->info().is_inside = true;
            open.push_back(next);
        }
    }
}

std::optional<std::vector<std::array<int, 3>>> collect_inside(Triangulation& plane) {
    std::vector<std::array<int, 3>> triangles;
    for (Face face : plane.finite_face_handles()) {
        if (!face->info().is_inside) continue;
        std::array<int, 3> triangle{};
        for (int i = 0; i < 3; ++i) {
            const int inner = face->vertex(i)->info();
            triangle[static_cast<std::size_t>(i)] = inner != kNoVertex ? inner : corner(face, i);
        }
        if (std::ranges::find(triangle, kNoVertex) != triangle.end()) return std::nullopt;
        std::rotate(triangle.begin(), std::ranges::min_element(triangle), triangle.end());
        triangles.push_back(triangle);
    }
    std::ranges::sort(triangles);
    return triangles;
}

}  // namespace

std::optional<std::vector<std::array<int, 3>>> delaunay_inside(std::span<const Vec2d> outline,
                                                               std::span<const Vec2d> interior) {
    Triangulation plane;
    const std::vector<Vertex> handles = insert_outline(plane, outline);
    if (plane.dimension() < 2) return std::nullopt;
    if (!insert_interior(plane, interior, outline.size())) return std::nullopt;
    for (std::size_t i = 0; i < handles.size(); ++i) {
        const Vertex previous = handles[(i + handles.size() - 1) % handles.size()];
        const Face face = left_of(plane, handles[i], handles[(i + 1) % handles.size()]);
        if (face == Face() || !claim_sector(plane, face, handles[i], previous, static_cast<int>(i)))
            return std::nullopt;
    }
    flood(plane);
    return collect_inside(plane);
}

int side_of(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
    return static_cast<int>(CGAL::orientation(point(a), point(b), point(c)));
}

}  // namespace selvedge::sim

#pragma once
// Vertex normals of an adaptive mesh: area-weighted sums over its leaf triangles, in one orientation of the surface.
//
// Where panels are sewn right side to wrong side, the right sides of neighbouring triangles look to opposite sides of
// the surface, so triangles that are `turned` count with the opposite sign. At a cut (AdaptiveMesh::is_cut) no
// orientation fits both sides; there each vertex takes that of the first triangle round it, and the sign of its normal
// means nothing.
#include <array>
#include <vector>

#include "sim/adaptive/adaptive_mesh.h"

namespace selvedge::sim {

// Sets the normals of the leaf vertices, by VertexId; their lengths are sums of areas. area_of(vertices): the vector of
// a triangle that looks to its fabric's right side; its length is proportional to the triangle's area.
template <class Normal, class AreaOf>
void sum_normals(const AdaptiveMesh& mesh, std::vector<Normal>& normals, const AreaOf& area_of) {
    for (const VertexId v : mesh.leaf_vertices()) normals[v.value].setZero();
    for (const LeafTriangle& triangle : mesh.leaf_triangles()) {
        Normal area = area_of(triangle.v);
        if (triangle.turned) area = -area;
        for (const VertexId v : triangle.v) normals[v.value] += area;
    }
    if (!mesh.has_cuts()) return;
    for (const VertexId v : mesh.leaf_vertices()) {
        if (!mesh.vertex(v).on_cut) continue;
        normals[v.value].setZero();
        const AdaptiveMesh::TrianglesAt around = mesh.triangles_at(v);
        for (auto at = around.begin(); at != around.end(); ++at) {
            const Normal area = area_of(mesh.triangle(*at).vertices);
            normals[v.value] += at.is_turned() ? Normal(-area) : area;
        }
    }
}

// The sum of the normals at the ends of an edge. Where an end lies on a cut, its sign is chosen so that the angle
// between them is acute.
template <class Normal>
Normal sum_of_ends(const AdaptiveMesh& mesh, const std::vector<Normal>& normals, VertexId a, VertexId b) {
    const Normal &first = normals[a.value], &second = normals[b.value];
    if (!mesh.has_cuts() || first.dot(second) >= 0) return first + second;
    if (mesh.vertex(a).on_cut) return second - first;
    return mesh.vertex(b).on_cut ? Normal(first - second) : Normal(first + second);
}

}  // namespace selvedge::sim

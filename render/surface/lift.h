#pragma once
// Keeps the drawn surface out of the body: where the cloth lies on it, a curve or the chord of a new edge may dip below
// the offset surface; its vertices are lifted back onto it.  (SPEC 5)
#include "render/surface/curved_surface.h"

namespace selvedge {

// For one update: asks the body once for each base vertex, and then only where a vertex may be too near.
class Lift {
 public:
    // The surface's base vertices are where they are to be. surface.clear is its memory.
    Lift(CurvedSurface& surface, const MoveOptions& options);

    // A vertex of an edge, moved to the offset surface if it was nearer to the body or inside, else `where`.
    Vec4f lifted(const SurfacePlan::Point& point, const Vec4f& where) const;

    // It stands so far, m, from where it was lifted to: so much nearer to the body it may be.
    void note_moved(VertexId v, float distance) const {
        if (body_ != nullptr) surface_.clear[v.value] -= distance;
    }

 private:
    CurvedSurface& surface_;
    const Collider* body_;
    float offset_;  // m
};

}  // namespace selvedge

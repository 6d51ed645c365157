#include "sim/cloth/triangle_bending.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "sim/cloth/cloth.h"
#include "sim/cloth/curvature_map.h"
#include "sim/cloth/kernels.h"
#include "sim/cloth/material_frame.h"
#include "sim/cloth/solver_blocks.h"
#include "sim/cloth/solver_state.h"
#include "sim/cloth/state_transfer.h"

namespace selvedge::sim {
namespace {

// Which neighbours to use: those of leaves are leaves; those of refined triangles are triangles of the same level,
// leaves or not.
enum class Level { Leaves, Refined };

struct Beside {
    TriangleId triangle;       // none at a boundary
    std::size_t edge = 0;      // the shared edge in the neighbour: the index of the opposite corner
    bool right_wrong = false;  // see AdaptiveEdge
};

Beside beside(const AdaptiveMesh& mesh, TriangleId t, std::size_t i, Level level) {
    const AdaptiveTriangle& triangle = mesh.triangle(t);
    const std::size_t k = (i + 1) % 3;
    const EdgeId e = triangle.edges[k];
    const int other = 1 - mesh.side_of(t, k);
    const TriangleId found =
        level == Level::Leaves ? mesh.leaf_at(e, other) : mesh.edge(e).sides[static_cast<std::size_t>(other)];
    if (!found) return {};
    return {found, (index_of(mesh.triangle(found), e) + 2) % 3, mesh.edge(e).right_wrong};
}

// A triangle with its neighbours. points: the corners, then the apex beyond each edge; for an edge without a hinge the
// opposite corner instead. An edge has no hinge at a boundary, and if its apex is one of the points already, because a
// solve writes each point once (this removes one hinge of each triangle at a vertex of valence three).
using Points = std::array<std::uint32_t, 6>;
struct Neighbourhood {
    RestTriangle rest;
    std::array<Beside, 3> beside;
    Points points;
};

RestTriangle alone(const Cloth& cloth, TriangleId t) {
    const AdaptiveTriangle& triangle = cloth.mesh.triangle(t);
    const float grain = cloth.material.grain_angles[triangle.panel];
    const Vec2d warp = warp_direction(grain).cast<double>();
    const Vec2d origin = triangle.u[0].cast<double>();
    RestTriangle rest;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec2d u = triangle.u[i].cast<double>() - origin;
        rest.x[i] = Vec2d(warp.dot(u), cross2(warp, u));
    }
    return rest;
}

// Everything but the shapes.
Neighbourhood points_about(const AdaptiveMesh& mesh, TriangleId t, Level level) {
    Neighbourhood found{.rest = {}, .beside = {}, .points = {}};
    const std::array<VertexId, 3>& v = mesh.triangle(t).vertices;
    for (std::size_t i = 0; i < 3; ++i) found.points[i] = v[i].value;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto end = found.points.begin() + 3 + static_cast<std::ptrdiff_t>(i);
        const Beside other = beside(mesh, t, i, level);
        *end = v[i].value;
        if (!other.triangle) continue;
        const std::uint32_t apex = mesh.triangle(other.triangle).vertices[other.edge].value;
        if (std::find(found.points.begin(), end, apex) != end) continue;
        *end = apex;
        found.beside[i] = other;
    }
    return found;
}

Neighbourhood neighbourhood(const Cloth& cloth, TriangleId t, Level level) {
    Neighbourhood found = points_about(cloth.mesh, t, level);
    found.rest = alone(cloth, t);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& [triangle, edge, right_wrong] = found.beside[i];
        if (!triangle) continue;
        const RestTriangle rest = alone(cloth, triangle);
        found.rest.beyond[i] = right_wrong ? rest.own_side(edge) : rest.side_for_neighbour(edge);
    }
    return found;
}

// The fits of triangles and of their neighbours. They are kept while there are few, for they are large: triangles that
// follow each other mostly lie beside each other.
class Fits {
 public:
    Fits(const Cloth& cloth, Level level, FitScratch& scratch) : cloth_(cloth), level_(level), scratch_(scratch) {
        scratch_.index_of.resize(cloth.mesh.triangles().capacity(), kNoBlockSlot);
    }
    ~Fits() { forget(); }
    Fits(const Fits&) = delete;
    Fits& operator=(const Fits&) = delete;

    Mat3d curvature_map(const Neighbourhood& own, TriangleId t) {
        constexpr std::size_t kMostKept = 4096;  // 1.5 MB
        if (scratch_.fits.size() >= kMostKept) forget();
        const std::uint32_t here = index_of(t);
        std::array<std::uint32_t, 3> places{};
        for (std::size_t i = 0; i < 3; ++i) {
            if (own.beside[i].triangle) places[i] = index_of(own.beside[i].triangle);
        }
        std::array<FitBeside, 3> around;  // pointers are safe now: scratch_.fits does not grow any more
        for (std::size_t i = 0; i < 3; ++i) {
            const Beside& other = own.beside[i];
            if (other.triangle) around[i] = {&scratch_.fits[places[i]], other.edge, other.right_wrong};
        }
        return selvedge::sim::curvature_map(scratch_.fits[here], around);
    }

 private:
    std::uint32_t index_of(TriangleId t) {
        std::uint32_t& place = scratch_.index_of[t.value];
        if (place == kNoBlockSlot) {
            place = static_cast<std::uint32_t>(scratch_.fits.size());
            scratch_.made.push_back(t);
            scratch_.fits.push_back(fit_curvature(neighbourhood(cloth_, t, level_).rest));
        }
        return place;
    }
    void forget() {
        for (const TriangleId t : scratch_.made) scratch_.index_of[t.value] = kNoBlockSlot;
        scratch_.made.clear();
        scratch_.fits.clear();
    }
    const Cloth& cloth_;
    Level level_;
    FitScratch& scratch_;
};

void set_symmetric(std::array<BlockFloats, 6>& rows, std::size_t at, const Mat3d& matrix) {
    constexpr Eigen::Index kPlaces[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
    for (std::size_t i = 0; i < 6; ++i) rows[i][at] = static_cast<float>(matrix(kPlaces[i][0], kPlaces[i][1]));
}

void set_shape(BendBlock& block, std::size_t at, const RestTriangle& rest, const Mat3d& map) {
    for (std::size_t i = 0; i < 3; ++i) {
        const std::optional<HingeSide>& beyond = rest.beyond[i];
        const HingeSide own = rest.own_side(i);
        block.own[i][at] = beyond ? static_cast<float>(1 / own.height) : 0.0F;
        block.beyond[i][at] = beyond ? static_cast<float>(1 / beyond->height) : 0.0F;
        block.own_foot[i][at] = static_cast<float>(own.foot);
        block.beyond_foot[i][at] = beyond ? static_cast<float>(beyond->foot) : 0.0F;
        for (std::size_t k = 0; k < 3; ++k) {
            const double c = map(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i));
            block.map[3 * k + i][at] = static_cast<float>(c);
        }
    }
}

// Sets the values that follow from the fabric and the shape at rest.
void set_element(const Cloth& cloth, TriangleId t, Level level, Fits& fits, BendBlock& block, BendRecord& record,
                 std::size_t at) {
    constexpr double kMinRigidity = 1e-12;  // N m: minimum rigidity; a fabric without more has no friction in bending
    const AdaptiveTriangle& triangle = cloth.mesh.triangle(t);
    const Fabric& fabric = cloth.material.fabrics[triangle.panel];
    const Neighbourhood own = neighbourhood(cloth, t, level);
    const Mat3d map = fits.curvature_map(own, t);
    set_shape(block, at, own.rest, map);

    const double warp = std::max(fabric.bending_warp, kMinRigidity), weft = std::max(fabric.bending_weft, kMinRigidity);
    const Vec3d rigidity(warp, weft, 0.5 * std::sqrt(warp * weft));
    const double hysteresis = fabric.bending_hysteresis;
    const Vec3d friction(0.5 * hysteresis, 0.5 * hysteresis, 0.25 * hysteresis);
    const double time = double(cloth.substep) * double(cloth.substep) * own.rest.area();
    set_symmetric(record.stiffness, at, time * map.transpose() * free_edge_rigidity(rigidity, own.rest) * map);
    set_values(record.rigidity, at, (time * rigidity).cast<float>());
    set_values(record.friction, at, (time * friction).cast<float>());
    block.has_friction[at] = hysteresis > 0 && std::max(warp, weft) > kMinRigidity ? 1.0F : 0.0F;
    const ParentOf& parent = cloth.solver->lists.parent_of[t.value];
    record.parent[at] = parent.offset;
    record.of_area[at] = parent.of_area;
    record.requested[at] = level == Level::Leaves ? 1.0F : 0.0F;
}

// The bending constraints of leaves, or of the refined triangles of one level.
template <class Block>
struct BendLists {
    ConstraintSet<Block, BendRecord>& bend;
    Level level;

    void set(Cloth& cloth, TriangleId t, std::uint32_t slot, const Points& points, Fits& fits) const {
        Block& block = bend.blocks[slot / kBlock];
        const std::size_t at = slot % kBlock;
        for (std::size_t i = 0; i < 6; ++i) block.vertices[i][at] = 4 * points[i];
        set_element(cloth, t, level, fits, block, bend.records[slot / kBlock], at);
        const SavedBend kept = saved_bend_of(cloth, t);
        block.realised[at] = kept.is_known ? 1.0F : 0.0F;
        const bool starts = !kept.is_known && level == Level::Leaves;
        set_values(block.anchor, at, starts ? curvature_now(cloth, block, at) : kept.anchor);
    }
    void insert(Cloth& cloth, TriangleId t, Fits& fits) const {
        const Points points = points_about(cloth.mesh, t, level).points;
        bend.insert(t, points, cloth.solver->lists.vertices,
                    [&](std::uint32_t slot) { set(cloth, t, slot, points, fits); });
    }
    // For a triangle with the same shape and vertices as before, but with changed neighbours.
    void reshape(const Cloth& cloth, TriangleId t, Fits& fits) const {
        const std::uint32_t slot = bend.slot_of(t);
        set_element(cloth, t, level, fits, bend.blocks[slot / kBlock], bend.records[slot / kBlock], slot % kBlock);
        bend.dirty.mark_slot(slot);
    }
};

BendLists<BendBlock> leaf_lists(SolverState& solver) {
    return {solver.constraints.bend, Level::Leaves};
}
BendLists<CoarseBendBlock> refined_lists(SolverState& solver, int level) {
    return {solver.constraints.parents[static_cast<std::size_t>(level)].bend, Level::Refined};
}

void erase(Cloth& cloth, TriangleId t) {
    Constraints& constraints = cloth.solver->constraints;
    const auto remove_from = [&](auto& bend) {
        if (bend.slot_of(t) == kNoBlockSlot) return;
        save_bend(cloth, t);
        bend.remove(t, cloth.solver->lists.vertices);
    };
    remove_from(constraints.bend);
    for (ParentLevel& level : constraints.parents) remove_from(level.bend);
}

// Triangles that an adaptation affects, each listed once. moved: their six vertices may have changed; reshaped: only
// their curvature map may have.
class Touched {
 public:
    explicit Touched(TouchedScratch& scratch)
        : moved(scratch.moved), reshaped(scratch.reshaped), marks_(scratch.marks) {}
    ~Touched() {
        for (std::vector<TriangleId>* list : {&moved, &reshaped}) {
            for (const TriangleId t : *list) marks_[t.value] = 0;
            list->clear();
        }
    }
    Touched(const Touched&) = delete;
    Touched& operator=(const Touched&) = delete;

    void add_moved(TriangleId t) { add(t, moved); }
    void add_reshaped(TriangleId t) { add(t, reshaped); }

    std::vector<TriangleId>&moved, &reshaped;

 private:
    void add(TriangleId t, std::vector<TriangleId>& list) {
        if (marks_[t.value] != 0) return;
        marks_[t.value] = 1;
        list.push_back(t);
    }
    std::vector<std::uint8_t>& marks_;
};

void change_leaves(Cloth& cloth, const LeafChanges& changes) {
    const AdaptiveMesh& mesh = cloth.mesh;
    SolverState& solver = *cloth.solver;
    Touched touched(solver.lists.touched);
    for (const TriangleId t : changes.triangles_added) touched.add_moved(t);
    for (const std::vector<EdgeId>* edges : {&changes.edges_added, &changes.hinges_changed}) {
        for (const EdgeId e : *edges) {
            for (const int side : {0, 1}) {
                const TriangleId t = mesh.leaf_at(e, side);
                if (t) touched.add_moved(t);
            }
        }
    }
    for (const TriangleId t : touched.moved) {
        for (std::size_t i = 0; i < 3; ++i) {
            const TriangleId other = beside(mesh, t, i, Level::Leaves).triangle;
            if (other) touched.add_reshaped(other);
        }
    }
    const BendLists<BendBlock> lists = leaf_lists(solver);
    Fits fits(cloth, Level::Leaves, solver.lists.fits);
    for (const TriangleId t : touched.moved) erase(cloth, t);
    for (const TriangleId t : touched.moved) lists.insert(cloth, t, fits);
    for (const TriangleId t : touched.reshaped) lists.reshape(cloth, t, fits);
}

// The neighbour of a refined triangle at its level may be a leaf, a refined triangle, or an irregular inner triangle.
void change_refined(Cloth& cloth, const LeafChanges& changes) {
    const AdaptiveMesh& mesh = cloth.mesh;
    SolverState& solver = *cloth.solver;
    Touched touched(solver.lists.touched);
    const auto is_refined = [&](TriangleId t) { return t && !is_leaf(mesh.triangle(t)); };
    const auto for_beside = [&](TriangleId t, const auto& act) {
        for (std::size_t i = 0; i < 3; ++i) {
            const TriangleId other = beside(mesh, t, i, Level::Refined).triangle;
            const TriangleId inside = beside(mesh, t, i, Level::Leaves).triangle;  // t is its neighbour as well
            if (other) act(other);
            if (inside && inside != other) act(inside);
        }
    };
    const auto for_new = [&](const auto& act) {
        for (const TriangleId t : changes.triangles_added) act(t);
        for (const TriangleId t : changes.refined_changed) {
            if (is_refined(t)) act(t);
        }
    };
    const auto move_refined = [&](TriangleId t) {
        if (is_refined(t)) touched.add_moved(t);
    };
    const auto reshape_refined = [&](TriangleId t) {
        if (is_refined(t)) touched.add_reshaped(t);
    };
    for_new([&](TriangleId t) {
        move_refined(t);
        for_beside(t, move_refined);
    });
    for_new([&](TriangleId t) { for_beside(t, [&](TriangleId other) { for_beside(other, reshape_refined); }); });
    Fits fits(cloth, Level::Refined, solver.lists.fits);
    for (const TriangleId t : touched.moved) erase(cloth, t);
    for (const TriangleId t : touched.moved) refined_lists(solver, mesh.triangle(t).level).insert(cloth, t, fits);
    for (const TriangleId t : touched.reshaped) refined_lists(solver, mesh.triangle(t).level).reshape(cloth, t, fits);
}

void size_lists(SolverState& solver, const AdaptiveMesh& mesh) {
    const std::size_t capacity = mesh.triangles().capacity();
    solver.lists.touched.marks.resize(capacity, 0);
    solver.lists.requested.resize(capacity + 1, 0.0F);
}

}  // namespace

void make_bending(Cloth& cloth) {
    SolverState& solver = *cloth.solver;
    const AdaptiveMesh& mesh = cloth.mesh;
    size_lists(solver, mesh);
    FitScratch& scratch = solver.lists.fits;
    const auto make = [&](const auto& lists, const auto& triangles, const auto& id_of) {
        Fits fits(cloth, lists.level, scratch);
        const auto points_of = [&](const auto& item) { return points_about(mesh, id_of(item), lists.level).points; };
        lists.bend.make(triangles, solver.lists.vertices, id_of, points_of, [&](const auto& item, std::uint32_t slot) {
            lists.set(cloth, id_of(item), slot, points_of(item), fits);
        });
    };
    make(leaf_lists(solver), mesh.leaf_triangles(), [](const LeafTriangle& leaf) { return leaf.triangle; });
    for (int level = 0; level < mesh.max_level(); ++level) {
        make(refined_lists(solver, level), mesh.refined_triangles(level), std::identity{});
    }
}

void change_bending(Cloth& cloth, const LeafChanges& changes) {
    size_lists(*cloth.solver, cloth.mesh);
    for (const TriangleId t : changes.triangles_removed) erase(cloth, t);
    for (const TriangleId t : changes.refined_changed) erase(cloth, t);
    change_leaves(cloth, changes);
    change_refined(cloth, changes);
}

BendSlot bend_slot(const Cloth& cloth, TriangleId t) {
    const Constraints& constraints = cloth.solver->constraints;
    const std::array<std::uint32_t, 3> corners = indices(cloth.mesh.triangle(t).vertices);
    const auto slot_in = [&](const auto& bend) -> BendSlot {
        const std::uint32_t slot = bend.slot_of(t, corners);
        return slot == kNoBlockSlot ? BendSlot{} : BendSlot{&bend.blocks[slot / kBlock], slot % kBlock};
    };
    BendSlot slot = slot_in(constraints.bend);
    for (std::size_t level = 0; slot.block == nullptr && level < constraints.parents.size(); ++level) {
        slot = slot_in(constraints.parents[level].bend);
    }
    return slot;
}

Vec3f curvature_now(const Cloth& cloth, const BendBlock& block, std::size_t at) {
    const auto x = [&](std::size_t i) -> Vec3f { return cloth.x[block.vertices[i][at] / 4].head<3>(); };
    const Vec3f normal = (x(1) - x(0)).cross(x(2) - x(0)).normalized();
    Vec3f bent = Vec3f::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3f a = x((i + 1) % 3);
        const Vec3f apex = x(3 + i) - a;
        const Vec3f beyond = apex.cross(x((i + 2) % 3) - a).normalized();
        const float sine = apex.dot(normal) * block.beyond[i][at], cosine = beyond.dot(normal);
        const float half = sine / std::max(cosine + 1, kMinFold);
        const float angle = std::clamp((4 * half + sine) / 3, -kMaxFold, kMaxFold);
        bent += angle * Vec3f(block.map[i][at], block.map[3 + i][at], block.map[6 + i][at]);
    }
    return bent;
}

// Update of the gains and intervals of bending.

namespace {

void hand_up(SolverLists& lists, const std::vector<BendRecord>& records) {
    for (const BendRecord& record : records) {
        for (std::size_t at = 0; at < kBlock; ++at) {
            lists.requested[record.parent[at] / 4] += record.of_area[at] * record.passed_up[at];
        }
    }
}

}  // namespace

void update_bending_masses(Cloth& cloth, const Kernels& loops) {
    SolverState& solver = *cloth.solver;
    solver.constraints.bend.update_dirty_masses([&](auto blocks, auto records) {
        loops.update_bend_masses(blocks, records, solver.lists.inverse_masses.data());
    });
    std::fill(solver.lists.requested.begin(), solver.lists.requested.end(), 0.0F);
    hand_up(solver.lists, solver.constraints.bend.records);
}

// A refined triangle that starts to apply rigidity gets its present curvature as anchor, so that friction starts at
// zero. The anchors of a triangle without rigidity have no meaning, because a solve of its block may write them. They
// are cleared, so that the bits of a block do not depend on its history.
void update_coarse_bending_masses(Cloth& cloth, const Kernels& loops, int level) {
    SolverState& solver = *cloth.solver;
    ParentLevel& parents = solver.constraints.parents[static_cast<std::size_t>(level)];
    auto& bend = parents.bend;
    std::vector<std::uint32_t>& idle = solver.lists.idle_bends;
    idle.clear();
    for (const TriangleId t : cloth.mesh.refined_triangles(level)) {
        const std::uint32_t slot = bend.slot_of(t);
        float& requested = bend.records[slot / kBlock].requested[slot % kBlock];
        const float now = solver.lists.requested[stress_offset(t) / 4];
        if (requested != now) bend.dirty.mark_slot(slot);
        requested = now;
        if (bend.blocks[slot / kBlock].realised[slot % kBlock] <= 0) idle.push_back(slot);
    }
    const float* const masses = solver.lists.masses[static_cast<std::size_t>(level)].data();
    bend.update_dirty_masses(
        [&](auto blocks, auto records) { loops.update_coarse_bend_masses(blocks, records, masses); });
    for (const std::uint32_t slot : idle) {
        CoarseBendBlock& block = bend.blocks[slot / kBlock];
        const std::size_t at = slot % kBlock;
        if (block.realised[at] > 0) set_values(block.anchor, at, curvature_now(cloth, block, at));
    }
    parents.interval = kNeverSolved;
    for (const TriangleId t : cloth.mesh.refined_triangles(level)) {
        const std::uint32_t slot = bend.slot_of(t);
        CoarseBendBlock& block = bend.blocks[slot / kBlock];
        if (block.realised[slot % kBlock] <= 0) set_values(block.anchor, slot % kBlock, Vec3f::Zero());
        parents.interval = std::min(parents.interval, block.interval[slot % kBlock]);
    }
    hand_up(solver.lists, bend.records);
}

}  // namespace selvedge::sim

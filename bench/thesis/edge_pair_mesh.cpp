#include "bench/thesis/edge_pair_mesh.h"

#include <map>
#include <utility>

#include "bench/support/cloth_run.h"
#include "bench/support/measured_mesh.h"
#include "bench/thesis/thesis.h"
#include "sim/core/assert.h"
#include "sim/mesh/square.h"

namespace selvedge::bench {
namespace {

void make_twins(HalfEdge* a, HalfEdge* b) {
    a->twin = b;
    b->twin = a;
}

}  // namespace

EdgePairMesh::EdgePairMesh(const sim::GarmentMesh& base) : levels_(1), vertex_count_(base.x.size()) {
    for (std::size_t v = 0; v < base.x.size(); ++v) base_vertices_.push_back(store_.make<PairVertex>());
    std::map<std::pair<int, int>, HalfEdge*> first_half;
    for (const sim::GarmentTriangle& source : base.triangles) {
        auto* const t = store_.make<PairTriangle>();
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = source.vertices[k], b = source.vertices[(k + 1) % 3];
            t->vertices[k] = base_vertices_[static_cast<std::size_t>(a)];
            t->u[k] = source.u[k].cast<float>();
            const auto length = static_cast<float>((source.u[(k + 1) % 3] - source.u[k]).norm());
            HalfEdge* const half = make_half(t->vertices[k], length, 0, levels_[0]);
            half->triangle = t;
            t->edges[k] = half;
            HalfEdge*& other = first_half[std::minmax(a, b)];
            if (other != nullptr) make_twins(half, other);
            other = half;
            t->vertices[k]->add(t);
        }
        levels_[0].triangles.push_back(t);
    }
}

EdgePairMesh::~EdgePairMesh() {
    while (level() > 0) coarsen();
    for (PairTriangle* t : levels_[0].triangles) store_.drop(t);
    for (HalfEdge* e : levels_[0].edges) store_.drop(e);
    for (PairVertex* v : base_vertices_) store_.drop(v);
}

std::size_t EdgePairMesh::half_edge_count() const {
    std::size_t count = 0;
    for (const Level& level : levels_) count += level.edges.size();
    return count;
}

std::size_t EdgePairMesh::edge_count() const {
    std::size_t twins = 0;
    for (const Level& level : levels_) {
        for (const HalfEdge* half : level.edges) twins += half->twin != nullptr ? 1 : 0;
    }
    return half_edge_count() - twins / 2;
}

std::size_t EdgePairMesh::triangle_count() const {
    std::size_t count = 0;
    for (const Level& level : levels_) count += level.triangles.size();
    return count;
}

void EdgePairMesh::refine() {
    Level finer;
    Level& last = levels_.back();
    finer.edges.reserve(2 * last.edges.size() + 6 * last.triangles.size());
    finer.triangles.reserve(4 * last.triangles.size());
    for (HalfEdge* half : last.edges) split(half, finer);
    for (PairTriangle* t : last.triangles) fill(t, finer);
    levels_.push_back(std::move(finer));
}

void EdgePairMesh::coarsen() {
    SELVEDGE_ASSERT(level() > 0);
    levels_.pop_back();
    Level& last = levels_.back();
    for (std::size_t i = last.triangles.size(); i-- > 0;) clear(last.triangles[i]);
    for (std::size_t i = last.edges.size(); i-- > 0;) {
        HalfEdge* const half = last.edges[i];
        store_.drop(half->children[1]);
        store_.drop(half->children[0]);
        PairVertex* const centre = std::exchange(half->centre, nullptr);
        if (half->twin != nullptr && half->twin->centre != nullptr) continue;  // the second of the pair drops it
        store_.drop(centre);
        --vertex_count_;
    }
}

HalfEdge* EdgePairMesh::make_half(PairVertex* start, float rest_length, int level, Level& finer) {
    auto* const half = store_.make<HalfEdge>();
    half->start = start;
    half->rest_length = rest_length;
    half->level = level;
    finer.edges.push_back(half);
    return half;
}

// The second half of a pair to be split takes the centre of the first, and their children become twins crosswise.
void EdgePairMesh::split(HalfEdge* half, Level& finer) {
    HalfEdge* const twin = half->twin;
    const bool is_second = twin != nullptr && twin->centre != nullptr;
    if (is_second) {
        half->centre = twin->centre;
    } else {
        half->centre = store_.make<PairVertex>();
        ++vertex_count_;
    }
    const float length = 0.5F * half->rest_length;
    half->children[0] = make_half(half->start, length, half->level + 1, finer);
    half->children[1] = make_half(half->centre, length, half->level + 1, finer);
    if (!is_second) return;
    make_twins(half->children[0], twin->children[1]);
    make_twins(half->children[1], twin->children[0]);
}

// Children as in PointerMesh: child k is at vertex k, child 3 is in the middle. Internal pair k is opposite vertex k.
void EdgePairMesh::fill(PairTriangle* parent, Level& finer) {
    std::array<PairVertex*, 3> m;
    std::array<Vec2f, 3> mu{Vec2f::Zero(), Vec2f::Zero(), Vec2f::Zero()};
    for (std::size_t k = 0; k < 3; ++k) {
        parent->vertices[k]->remove(parent);
        m[k] = parent->edges[k]->centre;
        mu[k] = 0.5F * (parent->u[k] + parent->u[(k + 1) % 3]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t l = (k + 2) % 3;
        const float length = (mu[k] - mu[l]).norm();
        HalfEdge* const outer = make_half(m[k], length, parent->level + 1, finer);
        HalfEdge* const inner = make_half(m[l], length, parent->level + 1, finer);
        make_twins(outer, inner);
        parent->internal_edges[2 * k] = outer;      // of child k
        parent->internal_edges[2 * k + 1] = inner;  // of child 3
    }
    for (std::size_t k = 0; k < 4; ++k) {
        auto* const t = store_.make<PairTriangle>();
        const std::size_t l = (k + 2) % 3;
        t->level = parent->level + 1;
        if (k < 3) {
            t->vertices = {parent->vertices[k], m[k], m[l]};
            t->u = {parent->u[k], mu[k], mu[l]};
            t->edges = {parent->edges[k]->children[0], parent->internal_edges[2 * k], parent->edges[l]->children[1]};
        } else {
            t->vertices = m;
            t->u = mu;
            t->edges = {parent->internal_edges[3], parent->internal_edges[5], parent->internal_edges[1]};
        }
        for (std::size_t c = 0; c < 3; ++c) {
            t->vertices[c]->add(t);
            t->edges[c]->triangle = t;
        }
        parent->internal_triangles[k] = t;
        finer.triangles.push_back(t);
    }
}

void EdgePairMesh::clear(PairTriangle* parent) {
    for (std::size_t k = 4; k-- > 0;) {
        PairTriangle* const t = std::exchange(parent->internal_triangles[k], nullptr);
        for (PairVertex* v : t->vertices) v->remove(t);
        store_.drop(t);
    }
    for (std::size_t k = 6; k-- > 0;) store_.drop(std::exchange(parent->internal_edges[k], nullptr));
    for (PairVertex* v : parent->vertices) v->add(parent);
}

// Listing 3.1: the cost of both designs.

namespace {

// Reads the vertices opposite every finest edge, as bending does. Returns how many there are.

template <class Triangle, class Vertex>
const Vertex* opposite(const Triangle& t, const Vertex* a, const Vertex* b) {
    for (const Vertex* v : t.vertices) {
        if (v != a && v != b) return v;
    }
    return nullptr;
}

std::size_t read_opposites(const std::vector<PointerEdge*>& edges) {
    std::size_t sum = 0;
    for (const PointerEdge* edge : edges) {
        for (const PointerTriangle* side : edge->sides) {
            if (side == nullptr) continue;
            const PointerVertex* const a = edge->ends[0];
            const PointerVertex* const b = edge->ends[1];
            sum += opposite(*side, a, b) != nullptr ? 1 : 0;
        }
    }
    return sum;
}

// A half-edge does not store its end: it is the start of the next one in its triangle.
std::size_t read_opposites(const std::vector<HalfEdge*>& halves) {
    std::size_t sum = 0;
    for (const HalfEdge* half : halves) {
        const PairTriangle& t = *half->triangle;
        const std::size_t k = t.edges[0] == half ? 0 : (t.edges[1] == half ? 1 : 2);
        sum += t.vertices[(k + 2) % 3] != nullptr ? 1 : 0;
    }
    return sum;
}

struct EdgeCosts {
    std::vector<double> refining, coarsening, reading;  // s
};

template <class Mesh>
void run_once(Mesh& mesh, EdgeCosts& costs) {
    costs.refining.push_back(time_once([&] {
        while (mesh.level() < 3) mesh.refine();
    }));
    costs.reading.push_back(time_once([&] { keep(read_opposites(mesh.finest_edges())); }));
    costs.coarsening.push_back(time_once([&] {
        while (mesh.level() > 0) mesh.coarsen();
    }));
}

void add_row(Table& table, const char* name, std::size_t bytes_per_edge, std::size_t bytes, const EdgeCosts& costs) {
    const auto ms = [](const std::vector<double>& seconds) { return Cell(1e3 * timing_of(seconds).median, 4); };
    table.add_row({name, bytes_per_edge, bytes, ms(costs.refining), ms(costs.coarsening), ms(costs.reading)});
}

}  // namespace

ThesisResult measure_edge_pair(const ThesisOptions& options) {
    const int quads = options.is_quick ? 4 : 16;
    const sim::GarmentMesh base = sim::make_square({.columns = quads, .rows = quads});
    PointerMesh<Pools> trio(base);
    EdgePairMesh pair(base);
    while (trio.level() < 3) trio.refine();
    while (pair.level() < 3) pair.refine();
    const std::size_t trio_bytes = trio.edge_count() * sizeof(PointerEdge);
    const std::size_t pair_bytes = pair.half_edge_count() * sizeof(HalfEdge);
    while (trio.level() > 0) trio.coarsen();
    while (pair.level() > 0) pair.coarsen();
    EdgeCosts of_trio, of_pair;
    for (int i = 0; i < (options.is_quick ? 1 : 41); ++i) {
        run_once(trio, of_trio);
        run_once(pair, of_pair);
    }
    Table table{
        .name = "listing-3.1",
        .title = "Edge-Pair beside Edge-Trio: " + std::to_string(base.triangles.size()) + " triangles at level 3",
        .note =
            "Both with 64-bit pointers and elements from pools. An Edge-Pair is two half-edges, so that an "
            "inner edge stores twice what its sides share. Refinement from level 0 to 3 and back; reading: the "
            "vertices opposite all finest edges, as bending does. CPU time of one thread, median of runs.",
        .columns = {"structure", "one inner edge, bytes", "all edges at level 3, bytes", "refine, ms", "coarsen, ms",
                    "read opposite vertices, ms"}};
    add_row(table, "Edge-Trio", sizeof(PointerEdge), trio_bytes, of_trio);
    add_row(table, "Edge-Pair", 2 * sizeof(HalfEdge), pair_bytes, of_pair);
    return {
        .tables = {table},
        .trends = {
            {.item = "L3.1",
             .reported = "the Edge-Trio stores once what both sides of an edge share.",
             .measured = "the edges of the Edge-Trio take " +
                         Cell(100.0 * static_cast<double>(trio_bytes) / static_cast<double>(pair_bytes), 0).to_text() +
                         " % of the memory of the Edge-Pair's.",
             .agrees = trio_bytes < pair_bytes}}};
}

}  // namespace selvedge::bench

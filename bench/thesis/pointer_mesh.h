#pragma once
// The baseline for the adaptive mesh: elements linked by pointers, and a fixed list of up to 20 triangles in each
// vertex, as in the thesis. It has only the states S0 and S7 and refines or coarsens the whole mesh at once, without
// criteria, permissions or other transitions. The template parameter Store allocates the elements: with new and delete,
// or from pools. (thesis 3.5.1, 3.8.1, tables 3.7-3.10)
#include <algorithm>
#include <array>
#include <memory>
#include <tuple>
#include <vector>

#include "sim/core/math.h"
#include "sim/mesh/garment_mesh.h"

namespace selvedge::bench {

struct PointerTriangle;

struct PointerVertex {
    std::array<PointerTriangle*, 20> triangles{};
    int triangle_count = 0;

    void add(PointerTriangle* t) { triangles[static_cast<std::size_t>(triangle_count++)] = t; }
    void remove(PointerTriangle* t) {
        auto* const end = triangles.begin() + triangle_count;
        *std::find(triangles.begin(), end, t) = *(end - 1);
        --triangle_count;
    }
};

struct PointerEdge {
    std::array<PointerVertex*, 2> ends{};
    PointerVertex* centre = nullptr;
    std::array<PointerEdge*, 2> children{};
    std::array<PointerTriangle*, 2> sides{};
    float rest_length = 0;
    int level = 0;
};

struct PointerTriangle {
    std::array<PointerVertex*, 3> vertices{};
    std::array<PointerEdge*, 3> edges{};  // edges[k] joins vertices[k] and vertices[k+1]
    std::array<PointerTriangle*, 4> internal_triangles{};
    std::array<PointerEdge*, 3> internal_edges{};
    std::array<Vec2f, 3> u{Vec2f::Zero(), Vec2f::Zero(), Vec2f::Zero()};
    int level = 0;
};

class NewDelete {
 public:
    template <class T>
    T* make() {
        return new T;
    }
    template <class T>
    void drop(T* element) {
        delete element;
    }
};

// Memory pools: blocks of elements, and a stack of free elements.
class Pools {
 public:
    template <class T>
    T* make() {
        Pool<T>& pool = std::get<Pool<T>>(pools_);
        if (pool.free.empty()) pool.grow();
        T* const element = pool.free.back();
        pool.free.pop_back();
        *element = T{};
        return element;
    }
    template <class T>
    void drop(T* element) {
        std::get<Pool<T>>(pools_).free.push_back(element);
    }

 private:
    template <class T>
    struct Pool {
        static constexpr std::size_t kBlock = 1024;
        std::vector<std::unique_ptr<T[]>> blocks;
        std::vector<T*> free;

        void grow() {
            blocks.push_back(std::make_unique<T[]>(kBlock));
            for (std::size_t i = kBlock; i > 0; --i) free.push_back(&blocks.back()[i - 1]);
        }
    };
    std::tuple<Pool<PointerVertex>, Pool<PointerEdge>, Pool<PointerTriangle>> pools_;
};

template <class Store>
class PointerMesh {
 public:
    explicit PointerMesh(const sim::GarmentMesh& base);
    ~PointerMesh();
    PointerMesh(const PointerMesh&) = delete;
    PointerMesh& operator=(const PointerMesh&) = delete;

    int level() const { return static_cast<int>(levels_.size()) - 1; }
    void refine();   // all leaves from S0 to S7
    void coarsen();  // all finest triangles back, S7 to S0. Pre: level() > 0

    // Of the whole hierarchy.
    std::size_t vertex_count() const { return vertex_count_; }
    std::size_t edge_count() const;
    std::size_t triangle_count() const;

 private:
    struct Level {
        std::vector<PointerEdge*> edges;
        std::vector<PointerTriangle*> triangles;
    };

    PointerEdge* make_edge(PointerVertex* a, PointerVertex* b, float rest_length, int level);
    void split(PointerEdge* edge, Level& finer);
    void fill(PointerTriangle* parent, Level& finer);
    void clear(PointerTriangle* parent);

    Store store_;
    std::vector<PointerVertex*> base_vertices_;
    std::vector<Level> levels_;
    std::size_t vertex_count_ = 0;
};

extern template class PointerMesh<NewDelete>;
extern template class PointerMesh<Pools>;

}  // namespace selvedge::bench

#pragma once
// The baseline for the adaptive mesh: elements linked by pointers, and a fixed list of up to 20 triangles in each
// vertex, as in the thesis. It has only the states S0 and S7 and refines or coarsens the whole mesh at once, without
// criteria, permissions or other transitions. The template parameter Store allocates the elements: with new and delete,
// or from pools. (thesis 3.5.1, 3.8.1, tables 3.7-3.10)
#include <algorithm>
#include <array>
#include <memory>
#include <new>
#include <tuple>
#include <type_traits>
#include <vector>

#include "sim/core/math.h"
#include "sim/mesh/garment_mesh.h"

namespace selvedge::bench {

struct PointerTriangle;

template <class Triangle>
struct VertexOf {
    std::array<Triangle*, 20> triangles{};
    int triangle_count = 0;

    void add(Triangle* t) { triangles[static_cast<std::size_t>(triangle_count++)] = t; }
    void remove(Triangle* t) {
        auto* const end = triangles.begin() + triangle_count;
        *std::find(triangles.begin(), end, t) = *(end - 1);
        --triangle_count;
    }
};
using PointerVertex = VertexOf<PointerTriangle>;

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

// Memory pools: blocks of elements, and a stack of pointers to the free ones.  (thesis 3.5.1, listing 3.11)
template <class... Elements>
class PoolsOf {
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
    std::tuple<Pool<Elements>...> pools_;
};

// List-based memory pools: the free elements form a linked list that runs through their own memory, so that no list of
// pointers is kept beside them. This is our reading of thesis 3.5.2, of which only the title is known to us.
template <class... Elements>
class ListPoolsOf {
 public:
    template <class T>
    T* make() {
        Pool<T>& pool = std::get<Pool<T>>(pools_);
        if (pool.first == nullptr) pool.grow();
        Slot<T>* const slot = pool.first;
        pool.first = slot->next;
        return ::new (static_cast<void*>(&slot->element)) T{};
    }
    template <class T>
    void drop(T* element) {
        Pool<T>& pool = std::get<Pool<T>>(pools_);
        auto* const slot = reinterpret_cast<Slot<T>*>(element);
        slot->next = pool.first;
        pool.first = slot;
    }

 private:
    template <class T>
    union Slot {
        static_assert(std::is_trivially_destructible_v<T>);
        Slot() : next(nullptr) {}
        ~Slot() {}
        Slot* next;
        T element;
    };
    template <class T>
    struct Pool {
        static constexpr std::size_t kBlock = 1024;
        std::vector<std::unique_ptr<Slot<T>[]>> blocks;
        Slot<T>* first = nullptr;

        void grow() {
            blocks.push_back(std::make_unique<Slot<T>[]>(kBlock));
            for (std::size_t i = kBlock; i > 0; --i) {
                blocks.back()[i - 1].next = first;
                first = &blocks.back()[i - 1];
            }
        }
    };
    std::tuple<Pool<Elements>...> pools_;
};

using Pools = PoolsOf<PointerVertex, PointerEdge, PointerTriangle>;
using ListPools = ListPoolsOf<PointerVertex, PointerEdge, PointerTriangle>;

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

    const std::vector<PointerEdge*>& finest_edges() const { return levels_.back().edges; }

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
extern template class PointerMesh<ListPools>;

}  // namespace selvedge::bench

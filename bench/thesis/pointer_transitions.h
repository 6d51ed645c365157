#pragma once
// Transitions of single triangles on the thesis' structure: elements linked by pointers, adjacent triangles listed in
// each vertex. A triangle goes to the cleared state SC, in which neither it nor anything inside it is a leaf, and from
// SC to any configuration.  (thesis 3.3.4, table 3.2)
#include <vector>

#include "bench/thesis/pointer_mesh.h"
#include "sim/adaptive/configuration.h"

namespace selvedge::bench {

// The base triangles of a mesh whose edges are all split, so that each can take any configuration. Starts in SC.
class PointerTransitions {
 public:
    explicit PointerTransitions(const sim::GarmentMesh& base);
    ~PointerTransitions();
    PointerTransitions(const PointerTransitions&) = delete;
    PointerTransitions& operator=(const PointerTransitions&) = delete;

    std::size_t size() const { return triangles_.size(); }

    void configure_all(sim::Configuration to);  // pre: all are in SC
    void clear_all();                           // pre: none is in SC

    // Triangles that vertices list as adjacent, summed over the vertices: three for each leaf.
    std::size_t adjacency_count() const;

 private:
    struct Parent {
        PointerTriangle triangle;
        sim::Configuration configuration = sim::Configuration::C0;
    };
    void configure(Parent& parent, sim::Configuration to);
    void clear(Parent& parent);
    PointerVertex* point(const PointerTriangle& t, sim::LocalPoint p) const;
    PointerEdge* edge(const PointerTriangle& t, sim::LocalEdge e) const;

    Pools store_;
    std::vector<PointerVertex*> vertices_;  // of the base, then the centres
    std::vector<PointerEdge*> edges_;       // of the base, then the children
    std::vector<Parent> triangles_;
};

}  // namespace selvedge::bench

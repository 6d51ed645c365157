#pragma once
// Elastics along edges of panels (OutlineEdge::elastic): each edge of the mesh on such a line is a spring with the
// energy 1/2 k (l - r)^2 / r where it is longer than its rest length r = share L, and none where it is slack. L is its
// length in the panel, so that a line is as stiff however it is refined.
//
// Springs that follow one another are solved together, by one step of implicit Euler (Baraff and Witkin 1998) from
// where the sub-step began. The vertices of a hem weigh so little that springs which were solved one by one would be
// softer the finer the mesh, and that a tension which kept its direction within a sub-step would make the line flutter.
// A vertex that the body holds does not give way into it; if it did, an elastic round a body would pull less than it
// should. The body is given a share of what presses on it: enough for friction, and cloth comes to rest.
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "sim/core/math.h"
#include "sim/pattern/pattern.h"
#include "sim/simulation/cloth_constraint.h"

namespace selvedge::sim {

bool has_elastics(const Pattern& pattern);

class ElasticBands : public ClothConstraint {
 public:
    // Of the panels of this pattern, in whatever cloth of them: sewn or not, all or some.
    explicit ElasticBands(const Pattern& pattern);

    std::unique_ptr<ClothConstraint> copy() const override { return std::make_unique<ElasticBands>(*this); }
    void make(const Cloth& cloth) override;
    void begin_step(const Cloth& cloth, const Collider& body, const StepOptions& stepping) override;
    void solve(float* points, const float* before) override;
    bool is_at_rest() const override;

    // N, of each leaf edge on that line as it lies, once it was drawn in. Pre: make() has seen this mesh.
    std::vector<float> tensions(const Cloth& cloth, int panel, int edge) const;

 private:
    struct Band {
        int panel = 0, edge = 0;
        float share = 1, stiffness = 0;  // N
        float drawn_to = 0;              // share of its length that it has now; 0: it is in no cloth yet
    };
    struct Spring {
        std::array<std::uint32_t, 2> ends{};
        std::uint32_t band = 0;
        float length = 0;  // m, in the panel
    };
    // Springs, each from where the one before ends. Their ends are its nodes; a ring has as many as it has springs.
    struct Chain {
        std::uint32_t first = 0, count = 0;
        bool is_ring = false;
    };
    // How the body holds a vertex: its unit normal; zero if it does not.
    using Held = Vec3f;
    struct Node {
        std::uint32_t vertex = 0;
        Vec3d held;                 // Held
        Vec3d drive;                // N, of its motion before; then with the springs' forces
        Eigen::Matrix3d stiffness;  // row of the system: with itself ...
        Eigen::Matrix3d next;       // ... with the next node ...
        Eigen::Matrix3d last;       // ... and with the last one, as far as that is another
        Vec3d force, way;           // right side; solution: m in this sub-step
    };
    struct Pull {
        Vec3d force = Vec3d::Zero();                          // N, on the first end
        Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();  // N/m, minus its change per way of the first end
    };

    void chain_up(std::vector<Spring> loose);
    void set_up(const Chain& chain, const float* points, const float* before);
    void solve_nodes();
    bool lift_off(const Chain& chain);
    void apply(const Chain& chain, float* points) const;
    void push(const Node& node, const Vec3d& force, float* points) const;
    float rest_length(const Spring& spring) const;

    std::vector<Band> bands_;
    std::vector<Spring> springs_;
    std::vector<Chain> chains_;
    std::vector<std::array<Held, 2>> held_;  // by spring and end
    float pressing_ = 0;                     // share of what presses on the body that it is given
    float substep_ = 0;                      // s
    float per_mass_ = 0;                     // 1/s^2, inertia of a sub-step per mass: compliance_of_spring() of 1 N/m

    // Scratch of solve(), of a chain.
    std::vector<Node> nodes_;
    std::vector<Pull> pulls_;      // by spring
    std::vector<bool> is_lifted_;  // by node: it leaves the body that held it
};

}  // namespace selvedge::sim

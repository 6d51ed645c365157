#pragma once
// Flesh that gives way. A skin follows its bones without regard to the rest of the body: an arm that is lowered cuts
// the trunk, and cloth between them has no place. Where two sides of a surface overlap, or leave less room than two
// layers of cloth need, both go back: what is missing is shared as springs in series share it, in proportion to their
// thickness, so that a thumb dents a thigh.
//
//        trunk |   ( arm                trunk )(  arm
//              | (                            )(            The contact of implicit skinning (Vaillant et al. 2013),
//              (                 ->           )(            with the distance to the other side by implicit moving
//              | (                            )(            least squares (Kolluri 2005).
//              |   (                          )(
//
// The surface in which the skin was bound stays as it is: two sides of it that face each other keep no more than the
// room that they have there.
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "sim/body/body.h"
#include "sim/body/skin.h"
#include "sim/core/math.h"
#include "sim/core/region.h"

namespace selvedge::sim {

struct PatchBounds;  // where the samples of a patch are

class YieldingFlesh {
 public:
    // Pre: the body has a skin.
    explicit YieldingFlesh(const Body& body);

    // x: the vertices of the skinned surface in a pose, m, in the order of Body::x. Changes little when x does; leaves
    // x as it is if it has numbers that are not finite. Flesh outside of the region (m) may stay as it is:
    // what is outside of it both where the surface was `before` (m; empty: where it is), and where it is now, less the
    // mean motion between.
    void give_way(std::vector<Vec3f>& x, const Region& region = {}, std::span<const Vec3f> before = {}) const;

 private:
    // A vertex of the surface that stands for those round it.
    struct Sample {
        std::uint32_t vertex = 0;
        Vec3f bind = Vec3f::Zero(), bind_normal = Vec3f::Zero();  // where the skin was bound: m, unit
        float thickness = 0;                                      // m, of the flesh below it, to the other side
        std::uint32_t triangles_begin = 0, triangles_end = 0;     // at the vertex, of around_
        std::uint32_t members_begin = 0, members_end = 0;         // of members_
    };
    // Whether, and how closely, two points may approach, from where the skin was bound.
    struct Relation {
        float weight = 0;  // 0 on two sides of the same flesh, as palm and back of a hand
        float room = 0;    // m, that is kept between them
    };
    struct Range {
        std::uint32_t begin = 0, end = 0;
    };
    struct Now;
    struct Found;
    using Pair = std::array<std::uint32_t, 2>;  // samples; the members of the first may have to go back

    void make_samples(const Body& body);
    void measure_thickness();
    void find_what_never_meets(const Body& body);
    std::vector<std::uint32_t> patches_near(const std::vector<Vec3f>& x, const Region& region,
                                            std::span<const Vec3f> before) const;
    std::vector<PatchBounds> bind_bounds() const;
    Relation relation(const Vec3f& a, const Sample& b) const;
    void place_samples(const std::vector<Vec3f>& x, std::span<const std::uint32_t> patches, Now& now) const;
    std::vector<Pair> find_pairs(const Now& now, std::span<const std::uint32_t> patches) const;
    void find_between(const Now& now, const Range& own, const Range& other, const PatchBounds& bounds,
                      std::vector<Pair>& pairs) const;
    void gather(const std::vector<Vec3f>& x, const Now& now, std::span<const Pair> pairs,
                std::vector<Found>& found) const;

    std::vector<Vec3f> bind_;  // of all vertices, m
    std::vector<std::array<std::uint32_t, 3>> around_;
    std::vector<std::uint32_t> members_;  // vertices by sample
    std::vector<Sample> samples_;
    std::vector<Range> patches_;    // of samples that are near each other and face about the same way
    std::vector<bool> never_meet_;  // by pair of patches
};

// The surface of a body: its skin, with flesh that gives way.
class FleshSurface {
 public:
    explicit FleshSurface(const Body& body) : skin_(body), flesh_(body) {}

    // The positions of all vertices in that pose, m, in the order of Body::x.
    void positions(const Body& body, const Pose& pose, std::vector<Vec3f>& x) const {
        skin_.positions(body, pose, x);
        flesh_.give_way(x);
    }
    const SkinnedSurface& skin() const { return skin_; }
    const YieldingFlesh& flesh() const { return flesh_; }

 private:
    SkinnedSurface skin_;
    YieldingFlesh flesh_;
};

// The same of a body that moves. Flesh is slow: how far it gives way is found at multiples of kFleshSeconds, and goes
// linearly between them.
class MovingFlesh {
 public:
    static constexpr double kFleshSeconds = 1.0 / 60;

    explicit MovingFlesh(const Body& body) : surface_(body) {}

    // pose_at: the pose at a time, s, of the same motion in each call, up to the next multiple of kFleshSeconds. Flesh
    // outside of the region (m) may stay as it is, as in give_way(), with the surface of the last call before.
    void positions(const Body& body, const std::function<Pose(double)>& pose_at, double seconds, const Region& region,
                   std::vector<Vec3f>& x);
    const FleshSurface& surface() const { return surface_; }

 private:
    struct Knot {
        long index = -1;
        std::vector<Vec3f> way;  // of each vertex, m
    };
    const Knot& knot(const Body& body, const std::function<Pose(double)>& pose_at, long index, const Region& region);

    FleshSurface surface_;
    std::array<Knot, 2> knots_;  // of even and odd indices
    std::vector<Vec3f> last_;    // positions that the last call gave, m
};

// A body in that pose, with flesh that gives way: its rest pose is the new one, so that everything that reads Body::x
// sees it there. Pre: it has a skin.
Body posed(const Body& body, const Pose& pose);
Body posed(const Body& body, const Pose& pose, const FleshSurface& surface);  // of that body: it takes long to prepare

}  // namespace selvedge::sim

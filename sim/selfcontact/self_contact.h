#pragma once
// Contact of cloth with itself and with other cloth, for any number of sheets: keeps vertices and triangles, and edges
// and edges, apart by the thickness of the cloth, with Coulomb friction.
//
// A detection finds all pairs that can touch while the vertices move as they do now. In each sub-step their contact
// planes are solved, after the constraints of the cloth and the body. The next detection waits until a vertex has left
// its expected path so far that an unknown pair could touch, and asks only the parts of the cloth that have such
// vertices; so cloth at rest needs none. Dividing planes then certify that no known pair went through each other. Where
// an unknown one did, the crossing is found by an exact test, and goes back along the way that it came. Cloth that
// crosses itself from the start is untangled by shortening the contours of intersection.
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "sim/selfcontact/crossings.h"
#include "sim/selfcontact/dividing_planes.h"
#include "sim/selfcontact/expected_paths.h"
#include "sim/selfcontact/moving_points.h"
#include "sim/selfcontact/options.h"
#include "sim/selfcontact/pair_search.h"
#include "sim/selfcontact/surface.h"
#include "sim/selfcontact/untangle.h"

namespace selvedge::sim {

struct SelfContactCounts {
    long steps = 0;
    long detections = 0;        // of the whole surface
    long local_detections = 0;  // of parts of it
    double asked = 0;           // share of the surface, sum over all detections
    long exact_tests = 0;       // of all pairs of triangles
    long local_tests = 0;
    long triangle_pairs = 0;  // sums over the detections
    long pairs = 0;
    long contacts = 0;  // sum over the refreshes
    long refreshes = 0;
    long acted = 0;  // contacts that moved something, sum over the sub-steps
    long parted = 0;
    long truncated = 0;
    long untangling_iterations = 0;
};

class SelfContact {
 public:
    // Replaces the surface, after an adaptation or a change of garment. A known clean state is kept for vertices that
    // stay; the next step starts with a detection.
    void set_surface(ContactSurface surface, std::size_t vertices);

    // A new vertex in the middle of an edge inherits the clean positions of its ends.
    void on_split(std::uint32_t centre, std::uint32_t a, std::uint32_t b);

    // Forgets all detections, for example after the vertices were moved from outside. Whether the cloth crosses itself
    // is then unknown.
    void forget();

    // By vertex, for the next step: whether a body presses cloth together there so that no place keeps it apart. Pairs
    // with such a vertex on both sides get no contact and may cross; where they did, they may until they do not. Empty:
    // none.
    void excuse(std::vector<std::uint8_t> is_pinched) { is_pinched_ = std::move(is_pinched); }

    // One step: begin_step(), then substep() as the last part of each sub-step, then end_step().
    void begin_step(const MovingPoints& points, const SelfContactOptions& options);
    void substep(const MovingPoints& points, const SelfContactOptions& options);
    void end_step(const MovingPoints& points, const SelfContactOptions& options);

    // The next detection tests for crossings, because the surface may have moved through itself between two steps.
    void doubt() { is_doubtful_ = true; }

    // Half of the distance from each vertex, and the elements at it, to the nearest known pair: by vertex, m. Two
    // surfaces that both move by less do not meet. Empty if there was no detection.
    std::vector<float> clearances(const MovingPoints& points) const;

    bool is_clean() const { return is_clean_; }  // whether the last exact test found no crossing
    const ContactSurface& surface() const { return surface_; }
    const SelfContactCounts& counts() const { return counts_; }

 private:
    // `from`: expected() of the points.
    void detect(const MovingPoints& points, const MovingPoints& from, const SelfContactOptions& options);
    void detect_where_off_path(const MovingPoints& points, const MovingPoints& from, float limit,
                               const SelfContactOptions& options);
    void list_pairs(const Sweep& sweep, const MovingPoints& points, const MovingPoints& from,
                    const SelfContactOptions& options);
    void look_for_crossings(const MovingPoints& points, const SelfContactOptions& options);
    bool has_new_crossing(const MovingPoints& points, const SelfContactOptions& options);
    std::vector<Crossing> crossings_of(std::span<const TrianglePair> pairs, const MovingPoints& points);
    void test_exactly(const MovingPoints& points);
    void find_suspects(const MovingPoints& points);
    void test_suspects(const MovingPoints& points);
    bool is_excused(std::uint32_t vertex) const;
    bool is_excused(const Crossing& crossing) const;
    void keep_excuses(std::span<const Crossing> crossings);
    void judge_sides();
    void judge_excused(PairList& pairs);
    void judge_sides(PairList& pairs, const std::vector<bool>& is_tangled, const std::vector<Vec3f>& normals);
    float facing(const PairBlock& block, std::size_t at, PairKind kind, const std::vector<Vec3f>& normals) const;
    bool is_ordered(const PairBlock& block, std::size_t at) const;
    float reach(const SelfContactOptions& options) const;
    void refresh(const MovingPoints& points, const MovingPoints& from, const SelfContactOptions& options);
    float most_swapped(const PairBlock& block, std::size_t at) const;
    void list_contacts(PairList& pairs, const MovingPoints& points, const SelfContactOptions& options);
    // Returns whether it moved a point.
    bool certify(const MovingPoints& points, const SelfContactOptions& options);
    void look_back(const MovingPoints& points, int substeps);
    MovingPoints expected(const MovingPoints& points);
    void untangle(const MovingPoints& points, const SelfContactOptions& options);
    void limit_clearances(const PairList& pairs, const MovingPoints& points, std::vector<float>& clearances) const;
    float thickest(const SelfContactOptions& options) const;
    void keep_clean_state(const MovingPoints& points);

    ContactSurface surface_;
    PairSearch search_;
    ContactPairs pairs_;
    SelfContactList contacts_;
    DividingPlanes dividers_;
    Untangler untangler_;
    std::vector<Crossing> crossings_;
    std::vector<std::uint8_t> is_pinched_;   // by vertex; see excuse()
    std::vector<std::uint8_t> was_excused_;  // by vertex: crosses other cloth since it was pinched
    std::vector<std::uint8_t> is_suspect_;   // by vertex: untangling has moved it since the last exact test
    std::vector<TrianglePair> suspects_;     // with such vertices

    std::vector<std::uint32_t> used_;     // vertices of the surface, ascending
    std::vector<int> layers_;             // by vertex, of its sheet
    bool has_layers_ = false;             // whether they differ
    std::vector<std::uint16_t> swapped_;  // by vertex: pairs on the wrong side
    ExpectedPaths paths_;
    std::vector<Vec4f> seen_;            // by vertex: position at the last look
    std::vector<Vec4f> mean_moves_;      // by vertex: mean displacement per sub-step between the last two looks, m
    std::vector<Vec4f> expected_;        // by vertex: position a sub-step ago, had it moved as is expected of it
    std::vector<Vec4f> start_;           // by vertex: position at the last detection
    Vec3f start_frame_ = Vec3f::Zero();  // the origin of the paths' frame then, m
    std::vector<Vec4f> clean_;           // by vertex: positions at the last clean exact test; empty: none yet
    std::vector<std::uint8_t> is_off_;   // by vertex: off its path
    int since_detection_ = 0;            // sub-steps
    int since_test_ = 0;                 // sub-steps since the last exact test of all
    bool has_detected_ = false;
    bool is_clean_ = false;
    bool is_doubtful_ = true;  // something moved farther than the known pairs cover
    SelfContactCounts counts_;
};

}  // namespace selvedge::sim

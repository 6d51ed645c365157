#pragma once
// Topology of the mannequin's control cage: its vertices and quads, derived from ring counts. Rings run around torso,
// legs, arms and thumbs and share vertices where parts meet (crotch, armhole, thumb), so no boolean operations are
// needed. The left half is listed; the right half is its mirror image. Also the positions of the
// mannequin's joints, and the subdivision of cages.
#include <array>
#include <cstddef>
#include <vector>

#include "sim/body/body.h"
#include "sim/body/joint_names.h"
#include "sim/core/math.h"

namespace selvedge::sim {

// Catmull-Clark subdivision of closed quad meshes with any number of values per vertex, so that positions and skin
// weights are subdivided together. (Catmull and Clark 1978; limit positions: Halstead, Kass, DeRose 1993)

using Quad = std::array<int, 4>;

// One row per vertex; the first three columns are its position.
using VertexRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct QuadMesh {
    VertexRows values;
    std::vector<Quad> quads;  // counter-clockwise seen from outside
};

// Pre: closed, every edge belongs to two quads. Post: four quads per quad; old vertices keep their indices, followed by
// the edges' vertices and the quads' vertices.
QuadMesh subdivide(const QuadMesh& mesh);

// Moves every vertex to its limit position under infinite subdivision.
void move_to_limit(QuadMesh& mesh);

// Two triangles per quad, split along the shorter diagonal.
std::vector<std::array<int, 3>> split_quads(const QuadMesh& mesh);

// Edges as vertex pairs, each once, in the order in which the quads first use them.
std::vector<std::array<int, 2>> quad_edges(const std::vector<Quad>& quads, int vertex_count);

enum class CagePart { Torso, Crown, Bridge, Leg, ToeCap, Arm, HandCap, Thumb, ThumbCap };
inline constexpr int kCagePartCount = 9;

// Ring counts. A torso row is half a ring: columns 0..12 from the front midline over the left side to the back midline.
struct CageCounts {
    static constexpr int kTorsoColumns = 13;
    static constexpr int kArmholeRow = 12;   // torso row at the armpit
    static constexpr int kArmholeRows = 3;   // quads omitted for the armhole, upward ...
    static constexpr int kArmholeFirst = 5;  // ... and between these columns
    static constexpr int kArmholeLast = 8;
    static constexpr int kShoulderTop = kArmholeRow + kArmholeRows;
    static constexpr int kNeckBase = kShoulderTop + 4;
    static constexpr int kNeckTop = kNeckBase + 2;
    static constexpr int kTorsoRows = kNeckTop + 7 + 1;
    static constexpr int kBridge = 3;     // points of the perineum between the legs
    static constexpr int kLegRing = 16;   // points: the torso's bottom row and the bridge
    static constexpr int kAnkleRow = 17;  // leg row at which the rings begin to fan out into the foot
    static constexpr int kLegRows = kAnkleRow + 4 + 5;
    static constexpr int kArmRing = 12;
    static constexpr int kShoulderFan = 2;  // arm rows that turn from the armhole towards the arm
    static constexpr int kHandRow = kShoulderFan + 7 + 7;
    static constexpr int kArmRows = kHandRow + 6;
    static constexpr int kThumbRow = kHandRow + 1;  // 2 x 2 quads are omitted from here and kThumbColumn - 1
    static constexpr int kThumbColumn = 11;
    static constexpr int kThumbRing = 8;
    static constexpr int kThumbRows = 3;
};

struct CageVertex {
    CagePart part;
    int row = 0;
    int column = 0;
    bool is_on_midplane = false;
};

struct Cage {
    std::vector<CageVertex> left;  // left half and midplane: vertices 0..left.size()-1
    std::vector<int> mirror;       // per left vertex: its mirror vertex; itself on the midplane
    std::vector<Quad> quads;       // of both halves, counter-clockwise seen from outside
    int vertex_count = 0;          // of both halves
};

// Within a part, vertices are numbered row by row, in the order of mannequin_table.json.
Cage make_cage();

// The mannequin's 21 joints (sim/body/joint_names.h), which are its bones in the order of Joint.

// Positions of the joints, m, in the order of Joint.
struct Joints {
    std::array<Vec3d, kJointCount> x{};

    Vec3d& operator[](Joint joint) { return x[static_cast<std::size_t>(joint)]; }
    const Vec3d& operator[](Joint joint) const { return x[static_cast<std::size_t>(joint)]; }
};

Vec3d mirrored(const Vec3d& x);  // reflects in the midplane x = 0

// Sets the right side's joints to the mirror images of the left side's.
void mirror_left_side(Joints& joints);

std::vector<Bone> make_bones(const Joints& joints);

}  // namespace selvedge::sim

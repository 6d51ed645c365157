#pragma once
// Report on a dressed garment as plain data and as JSON, with the quality checks that find its faults. All keys of the
// JSON are declared here.
#include <array>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/cloth/cloth.h"
#include "sim/core/json.h"
#include "sim/dress/drape.h"
#include "sim/dress/sewing.h"
#include "sim/mesh/draw_mesh.h"
#include "sim/pattern/pattern.h"

namespace selvedge::sim {

class BodyCollider;

namespace report_key {
inline constexpr std::string_view kGarment = "garment";
inline constexpr std::string_view kGarments = "garments";
inline constexpr std::string_view kBody = "body";
inline constexpr std::string_view kSettled = "settled";
inline constexpr std::string_view kStoppedBecause = "stopped_because";
inline constexpr std::string_view kSimulatedSeconds = "simulated_seconds";
inline constexpr std::string_view kNotes = "notes";

inline constexpr std::string_view kFaults = "faults";
inline constexpr std::string_view kKind = "kind";
inline constexpr std::string_view kClass = "class";
inline constexpr std::string_view kPlace = "place";
inline constexpr std::string_view kValue = "value";

inline constexpr std::string_view kMesh = "mesh";
inline constexpr std::string_view kBaseTriangles = "base_triangles";
inline constexpr std::string_view kLeafTriangles = "leaf_triangles";
inline constexpr std::string_view kLeafVertices = "leaf_vertices";
inline constexpr std::string_view kByLevel = "by_level";
inline constexpr std::string_view kMinAngleDeg = "min_angle_deg";
inline constexpr std::string_view kSplits = "splits";
inline constexpr std::string_view kRejoins = "rejoins";
inline constexpr std::string_view kTransitions = "transitions";

inline constexpr std::string_view kSeams = "seams";
inline constexpr std::string_view kCount = "count";
inline constexpr std::string_view kOpen = "open";
inline constexpr std::string_view kWorstLengthMismatch = "worst_length_mismatch";

inline constexpr std::string_view kContact = "contact";
inline constexpr std::string_view kInside = "inside";
inline constexpr std::string_view kDeepestM = "deepest_m";
inline constexpr std::string_view kFacesInBody = "faces_in_body";
inline constexpr std::string_view kEdgesInBody = "edges_in_body";
inline constexpr std::string_view kDeepestFaceM = "deepest_face_m";
inline constexpr std::string_view kDeepestFaceAt = "deepest_face_at";
inline constexpr std::string_view kSelfCrossings = "self_crossings";
inline constexpr std::string_view kSelfCrossingM = "self_crossing_m";
inline constexpr std::string_view kSelfCrossingAt = "self_crossing_at";
inline constexpr std::string_view kOnLowerLayer = "on_lower_layer";
inline constexpr std::string_view kWrongLayerOrder = "wrong_layer_order";

inline constexpr std::string_view kStretch = "stretch";
inline constexpr std::string_view kWarpWeftP50 = "warp_weft_p50";
inline constexpr std::string_view kWarpWeftP99 = "warp_weft_p99";
inline constexpr std::string_view kWarpWeftMax = "warp_weft_max";
inline constexpr std::string_view kShearDegP99 = "shear_deg_p99";

inline constexpr std::string_view kTiming = "timing";
inline constexpr std::string_view kWallS = "wall_s";
inline constexpr std::string_view kMsPerAdaption = "ms_per_adaption";
inline constexpr std::string_view kMsPerStep = "ms_per_step";
inline constexpr std::string_view kMsAdaptPlus4Steps = "ms_adapt_plus_4_steps";
inline constexpr std::string_view kPhases = "phases";
inline constexpr std::string_view kPeakMemoryMb = "peak_memory_mb";
}  // namespace report_key

// A fault of a dressed garment, and where it is. Kinds: "not_settled", "open_seam", "inside_body", "through_body",
// "self_crossing", "wrong_layer_order", "limb_missed", "displaced", "on_floor", "overstretched", "not_finite",
// "broken_mesh", "does_not_fit".
struct DressFault {
    std::string kind;
    std::string place;  // a seam, panel, opening or point that the user can find
    double value = 0;   // in the unit of the kind: m, m/s, strain, number of limbs, share of the vertices
};

enum class FaultClass {
    Defect,     // the drape is wrong, although the garment may fit
    DoesNotFit  // too small, too large or too stretchy for the body, in any drape
};
FaultClass class_of(const DressFault& fault);
std::string_view name_of(FaultClass fault_class);  // "defect" or "does_not_fit"

struct MeshCounts {
    int base_triangles = 0;
    int leaf_triangles = 0;
    int leaf_vertices = 0;
    std::vector<int> by_level;  // leaf triangles per level
    double min_angle_deg = 0;   // of the base mesh, in material coordinates
    long splits = 0;            // over the whole drape
    long rejoins = 0;
    long transitions = 0;
};

struct SeamCounts {
    int count = 0;
    int open = 0;
    double worst_length_mismatch = 0;  // relative: longer side / shorter side - 1
};

struct ContactCounts {
    int inside = 0;                  // leaf vertices inside the body
    double deepest_m = 0;            // 0 when no vertex is inside
    int faces_in_body = 0;           // leaf triangles of which a part is deeper than FaultLimits::depth
    int edges_in_body = 0;           // leaf edges of which a part is
    double deepest_face_m = 0;       // of these; 0 when there are none
    std::string deepest_face_at{};   // its place, empty when there are none
    int self_crossings = 0;          // pairs of leaf triangles without a common vertex that cross each other
    double self_crossing_m = 0;      // total length of the contours of these, m
    std::string self_crossing_at{};  // the place of one of them, empty when there are none
    int on_lower_layer = 0;          // leaf vertices that lie flat on a panel of a lower layer (layer_order.h)
    int wrong_layer_order = 0;       // of these, those that lie inside of it
};

// Statistics over the leaf triangles: strain along warp and weft (deformed length - 1), and the angle between them - 90
// deg.
struct StretchStatistics {
    double warp_weft_p50 = 0;
    double warp_weft_p99 = 0;
    double warp_weft_max = 0;
    double shear_deg_p99 = 0;
};

struct DressTiming {
    double wall_s = 0;
    double ms_per_adaptation = 0;  // medians over the drape
    double ms_per_step = 0;
    double ms_adapt_plus_4_steps = 0;
    std::map<std::string, double> phases_s;
    double peak_memory_mb = 0;
};

struct DressReport {
    std::string garment;
    std::vector<std::string> garments;  // from the innermost to the outermost
    std::string body;
    bool settled = false;
    std::string stopped_because;  // "settled", "time limit" or "bad number"
    double simulated_seconds = 0;
    std::vector<DressFault> faults;
    std::vector<std::string> notes;  // information for the user that is not a fault
    MeshCounts mesh;
    SeamCounts seams;
    ContactCounts contact;
    StretchStatistics stretch;
    DressTiming timing;
};

Json json_of(const DressReport& report);
// The whole report as JSON text. Equal input gives equal text, except for `timing`.
std::string to_json(const DressReport& report);

// Quality checks of a dressed garment.

// Limits above which a value is a fault.
struct FaultLimits {
    double depth = 0.0005;          // m, depth of a vertex inside the body; of what counts as an edge or face in it
    double face_depth = 0.003;      // m, of an edge or face: more than the solver lets one dip as it moves
    double stretch_p99 = 0.02;      // warp or weft strain beyond the fabric's limit and what tightness explains
    double stretch_max = 0.12;      // the same
    bool may_cross_itself = false;  // whether cloth that passes through itself is no fault
};

// Fills in mesh counts, contact, stretch, open seams, notes and faults.
void validate(const Cloth& cloth, const BodyCollider& body, const Pattern& pattern,
              std::span<const OpenSeam> open_seams, const DrapeResult& draped, DressReport& report,
              const FaultLimits& limits = {});

// Position for the user, for example "'front' beside 'left_sleeve' at x 0.123 y 1.340 z 0.051 m".
std::string describe_place(const Cloth& cloth, const Pattern& pattern, VertexId vertex);

}  // namespace selvedge::sim

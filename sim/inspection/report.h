#pragma once
// Report on a dressed garment as plain data and as JSON (docs/report.md). All keys of the JSON are declared here.
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/json.h"
#include "sim/dress/dress_options.h"
#include "sim/place/fit_table.h"

namespace selvedge::sim {

namespace report_key {
inline constexpr std::string_view kSchema = "schema";
inline constexpr std::string_view kVersion = "version";
inline constexpr std::string_view kOutcome = "outcome";
inline constexpr std::string_view kProblem = "problem";

inline constexpr std::string_view kInputs = "inputs";
inline constexpr std::string_view kRole = "role";
inline constexpr std::string_view kFile = "file";
inline constexpr std::string_view kSha256 = "sha256";

inline constexpr std::string_view kOptions = "options";
inline constexpr std::string_view kFabric = "fabric";
inline constexpr std::string_view kEdgeLengthM = "edge_length_m";
inline constexpr std::string_view kMaxLevel = "max_level";
inline constexpr std::string_view kShortestEdgeM = "shortest_edge_m";
inline constexpr std::string_view kTriangleBudget = "triangles";
inline constexpr std::string_view kCriteria = "criteria";
inline constexpr std::string_view kMaxSeconds = "max_seconds";
inline constexpr std::string_view kSelfCollision = "self_collision";

inline constexpr std::string_view kGarment = "garment";
inline constexpr std::string_view kGarments = "garments";
inline constexpr std::string_view kBody = "body";
inline constexpr std::string_view kSettled = "settled";
inline constexpr std::string_view kWork = "work";
inline constexpr std::string_view kStoppedBecause = "stopped_because";
inline constexpr std::string_view kSimulatedSeconds = "simulated_seconds";
inline constexpr std::string_view kNotes = "notes";

inline constexpr std::string_view kFaults = "faults";
inline constexpr std::string_view kKind = "kind";
inline constexpr std::string_view kClass = "class";
inline constexpr std::string_view kPlace = "place";
inline constexpr std::string_view kValue = "value";
inline constexpr std::string_view kUnit = "unit";
inline constexpr std::string_view kCause = "cause";

inline constexpr std::string_view kFit = "fit";
inline constexpr std::string_view kMeasure = "measure";
inline constexpr std::string_view kBodyGirthM = "body_girth_m";
inline constexpr std::string_view kGarmentGirthM = "garment_girth_m";
inline constexpr std::string_view kEaseM = "ease_m";
inline constexpr std::string_view kPlanePointM = "plane_point_m";
inline constexpr std::string_view kPlaneNormal = "plane_normal";

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
inline constexpr std::string_view kMsPerAdaptation = "ms_per_adaptation";
inline constexpr std::string_view kMsPerStep = "ms_per_step";
inline constexpr std::string_view kMsAdaptPlus4Steps = "ms_adapt_plus_4_steps";
inline constexpr std::string_view kPhases = "phases";
inline constexpr std::string_view kPeakMemoryMb = "peak_memory_mb";
}  // namespace report_key

inline constexpr std::string_view kWholeGarment = "whole garment";                // a fault's place
inline constexpr std::string_view kSmallerThanBody = "smaller than the body by";  // how a note of tightness begins

// A fault of a dressed garment, and where it is. Kinds: "not_settled", "open_seam", "inside_body", "through_body",
// "self_crossing", "wrong_layer_order", "limb_missed", "stuck_in_body", "displaced", "on_floor", "rolled_edge",
// "overstretched", "not_finite", "broken_mesh", "does_not_fit".
struct DressFault {
    std::string kind;
    std::string place;               // a seam, panel, opening or point that the user can find
    double value = 0;                // in the unit of the kind: m, m/s, strain, number of limbs, share of the vertices
    std::string unit{};              // empty: that of the kind
    std::optional<double> height{};  // m, of the point that the place names
};

enum class FaultClass {
    Defect,     // the drape is wrong, although the garment may fit
    DoesNotFit  // too small, too large or too stretchy for the body, in any drape
};
FaultClass class_of(const DressFault& fault);
std::string_view name_of(FaultClass fault_class);  // "defect" or "does_not_fit"

struct DressReport;

// Adds it to the faults; to the notes, as the sentence of its cause, if it is smaller than what counts as a fault of
// its kind (note_below()).
void add_fault(DressReport& report, DressFault fault);

// The size below which what is wrong is noted and is no fault, in the unit of the kind; 0: it is a fault at any size.
double note_below(std::string_view kind);

// What is wrong, where and by how much, as a sentence: "too small at the waist (y 1.02 m) by 3.2 cm", "crossing itself
// over 1.4 cm: 12 pairs of triangles, one at 'front' at x 0.113 y 1.071 z 0.129 m".
std::string cause_of(const DressFault& fault);

std::string in_centimetres(double length);  // "7 cm"

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

// A file that the dressing was made from.
struct ReportInput {
    std::string role;  // "garment", "over", "body", "fabric", "tartan", "picture", "motion"
    std::string file;  // as it was named
    std::string sha256;
};

// How a dressing ended: by its worst fault, or refused before it began.
enum class Outcome { Dressed, DoesNotFit, Defect, Refused };
std::string_view name_of(Outcome outcome);  // "dressed", "does_not_fit", "defect", "refused"
int exit_code_of(Outcome outcome);          // 0, 4, 3, 2

inline constexpr int kReportSchema = 1;  // increases when a key changes its meaning or goes

struct DressReport {
    std::vector<ReportInput> inputs;
    DressOptions options{};
    std::string problem;  // why it was refused; empty: it was not

    std::string garment;
    std::vector<std::string> garments;  // from the innermost to the outermost
    std::string body;
    bool settled = false;
    std::string stopped_because;  // "settled", "too small", "slips down", "work limit", "time limit" or
                                  // "bad number"
    double simulated_seconds = 0;
    double work = 0;  // of the drape, see DrapeResult
    std::vector<DressFault> faults;
    std::vector<std::string> notes;  // information for the user that is not a fault
    std::vector<FitRow> fit;         // empty if it was not measured
    MeshCounts mesh;
    SeamCounts seams;
    ContactCounts contact;
    StretchStatistics stretch;
    DressTiming timing;
};

Outcome outcome_of(const DressReport& report);

Json json_of(const DressReport& report);
// Without `timing`, which differs from run to run.
Json json_without_times(const DressReport& report);
Json times_json(const DressReport& report);  // `timing` alone
// The whole report as JSON text. Equal input gives equal text, except for `timing`.
std::string to_json(const DressReport& report);

}  // namespace selvedge::sim

#include "sim/inspection/report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

#include "sim/core/json.h"
#include "sim/core/version.h"

namespace selvedge::sim {
namespace {

// What a kind of fault is called, the unit of its value, and the value from which it is a fault.
struct FaultKind {
    std::string_view kind;
    std::string_view unit;
    double least = 0;
};

// What is at rest by the drape's own measure (DrapeOptions::rest_speed), though not for as long as it should be.
constexpr double kAtRest = 0.01;  // m/s

// A stitch is 2 to 3 mm long. The shortest edges of the mesh are ten times as long, so that a contour this short lies
// in the corner of one or two triangles, and no picture of a garment shows it.
constexpr double kShortCrossing = 0.002;  // m

// Fewer vertices than a triangle has are no area.
constexpr double kFewVertices = 3;

// Less than one gore of a skirt of eight: what is shorter is a fold of the hem.
constexpr double kRolledShare = 0.1;

constexpr std::array<FaultKind, 15> kFaultKinds{{{"not_settled", "m/s", kAtRest},
                                                 {"open_seam", "m"},
                                                 {"inside_body", "m"},
                                                 {"through_body", "m"},
                                                 {"self_crossing", "m", kShortCrossing},
                                                 {"wrong_layer_order", "vertices", kFewVertices},
                                                 {"limb_missed", "limbs"},
                                                 {"stuck_in_body", "panels"},
                                                 {"displaced", "m"},
                                                 {"on_floor", "share of the vertices"},
                                                 {"rolled_edge", "share of the edge", kRolledShare},
                                                 {"overstretched", "strain"},
                                                 {"not_finite", ""},
                                                 {"broken_mesh", ""},
                                                 {"does_not_fit", "m"}}};

const FaultKind* kind_of(std::string_view kind) {
    const auto* const known = std::ranges::find(kFaultKinds, kind, &FaultKind::kind);
    return known == kFaultKinds.end() ? nullptr : known;
}

std::string_view unit_of(const DressFault& fault) {
    if (!fault.unit.empty()) return fault.unit;
    const FaultKind* const known = kind_of(fault.kind);
    return known ? known->unit : "";
}

// "3.2 cm", "0.4 mm".
std::string length_text(double metres) {
    char text[32];
    const bool is_small = metres < 0.01;
    std::snprintf(text, sizeof text, "%.1f %s", metres * (is_small ? 1000 : 100), is_small ? "mm" : "cm");
    return text;
}

Json inputs_json(const std::vector<ReportInput>& inputs) {
    Json list = Json::array();
    for (const ReportInput& input : inputs) {
        Json item = Json::object();
        item[report_key::kRole] = input.role;
        item[report_key::kFile] = input.file;
        item[report_key::kSha256] = input.sha256;
        list.push_back(std::move(item));
    }
    return list;
}

template <class T>
Json json_or_null(const std::optional<T>& value) {
    return value ? Json(*value) : Json();
}

Json options_json(const DressOptions& options) {
    Json json = Json::object();
    json[report_key::kFabric] = options.fabric ? Json(options.fabric->name) : Json();
    json[report_key::kEdgeLengthM] = json_or_null(options.edge_length);
    json[report_key::kMaxLevel] = options.max_level;
    json[report_key::kShortestEdgeM] = options.shortest_edge;
    json[report_key::kTriangleBudget] = json_or_null(options.triangle_budget);
    Json& criteria = json[report_key::kCriteria] = Json::array();
    if (options.criteria.collision) criteria.push_back("collision");
    if (options.criteria.curvature) criteria.push_back("curvature");
    if (options.criteria.length) criteria.push_back("length");
    json[report_key::kMaxSeconds] = options.max_seconds;
    json[report_key::kSelfCollision] = options.self_collision;
    return json;
}

Json json_of(const Vec3d& x) {
    Json list = Json::array();
    for (const double value : x) list.push_back(value);
    return list;
}

Json fit_json(const std::vector<FitRow>& fit) {
    Json list = Json::array();
    for (const FitRow& row : fit) {
        Json item = Json::object();
        item[report_key::kMeasure] = row.measure;
        item[report_key::kBodyGirthM] = json_or_null(row.body_girth);
        item[report_key::kGarmentGirthM] = json_or_null(row.garment_girth);
        item[report_key::kEaseM] = json_or_null(row.ease());
        item[report_key::kPlanePointM] = row.plane ? json_of(row.plane->point) : Json();
        item[report_key::kPlaneNormal] = row.plane ? json_of(row.plane->normal) : Json();
        list.push_back(std::move(item));
    }
    return list;
}

Json faults_json(const std::vector<DressFault>& faults) {
    Json list = Json::array();
    for (const DressFault& fault : faults) {
        Json item = Json::object();
        item[report_key::kKind] = fault.kind;
        item[report_key::kClass] = std::string(name_of(class_of(fault)));
        item[report_key::kPlace] = fault.place;
        item[report_key::kValue] = fault.value;
        item[report_key::kUnit] = unit_of(fault);
        item[report_key::kCause] = cause_of(fault);
        list.push_back(std::move(item));
    }
    return list;
}

Json mesh_json(const MeshCounts& mesh) {
    Json json = Json::object();
    json[report_key::kBaseTriangles] = mesh.base_triangles;
    json[report_key::kLeafTriangles] = mesh.leaf_triangles;
    json[report_key::kLeafVertices] = mesh.leaf_vertices;
    Json levels = Json::array();
    for (const int count : mesh.by_level) levels.push_back(count);
    json[report_key::kByLevel] = std::move(levels);
    json[report_key::kMinAngleDeg] = mesh.min_angle_deg;
    json[report_key::kSplits] = mesh.splits;
    json[report_key::kRejoins] = mesh.rejoins;
    json[report_key::kTransitions] = mesh.transitions;
    return json;
}

Json seams_json(const SeamCounts& seams) {
    Json json = Json::object();
    json[report_key::kCount] = seams.count;
    json[report_key::kOpen] = seams.open;
    json[report_key::kWorstLengthMismatch] = seams.worst_length_mismatch;
    return json;
}

Json contact_json(const ContactCounts& contact) {
    Json json = Json::object();
    json[report_key::kInside] = contact.inside;
    json[report_key::kDeepestM] = contact.deepest_m;
    json[report_key::kFacesInBody] = contact.faces_in_body;
    json[report_key::kEdgesInBody] = contact.edges_in_body;
    json[report_key::kDeepestFaceM] = contact.deepest_face_m;
    json[report_key::kDeepestFaceAt] = contact.deepest_face_at;
    json[report_key::kSelfCrossings] = contact.self_crossings;
    json[report_key::kSelfCrossingM] = contact.self_crossing_m;
    json[report_key::kSelfCrossingAt] = contact.self_crossing_at;
    json[report_key::kOnLowerLayer] = contact.on_lower_layer;
    json[report_key::kWrongLayerOrder] = contact.wrong_layer_order;
    return json;
}

Json stretch_json(const StretchStatistics& stretch) {
    Json json = Json::object();
    json[report_key::kWarpWeftP50] = stretch.warp_weft_p50;
    json[report_key::kWarpWeftP99] = stretch.warp_weft_p99;
    json[report_key::kWarpWeftMax] = stretch.warp_weft_max;
    json[report_key::kShearDegP99] = stretch.shear_deg_p99;
    return json;
}

Json timing_json(const DressTiming& timing) {
    Json json = Json::object();
    json[report_key::kWallS] = timing.wall_s;
    json[report_key::kMsPerAdaptation] = timing.ms_per_adaptation;
    json[report_key::kMsPerStep] = timing.ms_per_step;
    json[report_key::kMsAdaptPlus4Steps] = timing.ms_adapt_plus_4_steps;
    Json phases = Json::object();
    for (const auto& [phase, seconds] : timing.phases_s) phases[phase] = seconds;
    json[report_key::kPhases] = std::move(phases);
    json[report_key::kPeakMemoryMb] = timing.peak_memory_mb;
    return json;
}

}  // namespace

double note_below(std::string_view kind) {
    const FaultKind* const known = kind_of(kind);
    return known ? known->least : 0;
}

void add_fault(DressReport& report, DressFault fault) {
    if (fault.value < note_below(fault.kind)) {
        report.notes.push_back(cause_of(fault));
    } else {
        report.faults.push_back(std::move(fault));
    }
}

FaultClass class_of(const DressFault& fault) {
    return fault.kind == "does_not_fit" ? FaultClass::DoesNotFit : FaultClass::Defect;
}

std::string_view name_of(FaultClass fault_class) {
    return fault_class == FaultClass::DoesNotFit ? "does_not_fit" : "defect";
}

std::string cause_of(const DressFault& fault) {
    const std::string_view kind = fault.kind;
    char text[64];
    if (kind == "not_settled") {
        std::snprintf(text, sizeof text, "still moving by %.0f mm/s at the end of its time", 1000 * fault.value);
        return fault.place == kWholeGarment ? text : text + (", most of all " + fault.place);
    }
    if (kind == "open_seam") return "seam open by " + length_text(fault.value) + ": " + fault.place;
    if (kind == "inside_body") return length_text(fault.value) + " inside the body: " + fault.place;
    if (kind == "self_crossing") return "crossing itself over " + length_text(fault.value) + ": " + fault.place;
    if (kind == "overstretched") {
        std::snprintf(text, sizeof text, "stretched by %.0f %%: ", 100 * fault.value);
        return text + fault.place;
    }
    if (kind == "not_finite") return "a position that is not a number: " + fault.place;
    if (kind == "broken_mesh") return "broken mesh: " + fault.place;
    return fault.place;  // says it all
}

std::string in_centimetres(double length) {
    return std::to_string(std::lround(100 * length)) + " cm";
}

std::string_view name_of(Outcome outcome) {
    switch (outcome) {
        case Outcome::Dressed:
            return "dressed";
        case Outcome::DoesNotFit:
            return "does_not_fit";
        case Outcome::Defect:
            return "defect";
        case Outcome::Refused:
            break;
    }
    return "refused";
}

int exit_code_of(Outcome outcome) {
    switch (outcome) {
        case Outcome::Dressed:
            return 0;
        case Outcome::DoesNotFit:
            return 4;
        case Outcome::Defect:
            return 3;
        case Outcome::Refused:
            break;
    }
    return 2;
}

Outcome outcome_of(const DressReport& report) {
    if (!report.problem.empty()) return Outcome::Refused;
    const auto is_defect = [](const DressFault& fault) { return class_of(fault) == FaultClass::Defect; };
    if (std::ranges::any_of(report.faults, is_defect)) return Outcome::Defect;
    return report.faults.empty() ? Outcome::Dressed : Outcome::DoesNotFit;
}

Json json_without_times(const DressReport& report) {
    Json json = Json::object();
    json[report_key::kSchema] = kReportSchema;
    json[report_key::kVersion] = program_version();
    json[report_key::kOutcome] = name_of(outcome_of(report));
    json[report_key::kProblem] = report.problem.empty() ? Json() : Json(report.problem);
    json[report_key::kInputs] = inputs_json(report.inputs);
    json[report_key::kOptions] = options_json(report.options);
    json[report_key::kGarment] = report.garment;
    Json garments = Json::array();
    for (const std::string& garment : report.garments) garments.push_back(garment);
    json[report_key::kGarments] = std::move(garments);
    json[report_key::kBody] = report.body;
    json[report_key::kSettled] = report.settled;
    json[report_key::kStoppedBecause] = report.stopped_because;
    json[report_key::kSimulatedSeconds] = report.simulated_seconds;
    json[report_key::kWork] = report.work;
    json[report_key::kFaults] = faults_json(report.faults);
    Json notes = Json::array();
    for (const std::string& note : report.notes) notes.push_back(note);
    json[report_key::kNotes] = std::move(notes);
    json[report_key::kFit] = fit_json(report.fit);
    json[report_key::kMesh] = mesh_json(report.mesh);
    json[report_key::kSeams] = seams_json(report.seams);
    json[report_key::kContact] = contact_json(report.contact);
    json[report_key::kStretch] = stretch_json(report.stretch);
    return json;
}

Json times_json(const DressReport& report) {
    return timing_json(report.timing);
}

Json json_of(const DressReport& report) {
    Json json = json_without_times(report);
    json[report_key::kTiming] = timing_json(report.timing);
    return json;
}

std::string to_json(const DressReport& report) {
    return write_json(json_of(report));
}

}  // namespace selvedge::sim

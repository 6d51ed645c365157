#include "sim/repair/load_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>

#include "sim/body/parted_legs.h"
#include "sim/body/pose.h"
#include "sim/core/error.h"
#include "sim/core/file_extension.h"
#include "sim/core/file_path.h"
#include "sim/core/printable.h"
#include "sim/repair/guarded_import.h"
#include "sim/repair/outer_hull.h"

namespace selvedge::sim {

namespace {

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    double extent() const { return high - low; }
};

Range range_along(const ImportedScene& scene, int axis) {
    Range range;
    for (const ImportedMesh& mesh : scene.meshes)
        for (const Vec3f& p : mesh.x) {
            range.low = std::min(range.low, double(p[axis]));
            range.high = std::max(range.high, double(p[axis]));
        }
    return range;
}

bool is_gltf(const std::filesystem::path& path) {
    const std::string extension = lower_extension(path);
    return extension == ".gltf" || extension == ".glb";
}

// A standing body is taller than it is deep in any arm pose.
UpAxis up_axis(const ImportedScene& scene, const std::filesystem::path& path, UpAxis requested) {
    if (requested != UpAxis::Auto) return requested;
    if (is_gltf(path)) return UpAxis::Y;
    return range_along(scene, 2).extent() > range_along(scene, 1).extent() ? UpAxis::Z : UpAxis::Y;
}

struct UnitOfLength {
    LengthUnit unit;
    double metres;
    const char* name;
};
constexpr std::array<UnitOfLength, 7> kUnits{{{LengthUnit::Metres, 1, "metres"},
                                              {LengthUnit::Decimetres, 0.1, "decimetres"},
                                              {LengthUnit::Centimetres, 0.01, "centimetres"},
                                              {LengthUnit::Millimetres, 0.001, "millimetres"},
                                              {LengthUnit::Inches, 0.0254, "inches"},
                                              {LengthUnit::Feet, 0.3048, "feet"},
                                              {LengthUnit::Poser, 8.6 * 0.3048, "Poser's units of 8.6 feet"}}};

const UnitOfLength& unit_of_length(LengthUnit unit) {
    return *std::ranges::find(kUnits, unit, &UnitOfLength::unit);
}

// How unlike a person a body of this size is: a stature of 1.6 m and a depth of 28 cm cost nothing. The depth tells a
// bust in centimetres from a body in inches: it is about the same for whole bodies, without a head, or without legs.
double implausibility(double height, double depth) {
    constexpr double kHeight = 1.6, kDepth = 0.28;  // m
    return std::abs(std::log(height / kHeight)) + std::abs(std::log(depth / kDepth));
}

// A child of a year is as tall in metres as a figure of Poser's in its units, but has shorter legs: its crotch is at
// 0.38 of its stature.
bool is_grown(const PersonLikeness& person) {
    constexpr double kGrown = 0.43;
    const Stature& stature = person.stature;
    return person.is_whole() && person.landmarks.crotch &&
           *person.landmarks.crotch - stature.floor > kGrown * stature.height();
}

// The most plausible unit in which the body is 0.3 to 2.3 m tall; otherwise, for giants, up to 4 m.
LengthUnit length_unit(double height, double depth, const PersonLikeness& person, const std::string& file,
                       LengthUnit requested) {
    if (requested != LengthUnit::Auto) return requested;
    constexpr double kLeast = 0.3, kTallest = 2.3, kGiant = 4;  // m
    depth = std::max(depth, 1e-3 * height);
    for (const double most : {kTallest, kGiant}) {
        const UnitOfLength* best = nullptr;
        const auto cost = [&](const UnitOfLength& unit) {
            return implausibility(height * unit.metres, depth * unit.metres);
        };
        for (const UnitOfLength& unit : kUnits) {
            if (height * unit.metres < kLeast || height * unit.metres > most) continue;
            if (unit.unit == LengthUnit::Poser && !is_grown(person)) continue;
            if (!best || cost(unit) < cost(*best)) best = &unit;
        }
        if (best) return best->unit;
    }
    throw InputError(
        file, "",
        "a body " + std::to_string(height) + " units tall is not one in m, dm, cm, mm, inches or feet: name its unit");
}

// Applies to any unit: nothing larger is a person, and the memory of the collision field grows with the volume.
void check_size(const ImportedScene& scene, double scale, const std::string& file) {
    constexpr double kLargestBody = 5;  // m
    for (int axis = 0; axis < 3; ++axis) {
        const double extent = range_along(scene, axis).extent() * scale;
        if (extent <= kLargestBody) continue;
        throw InputError(file, "",
                         "a body of " + std::to_string(extent) + " m is too large to dress: is its unit right?");
    }
}

// Converts the file's frame to ours.
struct FileFrame {
    double scale = 1;
    Stance stance;
    double lift = 0;  // m

    Vec3d operator()(const Vec3d& p) const { return scale * stance(p) + Vec3d(0, lift, 0); }
};

// Of the person, as far as it was found.
void check_stature(const PersonLikeness& person, double scale, const std::string& file) {
    constexpr double kSmallest = 0.4, kTallest = 2.75;  // m: newborn children, and the tallest man on record, 2.72 m
    const double stature = person.stature.height() * scale;
    if (stature >= kSmallest && stature <= kTallest) return;
    char text[96];
    std::snprintf(text, sizeof text, "no person is %.2f m tall: is its unit right?", stature);
    throw InputError(file, "", text);
}

FileFrame choose_frame(const ImportedScene& scene, const PersonSearch& person, const std::filesystem::path& path,
                       const LoadBodyOptions& options, LoadBodyReport& report) {
    report.up = person.stance.up;
    report.quarter_turns = person.stance.quarter_turns;
    const int up = report.up == UpAxis::Z ? 2 : 1;
    const double depth = std::min(range_along(scene, 0).extent(), range_along(scene, 3 - up).extent());
    const double height = range_along(scene, up).extent();
    constexpr double kLeast = 0.5, kTallest = 2.75;  // m: a unit other than glTF's own must be the better guess
    const bool is_own = is_gltf(path) && options.unit == LengthUnit::Auto && height > kLeast && height < kTallest;
    report.unit =
        is_own ? LengthUnit::Metres : length_unit(height, depth, person.likeness, path.string(), options.unit);
    report.is_unit_assumed = options.unit == LengthUnit::Auto;
    const double scale = unit_of_length(report.unit).metres;
    check_size(scene, scale, path.string());
    if (options.must_be_person && person.likeness.is_person()) check_stature(person.likeness, scale, path.string());
    return {.scale = scale, .stance = person.stance};
}

struct JoinedScene {
    Surface surface;
    std::vector<SkinWeights> skin;  // empty, or parallel to surface.x
};

JoinedScene join(const ImportedScene& scene, const FileFrame& frame) {
    JoinedScene joined;
    bool has_skin = !scene.bones.empty();
    for (const ImportedMesh& mesh : scene.meshes) has_skin = has_skin && mesh.skin.size() == mesh.x.size();
    for (const ImportedMesh& mesh : scene.meshes) {
        const int first = int(joined.surface.x.size());
        for (const Vec3f& p : mesh.x) joined.surface.x.push_back(frame(p.cast<double>()));
        for (const auto& [a, b, c] : mesh.triangles)
            joined.surface.triangles.push_back({first + int(a), first + int(b), first + int(c)});
        if (has_skin) joined.skin.insert(joined.skin.end(), mesh.skin.begin(), mesh.skin.end());
    }
    return joined;
}

// Per vertex of all meshes: whether bones move it.
std::vector<bool> bound_vertices(const ImportedScene& scene) {
    std::vector<bool> is_bound;
    for (const ImportedMesh& mesh : scene.meshes)
        is_bound.insert(is_bound.end(), mesh.x.size(), !scene.bones.empty() && mesh.skin.size() == mesh.x.size());
    return is_bound;
}

// Without the triangles that are not kept, and the vertices that only they use.
void keep_triangles(ImportedScene& scene, const std::vector<bool>& is_kept) {
    if (is_kept.empty()) return;
    std::size_t at = 0;
    for (ImportedMesh& mesh : scene.meshes) {
        ImportedMesh kept;
        kept.name = mesh.name;
        kept.material = mesh.material;
        std::vector<std::int64_t> place(mesh.x.size(), -1);
        for (std::array<std::uint32_t, 3> triangle : mesh.triangles) {
            if (!is_kept[at++]) continue;
            for (std::uint32_t& v : triangle) {
                if (place[v] < 0) {
                    place[v] = std::int64_t(kept.x.size());
                    kept.x.push_back(mesh.x[v]);
                    if (!mesh.u.empty()) kept.u.push_back(mesh.u[v]);
                    if (!mesh.skin.empty()) kept.skin.push_back(mesh.skin[v]);
                }
                v = std::uint32_t(place[v]);
            }
            kept.triangles.push_back(triangle);
        }
        mesh = std::move(kept);
    }
    // A mesh without triangles says nothing of the skin.
    std::erase_if(scene.meshes, [](const ImportedMesh& mesh) { return mesh.triangles.empty(); });
}

// Where the person is, for repair(), in metres. Of a person of several pieces each may be open where another one goes
// on, however wide, and so may what bones move: a head under its hair, a trunk under its clothes.
RepairOptions repair_options(const LoadBodyOptions& options, const PersonSearch& person, const FileFrame& frame) {
    RepairOptions repair = options.repair;
    const bool is_in_pieces = !person.on_the_person || person.has_skeleton;
    if (person.likeness.is_person() && is_in_pieces) repair.largest_hole = std::numeric_limits<double>::infinity();
    if (person.on_the_person) repair.main_at = frame(*person.on_the_person);
    constexpr double kAboveNeck = 0.3;  // of the way from the neck to the crown: below it, a hole is the neck's
    const std::optional<double>& neck = person.likeness.landmarks.neck;
    if (person.likeness.is_person() && neck)
        repair.head_from = frame.scale * (*neck + kAboveNeck * (person.likeness.stature.crown - *neck));
    return repair;
}

// A body of parts gets one surface round all of them.
void join_parts(Surface& surface, const PersonSearch& person, double scale, LoadBodyReport& report) {
    constexpr double kCell = 1.0 / 216;      // of the stature: 8 mm of 1.73 m, half of a finger
    constexpr double kWidestGap = 0.03;      // of the stature: half the thickness of an arm
    constexpr double kHighestGroove = 0.02;  // of the stature: a waistband
    if (!person.likeness.is_person() || !is_of_parts(surface)) return;
    report.joined_pieces = report.repair.pieces;
    const double stature = scale * person.likeness.stature.height();
    surface = outer_hull(
        surface,
        {.cell = kCell * stature, .widest_gap = kWidestGap * stature, .highest_groove = kHighestGroove * stature});
}

void stand_on_floor(Body& body) {
    body.lift = -height_range(body).low;
    for (Vec3d& p : body.x) p.y() += body.lift;
    const Eigen::Translation3d up(0, body.lift, 0);
    for (Bone& bone : body.bones) {
        bone.joint.y() += body.lift;
        bone.inverse_bind = bone.inverse_bind * up.inverse();
    }
    body.frame = up * body.frame;
}

// For example "moved 0.9 mm down to stand on the floor".
std::string describe_shift(double shift) {
    char text[64];
    std::snprintf(text, sizeof text, "moved %.1f mm %s to stand on the floor", std::abs(shift) * 1000,
                  shift > 0 ? "up" : "down");
    return text;
}

std::string triangles_text(int count) {
    return count_text(as_size(count), "triangle");
}

// For example "assumed decimetres: 1.68 m tall".
std::string describe_unit(const LoadBodyReport& report, double height) {
    char text[64];
    std::snprintf(text, sizeof text, "%s %s: %.2f m tall", report.is_unit_assumed ? "assumed" : "read as",
                  unit_of_length(report.unit).name, height);
    return text;
}

// For example "cut 2 edges where more than two triangles meet, the first at (0.012, 1.530, 0.104) m".
std::string describe_cuts(const EdgeCuts& cuts, double lift) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "cut %d edges where more than two triangles meet, the first at (%.3f, %.3f, %.3f) m", cuts.edges,
                  cuts.at.x(), cuts.at.y() + lift, cuts.at.z());
    return cuts.dropped == 0 ? text : std::string(text) + ", and left out " + triangles_text(cuts.dropped) + " there";
}

constexpr double kNotableParting = 0.001;  // m: a tape does not see less

// "thighs touch: their inner sides moved up to 5 mm apart, for the cloth between them"
std::string describe_parting(double parted) {
    char text[96];
    std::snprintf(text, sizeof text,
                  "thighs touch: their inner sides moved by up to %.0f mm, for the cloth between them", 1000 * parted);
    return text;
}

void write_notes(LoadBodyReport& report, const Body& body) {
    std::vector<std::string>& notes = report.notes;
    const RepairReport& repair = report.repair;
    const HeightRange height = height_range(body);
    if (report.unit != LengthUnit::Metres) notes.push_back(describe_unit(report, height.high - height.low));
    if (report.up == UpAxis::Z) notes.emplace_back("turned from z up to y up");
    if (report.quarter_turns != 0)
        notes.push_back("turned by " + std::to_string(90 * report.quarter_turns) + " degrees to face the front");
    if (std::abs(body.lift) > 1e-4) notes.push_back(describe_shift(body.lift));
    if (repair.dropped_triangles > 0)
        notes.push_back("left out " + triangles_text(repair.dropped_triangles) + " without area or twice there");
    if (repair.cuts.edges > 0) notes.push_back(describe_cuts(repair.cuts, body.lift));
    if (repair.turned_triangles > 0)
        notes.push_back("turned " + triangles_text(repair.turned_triangles) + " to face outward");
    if (repair.capped_crowns > 0) notes.emplace_back("closed the top of the head, which the file leaves open");
    if (report.joined_pieces > 0)
        notes.push_back("joined its " + std::to_string(report.joined_pieces) +
                        " pieces by one surface round all of them");
    const int capped = repair.capped_holes - repair.capped_crowns;
    if (capped > 0) notes.push_back("capped " + count_text(as_size(capped), "hole"));
    for (const std::string& left_out : report.left_out) notes.push_back("left out " + left_out);
    for (const std::string& dropped : repair.dropped_pieces) notes.push_back("left out " + dropped);
}

}  // namespace

std::string canonical_name(const std::filesystem::path& path) {
    return canonical_path(path).string();
}

namespace {

// Takes the scene's bones, which are in the file's frame, into ours.
void take_bones(Body& body, std::vector<Bone> bones, const FileFrame& frame) {
    body.frame.linear().col(0) = frame(Vec3d::UnitX());
    body.frame.linear().col(1) = frame(Vec3d::UnitY());
    body.frame.linear().col(2) = frame(Vec3d::UnitZ());
    const Eigen::Affine3d from_ours = body.frame.inverse();
    for (Bone& bone : bones) {
        bone.joint = frame(bone.joint);
        bone.inverse_bind = bone.inverse_bind * from_ours;
    }
    body.bones = std::move(bones);
}

}  // namespace

BodyClips load_moving_body(const std::filesystem::path& path, const LoadBodyOptions& options, LoadBodyReport* report) {
    return body_of(guarded_import(path), path, options, report);
}

BodyClips body_of(ImportedScene scene, const std::filesystem::path& path, const LoadBodyOptions& options,
                  LoadBodyReport* report) {
    LoadBodyReport own;
    LoadBodyReport& filled_report = report ? *report : own;
    filled_report = {};
    PersonSearch person = find_person(join(scene, {}).surface, scene.bones,
                                      {.file = path.string(),
                                       .first_up = up_axis(scene, path, options.up),
                                       .may_be_other_up = options.up == UpAxis::Auto,
                                       .is_bound = bound_vertices(scene)});
    keep_triangles(scene, person.is_kept);
    filled_report.left_out = std::move(person.left_out);
    const FileFrame frame = choose_frame(scene, person, path, options, filled_report);
    JoinedScene joined = join(scene, frame);
    Surface surface =
        repair(std::move(joined.surface), path.string(), repair_options(options, person, frame), filled_report.repair);
    if (options.must_be_person && !person.likeness.is_person())
        throw InputError(path.string(), "", "it is no person: " + person.likeness.lacks);
    join_parts(surface, person, frame.scale, filled_report);

    BodyClips motion;
    Body& body = motion.body;
    body.name = path.stem().string();
    body.file = canonical_name(path);
    if (!joined.skin.empty() && filled_report.joined_pieces > 0) {
        body.skin = hull_skin(surface, joined.skin);
    } else if (!joined.skin.empty()) {
        for (const int origin : surface.origin) body.skin.push_back(joined.skin[std::size_t(origin)]);
    }
    body.x = std::move(surface.x);
    body.triangles = std::move(surface.triangles);
    take_bones(body, std::move(scene.bones), frame);
    if (options.stands_on_floor) stand_on_floor(body);
    const double parted = part_legs(body);
    if (!body.skin.empty()) bind_at_rest(body);
    write_notes(filled_report, body);
    if (parted > kNotableParting) filled_report.notes.push_back(describe_parting(parted));
    motion.clips = std::move(scene.clips);
    return motion;
}

Body load_body(const std::filesystem::path& path, const LoadBodyOptions& options, LoadBodyReport* report) {
    return load_moving_body(path, options, report).body;
}

BodyClips load_motion(const std::filesystem::path& path) {
    ImportedScene scene = guarded_import(path, ImportKind::Motion);
    BodyClips motion;
    motion.body.name = path.stem().string();
    motion.body.file = canonical_name(path);
    motion.body.bones = std::move(scene.bones);
    motion.is_y_up = scene.is_y_up;
    motion.clips = std::move(scene.clips);
    return motion;
}

}  // namespace selvedge::sim

#include "sim/mannequin/mannequin.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <utility>

#include "sim/core/error.h"
#include "sim/mannequin/measures.h"
#include "sim/mannequin/shape.h"
#include "sim/repair/self_intersections.h"

namespace selvedge::sim {
namespace {

constexpr double kEnough = 0.0015;   // relative error below which calibration stops
constexpr double kPromised = 0.003;  // relative error above which a measure is reported as not met
constexpr int kMaxIterations = 12;
constexpr double kMaxClearance = 1.1;  // maximum of ShapeParameters::clearance
constexpr double kClearanceStep = 0.05;

// The measures of a deformed body, m.
struct Readings {
    double height = 0;
    double inseam = 0;
    double waist = 0;  // its height
    double shoulder = 0;
    double arm = 0;
    LegGap leg_gap;
    GirthValues girths;
};

// The lowest vertex of the midplane, to which only the trunk contributes.
double crotch_height(const MannequinBase& base, const std::vector<Vec3d>& x) {
    double lowest = std::numeric_limits<double>::max();
    for (std::size_t v = 0; v < x.size(); ++v) {
        if (std::abs(base.surface.x[v].x()) < 1e-6) lowest = std::min(lowest, x[v].y());
    }
    return lowest;
}

Readings take_measures(const MannequinBase& base, const Body& body, const Landmarks& landmarks) {
    const HeightRange range = height_range(body);
    const double crotch = crotch_height(base, body.x);
    return {.height = range.high - range.low,
            .inseam = crotch,
            .waist = landmarks.levels.waist,
            .shoulder = 2 * landmarks.joints[Joint::LeftUpperArm].x(),
            .arm = arm_length(landmarks.joints),
            .leg_gap = measure_leg_gap(body, crotch, landmarks.joints),
            .girths = measure_girths(body, landmarks)};
}

double wanted_stance(const MannequinOptions& options) {
    return options.stance.value_or(kUsualStance);
}

ShapeParameters first_shape(const MannequinBase& base, const MannequinOptions& options, const GirthValues& targets) {
    const MannequinMeasures& measures = options.measures;
    const Joints& joints = base.landmarks.joints;
    ShapeParameters shape;
    shape.height = measures.height.value_or(base.height);
    shape.stature = shape.height / base.height;
    const double head = joints[Joint::Head].y();
    const double neck_up = (base.height - head) * head_scale(shape);
    shape.inseam = measures.inseam.value_or(base.landmarks.levels.crotch * (shape.height - neck_up) / head);
    shape.waist = measures.waist_height;
    shape.arm = measures.arm ? *measures.arm / arm_length(joints) : shape.stature;
    for (std::size_t g = 0; g < kGirthCount; ++g) shape.scale.value[g] = targets.value[g] / base.girths.value[g];
    shape.has_wide_wrist = shape.scale[Girth::Wrist] > kUsualWrist * shape.scale[Girth::Forearm];
    shape.stance = wanted_stance(options);
    shape.bust_ratio = shape.scale[Girth::Bust] / shape.stature;
    shape.shoulder = measures.shoulder ? *measures.shoulder / (2 * joints[Joint::LeftUpperArm].x())
                                       : shape.stature * std::pow(shape.bust_ratio, 0.35);
    return shape;
}

double relative_error(double value, double wanted) {
    return std::abs(value / wanted - 1);
}

// Whether the chest keeps the shoulders wider than requested.
bool is_shoulder_held(const ShapeParameters& shape, const Readings& readings, const MannequinOptions& options) {
    const std::optional<double>& requested = options.measures.shoulder;
    return requested && readings.shoulder > *requested && shape.shoulder < min_shoulder(shape, options.sex);
}

double worst_error(const Readings& readings, const GirthValues& targets, const MannequinMeasures& requested,
                   bool is_shoulder_free) {
    double worst = 0;
    for (std::size_t g = 0; g < kGirthCount; ++g) {
        worst = std::max(worst, relative_error(readings.girths.value[g], targets.value[g]));
    }
    if (requested.inseam) worst = std::max(worst, relative_error(readings.inseam, *requested.inseam));
    if (requested.shoulder && is_shoulder_free)
        worst = std::max(worst, relative_error(readings.shoulder, *requested.shoulder));
    return worst;
}

// Scales each parameter by the ratio of wanted to measured value, limited to 0.7..1.4 per iteration.
void correct(ShapeParameters& shape, const Readings& readings, const GirthValues& targets,
             const MannequinMeasures& requested, bool is_shoulder_free) {
    const auto step = [](double wanted, double value) { return std::clamp(wanted / value, 0.7, 1.4); };
    for (std::size_t g = 0; g < kGirthCount; ++g) {
        shape.scale.value[g] *= std::pow(step(targets.value[g], readings.girths.value[g]), 0.95);
    }
    if (requested.inseam) shape.inseam += *requested.inseam - readings.inseam;
    if (requested.shoulder && is_shoulder_free) shape.shoulder *= step(*requested.shoulder, readings.shoulder);
}

std::vector<SkinWeights> skin_of(const VertexRows& weights) {
    constexpr std::size_t kMaxBones = 4;
    std::vector<SkinWeights> skin(static_cast<std::size_t>(weights.rows()));
    for (std::size_t v = 0; v < skin.size(); ++v) {
        std::array<std::pair<double, std::uint16_t>, kJointCount> shares;
        for (std::size_t j = 0; j < kJointCount; ++j) {
            shares[j] = {-weights(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(j)),
                         static_cast<std::uint16_t>(j)};
        }
        std::partial_sort(shares.begin(), shares.begin() + kMaxBones, shares.end());  // by weight, then lowest joint
        double sum = 0;
        for (std::size_t k = 0; k < kMaxBones; ++k) sum -= shares[k].first;
        for (std::size_t k = 0; k < kMaxBones; ++k) {
            if (shares[k].first == 0) break;
            skin[v].bones[k] = shares[k].second;
            skin[v].weights[k] = static_cast<float>(-shares[k].first / sum);
        }
    }
    return skin;
}

std::vector<MeasureReading> read_off(const Readings& readings, const Landmarks& landmarks,
                                     const MannequinMeasures& requested) {
    const std::array<double, 5> lengths{readings.height, readings.inseam, readings.waist, readings.shoulder,
                                        readings.arm};
    std::vector<MeasureReading> lines;
    for (const MeasureEntry& entry : measure_entries()) {
        const std::size_t line = lines.size();
        lines.push_back({.name = entry.name, .requested = requested.*entry.value, .measured = 0, .level = {}});
        if (line < lengths.size()) {
            lines.back().measured = lengths[line];
        } else {
            const auto girth = static_cast<Girth>(line - lengths.size());
            lines.back().measured = readings.girths[girth];
            lines.back().level = girth_plane(girth, landmarks).point.y();
        }
    }
    return lines;
}

std::vector<std::string> unmet(const std::vector<MeasureReading>& readings, bool is_shoulder_free) {
    std::vector<std::string> messages;
    for (const MeasureReading& reading : readings) {
        if (!reading.requested || relative_error(reading.measured, *reading.requested) <= kPromised) continue;
        char text[160];
        std::snprintf(
            text, sizeof text, "%.*s: asked %.1f cm, made %.1f cm%s", static_cast<int>(reading.name.size()),
            reading.name.data(), 100 * *reading.requested, 100 * reading.measured,
            reading.name == "shoulder" && !is_shoulder_free ? ": narrower, the arms would cut the chest" : "");
        messages.emplace_back(text);
    }
    return messages;
}

// Fills in the stance and its messages.
void report_stance(MeasureReport& report, const LegGap& gap, double stance, const MannequinOptions& options) {
    report.stance = {
        .requested = options.stance, .made = stance, .is_opened = stance > wanted_stance(options), .gap = gap.width};
    char text[160];
    if (options.stance && report.stance.is_opened) {
        std::snprintf(text, sizeof text,
                      "stance: asked %.1f degrees, made %.1f degrees: with less the thighs would touch",
                      degrees(*options.stance), degrees(stance));
        report.messages.emplace_back(text);
    }
    if (gap.width < kMinLegGap) {
        std::snprintf(text, sizeof text, "stance: at %.1f degrees the thighs are only %.1f mm apart", degrees(stance),
                      1000 * gap.width);
        report.messages.emplace_back(text);
    }
}

// Deforms, measures and corrects until all requested measures match, at most kMaxIterations times.
void calibrate(Mannequin& mannequin, ShapeParameters& shape, const MannequinBase& base, const MannequinOptions& options,
               const GirthValues& targets) {
    for (int iteration = 1;; ++iteration) {
        DeformedBody bent = bend_body(base, shape);
        mannequin.body.x = std::move(bent.x);
        mannequin.body.bones = make_bones(bent.landmarks.joints);
        const Readings readings = take_measures(base, mannequin.body, bent.landmarks);
        const bool is_shoulder_free = !is_shoulder_held(shape, readings, options);
        const double worst = worst_error(readings, targets, options.measures, is_shoulder_free);
        const std::optional<double> stance = better_stance(shape.stance, wanted_stance(options), readings.leg_gap);
        ++mannequin.report.iterations;
        if (iteration == kMaxIterations || (worst < kEnough && !stance)) {
            mannequin.report.readings = read_off(readings, bent.landmarks, options.measures);
            mannequin.report.messages = unmet(mannequin.report.readings, is_shoulder_free);
            report_stance(mannequin.report, readings.leg_gap, shape.stance, options);
            return;
        }
        correct(shape, readings, targets, options.measures, is_shoulder_free);
        shape.stance = stance.value_or(shape.stance);
    }
}

std::string describe_cuts(const Body& body, const std::vector<std::array<int, 2>>& cuts) {
    const auto vertex = static_cast<std::size_t>(body.triangles[static_cast<std::size_t>(cuts.front()[0])][0]);
    return "the surface cuts itself near " + body.bones[body.skin[vertex].bones[0]].name + " (" +
           std::to_string(cuts.size()) + " pairs of triangles): these measures do not go together";
}

}  // namespace

std::string made_from(const MannequinOptions& options) {
    std::string text = options.sex == Sex::Female ? "mannequin, female" : "mannequin, male";
    const auto add = [&](std::string_view name, double value) {
        std::array<char, 32> digits{};  // the shortest that read as the same number
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
        text += ", " + std::string(name) + " " + std::string(digits.data(), end);
    };
    for (const MeasureEntry& entry : measure_entries()) {
        if (const auto& value = options.measures.*entry.value) add(entry.name, *value);
    }
    if (options.stance) add("stance", *options.stance);
    add("subdivisions", options.subdivisions);
    return text;
}

Mannequin make_mannequin(const MannequinOptions& options) {
    check_options(options);
    const MannequinBase base = make_mannequin_base(options.sex, options.subdivisions);
    check_heights(base, options.measures);
    const GirthValues targets = target_girths(base, options.measures);
    ShapeParameters shape = first_shape(base, options, targets);

    Mannequin mannequin{.body = base.surface, .report = {}};
    mannequin.body.name = options.sex == Sex::Female ? "mannequin, female" : "mannequin, male";
    mannequin.body.made_from = made_from(options);
    mannequin.body.skin = skin_of(base.weights);
    for (;;) {
        calibrate(mannequin, shape, base, options, targets);
        const auto cuts = self_intersections(mannequin.body);
        if (cuts.empty()) return mannequin;
        if (shape.clearance >= kMaxClearance) {
            mannequin.report.messages.push_back(describe_cuts(mannequin.body, cuts));
            return mannequin;
        }
        shape.clearance += kClearanceStep;  // usually a wide chest and the arms intersect at the armpit
    }
}

namespace {

double read_number(std::string_view name, std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
        throw InputError("mannequin", std::string(name), "'" + std::string(text) + "' is not a number");
    }
    return value;
}

Sex read_sex(std::string_view text) {
    if (text == "female") return Sex::Female;
    if (text == "male") return Sex::Male;
    throw InputError("mannequin", "sex", "'" + std::string(text) + "' is neither female nor male");
}

std::string known_names() {
    std::string names = "sex, resolution, stance";
    for (const std::string_view name : measure_names()) names += ", " + std::string(name);
    return names;
}

void read_setting(MannequinOptions& options, std::string_view setting) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string_view::npos) {
        throw InputError("mannequin", std::string(setting), "'name=value' expected");
    }
    const std::string_view name = setting.substr(0, equals);
    const std::string_view value = setting.substr(equals + 1);
    if (name == "sex") {
        options.sex = read_sex(value);
    } else if (name == "resolution") {
        const double steps = read_number(name, value);
        if (steps != std::floor(steps) || std::abs(steps) > 100) {
            throw InputError("mannequin", "resolution", "'" + std::string(value) + "' is not a number of steps");
        }
        options.subdivisions = static_cast<int>(steps);
    } else if (name == "stance") {
        if (options.stance) throw InputError("mannequin", "stance", "given twice");
        options.stance = radians(read_number(name, value));
    } else if (std::optional<double>* measure = find_measure(options.measures, name)) {
        if (*measure) throw InputError("mannequin", std::string(name), "given twice");
        *measure = read_number(name, value) / 100;
    } else {
        throw InputError("mannequin", std::string(name), "no such measure; known are " + known_names());
    }
}

}  // namespace

std::vector<std::string_view> measure_names() {
    std::vector<std::string_view> names;
    for (const MeasureEntry& entry : measure_entries()) names.push_back(entry.name);
    return names;
}

std::optional<double>* find_measure(MannequinMeasures& measures, std::string_view name) {
    if (name == "hips") name = "hip";
    for (const MeasureEntry& entry : measure_entries()) {
        if (entry.name == name) return &(measures.*entry.value);
    }
    return nullptr;
}

MannequinOptions parse_mannequin(std::string_view text) {
    constexpr std::string_view kKind = "mannequin";
    if (!text.starts_with(kKind)) throw InputError("", std::string(text), "'mannequin:name=value,...' expected");
    text.remove_prefix(kKind.size());
    MannequinOptions options;
    if (!text.empty() && text.front() != ':') {
        throw InputError("mannequin", std::string(text), "':' expected after 'mannequin'");
    }
    if (!text.empty()) text.remove_prefix(1);
    while (!text.empty()) {
        const std::size_t comma = text.find(',');
        read_setting(options, text.substr(0, comma));
        text.remove_prefix(comma == std::string_view::npos ? text.size() : comma + 1);
    }
    check_options(options);
    return options;
}

}  // namespace selvedge::sim

#include "sim/mannequin/from_measurements.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "sim/mannequin/guess_sex.h"
#include "sim/mannequin/measures.h"

namespace selvedge::sim {
namespace {

struct Alias {
    std::string_view name;
    std::string_view measure;
};

// In the order in which they are preferred, where a file has several for one measure.
constexpr std::array kAliases = std::to_array<Alias>({
    // FreeSewing
    {"chest", "bust"},
    {"underbust", "underbust"},
    {"waist", "waist"},
    {"seat", "hip"},
    {"neck", "neck"},
    {"biceps", "biceps"},
    {"wrist", "wrist"},
    {"upperLeg", "thigh"},
    {"knee", "knee"},
    {"ankle", "ankle"},
    {"inseam", "inseam"},
    {"shoulderToWrist", "arm"},
    {"waistToFloor", "waist_height"},
    // Seamly2D, Valentina
    {"height", "height"},
    {"bust_circ", "bust"},
    {"lowbust_circ", "underbust"},
    {"rib_circ", "underbust"},
    {"waist_circ", "waist"},
    {"waist_natural_circ", "waist"},
    {"highhip_circ", "high_hip"},
    {"hip_circ", "hip"},
    {"neck_circ", "neck"},
    {"neck_mid_circ", "neck"},
    {"arm_upper_circ", "biceps"},
    {"arm_elbow_circ", "elbow"},
    {"arm_lower_circ", "forearm"},
    {"arm_wrist_circ", "wrist"},
    {"hand_wrist_circ", "wrist"},
    {"leg_thigh_upper_circ", "thigh"},
    {"leg_thigh_mid_circ", "mid_thigh"},
    {"leg_knee_circ", "knee"},
    {"leg_calf_circ", "calf"},
    {"leg_ankle_circ", "ankle"},
    {"leg_crotch_to_floor", "inseam"},
    {"arm_shoulder_tip_to_wrist", "arm"},
    {"height_waist_side", "waist_height"},
    {"leg_waist_side_to_floor", "waist_height"},
    // GarmentCode
    {"bust", "bust"},
    {"hips", "hip"},
    {"leg_circ", "thigh"},
    {"arm_length", "arm"},
});

// Breadths of the shoulders over the outermost points of the shoulder blades. FreeSewing measures over the back: 415
// and 450 mm on its mean bodies, where a survey has 365 and 415 (guess_sex.cpp); the mean bodies of GarmentCode have
// 347 and 385.
struct ShoulderBreadth {
    std::string_view name;
    double per_breadth = 1;
};
constexpr std::array kShoulderBreadths =
    std::to_array<ShoulderBreadth>({{"shoulderToShoulder", 1.11}, {"shoulder_w", 0.94}});

// A measure as a share of a sum of others.
struct Derivation {
    std::string_view measure;
    std::array<std::string_view, 5> plus;   // empty: unused
    std::array<std::string_view, 4> minus;  // empty: unused
    double share = 1;
};

// The neck's side is at 87 % of the base bodies' stature and the waist at 63 %. The nape is at 86 % of a person's, the
// crotch at 48 %, and an arm is 34 % of it (Gordon et al. 2014, Natick/TR-15/007, means of both sexes). The first that
// is given and gives a height that a mannequin can have is taken.
constexpr std::array kDerivations = std::to_array<Derivation>({
    {"height", {"waistToFloor", "hpsToWaistBack"}, {}, 0.87},
    {"height", {"height_neck_side"}, {}, 0.87},
    {"height", {"height_neck_back"}, {}, 0.86},
    {"height", {"waistToFloor"}, {}, 0.63},
    {"height", {"height_waist_side"}, {}, 0.63},
    {"height", {"leg_waist_side_to_floor"}, {}, 0.63},
    {"height", {"inseam"}, {}, 0.48},
    {"height", {"leg_crotch_to_floor"}, {}, 0.48},
    {"height", {"shoulderToWrist"}, {}, 0.34},
    {"height", {"arm_shoulder_tip_to_wrist"}, {}, 0.34},
    {"height", {"arm_length"}, {}, 0.34},
    {"inseam", {"waistToFloor"}, {"waistToUpperLeg"}},
    {"inseam", {"height"}, {"head_l", "waist_line", "hips_line", "crotch_hip_diff"}},
    {"waist_height", {"height"}, {"head_l", "waist_line"}},
});

std::string in_cm(double metres) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1f cm", 100 * metres);
    return text.data();
}

class Fitter {
 public:
    Fitter(std::span<const NamedLength> lengths, std::optional<Sex> sex, std::string_view name)
        : lengths_(lengths), sex_(sex), name_(name) {}

    MannequinFit fit() {
        is_known_.assign(lengths_.size(), false);
        const bool is_freesewing = value("seat") || value("hpsToWaistBack") || value("waistToFloor");
        for (const Alias& alias : kAliases) {
            // FreeSewing's hips lie above its seat; GarmentCode's are the widest.
            const bool is_high_hip = is_freesewing && alias.name == "hips";
            use(alias.name, is_high_hip ? "high_hip" : alias.measure);
        }
        for (const Derivation& derivation : kDerivations) derive(derivation);
        check_shares();
        choose_sex();
        list_rest();
        return std::move(fit_);
    }

 private:
    std::optional<double> value(std::string_view name) {
        for (std::size_t i = 0; i < lengths_.size(); ++i) {
            if (lengths_[i].name == name && std::isfinite(lengths_[i].value) && lengths_[i].value > 0)
                return lengths_[i].value;
        }
        return std::nullopt;
    }

    void know(std::string_view name) {
        for (std::size_t i = 0; i < lengths_.size(); ++i) is_known_[i] = is_known_[i] || lengths_[i].name == name;
    }

    // Whether the measure takes the value; otherwise why not is told.
    bool accept(std::string_view measure, double length, const std::string& from) {
        const auto entry = std::ranges::find(measure_entries(), measure, &MeasureEntry::name);
        std::optional<double>& target = fit_.options.measures.*(entry->value);
        if (target) return false;
        if (length < entry->least || length > entry->most) {
            fit_.refused.push_back(std::string(measure) + " " + in_cm(length) + " (" + from + "): a mannequin has " +
                                   in_cm(entry->least) + " to " + in_cm(entry->most));
            return false;
        }
        constexpr double kStep = 1e-4;  // m: as the text of a mannequin has it
        target = std::round(length / kStep) * kStep;
        return true;
    }

    void use(std::string_view name, std::string_view measure) {
        const std::optional<double> length = value(name);
        if (!length) return;
        know(name);
        if (!accept(measure, *length, std::string(name))) return;
        fit_.used.push_back(std::string(measure) + " " + in_cm(*length) + " (" + std::string(name) + ")");
    }

    void derive(const Derivation& derivation) {
        double sum = 0;
        std::string from;
        const auto add = [&](std::string_view name, double sign) {
            if (name.empty()) return true;
            const std::optional<double> length = value(name);
            if (!length) return false;
            sum += sign * *length;
            from += (from.empty() ? "" : sign > 0 ? " + " : " - ") + std::string(name);
            return true;
        };
        for (const std::string_view name : derivation.plus) {
            if (!add(name, 1)) return;
        }
        for (const std::string_view name : derivation.minus) {
            if (!add(name, -1)) return;
        }
        for (const std::string_view name : derivation.plus) know(name);
        for (const std::string_view name : derivation.minus) know(name);
        if (!accept(derivation.measure, sum / derivation.share, from)) return;
        std::string text = std::string(derivation.measure) + " " + in_cm(sum / derivation.share) + ", from " + from;
        if (derivation.share != 1)
            text += ", which is " + std::to_string(static_cast<int>(std::lround(100 * derivation.share))) + " % of it";
        fit_.derived.push_back(std::move(text));
    }

    // Crotch and waist lie at some shares of a mannequin's height; what does not is left to the height.
    void check_shares() {
        MannequinMeasures& measures = fit_.options.measures;
        if (!measures.height) return;
        const auto check = [&](std::string_view name, std::optional<double>& value, const HeightShares& shares) {
            if (!value || shares.hold(*value / *measures.height)) return;
            const auto percent = [](double share) { return std::to_string(std::lround(100 * share)); };
            fit_.refused.push_back(std::string(name) + " " + in_cm(*value) + ": not " + percent(shares.least) + " to " +
                                   percent(shares.most) + " % of the height");
            value.reset();
        };
        check("inseam", measures.inseam, kInseamShares);
        check("waist_height", measures.waist_height, kWaistShares);
        if (!measures.inseam || !measures.waist_height) return;
        const double over = *measures.waist_height - *measures.inseam;
        if (kWaistOverCrotch.hold(over / *measures.height)) return;
        fit_.refused.push_back("waist_height " + in_cm(*measures.waist_height) +
                               ": too near to the inseam, or too far");
        measures.waist_height.reset();
    }

    void choose_sex() {
        if (sex_) {
            fit_.options.sex = *sex_;
            return;
        }
        SexEvidence evidence{.measures = fit_.options.measures, .name = name_};
        for (const ShoulderBreadth& breadth : kShoulderBreadths) {
            const std::optional<double> length = value(breadth.name);
            if (length) evidence.shoulder_breadth = *length / breadth.per_breadth;
        }
        const SexGuess guess = guess_sex(evidence);
        fit_.options.sex = guess.sex;
        std::string text = std::string("sex: ") + (guess.sex == Sex::Male ? "male" : "female");
        text += guess.reasons.empty() ? ", for nothing tells it" : ", by " + guess.reasons;
        if (!guess.is_sure())
            text += " (not sure, " + std::to_string(std::lround(100 * guess.probability)) +
                    " %: mannequin --sex settles it, or the sex in --body mannequin:sex=...)";
        fit_.guessed.push_back(std::move(text));
    }

    void list_rest() {
        for (const MeasureEntry& entry : measure_entries()) {
            if (!(fit_.options.measures.*(entry.value))) fit_.guessed.emplace_back(entry.name);
        }
        for (std::size_t i = 0; i < lengths_.size(); ++i) {
            if (!is_known_[i]) fit_.ignored.push_back(lengths_[i].name);
        }
    }

    std::span<const NamedLength> lengths_;
    std::optional<Sex> sex_;
    std::string_view name_;
    std::vector<bool> is_known_;
    MannequinFit fit_;
};

}  // namespace

MannequinFit mannequin_from_measurements(std::span<const NamedLength> lengths, std::optional<Sex> sex,
                                         std::string_view name) {
    return Fitter(lengths, sex, name).fit();
}

std::string mannequin_text(const MannequinOptions& options) {
    std::string text = std::string("mannequin:sex=") + (options.sex == Sex::Male ? "male" : "female");
    for (const MeasureEntry& entry : measure_entries()) {
        const std::optional<double>& measure = options.measures.*(entry.value);
        if (!measure) continue;
        const long steps = std::lround(*measure * 10000);  // 0.1 mm, so that no locale writes the decimal point
        text += "," + std::string(entry.name) + "=" + std::to_string(steps / 100);
        const std::string hundredths = std::to_string(100 + steps % 100).substr(1);
        if (hundredths != "00") text += "." + hundredths;
    }
    return text;
}

}  // namespace selvedge::sim

#include "sim/paper/measurement_file.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <pugixml.hpp>

#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/paper/measurement_formula.h"

namespace selvedge::sim {
namespace {

constexpr std::size_t kMostBytes = 1000000;
constexpr std::size_t kMostMeasures = 2000;  // measurements
constexpr double kInch = 0.0254;

MeasuredSex sex_of(std::string_view text) {
    if (text.find("emale") != std::string_view::npos) return MeasuredSex::Female;
    if (text.find("Male") != std::string_view::npos || text == "male") return MeasuredSex::Male;
    return MeasuredSex::Unknown;
}

bool is_angle(std::string_view name) {
    return name == "shoulderSlope" || name == "arm_pose_angle" || name == "hip_inclination" ||
           name == "shoulder_incl" || name.find("angle") != std::string_view::npos ||
           name.find("slope") != std::string_view::npos;
}

// Names of measurements that only FreeSewing has.
bool is_freesewings(const Measurement& one) {
    constexpr std::array<std::string_view, 27> kNames{"bustFront",
                                                      "bustPointToUnderbust",
                                                      "bustSpan",
                                                      "crossSeam",
                                                      "crossSeamFront",
                                                      "crotchDepth",
                                                      "highBust",
                                                      "highBustFront",
                                                      "hpsToBust",
                                                      "hpsToWaistBack",
                                                      "hpsToWaistFront",
                                                      "seatBack",
                                                      "shoulderSlope",
                                                      "shoulderToElbow",
                                                      "shoulderToShoulder",
                                                      "shoulderToWrist",
                                                      "upperLeg",
                                                      "waistBack",
                                                      "waistToArmpit",
                                                      "waistToFloor",
                                                      "waistToHips",
                                                      "waistToKnee",
                                                      "waistToSeat",
                                                      "waistToUnderbust",
                                                      "waistToUpperLeg",
                                                      "seat",
                                                      "biceps"};
    return std::ranges::find(kNames, std::string_view(one.name)) != kNames.end();
}

bool has_freesewings(const std::vector<Measurement>& lengths) {
    return std::ranges::count_if(lengths, is_freesewings) >= 2;
}

// ---- YAML and JSON.

struct Unit {
    double metres = 0.01;
    std::string guess;  // why; empty: the file says so
};

// FreeSewing has kept measurements in mm and in cm; a grown person's largest girth or height tells which.
Unit unit_of_freesewing(const std::string& named, const std::vector<Measurement>& lengths) {
    constexpr double kMostInches = 90, kMostCentimetres = 260;  // that a person measures
    double largest = 0;
    for (const Measurement& one : lengths) largest = std::max(largest, one.value);
    if (named == "mm") return {0.001, ""};
    if (named == "cm") return {0.01, ""};
    if (named == "imperial" && largest <= kMostInches) return {kInch, ""};
    if (largest <= kMostCentimetres) return {0.01, "values taken as cm, by their size"};
    return {0.001, "values taken as mm, by their size"};
}

class YamlReader {
 public:
    YamlReader(const YAML::Node& root, const std::string& file) : root_(root), file_(file) {}

    MeasurementFile read() {
        if (const YAML::Node body = root_["body"]; body && body.IsMap()) {
            out_.format = "GarmentCode";
            read_map(body);
            scale(0.01);
            return std::move(out_);
        }
        out_.format = "FreeSewing";
        if (root_["measurements"] && root_["measurements"].IsMap()) {
            read_map(root_["measurements"]);
        } else {
            read_map(root_);
            const bool has_usual = root_["chest"] || root_["waist"] || root_["seat"] || root_["bust"];
            if (!has_usual && !has_freesewings(out_.lengths)) {
                throw InputError(file_, "",
                                 "no measurements: neither FreeSewing's 'measurements' nor GarmentCode's 'body'");
            }
            if (has_freesewings(out_.lengths)) out_.notes.emplace_back("its names are FreeSewing's");
        }
        const Unit unit = unit_of_freesewing(text_of("units"), out_.lengths);
        if (!unit.guess.empty()) out_.notes.push_back(unit.guess);
        scale(unit.metres);
        for (const char* key : {"measurementSet", "gender", "sex"}) {
            if (out_.sex == MeasuredSex::Unknown) out_.sex = sex_of(text_of(key));
        }
        return std::move(out_);
    }

 private:
    std::string text_of(const char* key) const {
        const YAML::Node node = root_[key];
        return node && node.IsScalar() ? node.Scalar() : std::string();
    }

    void read_map(const YAML::Node& map) {
        if (map.size() > kMostMeasures) throw InputError(file_, "", "more than 2,000 measurements");
        for (const auto& entry : map) {
            if (!entry.first.IsScalar() || !entry.second.IsScalar()) continue;
            const std::string name = entry.first.Scalar();
            const std::string text = with_decimal_point(entry.second.Scalar());
            double value = 0;
            const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
            const bool is_number = error == std::errc() && stop == text.data() + text.size() && std::isfinite(value);
            if (!is_number && error == std::errc())  // "92 cm"; other texts say something else: "units: metric"
                out_.notes.push_back(name.substr(0, 60) + ": '" + text.substr(0, 40) + "' is no number, left out");
            if (!is_number || is_angle(name)) continue;
            if (!(value >= 0 && value < 1e5))
                throw InputError(file_, "line " + std::to_string(entry.second.Mark().line + 1),
                                 name.substr(0, 60) + ": '" + text.substr(0, 40) + "' is no length of a body");
            out_.lengths.push_back({name, value});
        }
    }

    void scale(double metres) {
        for (Measurement& one : out_.lengths) one.value *= metres;
    }

    const YAML::Node& root_;
    const std::string& file_;
    MeasurementFile out_;
};

// yaml-cpp follows aliases without a copy, but a loop over nested ones would not end: refused.
MeasurementFile parse_yaml(std::string_view text, const std::string& file) {
    try {
        const YAML::Node root = YAML::Load(std::string(text));
        if (!root.IsMap()) throw InputError(file, "", "no file of measurements: neither YAML, JSON nor XML with names");
        return YamlReader(root, file).read();
    } catch (const YAML::Exception& error) {
        const int line = error.mark.is_null() ? 0 : error.mark.line + 1;
        throw InputError(file, line > 0 ? "line " + std::to_string(line) : "", "no YAML: " + error.msg);
    }
}

// ---- XML.

double metres_of(const std::string& unit) {
    if (unit == "mm") return 0.001;
    if (unit == "inch" || unit == "in") return kInch;
    return 0.01;
}

int line_of(std::string_view text, std::ptrdiff_t offset) {
    const auto end = std::min(text.size(), static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, offset)));
    return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
}

MeasurementFile parse_xml(std::string_view text, const std::string& file) {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
    if (!parsed)
        throw InputError(file, "line " + std::to_string(line_of(text, parsed.offset)),
                         std::string("no XML: ") + parsed.description());
    const pugi::xml_node root = document.document_element();
    const std::string kind = root.name();
    constexpr std::array<std::string_view, 5> kinds{"vit", "vst", "smis", "smms", "measurements"};
    if (std::ranges::find(kinds, kind) == kinds.end())
        throw InputError(file, "<" + kind.substr(0, 40) + ">", "no file of measurements of Valentina or Seamly2D");
    MeasurementFile out{.format = kind.starts_with('s') ? "Seamly2D" : "Valentina"};
    const bool is_multisize = kind == "vst" || kind == "smms";
    Formulas formulas;
    std::vector<std::string> order;
    for (const pugi::xml_node& one : root.child("body-measurements").children("m")) {
        const std::string name = one.attribute("name").value();
        const char* value = one.attribute(is_multisize ? "base" : "value").value();
        if (name.empty() || *value == '\0') continue;
        if (order.size() >= kMostMeasures) throw InputError(file, "", "more than 2,000 measurements");
        if (formulas.emplace(name, value).second) order.push_back(name);
    }
    if (order.empty()) throw InputError(file, "<body-measurements>", "no measurement with a value");
    if (is_multisize) out.notes.emplace_back("a file of several sizes: its base size is taken");
    const double metres = metres_of(root.child_value("unit"));
    for (const std::string& name : order) {
        const std::optional<double> value = value_of_formula(formulas, name);
        if (!value || *value <= 0 || is_angle(name)) {
            if (!value) out.notes.push_back(name + ": '" + formulas[name].substr(0, 60) + "' has no value, left out");
            continue;
        }
        out.lengths.push_back({name, *value * metres});
    }
    if (has_freesewings(out.lengths)) out.notes.emplace_back("its names are FreeSewing's: 'hips' is the high hip");
    out.sex = sex_of(root.child("personal").child_value("gender"));
    return out;
}

}  // namespace

MeasurementFile parse_measurements(std::string_view text, const std::string& file) {
    if (text.size() > kMostBytes) throw InputError(file, "", "larger than 1 MB");
    const std::size_t at = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    if (at == std::string_view::npos) throw InputError(file, "", "empty");
    return text[at] == '<' ? parse_xml(text, file) : parse_yaml(text, file);
}

MeasurementFile read_measurements(const std::filesystem::path& path) {
    return parse_measurements(read_file(path, kMostBytes), path.string());
}

}  // namespace selvedge::sim

#pragma once
// What is wrong in a file: where, and how badly.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/core/json.h"
#include "sim/core/math.h"

namespace selvedge::sim {

enum class Severity { Warning, Error };

struct Fault {
    Severity severity = Severity::Error;
    std::string file;
    std::string place;    // JSON path, e.g. pattern.panels.front.edges[3]
    std::string problem;  // in words
};

// "garment.json: pattern.panels.front.edges[3]: warning: ..."
std::string describe(const Fault& fault);

bool has_error(const std::vector<Fault>& faults);

// Reading JSON that may be wrong anywhere: every step that fails notes a fault with its path and goes on, so that one
// pass lists them all.

// No garment reaches further, m, and squares of it stay exact enough.
inline constexpr double kFarthest = 100;

// A value and its path; no value: not there.
struct JsonNode {
    const Json* value = nullptr;
    std::string path;

    explicit operator bool() const { return value != nullptr; }
    JsonNode member(std::string_view key) const;
    JsonNode element(std::size_t index) const;                     // pre: an array that long
    std::size_t size() const { return value->elements().size(); }  // pre: an array
};

class FaultReader {
 public:
    explicit FaultReader(std::string file) : file_(std::move(file)) {}

    std::size_t error_count() const { return errors_; }
    std::vector<Fault> take_faults() { return std::move(faults_); }

    void error(const JsonNode& node, const std::string& problem);
    void warn(const JsonNode& node, const std::string& problem);

    // Each notes an error and gives nothing (or false) when the value is of another kind, or out of its range.
    bool expect(const JsonNode& node, Json::Kind kind);
    bool expect_array(const JsonNode& node, std::size_t size);
    std::optional<double> number(const JsonNode& node);
    std::optional<int> index(const JsonNode& node, std::size_t count, const char* of_what);
    std::optional<std::string> text(const JsonNode& node);
    std::optional<bool> flag(const JsonNode& node);  // true, false, 1 or 0
    std::optional<Vec2d> pair(const JsonNode& node);
    std::optional<Vec3d> triple(const JsonNode& node);

    // Lengths in file units, as metres; further than 100 m is an error.
    std::optional<double> length(const JsonNode& node);
    std::optional<Vec2d> point(const JsonNode& node);

    double units_in_meter = 100;

 private:
    std::string file_;
    std::vector<Fault> faults_;
    std::size_t errors_ = 0;
};

}  // namespace selvedge::sim

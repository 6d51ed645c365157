#pragma once
// Faults in a file, each with its JSON path and severity, and FaultReader, which reads JSON and records every fault
// instead of stopping at the first.
#include <optional>
#include <span>
#include <string>
#include <string_view>
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
    std::string problem;  // message for the user
};

// The fault on one printable line: "garment.json: pattern.panels.front.edges[3]: warning: ..."
std::string describe(const Fault& fault);

bool has_error(const std::vector<Fault>& faults);

// The largest coordinate that is accepted, m. No garment is larger, and squares of it keep enough precision.
inline constexpr double kMaxCoordinate = 100;

// A file with more faults is not one that was meant to be a pattern, and their texts would fill the memory.
inline constexpr std::size_t kMostFaults = 1000;

// A JSON value and its path. A null `value`: the key does not exist.
struct JsonNode {
    const Json* value = nullptr;
    std::string path;

    explicit operator bool() const { return value != nullptr; }
    JsonNode member(std::string_view key) const;
    JsonNode element(std::size_t index) const;                     // pre: an array with that index
    std::size_t size() const { return value->elements().size(); }  // pre: an array
};

// Reads values of a JSON document that may be wrong anywhere. Each failed access records a fault with the path, and
// reading continues, so that one run lists all faults: of errors and of warnings, the first kMostFaults each.
class FaultReader {
 public:
    explicit FaultReader(std::string file) : file_(std::move(file)) {}

    std::size_t error_count() const { return errors_; }
    std::vector<Fault> take_faults() { return std::move(faults_); }

    void error(const JsonNode& node, const std::string& problem);
    void warn(const JsonNode& node, const std::string& problem);

    // Warns of each key of the object that is none of these, with the one that is nearly spelt so, if there is one. For
    // objects that only Selvedge writes: what another program adds to its own is not unknown.
    void warn_of_unknown_keys(const JsonNode& object, std::span<const std::string_view> known);

    // Each records an error and returns nullopt (or false) if the value is of the wrong kind or out of range.
    bool expect(const JsonNode& node, Json::Kind kind);
    bool expect_array(const JsonNode& node, std::size_t size);
    std::optional<double> number(const JsonNode& node);
    std::optional<int> index(const JsonNode& node, std::size_t count, const char* of_what);
    std::optional<std::string> text(const JsonNode& node);
    std::optional<bool> flag(const JsonNode& node);  // true, false, 1 or 0
    std::optional<int> whole_number(const JsonNode& node, int least, int most);
    std::optional<std::size_t> choice(const JsonNode& node, std::span<const std::string_view> names);  // its index
    std::optional<Vec2d> pair(const JsonNode& node);
    std::optional<Vec3d> triple(const JsonNode& node);

    // Read lengths in file units and return metres. An absolute value over 100 m is an error.
    std::optional<double> length(const JsonNode& node);
    std::optional<Vec2d> point(const JsonNode& node);

    double units_in_meter = 100;

 private:
    void add(Severity severity, const JsonNode& node, const std::string& problem, std::size_t count);

    std::string file_;
    std::vector<Fault> faults_;
    std::size_t errors_ = 0;
    std::size_t warnings_ = 0;
};

}  // namespace selvedge::sim

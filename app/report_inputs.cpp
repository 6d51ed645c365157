#include "app/report_inputs.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "sim/core/sha256.h"
#include "sim/pattern/surface_design.h"

namespace selvedge::app {
namespace {

using Path = std::filesystem::path;

class Inputs {
 public:
    // A file that was added before is left out.
    void add(std::string_view role, const Path& file) {
        const auto is_same = [&](const sim::ReportInput& known) { return known.file == file.string(); };
        if (std::ranges::any_of(list_, is_same)) return;
        list_.push_back({std::string(role), file.string(), sim::sha256_of_file(file)});
    }
    // What names a shipped thing, or a file that ends in .json.
    void add_named(std::string_view role, const std::string& name_or_file) {
        if (name_or_file.ends_with(".json")) add(role, name_or_file);
    }
    void add(const std::optional<sim::SurfaceDesign>& design) {
        if (!design) return;
        if (design->kind == sim::DesignKind::Tartan) add_named("tartan", design->source);
        if (design->kind == sim::DesignKind::Picture) add("picture", design->source);
    }
    std::vector<sim::ReportInput> take() { return std::move(list_); }

 private:
    std::vector<sim::ReportInput> list_;
};

}  // namespace

std::vector<sim::ReportInput> report_inputs(const GarmentOptions& options, const BodyOptions& body,
                                            const sim::Pattern& pattern) {
    Inputs inputs;
    inputs.add("garment", options.garment);
    for (const Path& over : options.over) inputs.add("over", over);
    if (body.is_file()) inputs.add("body", body.source);
    inputs.add_named("fabric", options.fabric.empty() ? pattern.fabric : options.fabric);
    for (const sim::Panel& panel : pattern.panels) {
        if (options.fabric.empty()) inputs.add_named("fabric", panel.fabric);
        for (const std::string& interlining : panel.interlinings) inputs.add_named("fabric", interlining);
        inputs.add(panel.surface);
    }
    inputs.add_named("tartan", pattern.tartan);
    inputs.add(pattern.surface);
    return inputs.take();
}

}  // namespace selvedge::app

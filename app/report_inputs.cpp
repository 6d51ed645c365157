#include "app/report_inputs.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "app/body_buffers.h"
#include "sim/core/sha256.h"
#include "sim/pattern/named_file.h"

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
    void add_text(std::string_view role, const std::string& text) {
        list_.push_back({std::string(role), text, sim::sha256(text)});
    }
    std::vector<sim::ReportInput> take() { return std::move(list_); }

 private:
    std::vector<sim::ReportInput> list_;
};

}  // namespace

std::vector<sim::ReportInput> report_inputs(const GarmentOptions& options, const BodyOptions& body,
                                            const sim::Pattern& shown, const std::string& motion) {
    Inputs inputs;
    inputs.add("garment", options.garment);
    for (const Path& over : options.over) inputs.add("over", over);
    if (body.is_file()) {
        inputs.add("body", body.source);
        for (const Path& buffer : buffers_beside(body.source)) inputs.add("body", buffer);
    } else {
        inputs.add_text("body", body.source);
    }
    if (!motion.empty()) inputs.add("motion", motion);
    for (const sim::NamedFileUse& named : named_file_uses(shown)) {
        if (named.use == sim::FileUse::Fabric) inputs.add("fabric", named.file);
        if (named.use == sim::FileUse::Picture) inputs.add("picture", named.file);
    }
    return inputs.take();
}

}  // namespace selvedge::app

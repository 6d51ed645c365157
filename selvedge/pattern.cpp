#include "selvedge/pattern.h"

#include <utility>

#include "render/output/pattern_faults.h"
#include "selvedge/content.h"
#include "sim/core/assert.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/pattern_file.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge {
namespace {

std::vector<Fault> public_faults(const std::vector<sim::Fault>& found) {
    std::vector<Fault> faults;
    for (const sim::Fault& fault : found) {
        const Severity severity = fault.severity == sim::Severity::Error ? Severity::Error : Severity::Warning;
        faults.push_back({.severity = severity, .file = fault.file, .place = fault.place, .problem = fault.problem});
    }
    return faults;
}

Pattern pattern_of(sim::PatternDocument document, const std::string& file) {
    return Pattern(std::make_shared<const Pattern::Content>(Pattern::Content{std::move(document), file}));
}

}  // namespace

Pattern::Pattern(std::shared_ptr<const Content> content) : content_(std::move(content)) {
    SELVEDGE_ASSERT(content_ != nullptr);
}

Pattern::Pattern(const Pattern&) = default;

Pattern& Pattern::operator=(const Pattern&) = default;

Pattern::~Pattern() = default;

const std::string& Pattern::name() const {
    return content_->document.pattern.name;
}

std::vector<std::string> Pattern::panel_names() const {
    std::vector<std::string> names;
    for (const sim::Panel& panel : content_->document.pattern.panels) names.push_back(panel.name);
    return names;
}

std::vector<std::string> Pattern::seam_names() const {
    const sim::Pattern& pattern = content_->document.pattern;
    std::vector<std::string> names;
    for (const sim::Seam& seam : pattern.seams) names.push_back(seam_name(pattern, seam));
    return names;
}

std::string Pattern::text() const {
    return for_caller([&] { return sim::write_pattern(content_->document); });
}

std::vector<Fault> Pattern::faults() const {
    return for_caller([&] {
        const auto& [document, file] = *content_;
        std::vector<sim::Fault> faults = sim::check_pattern_text(sim::write_pattern(document), file);
        if (!has_error(faults)) render::add_faults_of_dressing(document.pattern, file, faults);
        return public_faults(faults);
    });
}

Pattern load_pattern(const std::filesystem::path& file) {
    return for_caller([&] { return pattern_of(sim::load_pattern(file), file.string()); });
}

Pattern parse_pattern(std::string_view text, const std::string& name) {
    return for_caller([&] { return pattern_of(sim::parse_pattern(text, name), name); });
}

std::vector<Fault> check_pattern(const std::filesystem::path& file) {
    return for_caller([&] { return public_faults(render::faults_of_file(file)); });
}

std::vector<std::string> fabric_names() {
    return sim::fabric_names();
}

std::vector<std::string> tartan_names() {
    return sim::shipped_tartans();
}

}  // namespace selvedge

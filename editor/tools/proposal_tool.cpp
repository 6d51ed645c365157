#include "editor/tools/proposal_tool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "editor/geometry/draft.h"
#include "editor/tools/sewing_tools.h"
#include "editor/tools/sheet_geometry.h"
#include "sim/pattern/segment_distance.h"

namespace selvedge::editor {
namespace {

constexpr double kLeastConfidence = 0.15;

std::vector<Vec2d> line_of(const SheetGeometry& geometry, const sim::Pattern& pattern, const sim::EdgeSpan& span) {
    const PanelShape* shape = geometry.find(pattern.panels[static_cast<std::size_t>(span.panel)].name);
    if (shape == nullptr || static_cast<std::size_t>(span.edge) >= shape->edges.size()) return {};
    return part_of_edge(*shape, span.edge, span.from, span.to);
}

// Between the middles of both sides' longest stretches.
std::vector<Vec2d> link_of(const SheetGeometry& geometry, const sim::Pattern& pattern,
                           const sim::SeamProposal& proposal) {
    const auto& part = proposal.parts[proposal.parts.size() / 2];
    const std::vector<Vec2d> first = line_of(geometry, pattern, part.first);
    const std::vector<Vec2d> second = line_of(geometry, pattern, part.second);
    if (first.empty() || second.empty()) return {};
    return {first[first.size() / 2], second[second.size() / 2]};
}

// "a to b (90 %): lengths 3 and 3 cm; same shape" in lines.
std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines{""};
    for (const char c : text) {
        const bool ends = c == ';' || (c == ':' && lines.size() == 1);
        if (ends) lines.emplace_back();
        if (!ends && (c != ' ' || !lines.back().empty())) lines.back() += c;
    }
    return lines;
}

bool may_be_sewn(const sim::Pattern& pattern, const PanelStates& states, const sim::SeamProposal& proposal) {
    const auto may = [&](const sim::EdgeSpan& span) {
        return states.may_be_picked(pattern.panels[static_cast<std::size_t>(span.panel)].name);
    };
    return std::ranges::all_of(proposal.parts, [&](const auto& part) { return may(part.first) && may(part.second); });
}

SpanRef ref_of(const sim::Pattern& pattern, const sim::EdgeSpan& span) {
    return {pattern.panels[static_cast<std::size_t>(span.panel)].name, span.edge, span.from, span.to};
}

const ToolInfo kProposals{.id = "propose_seams",
                          .title = "Propose seams",
                          .what = "Go through the seams that the pattern probably has",
                          .make = make<ProposalTool>,
                          .icon = "M3 3 L3 13 M13 3 L13 13 M5 8 L11 8",
                          .is_drawing = false};

}  // namespace

void ProposalTool::refresh(const ToolContext& context) {
    const Document& document = context.document;
    if (is_of_now(document) || document.is_previewing()) return;
    revision_ = document.revision();
    states_ = document.panel_states();
    proposals_ = propose_seams(document.pattern(), {.least_confidence = kLeastConfidence, .hints = document.hints()});
    std::erase_if(proposals_, [&](const sim::SeamProposal& proposal) {
        return std::ranges::find(refused_, proposal.parts.front()) != refused_.end() ||
               !may_be_sewn(document.pattern(), states_, proposal);
    });
    marked_ = 0;
    is_turned_ = false;
}

bool ProposalTool::is_of_now(const Document& document) const {
    return revision_ == document.revision() && states_ == document.panel_states();
}

bool ProposalTool::is_current(const ToolContext& context) const {
    return is_of_now(context.document) && marked_ < proposals_.size();
}

void ProposalTool::hover(ToolContext& context, const SheetPointer& pointer) {
    Tool::hover(context, pointer);
    refresh(context);
}

void ProposalTool::click(ToolContext& context, const SheetPointer& pointer) {
    refresh(context);
    double nearest = kPickTolerance * context.px;
    for (std::size_t i = 0; i < proposals_.size(); ++i) {
        const std::vector<Vec2d> link = link_of(context.geometry, context.document.pattern(), proposals_[i]);
        if (link.empty()) continue;
        const double distance = sim::distance_to_segment(pointer.at, link[0], link[1]);
        if (distance > nearest) continue;
        nearest = distance;
        marked_ = i;
        is_turned_ = false;
    }
}

bool ProposalTool::key(ToolContext& context, Key key, const Modifiers& modifiers) {
    refresh(context);
    if (modifiers.ctrl || proposals_.empty()) return false;
    if (key == Key::Enter) return accept(context), true;
    if (key == Key::Delete || key == Key::Backspace) return refuse(), true;
    if (key == key_of('R')) return is_turned_ = !is_turned_, true;
    if (key != Key::Tab) return false;
    const std::size_t count = proposals_.size();
    marked_ = (marked_ + (modifiers.shift ? count - 1 : 1)) % count;
    is_turned_ = false;
    return true;
}

bool ProposalTool::enter(ToolContext& context, const std::vector<double>&) {
    accept(context);
    return true;
}

bool ProposalTool::cancel(ToolContext&) {
    const bool has_refused = !refused_.empty();
    refused_.clear();
    revision_.reset();
    return has_refused;
}

// The start of the first run meets the end of the second, so the second goes along its outline from the last part on.
void ProposalTool::accept(ToolContext& context) {
    if (!is_current(context)) return;
    const sim::SeamProposal& proposal = proposals_[marked_];
    SewRuns sewn{.first = {}, .second = {}, .is_reversed = !is_turned_};
    for (const auto& [first, second] : proposal.parts) {
        sewn.first.push_back(ref_of(context.document.pattern(), first));
        sewn.second.insert(sewn.second.begin(), ref_of(context.document.pattern(), second));
    }
    context.document.run(sewn);
    refresh(context);
}

void ProposalTool::refuse() {
    refused_.push_back(proposals_[marked_].parts.front());
    proposals_.erase(proposals_.begin() + static_cast<std::ptrdiff_t>(marked_));
    if (marked_ >= proposals_.size()) marked_ = 0;
    is_turned_ = false;
}

void ProposalTool::draw(const ToolContext& context, ToolOverlay& overlay) const {
    overlay.shows_sewing = true;
    if (!is_current(context)) return;
    const sim::Pattern& pattern = context.document.pattern();
    for (std::size_t i = 0; i < proposals_.size(); ++i) {
        const std::vector<Vec2d> link = link_of(context.geometry, pattern, proposals_[i]);
        if (link.empty()) continue;
        const bool is_marked = i == marked_;
        const OverlayTone tone = is_marked ? OverlayTone::Draft : OverlayTone::Measure;
        overlay.lines.push_back({.points = link, .tone = tone, .is_dashed = true});
        std::array<char, 16> text{};
        std::snprintf(text.data(), text.size(), "%.0f %%", 100 * proposals_[i].confidence);
        overlay.labels.push_back({.at = (link[0] + link[1]) / 2, .text = text.data(), .tone = tone});
        if (!is_marked) continue;
        for (const auto& [first, second] : proposals_[i].parts) {
            std::vector<Vec2d> there = line_of(context.geometry, pattern, second);
            if (!is_turned_) std::ranges::reverse(there);
            overlay.lines.push_back({.points = line_of(context.geometry, pattern, first), .tone = tone});
            overlay.lines.push_back({.points = there, .tone = tone});
            add_seam_lines(overlay, line_of(context.geometry, pattern, first), there, OverlayTone::Faint);
        }
        overlay.readout = lines_of(describe(pattern, proposals_[i]));
    }
}

std::string ProposalTool::hint(const ToolContext& context) const {
    if (!is_current(context)) return "No seams to propose: all edges are sewn, or none are alike";
    return std::to_string(marked_ + 1) + " of " + std::to_string(proposals_.size()) +
           ": Enter sews it, Delete refuses it, R turns it round, Tab goes on";
}

const ToolInfo& proposal_tool() {
    return kProposals;
}

}  // namespace selvedge::editor

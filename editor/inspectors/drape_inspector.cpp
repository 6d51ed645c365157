#include "editor/inspectors/drape_inspector.h"

#include <imgui.h>
#include <algorithm>
#include <cstdio>

#include "editor/inspectors/controls.h"
#include "editor/inspectors/number_box.h"
#include "sim/core/math.h"

namespace selvedge::editor {
namespace {

std::string printed(const char* format, double value) {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
}

}  // namespace

std::string stage_sentence(sim::SessionStage stage, bool is_running) {
    switch (stage) {
        case sim::SessionStage::Empty:
            return "Empty: there is nothing to drape";
        case sim::SessionStage::Placed:
            return is_running ? "Loading panels" : "Placed: panels stand round the body";
        case sim::SessionStage::Sewing:
            return is_running ? "Sewing: seams close" : "Sewing, paused";
        case sim::SessionStage::Draping:
            return is_running ? "Draping: the garment falls" : "Draping, paused";
        case sim::SessionStage::Moving:
            return is_running ? "Moving: the body carries the garment along" : "Moving, paused";
        case sim::SessionStage::Settled:
            return "Settled: at rest";
        case sim::SessionStage::Failed:
            break;
    }
    return "Failed: it cannot go on";
}

std::string seconds_text(double seconds) {
    return printed("%.1f s", seconds);
}

std::string milliseconds_text(double milliseconds) {
    return printed(milliseconds < 10 ? "%.2f ms" : "%.1f ms", milliseconds);
}

std::string speed_text(double metres_per_second) {
    return printed("%.1f cm/s", 100 * metres_per_second);
}

std::string count_text(int count) {
    std::string text = std::to_string(count);
    for (std::size_t i = text.size(); i > 3 && text[i - 4] != '-'; i -= 3) text.insert(i - 3, ",");
    return text;
}

sim::CurvatureOptions curvature_with(sim::CurvatureOptions options, std::optional<double> split,
                                     std::optional<double> rejoin) {
    constexpr float kBelow = 0.95F;
    if (split) {
        options.split_angle = static_cast<float>(*split);
        options.rejoin_angle = std::min(options.rejoin_angle, kBelow * options.split_angle);
    }
    if (rejoin) options.rejoin_angle = std::min(static_cast<float>(*rejoin), kBelow * options.split_angle);
    return options;
}

std::string free_drape_name(const std::vector<std::string>& kept, const std::string& wanted) {
    const std::string base = wanted.empty() ? "drape" : wanted;
    std::string name = base;
    for (int number = 2; std::find(kept.begin(), kept.end(), name) != kept.end(); ++number) {
        name = base + " " + std::to_string(number);
    }
    return name;
}

void DrapeTrace::take(const sim::SessionFrame& frame) {
    if (frame.number < last_number_) *this = {};
    if (frame.number == last_number_) return;
    last_number_ = frame.number;
    if (!frame.is_running) return;
    if (size_ == kLength) {
        first_ = (first_ + 1) % kLength;
    } else {
        ++size_;
    }
    rows_[place(size_ - 1)] = {.frame_ms = static_cast<float>(frame.statistics.times.frame),
                               .triangles = static_cast<float>(frame.statistics.leaf_triangles)};
}

// The drape inspector: state, statistics, and the settings of the adaptive mesh.

namespace {

constexpr int kMaxLevels = 6;
constexpr double kShortestEdge = 0.002, kLongestEdge = 0.2;  // m
constexpr int kMinTriangles = 100, kMaxTriangles = 200000;

void draw_buttons(InspectorContext& context, const sim::SessionFrame& frame) {
    sim::Session& session = context.workspace.drape.session();
    ButtonRow row(context);
    if (row.button(
            {.name = "drape.run",
             .title = frame.is_running ? "Pause" : "Start",
             .tip = with_key(context, frame.is_running ? "Holds the cloth still" : "Sews the panels and lets them fall",
                             "simulate.run")})) {
        if (frame.is_running) {
            session.pause();
        } else {
            session.start();
        }
    }
    if (row.button(
            {.name = "drape.reset",
             .title = "Reset",
             .tip = with_key(context, "Puts the panels back to where they are placed, unsewn", "simulate.reset")})) {
        context.workspace.drape.reset();
    }
    if (row.button({.name = "drape.unpin",
                    .title = "Unpin all",
                    .tip = with_key(context, "Lets go of all points that were pinned by hand", "simulate.unpin"),
                    .is_enabled = !frame.pins.empty()})) {
        session.unpin_all();
    }
}

// A row that lights up its place on the sheet and in the 3D view while it is chosen or hovered.
void draw_finding(InspectorContext& context, const Finding& finding, std::size_t index) {
    DrapeState& state = context.state.drape;
    const std::string name = "drape.finding." + std::to_string(index);
    const bool is_fault = finding.kind != FindingKind::Note;
    const float mark = ImGui::GetFontSize(), wrap = ImGui::GetContentRegionAvail().x - mark;
    const ImVec2 size = ImGui::CalcTextSize(finding.text.c_str(), nullptr, false, wrap);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const bool is_chosen = state.lit_finding == index;
    if (ImGui::Selectable(("##" + name).c_str(), is_chosen, 0, {0, size.y}))
        state.lit_finding = is_chosen ? std::nullopt : std::optional(index);
    note_widget(context, name);
    if (ImGui::IsItemHovered()) state.hovered_finding = index;
    show_tip(finding.place.is_empty() ? "Its place is not known" : "Click to see where it is");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec4 colour = to_colour(is_fault ? context.theme.error : context.theme.warning);
    list.AddCircleFilled({low.x + 0.4F * mark, low.y + 0.5F * mark}, 0.22F * mark, ImGui::GetColorU32(colour));
    list.AddText(nullptr, 0, {low.x + mark, low.y}, ImGui::GetColorU32(ImGuiCol_Text), finding.text.c_str(), nullptr,
                 wrap);
}

void draw_fit_table(InspectorContext& context, const sim::DressReport& report) {
    for (const sim::FitRow& row : report.fit) {
        if (!row.body_girth || !row.garment_girth) continue;
        std::string measure(row.measure);
        std::ranges::replace(measure, '_', ' ');
        std::string text(96, '\0');
        text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%.1f on %.1f cm: %+.1f",
                                                           100 * *row.garment_girth, 100 * *row.body_girth,
                                                           100 * *row.ease())));
        fact(
            context, measure.c_str(), text,
            "The garment's girth as it was cut, the body's, and the ease between them. Negative: the cloth stretches.");
    }
}

void draw_findings(InspectorContext& context, const sim::SessionFrame& frame) {
    DrapeState& state = context.state.drape;
    state.hovered_finding.reset();
    if (frame.report != state.report || frame.motion.faults.size() != state.motion_faults) {
        state.report = frame.report;
        state.motion_faults = frame.motion.faults.size();
        state.lit_finding.reset();
    }
    if (!frame.report && frame.motion.faults.empty()) return;
    if (!folding("Fit and faults", Fold::Open)) return;
    const std::vector<Finding> findings = findings_of(frame, context.pattern());
    for (std::size_t i = 0; i < findings.size(); ++i) draw_finding(context, findings[i], i);
    if (findings.empty()) paragraph(context, "Nothing is wrong with how it hangs.");
    if (frame.report) draw_fit_table(context, *frame.report);
    const std::optional<std::size_t> lit = state.hovered_finding ? state.hovered_finding : state.lit_finding;
    if (lit && *lit < findings.size()) context.workspace.lit = findings[*lit].place;
}

void draw_statistics(InspectorContext& context, const sim::SessionFrame& frame) {
    const sim::SessionStatistics& now = frame.statistics;
    fact(context, "Simulated", seconds_text(now.simulated_seconds), "How long the cloth has fallen, by its own clock.");
    fact(context, "Speed", speed_text(now.rms_speed), "How fast the cloth moves, as a mean.");
    fact(context, "Triangles", count_text(now.leaf_triangles) + " of " + count_text(now.base_triangles) + " coarse",
         "Triangles that are simulated now, and those of the coarsest mesh.");
    fact(context, "Last step", count_text(now.splits) + " split, " + count_text(now.rejoins) + " rejoined",
         "Edges that the last adaptation split or put together again.");
}

void draw_levels(InspectorContext& context, const sim::SessionFrame& frame) {
    const std::vector<int>& levels = frame.statistics.by_level;
    if (levels.empty()) return;
    ImGui::TextUnformatted(elided("Triangles per level", ImGui::GetContentRegionAvail().x).c_str());
    bar_chart(context, {.values = levels,
                        .tip =
                            [&](std::size_t level) {
                                return "Level " + std::to_string(level) + ": " + count_text(levels[level]) +
                                       " triangles";
                            },
                        .colour = [&](std::size_t) { return context.theme.accent; }});
}

void draw_spark(InspectorContext& context, const char* label, const std::string& value, SparkLine line) {
    row_label(context, label, line.tip);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(elided(value, field_width()).c_str());
    line.full = DrapeTrace::kLength;
    line.count = context.state.drape.trace.size();
    spark_line(context, line);
}

void draw_times(InspectorContext& context, const sim::SessionFrame& frame) {
    const sim::SessionTimes& times = frame.statistics.times;
    const DrapeTrace& trace = context.state.drape.trace;
    fact(context, "Adaptation", milliseconds_text(times.adaptation), "Splitting and rejoining edges, once per frame.");
    fact(context, "Steps", milliseconds_text(times.steps), "All steps of one frame: forces, constraints, contacts.");
    draw_spark(context, "Frame", milliseconds_text(times.frame),
               {.value = [&](std::size_t i) { return trace.frame_ms(i); }, .tip = "What the last 120 frames took."});
    draw_spark(context, "Triangles", count_text(frame.statistics.leaf_triangles),
               {.value = [&](std::size_t i) { return trace.triangles(i); },
                .tip = "How many triangles the last 120 frames had."});
}

void draw_criteria(InspectorContext& context, sim::SessionOptions& options) {
    sim::CriteriaOptions& criteria = options.criteria;
    paragraph(context, "Edges are split");
    if (check_box(context, "drape.collision", "where the body is near", criteria.collision,
                  "Finer where the body's surface is rounder than the cloth's triangles."))
        criteria.collision = !criteria.collision;
    if (check_box(context, "drape.curvature", "where it bends", criteria.curvature,
                  "Finer where the cloth's surface bends."))
        criteria.curvature = !criteria.curvature;
    if (check_box(context, "drape.length", "where it is compressed", criteria.length,
                  "Finer where edges are shorter than they want to be: there it must wrinkle."))
        criteria.length = !criteria.length;
    if (check_box(context, "drape.buckling", "where it is about to buckle", criteria.buckling,
                  "Finer already before folds form."))
        criteria.buckling = !criteria.buckling;
    const NumberEdit split = number_row(context,
                                        {.name = "drape.split_angle",
                                         .value = options.curvature.split_angle,
                                         .unit = Unit::Degrees,
                                         .tip = "An edge splits where the cloth turns by more than this along it.",
                                         .least = 1 * sim::kDegree,
                                         .most = 90 * sim::kDegree},
                                        "Split from");
    const NumberEdit rejoin = number_row(context,
                                         {.name = "drape.rejoin_angle",
                                          .value = options.curvature.rejoin_angle,
                                          .unit = Unit::Degrees,
                                          .tip = "It is put together again where it turns by less; below the other.",
                                          .least = 0.1 * sim::kDegree,
                                          .most = 90 * sim::kDegree},
                                         "Rejoin below");
    options.curvature =
        curvature_with(options.curvature, split ? split.value : std::nullopt, rejoin ? rejoin.value : std::nullopt);
}

void draw_fineness(InspectorContext& context, sim::SessionOptions& options) {
    const NumberEdit level = number_row(context,
                                        {.name = "drape.max_level",
                                         .value = options.max_level,
                                         .unit = Unit::Whole,
                                         .tip = "How often an edge may be halved. Each level has four times as many "
                                                "triangles, at most.",
                                         .least = 0,
                                         .most = kMaxLevels},
                                        "Levels");
    if (level) options.max_level = static_cast<int>(level.value.value_or(options.max_level));
    const NumberEdit shortest = number_row(context,
                                           {.name = "drape.shortest_edge",
                                            .value = options.shortest_edge,
                                            .tip = "Shorter edges are not split, whatever the levels allow.",
                                            .least = kShortestEdge,
                                            .most = kLongestEdge},
                                           "Shortest edge");
    if (shortest) options.shortest_edge = shortest.value.value_or(options.shortest_edge);
    const NumberEdit budget =
        number_row(context,
                   {.name = "drape.budget",
                    .value = options.triangle_budget ? std::optional<double>(*options.triangle_budget) : std::nullopt,
                    .unit = Unit::Whole,
                    .tip = "About so many triangles are kept to. Empty: as many as are asked for.",
                    .least = kMinTriangles,
                    .most = kMaxTriangles,
                    .may_be_empty = true},
                   "Triangles");
    if (check_box(context, "drape.back_faces", "Coarse where it faces away", options.coarsens_back_faces,
                  "Fewer triangles where the cloth's right side faces away from the viewer. Turning the view makes the "
                  "cloth move again."))
        options.coarsens_back_faces = !options.coarsens_back_faces;
    if (!budget) return;
    options.triangle_budget = budget.value ? std::optional<int>(static_cast<int>(*budget.value)) : std::nullopt;
}

void draw_world(InspectorContext& context, sim::SessionOptions& options) {
    if (check_box(context, "drape.gravity", "Gravity", options.has_gravity, "Without it the cloth floats."))
        options.has_gravity = !options.has_gravity;
    if (check_box(context, "drape.self_collision", "Self-collision", options.self_collision,
                  "Cloth stays apart from itself. Off: it passes through itself, which is faster. Garments over each "
                  "other need it."))
        options.self_collision = !options.self_collision;
    if (check_box(context, "drape.real_time", "Real time", options.keeps_real_time,
                  "A second of cloth takes a second, if the machine can. Off: as fast as it can."))
        options.keeps_real_time = !options.keeps_real_time;
}

void draw_kept(InspectorContext& context) {
    DrapeState& state = context.state.drape;
    sim::Session& session = context.workspace.drape.session();
    const auto name = text_box(context, {.name = "drape.name",
                                         .text = state.name,
                                         .hint = free_drape_name(state.kept, ""),
                                         .tip = "The name to keep the drape under.",
                                         .width_px = ImGui::GetContentRegionAvail().x});
    if (name) state.name = *name;
    ButtonRow row(context);
    if (row.button({.name = "drape.keep",
                    .title = "Keep this drape",
                    .tip = "Remembers how the cloth hangs now, to come back to."})) {
        state.kept.push_back(free_drape_name(state.kept, state.name));
        session.save_drape(state.kept.back());
        state.name.clear();
    }
    if (state.kept.empty()) return paragraph(context, "Drapes that are kept are listed here.");
    for (const std::string& kept : state.kept) {
        const std::string item = "drape.kept." + kept;
        if (ImGui::Selectable((elided(kept, ImGui::GetContentRegionAvail().x) + "##" + item).c_str())) {
            session.restore_drape(kept);
        }
        show_tip(kept + "\nClick to go back to it, where the panels still have the same mesh.");
        note_widget(context, item);
    }
}

}  // namespace

void draw_drape(InspectorContext& context) {
    ImGui::PushID("drape");
    const std::shared_ptr<const sim::SessionFrame> frame = context.workspace.drape.frame();
    sim::SessionOptions& options = context.workspace.drape.options();
    draw_buttons(context, *frame);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(stage_sentence(frame->stage, frame->is_running).c_str());
    ImGui::PopTextWrapPos();
    if (!frame->problem.empty()) message_text(context.theme.error, frame->problem);
    draw_findings(context, *frame);
    draw_statistics(context, *frame);
    draw_levels(context, *frame);
    if (context.shows_times && folding("Cost", Fold::Open)) draw_times(context, *frame);
    if (folding("Fineness", Fold::Open)) {
        draw_fineness(context, options);
        draw_criteria(context, options);
    }
    if (folding("Surroundings", Fold::Open)) draw_world(context, options);
    if (folding("Kept drapes", Fold::Open)) draw_kept(context);
    ImGui::PopID();
}

}  // namespace selvedge::editor

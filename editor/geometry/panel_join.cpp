// Implements merge_panels, unfold_panel and insert_dart of panel_edit.h.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "editor/geometry/draft.h"
#include "editor/geometry/edge_remap.h"
#include "editor/geometry/panel_edit.h"
#include "sim/pattern/edge_keys.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/field_moves.h"
#include "sim/pattern/outline.h"

namespace selvedge::editor {
namespace {

constexpr double kSameShape = 1e-3;  // m, largest distance between the two sides of a merged seam

// Merges panel b into panel a along a run of consecutive seams between them. The runs have opposite directions: a's
// first edge is sewn to b's last.
class Merger {
 public:
    Merger(sim::Pattern& draft, const sim::Seam& seam)
        : draft_(draft),
          a_(seam.first.panel),
          b_(seam.second.panel),
          a_first_(seam.first.edge),
          b_first_(seam.second.edge) {}

    Merged merge() {
        const Eigen::Affine2d map = map_of_seam();
        other_ = mapped_panel(b(), map);
        if (!lie_together(a_first_, b_first_)) {
            throw GeometryError("The sides of the seam have different shapes.",
                                {place_of(draft_, {a_, a_first_}), place_of(draft_, {b_, b_first_})});
        }
        extend();
        const std::vector<std::string> notes = differences();
        meet_ends();
        join();
        const int joined = a_ - (b_ < a_ ? 1 : 0);
        unlink(draft_, a_);
        drop_panels(draft_, {b_});
        return {.panel = joined, .notes = notes};
    }

 private:
    sim::Panel& a() { return draft_.panels[as_size(a_)]; }
    sim::Panel& b() { return draft_.panels[as_size(b_)]; }

    const sim::OutlineEdge& edge(const sim::Panel& panel, int index) const { return panel.edges[as_size(index)]; }
    int a_edge(int i) { return (a_first_ + i + edge_count(a())) % edge_count(a()); }
    int b_edge(int i) { return (b_first_ + i + edge_count(b())) % edge_count(b()); }

    Eigen::Affine2d map_of_seam() {
        const sim::OutlineEdge& own = edge(a(), a_first_);
        const sim::OutlineEdge& other = edge(b(), b_first_);
        const Vec2d from = b().vertices[as_size(other.end)];
        const Vec2d to = b().vertices[as_size(other.start)];
        const Vec2d start = a().vertices[as_size(own.start)];
        const Vec2d end = a().vertices[as_size(own.end)];
        Eigen::Affine2d map = sim::chord_map(from, to, start, end);
        map.linear() /= std::sqrt(map.linear().determinant());  // rigid: remove the scale
        map.translation() = (start + end) / 2 - map.linear() * (from + to) / 2;
        return map;
    }

    // What the moved panel had otherwise than the one that stays, whose values the whole then has.
    std::vector<std::string> differences() {
        std::vector<std::string> notes;
        const auto tell = [&](const std::string& what) {
            notes.push_back("'" + b().name + "' was merged into '" + a().name + "': " + what);
        };
        constexpr double kSameGrain = 0.1;  // degrees
        const double turned =
            std::remainder(other_.grain_angle - a().grain_angle, std::numbers::pi);  // warps have no end
        const double degrees = std::abs(turned) * 180 / std::numbers::pi;
        if (degrees > kSameGrain) {
            std::array<char, 96> text{};
            std::snprintf(text.data(), text.size(), "its grain ran %.1f degrees off and is now that of '", degrees);
            tell(text.data() + a().name + "'");
        }
        if (a().fabric != b().fabric) tell("it is now made of the same fabric");
        if (a().surface != b().surface) tell("it now shows the same");
        return notes;
    }

    bool lie_together(int own, int other) {
        const sim::OutlineEdge& one = edge(a(), own);
        const sim::OutlineEdge& two = edge(other_, other);
        if (std::abs(outline_length(a(), one) - outline_length(other_, two)) > kSameShape) return false;
        constexpr int kSamples = 16;
        for (int i = 0; i <= kSamples; ++i) {
            const double t = double(i) / kSamples;
            if ((outline_point(a(), one, t) - outline_point(other_, two, 1 - t)).norm() > kSameShape) return false;
        }
        return true;
    }

    bool are_joined(int own, int other) {
        const auto found = seam_at(draft_, {a_, own});
        if (!found) return false;
        const sim::Seam& seam = draft_.seams[as_size(*found)];
        const sim::SeamSide& across = seam.first == sim::SeamSide{a_, own} ? seam.second : seam.first;
        return seam.is_reversed && across == sim::SeamSide{b_, other} && lie_together(own, other);
    }

    // Extends the run by adjacent seams between the same panels, which would otherwise leave a slit.
    void extend() {
        const int most = std::min(edge_count(a()), edge_count(b())) - 1;
        while (count_ < most && are_joined(a_edge(count_), b_edge(-1))) {
            ++count_;
            b_first_ = b_edge(-1);
        }
        while (count_ < most && are_joined(a_edge(-1), b_edge(count_))) {
            ++count_;
            a_first_ = a_edge(-1);
        }
    }

    // Moves the ends of b's run exactly onto those of a's.
    void meet_ends() {
        a_start_ = edge(a(), a_first_).start;
        a_end_ = edge(a(), a_edge(count_ - 1)).end;
        b_start_ = edge(b(), b_first_).start;
        b_end_ = edge(b(), b_edge(count_ - 1)).end;
        for (const auto& [vertex, to] : {std::pair{b_start_, a_end_}, std::pair{b_end_, a_start_}}) {
            sim::VertexMove move{std::vector<bool>(other_.vertices.size(), false), Eigen::Affine2d::Identity()};
            move.is_moved[as_size(vertex)] = true;
            move.map.translation() = a().vertices[as_size(to)] - other_.vertices[as_size(vertex)];
            move_outline(other_, move);
        }
    }

    void join() {
        sim::Panel joined = a();
        const int a_count = edge_count(joined);
        const int b_rest = edge_count(other_) - count_;
        const int shift = static_cast<int>(joined.vertices.size());
        const auto vertex = [&](int v) { return v == b_start_ ? a_end_ : v == b_end_ ? a_start_ : v + shift; };
        const int wrapped = std::max(0, a_first_ + count_ - a_count);
        const int base = a_first_ - wrapped;
        const auto a_image = [&](int e) -> std::optional<EdgeImage> {
            if ((e - a_first_ + a_count) % a_count < count_) return {};
            return EdgeImage{{a_, e < a_first_ ? e - wrapped : e - count_ + b_rest}};
        };
        const auto b_image = [&](int e) -> std::optional<EdgeImage> {
            const int along = (e - b_first_ + edge_count(other_)) % edge_count(other_) - count_;
            if (along < 0) return {};
            return EdgeImage{{a_, base + along}};
        };
        joined.edges.assign(as_size(a_count - count_ + b_rest), {});
        for (int e = 0; e < a_count; ++e) {
            if (const auto image = a_image(e)) joined.edges[as_size(image->side.edge)] = a().edges[as_size(e)];
        }
        for (int e = 0; e < edge_count(other_); ++e) {
            const auto image = b_image(e);
            if (!image) continue;
            sim::OutlineEdge& place = joined.edges[as_size(image->side.edge)];
            place = other_.edges[as_size(e)];
            place.start = vertex(place.start);
            place.end = vertex(place.end);
            place.key = sim::new_key(joined);
        }
        joined.vertices.insert(joined.vertices.end(), other_.vertices.begin(), other_.vertices.end());
        for (const int pin : other_.pins) {
            if (std::find(joined.pins.begin(), joined.pins.end(), vertex(pin)) == joined.pins.end()) {
                joined.pins.push_back(vertex(pin));
            }
        }
        joined.notches.clear();
        add_notches(joined, a().notches, a_image);
        add_notches(joined, other_.notches, b_image);
        gather_fields(joined, other_);
        drop_vertices(joined, inner_vertices(shift));
        remap_edges(draft_, a_, a_image);
        remap_edges(draft_, b_, b_image);
        a() = std::move(joined);
    }

    template <class ImageOf>
    static void add_notches(sim::Panel& joined, const std::vector<sim::Notch>& notches, ImageOf image_of) {
        for (const sim::Notch& notch : notches) {
            const auto image = image_of(notch.edge);
            if (!image) continue;
            joined.notches.push_back(notch);
            joined.notches.back().edge = image->side.edge;
        }
    }

    // Vertices to remove: those of a's run between its ends, and all of b's run.
    std::vector<int> inner_vertices(int shift) {
        std::vector<int> vertices{b_start_ + shift, b_end_ + shift};
        for (int i = 0; i + 1 < count_; ++i) {
            vertices.push_back(edge(a(), a_edge(i)).end);
            vertices.push_back(edge(b(), b_edge(i)).end + shift);
        }
        return vertices;
    }

    sim::Pattern& draft_;
    int a_;
    int b_;
    int a_first_;
    int b_first_;
    int count_ = 1;
    sim::Panel other_;  // b, mapped onto a
    int a_start_ = 0;
    int a_end_ = 0;
    int b_start_ = 0;
    int b_end_ = 0;
};

bool is_straight(const sim::Panel& panel, const sim::OutlineEdge& edge) {
    const Vec2d start = panel.vertices[as_size(edge.start)];
    const Vec2d along = (panel.vertices[as_size(edge.end)] - start).normalized();
    const std::vector<Vec2d> points = outline_polyline(panel, edge, 1e-5);
    return std::all_of(points.begin(), points.end(),
                       [&](const Vec2d& p) { return std::abs(sim::cross2(along, p - start)) < 1e-5; });
}

// Keys with which no edge is an image: that is what its own images will be.
void give_drawn_keys(sim::Panel& panel) {
    give_keys(panel);
    for (sim::OutlineEdge& edge : panel.edges) {
        if (edge.key.role != sim::EdgeRole::Drawn) edge.key = sim::new_key(panel);
    }
}

void unfold(sim::Pattern& draft, const sim::SeamSide& fold, CopyLink link) {
    sim::Panel& panel = draft.panels[as_size(fold.panel)];
    if (link == CopyLink::Linked) {
        give_drawn_keys(panel);
        panel.fold_key = panel.edges[as_size(fold.edge)].key.number;
    }
    const int count = edge_count(panel);
    const auto image_of = [&](int e) { return sim::unfolded_image(e, fold.edge, count); };
    const auto stays_at = [&](int e) { return sim::unfolded_index(e, fold.edge, count); };
    panel = sim::unfolded(panel, fold.edge);
    std::vector<sim::Seam> darts;
    for (const sim::Seam& seam : draft.seams) {
        if (seam.first.panel != fold.panel || seam.second.panel != fold.panel) continue;
        if (seam.first.edge == fold.edge || seam.second.edge == fold.edge) continue;
        sim::Seam& dart = darts.emplace_back(copy_of(seam));
        dart.first.edge = image_of(seam.first.edge);
        dart.second.edge = image_of(seam.second.edge);
    }
    remap_edges(draft, fold.panel, [&](int e) -> std::optional<EdgeImage> {
        if (e == fold.edge) return {};
        return EdgeImage{{fold.panel, stays_at(e)}};
    });
    draft.seams.insert(draft.seams.end(), darts.begin(), darts.end());
}

// Replaces an edge by the dart's two legs: start to apex, apex to end. Returns the apex vertex.
int open_wedge(sim::Pattern& draft, const sim::SeamSide& mouth, double depth) {
    sim::Panel& panel = draft.panels[as_size(mouth.panel)];
    sim::OutlineEdge& edge = panel.edges[as_size(mouth.edge)];
    const Vec2d from = panel.vertices[as_size(edge.start)];
    const Vec2d to = panel.vertices[as_size(edge.end)];
    const Vec2d along = (to - from).normalized();
    const int apex = static_cast<int>(panel.vertices.size());
    panel.vertices.push_back((from + to) / 2 + depth * Vec2d(-along.y(), along.x()));
    const sim::OutlineEdge second{.start = apex, .end = edge.end, .key = sim::new_part_key(panel, edge)};
    edge = {.start = edge.start, .end = apex, .key = edge.key};
    panel.edges.insert(panel.edges.begin() + mouth.edge + 1, second);
    std::erase_if(panel.notches, [&](const sim::Notch& notch) { return notch.edge == mouth.edge; });
    for (sim::Notch& notch : panel.notches) notch.edge += notch.edge > mouth.edge ? 1 : 0;
    remap_edges(draft, mouth.panel, [&](int e) { return EdgeImage{{mouth.panel, e > mouth.edge ? e + 1 : e}}; });
    return apex;
}

}  // namespace

Merged merge_panels(sim::Pattern& pattern, int seam, std::optional<int> stays) {
    sim::Seam joint = seam_of(pattern, seam);
    const std::vector<PartLocation> places{place_of(pattern, joint.first), place_of(pattern, joint.second)};
    const sim::Panel& first = panel_of(pattern, joint.first.panel);
    const sim::Panel& second = panel_of(pattern, joint.second.panel);
    if (joint.first.panel == joint.second.panel)
        throw GeometryError(
            "Both sides of this seam are on '" + first.name + "': there is no second panel to merge it with", places);
    if (stays && *stays != joint.first.panel && *stays != joint.second.panel)
        throw GeometryError("'" + panel_of(pattern, *stays).name + "' is no panel of this seam", places);
    const bool second_stays =
        stays ? *stays == joint.second.panel : std::abs(outline_area(second)) > std::abs(outline_area(first));
    if (second_stays) std::swap(joint.first, joint.second);
    if (!joint.is_reversed) throw GeometryError("The panels have opposite orientation: mirror one first.", places);
    return edit_pattern(pattern, [&](sim::Pattern& draft) { return Merger(draft, joint).merge(); });
}

void unfold_panel(sim::Pattern& pattern, sim::SeamSide fold, CopyLink link) {
    if (!is_straight(panel_of(pattern, fold.panel), edge_of(pattern, fold))) {
        throw GeometryError("A fold is straight; this edge is curved.", {place_of(pattern, fold)});
    }
    edit_pattern(pattern, [&](sim::Pattern& draft) {
        unlink(draft, fold.panel);
        unfold(draft, fold, link);
    });
}

void insert_dart(sim::Pattern& pattern, sim::SeamSide at, double t, double width, double depth) {
    const double length = outline_length(panel_of(pattern, at.panel), edge_of(pattern, at));
    const double from = t - width / 2 / length;
    const double to = t + width / 2 / length;
    if (!(width > 0 && depth > 0)) throw GeometryError("A dart needs a width and a depth.", {place_of(pattern, at)});
    if (!(from > 0 && to < 1))
        throw GeometryError("The dart does not fit here: make it narrower", {place_of(pattern, at)});
    edit_pattern(pattern, [&](sim::Pattern& draft) {
        const sim::Panel& panel = draft.panels[as_size(at.panel)];
        const int second = split_alone(draft, at, to);
        const int first = split_alone(draft, at, from / to);
        const int apex = open_wedge(draft, {at.panel, at.edge + 1}, depth);
        if (seam_at(draft, at)) share_seam(draft, at, second, from / (from + 1 - to));
        draft.seams.push_back({.first = {at.panel, edge_from(panel, first)},
                               .second = {at.panel, edge_from(panel, apex)},
                               .is_reversed = true});
    });
}

}  // namespace selvedge::editor

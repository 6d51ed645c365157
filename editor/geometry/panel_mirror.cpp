// Implements symmetric_copies and update_mirrors of panel_edit.h: mirror images of panels and symmetry propagation.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "editor/geometry/draft.h"
#include "editor/geometry/edge_remap.h"
#include "editor/geometry/panel_edit.h"
#include "editor/geometry/sewing.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/field_moves.h"
#include "sim/pattern/outline.h"

namespace selvedge::editor {
namespace {

constexpr double kSamePoint = 1e-6;  // m, closer vertices match

// The panel's reflection in the world plane x = 0. Let S = diag(-1, 1, 1) and let m mirror the sheet (is_mirrored
// stays). Then S (R p + t) = (S R S) (S p) + S t, and S p is the local point of m(u), with p the local point of u.
sim::Panel mirror_image(const sim::Panel& panel) {
    sim::Panel image = mapped_panel(panel, Eigen::Affine2d(Eigen::Scaling(-1.0, 1.0)));
    const Eigen::Matrix3d across = Vec3d(-1, 1, 1).asDiagonal();
    image.rotation = across * panel.rotation * across;
    image.translation.x() = -panel.translation.x();
    return image;
}

// left_sleeve for right_sleeve and vice versa; other names unchanged.
std::string name_across(const std::string& name) {
    for (const auto& [one, other] : {std::pair<std::string, std::string>{"left", "right"}, {"right", "left"}}) {
        const std::size_t at = name.find(one);
        if (at != std::string::npos) return name.substr(0, at) + other + name.substr(at + one.size());
    }
    return name;
}

// Equality of what a mirror link keeps equal: all but name, mirror_of and sheet position.
bool is_alike(const sim::Panel& one, const sim::Panel& other) {
    return sim::copy_of(one) == sim::copy_of(other);
}

// Darts: seams between two edges of the same panel. Their panel index is 0 in the result.
std::vector<sim::Seam> darts_of(const sim::Pattern& pattern, int panel) {
    std::vector<sim::Seam> darts;
    for (const sim::Seam& seam : pattern.seams) {
        if (seam.first.panel != panel || seam.second.panel != panel) continue;
        sim::Seam& dart = darts.emplace_back(sim::copy_of(seam));
        dart.first.panel = dart.second.panel = 0;
    }
    return darts;
}

// The image of a dart on a mirrored panel of `count` edges.
sim::Seam dart_across(sim::Seam dart, int panel, int count) {
    for (sim::SeamSide* side : {&dart.first, &dart.second}) *side = {panel, sim::mirrored_edge(side->edge, count)};
    return dart;
}

void swap_sides(sim::Seam& seam) {
    std::swap(seam.first, seam.second);
    reverse_fields(seam);
}

// For each edge of `panel`, the edge of `target` that starts at the same point; -1: none. First tries a cyclic shift of
// vertex indices, then positions. All -1 if the matches are not in the same cyclic order.
std::vector<int> match_loops(const sim::Panel& panel, const sim::Panel& target) {
    const int count = edge_count(panel);
    const int target_count = edge_count(target);
    std::vector<int> match(as_size(count), -1);
    if (count == target_count) {
        const int shift = edge_from(target, panel.edges[0].start);
        const auto is_turned_by_shift = [&](int e) {
            return panel.edges[as_size(e)].start == target.edges[as_size((e + shift) % count)].start;
        };
        for (int e = 0; e < count && is_turned_by_shift(e); ++e) match[as_size(e)] = (e + shift) % count;
        if (match.back() >= 0) return match;
    }
    int falls = 0;
    int last = -1;
    int first = -1;
    for (int e = 0; e < count; ++e) {
        match[as_size(e)] = -1;
        const Vec2d& point = panel.vertices[as_size(panel.edges[as_size(e)].start)];
        for (int k = 0; k < target_count; ++k) {
            const Vec2d& other = target.vertices[as_size(target.edges[as_size(k)].start)];
            if ((point - other).norm() < kSamePoint) match[as_size(e)] = k;
        }
        const int found = match[as_size(e)];
        if (found < 0) continue;
        falls += found < last ? 1 : 0;
        last = found;
        if (first < 0) first = found;
    }
    falls += first < last ? 1 : 0;
    if (falls > 1) match.assign(as_size(count), -1);
    return match;
}

// Corresponding parts of two outlines, between two consecutive shared points.
struct Stretch {
    int first = 0;  // edge of the panel
    int count = 0;
    int target_first = 0;
    int target_count = 0;
};

std::vector<Stretch> stretches(const sim::Panel& panel, const sim::Panel& target) {
    const std::vector<int> match = match_loops(panel, target);
    const int count = edge_count(panel);
    const int target_count = edge_count(target);
    std::vector<int> shared;
    for (int e = 0; e < count; ++e) {
        if (match[as_size(e)] >= 0) shared.push_back(e);
    }
    std::vector<Stretch> found;
    for (std::size_t i = 0; i < shared.size(); ++i) {
        const int from = shared[i];
        const int to = shared[(i + 1) % shared.size()];
        // NOLINTNEXTLINE(clang-analyzer-core.DivideZero): `shared` has an edge, so the outline has one
        const int own = (to - from + count - 1) % count + 1;
        const int across = match[as_size(to)] - match[as_size(from)];
        found.push_back({from, own, match[as_size(from)], (across + target_count - 1) % target_count + 1});
    }
    if (found.empty() && count == target_count) found.push_back({0, count, 0, count});
    return found;
}

// Makes panel `panel_` the mirror image of the source panel `source_` and updates its seams: where the source's edges
// were split or joined, its own edges are too.
class SymmetryPropagation {
 public:
    SymmetryPropagation(sim::Pattern& draft, int source, int panel) : draft_(draft), source_(source), panel_(panel) {}

    void follow() {
        match_splits();
        const sim::Panel target = image();
        std::vector<int> place(own().edges.size(), -1);
        for (const Stretch& stretch : stretches(own(), target)) {
            if (stretch.count != stretch.target_count) continue;
            for (int i = 0; i < stretch.count; ++i) {
                place[as_size((stretch.first + i) % edge_count(own()))] =
                    (stretch.target_first + i) % edge_count(target);
            }
        }
        remap_edges(draft_, panel_, [&](int e) -> std::optional<EdgeImage> {
            if (place[as_size(e)] < 0) return {};
            return EdgeImage{{panel_, place[as_size(e)]}};
        });
        own() = target;
        follow_darts();
    }

 private:
    sim::Panel& own() { return draft_.panels[as_size(panel_)]; }

    sim::Panel image() {
        sim::Panel target = mirror_image(draft_.panels[as_size(source_)]);
        keep_names(target, own());
        return target;
    }

    // If the two panels are sewn to each other, a split of one may split the other, and so on. Without an end after as
    // many steps as both have edges, the splits would never end: throws GeometryError.
    void match_splits() {
        const sim::Panel& source = draft_.panels[as_size(source_)];
        const int most = edge_count(own()) + edge_count(source);
        for (int step = 0; even_one_stretch(); ++step) {
            if (step < most) continue;
            throw GeometryError(
                "Panels " + source.name + " and " + own().name +
                    " are mirror images and sewn to each other so that their seams cannot be split alike.",
                {{source.name, -1, -1}, {own().name, -1, -1}});
        }
    }

    bool even_one_stretch() {
        const sim::Panel target = image();
        for (const Stretch& stretch : stretches(own(), target)) {
            if (stretch.count == stretch.target_count) continue;
            if (stretch.count == 1) {
                split(stretch, target);
                return true;
            }
            if (stretch.target_count == 1) {
                join(stretch);
                return true;
            }
        }
        return false;
    }

    void join(const Stretch& stretch) {
        std::vector<std::pair<int, int>> joined;
        join_sewn(draft_, panel_, stretch.first, stretch.count, [&](int panel, int vertex) {
            joined.emplace_back(panel, vertex);
            return panel == panel_ || is_smooth(draft_.panels[as_size(panel)], vertex);
        });
        for (const auto& [panel, vertex] : joined) drop_unused(draft_.panels[as_size(panel)], {vertex});
    }

    // Splits at the same length fractions as the target's edges, from the last to the first.
    void split(const Stretch& stretch, const sim::Panel& target) {
        std::vector<double> reached{0};
        for (int i = 0; i < stretch.target_count; ++i) {
            const int edge = (stretch.target_first + i) % edge_count(target);
            reached.push_back(reached.back() + outline_length(target, target.edges[as_size(edge)]));
        }
        const int start = own().edges[as_size(stretch.first)].start;
        for (std::size_t i = reached.size() - 2; i > 0; --i) {
            split_sewn(draft_, {panel_, edge_from(own(), start)}, reached[i] / reached[i + 1]);
        }
    }

    void follow_darts() {
        std::vector<sim::Seam> wanted;
        for (const sim::Seam& dart : darts_of(draft_, source_))
            wanted.push_back(dart_across(dart, panel_, edge_count(own())));
        const auto is_same = [](const sim::Seam& one, const sim::Seam& other) {
            return one.is_reversed == other.is_reversed && ((one.first == other.first && one.second == other.second) ||
                                                            (one.first == other.second && one.second == other.first));
        };
        std::erase_if(draft_.seams, [&](const sim::Seam& seam) {
            return seam.first.panel == panel_ && seam.second.panel == panel_ &&
                   std::none_of(wanted.begin(), wanted.end(),
                                [&](const sim::Seam& dart) { return is_same(dart, seam); });
        });
        for (sim::Seam& dart : wanted) {
            const auto found =
                std::ranges::find_if(draft_.seams, [&](const sim::Seam& seam) { return is_same(dart, seam); });
            if (found != draft_.seams.end()) {
                if (found->first != dart.first) swap_sides(dart);
                keep_names(dart, *found);
                *found = dart;
            } else if (!seam_at(draft_, dart.first) && !seam_at(draft_, dart.second)) {
                draft_.seams.push_back(dart);
            }
        }
    }

    sim::Pattern& draft_;
    int source_;
    int panel_;
};

// Whether the panel crosses the middle of the body and faces to the front or the back: the plane x = 0 passes through
// the middle half of its width, and it is turned by less than 15 degrees from that plane's normal.
bool stands_in_the_middle(const sim::Panel& panel) {
    constexpr double kCosOfTurn = 0.966;
    const Eigen::AlignedBox2d box = outline_box(panel);
    return std::abs(panel.place(box.center()).x()) < box.sizes().x() / 4 && std::abs(panel.rotation(0, 0)) > kCosOfTurn;
}

// The edge that is the mirror image of `edge` on the other half of the panel. None: there is no such edge.
std::optional<int> edge_across(const sim::Panel& panel, int edge) {
    constexpr double kAlike = 0.001;  // m
    const double middle = outline_box(panel).center().x();
    const auto is_image = [&](const sim::OutlineEdge& other) {
        for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            const Vec2d own = outline_point(panel, panel.edges[as_size(edge)], t);
            const Vec2d image(2 * middle - own.x(), own.y());
            if ((outline_point(panel, other, 1 - t) - image).norm() > kAlike) return false;
        }
        return true;
    };
    const auto found = std::find_if(panel.edges.begin(), panel.edges.end(), is_image);
    if (found == panel.edges.end()) return {};
    return static_cast<int>(found - panel.edges.begin());
}

// Sews copies on the other side of the body as their originals are sewn on theirs. `copies`: the copy of each original.
class SeamMirror {
 public:
    SeamMirror(sim::Pattern& draft, const std::map<int, int>& copies) : draft_(draft), copies_(copies) {}

    void mirror() {
        const std::vector<sim::Seam> seams = draft_.seams;
        for (const sim::Seam& seam : seams) {
            if (!copies_.contains(seam.first.panel) && !copies_.contains(seam.second.panel)) continue;
            const std::optional<sim::SeamSide> first = across(seam.first), second = across(seam.second);
            if (!first || !second || *first == *second) continue;
            if (seam_at(draft_, *first) || seam_at(draft_, *second)) continue;
            sim::Seam& image = draft_.seams.emplace_back(sim::copy_of(seam));
            image.first = *first;
            image.second = *second;
            image.sewing = seam.sewing;
        }
        separate_sewings(draft_, seams.size());
    }

 private:
    std::optional<sim::SeamSide> across(const sim::SeamSide& side) const {
        const sim::Panel& panel = draft_.panels[as_size(side.panel)];
        const auto copy = copies_.find(side.panel);
        const std::optional<int> image = copy != copies_.end() ? copy->second : linked_image(side.panel);
        if (image) return sim::SeamSide{*image, sim::mirrored_edge(side.edge, edge_count(panel))};
        if (!stands_in_the_middle(panel)) return {};
        const std::optional<int> edge = edge_across(panel, side.edge);
        if (!edge) return {};
        return sim::SeamSide{side.panel, *edge};
    }

    std::optional<int> linked_image(int panel) const {
        const sim::Panel& own = draft_.panels[as_size(panel)];
        for (std::size_t i = 0; i < draft_.panels.size(); ++i) {
            const sim::Panel& other = draft_.panels[i];
            const bool is_image = other.mirror_of == own.name || own.mirror_of == other.name;
            if (is_image && edge_count(other) == edge_count(own)) return static_cast<int>(i);
        }
        return {};
    }

    sim::Pattern& draft_;
    const std::map<int, int>& copies_;
};

// How a panel differs from `before`, as far as its mirror images are concerned.
struct Change {
    bool is_changed = false;
    int edges = 0;  // absolute change of the number of edges
};

Change change_of(const sim::Pattern& pattern, int panel, const sim::Pattern& before) {
    const sim::Panel& now = pattern.panels[as_size(panel)];
    const auto is_it = [&](const sim::Panel& other) { return other.name == now.name; };
    auto was = std::find_if(before.panels.begin(), before.panels.end(), is_it);
    if (was == before.panels.end() && before.panels.size() == pattern.panels.size())
        was = before.panels.begin() + panel;
    if (was == before.panels.end()) return {};
    const int index = static_cast<int>(was - before.panels.begin());
    return {!is_alike(now, *was) || darts_of(pattern, panel) != darts_of(before, index),
            std::abs(edge_count(now) - edge_count(*was))};
}

// Maps each original panel to the panels that mirror it.
std::map<int, std::vector<int>> linked_groups(const sim::Pattern& pattern) {
    std::map<int, std::vector<int>> groups;
    for (std::size_t i = 0; i < pattern.panels.size(); ++i) {
        for (std::size_t k = 0; k < pattern.panels.size(); ++k) {
            if (i == k || pattern.panels[i].mirror_of != pattern.panels[k].name) continue;
            groups[static_cast<int>(k)].push_back(static_cast<int>(i));
        }
    }
    return groups;
}

bool was_linked(const sim::Pattern& before, const sim::Panel& panel) {
    return std::any_of(before.panels.begin(), before.panels.end(), [&](const sim::Panel& other) {
        return other.name == panel.name && other.mirror_of == panel.mirror_of;
    });
}

}  // namespace

std::vector<int> symmetric_copies(sim::Pattern& pattern, const std::vector<int>& panels, bool is_linked,
                                  const Vec2d& shift) {
    for (const int panel : panels) {
        const sim::Panel& own = panel_of(pattern, panel);
        if (!is_linked || own.mirror_of.empty()) continue;
        throw GeometryError("Panel " + own.name + " is kept a mirror image of " + own.mirror_of + " already.",
                            {{own.name, -1, -1}, {own.mirror_of, -1, -1}});
    }
    const std::vector<Vec2d> positions = sheet_positions(pattern);
    Eigen::AlignedBox1d across;  // of the panels on the sheet
    for (const int panel : panels) {
        const Eigen::AlignedBox2d box = outline_box(panel_of(pattern, panel));
        const double origin = positions[as_size(panel)].x();
        across.extend(Eigen::AlignedBox1d(origin + box.min().x(), origin + box.max().x()));
    }
    return edit_pattern(pattern, [&](sim::Pattern& draft) {
        std::vector<int> added;
        std::map<int, int> copies;
        for (const int panel : panels) {
            const sim::Panel own = draft.panels[as_size(panel)];
            sim::Panel image = mirror_image(own);
            image.name = free_panel_name(draft, name_across(own.name));
            image.mirror_of = is_linked ? own.name : "";
            const Vec2d& position = positions[as_size(panel)];
            image.sheet_position = Vec2d(across.min()[0] + across.max()[0] - position.x(), position.y()) + shift;
            added.push_back(static_cast<int>(draft.panels.size()));
            copies.emplace(panel, added.back());
            draft.panels.push_back(std::move(image));
        }
        SeamMirror(draft, copies).mirror();
        return added;
    });
}

void update_mirrors(sim::Pattern& pattern, const sim::Pattern& before) {
    const std::map<int, std::vector<int>> groups = linked_groups(pattern);
    if (groups.empty()) return;
    edit_pattern(pattern, [&](sim::Pattern& draft) {
        for (const auto& [head, images] : groups) {
            int source = head;
            Change most = change_of(pattern, head, before);
            for (const int image : images) {
                const Change change = change_of(pattern, image, before);
                const bool is_new = !was_linked(before, pattern.panels[as_size(image)]);
                if (is_new) most.is_changed = true;
                if (is_new || !change.is_changed || (most.is_changed && change.edges <= most.edges)) continue;
                source = image;
                most = change;
            }
            if (!most.is_changed) continue;
            if (source != head) SymmetryPropagation(draft, source, head).follow();
            for (const int image : images) {
                if (image != source) SymmetryPropagation(draft, head, image).follow();
            }
        }
    });
}

}  // namespace selvedge::editor

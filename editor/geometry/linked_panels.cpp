#include "editor/geometry/linked_panels.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "editor/geometry/draft.h"
#include "editor/geometry/linked_halves.h"
#include "editor/geometry/panel_families.h"
#include "editor/geometry/seam_bundles.h"
#include "sim/pattern/edge_keys.h"
#include "sim/pattern/field_moves.h"
#include "sim/pattern/halves.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/pattern_fields.h"
#include "sim/pattern/sources.h"

namespace selvedge::editor {
namespace {

using Heirs = std::map<sim::EdgeKey, std::vector<EdgeHeir>>;

// Equality of what a link keeps equal.
bool is_alike(sim::Panel one, const sim::Panel& other) {
    const auto link = sim::link_of(other);
    sim::visit_fields(one, [&](const auto& field, auto& value) {
        const bool is_own = link ? sim::is_own_field(field, link->kind) : field.descent == sim::Descent::Own;
        if (is_own) value = other.*field.member;
    });
    return one == other;
}

// The sides of darts within a run of edges: what is sewn to another edge of the run.
std::set<int> dart_sides(const sim::Pattern& pattern, int panel, const std::vector<int>& run) {
    std::set<int> sides;
    const auto is_there = [&](const sim::SeamSide& side) {
        return side.panel == panel && std::ranges::find(run, side.edge) != run.end();
    };
    for (const sim::Seam& seam : pattern.seams) {
        if (is_there(seam.first) && is_there(seam.second)) sides.insert({seam.first.edge, seam.second.edge});
    }
    return sides;
}

std::vector<int> run_from(int first, int count, int total) {
    std::vector<int> run;
    for (int i = 0; i < count; ++i) run.push_back((first + i) % total);
    return run;
}

// Where the edges of a run lie along it, as fractions of its length; those of `left_out` take no part of it.
std::vector<std::pair<double, double>> shares_of(const sim::Panel& panel, const std::vector<int>& run,
                                                 const std::set<int>& left_out = {}) {
    std::vector<double> reached{0};
    for (const int edge : run) {
        const double length = outline_length(panel, panel.edges[as_size(edge)]);
        reached.push_back(reached.back() + (left_out.contains(edge) ? 0 : length));
    }
    std::vector<std::pair<double, double>> shares;
    for (std::size_t i = 0; i < run.size(); ++i)
        shares.emplace_back(reached[i] / reached.back(), reached[i + 1] / reached.back());
    return shares;
}

// A panel as it was and as it is now, in a pattern.
struct EditedPanel {
    const sim::Panel& was;
    const sim::Panel& now;
    const sim::Pattern& pattern;  // with `now`
    int index = 0;                // of `now`
};

// What became of the edges of the panel.
Heirs heirs_of_edges(const EditedPanel& panel) {
    Heirs heirs;
    const int was_count = edge_count(panel.was), now_count = edge_count(panel.now);
    if (is_turned_over(panel.was, panel.now)) {
        for (int e = 0; e < was_count; ++e) heirs[edge_key(panel.was, e)] = {{0, 1, {edge_key(panel.was, e)}}};
    }
    for (const sim::OutlineStretch& stretch : shared_stretches(panel.was, panel.now)) {
        const std::vector<int> was = run_from(stretch.first, stretch.count, was_count);
        const std::vector<int> now = run_from(stretch.other_first, stretch.other_count, now_count);
        if (was.size() == now.size()) {
            for (std::size_t i = 0; i < was.size(); ++i)
                heirs[edge_key(panel.was, was[i])] = {{0, 1, {edge_key(panel.now, now[i])}}};
        } else if (was.size() == 1) {
            const std::set<int> darts = dart_sides(panel.pattern, panel.index, now);
            const auto shares = shares_of(panel.now, now, darts);
            for (std::size_t i = 0; i < now.size(); ++i) {
                if (darts.contains(now[i])) continue;
                heirs[edge_key(panel.was, was[0])].push_back(
                    {shares[i].first, shares[i].second, {edge_key(panel.now, now[i])}});
            }
        } else if (now.size() == 1) {
            const auto shares = shares_of(panel.was, was);
            for (std::size_t i = 0; i < was.size(); ++i) {
                heirs[edge_key(panel.was, was[i])] = {
                    {0, 1, {edge_key(panel.now, now[0]), shares[i].first, shares[i].second, true}}};
            }
        }
    }
    return heirs;
}

// For each edge of the panel as it is now, the pieces of edges that it stands for, as they were.
std::vector<EdgePieces> origins_of_edges(const EditedPanel& panel) {
    struct Origin {
        double at;
        EdgePiece piece;
    };
    std::map<sim::EdgeKey, std::vector<Origin>> found;
    for (const auto& [key, heirs] : heirs_of_edges(panel)) {
        for (const EdgeHeir& heir : heirs)
            found[heir.piece.key].push_back({heir.piece.from, {key, heir.from, heir.to}});
    }
    std::vector<EdgePieces> origins;
    for (int e = 0; e < edge_count(panel.now); ++e) {
        EdgePieces& pieces = origins.emplace_back();
        std::vector<Origin>& parts = found[edge_key(panel.now, e)];
        std::ranges::sort(parts, {}, &Origin::at);
        for (const Origin& part : parts) add_piece(pieces, part.piece);
    }
    return origins;
}

Heirs turned_heirs(Heirs heirs) {
    for (auto& [key, parts] : heirs) parts = turned(std::move(parts));
    return heirs;
}

// The panel that has this half (linked_halves.h), or the panel itself.
int index_of_whole(const sim::Pattern& pattern, int panel) {
    const std::string& name = pattern.panels[as_size(panel)].name;
    const std::string whole = whole_name(name);
    if (whole == name) return panel;
    return static_cast<int>(std::ranges::find(pattern.panels, whole, &sim::Panel::name) - pattern.panels.begin());
}

// Whether a seam joins the two halves of one panel.
bool is_across(const sim::Pattern& pattern, const sim::Seam& seam) {
    return seam.first.panel != seam.second.panel &&
           whole_name(sim::panel_of(pattern, seam.first).name) == whole_name(sim::panel_of(pattern, seam.second).name);
}

// The seams from one half of the panel to the other, with the edges that they join: those of the panel first.
std::vector<sim::Seam> seams_across(const sim::Pattern& pattern, int panel) {
    std::vector<sim::Seam> found;
    for (const sim::Seam& seam : pattern.seams) {
        if (seam.first.panel != panel && seam.second.panel != panel) continue;
        if (!is_across(pattern, seam)) continue;
        sim::Seam& added = found.emplace_back(sim::copy_of(seam));
        if (seam.second.panel == panel) {
            std::swap(added.first, added.second);
            reverse_fields(added);
        }
        added.first.panel = added.second.panel = 0;
    }
    return found;
}

class LinkUpdate {
 public:
    LinkUpdate(sim::Pattern& draft, const sim::Pattern& before)
        : draft_(draft), before_(before), families_(draft), pieces_(draft.panels.size()) {
        is_seam_turned_.resize(draft.panels.size(), false);
        const std::map<std::string, std::size_t> index = sim::index_by_name(before.panels);
        for (std::size_t i = 0; i < draft.panels.size(); ++i) was_.push_back(find_before(i, index));
        for (std::size_t i = 0; i < draft.panels.size(); ++i) {
            const sim::Panel& panel = draft.panels[i];
            whole_.push_back(index_of_whole(draft, static_cast<int>(i)));
            leader_.push_back(families_.root_of(static_cast<int>(i)));
            for (int e = 0; e < edge_count(panel); ++e) pieces_[i].push_back({{edge_key(panel, e)}});
        }
    }

    void update() {
        for (int root = 0; root < static_cast<int>(draft_.panels.size()); ++root) {
            if (families_.root_of(root) == root && families_.members(root).size() > 1) follow_leader(root);
        }
        const std::vector<sim::Seam> old = draft_.seams;
        BundledSeams bundled = SeamBundles(families_, bundles_of_seams()).seams();
        draft_.panels = families_.panels();
        places_ = std::move(bundled.kept);
        more_ = std::move(bundled.parts);
        collect();
        for (int panel = 0; panel < static_cast<int>(draft_.panels.size()); ++panel) {
            if (leader_[as_size(panel)] != panel) follow_darts(panel, old);
            const bool is_half = whole_[as_size(panel)] != panel;
            if (!is_half && whole_[as_size(leader_[as_size(panel)])] != panel) follow_seams_across(panel, old);
        }
        collect();
    }

 private:
    // The panel as it was. Null: it was not there, or was not linked so.
    const sim::Panel* was(int panel) const { return was_[as_size(panel)]; }

    // The same, in `before` with this index of its panels.
    const sim::Panel* find_before(std::size_t panel, const std::map<std::string, std::size_t>& index) const {
        const sim::Panel& now = draft_.panels[panel];
        const bool has_same_panels = before_.panels.size() == draft_.panels.size();
        const auto named = index.find(now.name);
        if (named == index.end() && !has_same_panels) return nullptr;
        const sim::Panel& found = before_.panels[named == index.end() ? panel : named->second];
        const auto link = sim::link_of(now), old_link = sim::link_of(found);
        const bool is_same_kind = link.has_value() == old_link.has_value() && (!link || link->kind == old_link->kind);
        const bool has_same_source = !link || has_same_panels || (old_link && link->source == old_link->source);
        return is_same_kind && has_same_source ? &found : nullptr;
    }

    bool is_changed(int panel, const sim::Panel& before) const {
        const int old = static_cast<int>(&before - before_.panels.data());
        if (!is_alike(before, draft_.panels[as_size(panel)])) return true;
        if (seams_across(draft_, panel) != seams_across(before_, old)) return true;
        const std::vector<int> darts = sim::darts_of(draft_, panel), had = sim::darts_of(before_, old);
        return !std::ranges::equal(darts, had, [&](int one, int other) {
            return sim::copy_of(draft_.seams[as_size(one)]) == with_panel(before_.seams[as_size(other)], panel);
        });
    }

    // The other half of a panel. -1: it is not divided.
    int other_half(int panel) const {
        for (std::size_t i = 0; i < whole_.size(); ++i) {
            if (whole_[i] == panel && static_cast<int>(i) != panel) return static_cast<int>(i);
        }
        return -1;
    }

    static sim::Seam with_panel(const sim::Seam& dart, int panel) {
        sim::Seam moved = sim::copy_of(dart);
        moved.first = {panel, dart.first.edge};
        moved.second = {panel, dart.second.edge};
        return moved;
    }

    // The member of a family that was edited, before all others one whose number of edges changed. None was, but some
    // are new: the root. None: none was, and none is new.
    std::optional<int> leader_of(int root) const {
        std::optional<int> leader;
        bool has_new = false;
        int most = 0;  // change of the number of edges
        for (const int member : families_.members(root)) {
            const sim::Panel* before = was(member);
            if (!before) has_new = true;
            if (!before || !is_changed(member, *before)) continue;
            const int edges = std::abs(edge_count(draft_.panels[as_size(member)]) - edge_count(*before));
            if (leader && edges <= most) continue;
            leader = member;
            most = edges;
        }
        return leader || !has_new ? leader : root;
    }

    void follow_leader(int root) {
        const std::optional<int> leader = leader_of(root);
        if (!leader) return;
        for (const int member : families_.members(root)) leader_[as_size(member)] = *leader;
        const sim::Panel& leading = draft_.panels[as_size(*leader)];
        const sim::Panel* leading_before = was(*leader);
        const Heirs heirs = heirs_of_edges({leading_before ? *leading_before : leading, leading, draft_, *leader});
        const bool is_turned = leading_before && is_turned_over(*leading_before, leading);
        families_.put(*leader, leading);
        for (const int member : families_.members(root)) {
            if (member != *leader) follow(member, *leader, heirs, is_turned);
        }
    }

    // Finds the pieces of the panel's new edges that its old ones are.
    void follow(int member, int leader, const Heirs& heirs, bool is_leader_turned) {
        const sim::Panel* before = was(member);
        if (!before) return;  // a copy, just made
        const sim::Panel& now = draft_.panels[as_size(member)];
        is_seam_turned_[as_size(member)] = is_leader_turned != is_turned_over(*before, now);
        if (is_seam_turned_[as_size(member)]) families_.turn_on_cloth(member);
        const bool runs_alike = families_.is_turned(member) == families_.is_turned(leader);
        const Heirs own = runs_alike ? heirs : turned_heirs(heirs);
        const std::vector<EdgePieces> origins = origins_of_edges({*before, now, draft_, member});
        for (std::size_t e = 0; e < origins.size(); ++e) {
            EdgePieces& pieces = pieces_[as_size(member)][e];
            pieces.clear();
            for (const EdgePiece& origin : origins[e]) {
                const auto found = own.find(origin.key);
                if (found == own.end()) continue;
                for (const EdgePiece& piece : heirs_of(origin, found->second)) add_piece(pieces, piece);
            }
        }
    }

    // Of all seams; those of darts in panels that follow another have no sides.
    std::vector<SeamBundle> bundles_of_seams() const {
        std::vector<SeamBundle> bundles;
        for (const sim::Seam& seam : draft_.seams) {
            SeamBundle& bundle = bundles.emplace_back();
            bundle.seam = seam;
            if (is_followed(seam)) continue;
            bundle.first = {seam.first.panel, pieces_at(seam.first)};
            bundle.second = {seam.second.panel, pieces_at(seam.second)};
            for (const sim::SeamSide& side : {seam.first, seam.second}) {
                if (is_seam_turned_[as_size(side.panel)]) bundle.seam.is_reversed = !bundle.seam.is_reversed;
            }
        }
        return bundles;
    }

    bool is_followed(const sim::Seam& seam) const {
        const int panel = seam.first.panel, leader = leader_[as_size(panel)];
        if (is_across(draft_, seam)) return whole_[as_size(leader)] != whole_[as_size(panel)];
        return panel == seam.second.panel && leader != panel;
    }

    const EdgePieces& pieces_at(const sim::SeamSide& side) const {
        return pieces_[as_size(side.panel)][as_size(side.edge)];
    }

    void collect() {
        draft_.seams.clear();
        for (const std::optional<sim::Seam>& seam : places_) {
            if (seam) draft_.seams.push_back(*seam);
        }
        draft_.seams.insert(draft_.seams.end(), more_.begin(), more_.end());
    }

    // The panel gets the darts of the one that leads, whose keys of edges it has too. Those that it had keep their
    // names and their places among the seams.
    void follow_darts(int panel, const std::vector<sim::Seam>& old) {
        const int leader = leader_[as_size(panel)];
        for (const int dart : sim::darts_of(draft_, leader))
            follow_dart(draft_.seams[as_size(dart)], {{leader, panel}}, old);
    }

    // The same for seams from one half of a panel to the other.
    void follow_seams_across(int panel, const std::vector<sim::Seam>& old) {
        const int leader = whole_[as_size(leader_[as_size(panel)])];
        const std::map<int, int> images{{leader, panel}, {other_half(leader), other_half(panel)}};
        for (const sim::Seam& seam : draft_.seams) {
            if (whole_[as_size(seam.first.panel)] == leader && is_across(draft_, seam)) follow_dart(seam, images, old);
        }
    }

    // images: the panel for each panel of the seam.
    void follow_dart(const sim::Seam& dart, const std::map<int, int>& images, const std::vector<sim::Seam>& old) {
        sim::Seam made = sim::copy_of(dart);
        for (sim::SeamSide* side : {&made.first, &made.second}) {
            const sim::Panel& from = draft_.panels[as_size(side->panel)];
            const sim::Panel& own = draft_.panels[as_size(images.at(side->panel))];
            *side = {images.at(side->panel), find_edge(own, edge_key(from, side->edge)).value()};
            if (!seam_at(draft_, *side)) continue;
            throw GeometryError("Panel " + own.name + " is linked to " + from.name +
                                    ", and is sewn already where a seam within it would be.",
                                {place_of(draft_, *side)});
        }
        add_dart(std::move(made), old);
    }

    void add_dart(sim::Seam made, const std::vector<sim::Seam>& old) {
        const auto is_now = [&](const sim::SeamSide& was, const sim::SeamSide& now) {
            const EdgePieces& pieces = pieces_at(was);
            const sim::Panel& panel = draft_.panels[as_size(now.panel)];
            return was.panel == now.panel && pieces.size() == 1 && pieces.front().key == edge_key(panel, now.edge);
        };
        for (std::size_t i = 0; i < old.size(); ++i) {
            const sim::Seam& seam = old[i];
            if (places_[i] || !is_followed(seam)) continue;
            if (is_now(seam.first, made.second) && is_now(seam.second, made.first)) {
                std::swap(made.first, made.second);
                reverse_fields(made);
            }
            if (!is_now(seam.first, made.first) || !is_now(seam.second, made.second)) continue;
            keep_names(made, seam);
            places_[i] = std::move(made);
            return;
        }
        more_.push_back(std::move(made));
    }

    sim::Pattern& draft_;
    const sim::Pattern& before_;
    PanelFamilies families_;
    std::vector<std::vector<EdgePieces>> pieces_;     // per panel and edge of the draft: of the families' edges
    std::vector<const sim::Panel*> was_;              // per panel: as it was
    std::vector<bool> is_seam_turned_;                // per panel
    std::vector<int> leader_;                         // per panel
    std::vector<int> whole_;                          // per panel: the drawn half, of one that is another half
    std::vector<std::optional<sim::Seam>> places_{};  // what became of the draft's seams
    std::vector<sim::Seam> more_{};                   // and those that are new
};

bool has_links(const sim::Pattern& pattern) {
    return std::ranges::any_of(pattern.panels, [](const sim::Panel& panel) {
        return sim::link_of(panel).has_value() || sim::has_linked_halves(panel);
    });
}

// Halves were unfolded in derived panels too: these become what their sources give, to the last bit.
void derive_again(sim::Pattern& pattern) {
    PanelFamilies families(pattern);
    for (int root = 0; root < static_cast<int>(pattern.panels.size()); ++root) {
        if (families.root_of(root) == root && families.members(root).size() > 1)
            families.put(root, sim::Panel(families.panel(root)));
    }
    for (sim::Seam& seam : pattern.seams) {
        for (sim::SeamSide* side : {&seam.first, &seam.second}) {
            const sim::EdgeKey key = edge_key(pattern.panels[as_size(side->panel)], side->edge);
            side->edge = find_edge(families.panel(side->panel), key).value();
        }
    }
    pattern.panels = families.panels();
}

// The error of an edit of divided panels, about those that a person knows.
GeometryError about_wholes(const GeometryError& error) {
    std::vector<PartLocation> places;
    for (const PartLocation& place : error.places()) places.push_back({whole_name(place.panel), -1, -1});
    return GeometryError(without_half_names(error.what()), places);
}

void update_divided(sim::Pattern& draft, const sim::Pattern& before) {
    DividedPattern parts = divide_halves(draft, before);
    if (parts.divided.empty()) return LinkUpdate(draft, before).update();
    const DividedPattern was = divide_halves(before, before);
    try {
        LinkUpdate(parts.pattern, was.pattern).update();
    } catch (const GeometryError& error) {
        throw about_wholes(error);
    }
    draft = joined_halves(parts);
    derive_again(draft);
}

}  // namespace

void update_links(sim::Pattern& pattern, const sim::Pattern& before) {
    if (!has_links(pattern)) return;
    edit_pattern(pattern, [&](sim::Pattern& draft) {
        for (sim::Panel& panel : draft.panels) give_keys(panel);
        update_divided(draft, before);
    });
}

}  // namespace selvedge::editor

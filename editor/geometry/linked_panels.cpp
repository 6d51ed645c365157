#include "editor/geometry/linked_panels.h"

#include <algorithm>
#include <map>
#include <numeric>
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

// Of each panel, the panel that has this half, or the panel itself.
std::vector<int> wholes_of(const DividedPattern& parts) {
    std::vector<int> wholes(parts.pattern.panels.size() - parts.divided.size());
    std::iota(wholes.begin(), wholes.end(), 0);
    for (const DividedPanel& divided : parts.divided) wholes.push_back(divided.panel);
    return wholes;
}

// Whether a seam joins the two halves of one panel.
bool is_across(const std::vector<int>& wholes, const sim::Seam& seam) {
    return seam.first.panel != seam.second.panel &&
           wholes[as_size(seam.first.panel)] == wholes[as_size(seam.second.panel)];
}

// The seams from one half of the panel to the other, with the edges that they join: those of the panel first.
std::vector<sim::Seam> seams_across(const sim::Pattern& pattern, const std::vector<int>& wholes, int panel) {
    std::vector<sim::Seam> found;
    for (const sim::Seam& seam : pattern.seams) {
        if (seam.first.panel != panel && seam.second.panel != panel) continue;
        if (!is_across(wholes, seam)) continue;
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
    // Divided as linked_halves.h has it.
    LinkUpdate(DividedPattern& draft, const DividedPattern& before)
        : draft_(draft.pattern),
          before_(before.pattern),
          divided_(draft.divided),
          families_(draft_),
          pieces_(draft_.panels.size()),
          whole_(wholes_of(draft)),
          whole_before_(wholes_of(before)) {
        is_seam_turned_.resize(draft_.panels.size(), false);
        const std::map<std::string, std::size_t> index = sim::index_by_name(before_.panels);
        for (std::size_t i = 0; i < draft_.panels.size(); ++i) was_.push_back(find_before(i, index));
        for (std::size_t i = 0; i < draft_.panels.size(); ++i) {
            const sim::Panel& panel = draft_.panels[i];
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
            if (!is_other_half(panel) && whole_[as_size(leader_[as_size(panel)])] != panel)
                follow_seams_across(panel, old);
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
        std::size_t old = named == index.end() ? panel : named->second;
        if (is_other_half(static_cast<int>(panel)) && named != index.end()) {
            const int half = other_half(whole_before_, static_cast<int>(named->second));
            if (half < 0 && !has_same_panels) return nullptr;
            old = half < 0 ? panel : as_size(half);
        }
        const sim::Panel& found = before_.panels[old];
        const auto link = sim::link_of(now), old_link = sim::link_of(found);
        const bool is_same_kind = link.has_value() == old_link.has_value() && (!link || link->kind == old_link->kind);
        const bool has_same_source = !link || has_same_panels || (old_link && link->source == old_link->source);
        return is_same_kind && has_same_source ? &found : nullptr;
    }

    // How a member of a family was changed. Shared: in what both halves of its panel have, and not in its own half.
    enum class Change { None, Shared, Own };

    Change change_of(int panel, const sim::Panel& before) const {
        const int old = static_cast<int>(&before - before_.panels.data());
        const std::vector<int> darts = sim::darts_of(draft_, panel), had = sim::darts_of(before_, old);
        const bool has_same_darts = std::ranges::equal(darts, had, [&](int one, int other) {
            return sim::copy_of(draft_.seams[as_size(one)]) == with_panel(before_.seams[as_size(other)], panel);
        });
        const HalfEdit* half = edit_of_half(panel);
        if (!has_same_darts || (half != nullptr && half->is_changed)) return Change::Own;
        const bool is_same = is_alike(before, draft_.panels[as_size(panel)]) &&
                             seams_across(draft_, whole_, panel) == seams_across(before_, whole_before_, old);
        if (is_same) return Change::None;
        return half == nullptr ? Change::Own : Change::Shared;
    }

    bool is_other_half(int panel) const { return whole_[as_size(panel)] != panel; }

    // Null: the panel is no half, or was none.
    const HalfEdit* edit_of_half(int panel) const {
        for (const DividedPanel& divided : divided_) {
            if (divided.panel != whole_[as_size(panel)]) continue;
            const std::optional<HalfEdit>& edit = is_other_half(panel) ? divided.other : divided.drawn;
            return edit ? &*edit : nullptr;
        }
        return nullptr;
    }

    // The other half of a panel. -1: it is not divided.
    static int other_half(const std::vector<int>& wholes, int panel) {
        for (std::size_t i = 0; i < wholes.size(); ++i) {
            if (wholes[i] == panel && static_cast<int>(i) != panel) return static_cast<int>(i);
        }
        return -1;
    }

    static sim::Seam with_panel(const sim::Seam& dart, int panel) {
        sim::Seam moved = sim::copy_of(dart);
        moved.first = {panel, dart.first.edge};
        moved.second = {panel, dart.second.edge};
        return moved;
    }

    // The member of a family that was edited, before all others one whose number of edges changed; of the halves of a
    // panel, the one that was changed in more than what both have. None was, but some are new: the root. None: none
    // was, and none is new.
    std::optional<int> leader_of(int root) const {
        std::optional<int> leader;
        bool has_new = false;
        std::pair<int, Change> most{0, Change::None};  // change of the number of edges
        for (const int member : families_.members(root)) {
            const sim::Panel* before = was(member);
            if (!before) has_new = true;
            if (!before) continue;
            const Change change = change_of(member, *before);
            const int edges = std::abs(edge_count(draft_.panels[as_size(member)]) - edge_count(*before));
            if (change == Change::None || (leader && std::pair(edges, change) <= most)) continue;
            leader = member;
            most = {edges, change};
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
        if (is_across(whole_, seam)) return whole_[as_size(leader)] != whole_[as_size(panel)];
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
        const std::map<int, int> images{{leader, panel}, {other_half(whole_, leader), other_half(whole_, panel)}};
        for (const sim::Seam& seam : draft_.seams) {
            if (whole_[as_size(seam.first.panel)] == leader && is_across(whole_, seam)) follow_dart(seam, images, old);
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
            const std::string linked = own.name == from.name ? "The halves of panel " + own.name + " are linked"
                                                             : "Panel " + own.name + " is linked to " + from.name;
            throw GeometryError(linked + ", and it is sewn already where a seam within it would be.",
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
    const std::vector<DividedPanel>& divided_;
    PanelFamilies families_;
    std::vector<std::vector<EdgePieces>> pieces_;     // per panel and edge of the draft: of the families' edges
    std::vector<int> whole_;                          // per panel: the drawn half, of one that is another half
    std::vector<int> whole_before_;                   // the same before
    std::vector<const sim::Panel*> was_{};            // per panel: as it was
    std::vector<bool> is_seam_turned_{};              // per panel
    std::vector<int> leader_{};                       // per panel
    std::vector<std::optional<sim::Seam>> places_{};  // what became of the draft's seams
    std::vector<sim::Seam> more_{};                   // and those that are new
};

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
    for (const PartLocation& place : error.places()) places.push_back({place.panel, -1, -1});
    return GeometryError(error.what(), places);
}

void update_divided(sim::Pattern& draft, const sim::Pattern& before) {
    DividedPattern parts = divide_halves(draft, before);
    if (parts.divided.empty()) {
        LinkUpdate(parts, {.pattern = before, .divided = {}}).update();
        draft = std::move(parts.pattern);
        return;
    }
    const DividedPattern was = divide_halves(before, before);
    try {
        LinkUpdate(parts, was).update();
    } catch (const GeometryError& error) {
        throw about_wholes(error);
    }
    draft = joined_halves(parts);
    derive_again(draft);
    expect_both_kept(parts, draft);
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

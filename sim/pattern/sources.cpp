#include "sim/pattern/sources.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <type_traits>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/math.h"
#include "sim/pattern/edge_keys.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/field_moves.h"
#include "sim/pattern/halves.h"
#include "sim/pattern/pattern_fields.h"

namespace selvedge::sim {
namespace {

void take_own_fields(Panel& panel, const Panel& from, Derivation kind) {
    visit_fields(panel, [&](const auto& field, auto& value) {
        if (is_own_field(field, kind)) value = from.*field.member;
    });
}

// Edges with their ends and keys alone.
std::vector<OutlineEdge> numbering_of(const Panel& panel) {
    std::vector<OutlineEdge> edges;
    for (const OutlineEdge& edge : panel.edges)
        edges.push_back({.start = edge.start, .end = edge.end, .key = edge.key});
    return edges;
}

// By how many places edges are to be shifted for the keys to be those of `wanted`. None: that is not possible.
std::optional<std::size_t> shift_to(const std::vector<OutlineEdge>& edges, const std::vector<OutlineEdge>& wanted) {
    if (edges.size() < 3 || edges.size() != wanted.size()) return {};
    const auto first = std::ranges::find(edges, wanted.front().key, &OutlineEdge::key);
    const auto shift = static_cast<std::size_t>(first - edges.begin());
    for (std::size_t e = 0; e < edges.size(); ++e) {
        if (edges[(e + shift) % edges.size()].key != wanted[e].key) return {};
    }
    return shift;
}

// Numbers vertices and edges as `wanted` does, if it has the same edges in the same cyclic order.
void renumber(Panel& panel, const std::vector<OutlineEdge>& wanted) {
    const auto shift = shift_to(panel.edges, wanted);
    if (!shift || panel.vertices.size() != panel.edges.size()) return;
    std::vector<int> vertex(panel.vertices.size(), -1);
    std::set<int> taken;
    for (std::size_t e = 0; e < wanted.size(); ++e) {
        const int to = wanted[e].start;
        if (to < 0 || as_size(to) >= vertex.size() || !taken.insert(to).second) return;
        vertex[as_size(panel.edges[(e + *shift) % wanted.size()].start)] = to;
    }
    const Panel before = panel;
    for (std::size_t v = 0; v < vertex.size(); ++v) panel.vertices[as_size(vertex[v])] = before.vertices[v];
    for (std::size_t e = 0; e < wanted.size(); ++e) {
        panel.edges[e] = before.edges[(e + *shift) % wanted.size()];
        panel.edges[e].start = vertex[as_size(panel.edges[e].start)];
        panel.edges[e].end = vertex[as_size(panel.edges[e].end)];
    }
    const int count = static_cast<int>(wanted.size()), back = count - static_cast<int>(*shift);
    for (Notch& notch : panel.notches) notch.edge = (notch.edge + back) % count;
    for (int& pin : panel.pins) pin = vertex[as_size(pin)];
}

// Panels by their sources.
class PanelEvaluation {
 public:
    explicit PanelEvaluation(const std::vector<Panel>& sources)
        : sources_(sources), index_(index_by_name(sources)), state_(sources.size(), State::Unknown), panels_(sources) {}

    std::vector<Panel> evaluate() {
        for (std::size_t i = 0; i < sources_.size(); ++i) make(i);
        return std::move(panels_);
    }

 private:
    enum class State { Unknown, UnderWay, Known };

    const Panel& make(std::size_t i) {
        if (state_[i] == State::Known) return panels_[i];
        const Panel& own = sources_[i];
        if (state_[i] == State::UnderWay) throw InputError("", "", "panel '" + own.name + "' is derived from itself");
        state_[i] = State::UnderWay;
        if (const auto link = link_of(own)) {
            const auto source = index_.find(link->source);
            if (source == index_.end()) {
                throw InputError("", "",
                                 "panel '" + own.name + "' is derived from '" + link->source + "', which is not there");
            }
            panels_[i] = derived_panel(make(source->second), link->kind, own);
        } else {
            give_keys(panels_[i]);
            if (fold_of(panels_[i])) panels_[i] = whole_of(panels_[i]);
        }
        state_[i] = State::Known;
        return panels_[i];
    }

    const std::vector<Panel>& sources_;
    std::map<std::string, std::size_t> index_;
    std::vector<State> state_;
    std::vector<Panel> panels_;
};

// Whether a seam within a panel with linked halves joins two edges of this half. Those of EdgeRole::Image are images.
bool is_of_half(const Panel& panel, const EdgeKeyPair& keys, EdgeRole half) {
    return has_linked_halves(panel) && keys.first.role == half && keys.second.role == half;
}

// Seams within panels, by their panel and keys.
using Darts = std::map<std::string, std::map<EdgeKeyPair, const SourceSeam*>>;

Darts darts_by_keys(const Sources& sources) {
    Darts darts;
    for (const SourceSeam& seam : sources.seams) {
        if (seam.first.panel != seam.second.panel) continue;
        darts[seam.first.panel].emplace(sorted_keys(seam.first.edge, seam.second.edge), &seam);
    }
    return darts;
}

void swap_sides(SourceSeam& seam) {
    std::swap(seam.first, seam.second);
    reverse_fields(seam.properties);
}

// Seams by their sources. Pre: the panels' sources are sound.
class SeamEvaluation {
 public:
    SeamEvaluation(const Sources& sources, Pattern& pattern)
        : sources_(sources), pattern_(pattern), index_(index_by_name(pattern.panels)), darts_(darts_by_keys(sources)) {}

    void evaluate() {
        for (const SourceSeam& seam : sources_.seams) add(with_properties(seam));
        for (const Panel& panel : sources_.panels) add_missing_darts(panel);
    }

 private:
    // The drawn panel that the panel is, or is derived from.
    const Panel& drawn(const std::string& panel) const {
        const Panel* at = &sources_.panels[index_.at(panel)];
        while (const auto link = link_of(*at)) at = &sources_.panels[index_.at(link->source)];
        return *at;
    }

    bool is_derived(const SourceSeam& seam) const {
        const auto panel = index_.find(seam.first.panel);
        if (panel == index_.end() || seam.first.panel != seam.second.panel) return false;
        const Panel& own = sources_.panels[panel->second];
        return link_of(own) || is_of_half(own, sorted_keys(seam.first.edge, seam.second.edge), EdgeRole::Image);
    }

    // The dart of the drawn panel, or of its drawn half, that gives the panel this one. Null: there is none.
    const SourceSeam* drawn_dart(const std::string& panel, const EdgeKeyPair& keys) const {
        const Panel& root = drawn(panel);
        const auto darts = darts_.find(root.name);
        if (darts == darts_.end()) return nullptr;
        const auto dart =
            darts->second.find(is_of_half(root, keys, EdgeRole::Image) ? with_role(keys, EdgeRole::Drawn) : keys);
        return dart == darts->second.end() ? nullptr : dart->second;
    }

    SourceSeam with_properties(const SourceSeam& seam) const {
        if (!is_derived(seam)) return seam;
        const EdgeKeyPair keys = sorted_keys(seam.first.edge, seam.second.edge);
        const SourceSeam* dart = drawn_dart(seam.first.panel, keys);
        if (!dart) throw InputError("", "", "panel '" + seam.first.panel + "' has a seam that its source has not");
        SourceSeam made = *dart;
        EdgeKey first = seam.first.edge;
        if (is_of_half(drawn(seam.first.panel), keys, EdgeRole::Image)) first.role = EdgeRole::Drawn;
        if (made.first.edge != first) swap_sides(made);
        made.first = seam.first;
        made.second = seam.second;
        keep_names(made.properties, seam.properties);
        return made;
    }

    void add_missing_darts(const Panel& panel) {
        if (!link_of(panel) && !has_linked_halves(panel)) return;
        const Panel& root = drawn(panel.name);
        for (const SourceSeam& seam : sources_.seams) {
            if (seam.first.panel != root.name || seam.second.panel != root.name) continue;
            const EdgeKeyPair keys = sorted_keys(seam.first.edge, seam.second.edge);
            if (is_of_half(root, keys, EdgeRole::Image)) continue;
            SourceSeam made = seam;
            made.first.panel = made.second.panel = panel.name;
            made.properties = copy_of(made.properties);
            add_missing(made);
            made.first.edge.role = made.second.edge.role = EdgeRole::Image;
            if (is_of_half(root, keys, EdgeRole::Drawn)) add_missing(made);
        }
    }

    void add_missing(const SourceSeam& dart) {
        const auto own = darts_.find(dart.first.panel);
        const EdgeKeyPair keys = sorted_keys(dart.first.edge, dart.second.edge);
        if (own == darts_.end() || !own->second.contains(keys)) add(dart);
    }

    void add(const SourceSeam& seam) {
        Seam& made = pattern_.seams.emplace_back(seam.properties);
        made.first = side_of(seam.first);
        made.second = side_of(seam.second);
    }

    SeamSide side_of(const SourceSide& side) const {
        const auto panel = index_.find(side.panel);
        const auto edge = panel == index_.end() ? std::nullopt : find_edge(pattern_.panels[panel->second], side.edge);
        if (edge) return {.panel = static_cast<int>(panel->second), .edge = *edge};
        throw InputError("", "",
                         "a seam has edge " + std::to_string(side.edge.number) + " of panel '" + side.panel +
                             "', which is not there");
    }

    const Sources& sources_;
    Pattern& pattern_;
    std::map<std::string, std::size_t> index_;
    Darts darts_;
};

}  // namespace

std::optional<Link> link_of(const Panel& panel) {
    if (!panel.mirror_of.empty()) return Link{Derivation::Mirror, panel.mirror_of};
    if (!panel.copy_of.empty()) return Link{Derivation::Copy, panel.copy_of};
    return {};
}

bool has_links(const Pattern& pattern) {
    return std::ranges::any_of(pattern.panels,
                               [](const Panel& panel) { return link_of(panel) || has_linked_halves(panel); });
}

std::optional<Link> link_with(const Pattern& pattern, const Panel& panel) {
    if (const auto link = link_of(panel)) return link;
    for (const Panel& other : pattern.panels) {
        const auto link = link_of(other);
        if (link && link->source == panel.name) return Link{link->kind, other.name};
    }
    return {};
}

// The panel's reflection in the world plane x = 0. Let S = diag(-1, 1, 1) and let m mirror the sheet (is_mirrored
// stays). Then S (R p + t) = (S R S) (S p) + S t, and S p is the local point of m(u), with p the local point of u.
Panel mirror_image(const Panel& panel) {
    Panel image = mapped_panel(panel, Eigen::Affine2d(Eigen::Scaling(-1.0, 1.0)));
    const Eigen::Matrix3d across = Vec3d(-1, 1, 1).asDiagonal();
    image.rotation = across * panel.rotation * across;
    image.translation.x() = -panel.translation.x();
    return image;
}

std::map<std::string, std::size_t> index_by_name(const std::vector<Panel>& panels) {
    std::map<std::string, std::size_t> found;
    for (std::size_t i = 0; i < panels.size(); ++i) found.emplace(panels[i].name, i);
    return found;
}

Panel derived_panel(const Panel& source, Derivation kind, const Panel& own) {
    Panel panel = kind == Derivation::Mirror ? mirror_image(source) : source;
    take_own_fields(panel, own, kind);
    renumber(panel, own.edges);
    return panel;
}

// Both derivations are their own inverses.
Panel source_of_derived(const Panel& derived, Derivation kind, const Panel& own) {
    return derived_panel(derived, kind, own);
}

Pattern evaluate(const Sources& sources) {
    Pattern pattern = sources.rest;
    pattern.panels = PanelEvaluation(sources.panels).evaluate();
    SeamEvaluation(sources, pattern).evaluate();
    return pattern;
}

namespace {

void keep_numbering(Sources& sources, const Pattern& pattern) {
    const std::map<std::string, std::size_t> index = index_by_name(pattern.panels);
    for (std::size_t i = 0; i < pattern.panels.size(); ++i) {
        const Panel& panel = pattern.panels[i];
        const auto link = link_of(panel);
        const auto source = link ? index.find(link->source) : index.end();
        if (source == index.end() || !has_keys(panel)) continue;
        const Panel usual = derived_panel(pattern.panels[source->second], link->kind, sources.panels[i]);
        if (numbering_of(usual) != numbering_of(panel)) sources.panels[i].edges = numbering_of(panel);
    }
}

}  // namespace

Sources sources_of(const Pattern& pattern) {
    Sources sources{.panels = {}, .seams = {}, .rest = pattern};
    sources.rest.panels = {};  // also frees the memory, which clear() would keep
    sources.rest.seams = {};
    for (const Panel& panel : pattern.panels) {
        Panel& source = sources.panels.emplace_back();
        const auto link = link_of(panel);
        if (link) take_own_fields(source, panel, link->kind);
        if (!link) source = half_of(panel, EdgeRole::Drawn).value_or(panel);
        if (!link) give_keys(source);
    }
    keep_numbering(sources, pattern);
    // Edges of derived panels are numbered as their sources', also where they have no keys of their own.
    const std::vector<Panel> panels = PanelEvaluation(sources.panels).evaluate();
    const auto side_of = [&](const SeamSide& side) {
        const Panel& panel = panels[as_size(side.panel)];
        const Panel& shown = pattern.panels[as_size(side.panel)];
        return SourceSide{panel.name, has_keys(shown) ? edge_key(shown, side.edge) : edge_key(panel, side.edge)};
    };
    for (const Seam& seam : pattern.seams) {
        SourceSeam& source = sources.seams.emplace_back();
        source.first = side_of(seam.first);
        source.second = side_of(seam.second);
        const Panel& panel = pattern.panels[as_size(seam.first.panel)];
        const bool is_derived =
            seam.first.panel == seam.second.panel &&
            (link_of(panel) || is_of_half(panel, sorted_keys(source.first.edge, source.second.edge), EdgeRole::Image));
        if (is_derived) keep_names(source.properties, seam);
        if (!is_derived) source.properties = seam;
        source.properties.first = source.properties.second = {};
    }
    return sources;
}

std::vector<int> darts_of(const Pattern& pattern, int panel) {
    std::vector<int> darts;
    for (std::size_t i = 0; i < pattern.seams.size(); ++i) {
        const Seam& seam = pattern.seams[i];
        if (seam.first.panel == panel && seam.second.panel == panel) darts.push_back(static_cast<int>(i));
    }
    return darts;
}

// Comparing what a file holds with what it should hold.

namespace {

constexpr double kRounding = 1e-4;  // m or rad: numbers of a file may be rounded to what is cut

bool is_near(double one, double other) {
    return std::abs(one - other) <= kRounding;
}
template <int kRows, int kColumns>
bool is_near(const Eigen::Matrix<double, kRows, kColumns>& one, const Eigen::Matrix<double, kRows, kColumns>& other) {
    return (one - other).cwiseAbs().maxCoeff() <= kRounding;
}
template <class T>
bool is_near(const T& one, const T& other) {
    return one == other;
}
template <Described Part>
bool is_near(const Part& one, const Part& other);
template <class T>
bool is_near(const std::optional<T>& one, const std::optional<T>& other) {
    return one.has_value() == other.has_value() && (!one || is_near(*one, *other));
}
template <class T, std::size_t kCount>
bool is_near(const std::array<T, kCount>& one, const std::array<T, kCount>& other) {
    return std::ranges::equal(one, other, [](const T& a, const T& b) { return is_near(a, b); });
}
template <class T>
bool is_near(const std::vector<T>& one, const std::vector<T>& other) {
    return std::ranges::equal(one, other, [](const T& a, const T& b) { return is_near(a, b); });
}

// Names may differ; so may where they are placed.
template <Described Part>
bool is_near(const Part& one, const Part& other) {
    bool is_same = true;
    visit_fields(one, [&](const auto& field, const auto& value) {
        const bool is_free = field.descent == Descent::Own || field.descent == Descent::Key ||
                             (field.placing != Placing::None && field.placing != Placing::Side);
        is_same = is_same && (is_free || is_near(value, other.*field.member));
    });
    return is_same;
}

// What seams within a panel have besides their sides and names, by the keys of their edges, from the smaller key on.
using PropertiesByKeys = std::map<EdgeKeyPair, Seam>;

PropertiesByKeys::value_type keyed_properties(Seam seam, const Panel& panel) {
    const EdgeKey one = edge_key(panel, seam.first.edge), other = edge_key(panel, seam.second.edge);
    if (other < one) reverse_fields(seam);
    seam = copy_of(std::move(seam));
    seam.first = seam.second = {};
    return {sorted_keys(one, other), std::move(seam)};
}

// Whether the panel has the darts of its source, wherever they are in the pattern.
bool has_darts_of_source(const Pattern& pattern, const Panel& made, int panel, int source) {
    const auto darts_by = [&](int index, const Panel& keyed) {
        PropertiesByKeys darts;
        for (const int dart : darts_of(pattern, index))
            darts.insert(keyed_properties(pattern.seams[as_size(dart)], keyed));
        return darts;
    };
    return darts_by(panel, made) == darts_by(source, pattern.panels[as_size(source)]);
}

// Whether edges start at distinct vertices, and each vertex is one of them.
bool is_start_of_each(const Panel& panel) {
    std::set<int> starts;
    for (const OutlineEdge& edge : panel.edges) {
        if (edge.start < 0 || as_size(edge.start) >= panel.vertices.size()) return false;
        starts.insert(edge.start);
    }
    return starts.size() == panel.vertices.size() && starts.size() == panel.edges.size();
}

// Whether the corners of one panel, from its first edge on, are those of the other from its edge `shift` on.
bool are_corners_near(const Panel& one, const Panel& other, std::size_t shift) {
    const std::size_t count = one.edges.size();
    for (std::size_t e = 0; e < count; ++e) {
        const OutlineEdge& counterpart = other.edges[(e + shift) % count];
        if (!is_near(one.vertices[as_size(one.edges[e].start)], other.vertices[as_size(counterpart.start)]))
            return false;
    }
    return true;
}

// The panel as its source gives it, with the numbering that it has. None: it is not what its source gives.
std::optional<Panel> as_derived(const Pattern& pattern, int panel, int source, Derivation kind) {
    const Panel& drawn = pattern.panels[as_size(source)];
    Panel found = pattern.panels[as_size(panel)];
    const Panel usual = kind == Derivation::Mirror ? mirror_image(drawn) : drawn;
    const std::size_t count = found.edges.size();
    if (usual.edges.size() != count) return {};
    // Deriving a panel costs much more than comparing its corners, which most shifts do not stand.
    const bool has_corners = count >= 3 && is_start_of_each(found) && is_start_of_each(usual);
    for (std::size_t shift = 0; shift < count; ++shift) {
        if (has_corners && !are_corners_near(found, usual, shift)) continue;
        for (std::size_t e = 0; e < count; ++e) found.edges[e].key = usual.edges[(e + shift) % count].key;
        Panel made = derived_panel(drawn, kind, found);
        if (is_near(found, made) && has_darts_of_source(pattern, made, panel, source)) return made;
    }
    return {};
}

// Whether the halves of the panel are mirror images of each other, with the seams within them.
bool are_halves_alike(const Pattern& pattern, int index) {
    const Panel& panel = pattern.panels[as_size(index)];
    const std::optional<Panel> half = half_of(panel, EdgeRole::Drawn);
    if (!half || 2 * (half->edges.size() - 1) != panel.edges.size() || find_edge(panel, {panel.fold_key})) return false;
    const OutlineEdge& fold = half->edges[as_size(fold_of(*half).value())];
    if (half->vertices[as_size(fold.start)] == half->vertices[as_size(fold.end)]) return false;
    Panel whole = whole_of(*half);
    renumber(whole, panel.edges);
    std::map<EdgeRole, PropertiesByKeys> darts;
    for (const int dart : darts_of(pattern, index)) {
        const auto [keys, properties] = keyed_properties(pattern.seams[as_size(dart)], panel);
        if (keys.first.role == keys.second.role)
            darts[keys.first.role].emplace(with_role(keys, EdgeRole::Drawn), properties);
    }
    return is_near(whole, panel) &&
           std::ranges::equal(whole.edges, panel.edges, {}, &OutlineEdge::key, &OutlineEdge::key) &&
           darts[EdgeRole::Drawn] == darts[EdgeRole::Image];
}

// What only reads a file tells it too, and changes nothing in it.
constexpr const char* kNotFollowed = ": the link is not followed";

void end_link(Panel& panel) {
    panel.mirror_of.clear();
    panel.copy_of.clear();
    panel.fold_key = 0;
}

}  // namespace

std::vector<EndedLink> end_broken_links(Pattern& pattern) {
    std::vector<EndedLink> ended;
    for (std::size_t i = 0; i < pattern.panels.size(); ++i) {
        Panel& panel = pattern.panels[i];
        if (link_of(panel)) continue;
        give_keys(panel);
        if (!has_linked_halves(panel) || are_halves_alike(pattern, static_cast<int>(i))) continue;
        ended.push_back(
            {panel.name, "the halves of '" + panel.name + "' are not mirror images of each other" + kNotFollowed});
        panel.fold_key = 0;
    }
    const std::map<std::string, std::size_t> index = index_by_name(pattern.panels);
    // Sources before what is derived from them, which takes their keys.
    std::set<std::string> known;
    for (const Panel& panel : pattern.panels) {
        if (!link_of(panel)) known.insert(panel.name);
    }
    bool is_under_way = true;
    while (std::exchange(is_under_way, false)) {
        for (std::size_t i = 0; i < pattern.panels.size(); ++i) {
            Panel& panel = pattern.panels[i];
            const auto link = link_of(panel);
            if (!link || known.contains(panel.name) || !known.contains(link->source)) continue;
            const int source = static_cast<int>(index.at(link->source));
            is_under_way = known.insert(panel.name).second;
            if (const auto made = as_derived(pattern, static_cast<int>(i), source, link->kind)) {
                for (std::size_t e = 0; e < panel.edges.size(); ++e) panel.edges[e].key = made->edges[e].key;
                panel.last_key = made->last_key;
                panel.fold_key = made->fold_key;
                continue;
            }
            ended.push_back({panel.name, "'" + panel.name + "' is not the " +
                                             (link->kind == Derivation::Mirror ? "mirror image" : "copy") + " of '" +
                                             link->source + "'" + kNotFollowed});
            end_link(panel);
            give_keys(panel);
        }
    }
    for (Panel& panel : pattern.panels) {
        if (known.contains(panel.name)) continue;
        ended.push_back({panel.name, "'" + panel.name + "' is derived from a panel that is not there, or from itself" +
                                         kNotFollowed});
        end_link(panel);
        give_keys(panel);
    }
    return ended;
}

}  // namespace selvedge::sim

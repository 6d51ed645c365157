#include "editor/geometry/seam_bundles.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "editor/geometry/draft.h"
#include "sim/pattern/edge_keys.h"
#include "sim/pattern/outline.h"

namespace selvedge::editor {
namespace {

std::array<BundleSide*, 2> sides_of(SeamBundle& bundle) {
    return {&bundle.first, &bundle.second};
}

bool has_ended(const SeamBundle& bundle) {
    return bundle.first.pieces.empty() || bundle.second.pieces.empty();
}

[[noreturn]] void throw_unlike() {
    throw GeometryError("Linked panels are sewn to each other so that their seams cannot be split alike.");
}

// Pieces that together are the whole edge, as its heirs by their lengths.
std::vector<EdgeHeir> heirs_by_length(const EdgePieces& parts, const std::function<double(const EdgePiece&)>& length) {
    std::vector<double> reached{0};
    for (const EdgePiece& part : parts) reached.push_back(reached.back() + length(part));
    std::vector<EdgeHeir> heirs;
    for (std::size_t i = 0; i < parts.size(); ++i)
        heirs.push_back({reached[i] / reached.back(), reached[i + 1] / reached.back(), parts[i]});
    return heirs;
}

}  // namespace

EdgePieces heirs_of(const EdgePiece& piece, const std::vector<EdgeHeir>& heirs) {
    EdgePieces found;
    for (const EdgeHeir& heir : heirs) {
        const double from = std::max(piece.from, heir.from), to = std::min(piece.to, heir.to);
        if (to - from <= kSameFraction) continue;
        const auto at = [&](double t) {
            const double share = (t - heir.from) / (heir.to - heir.from);
            return heir.piece.from + share * (heir.piece.to - heir.piece.from);
        };
        add_piece(found, {.key = heir.piece.key,
                          .from = at(from),
                          .to = at(to),
                          .is_joined = heir.piece.is_joined || piece.is_joined});
    }
    return found;
}

BundledSeams SeamBundles::seams() {
    int steps_left = 2 * static_cast<int>(bundles_.size());
    for (const sim::Panel& panel : families_.panels()) steps_left += 2 * edge_count(panel);
    while (merge_joined() || split_partial() || even_one()) {
        if (steps_left-- <= 0) throw_unlike();
    }
    BundledSeams found;
    for (const SeamBundle& bundle : bundles_) {
        std::optional<sim::Seam>& kept = found.kept.emplace_back();
        const std::size_t count = has_ended(bundle) ? 0 : bundle.first.pieces.size();
        for (std::size_t i = 0; i < count; ++i) {
            sim::Seam seam = bundle.seam;
            seam.first = side_at(bundle.first, i);
            seam.second = side_at(bundle.second, seam.is_reversed ? count - 1 - i : i);
            if (i == 0) {
                kept = std::move(seam);
            } else {
                seam.name.clear();
                found.parts.push_back(std::move(seam));
            }
        }
    }
    return found;
}

sim::SeamSide SeamBundles::side_at(const BundleSide& side, std::size_t piece) const {
    return {side.panel, find_edge(families_.panel(side.panel), side.pieces[piece].key).value()};
}

double SeamBundles::length_of(int panel, const EdgePiece& piece) const {
    const sim::Panel& own = families_.panel(panel);
    const sim::OutlineEdge& edge = own.edges[as_size(find_edge(own, piece.key).value())];
    return outline_length(own, edge) * (piece.to - piece.from);
}

void SeamBundles::end(SeamBundle& bundle) {
    bundle.first.pieces.clear();
    bundle.second.pieces.clear();
}

// Seams of edges that were joined become one, if they are sewn to consecutive edges in the same order.
bool SeamBundles::merge_joined() {
    for (SeamBundle& bundle : bundles_) {
        if (has_ended(bundle)) continue;
        for (const BundleSide* side : sides_of(bundle)) {
            for (const EdgePiece& piece : side->pieces) {
                if (!piece.is_joined || piece.is_whole()) continue;
                merge_group(side->panel, sim::EdgeKey(piece.key));
                return true;
            }
        }
    }
    return false;
}

void SeamBundles::merge_group(int panel, const sim::EdgeKey& key) {
    const auto is_on_edge = [&](const BundleSide& side) {
        return side.panel == panel &&
               std::ranges::any_of(side.pieces, [&](const EdgePiece& p) { return p.key == key; });
    };
    struct Part {
        SeamBundle* bundle;
        BundleSide* own;
        BundleSide* other;
    };
    std::vector<Part> parts;
    for (SeamBundle& bundle : bundles_) {
        if (has_ended(bundle)) continue;
        if (is_on_edge(bundle.first)) parts.push_back({&bundle, &bundle.first, &bundle.second});
        if (is_on_edge(bundle.second)) parts.push_back({&bundle, &bundle.second, &bundle.first});
    }
    SeamBundle& kept = *parts.front().bundle;
    std::ranges::stable_sort(parts, {}, [](const Part& part) { return part.own->pieces.front().from; });
    const bool is_reversed = kept.seam.is_reversed;
    EdgePieces own, other;
    std::set<const SeamBundle*> bundles;
    for (const Part& part : parts) bundles.insert(part.bundle);
    bool is_one = bundles.size() == parts.size();
    for (const Part& part : parts) {
        is_one = is_one && part.own->pieces.size() == 1 && part.bundle->seam.is_reversed == is_reversed &&
                 part.other->panel == parts.front().other->panel;
        add_piece(own, part.own->pieces.front());
    }
    if (is_reversed) std::ranges::reverse(parts);
    for (const Part& part : parts) {
        for (const EdgePiece& piece : part.other->pieces) add_piece(other, piece);
    }
    const BundleSide run{parts.front().other->panel, other};
    is_one = is_one && own.size() == 1 && own.front().is_whole() && has_run(run);
    const bool is_first = &kept.first == std::ranges::find(parts, &kept, &Part::bundle)->own;
    for (const Part& part : parts) end(*part.bundle);
    if (!is_one) return;
    kept.first = is_first ? BundleSide{panel, {EdgePiece{key}}} : run;
    kept.second = is_first ? run : BundleSide{panel, {EdgePiece{key}}};
    kept.wants_join = run.pieces.size() > 1;
}

// Whether the pieces follow each other along the outline, each a whole edge.
bool SeamBundles::has_run(const BundleSide& side) const {
    const sim::Panel& panel = families_.panel(side.panel);
    std::optional<int> last;
    for (const EdgePiece& piece : side.pieces) {
        const std::optional<int> edge = find_edge(panel, piece.key);
        if (!edge || !piece.is_whole() || (last && *edge != (*last + 1) % edge_count(panel))) return false;
        last = edge;
    }
    return true;
}

// An edge that is sewn in parts is split there.
bool SeamBundles::split_partial() {
    for (SeamBundle& bundle : bundles_) {
        if (has_ended(bundle)) continue;
        for (const BundleSide* side : sides_of(bundle)) {
            const auto partial = std::ranges::find_if(side->pieces, [](const EdgePiece& p) { return !p.is_whole(); });
            if (partial == side->pieces.end()) continue;
            const EdgePiece piece = *partial;
            std::vector<double> fractions;
            if (piece.from > kSameFraction) fractions.push_back(piece.from);
            if (piece.to < 1 - kSameFraction) fractions.push_back(piece.to);
            split(side->panel, piece.key, fractions);
            return true;
        }
    }
    return false;
}

// A seam whose sides are divided at different places is divided at all of them.
bool SeamBundles::even_one() {
    for (SeamBundle& bundle : bundles_) {
        if (has_ended(bundle)) continue;
        BundleSide& first = bundle.first;
        BundleSide& second = bundle.second;
        if (bundle.wants_join && first.pieces.size() != second.pieces.size()) {
            const BundleSide longer = first.pieces.size() > second.pieces.size() ? first : second;
            if (!join(longer)) end(bundle);
            return true;
        }
        if (first.pieces.size() + second.pieces.size() == 2) continue;
        if (divide(first, second, bundle.seam.is_reversed) || divide(second, first, bundle.seam.is_reversed))
            return true;
        if (first.pieces.size() == second.pieces.size()) continue;
        throw_unlike();  // what is left to divide is too short
    }
    return false;
}

// Where the pieces of a side meet, as fractions of its length, and its length, m.
std::pair<std::vector<double>, double> SeamBundles::joints_of(const BundleSide& side) const {
    std::vector<double> joints;
    double length = 0;
    for (const EdgePiece& piece : side.pieces) joints.push_back(length += length_of(side.panel, piece));
    for (double& joint : joints) joint /= length;
    joints.pop_back();
    return {joints, length};
}

// Divides a side at one place where only the other is divided. False: there is none.
bool SeamBundles::divide(const BundleSide& side, const BundleSide& other, bool is_reversed) {
    constexpr double kSamePlace = 1e-4;  // m, as joints of runs that are sewn
    const auto [own, length] = joints_of(side);
    const auto [others, other_length] = joints_of(other);
    for (const double joint : others) {
        const double at = is_reversed ? 1 - joint : joint;
        const double shorter = std::min(length, other_length);
        const auto is_there = [&](double t) { return std::abs(t - at) * shorter < kSamePlace; };
        if (is_there(0) || is_there(1) || std::ranges::any_of(own, is_there)) continue;
        const auto piece = static_cast<std::size_t>(std::ranges::upper_bound(own, at) - own.begin());
        const double from = piece == 0 ? 0 : own[piece - 1], to = piece == own.size() ? 1 : own[piece];
        split(side.panel, sim::EdgeKey(side.pieces[piece].key), {(at - from) / (to - from)});
        return true;
    }
    return false;
}

void SeamBundles::split(int panel, const sim::EdgeKey& key, std::vector<double> fractions) {
    const EdgePieces parts = families_.split(panel, key, std::move(fractions));
    replace(panel, [&](const sim::EdgeKey& edge) { return edge == key ? &parts : nullptr; });
}

// Whether the edges of the run became one.
bool SeamBundles::join(const BundleSide& run) {
    const std::optional<EdgePieces> joined = families_.join(run.panel, run.pieces);
    if (!joined) return false;
    std::map<sim::EdgeKey, EdgePieces> parts;
    for (std::size_t i = 0; i < run.pieces.size(); ++i) parts[run.pieces[i].key] = {(*joined)[i]};
    replace(run.panel, [&](const sim::EdgeKey& edge) {
        const auto part = parts.find(edge);
        return part == parts.end() ? nullptr : &part->second;
    });
    return true;
}

void SeamBundles::replace(int panel, const std::function<const EdgePieces*(const sim::EdgeKey&)>& become) {
    const auto replaced = [&](const BundleSide& side) {
        EdgePieces pieces;
        for (const EdgePiece& piece : side.pieces) {
            const EdgePieces* parts = become(piece.key);
            if (!parts) {
                add_piece(pieces, piece);
                continue;
            }
            std::vector<EdgeHeir> heirs =
                heirs_by_length(*parts, [&](const EdgePiece& part) { return length_of(panel, part); });
            if (families_.is_turned(side.panel) != families_.is_turned(panel)) heirs = turned(std::move(heirs));
            for (const EdgePiece& heir : heirs_of(piece, heirs)) add_piece(pieces, heir);
        }
        for (EdgePiece& piece : pieces) piece.is_joined = piece.is_joined && !piece.is_whole();
        return pieces;
    };
    for (SeamBundle& bundle : bundles_) {
        for (BundleSide* side : sides_of(bundle)) {
            if (families_.root_of(side->panel) == families_.root_of(panel)) side->pieces = replaced(*side);
        }
    }
}

}  // namespace selvedge::editor

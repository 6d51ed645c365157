#include "sim/pattern/edge_keys.h"

#include <algorithm>
#include <set>

namespace selvedge::sim {
namespace {

int count_of(const Panel& panel) {
    return static_cast<int>(panel.edges.size());
}

// The edges of `other` with the keys of the edges of `one`, in the order of the latter; -1: there is none.
std::vector<int> matches(const Panel& one, const Panel& other) {
    std::vector<int> found;
    for (int e = 0; e < count_of(one); ++e) found.push_back(find_edge(other, edge_key(one, e)).value_or(-1));
    return found;
}

// How often the numbers fall when they are gone through once round.
int count_falls(const std::vector<int>& numbers) {
    int falls = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) falls += numbers[(i + 1) % numbers.size()] < numbers[i] ? 1 : 0;
    return falls;
}

}  // namespace

bool has_keys(const Panel& panel) {
    return panel.last_key > 0;
}

bool has_plain_keys(const Panel& panel) {
    for (int e = 0; e < count_of(panel); ++e) {
        if (edge_key(panel, e) != EdgeKey{e + 1}) return false;
    }
    return panel.last_key == count_of(panel);
}

EdgeKey edge_key(const Panel& panel, int edge) {
    const EdgeKey& key = panel.edges[as_size(edge)].key;
    return has_keys(panel) ? key : EdgeKey{edge + 1};
}

EdgeKeyPair sorted_keys(const EdgeKey& one, const EdgeKey& other) {
    return std::minmax(one, other);
}

EdgeKeyPair with_role(EdgeKeyPair keys, EdgeRole role) {
    keys.first.role = keys.second.role = role;
    return sorted_keys(keys.first, keys.second);
}

std::optional<int> find_edge(const Panel& panel, const EdgeKey& key) {
    for (int e = 0; e < count_of(panel); ++e) {
        if (edge_key(panel, e) == key) return e;
    }
    return {};
}

EdgeKey new_key(Panel& panel) {
    return has_keys(panel) ? EdgeKey{++panel.last_key} : EdgeKey{};
}

EdgeKey new_part_key(Panel& panel, const OutlineEdge& edge) {
    EdgeKey key = new_key(panel);
    if (panel.fold_key > 0) key.role = edge.key.role;
    return key;
}

void give_keys(Panel& panel) {
    for (const OutlineEdge& edge : panel.edges) panel.last_key = std::max(panel.last_key, edge.key.number);
    std::set<EdgeKey> taken;
    for (OutlineEdge& edge : panel.edges) {
        if (edge.key.number == 0 || !taken.insert(edge.key).second) edge.key = EdgeKey{++panel.last_key};
    }
}

std::vector<OutlineStretch> shared_stretches(const Panel& one, const Panel& other) {
    const std::vector<int> match = matches(one, other);
    const int count = count_of(one), other_count = count_of(other);
    std::vector<int> shared, there;
    for (int e = 0; e < count; ++e) {
        if (match[as_size(e)] < 0) continue;
        shared.push_back(e);
        there.push_back(match[as_size(e)]);
    }
    std::vector<OutlineStretch> found;
    if (count_falls(there) > 1 || is_turned_over(one, other)) return found;
    for (std::size_t i = 0; i < shared.size(); ++i) {
        const std::size_t next = (i + 1) % shared.size();
        found.push_back({.first = shared[i],
                         .count = (shared[next] - shared[i] + count - 1) % count + 1,
                         .other_first = there[i],
                         .other_count = (there[next] - there[i] + other_count - 1) % other_count + 1});
    }
    return found;
}

bool is_turned_over(const Panel& one, const Panel& other) {
    if (one.edges.size() != other.edges.size()) return false;
    std::vector<int> match = matches(one, other);
    if (std::ranges::find(match, -1) != match.end()) return false;
    if (match.size() == 2) return one.edges[0].start == other.edges[as_size(match[0])].end;
    if (count_falls(match) <= 1) return false;
    std::ranges::reverse(match);
    return count_falls(match) <= 1;
}

}  // namespace selvedge::sim

#pragma once
// The elements of each level by what they are now: edges that are unsplit or split, triangles that are refined. Each
// knows its place, so that it can leave when it changes: the last one takes its place. At the deepest level nothing
// changes, so nothing is listed.  (SPEC 1.4)
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/core/ids.h"

namespace selvedge {

class LevelLists {
 public:
    static constexpr std::size_t kBytesPerId = sizeof(std::uint32_t);

    void set_deepest(int level) { levels_.resize(static_cast<std::size_t>(level)); }
    void grow(std::size_t edges, std::size_t triangles) {
        if (edge_places_.size() < edges) edge_places_.resize(edges);
        if (triangle_places_.size() < triangles) triangle_places_.resize(triangles);
    }

    std::span<const EdgeId> unsplit(int level) const { return lists(level, &Level::unsplit); }
    std::span<const EdgeId> split(int level) const { return lists(level, &Level::split); }
    std::span<const TriangleId> refined(int level) const { return lists(level, &Level::refined); }

    void add_unsplit(int level, EdgeId e) {
        if (is_listed(level)) add(at(level).unsplit, edge_places_, e);
    }
    void add_split(int level, EdgeId e) { add(at(level).split, edge_places_, e); }
    void add_refined(int level, TriangleId t) { add(at(level).refined, triangle_places_, t); }

    // Pre: it stands in that list.
    void remove_unsplit(int level, EdgeId e) {
        if (is_listed(level)) remove(at(level).unsplit, edge_places_, e);
    }
    void remove_split(int level, EdgeId e) { remove(at(level).split, edge_places_, e); }
    void remove_refined(int level, TriangleId t) { remove(at(level).refined, triangle_places_, t); }

 private:
    struct Level {
        std::vector<EdgeId> unsplit, split;
        std::vector<TriangleId> refined;
    };

    bool is_listed(int level) const { return static_cast<std::size_t>(level) < levels_.size(); }

    template <class List>
    std::span<const typename List::value_type> lists(int level, List Level::*list) const {
        if (!is_listed(level)) return {};
        return levels_[static_cast<std::size_t>(level)].*list;
    }
    Level& at(int level) { return levels_[static_cast<std::size_t>(level)]; }

    template <class ElementId>
    static void add(std::vector<ElementId>& list, std::vector<std::uint32_t>& places, ElementId id) {
        places[id.value] = static_cast<std::uint32_t>(list.size());
        list.push_back(id);
    }

    template <class ElementId>
    static void remove(std::vector<ElementId>& list, std::vector<std::uint32_t>& places, ElementId id) {
        const std::uint32_t place = places[id.value];
        const ElementId last = list.back();
        list[place] = last;
        places[last.value] = place;
        list.pop_back();
    }

    std::vector<Level> levels_;
    std::vector<std::uint32_t> edge_places_, triangle_places_;  // by id
};

}  // namespace selvedge

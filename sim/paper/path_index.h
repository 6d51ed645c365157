#pragma once
// Finds paths that several pages draw, wherever they draw them, and texts.
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "sim/paper/drawing.h"

namespace selvedge::sim {

// What equal points of two pages may lie apart, mm: what rounding to 1/100 pt and to 1/256 pt gives, and some more.
inline constexpr double kSamePathPlace = 0.15;

// How far one path lies from another that is as long and as bent; none: it is another path.
std::optional<Vec2d> shift_between(const DrawnPath& a, const DrawnPath& b);

// Finds paths that are the same but for their place, or at the same place.
class PathIndex {
 public:
    enum class Match { Anywhere, AtOnePlace };
    explicit PathIndex(Match match) : is_placed_(match == Match::AtOnePlace) {}

    void add(const DrawnPath& path, std::size_t page, std::size_t shape) {
        entries_[key_of(path)].push_back({&path, page, shape});
    }

    // Calls visit(page, shape, shift from `path` to it). Of paths that are there by hundreds, as the strokes of a
    // hatching, none is visited.
    template <class Visit>
    void for_each_alike(const DrawnPath& path, Visit visit) const {
        constexpr std::size_t kMost = 600;
        const Key own = key_of(path);
        std::vector<Key> keys{own};
        for (std::size_t i = 0; i < own.steps.size(); ++i) {
            const std::size_t count = keys.size();
            for (std::size_t k = 0; k < count && own.beside[i] != 0; ++k) {
                keys.push_back(keys[k]);
                keys.back().steps[i] += own.beside[i];
            }
        }
        for (const Key& key : keys) {
            const auto found = entries_.find(key);
            if (found == entries_.end() || found->second.size() > kMost) continue;
            for (const Entry& entry : found->second) {
                if (entry.path == &path) continue;
                if (const auto shift = shift_between(path, *entry.path)) visit(entry.page, entry.shape, *shift);
            }
        }
    }

 private:
    // Edges, and extent and place in steps that are wider than what places are off; and where a value is near the end
    // of its step, which one is beside it.
    struct Key {
        std::size_t edges = 0;
        bool is_closed = false;
        std::array<long, 4> steps = {};
        std::array<int, 4> beside = {};

        bool operator<(const Key& other) const {
            return std::tie(edges, is_closed, steps) < std::tie(other.edges, other.is_closed, other.steps);
        }
    };
    struct Entry {
        const DrawnPath* path;
        std::size_t page, shape;
    };

    Key key_of(const DrawnPath& path) const;

    bool is_placed_;
    std::map<Key, std::vector<Entry>> entries_;
};

// Texts by what they say and where they are.
class TextIndex {
 public:
    void add(const std::string& text, const Vec2d& at, std::size_t page) {
        entries_[key_of(text, at, 0, 0)].insert(page);
    }

    // Whether the text is there, about, on another page than this one.
    bool has_on_other(const std::string& text, const Vec2d& at, std::size_t page) const {
        for (int i = 0; i < 9; ++i) {
            const auto found = entries_.find(key_of(text, at, i % 3 - 1, i / 3 - 1));
            if (found != entries_.end() && (found->second.size() > 1 || !found->second.contains(page))) return true;
        }
        return false;
    }

 private:
    using Key = std::tuple<std::string, long, long>;
    static Key key_of(const std::string& text, const Vec2d& at, int dx, int dy) {
        constexpr double kStep = 1;  // mm
        return {text, std::lround(at.x() / kStep) + dx, std::lround(at.y() / kStep) + dy};
    }
    std::map<Key, std::set<std::size_t>> entries_;
};

}  // namespace selvedge::sim

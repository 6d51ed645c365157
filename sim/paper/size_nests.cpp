#include "sim/paper/size_nests.h"

#include <algorithm>
#include <map>
#include <set>

#include "sim/core/disjoint_sets.h"
#include "sim/paper/size_names.h"

namespace selvedge::sim {
namespace {

class NestFinder {
 public:
    NestFinder(const PlainDrawing& drawing, const std::vector<PlainArea>& areas) : drawing_(drawing), areas_(areas) {
        nests_.sizes.resize(areas.size());
    }

    SizeNests find() {
        if (!take_names()) take_outlines();
        return std::move(nests_);
    }

 private:
    const PlainShape& shape(std::size_t a) const { return drawing_.shapes[areas_[a].shape]; }

    bool take_names() {
        std::vector<std::string> named(areas_.size());
        std::set<std::string> different;
        for (std::size_t a = 0; a < areas_.size(); ++a) {
            if (areas_[a].is_left_out) continue;
            named[a] = size_of_shape(shape(a));
            if (!named[a].empty()) different.insert(named[a]);
        }
        if (different.size() < 2) return take_ends_of_names();
        // Bare numbers may count pieces or layers: sizes of one part lie on each other.
        const bool are_numbers = std::ranges::all_of(different, [](const std::string& size) {
            return std::ranges::all_of(size, [](char c) { return c >= '0' && c <= '9'; });
        });
        if (are_numbers && !says_size() && !has_alike(named)) return false;
        nests_.sizes = std::move(named);
        return true;
    }

    // Whether a name has a word for size, too.
    bool says_size() const {
        return std::ranges::any_of(drawing_.shapes, [](const PlainShape& shape) {
            std::string names = shape.path.name;
            for (const PlainGroup& group : shape.groups) names += " " + group.label + " " + group.id;
            return has_size_word(names);
        });
    }

    bool has_alike(const std::vector<std::string>& named) const {
        for (std::size_t a = 0; a < areas_.size(); ++a) {
            for (std::size_t b = 0; b < a; ++b) {
                if (!named[a].empty() && !named[b].empty() && named[a] != named[b] && are_alike(a, b)) return true;
            }
        }
        return false;
    }

    // The shape's own name, or that of its nearest group, whichever divides.
    static std::string name_with_size(const PlainShape& shape) {
        if (split_size(shape.path.name)) return shape.path.name;
        for (auto group = shape.groups.rbegin(); group != shape.groups.rend(); ++group) {
            for (const std::string& name : {group->label, group->id}) {
                if (split_size(name)) return name;
            }
        }
        return {};
    }

    // "Front_S" and "Front_M".
    bool take_ends_of_names() {
        std::vector<std::string> names;
        for (std::size_t a = 0; a < areas_.size(); ++a)
            names.push_back(areas_[a].is_left_out ? std::string() : name_with_size(shape(a)));
        const auto splits = split_sizes(names);
        for (std::size_t a = 0; a < areas_.size(); ++a) nests_.sizes[a] = splits[a] ? splits[a]->second : std::string();
        return std::ranges::any_of(nests_.sizes, [](const std::string& size) { return !size.empty(); });
    }

    // ---- Outlines that lie on each other.

    // Whether two outlines can be one part in two sizes: they cover nearly the same, and neither is the other's inset.
    bool are_alike(std::size_t a, std::size_t b) const {
        constexpr double kCommon = 0.45, kRatio = 0.5;
        const Eigen::AlignedBox2d common = areas_[a].box.intersection(areas_[b].box);
        if (common.isEmpty()) return false;
        const double both = common.sizes().prod();
        const double all = areas_[a].box.sizes().prod() + areas_[b].box.sizes().prod() - both;
        const double small = std::min(areas_[a].area, areas_[b].area), large = std::max(areas_[a].area, areas_[b].area);
        return both > kCommon * all && small > kRatio * large;
    }

    bool is_pair_of_lines(std::size_t a, std::size_t b) const {
        const bool is_smaller = areas_[a].area < areas_[b].area;
        return is_smaller ? is_inset(areas_[a], areas_[b]) : is_inset(areas_[b], areas_[a]);
    }

    std::vector<std::vector<std::size_t>> clusters() const {
        DisjointSets sets(areas_.size());
        for (std::size_t a = 0; a < areas_.size(); ++a) {
            for (std::size_t b = 0; b < a; ++b) {
                if (!areas_[a].is_left_out && !areas_[b].is_left_out && are_alike(a, b))
                    sets.join(static_cast<int>(a), static_cast<int>(b));
            }
        }
        std::map<int, std::vector<std::size_t>> lists;
        for (std::size_t a = 0; a < areas_.size(); ++a) {
            if (!areas_[a].is_left_out) lists[sets.find(static_cast<int>(a))].push_back(a);
        }
        std::vector<std::vector<std::size_t>> all;
        for (auto& [root, list] : lists) {
            std::ranges::stable_sort(list, {}, [&](std::size_t a) { return areas_[a].area; });
            if (list.size() > 1) all.push_back(std::move(list));
        }
        return all;
    }

    std::set<std::string> styles_of(const std::vector<std::size_t>& cluster) const {
        std::set<std::string> styles;
        for (const std::size_t a : cluster) styles.insert(shape(a).style);
        return styles;
    }

    // Two outlines are a cut line and a sewing line, or a part and a line in it, unless several parts have such pairs,
    // each pair in the same two styles, and at uneven distances.
    void take_outlines() {
        std::vector<std::vector<std::size_t>> all = clusters();
        std::map<std::size_t, int> counts;
        for (const auto& cluster : all) ++counts[cluster.size()];
        std::size_t number = 0;  // of sizes: the most frequent number of outlines in a nest
        for (const auto& [size, count] : counts) {
            const bool is_enough = count > 1 || size > 3;  // three lines may be those of one part
            if (size > 2 && is_enough && (number == 0 || count >= counts[number])) number = size;
        }
        if (number == 0 && is_nest_of_two(all)) number = 2;
        if (number == 0) return;
        std::erase_if(all, [&](const auto& cluster) { return cluster.size() != number || !is_nest(cluster); });
        if (all.empty()) return;
        const std::vector<std::string> names = names_of_sizes(number);
        for (const std::vector<std::size_t>& cluster : all) {
            for (std::size_t k = 0; k < number; ++k) nests_.sizes[cluster[k]] = names[k];
        }
        order_by_style(all, names);
    }

    // More than a line beside a line: hem, seam and cut lines lie at even distances.
    bool is_nest(const std::vector<std::size_t>& cluster) const {
        for (std::size_t k = 0; k + 1 < cluster.size(); ++k) {
            const bool is_same_style = shape(cluster[k]).style == shape(cluster[k + 1]).style;
            if (is_same_style && is_even_inset(areas_[cluster[k]], areas_[cluster[k + 1]])) return false;
        }
        return true;
    }

    bool is_nest_of_two(const std::vector<std::vector<std::size_t>>& all) const {
        std::set<std::set<std::string>> styles;
        int nests = 0;
        for (const std::vector<std::size_t>& cluster : all) {
            if (cluster.size() != 2 || is_pair_of_lines(cluster[0], cluster[1])) return false;
            styles.insert(styles_of(cluster));
            ++nests;
        }
        return nests > 1 && styles.size() == 1 && styles.begin()->size() == 2;
    }

    std::vector<std::string> names_of_sizes(std::size_t number) const {
        std::vector<std::string> names;
        for (const DrawnText& text : drawing_.texts) {
            const auto size = size_of_name(text.text);
            if (size && std::ranges::find(names, *size) == names.end()) names.push_back(*size);
        }
        sort_sizes(names);
        if (names.size() == number) return names;
        names.clear();
        for (std::size_t k = 0; k < number; ++k) names.push_back(std::to_string(k + 1));
        return names;
    }

    // Where all nests have the same styles, a style is a size in each: outlines of one part may not grow in order.
    void order_by_style(const std::vector<std::vector<std::size_t>>& nests, const std::vector<std::string>& names) {
        const std::set<std::string> styles = styles_of(nests.front());
        if (styles.size() != names.size()) return;
        if (!std::ranges::all_of(nests, [&](const auto& nest) { return styles_of(nest) == styles; })) return;
        std::vector<std::pair<double, std::string>> sums;  // of the areas in a style
        for (const std::string& style : styles) {
            double sum = 0;
            for (const std::vector<std::size_t>& nest : nests) {
                for (const std::size_t a : nest) sum += shape(a).style == style ? areas_[a].area : 0;
            }
            sums.emplace_back(sum, style);
        }
        std::ranges::sort(sums);
        for (const std::vector<std::size_t>& nest : nests) {
            for (const std::size_t a : nest) {
                const auto found = std::ranges::find(sums, shape(a).style, &std::pair<double, std::string>::second);
                nests_.sizes[a] = names[static_cast<std::size_t>(found - sums.begin())];
            }
        }
    }

    const PlainDrawing& drawing_;
    const std::vector<PlainArea>& areas_;
    SizeNests nests_;
};

}  // namespace

SizeNests find_size_nests(const PlainDrawing& drawing, const std::vector<PlainArea>& areas) {
    return NestFinder(drawing, areas).find();
}

}  // namespace selvedge::sim

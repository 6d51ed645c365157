#include "sim/paper/dxf_blocks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "sim/core/error.h"
#include "sim/core/lower_case.h"

namespace selvedge::sim {
namespace {

class BlockPlacer {
 public:
    BlockPlacer(const std::vector<DxfPiece>& blocks, const std::string& file, std::vector<std::string>& notes)
        : blocks_(blocks), file_(file), notes_(notes) {
        for (std::size_t b = 0; b < blocks.size(); ++b) by_name_[blocks[b].name].push_back(b);
    }

    std::vector<DxfPiece> place(const std::vector<DxfInsert>& inserts, bool has_loose) {
        for (const DxfInsert& insert : inserts) collect(insert, Eigen::Affine2d::Identity(), 0);
        const bool is_any_placed = has_loose || !maps_.empty();
        std::vector<DxfPiece> pieces;
        for (std::size_t b = 0; b < blocks_.size(); ++b) {
            const auto found = maps_.find(b);
            if (is_layout(blocks_[b]) || blocks_[b].lines.empty()) continue;  // what a layout places is a piece itself
            if (found == maps_.end() && hidden_.contains(b)) continue;
            if (found == maps_.end()) {
                if (!is_any_placed || says_piece_name(blocks_[b])) {
                    add(b, Eigen::Affine2d::Identity(), pieces);
                } else if (!is_part_.contains(b)) {
                    notes_.push_back("line " + std::to_string(blocks_[b].line) + ": block '" + blocks_[b].name +
                                     "' is not placed in the drawing, left out");
                }
                continue;
            }
            add_placed(b, found->second, pieces);
        }
        return pieces;
    }

 private:
    static constexpr int kDeepest = 16;

    static bool is_layout(const DxfPiece& block) { return block.name.starts_with('*') || block.name.starts_with('$'); }

    static bool says_piece_name(const DxfPiece& block) {
        return std::ranges::any_of(block.texts, [](const DxfLayerText& text) {
            return lower_case(text.text).find("piece name") != std::string::npos;
        });
    }

    void check_depth(int depth, const DxfInsert& insert) {
        if (depth > kDeepest || ++steps_ > kMostSteps)
            throw InputError(file_, "line " + std::to_string(insert.line),
                             "INSERT: blocks place each other without end");
    }

    // The block that an INSERT means; of several that share a name, one after the other. Null: there is none.
    std::optional<std::size_t> block_of(const DxfInsert& insert, std::size_t nth = 0) const {
        const auto found = by_name_.find(insert.block);
        if (found == by_name_.end()) return std::nullopt;
        return found->second[nth % found->second.size()];
    }

    void collect(const DxfInsert& insert, const Eigen::Affine2d& above, int depth) {
        check_depth(depth, insert);
        const auto found = block_of(insert, placed_[insert.block]++);
        if (!found && missing_.insert(insert.block).second)
            notes_.push_back("line " + std::to_string(insert.line) + ": block '" + insert.block +
                             "' is not in the file");
        if (!found) return;
        if (insert.is_hidden) {
            hidden_.insert(*found);
            return;
        }
        const DxfPiece& block = blocks_[*found];
        const Eigen::Affine2d map = above * insert.map * Eigen::Translation2d(-block.base);
        if (block.lines.empty()) {
            for (const DxfInsert& inner : block.inserts) collect(inner, map, depth + 1);
            return;
        }
        maps_[*found].push_back(map);
        note_parts(block, depth + 1);
    }

    // Blocks that are drawn as parts of others.
    void note_parts(const DxfPiece& block, int depth) {
        for (const DxfInsert& insert : block.inserts) {
            check_depth(depth, insert);
            const auto found = block_of(insert);
            if (!found) continue;
            is_part_.insert(*found);
            note_parts(blocks_[*found], depth + 1);
        }
    }

    // A block with all that it places.
    DxfPiece whole(std::size_t b, int depth) {
        DxfPiece piece = blocks_[b];
        const std::vector<DxfInsert> inserts = std::exchange(piece.inserts, {});
        for (const DxfInsert& insert : inserts) {
            check_depth(depth, insert);
            const auto found = block_of(insert);
            if (!found || insert.is_hidden) continue;
            DxfPiece inner = whole(*found, depth + 1);
            transform(inner, insert.map * Eigen::Translation2d(-blocks_[*found].base));
            append(piece, std::move(inner));
        }
        return piece;
    }

    void add(std::size_t b, const Eigen::Affine2d& map, std::vector<DxfPiece>& pieces) {
        DxfPiece piece = whole(b, 0);
        transform(piece, Eigen::Affine2d(map.linear()));
        pieces.push_back(std::move(piece));
    }

    static bool is_equal(double a, double b) {
        constexpr double kSame = 1e-6;
        return std::abs(a - b) <= kSame * std::max(std::abs(a), std::abs(b));
    }

    // One piece per size and side: a block that is laid twice is one piece. What is laid as drawn and mirrored is a
    // pair.
    void add_placed(std::size_t b, const std::vector<Eigen::Affine2d>& maps, std::vector<DxfPiece>& pieces) {
        std::vector<double> areas;  // with their sides as signs
        for (const Eigen::Affine2d& map : maps) {
            const double area = map.linear().determinant();
            if (std::ranges::any_of(areas, [&](double other) { return is_equal(area, other); })) continue;
            areas.push_back(area);
            add(b, map, pieces);
        }
        if (maps.size() > areas.size()) {
            notes_.push_back("block '" + blocks_[b].name + "' is placed " + std::to_string(maps.size()) +
                             " times: taken once" + (areas.size() > 1 ? " per size and side" : ""));
        }
        constexpr double kScaled = 1e-3;
        if (std::abs(std::abs(areas.front()) - 1) > kScaled) ++scaled_;
    }

 public:
    int scaled() const { return scaled_; }

 private:
    static constexpr int kMostSteps = 200000;

    const std::vector<DxfPiece>& blocks_;
    const std::string& file_;
    std::vector<std::string>& notes_;
    std::map<std::string, std::vector<std::size_t>> by_name_;
    std::map<std::string, std::size_t> placed_;                 // how often each name was placed so far
    std::map<std::size_t, std::vector<Eigen::Affine2d>> maps_;  // where blocks stand in the drawing
    std::set<std::size_t> is_part_;
    std::set<std::size_t> hidden_;
    std::set<std::string> missing_;
    int steps_ = 0;
    int scaled_ = 0;
};

}  // namespace

std::vector<DxfPiece> placed_pieces(const std::vector<DxfPiece>& blocks, const std::vector<DxfInsert>& inserts,
                                    bool has_loose, const std::string& file, std::vector<std::string>& notes) {
    BlockPlacer placer(blocks, file, notes);
    std::vector<DxfPiece> pieces = placer.place(inserts, has_loose);
    if (placer.scaled() > 0)
        notes.push_back("blocks are placed at a scale of their own (" + std::to_string(placer.scaled()) + "): applied");
    return pieces;
}

}  // namespace selvedge::sim

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
        for (const auto& placed : maps_) whole_.extend(boxes_[placed.first] = placed_box(placed.first));
        const bool is_any_placed = has_loose || !maps_.empty();
        std::vector<DxfPiece> pieces;
        for (std::size_t b = 0; b < blocks_.size(); ++b) {
            const auto found = maps_.find(b);
            // What a layout places is a piece itself.
            if (is_space(blocks_[b]) || blocks_[b].lines.empty()) continue;
            if (found == maps_.end() && (is_unnamed(blocks_[b]) || hidden_.contains(b))) continue;
            if (found == maps_.end()) {
                if (!is_any_placed || says_piece_name(blocks_[b])) {
                    add(b, Eigen::Affine2d::Identity(), pieces);
                } else if (!is_part_.contains(b)) {
                    notes_.push_back("line " + std::to_string(blocks_[b].line) + ": block '" + blocks_[b].name +
                                     "' is not placed in the drawing, left out");
                }
                continue;
            }
            if (is_sheet(b)) {
                notes_.push_back("line " + std::to_string(blocks_[b].line) + ": block '" + blocks_[b].name +
                                 "': a page frame, left out");
                continue;
            }
            add_placed(b, found->second, pieces);
        }
        return pieces;
    }

 private:
    static constexpr int kDeepest = 16;

    Eigen::AlignedBox2d placed_box(std::size_t b) const {
        Eigen::AlignedBox2d box;
        for (const Eigen::Affine2d& map : maps_.at(b)) {
            for (const DxfLine& line : blocks_[b].lines) {
                for (const Vec2d& p : line.points) box.extend(map * p);
            }
        }
        return box;
    }

    // Whether all lines of a block run along the axes, and all other blocks that are placed lie within it, and not upon
    // each other: a page.
    bool is_sheet(std::size_t b) const {
        constexpr double kAlong = 1e-6;  // of a segment's length, off the axis
        if (maps_.size() < 2 || maps_.at(b).size() != 1) return false;
        for (const DxfLine& line : blocks_[b].lines) {
            for (std::size_t i = 1; i < line.points.size(); ++i) {
                const Vec2d step = (line.points[i] - line.points[i - 1]).cwiseAbs();
                if (step.minCoeff() > kAlong * step.maxCoeff()) return false;
            }
        }
        if (!boxes_.at(b).contains(whole_)) return false;
        // Boxes that meet pairwise have a point in common.
        Eigen::AlignedBox2d common = whole_;
        for (const auto& [other, box] : boxes_) {
            if (other != b) common = common.intersection(box);
        }
        return common.isEmpty();
    }

    // Of the drawing itself, or of a sheet of paper.
    static bool is_space(const DxfPiece& block) {
        const std::string name = lower_case(block.name);
        if (!is_unnamed(block)) return false;
        return name.substr(1).starts_with("model_space") || name.substr(1).starts_with("paper_space");
    }

    // By the program that wrote the file, as a dimension is: it counts only where it is placed.
    static bool is_unnamed(const DxfPiece& block) { return block.name.starts_with('*') || block.name.starts_with('$'); }

    static bool says_piece_name(const DxfPiece& block) {
        return std::ranges::any_of(block.texts, [](const DxfLayerText& text) {
            return lower_case(text.text).find("piece name") != std::string::npos;
        });
    }

    void check_depth(int depth, const DxfInsert& insert) {
        const std::string place = "line " + std::to_string(insert.line);
        if (depth > kDeepest) throw InputError(file_, place, "INSERT: blocks place each other without end");
        if (++steps_ > kMostSteps) throw InputError(file_, place, "INSERT: more than 200,000 blocks are placed");
    }

    // The block that an INSERT means; of several that share a name, one after the other. None: it is not in the file.
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
        std::vector<Eigen::Affine2d>& maps = maps_[*found];
        maps.push_back(map);
        if (maps.size() == 1) note_parts(block, depth + 1);
    }

    // Blocks that are drawn as parts of others.
    void note_parts(const DxfPiece& block, int depth) {
        for (const DxfInsert& insert : block.inserts) {
            check_depth(depth, insert);
            const auto found = block_of(insert);
            if (!found) continue;
            if (is_part_.insert(*found).second) note_parts(blocks_[*found], depth + 1);
        }
    }

    // A block with all that it places.
    DxfPiece whole(std::size_t b, int depth) {
        vertices_ += blocks_[b].points.size() + blocks_[b].texts.size();
        for (const DxfLine& line : blocks_[b].lines) vertices_ += line.points.size();
        if (vertices_ > kMostDxfVertices)
            throw InputError(file_, "line " + std::to_string(blocks_[b].line),
                             "the blocks that are placed have more than 2 million vertices");
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
        const auto is_placed_well = [](const DxfLine& line) { return std::ranges::all_of(line.points, is_dxf_place); };
        if (!std::ranges::all_of(piece.lines, is_placed_well) ||
            !std::ranges::all_of(piece.points, is_dxf_place, &std::pair<int, Vec2d>::second) ||
            !std::ranges::all_of(piece.texts, is_dxf_place, &DxfLayerText::at))
            throw InputError(file_, "line " + std::to_string(piece.line),
                             "block '" + piece.name + "': where it is placed, a point is not a number, or too large");
        pieces.push_back(std::move(piece));
    }

    // Whether one map gives what another does, turned.
    static bool is_turned(const Eigen::Matrix2d& a, const Eigen::Matrix2d& b) {
        constexpr double kSame = 1e-6;
        const Eigen::Matrix2d one = a.transpose() * a, other = b.transpose() * b;
        return (one - other).norm() <= 2 * kSame * std::max(one.norm(), other.norm()) &&
               (a.determinant() < 0) == (b.determinant() < 0);
    }

    // One piece per size and side: a block that is laid twice is one piece. What is laid as drawn and mirrored is a
    // pair.
    void add_placed(std::size_t b, const std::vector<Eigen::Affine2d>& maps, std::vector<DxfPiece>& pieces) {
        constexpr std::size_t kMostSizes = 1000;
        std::vector<Eigen::Matrix2d> taken;
        for (const Eigen::Affine2d& map : maps) {
            const Eigen::Matrix2d linear = map.linear();
            if (std::ranges::any_of(taken, [&](const auto& other) { return is_turned(linear, other); })) continue;
            if (taken.size() == kMostSizes)
                throw InputError(file_, "line " + std::to_string(blocks_[b].line),
                                 "block '" + blocks_[b].name + "' is placed in more than 1,000 sizes");
            taken.push_back(linear);
            add(b, map, pieces);
        }
        if (maps.size() > taken.size()) {
            notes_.push_back("block '" + blocks_[b].name + "' is placed " + std::to_string(maps.size()) +
                             " times: taken once" + (taken.size() > 1 ? " per size and side" : ""));
        }
        constexpr double kScaled = 1e-3;
        const Eigen::Matrix2d gram = taken.front().transpose() * taken.front();
        if ((gram - Eigen::Matrix2d::Identity()).cwiseAbs().maxCoeff() > kScaled) ++scaled_;
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
    std::map<std::size_t, Eigen::AlignedBox2d> boxes_;          // of these blocks as they are placed
    Eigen::AlignedBox2d whole_;                                 // of all of them
    std::set<std::size_t> is_part_;
    std::set<std::size_t> hidden_;
    std::set<std::string> missing_;
    std::size_t vertices_ = 0;
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

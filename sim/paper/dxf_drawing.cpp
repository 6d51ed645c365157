#include "sim/paper/dxf_drawing.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>

#include "sim/core/error.h"
#include "sim/core/lower_case.h"
#include "sim/core/printable.h"
#include "sim/paper/closed_chains.h"
#include "sim/paper/cut_text.h"
#include "sim/paper/drawing_unit.h"
#include "sim/paper/dxf_blocks.h"
#include "sim/paper/dxf_entities.h"
#include "sim/paper/dxf_grading.h"
#include "sim/paper/dxf_layers.h"
#include "sim/paper/dxf_lines.h"
#include "sim/paper/dxf_records.h"
#include "sim/paper/dxf_text.h"
#include "sim/paper/path_builder.h"
#include "sim/paper/placement_record.h"
#include "sim/paper/plain_parts.h"
#include "sim/paper/size_names.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/polyline.h"

namespace selvedge::sim {
namespace {

constexpr std::size_t kMostEntities = 2000000;

bool is_outline_layer(int layer) {
    return layer == kBoundaryLayer || layer == kSewLayer;
}

class DxfReader {
 public:
    DxfReader(std::string_view text, const std::string& file, const GradeRules* rules)
        : file_(file),
          rules_(rules),
          decoded_(decoded_dxf(text)),
          groups_(parse_dxf(decoded_ ? std::string_view(*decoded_) : text, file)) {}

    Drawing read() {
        drawing_.format = "DXF";
        drawing_.is_upright = false;
        read_sections();
        read_pieces();
        if (!version_.empty()) drawing_.format += " (" + std::string(version_) + ")";
        if (hidden_ > 0)
            drawing_.notes.push_back(count_text(static_cast<std::size_t>(hidden_), "hidden element") + " left out");
        constexpr std::size_t kOutline = 3;  // lines that may make one
        const bool has_loose = loose_.lines.size() >= kOutline ||
                               std::ranges::any_of(loose_.lines, [](const DxfLine& line) { return line.is_closed; });
        std::vector<DxfPiece> pieces = placed_pieces(blocks_, loose_.inserts, has_loose, file_, drawing_.notes);
        for (const DxfPiece& piece : pieces) {
            for (const DxfLayerText& text : piece.texts) read_file_text(text.text);
        }
        settle_unit(pieces);
        bool has_sewing_lines = false;
        for (DxfPiece& piece : pieces) {
            join_outlines(piece, gap_in(piece), joints_);
            has_sewing_lines |= find_sewing_line(piece) != nullptr;
        }
        tell_joined();
        if (rules_) add_graded(pieces);
        for (DxfPiece& piece : pieces) add_part(std::move(piece), has_sewing_lines);
        add_loose_parts();
        add_seams();
        drawing_.body = read_body_phrase(body_text_);
        find_sample_size();
        name_again();
        if (drawing_.parts.empty()) refuse_open();
        return std::move(drawing_);
    }

 private:
    // Where no line is closed: names the largest of those that were meant to be.
    [[noreturn]] void refuse_open() const {
        if (first_open_) throw *first_open_;
        const DxfLine* found = nullptr;
        for (const DxfLine& line : loose_.lines) {
            if (!line.is_closed && line.points.size() > 2 && (!found || extent_of(line) > extent_of(*found)))
                found = &line;
        }
        const std::string hidden = hidden_ > 0 ? "; " + std::to_string(hidden_) + " elements are hidden" : "";
        if (!found) throw InputError(file_, "", "no closed line: nothing that could be a panel" + hidden);
        throw InputError(file_, "line " + std::to_string(found->line),
                         open_by(gap_of(*found), drawing_.metres_per_unit) +
                             ", and no other line is closed: nothing that could be a panel" + hidden);
    }

    void read_sections() {
        std::string_view section;
        std::vector<DxfEntity> entities;
        const auto finish = [&] {
            if (section == "TABLES") read_layers(entities);
            if (section == "BLOCKS") block_entities_ = std::move(entities);
            if (section == "ENTITIES") std::ranges::move(entities, std::back_inserter(loose_entities_));
            section = {};
            entities = {};
        };
        for (std::size_t i = 0; i < groups_.size(); ++i) {
            const DxfGroup& group = groups_[i];
            if (group.code == 0 && group.value == "SECTION") {
                finish();
                section = i + 1 < groups_.size() ? groups_[i + 1].value : std::string_view();
            } else if (group.code == 0 && group.value == "ENDSEC") {
                finish();
            } else if (section == "HEADER" && group.code == 9 && i + 1 < groups_.size()) {
                read_variable(group.value, groups_[i + 1]);
            } else if (section == "TABLES" || section == "BLOCKS" || section == "ENTITIES") {
                if (group.code == 0) entities.push_back({.type = group.value, .line = group.line, .groups = {}});
                if (group.code != 0 && !entities.empty()) entities.back().groups.push_back(group);
                if (entities.size() > kMostEntities) throw InputError(file_, "", "more than 2 million entities");
            }
        }
        if (!section.empty())
            throw InputError(file_, "line " + std::to_string(groups_.back().line),
                             "the file ends within its section " + std::string(section) + ": it was cut off");
    }

    void read_variable(std::string_view name, const DxfGroup& value) {
        if (name == "$ACADVER") version_ = value.value;
        if (name != "$INSUNITS") return;
        constexpr std::array<std::pair<int, double>, 10> units{{{1, 0.0254},
                                                                {2, 0.3048},
                                                                {4, 0.001},
                                                                {5, 0.01},
                                                                {6, 1},
                                                                {8, 2.54e-8},
                                                                {9, 2.54e-5},
                                                                {10, 0.9144},
                                                                {13, 1e-6},
                                                                {14, 0.1}}};
        for (const auto& [code, metres] : units) {
            if (dxf_number(value.value) == code) drawing_.metres_per_unit = metres;
        }
    }

    // Layers that are frozen, or off: their colour is negative.
    void read_layers(const std::vector<DxfEntity>& tables) {
        hidden_layers_.insert("defpoints");  // which AutoCAD never plots
        for (const DxfEntity& entity : tables) {
            if (entity.type != "LAYER") continue;
            const int flags = static_cast<int>(std::clamp(entity.number(70).value_or(0), 0.0, 1e6));
            const bool is_hidden = (flags & 1) != 0 || entity.number(62).value_or(1) < 0;
            if (is_hidden) hidden_layers_.insert(lower_case(dxf_string(entity.text(2).value_or(""))));
        }
    }

    void read_pieces() {
        DxfEntityReader reader(file_, hidden_layers_, drawing_.notes);
        std::optional<DxfPiece> block;
        for (std::size_t i = 0; i < block_entities_.size(); ++i) {
            const DxfEntity& entity = block_entities_[i];
            if (entity.type == "BLOCK") {
                block = DxfPiece{.name = dxf_string(entity.text(2).value_or("")), .line = entity.line};
                block->base = {entity.number(10).value_or(0), entity.number(20).value_or(0)};
            } else if (entity.type == "ENDBLK") {
                if (block) blocks_.push_back(std::move(*block));
                block.reset();
            } else if (block) {
                i += reader.read(block_entities_, i, *block);
            }
        }
        for (std::size_t i = 0; i < loose_entities_.size(); ++i) i += reader.read(loose_entities_, i, loose_);
        hidden_ = reader.hidden();
        for (const DxfLayerText& text : loose_.texts) read_file_text(text.text);
    }

    // ---- The unit.

    static double largest_side(const DxfPiece& piece) {
        Eigen::AlignedBox2d box;
        for (const DxfLine& line : piece.lines) box.extend(box_around(line.points));
        return box.isEmpty() ? 0 : box.sizes().maxCoeff();
    }

    // "METRIC" is mm by the standard. Some programs mean cm: pieces that would fit a doll tell.
    void settle_unit(const std::vector<DxfPiece>& pieces) {
        constexpr double kMillimetre = 0.001, kCentimetre = 0.01;  // m
        if (!is_metric_) return;
        double largest = 0;
        for (const DxfPiece& piece : pieces) largest = std::max(largest, largest_side(piece));
        const bool is_stated = drawing_.metres_per_unit == kCentimetre || drawing_.metres_per_unit == 1.0;
        if (!is_stated || largest * *drawing_.metres_per_unit > kLargestLargest) drawing_.metres_per_unit = kMillimetre;
        const bool is_small =
            largest > 0 && largest * kMillimetre < kSmallestLargest && largest * kCentimetre > 2 * kSmallestLargest;
        if (drawing_.metres_per_unit != kMillimetre || !is_small) return;
        drawing_.metres_per_unit = kCentimetre;
        drawing_.notes.emplace_back(
            "'Units: METRIC' is mm by the standard, in which no garment is so small: taken as cm; --unit sets another");
    }

    // What ends that meet may lie apart, file units.
    double gap_in(const DxfPiece& piece) const { return join_gap(drawing_.metres_per_unit, largest_side(piece)); }

    // ---- Sizes by the table beside the file.

    void add_graded(std::vector<DxfPiece>& pieces) {
        const std::vector<DxfPiece> drawn = pieces;
        constexpr std::size_t kMostGraded = 20000000;  // vertices
        std::size_t vertices = 0;
        for (const DxfPiece& piece : drawn) {
            for (const DxfLine& line : piece.lines) vertices += line.points.size();
        }
        if (vertices * rules_->sizes.size() > kMostGraded)
            throw InputError(file_, "", "more than 20 million vertices in all sizes of its grade table");
        std::size_t without = 0;
        for (std::size_t p = 0; p < drawn.size(); ++p) {
            std::vector<DxfPiece> sizes = graded_pieces(drawn[p], *rules_, unit());
            without += sizes.empty() ? 1 : 0;
            if (!sizes.empty()) set_size(pieces[p], rules_->sample_size);  // it may not say so
            std::ranges::move(sizes, std::back_inserter(pieces));
        }
        if (without == drawn.size()) {
            drawing_.notes.emplace_back(
                "no point has the number of a rule of its grade table: only what is drawn is read");
            return;
        }
        drawing_.sample_size = rules_->sample_size;
        if (without > 0)
            drawing_.notes.push_back(count_text(without, "piece") +
                                     " without numbers of grade rules: the same in all sizes");
    }

    // ---- Lines that belong to no piece.

    void add_loose_parts() {
        if (loose_.lines.empty()) return;
        DxfJoints joints;
        join_loose(loose_, gap_in(loose_), joints);
        add_plain(loose_, {}, joints);
    }

    // Lines without the layers of a pattern program, as a drawing whose shapes tell.
    void add_plain(const DxfPiece& piece, const std::string& name, const DxfJoints& joints) {
        PlainDrawing plain{.metres_per_unit = drawing_.metres_per_unit};
        std::map<std::string, int> layers;
        for (const DxfLine& line : piece.lines) {
            if (is_quality_layer(line.layer)) continue;
            PlainShape shape{.path = path_of(piece, line, plain_kind(line.layer), drawing_.metres_per_unit)};
            if (is_notch_layer(line.layer) && !line.is_closed) {
                plain.marks.push_back({.at = line.points.front(), .notch = notch_of_layer(line.layer)});
                continue;
            }
            const int number = layers.try_emplace(line.layer_name, static_cast<int>(layers.size()) + 1).first->second;
            constexpr int kFirstSize = 24;  // a layer below is one of the standard's
            const bool is_name = line.layer < 0 || line.layer >= kFirstSize;
            shape.groups.push_back(
                {.number = number, .label = is_name ? line.layer_name : std::string(), .is_layer = true});
            if (!name.empty()) shape.path.name = name;
            shape.style = line.style;
            plain.shapes.push_back(std::move(shape));
        }
        for (const auto& [layer, at] : piece.points) {
            if (layer == kDrillLayer) plain.marks.push_back({.kind = MarkKind::Drill, .at = at});
            if (is_notch_layer(layer)) plain.marks.push_back({.at = at, .notch = notch_of_layer(layer)});
        }
        for (const DxfLayerText& text : piece.texts) plain.texts.push_back({text.at, text.text});
        joints_.outlines += joints.outlines;
        joints_.widest_gap = std::max(joints_.widest_gap, joints.widest_gap);
        tell_joined();
        add_plain_parts(std::move(plain), file_, drawing_);
    }

    static LineKind plain_kind(int layer) {
        if (layer == kSewLayer) return LineKind::Sew;
        const LineKind kind = kind_of_layer(layer);
        return kind == LineKind::Help ? LineKind::Unknown : kind;
    }

    void tell_joined() {
        if (joints_.outlines == 0) return;
        drawing_.notes.push_back(joined_note(joints_.outlines, joints_.widest_gap, drawing_.metres_per_unit));
        joints_ = {};
    }

    // ---- A piece.

    double unit() const { return drawing_.metres_per_unit.value_or(0.001); }

    // The records of a piece, from mm to the file's unit.
    void take_unit(DxfRecords& records) const {
        transform(records.outline, Eigen::Affine2d(Eigen::Scaling(0.001 / unit())));
    }

    // The notches and lines that the records describe, instead of what is drawn of them.
    static void take_records(const DxfRecords& records, DrawnPart& part) {
        std::erase_if(part.marks, [](const DrawnMark& mark) { return mark.kind == MarkKind::Notch; });
        const Panel outline = as_panel(records.outline);
        for (const Notch& notch : records.notches) {
            if (notch.edge >= static_cast<int>(outline.edges.size())) continue;
            const OutlineEdge& edge = outline.edges[static_cast<std::size_t>(notch.edge)];
            part.marks.push_back(
                {MarkKind::Notch, outline_point(outline, edge, notch.t), notch.kind, notch.count, notch.edge});
        }
        std::size_t next = 0;
        for (DrawnPath& path : part.paths) {
            if (path.kind != LineKind::Internal || next >= records.lines.size()) continue;
            const InternalLine& line = records.lines[next++];
            path.name = line.name;
            path.line = line;
            if (line.use == LineUse::Fold) path.kind = LineKind::FoldLine;
        }
    }

    void add_part(DxfPiece piece, bool has_sewing_lines) {
        constexpr double kMoved = 1e-4;  // m: an outline that is drawn farther from its record was changed
        const DxfLine* sewn = find_sewing_line(piece);
        const DxfLine* boundary = largest_closed(piece, kBoundaryLayer);
        if (!sewn && !boundary) return add_without_boundary(piece);
        if (!boundary) note_open_boundary(piece);
        DrawnPart part{.name = piece.name};
        read_texts(piece, part);
        take_unit(piece.records);
        bool has_records = false;
        for (const DxfLine& line : piece.lines) {
            const LineKind kind = &line == sewn       ? LineKind::Sew
                                  : &line == boundary ? (sewn || has_sewing_lines ? LineKind::Cut : LineKind::Unknown)
                                                      : kind_of_layer(line.layer);
            const bool is_sewn = &line == (sewn ? sewn : boundary);
            if (is_sewn && is_outline_on(piece.records.outline, line.points, kMoved / unit())) {
                if (!sewn) part.paths.push_back(as_drawn(line, LineKind::Cut));  // without an allowance it is both
                part.paths.push_back(piece.records.outline);
                part.paths.back().kind = LineKind::Sew;
                part.paths.back().place = "line " + std::to_string(line.line);
                has_records = true;
            } else if (is_notch_layer(line.layer)) {
                add_notch(part, line.layer, line.points.front(), line.points.back(), sewn ? sewn : boundary);
            } else if (!is_quality_layer(line.layer)) {
                const bool is_ours = !piece.records.outline.edges.empty() && &line != sewn;
                part.paths.push_back(is_ours ? as_drawn(line, kind)
                                             : path_of(piece, line, kind, drawing_.metres_per_unit));
            }
        }
        const auto others = std::ranges::count_if(piece.lines, [&](const DxfLine& line) {
            return is_outline_layer(line.layer) && line.is_closed && &line != sewn && &line != boundary;
        });
        if (others > 0)
            drawing_.notes.push_back("line " + std::to_string(piece.line) + ": '" + piece.name + "' has " +
                                     count_text(static_cast<std::size_t>(others), "more closed outline") +
                                     ": only the largest is read");
        for (const auto& [layer, at] : piece.points) {
            if (is_notch_layer(layer)) add_notch(part, layer, at, at, sewn ? sewn : boundary);
            if (layer == kDrillLayer) part.marks.push_back({.kind = MarkKind::Drill, .at = at});
        }
        if (has_records) take_records(piece.records, part);
        if (has_records && !piece.records.is_placement_broken) part.placement = piece.records.placement;
        drawing_.parts.push_back(std::move(part));
        block_names_.push_back(piece.name);
    }

    // Of a piece whose sewing line is closed.
    void note_open_boundary(const DxfPiece& piece) {
        for (const DxfLine& line : piece.lines) {
            if (line.layer != kBoundaryLayer || line.points.size() < 4) continue;
            drawing_.notes.push_back("line " + std::to_string(line.line) + ": the outline of '" + piece.name + "' is " +
                                     open_by(gap_of(line), drawing_.metres_per_unit) +
                                     ": only its sewing line is taken");
            return;
        }
    }

    // Of a block without the standard's layers the shapes tell; of one with them, that its outline is open.
    void add_without_boundary(DxfPiece& piece) {
        const DxfLine* open = nullptr;
        for (const DxfLine& line : piece.lines) {
            if (is_outline_layer(line.layer) && (!open || gap_of(line) > gap_of(*open))) open = &line;
        }
        const std::string place = "line " + std::to_string(open ? open->line : piece.line);
        if (!open) {
            const std::size_t parts = drawing_.parts.size();
            DxfJoints joints;
            join_loose(piece, gap_in(piece), joints);
            DrawnPart texts;
            read_texts(piece, texts);
            const std::string name = texts.name.empty() ? piece.name : texts.name;
            if (may_enclose(piece)) add_plain(piece, name, joints);
            for (std::size_t p = parts; p < drawing_.parts.size(); ++p) drawing_.parts[p].size = texts.size;
            if (drawing_.parts.size() == parts)
                drawing_.notes.push_back(place + ": block '" + piece.name + "' has no closed boundary, left out");
            return;
        }
        const std::string problem =
            "the outline of '" + piece.name + "' is " + open_by(gap_of(*open), drawing_.metres_per_unit);
        if (!first_open_) first_open_ = InputError(file_, place, problem);
        drawing_.notes.push_back(place + ": " + problem + ", left out");
    }

    static bool may_enclose(const DxfPiece& piece) {
        return std::ranges::any_of(piece.lines, [](const DxfLine& line) { return line.is_closed; });
    }

    // The notch is where its line begins or ends on the outline.
    static void add_notch(DrawnPart& part, int layer, const Vec2d& a, const Vec2d& b, const DxfLine* outline) {
        DrawnMark mark{.kind = MarkKind::Notch, .at = a, .notch = notch_of_layer(layer)};
        if (outline && distance_to_polyline(b, outline->points) < distance_to_polyline(a, outline->points)) mark.at = b;
        part.marks.push_back(mark);
    }

    // ---- Texts: "Piece Name: FRONT", "Size: M", "Quantity: 2".

    static std::optional<std::string> value_after(const std::string& text, std::string_view key) {
        if (!lower_case(text).starts_with(key)) return std::nullopt;
        std::size_t at = key.size();
        while (at < text.size() && (text[at] == ' ' || text[at] == ':')) ++at;
        std::string value = text.substr(at, text.find('\n', at) - at);
        while (!value.empty() && value.back() == ' ') value.pop_back();
        return value;
    }

    static std::optional<std::string> size_in(const std::string& text) {
        if (const auto size = value_after(text, "size name")) return size;
        return value_after(text, "size");
    }

    void read_file_text(const std::string& text) {
        if (const auto style = value_after(text, "style name")) drawing_.title = *style;
        if (const auto units = value_after(text, "units")) {
            const std::string word = lower_case(*units);
            is_metric_ = word.starts_with("metric");
            if (word.starts_with("english") || word.starts_with("imperial")) drawing_.metres_per_unit = 0.0254;
        }
        if (const auto size = value_after(text, "sample size"); size && !size->empty()) drawing_.sample_size = *size;
        if (text.starts_with("SELVEDGE")) drawing_.is_upright = true;
        if (text.starts_with("SELVEDGE SEAM ")) seam_texts_.push_back(text);
        if (text.starts_with("SELVEDGE SEWING ")) sewing_texts_.push_back(text);
        if (text.starts_with("SELVEDGE SEAMED ")) property_texts_.push_back(text);
        constexpr std::string_view body = "SELVEDGE BODY ";
        if (text.starts_with(body)) body_text_ += text.substr(body.size());
    }

    void read_texts(DxfPiece& piece, DrawnPart& part) {
        for (const auto& [layer, at, text] : piece.texts) {
            if (read_dxf_record(text, piece.records)) continue;
            if (const auto name = value_after(text, "piece name"); name && !name->empty()) {
                part.name = *name;
            } else if (const auto size = size_in(text)) {
                part.size = *size;
            } else if (const auto category = value_after(text, "category")) {
                part.category = *category;
            } else {
                read_cut_text(text, part.cut);
            }
            part.texts.push_back({at, text});
        }
    }

    // ---- Seams of our own files, and names.

    void add_seams() {
        for (const std::string& text : seam_texts_) {
            std::optional<DrawnSeam> seam = read_dxf_seam(text);
            if (!seam) throw InputError(file_, "layer 15", "'" + text.substr(0, 80) + "' is no seam");
            drawing_.seams.push_back(std::move(*seam));
        }
        for (const std::string& text : property_texts_) {
            if (!read_dxf_seam_property(text, drawing_.seams))
                throw InputError(file_, "layer 15", "'" + text.substr(0, 80) + "' is no property of a seam");
        }
        add_sewings();
    }

    void add_sewings() {
        std::map<SeamSide, std::size_t> seams;
        for (std::size_t i = 0; i < drawing_.seams.size(); ++i) seams.emplace(drawing_.seams[i].first, i);
        std::map<std::string, std::string> names;  // by number
        std::set<std::string> taken;
        for (const std::string& text : sewing_texts_) {
            const std::optional<DxfSewing> sewing = read_dxf_sewing(text);
            const auto seam = sewing ? seams.find(sewing->side) : seams.end();
            if (seam == seams.end()) throw InputError(file_, "layer 15", "'" + text.substr(0, 80) + "' is no sewing");
            const auto [name, is_new] = names.try_emplace(sewing->number, sewing->name);
            if (is_new && (name->second.empty() || !taken.insert(name->second).second)) {
                name->second = "sewing " + sewing->number;
                taken.insert(name->second);
            }
            drawing_.seams[seam->second].sewing = name->second;
        }
    }

    // Where the file names none: pattern programs write how often a piece is cut only beside the sample size.
    void find_sample_size() {
        take_sizes_from_names();
        if (!drawing_.sample_size.empty()) return;
        std::set<std::string> with, without;
        for (const DrawnPart& part : drawing_.parts) {
            if (!part.size.empty()) (part.cut.pieces ? with : without).insert(part.size);
        }
        if (with.size() == 1 && !without.empty() && !without.contains(*with.begin()))
            drawing_.sample_size = *with.begin();
    }

    // Of blocks per size that say no size: "FRONT_S", "FRONT_M".
    void take_sizes_from_names() {
        std::vector<std::string> names;
        for (const DrawnPart& part : drawing_.parts) {
            if (!part.size.empty()) return;
            names.push_back(part.name);
        }
        const auto splits = split_sizes(names);
        for (std::size_t p = 0; p < splits.size(); ++p) {
            if (splits[p]) std::tie(drawing_.parts[p].name, drawing_.parts[p].size) = *splits[p];
        }
        // "Piece Name: FRONT" in the blocks FRONT_S and FRONT_M.
        if (block_names_.size() != drawing_.parts.size()) return;
        const auto of_blocks = split_sizes(block_names_);
        for (std::size_t p = 0; p < of_blocks.size(); ++p) {
            if (of_blocks[p] && drawing_.parts[p].size.empty()) drawing_.parts[p].size = of_blocks[p]->second;
        }
    }

    // Names that differ, so that reports can tell the pieces apart; one size has each name once.
    void name_again() {
        std::map<std::pair<std::string, std::string>, int> used;
        for (DrawnPart& part : drawing_.parts) {
            const int number = ++used[{part.name, part.size}];
            if (number > 1) part.name += "_" + std::to_string(number);
        }
    }

    const std::string& file_;
    const GradeRules* rules_;
    std::optional<std::string> decoded_;
    std::vector<DxfGroup> groups_;
    std::vector<DxfEntity> block_entities_, loose_entities_;
    std::set<std::string> hidden_layers_;
    int hidden_ = 0;  // entities
    std::vector<DxfPiece> blocks_;
    DxfPiece loose_;                        // what lies in no block
    DxfJoints joints_;                      // not told yet
    std::vector<std::string> block_names_;  // per part that is a block
    bool is_metric_ = false;                // the file says "METRIC"
    std::optional<InputError> first_open_;  // of the first block whose outline is open
    std::vector<std::string> seam_texts_, sewing_texts_;
    std::vector<std::string> property_texts_ = {};
    std::string body_text_;
    std::string_view version_;
    Drawing drawing_;
};

}  // namespace

Drawing read_dxf(std::string_view text, const std::string& file, const GradeRules* rules) {
    return DxfReader(text, file, rules).read();
}

}  // namespace selvedge::sim

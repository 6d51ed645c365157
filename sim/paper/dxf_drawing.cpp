#include "sim/paper/dxf_drawing.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "sim/core/error.h"
#include "sim/paper/cut_text.h"
#include "sim/paper/dxf_records.h"
#include "sim/paper/dxf_text.h"
#include "sim/paper/path_builder.h"
#include "sim/paper/placement_record.h"
#include "sim/paper/polyline_outline.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/segment_distance.h"

namespace selvedge::sim {
namespace {

constexpr std::size_t kMostEntities = 100000;
constexpr std::size_t kMostVertices = 2000000;
constexpr double kLargestNumber = 1e7;  // drawing units

std::string lower(std::string_view text) {
    std::string small(text);
    for (char& c : small) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return small;
}

// ---- Layers.

// The number of a layer; words that other programs use stand for it; -1: neither.
int layer_number(std::string_view name) {
    const std::string small = lower(name);
    std::string_view digits = small;
    for (const std::string_view prefix : {"layer_", "layer-", "layer"}) {
        if (digits.starts_with(prefix)) digits.remove_prefix(prefix.size());
    }
    int number = -1;
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error == std::errc() && stop == digits.data() + digits.size()) return number;
    constexpr std::array<std::pair<std::string_view, int>, 14> words{{{"cut", 1},
                                                                      {"boundary", 1},
                                                                      {"outline", 1},
                                                                      {"contour", 1},
                                                                      {"sew", 14},
                                                                      {"stitch", 14},
                                                                      {"seam", 14},
                                                                      {"notch", 4},
                                                                      {"grain", 7},
                                                                      {"mirror", 6},
                                                                      {"fold", 6},
                                                                      {"drill", 13},
                                                                      {"internal", 8},
                                                                      {"text", 15}}};
    for (const auto& [word, layer] : words) {
        if (small.find(word) != std::string::npos) return layer;
    }
    return -1;
}

bool is_notch_layer(int layer) {
    return layer == 4 || (layer >= 80 && layer <= 83);
}

NotchKind notch_of_layer(int layer) {
    return layer == 80   ? NotchKind::T
           : layer == 81 ? NotchKind::Castle
           : layer == 82 ? NotchKind::V
           : layer == 83 ? NotchKind::U
                         : NotchKind::Slit;
}

// ---- Entities as lines of points.

struct DxfLine {
    int layer = -1;
    std::vector<Vec2d> points;
    bool is_closed = false;
    int line = 0;  // in the file
};

struct DxfPiece {
    std::string name;
    int line = 0;
    std::vector<DxfLine> lines = {};
    std::vector<std::pair<int, Vec2d>> points = {};       // with their layers
    std::vector<std::pair<int, std::string>> texts = {};  // with their layers
    DxfRecords records = {};                              // of files of Selvedge
};

class EntityReader {
 public:
    EntityReader(const std::string& file, std::vector<std::string>& notes) : file_(file), notes_(notes) {}

    // Adds what an entity draws. POLYLINE takes its vertices from the entities that follow; returns how many it took.
    std::size_t read(const std::vector<DxfEntity>& all, std::size_t index, DxfPiece& piece) {
        const DxfEntity& entity = all[index];
        const int layer = layer_number(entity.text(8).value_or(""));
        if (entity.type == "POLYLINE") return read_polyline(all, index, layer, piece);
        if (entity.type == "LWPOLYLINE") return read_lwpolyline(entity, layer, piece), 0U;
        if (entity.type == "LINE")
            return add(piece, {layer, {point(entity, 10), point(entity, 11)}, false, entity.line}), 0U;
        if (entity.type == "POINT") return piece.points.emplace_back(layer, point(entity, 10)), 0U;
        if (entity.type == "TEXT" || entity.type == "MTEXT" || entity.type == "ATTRIB" || entity.type == "ATTDEF")
            return piece.texts.emplace_back(layer, dxf_string(entity.text(1).value_or(""))), 0U;
        if (entity.type == "ARC" || entity.type == "CIRCLE") return read_arc(entity, layer, piece), 0U;
        if (entity.type == "SPLINE") return read_spline(entity, layer, piece), 0U;
        if (entity.type != "INSERT" && entity.type != "SEQEND" && unknown_.emplace(std::string(entity.type), 0).second)
            notes_.push_back("line " + std::to_string(entity.line) + ": " + std::string(entity.type) + " left out");
        return 0;
    }

 private:
    [[noreturn]] void fail(const DxfEntity& entity, const std::string& problem) const {
        throw InputError(file_, "line " + std::to_string(entity.line), std::string(entity.type) + ": " + problem);
    }

    double coordinate(const DxfEntity& entity, std::string_view text) const {
        const auto value = dxf_number(text);
        if (!value || std::abs(*value) > kLargestNumber)
            fail(entity, "'" + std::string(text.substr(0, 40)) + "' is no coordinate");
        return *value;
    }

    Vec2d point(const DxfEntity& entity, int code) const {
        const auto x = entity.text(code), y = entity.text(code + 10);
        if (!x || !y) fail(entity, "a point is missing");
        return {coordinate(entity, *x), coordinate(entity, *y)};
    }

    void add(DxfPiece& piece, DxfLine line) {
        vertices_ += line.points.size();
        if (vertices_ > kMostVertices) throw InputError(file_, "", "more than 2 million vertices");
        if (line.points.size() >= 2) piece.lines.push_back(std::move(line));
    }

    // Points on the arc that a bulge (the tangent of a quarter of its angle) makes between two vertices.
    static void append_bulge(std::vector<Vec2d>& points, const Vec2d& to, double bulge) {
        const Vec2d from = points.back();
        const double angle = 4 * std::atan(bulge);
        const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(angle) / (5 * std::numbers::pi / 180))));
        const Vec2d half = (to - from) / 2;
        const double rise = std::tan(angle / 2);
        if (bulge != 0 && std::abs(rise) > 1e-9) {
            const Vec2d centre = from + half + Vec2d(-half.y(), half.x()) / rise;
            for (int i = 1; i < steps; ++i)
                points.emplace_back(centre + Eigen::Rotation2Dd(angle * i / steps) * (from - centre));
        }
        points.push_back(to);
    }

    static bool closes(const DxfEntity& entity) {
        return (static_cast<int>(std::clamp(entity.number(70).value_or(0), 0.0, 1e6)) & 1) != 0;
    }

    // Vertices with their bulges, as points; `is_closed` also where the last vertex repeats the first.
    DxfLine joined(const std::vector<std::pair<Vec2d, double>>& vertices, bool is_closed, int layer, int line) const {
        DxfLine out{.layer = layer, .points = {}, .is_closed = is_closed, .line = line};
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            if (i == 0) {
                out.points.push_back(vertices[0].first);
            } else {
                append_bulge(out.points, vertices[i].first, vertices[i - 1].second);
            }
        }
        if (vertices.size() < 3) return out;
        if (is_closed) append_bulge(out.points, vertices[0].first, vertices.back().second);
        out.is_closed = is_closed || out.points.front() == out.points.back();
        return out;
    }

    std::size_t read_polyline(const std::vector<DxfEntity>& all, std::size_t index, int layer, DxfPiece& piece) {
        std::vector<std::pair<Vec2d, double>> vertices;
        std::size_t taken = 0;
        for (std::size_t i = index + 1; i < all.size() && all[i].type == "VERTEX"; ++i) {
            vertices.emplace_back(point(all[i], 10), std::clamp(all[i].number(42).value_or(0), -1e3, 1e3));
            ++taken;
        }
        if (index + taken + 1 < all.size() && all[index + taken + 1].type == "SEQEND") ++taken;
        add(piece, joined(vertices, closes(all[index]), layer, all[index].line));
        return taken;
    }

    void read_lwpolyline(const DxfEntity& entity, int layer, DxfPiece& piece) {
        std::vector<std::pair<Vec2d, double>> vertices;
        for (const DxfGroup& group : entity.groups) {
            if (group.code == 10) vertices.emplace_back(Vec2d(coordinate(entity, group.value), 0), 0);
            if (vertices.empty()) continue;
            if (group.code == 20) vertices.back().first.y() = coordinate(entity, group.value);
            if (group.code == 42) vertices.back().second = std::clamp(dxf_number(group.value).value_or(0), -1e3, 1e3);
        }
        add(piece, joined(vertices, closes(entity), layer, entity.line));
    }

    void read_arc(const DxfEntity& entity, int layer, DxfPiece& piece) {
        const Vec2d centre = point(entity, 10);
        const double radius = entity.number(40).value_or(0);
        if (!(radius > 0) || radius > kLargestNumber) fail(entity, "the radius is wrong");
        const bool is_circle = entity.type == "CIRCLE";
        const double degree = std::numbers::pi / 180;
        const double from = is_circle ? 0 : std::fmod(entity.number(50).value_or(0), 360) * degree;
        double to = is_circle ? 2 * std::numbers::pi : std::fmod(entity.number(51).value_or(360), 360) * degree;
        if (to <= from) to += 2 * std::numbers::pi;
        const int steps = std::max(2, static_cast<int>(std::ceil((to - from) / (3 * degree))));
        DxfLine line{.layer = layer, .points = {}, .is_closed = is_circle, .line = entity.line};
        for (int i = 0; i <= steps; ++i) {
            const double angle = from + (to - from) * i / steps;
            line.points.emplace_back(centre + radius * Vec2d(std::cos(angle), std::sin(angle)));
        }
        if (is_circle) line.points.back() = line.points.front();
        add(piece, std::move(line));
    }

    // Points of a B-spline by de Boor's recursion. (de Boor 1972)
    static Vec2d spline_point(const std::vector<Vec2d>& control, const std::vector<double>& knots, std::size_t degree,
                              double t) {
        std::size_t span = degree;
        while (span + 1 < control.size() && knots[span + 1] <= t) ++span;
        std::vector<Vec2d> d(control.begin() + static_cast<std::ptrdiff_t>(span - degree),
                             control.begin() + static_cast<std::ptrdiff_t>(span) + 1);
        for (std::size_t r = 1; r <= degree; ++r) {
            for (std::size_t j = degree; j >= r; --j) {
                const double low = knots[span - degree + j], high = knots[span + 1 + j - r];
                const double s = high > low ? (t - low) / (high - low) : 0;
                d[j] = (1 - s) * d[j - 1] + s * d[j];
            }
        }
        return d[degree];
    }

    void read_spline(const DxfEntity& entity, int layer, DxfPiece& piece) {
        std::vector<Vec2d> control;
        std::vector<double> knots;
        for (const DxfGroup& group : entity.groups) {
            if (group.code == 10) control.emplace_back(coordinate(entity, group.value), 0);
            if (group.code == 20 && !control.empty()) control.back().y() = coordinate(entity, group.value);
            if (group.code == 40) knots.push_back(dxf_number(group.value).value_or(0));
        }
        const auto degree = static_cast<std::size_t>(std::clamp(entity.number(71).value_or(3), 1.0, 10.0));
        if (control.size() <= degree || knots.size() != control.size() + degree + 1 || !std::ranges::is_sorted(knots))
            fail(entity, "its knots do not fit its control points");
        DxfLine line{.layer = layer, .points = {}, .is_closed = false, .line = entity.line};
        const double from = knots[degree], to = knots[control.size()];
        const std::size_t steps = std::min<std::size_t>(16 * control.size(), 20000);
        for (std::size_t i = 0; i <= steps; ++i) {
            const double t = from + (to - from) * static_cast<double>(i) / static_cast<double>(steps);
            line.points.push_back(spline_point(control, knots, degree, t));
        }
        line.is_closed = closes(entity) || (line.points.front() - line.points.back()).norm() == 0;
        if (line.is_closed) line.points.push_back(line.points.front());
        add(piece, std::move(line));
    }

    const std::string& file_;
    std::vector<std::string>& notes_;
    std::map<std::string, int> unknown_;
    std::size_t vertices_ = 0;
};

// ---- The file.

class DxfReader {
 public:
    DxfReader(std::string_view text, const std::string& file) : file_(file), groups_(parse_dxf(text, file)) {}

    Drawing read() {
        drawing_.format = "DXF";
        drawing_.is_upright = false;
        read_sections();
        if (pieces_.empty()) split_loose();
        bool has_sewing_lines = false;
        for (const DxfPiece& piece : pieces_) has_sewing_lines |= find_sewing_line(piece) != nullptr;
        for (const DxfPiece& piece : pieces_) add_part(piece, has_sewing_lines);
        add_seams();
        drawing_.body = read_body_phrase(body_text_);
        name_again();
        if (drawing_.parts.empty()) refuse_open();
        return std::move(drawing_);
    }

 private:
    // Where no line is closed: names the largest of those that were meant to be.
    [[noreturn]] void refuse_open() const {
        const DxfLine* found = nullptr;
        for (const DxfLine& line : loose_.lines) {
            if (!line.is_closed && line.points.size() > 2 && (!found || extent(line) > extent(*found))) found = &line;
        }
        if (!found) throw InputError(file_, "", "no closed line: nothing that could be a panel");
        throw InputError(file_, "line " + std::to_string(found->line),
                         open_by(gap_of(*found), drawing_.metres_per_unit) +
                             ", and no other line is closed: nothing that could be a panel");
    }

    static double gap_of(const DxfLine& line) { return (line.points.front() - line.points.back()).norm(); }

    void read_sections() {
        std::string_view section;
        std::vector<DxfEntity> entities;
        for (std::size_t i = 0; i < groups_.size(); ++i) {
            const DxfGroup& group = groups_[i];
            if (group.code == 0 && group.value == "SECTION") {
                section = i + 1 < groups_.size() ? groups_[i + 1].value : std::string_view();
                entities.clear();
            } else if (group.code == 0 && group.value == "ENDSEC") {
                if (section == "BLOCKS") read_blocks(entities);
                if (section == "ENTITIES") read_entities(entities);
                section = {};
            } else if (section == "HEADER" && group.code == 9 && i + 1 < groups_.size()) {
                read_variable(group.value, groups_[i + 1]);
            } else if (section == "BLOCKS" || section == "ENTITIES") {
                if (group.code == 0) entities.push_back({.type = group.value, .line = group.line, .groups = {}});
                if (group.code != 0 && !entities.empty()) entities.back().groups.push_back(group);
                if (entities.size() > kMostEntities * 20) throw InputError(file_, "", "more than 2 million entities");
            }
        }
        // A file that was cut off still has its last section.
        if (section == "BLOCKS") read_blocks(entities);
        if (section == "ENTITIES") read_entities(entities);
    }

    void read_variable(std::string_view name, const DxfGroup& value) {
        if (name == "$ACADVER") version_ = value.value;
        if (name != "$INSUNITS") return;
        constexpr std::array<std::pair<int, double>, 5> units{
            {{1, 0.0254}, {2, 0.3048}, {4, 0.001}, {5, 0.01}, {6, 1}}};
        for (const auto& [code, metres] : units) {
            if (dxf_number(value.value) == code) drawing_.metres_per_unit = metres;
        }
    }

    void read_blocks(const std::vector<DxfEntity>& entities) {
        EntityReader reader(file_, drawing_.notes);
        std::optional<DxfPiece> piece;
        for (std::size_t i = 0; i < entities.size(); ++i) {
            const DxfEntity& entity = entities[i];
            if (entity.type == "BLOCK") {
                piece = DxfPiece{.name = dxf_string(entity.text(2).value_or("")), .line = entity.line};
            } else if (entity.type == "ENDBLK") {
                const bool is_layout = piece && (piece->name.starts_with('*') || piece->name.starts_with('$'));
                if (piece && !is_layout && !piece->lines.empty()) pieces_.push_back(std::move(*piece));
                piece.reset();
            } else if (piece) {
                i += reader.read(entities, i, *piece);
            }
        }
    }

    void read_entities(const std::vector<DxfEntity>& entities) {
        EntityReader reader(file_, drawing_.notes);
        for (std::size_t i = 0; i < entities.size(); ++i) i += reader.read(entities, i, loose_);
        for (const auto& [layer, text] : loose_.texts) read_file_text(text);
    }

    // Files without blocks: each closed line that lies in no other is a piece, with what lies in it.
    void split_loose() {
        std::vector<Eigen::AlignedBox2d> boxes;
        for (DxfLine& line : loose_.lines) {
            close(line);
            Eigen::AlignedBox2d box;
            for (const Vec2d& p : line.points) box.extend(p);
            boxes.push_back(box);
        }
        constexpr std::size_t kMost = 5000;
        if (loose_.lines.size() > kMost) throw InputError(file_, "ENTITIES", "more than 5,000 lines, and no blocks");
        std::vector<std::size_t> outer;
        for (std::size_t i = 0; i < loose_.lines.size(); ++i) {
            if (!loose_.lines[i].is_closed) continue;
            const bool is_inside = std::ranges::any_of(loose_.lines, [&](const DxfLine& other) {
                const auto k = static_cast<std::size_t>(&other - loose_.lines.data());
                return k != i && other.is_closed && boxes[k].contains(boxes[i]) &&
                       (boxes[k].sizes().prod() > boxes[i].sizes().prod() || k < i);
            });
            if (!is_inside) outer.push_back(i);
        }
        for (const std::size_t o : outer) {
            DxfPiece piece{.name = "piece_" + std::to_string(pieces_.size() + 1), .line = loose_.lines[o].line};
            piece.lines.push_back(loose_.lines[o]);
            piece.lines.back().layer = 1;
            for (std::size_t i = 0; i < loose_.lines.size(); ++i) {
                if (i != o && boxes[o].contains(boxes[i].center())) piece.lines.push_back(loose_.lines[i]);
            }
            for (const auto& point : loose_.points) {
                if (boxes[o].contains(point.second)) piece.points.push_back(point);
            }
            pieces_.push_back(std::move(piece));
        }
        note_open_outlines(outer, boxes);
    }

    // Of loose lines that lie in no piece, and whose ends nearly meet.
    void note_open_outlines(const std::vector<std::size_t>& outer, const std::vector<Eigen::AlignedBox2d>& boxes) {
        constexpr double kNearly = 0.1;  // of the line's size
        for (std::size_t i = 0; i < loose_.lines.size(); ++i) {
            const DxfLine& line = loose_.lines[i];
            if (line.is_closed || line.points.size() < 4 || gap_of(line) > kNearly * extent(line)) continue;
            if (std::ranges::any_of(outer, [&](std::size_t o) { return boxes[o].contains(boxes[i].center()); }))
                continue;
            drawing_.notes.push_back("line " + std::to_string(line.line) + ": " +
                                     open_by(gap_of(line), drawing_.metres_per_unit) + ", left out");
        }
    }

    // ---- A piece.

    static double extent(const DxfLine& line) {
        Eigen::AlignedBox2d box;
        for (const Vec2d& p : line.points) box.extend(p);
        return box.isEmpty() ? 0 : box.sizes().norm();
    }

    static const DxfLine* largest(const DxfPiece& piece, int layer) {
        const DxfLine* found = nullptr;
        for (const DxfLine& line : piece.lines) {
            if (line.layer != layer || !line.is_closed || line.points.size() < 4) continue;
            if (!found || extent(line) > extent(*found)) found = &line;
        }
        return found;
    }

    // Layer 14, or a closed line on layer 8 that is nearly as large as the boundary.
    static const DxfLine* find_sewing_line(const DxfPiece& piece) {
        if (const DxfLine* sewn = largest(piece, 14)) return sewn;
        const DxfLine* boundary = largest(piece, 1);
        const DxfLine* inner = largest(piece, 8);
        constexpr double kNearly = 0.7;
        return boundary && inner && extent(*inner) > kNearly * extent(*boundary) ? inner : nullptr;
    }

    // Ends that nearly meet are one; returns false if the line stays open.
    bool close(DxfLine& line) {
        if (line.is_closed) return true;
        const double gap = gap_of(line);
        constexpr double kGap = 0.2e-3;  // m
        if (line.points.size() < 4 || gap * unit() > kGap) return false;
        line.points.back() = line.points.front();
        line.is_closed = true;
        if (gap > 0)
            drawing_.notes.push_back("line " + std::to_string(line.line) +
                                     ": open by a fifth of a millimetre or less, closed");
        return true;
    }

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
        for (DxfLine& line : piece.lines) {
            const bool is_outline = line.layer == 1 || line.layer == 14;
            if (!close(line) && is_outline && line.points.size() > 3) {
                throw InputError(
                    file_, "line " + std::to_string(line.line),
                    "the outline of '" + piece.name + "' is " + open_by(gap_of(line), drawing_.metres_per_unit));
            }
        }
        DrawnPart part{.name = piece.name};
        read_texts(piece, part);
        take_unit(piece.records);
        bool has_records = false;
        const DxfLine* sewn = find_sewing_line(piece);
        const DxfLine* boundary = largest(piece, 1);
        for (const DxfLine& line : piece.lines) {
            const LineKind kind = &line == sewn       ? LineKind::Sew
                                  : &line == boundary ? (sewn || has_sewing_lines ? LineKind::Cut : LineKind::Unknown)
                                                      : kind_of_layer(line.layer);
            if (&line == sewn && is_outline_on(piece.records.outline, line.points, kMoved / unit())) {
                part.paths.push_back(piece.records.outline);
                part.paths.back().kind = LineKind::Sew;
                part.paths.back().place = "line " + std::to_string(line.line);
                has_records = true;
            } else if (is_notch_layer(line.layer)) {
                add_notch(part, line.layer, line.points.front(), line.points.back(), sewn ? sewn : boundary);
            } else if (line.layer < 84 || line.layer > 87) {
                const bool is_ours = !piece.records.outline.edges.empty() && &line != sewn;
                part.paths.push_back(is_ours ? as_drawn(line, kind) : path_of(piece, line, kind));
            }
        }
        for (const auto& [layer, at] : piece.points) {
            if (is_notch_layer(layer)) add_notch(part, layer, at, at, sewn ? sewn : boundary);
            if (layer == 13) part.marks.push_back({.kind = MarkKind::Drill, .at = at});
        }
        if (has_records) take_records(piece.records, part);
        if (has_records && !piece.records.is_placement_broken) part.placement = piece.records.placement;
        if (boundary || sewn) {
            drawing_.parts.push_back(std::move(part));
        } else {
            drawing_.notes.push_back("line " + std::to_string(piece.line) + ": block '" + piece.name +
                                     "' has no closed boundary, left out");
        }
    }

    static LineKind kind_of_layer(int layer) {
        if (layer == 6) return LineKind::FoldEdge;
        if (layer == 7) return LineKind::Grain;
        if (layer == 8) return LineKind::Internal;
        if (layer == 11) return LineKind::Cutout;
        return LineKind::Help;
    }

    // The notch is where its line begins or ends on the outline.
    static void add_notch(DrawnPart& part, int layer, const Vec2d& a, const Vec2d& b, const DxfLine* outline) {
        DrawnMark mark{.kind = MarkKind::Notch, .at = a, .notch = notch_of_layer(layer)};
        if (outline && distance(b, *outline) < distance(a, *outline)) mark.at = b;
        part.marks.push_back(mark);
    }

    static double distance(const Vec2d& p, const DxfLine& line) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
            least = std::min(least, distance_to_segment(p, line.points[i], line.points[i + 1]));
        return least;
    }

    // Files of Selvedge have the curves of outlines as records. Their other lines are polylines, and stay so.
    static DrawnPath as_drawn(const DxfLine& line, LineKind kind) {
        DrawnPath path;
        path.kind = kind;
        path.is_closed = line.is_closed;
        path.place = "line " + std::to_string(line.line);
        for (const Vec2d& p : line.points) {
            if (path.vertices.empty() || p != path.vertices.back()) path.vertices.push_back(p);
        }
        if (line.is_closed && path.vertices.size() > 1 && path.vertices.front() == path.vertices.back())
            path.vertices.pop_back();
        const int count = static_cast<int>(path.vertices.size());
        for (int i = 0; i + (line.is_closed ? 0 : 1) < count; ++i)
            path.edges.push_back({.start = i, .end = line.is_closed ? (i + 1) % count : i + 1});
        return path;
    }

    // Corners are the turn points of layer 2, if the piece has them.
    DrawnPath path_of(const DxfPiece& piece, const DxfLine& line, LineKind kind) const {
        constexpr double kTolerance = 1e-4;  // m
        constexpr double kOnLine = 1e-4;     // of the line's size
        PolylineOptions options{.tolerance = kTolerance / unit()};
        std::vector<Vec2d> points = line.points;
        if (line.is_closed && points.front() == points.back()) points.pop_back();
        const bool is_outline = kind == LineKind::Sew || kind == LineKind::Cut || kind == LineKind::Unknown;
        const double reach = kOnLine * extent(line);
        for (const std::pair<int, Vec2d>& point : piece.points) {
            const Vec2d& at = point.second;
            if (point.first != 2 || !is_outline) continue;
            const auto nearest = std::ranges::min_element(points, {}, [&](const Vec2d& p) { return (p - at).norm(); });
            if ((*nearest - at).norm() < reach) options.corners.push_back(static_cast<int>(nearest - points.begin()));
        }
        DrawnPath path = outline_of_points(points, line.is_closed, options);
        path.kind = kind;
        path.place = "line " + std::to_string(line.line);
        return path;
    }

    // ---- Texts: "Piece Name: FRONT", "Size: M", "Quantity: 2".

    static std::optional<std::string> value_after(const std::string& text, std::string_view key) {
        if (!lower(text).starts_with(key)) return std::nullopt;
        std::size_t at = key.size();
        while (at < text.size() && (text[at] == ' ' || text[at] == ':')) ++at;
        std::string value = text.substr(at);
        while (!value.empty() && value.back() == ' ') value.pop_back();
        return value;
    }

    void read_file_text(const std::string& text) {
        if (const auto style = value_after(text, "style name")) drawing_.title = *style;
        if (const auto units = value_after(text, "units")) {
            const std::string word = lower(*units);
            if (word.starts_with("metric")) drawing_.metres_per_unit = 0.001;
            if (word.starts_with("english") || word.starts_with("imperial")) drawing_.metres_per_unit = 0.0254;
        }
        if (text.starts_with("SELVEDGE")) drawing_.is_upright = true;
        if (text.starts_with("SELVEDGE SEAM ")) seam_texts_.push_back(text);
        if (text.starts_with("SELVEDGE SEWING ")) sewing_texts_.push_back(text);
        if (text.starts_with("SELVEDGE SEAMED ")) property_texts_.push_back(text);
        constexpr std::string_view body = "SELVEDGE BODY ";
        if (text.starts_with(body)) body_text_ += text.substr(body.size());
    }

    void read_texts(DxfPiece& piece, DrawnPart& part) {
        for (const auto& [layer, text] : piece.texts) {
            if (read_dxf_record(text, piece.records)) continue;
            read_file_text(text);
            if (const auto name = value_after(text, "piece name"); name && !name->empty()) {
                part.name = *name;
            } else if (const auto size = value_after(text, "size")) {
                part.size = *size;
            } else {
                read_cut_text(text, part.cut);
            }
            part.texts.push_back({Vec2d::Zero(), text});
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

    // Names that differ, so that reports can tell the pieces apart; one size has each name once.
    void name_again() {
        std::map<std::pair<std::string, std::string>, int> used;
        for (DrawnPart& part : drawing_.parts) {
            const int number = ++used[{part.name, part.size}];
            if (number > 1) part.name += "_" + std::to_string(number);
        }
        if (!version_.empty()) drawing_.format += " (" + std::string(version_) + ")";
    }

    const std::string& file_;
    std::vector<DxfGroup> groups_;
    std::vector<DxfPiece> pieces_;
    DxfPiece loose_;
    std::vector<std::string> seam_texts_, sewing_texts_;
    std::vector<std::string> property_texts_ = {};
    std::string body_text_;
    std::string_view version_;
    Drawing drawing_;
};

}  // namespace

Drawing read_dxf(std::string_view text, const std::string& file) {
    return DxfReader(text, file).read();
}

}  // namespace selvedge::sim

#include "sim/print/svg_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sim/paper/decimal_text.h"
#include "sim/paper/field_record.h"
#include "sim/paper/placement_record.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/enum_names.h"
#include "sim/pattern/fabric_file.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

// For text and attributes of XML 1.0; characters that it forbids are left out.
std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            case '\n':
                out += "&#10;";
                break;
            case '\t':
                out += "&#9;";
                break;
            default:
                if (static_cast<unsigned char>(c) >= 0x20) out += c;
        }
    }
    return out;
}

std::string attribute(std::string_view name, std::string_view value) {
    return " " + std::string(name) + "=\"" + escaped(value) + "\"";
}

struct LayerLook {
    PaperLayer layer;
    const char* label;
    const char* line;  // data-selvedge-line; empty: none
    const char* style;
};
constexpr std::array kLooks = std::to_array<LayerLook>({
    {PaperLayer::Cut, "cut line", "cut", "stroke-width:0.4"},
    {PaperLayer::Sew, "sewing line", "sew", "stroke-width:0.25;stroke-dasharray:4 2"},
    {PaperLayer::Fold, "fold", "fold-line", "stroke-width:0.3;stroke-dasharray:8 2 1 2"},
    {PaperLayer::Grain, "grain line", "grain", "stroke-width:0.3"},
    {PaperLayer::Notches, "notches", "", "stroke-width:0.35"},
    {PaperLayer::Drill, "drill points", "", "stroke-width:0.25"},
    {PaperLayer::Internal, "internal lines", "internal", "stroke-width:0.25;stroke-dasharray:1.5 1.5"},
    {PaperLayer::Labels, "labels", "", "stroke:none;fill:black"},
});

// The panels on the sheet are all of the pattern's, in its order.
bool shows_all_panels(const Pattern& pattern, const PaperSheet& sheet) {
    if (sheet.pieces.size() != pattern.panels.size()) return false;
    for (std::size_t i = 0; i < sheet.pieces.size(); ++i) {
        if (sheet.pieces[i].panel != static_cast<int>(i)) return false;
    }
    return true;
}

class SvgWriter {
 public:
    SvgWriter(const Pattern& pattern, const PaperSheet& sheet, const LayerChoice& layers)
        : pattern_(pattern), sheet_(sheet), layers_(layers), is_whole_(shows_all_panels(pattern, sheet)) {}

    std::string write() {
        const Vec2d size = 1000 * sheet_.size + Vec2d::Constant(2 * kBorder);
        out_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"" +
               attribute("xmlns:inkscape", "http://www.inkscape.org/namespaces/inkscape") +
               attribute("width", decimal_text(size.x()) + "mm") + attribute("height", decimal_text(size.y()) + "mm") +
               attribute("viewBox", "0 0 " + decimal_text(size.x()) + " " + decimal_text(size.y())) + ">\n";
        const std::string title = sheet_.title.empty() ? pattern_.name : sheet_.title;
        out_ += "<title>" + escaped(title) + "</title>\n";
        write_metadata();
        if (!sheet_.fabric.empty() || sheet_.repeat) write_fabric();
        for (std::size_t i = 0; i < sheet_.pieces.size(); ++i) write_piece(i);
        out_ += "</svg>\n";
        return std::move(out_);
    }

 private:
    static constexpr double kBorder = 10;  // mm

    Vec2d to_page(const Vec2d& p) const { return {1000 * p.x() + kBorder, 1000 * (sheet_.size.y() - p.y()) + kBorder}; }

    std::string point(const Vec2d& on_sheet) const {
        const Vec2d p = to_page(on_sheet);
        return decimal_text(p.x()) + "," + decimal_text(p.y());
    }

    bool has(PaperLayer layer) const { return layers_[static_cast<std::size_t>(layer)]; }

    // What is not drawn: seams and the body, if all panels are there.
    void write_metadata() {
        if (!is_whole_ || (pattern_.seams.empty() && !has_portable_placement(pattern_))) return;
        out_ += "<metadata><selvedge:seams xmlns:selvedge=\"urn:selvedge:pattern\"";
        if (has_portable_placement(pattern_)) out_ += attribute("body", body_phrase(pattern_));
        out_ += ">\n";
        const auto side = [&](const SeamSide& s) { return panel_of(pattern_, s).name + ":" + std::to_string(s.edge); };
        for (const Seam& seam : pattern_.seams) {
            out_ += "<selvedge:seam" + attribute("first", side(seam.first)) + attribute("second", side(seam.second)) +
                    attribute("reversed", seam.is_reversed ? "true" : "false");
            if (seam.is_eased) out_ += attribute("eased", "true");
            if (!seam.name.empty()) out_ += attribute("name", seam.name);
            if (!seam.sewing.empty()) out_ += attribute("sewing", seam.sewing);
            out_ += optional_attribute("properties", record_of_fields(seam)) + "/>\n";
        }
        out_ += "</selvedge:seams></metadata>\n";
    }

    void write_fabric() {
        out_ += "<g" + attribute("inkscape:groupmode", "layer") + attribute("inkscape:label", "fabric") +
                attribute("style", "fill:none;stroke:#999;stroke-width:0.4") + ">\n";
        const auto line = [&](const Vec2d& a, const Vec2d& b) {
            out_ += "<path d=\"M " + point(a) + " L " + point(b) + "\"/>\n";
        };
        const Vec2d size = sheet_.size;
        out_ += "<rect" + attribute("x", decimal_text(kBorder)) + attribute("y", decimal_text(kBorder)) +
                attribute("width", decimal_text(1000 * size.x())) + attribute("height", decimal_text(1000 * size.y())) +
                "/>\n";
        if (sheet_.repeat) {
            for (double x = sheet_.repeat->x(); x < size.x(); x += sheet_.repeat->x()) line({x, 0}, {x, size.y()});
            for (double y = sheet_.repeat->y(); y < size.y(); y += sheet_.repeat->y()) line({0, y}, {size.x(), y});
        }
        out_ += "</g>\n";
    }

    void write_piece(std::size_t index) {
        const PaperPiece& piece = sheet_.pieces[index];
        const NestPlace& place = sheet_.places[index];
        const Panel& own = pattern_.panels[static_cast<std::size_t>(piece.panel)];
        Eigen::Affine2d map = Eigen::Affine2d::Identity();
        map.translate(place.shift).rotate(place.turn);
        const Panel panel = mapped_panel(own, map);
        out_ += "<g" + attribute("id", "panel-" + std::to_string(index)) + attribute("inkscape:groupmode", "layer") +
                attribute("inkscape:label", own.name) + attribute("data-selvedge-panel", own.name) +
                attribute("data-selvedge-pieces", std::to_string(own.pieces));
        if (!pattern_.size.empty()) out_ += attribute("data-selvedge-size", pattern_.size);
        if (is_whole_ && has_portable_placement(pattern_)) {
            std::string phrases;
            for (const std::string& phrase : placement_phrases(own)) phrases += (phrases.empty() ? "" : "; ") + phrase;
            out_ += attribute("data-selvedge-placement", phrases);
        }
        const std::string& fabric = own.fabric.empty() ? pattern_.fabric : own.fabric;
        if (is_shipped_fabric(fabric)) out_ += attribute("data-selvedge-fabric", fabric);
        out_ += attribute("style", "fill:none;stroke:black;stroke-linejoin:round;stroke-linecap:round") + ">\n";
        for (const LayerLook& look : kLooks) {
            if (has(look.layer)) write_layer(look, piece, place, panel);
        }
        out_ += "</g>\n";
    }

    void write_layer(const LayerLook& look, const PaperPiece& piece, const NestPlace& place, const Panel& panel) {
        std::string lines;
        if (look.layer == PaperLayer::Cut) {
            if (piece.has_allowance) lines = path(placed(piece.cut, place), true, "cut", "");
        } else if (look.layer == PaperLayer::Sew) {
            lines = "<path" + attribute("data-selvedge-line", "sew") +
                    optional_attribute("data-selvedge-edges", edge_records(panel)) + attribute("d", curve_of(panel)) +
                    "/>\n";
        } else if (look.layer == PaperLayer::Notches) {
            lines = notches(piece, place, panel);
        } else if (look.layer == PaperLayer::Drill) {
            lines = drill_points(piece, place);
        } else if (look.layer == PaperLayer::Labels) {
            lines = label(piece, place);
        } else {
            lines = lines_of(look, piece, place, panel);
        }
        if (lines.empty()) return;
        out_ += "<g" + attribute("inkscape:groupmode", "layer") + attribute("inkscape:label", look.label) +
                attribute("style", look.style) + ">\n" + lines + "</g>\n";
    }

    static std::vector<Vec2d> placed(std::vector<Vec2d> points, const NestPlace& place) {
        for (Vec2d& p : points) p = place.at(p);
        return points;
    }

    std::string path(const std::vector<Vec2d>& points, bool is_closed, const std::string& line, const std::string& name,
                     const std::string& properties = "") const {
        std::string d = "M";
        for (const Vec2d& p : points) d += " " + point(p);
        if (is_closed) d += " Z";
        return "<path" + (line.empty() ? "" : attribute("data-selvedge-line", line)) + optional_attribute("id", name) +
               optional_attribute("data-selvedge-properties", properties) + attribute("d", d) + "/>\n";
    }

    static std::string optional_attribute(const char* name, const std::string& value) {
        return value.empty() ? "" : attribute(name, value);
    }

    // "3 PHRASE; 4 PHRASE"
    static std::string edge_records(const Panel& panel) {
        std::string records;
        for (std::size_t e = 0; e < panel.edges.size(); ++e) {
            const std::string record = record_of_fields(panel.edges[e], std::to_string(e) + " ");
            records += (records.empty() || record.empty() ? "" : "; ") + record;
        }
        return records;
    }

    // Edge by edge, from edge 0 on.
    std::string curve_of(const Panel& panel) const {
        const auto vertex = [&](int v) { return point(panel.vertices[static_cast<std::size_t>(v)]); };
        std::string d = "M " + vertex(panel.edges.front().start);
        for (const OutlineEdge& edge : panel.edges) {
            switch (edge.kind) {
                case CurveKind::Line:
                    d += " L ";
                    break;
                case CurveKind::Quadratic:
                    d += " Q " + point(edge.control[0]) + " ";
                    break;
                case CurveKind::Cubic:
                    d += " C " + point(edge.control[0]) + " " + point(edge.control[1]) + " ";
                    break;
                case CurveKind::Arc: {
                    const std::string radius = decimal_text(1000 * edge.arc_radius);
                    // With y down, what turns right on paper is the positive direction of SVG.
                    d += " A " + radius + " " + radius + " 0 " + (edge.is_large_arc ? "1 " : "0 ") +
                         (edge.turns_right ? "1 " : "0 ");
                    break;
                }
            }
            d += vertex(edge.end);
        }
        return d + " Z";
    }

    // Folds, grain and internal lines; the grain's arrow heads are lines of their own.
    std::string lines_of(const LayerLook& look, const PaperPiece& piece, const NestPlace& place,
                         const Panel& panel) const {
        std::string lines;
        if (look.layer == PaperLayer::Grain) {
            bool is_shaft = true;
            for (const PaperStroke& stroke : strokes_of(piece)) {
                if (stroke.layer != look.layer) continue;
                lines += path(placed(stroke.points, place), false, is_shaft ? look.line : "", "");
                is_shaft = false;
            }
            return lines;
        }
        const LineUse use = look.layer == PaperLayer::Fold ? LineUse::Fold : LineUse::Mark;
        for (const InternalLine& line : panel.internal_lines) {
            if (line.use != use || line.points.size() < 2) continue;
            lines += path(line.points, false, look.line, line.name, record_of_fields(line));
        }
        for (const PaperLine& line : piece.lines) {
            if (line.is_dart_fold && line.layer == look.layer) lines += path(placed(line.points, place), false, "", "");
        }
        return lines;
    }

    std::string notches(const PaperPiece& piece, const NestPlace& place, const Panel& panel) const {
        std::string lines;
        for (std::size_t i = 0; i < piece.notches.size(); ++i) {
            const NotchLine& notch = piece.notches[i];
            const std::string d = sign_of(notch, place);
            const OutlineEdge& edge = panel.edges[static_cast<std::size_t>(panel.notches[i].edge)];
            lines += "<path" + attribute("data-selvedge-mark", "notch") +
                     attribute("data-selvedge-kind", name_of_value(notch.kind)) +
                     attribute("data-selvedge-count", std::to_string(notch.count)) +
                     attribute("data-selvedge-edge", std::to_string(panel.notches[i].edge)) +
                     attribute("data-selvedge-fraction", decimal_text(panel.notches[i].t)) +
                     attribute("data-selvedge-at", point(outline_point(panel, edge, panel.notches[i].t))) +
                     attribute("d", d) + "/>\n";
        }
        for (const NotchLine& notch : piece.leg_notches)
            lines += "<path" + attribute("d", sign_of(notch, place)) + "/>\n";
        return lines;
    }

    std::string sign_of(const NotchLine& notch, const NestPlace& place) const {
        PaperPiece single;
        single.notches = {notch};
        LayerChoice only{};
        only[static_cast<std::size_t>(PaperLayer::Notches)] = true;
        std::string d;
        for (const PaperStroke& stroke : strokes_of(single, only)) {
            d += d.empty() ? "M" : " M";
            for (const Vec2d& p : placed(stroke.points, place)) d += " " + point(p);
        }
        return d;
    }

    std::string drill_points(const PaperPiece& piece, const NestPlace& place) const {
        std::string lines;
        for (const Vec2d& at : piece.drill_points) {
            const Vec2d p = to_page(place.at(at));
            lines += "<circle" + attribute("data-selvedge-mark", "drill") +
                     attribute("data-selvedge-at", decimal_text(p.x()) + "," + decimal_text(p.y())) +
                     attribute("cx", decimal_text(p.x())) + attribute("cy", decimal_text(p.y())) + attribute("r", "3") +
                     "/>\n";
        }
        return lines;
    }

    std::string label(const PaperPiece& piece, const NestPlace& place) const {
        std::string lines;
        const Vec2d middle = to_page(place.at(piece.label.at));
        const double height = 1000 * piece.label.height;
        const double angle_deg = piece.label.angle(place.turn) * 180 / std::numbers::pi;
        const std::string turn =
            std::abs(angle_deg) < 1e-6
                ? ""
                : attribute("transform", "rotate(" + decimal_text(-angle_deg) + " " + decimal_text(middle.x()) + " " +
                                             decimal_text(middle.y()) + ")");
        double y = middle.y() - height * (static_cast<double>(piece.label.lines.size()) / 2 - 0.8);
        for (const std::string& line : piece.label.lines) {
            lines += "<text" + attribute("x", decimal_text(middle.x())) + attribute("y", decimal_text(y)) + turn +
                     attribute("style", "font-family:Inter,sans-serif;text-anchor:middle;font-size:" +
                                            decimal_text(0.8 * height) + "px") +
                     ">" + escaped(line) + "</text>\n";
            y += height;
        }
        return lines;
    }

    const Pattern& pattern_;
    const PaperSheet& sheet_;
    const LayerChoice& layers_;
    bool is_whole_;
    std::string out_;
};

}  // namespace

std::string svg_of(const Pattern& pattern, const PaperSheet& sheet, const LayerChoice& layers) {
    return SvgWriter(pattern, sheet, layers).write();
}

}  // namespace selvedge::sim

#include "sim/pattern/pattern_read.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "sim/pattern/fabric.h"
#include "sim/pattern/fault_reader.h"
#include "sim/pattern/outline.h"

namespace selvedge {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kFarthest = 100;        // m: no garment reaches further, and squares of it stay exact enough
constexpr std::size_t kMaxEdges = 5000;  // of one panel

using Node = JsonNode;

class Reader : FaultReader {
 public:
    Reader(const Json& root, const std::string& file) : FaultReader(file), root_{&root, ""} {}

    PatternReading read() {
        if (expect(root_, Json::Kind::Object)) read_root();
        out_.faults = take_faults();
        return std::move(out_);
    }

 private:
    void read_root() {
        read_properties();
        const Node pattern = root_.member("pattern");
        if (!pattern) return error(root_, "no key 'pattern': not a garment specification");
        if (!expect(pattern, Json::Kind::Object)) return;
        read_panels(pattern);
        read_seams(pattern);
        read_additions(root_.member("selvedge"));
    }

    // A length in file units, as metres.
    std::optional<double> length(const Node& node) {
        const auto value = number(node);
        if (!value) return {};
        if (std::abs(*value) <= kFarthest * units_) return *value / units_;
        error(node, node.value->number_text() + " is further than 100 m");
        return {};
    }
    std::optional<Vec2d> point(const Node& node) {
        const auto values = pair(node);
        if (!values) return {};
        if (values->cwiseAbs().maxCoeff() <= kFarthest * units_) return Vec2d(*values / units_);
        error(node, "further than 100 m");
        return {};
    }

    void read_properties() {
        const Node properties = root_.member("properties");
        if (!properties || !expect(properties, Json::Kind::Object)) return;
        const Node units = properties.member("units_in_meter");
        if (units && number(units)) {
            units_ = units_in_meter(*root_.value);
            if (units.value->number() != units_) {
                error(units, units.value->number_text() + " units in a metre: expected 0.001 to 1000000");
            }
        }
        const Node coords = properties.member("curvature_coords");
        if (!coords) return;
        const auto word = text(coords);
        if (!word) return;
        is_relative_ = *word != "absolute";
        if (*word != "absolute" && *word != "relative")
            error(coords, "'" + *word + "' is neither relative nor absolute");
    }

    void read_panels(const Node& pattern) {
        const Node panels = pattern.member("panels");
        if (!panels) return error(pattern, "no key 'panels'");
        if (!expect(panels, Json::Kind::Object)) return;
        if (panels.value->members().empty()) error(panels, "no panels");
        for (const Json::Member& member : panels.value->members()) {
            const Node node{&member.value, json_path(panels.path, member.key)};
            panel_index_[member.key] = static_cast<int>(out_.pattern.panels.size());
            Panel panel;
            panel.name = member.key;
            const std::size_t before = error_count();
            edge_counts_.push_back(0);
            if (expect(node, Json::Kind::Object)) read_panel(node, panel);
            out_.is_sound.push_back(error_count() == before);
            out_.places.push_back(node.path);
            out_.pattern.panels.push_back(std::move(panel));
        }
    }

    void read_panel(const Node& node, Panel& panel) {
        const std::size_t before = error_count();
        read_vertices(node, panel);
        read_edges(node, panel);
        if (const Node translation = node.member("translation")) {
            if (const auto values = triple(translation)) panel.translation = *values / units_;
            if (panel.translation.cwiseAbs().maxCoeff() > kFarthest) error(translation, "further than 100 m");
        }
        if (const Node rotation = node.member("rotation")) {
            if (const auto angles = triple(rotation)) panel.rotation = rotation_from_degrees(*angles);
        }
        const bool outline_reads = error_count() == before;
        if (outline_reads) check_chain(node, panel);
        if (const Node own = node.member("selvedge")) read_panel_additions(own, panel);
        if (outline_reads && error_count() == before) hold_counter_clockwise(node, panel);
    }

    void read_vertices(const Node& panel_node, Panel& panel) {
        const Node vertices = panel_node.member("vertices");
        if (!vertices) return error(panel_node, "no key 'vertices'");
        if (!expect(vertices, Json::Kind::Array)) return;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            panel.vertices.push_back(point(vertices.element(i)).value_or(Vec2d::Zero()));
        }
    }

    void read_edges(const Node& panel_node, Panel& panel) {
        const Node edges = panel_node.member("edges");
        if (!edges) return error(panel_node, "no key 'edges'");
        if (!expect(edges, Json::Kind::Array)) return;
        edge_counts_.back() = edges.size();
        if (edges.size() > kMaxEdges) {
            return error(edges, std::to_string(edges.size()) + " edges: at most " + std::to_string(kMaxEdges));
        }
        if (edges.size() < 2) error(edges, "an outline needs two edges or more");
        for (std::size_t i = 0; i < edges.size(); ++i) {
            OutlineEdge edge;
            const Node node = edges.element(i);
            if (expect(node, Json::Kind::Object)) read_edge(node, panel, edge);
            panel.edges.push_back(std::move(edge));
        }
    }

    void read_edge(const Node& node, const Panel& panel, OutlineEdge& edge) {
        const Node endpoints = node.member("endpoints");
        if (!endpoints) return error(node, "no key 'endpoints'");
        if (!expect_array(endpoints, 2)) return;
        const auto start = index(endpoints.element(0), panel.vertices.size(), "vertex");
        const auto end = index(endpoints.element(1), panel.vertices.size(), "vertex");
        if (const Node label = node.member("label")) edge.label = text(label).value_or("");
        if (!start || !end) return;
        edge.start = *start;
        edge.end = *end;
        if (*start == *end) return error(endpoints, "the edge starts and ends at the same vertex");
        const Node curvature = node.member("curvature");
        if (!curvature || curvature.value->is_null()) return;
        read_curvature(curvature, panel, edge);
    }

    void read_curvature(const Node& node, const Panel& panel, OutlineEdge& edge) {
        if (node.value->is_array()) {  // as older files have it
            edge.kind = CurveKind::Quadratic;
            return read_control(node, panel, edge, 0);
        }
        if (!expect(node, Json::Kind::Object)) return;
        const Node type = node.member("type");
        const Node params = node.member("params");
        if (!type) return error(node, "no key 'type'");
        if (!params) return error(node, "no key 'params'");
        const auto word = text(type);
        if (!word) return;
        if (*word == "circle") return read_arc(params, panel, edge);
        if (*word != "quadratic" && *word != "cubic") {
            return error(type, "unknown curvature type '" + *word + "': known are quadratic, cubic, circle");
        }
        edge.kind = *word == "cubic" ? CurveKind::Cubic : CurveKind::Quadratic;
        const std::size_t count = edge.kind == CurveKind::Cubic ? 2 : 1;
        if (!expect_array(params, count)) return;
        for (std::size_t i = 0; i < count; ++i) read_control(params.element(i), panel, edge, i);
    }

    void read_control(const Node& node, const Panel& panel, OutlineEdge& edge, std::size_t which) {
        if (!is_relative_) {
            edge.control[which] = point(node).value_or(Vec2d::Zero());
            return;
        }
        if (!expect_array(node, 2)) return;
        const auto along = number(node.element(0));
        const auto across = number(node.element(1));
        if (!along || !across) return;
        const Vec2d start = panel.vertices[static_cast<std::size_t>(edge.start)];
        const Vec2d chord = panel.vertices[static_cast<std::size_t>(edge.end)] - start;
        const Vec2d control = start + *along * chord + *across * Vec2d(-chord.y(), chord.x());
        if (!(control.cwiseAbs().maxCoeff() <= kFarthest))
            return error(node, "the control point is further than 100 m");
        edge.control[which] = control;
    }

    void read_arc(const Node& params, const Panel& panel, OutlineEdge& edge) {
        edge.kind = CurveKind::Arc;
        if (!expect_array(params, 3)) return;
        const auto radius = length(params.element(0));
        const auto is_large = flag(params.element(1));
        const auto bulges_right = flag(params.element(2));
        if (!radius || !is_large || !bulges_right) return;
        edge.arc_radius = *radius;
        edge.is_large_arc = *is_large;
        edge.turns_right = !*bulges_right;  // an arc that lies to the right of its chord turns left
        const double chord =
            (panel.vertices[static_cast<std::size_t>(edge.end)] - panel.vertices[static_cast<std::size_t>(edge.start)])
                .norm();
        if (*radius <= 0) return error(params.element(0), "the radius of an arc must be positive");
        if (*radius * 2 < chord * (1 - 1e-6)) {
            error(params.element(0), "a radius of " + params.element(0).value->number_text() +
                                         " is too small for a chord of " + Json(chord * units_).number_text());
        }
    }

    // Seams name edges by their place in the file, so the loop must stand in order there.
    void check_chain(const Node& node, const Panel& panel) {
        const std::size_t count = panel.edges.size();
        const Node edges = node.member("edges");
        std::vector<int> visits(panel.vertices.size(), 0);
        for (std::size_t i = 0; i < count; ++i) {
            const OutlineEdge& edge = panel.edges[i];
            const OutlineEdge& next = panel.edges[(i + 1) % count];
            if (++visits[static_cast<std::size_t>(edge.start)] == 2) {
                error(edges.element(i), "the outline passes vertex " + std::to_string(edge.start) + " twice");
            }
            if (edge.end == next.start) continue;
            error(edges.element(i), "the outline is open: this edge ends at vertex " + std::to_string(edge.end) +
                                        ", the next starts at vertex " + std::to_string(next.start));
        }
    }

    // GarmentCode draws back panels clockwise, seen from the front: the order of traversal says which way a panel
    // faces. Mirroring x turns such a loop counter-clockwise and leaves the order and direction of its edges, so an
    // edge has the same index, start and end in the file and in the Panel, and a seam means the same in both.
    void hold_counter_clockwise(const Node& node, Panel& panel) {
        const double area = outline_area(panel);
        if (std::abs(area) < 1e-8) return error(node, "the outline encloses no area");
        if (area > 0) return;
        panel.is_mirrored = true;
        for (Vec2d& vertex : panel.vertices) vertex.x() = -vertex.x();
        for (OutlineEdge& edge : panel.edges) {
            for (Vec2d& control : edge.control) control.x() = -control.x();
            edge.turns_right = edge.kind == CurveKind::Arc && !edge.turns_right;
        }
        for (InternalLine& line : panel.internal_lines) {
            for (Vec2d& p : line.points) p.x() = -p.x();
        }
        panel.grain_angle = -panel.grain_angle;
    }

    void read_panel_additions(const Node& node, Panel& panel) {
        if (!expect(node, Json::Kind::Object)) return;
        if (const Node grain = node.member("grainline")) panel.grain_angle = number(grain).value_or(0) * kDegree;
        if (const Node fabric = node.member("fabric")) panel.fabric = read_fabric_name(fabric);
        if (const Node layer = node.member("layer")) {
            const auto value = number(layer);
            if (value && (*value != std::floor(*value) || std::abs(*value) > 1000)) {
                error(layer, "a layer is a whole number from -1000 to 1000");
            } else {
                panel.layer = static_cast<int>(value.value_or(0));
            }
        }
        if (const Node pins = node.member("pins"); pins && expect(pins, Json::Kind::Array)) {
            for (std::size_t i = 0; i < pins.size(); ++i) {
                if (const auto pin = index(pins.element(i), panel.vertices.size(), "vertex"))
                    panel.pins.push_back(*pin);
            }
        }
        if (const Node lines = node.member("internal_lines")) read_internal_lines(lines, panel);
    }

    void read_internal_lines(const Node& lines, Panel& panel) {
        if (!expect(lines, Json::Kind::Array)) return;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const Node node = lines.element(i);
            InternalLine line;
            if (!expect(node, Json::Kind::Object)) continue;
            if (const Node name = node.member("name")) line.name = text(name).value_or("");
            const Node points = node.member("points");
            if (!points) {
                error(node, "no key 'points'");
                continue;
            }
            if (!expect(points, Json::Kind::Array)) continue;
            for (std::size_t k = 0; k < points.size(); ++k) {
                if (const auto p = point(points.element(k))) line.points.push_back(*p);
            }
            panel.internal_lines.push_back(std::move(line));
        }
    }

    void read_seams(const Node& pattern) {
        const Node stitches = pattern.member("stitches");
        if (!stitches || !expect(stitches, Json::Kind::Array)) return;
        for (std::size_t i = 0; i < stitches.size(); ++i) {
            const Node node = stitches.element(i);
            if (const auto seam = read_seam(node)) {
                out_.pattern.seams.push_back(*seam);
                out_.seam_indices.push_back(static_cast<int>(i));
            }
        }
    }

    std::optional<Seam> read_seam(const Node& node) {
        if (!expect(node, Json::Kind::Array)) return {};
        if (node.size() != 2 && node.size() != 3) {
            error(node, std::to_string(node.size()) + " values: a stitch joins two edges");
            return {};
        }
        Seam seam;
        if (node.size() == 3) {
            const auto word = text(node.element(2));
            if (word && *word != "right_wrong") error(node.element(2), "'" + *word + "' should be right_wrong");
            seam.is_reversed = false;
        }
        const auto first = read_side(node.element(0));
        const auto second = read_side(node.element(1));
        if (!first || !second) return {};
        seam.first = *first;
        seam.second = *second;
        return seam;
    }

    std::optional<SeamSide> read_side(const Node& node) {
        if (!expect(node, Json::Kind::Object)) return {};
        const Node panel = node.member("panel");
        const Node edge = node.member("edge");
        if (!panel) error(node, "no key 'panel'");
        if (!edge) error(node, "no key 'edge'");
        if (!panel || !edge) return {};
        const auto name = text(panel);
        if (!name) return {};
        const auto found = panel_index_.find(*name);
        if (found == panel_index_.end()) {
            error(panel, "no panel '" + *name + "'");
            return {};
        }
        const auto at = index(edge, edge_counts_[static_cast<std::size_t>(found->second)], "edge");
        if (!at) return {};
        const SeamSide side{found->second, *at};
        const auto [earlier, is_new] = sewn_.insert({side, node.path});
        if (!is_new) {
            error(node,
                  "edge " + std::to_string(*at) + " of panel '" + *name + "' is sewn already, at " + earlier->second);
        }
        return side;
    }

    void read_additions(const Node& node) {
        if (!node || !expect(node, Json::Kind::Object)) return;
        Pattern& pattern = out_.pattern;
        if (const Node fabric = node.member("fabric")) pattern.fabric = read_fabric_name(fabric);
        if (const Node tartan = node.member("tartan")) pattern.tartan = text(tartan).value_or("");
        if (const Node body = node.member("body")) pattern.body = text(body).value_or("");
        if (const Node height = node.member("body_height")) {
            const auto value = length(height);
            if (value && (*value < 0.3 || *value > 3)) {
                error(height, height.value->number_text() + " is no body's height");
            } else {
                pattern.body_height = value.value_or(pattern.body_height);
            }
        }
    }

    std::string read_fabric_name(const Node& node) {
        const auto name = text(node);
        if (!name || name->empty() || name->ends_with(".json")) return name.value_or("");
        const std::vector<std::string> known = fabric_names();
        if (std::find(known.begin(), known.end(), *name) == known.end()) {
            warn(node, "no fabric '" + *name + "' ships with the program");
        }
        return *name;
    }

    Node root_;
    PatternReading out_;
    double units_ = 100;
    bool is_relative_ = true;
    std::map<std::string, int> panel_index_;
    std::vector<std::size_t> edge_counts_;
    std::map<SeamSide, std::string> sewn_;
};

}  // namespace

double units_in_meter(const Json& root) {
    const Json* properties = root.find("properties");
    const Json* units = properties ? properties->find("units_in_meter") : nullptr;
    if (!units || !units->is_number()) return 100;
    return units->number() >= 1e-3 && units->number() <= 1e6 ? units->number() : 100;
}

Eigen::Matrix3d rotation_from_degrees(const Vec3d& angles_deg) {
    const Vec3d angles = angles_deg * kDegree;
    return (Eigen::AngleAxisd(angles.z(), Vec3d::UnitZ()) * Eigen::AngleAxisd(angles.y(), Vec3d::UnitY()) *
            Eigen::AngleAxisd(angles.x(), Vec3d::UnitX()))
        .toRotationMatrix();
}

PatternReading read_pattern(const Json& root, const std::string& file) {
    return Reader(root, file).read();
}

}  // namespace selvedge

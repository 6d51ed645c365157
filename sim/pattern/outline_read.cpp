#include "sim/pattern/outline_read.h"

#include <cmath>

#include "sim/pattern/outline.h"
#include "sim/pattern/outline_crossing.h"

namespace selvedge {
namespace {

class OutlineReader {
 public:
    OutlineReader(FaultReader& reader, bool is_relative, Panel& panel)
        : reader_(reader), panel_(panel), is_relative_(is_relative) {}

    void read(const JsonNode& node) {
        const std::size_t before = reader_.error_count();
        read_vertices(node);
        has_sound_vertices_ = reader_.error_count() == before;
        read_edges(node);
        if (reader_.error_count() == before) check_chain(node.member("edges"));
    }

 private:
    void read_vertices(const JsonNode& node) {
        const JsonNode vertices = node.member("vertices");
        if (!vertices) return reader_.error(node, "no key 'vertices'");
        if (!reader_.expect(vertices, Json::Kind::Array)) return;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            panel_.vertices.push_back(reader_.point(vertices.element(i)).value_or(Vec2d::Zero()));
        }
    }

    void read_edges(const JsonNode& node) {
        const JsonNode edges = node.member("edges");
        if (!edges) return reader_.error(node, "no key 'edges'");
        if (!reader_.expect(edges, Json::Kind::Array)) return;
        if (edges.size() > kMostEdges) {
            return reader_.error(edges, std::to_string(edges.size()) + " edges: at most " + std::to_string(kMostEdges));
        }
        if (edges.size() < 2) reader_.error(edges, "an outline needs two edges or more");
        for (std::size_t i = 0; i < edges.size(); ++i) {
            OutlineEdge edge;
            if (reader_.expect(edges.element(i), Json::Kind::Object)) read_edge(edges.element(i), edge);
            panel_.edges.push_back(std::move(edge));
        }
    }

    void read_edge(const JsonNode& node, OutlineEdge& edge) {
        const JsonNode endpoints = node.member("endpoints");
        if (!endpoints) return reader_.error(node, "no key 'endpoints'");
        if (!reader_.expect_array(endpoints, 2)) return;
        const auto start = reader_.index(endpoints.element(0), panel_.vertices.size(), "vertex");
        const auto end = reader_.index(endpoints.element(1), panel_.vertices.size(), "vertex");
        if (const JsonNode label = node.member("label")) edge.label = reader_.text(label).value_or("");
        if (!start || !end) return;
        edge.start = *start;
        edge.end = *end;
        if (*start == *end) return reader_.error(endpoints, "the edge starts and ends at the same vertex");
        const JsonNode curvature = node.member("curvature");
        if (curvature && !curvature.value->is_null()) read_curvature(curvature, edge);
    }

    void read_curvature(const JsonNode& node, OutlineEdge& edge) {
        if (node.value->is_array()) {  // as older files have it
            edge.kind = CurveKind::Quadratic;
            return read_control(node, edge, 0);
        }
        if (!reader_.expect(node, Json::Kind::Object)) return;
        const JsonNode type = node.member("type");
        const JsonNode params = node.member("params");
        if (!type) return reader_.error(node, "no key 'type'");
        if (!params) return reader_.error(node, "no key 'params'");
        const auto word = reader_.text(type);
        if (!word) return;
        if (*word == "circle") return read_arc(params, edge);
        if (*word != "quadratic" && *word != "cubic") {
            return reader_.error(type, "unknown curvature type '" + *word + "': known are quadratic, cubic, circle");
        }
        edge.kind = *word == "cubic" ? CurveKind::Cubic : CurveKind::Quadratic;
        const std::size_t count = edge.kind == CurveKind::Cubic ? 2 : 1;
        if (!reader_.expect_array(params, count)) return;
        for (std::size_t i = 0; i < count; ++i) read_control(params.element(i), edge, i);
    }

    void read_control(const JsonNode& node, OutlineEdge& edge, std::size_t which) {
        if (!is_relative_) {
            edge.control[which] = reader_.point(node).value_or(Vec2d::Zero());
            return;
        }
        const auto relative = reader_.pair(node);
        if (!relative) return;
        const Vec2d along = chord(edge);
        const Vec2d control = vertex(edge.start) + relative->x() * along + relative->y() * Vec2d(-along.y(), along.x());
        if (!(control.cwiseAbs().maxCoeff() <= kFarthest)) {
            return reader_.error(node, "the control point is further than 100 m");
        }
        edge.control[which] = control;
    }

    void read_arc(const JsonNode& params, OutlineEdge& edge) {
        edge.kind = CurveKind::Arc;
        if (!reader_.expect_array(params, 3)) return;
        const JsonNode radius_node = params.element(0);
        const auto radius = reader_.length(radius_node);
        const auto is_large = reader_.flag(params.element(1));
        const auto bulges_right = reader_.flag(params.element(2));
        if (!radius || !is_large || !bulges_right) return;
        edge.arc_radius = *radius;
        edge.is_large_arc = *is_large;
        edge.turns_right = !*bulges_right;  // an arc that lies to the right of its chord turns left
        if (*radius <= 0) return reader_.error(radius_node, "the radius of an arc must be positive");
        const double span = chord(edge).norm();
        if (!has_sound_vertices_ || *radius * 2 >= span * (1 - 1e-6)) return;
        reader_.error(radius_node, "a radius of " + radius_node.value->number_text() + " is too small for a chord of " +
                                       Json(std::round(span * reader_.units_in_meter * 1e3) / 1e3).number_text());
    }

    // Seams name edges by their place in the file, so the loop must stand in order there.
    void check_chain(const JsonNode& edges) {
        const std::size_t count = panel_.edges.size();
        std::vector<int> visits(panel_.vertices.size(), 0);
        for (std::size_t i = 0; i < count; ++i) {
            const OutlineEdge& edge = panel_.edges[i];
            const OutlineEdge& next = panel_.edges[(i + 1) % count];
            if (++visits[static_cast<std::size_t>(edge.start)] == 2) {
                reader_.error(edges.element(i), "the outline passes vertex " + std::to_string(edge.start) + " twice");
            }
            if (edge.end == next.start) continue;
            reader_.error(edges.element(i), "the outline is open: this edge ends at vertex " +
                                                std::to_string(edge.end) + ", the next starts at vertex " +
                                                std::to_string(next.start));
        }
    }

    const Vec2d& vertex(int index) const { return panel_.vertices[static_cast<std::size_t>(index)]; }
    Vec2d chord(const OutlineEdge& edge) const { return vertex(edge.end) - vertex(edge.start); }

    FaultReader& reader_;
    Panel& panel_;
    bool is_relative_;
    bool has_sound_vertices_ = false;
};

}  // namespace

void read_outline(FaultReader& reader, const JsonNode& panel_node, bool is_relative, Panel& panel) {
    OutlineReader(reader, is_relative, panel).read(panel_node);
}

// GarmentCode draws back panels clockwise, seen from the front: the order of traversal says which way a panel faces.
// Mirroring x turns such a loop counter-clockwise and leaves the order and direction of its edges, so that an edge has
// the same index, start and end in the file and in the Panel, and a seam means the same in both.
void hold_counter_clockwise(FaultReader& reader, const JsonNode& panel_node, Panel& panel) {
    const double area = outline_area(panel);
    if (std::abs(area) < kSmallestArea) return reader.error(panel_node, "the outline encloses no area");
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

}  // namespace selvedge

#include "sim/pattern/pattern_read.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "sim/core/math.h"
#include "sim/pattern/enum_names.h"
#include "sim/pattern/fabric.h"
#include "sim/pattern/fabric_file.h"
#include "sim/pattern/fault.h"
#include "sim/pattern/limits.h"
#include "sim/pattern/outline.h"

namespace selvedge::sim {
namespace {

constexpr std::size_t kMostPanels = 10'000;

// Sets the value that the text names.
template <class T>
void read_choice(FaultReader& reader, const JsonNode& node, T& value) {
    constexpr auto names = names_of(T{});
    if (const auto index = reader.choice(node, names.texts)) value = static_cast<T>(*index);
}

// Between an outline and its cut line, in file units; returns metres.
std::optional<double> read_allowance(FaultReader& reader, const JsonNode& node) {
    const auto width = reader.length(node);
    if (!width || (*width >= 0 && *width <= kWidestAllowance)) return width;
    reader.error(node, "an allowance is from 0 to 50 cm");
    return std::nullopt;
}

using Node = JsonNode;

class Reader : private FaultReader {
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
        check_mirrors();
        if (!out_.pattern.panels.empty()) read_seams(pattern);
        read_additions(root_.member("selvedge"));
    }

    void read_properties() {
        const Node properties = root_.member("properties");
        if (!properties || !expect(properties, Json::Kind::Object)) return;
        const Node units = properties.member("units_in_meter");
        if (units && number(units)) {
            units_in_meter = selvedge::sim::units_in_meter(*root_.value);
            if (units.value->number() != units_in_meter) {
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
        // A garment that was only begun can be saved and opened; one with a photo to trace is at its usual beginning.
        const Json* own = root_.value->find("selvedge");
        const bool has_photos = own && own->find("underlays");
        const std::size_t count = panels.value->members().size();
        if (count == 0 && !has_photos) warn(panels, "no panels");
        if (count > kMostPanels) {
            return error(panels, std::to_string(count) + " panels: at most " + std::to_string(kMostPanels));
        }
        for (const Json::Member& member : panels.value->members()) {
            const Node node{&member.value, json_path(panels.path, member.key)};
            panel_index_[member.key] = static_cast<int>(out_.pattern.panels.size());
            Panel panel;
            panel.name = member.key;
            const std::size_t before = error_count();
            if (expect(node, Json::Kind::Object)) read_panel(node, panel);
            out_.is_sound.push_back(error_count() == before);
            out_.places.push_back(node.path);
            out_.pattern.panels.push_back(std::move(panel));
        }
    }

    void read_panel(const Node& node, Panel& panel) {
        const std::size_t before = error_count();
        read_outline(*this, node, is_relative_, panel);
        if (const Node translation = node.member("translation")) {
            if (const auto values = triple(translation)) panel.translation = *values / units_in_meter;
        }
        if (const Node rotation = node.member("rotation")) {
            if (const auto angles = triple(rotation)) panel.rotation = rotation_from_degrees(*angles);
        }
        if (const Node label = node.member("label"); label && label.value->is_string())
            panel.label = label.value->string();
        if (const Node own = node.member("selvedge")) read_panel_additions(own, panel);
        for (const LimitFault& fault : limit_faults(panel))
            error({node.value, node.path + "." + fault.place}, fault.problem);
        if (error_count() == before) convert_to_panel_frame(*this, node, panel);
    }

    void read_panel_additions(const Node& node, Panel& panel) {
        if (!expect(node, Json::Kind::Object)) return;
        if (const Node grain = node.member("grainline")) panel.grain_angle = number(grain).value_or(0) * kDegree;
        if (const Node offset = node.member("sett_offset")) panel.sett_offset = point(offset).value_or(Vec2d::Zero());
        if (const Node fabric = node.member("fabric")) panel.fabric = read_fabric_name(fabric);
        if (const Node interlinings = node.member("interlinings")) read_interlinings(interlinings, panel);
        if (const Node surface = node.member("surface")) panel.surface = read_design(*this, surface);
        if (const Node layer = node.member("layer")) {
            const auto value = number(layer);
            if (value && (*value != std::floor(*value) || std::abs(*value) > kHighestLayer)) {
                error(layer, layer_problem());
            } else {
                panel.layer = static_cast<int>(value.value_or(0));
            }
        }
        if (const Node garment = node.member("garment")) panel.garment = text(garment).value_or("");
        if (const Node pins = node.member("pins"); pins && expect(pins, Json::Kind::Array)) {
            for (std::size_t i = 0; i < pins.size(); ++i) {
                if (const auto pin = index(pins.element(i), panel.vertices.size(), "vertex"))
                    panel.pins.push_back(*pin);
            }
        }
        if (const Node lines = node.member("internal_lines")) read_internal_lines(lines, panel);
        if (const Node notches = node.member("notches")) read_notches(notches, panel);
        if (const Node wrap = node.member("wrap_radius")) {
            panel.wrap_radius = length(wrap).value_or(0);
            if (panel.wrap_radius < 0) error(wrap, "wrap_radius must not be negative");
        }
        if (const Node cone = node.member("wrap_cone")) read_wrap_cone(cone, panel);
        if (const Node other = node.member("mirror_of")) {
            const auto name = text(other);
            if (name) mirrors_.push_back({other, panel.name, *name});
            panel.mirror_of = name.value_or("");
        }
        if (const Node position = node.member("sheet_position")) panel.sheet_position = point(position);
        read_cutting(node, panel);
    }

    // What the panel's paper says: allowance, pieces, drill points.
    void read_cutting(const Node& node, Panel& panel) {
        if (const Node width = node.member("allowance")) panel.allowance = read_allowance(*this, width);
        if (const Node count = node.member("pieces"))
            panel.pieces = whole_number(count, 1, kMostPieces).value_or(panel.pieces);
        if (const Node worn = node.member("worn")) panel.is_worn = flag(worn).value_or(true);
        if (const Node points = node.member("drill_points"); points && expect(points, Json::Kind::Array)) {
            for (std::size_t i = 0; i < points.size(); ++i) {
                if (const auto p = point(points.element(i))) panel.drill_points.push_back(*p);
            }
        }
    }

    void read_interlinings(const Node& node, Panel& panel) {
        if (!expect(node, Json::Kind::Array)) return;
        if (node.size() > kMostInterlinings) {
            return error(node,
                         std::to_string(node.size()) + " interlinings: at most " + std::to_string(kMostInterlinings));
        }
        for (std::size_t i = 0; i < node.size(); ++i) {
            panel.interlinings.push_back(read_fabric_name(node.element(i)));
            if (panel.interlinings.back().empty()) error(node.element(i), "an interlining names a fabric");
        }
    }

    // [{"edge": INDEX, "at": FRACTION}]. The fraction is measured from the start of the edge, which is the same vertex
    // in the file and in the Panel.
    void read_notches(const Node& notches, Panel& panel) {
        if (!expect(notches, Json::Kind::Array)) return;
        for (std::size_t i = 0; i < notches.size(); ++i) {
            const Node node = notches.element(i);
            if (!expect(node, Json::Kind::Object)) continue;
            const Node edge = node.member("edge");
            const Node at = node.member("at");
            if (!edge) error(node, "no key 'edge'");
            if (!at) error(node, "no key 'at'");
            if (!edge || !at) continue;
            const auto edge_index = index(edge, panel.edges.size(), "edge");
            const auto fraction = number(at);
            if (fraction && !(*fraction >= 0 && *fraction <= 1)) error(at, "a notch lies from 0 to 1 along its edge");
            if (!edge_index || !fraction) continue;
            Notch notch{.edge = *edge_index, .t = *fraction};
            if (const Node kind = node.member("kind")) read_choice(*this, kind, notch.kind);
            if (const Node count = node.member("count"))
                notch.count = whole_number(count, 1, kMostNotchesTogether).value_or(notch.count);
            panel.notches.push_back(notch);
        }
    }

    // The panel named by mirror_of must exist, be another panel, and not be a mirror image itself.
    void check_mirrors() {
        for (const Mirror& mirror : mirrors_) {
            const auto found = panel_index_.find(mirror.of);
            if (found == panel_index_.end()) {
                error(mirror.node, "no panel '" + mirror.of + "'");
            } else if (mirror.of == mirror.panel) {
                error(mirror.node, "a panel is no mirror image of itself");
            } else if (const Panel& other = out_.pattern.panels[static_cast<std::size_t>(found->second)];
                       !other.mirror_of.empty()) {
                error(mirror.node, "panel '" + mirror.of + "' is a mirror image itself, of '" + other.mirror_of + "'");
            }
        }
    }

    void read_wrap_cone(const Node& node, Panel& panel) {
        if (!expect(node, Json::Kind::Object)) return;
        if (panel.wrap_radius > 0) return error(node, "a panel has wrap_radius or wrap_cone, not both");
        const Node apex = node.member("apex"), sine = node.member("sine");
        if (!apex || !sine) return error(node, std::string("no key '") + (apex ? "sine" : "apex") + "'");
        const auto at = point(apex);
        const auto value = number(sine);
        if (!at || !value) return;
        if (!(std::abs(*value) >= kLeastConeSine && std::abs(*value) <= 1))
            return error(sine, "the sine is from 0.01 to 1, or as much below 0");
        panel.wrap_cone = WrapCone{.apex = *at, .sine = *value};
    }

    void read_internal_lines(const Node& lines, Panel& panel) {
        if (!expect(lines, Json::Kind::Array)) return;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const Node node = lines.element(i);
            InternalLine line;
            if (!expect(node, Json::Kind::Object)) continue;
            if (const Node name = node.member("name")) line.name = text(name).value_or("");
            if (const Node use = node.member("use")) read_choice(*this, use, line.use);
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
                for (const SeamSide& side : {seam->first, seam->second})
                    seam_at_.emplace(side, out_.pattern.seams.size());
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

    // {"panel": NAME, "edge": INDEX}
    std::optional<SeamSide> read_edge(const Node& node) {
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
        const std::vector<OutlineEdge>& edges = out_.pattern.panels[static_cast<std::size_t>(found->second)].edges;
        if (edges.empty()) return {};  // the edges could not be read; that fault is already recorded
        const auto at = index(edge, edges.size(), "edge");
        if (!at) return {};
        return SeamSide{found->second, *at};
    }

    // A side of a stitch. Records an error if another stitch already uses this edge.
    std::optional<SeamSide> read_side(const Node& node) {
        const auto side = read_edge(node);
        if (!side) return {};
        const auto [earlier, is_new] = sewn_.insert({*side, node.path});
        if (!is_new) {
            error(node, "edge " + std::to_string(side->edge) + " of panel '" +
                            out_.pattern.panels[static_cast<std::size_t>(side->panel)].name + "' is sewn already, at " +
                            earlier->second);
        }
        return side;
    }

    void read_additions(const Node& node) {
        if (!node || !expect(node, Json::Kind::Object)) return;
        Pattern& pattern = out_.pattern;
        if (const Node fabric = node.member("fabric")) pattern.fabric = read_fabric_name(fabric);
        if (const Node tartan = node.member("tartan")) pattern.tartan = text(tartan).value_or("");
        if (const Node size = node.member("sett_size")) read_sett_size(size);
        if (const Node position = node.member("sett_position")) {
            pattern.sett_position = point(position).value_or(Vec2d::Zero());
        }
        if (const Node surface = node.member("surface")) pattern.surface = read_design(*this, surface);
        if (const Node matched = node.member("matched_sett")) read_matched_sett(matched);
        if (const Node names = node.member("seam_names")) read_seam_names(names);
        if (const Node eased = node.member("eased")) read_eased(eased);
        if (const Node sewings = node.member("sewings")) read_sewings(sewings);
        if (const Node body = node.member("body")) pattern.body = text(body).value_or("");
        if (const Node height = node.member("body_height")) {
            const auto value = length(height);
            if (value && (*value < kLeastBodyHeight || *value > kGreatestBodyHeight)) {
                error(height, height.value->number_text() + " is not a body height: 30 to 300 cm");
            } else {
                pattern.body_height = value.value_or(pattern.body_height);
            }
        }
        if (const Node width = node.member("allowance")) pattern.allowance = read_allowance(*this, width).value_or(0);
        if (const Node underlays = node.member("underlays")) read_underlays(underlays);
        if (const Node size = node.member("size")) pattern.size = text(size).value_or("");
        if (const Node edge = node.member("edge_length")) {
            pattern.edge_length = length(edge);
            if (pattern.edge_length &&
                (*pattern.edge_length < kShortestMeshEdge || *pattern.edge_length > kLongestMeshEdge)) {
                error(edge, edge.value->number_text() + " is no edge length of a mesh: " + kMeshEdgesText + " are");
            }
        }
    }

    void read_underlays(const Node& list) {
        if (!expect(list, Json::Kind::Array)) return;
        if (list.size() > kMostUnderlays) {
            return error(list, std::to_string(list.size()) + " underlays: at most " + std::to_string(kMostUnderlays) +
                                   " are possible");
        }
        for (std::size_t i = 0; i < list.size(); ++i) read_underlay(list.element(i));
    }

    void read_underlay(const Node& node) {
        if (!expect(node, Json::Kind::Object)) return;
        Underlay underlay;
        const Node file = node.member("file"), size = node.member("pixel_size");
        if (!file) return error(node, "no key 'file'");
        if (!size) return error(node, "no key 'pixel_size'");
        underlay.file = text(file).value_or("");
        underlay.pixel_size = length(size).value_or(underlay.pixel_size);
        if (underlay.pixel_size < kSmallestPixel || underlay.pixel_size > kLargestPixel)
            error(size, size.value->number_text() + " is no size of a pixel: 0.0001 to 100 cm are");
        if (const Node position = node.member("position")) underlay.position = point(position).value_or(Vec2d::Zero());
        if (const Node rotation = node.member("rotation")) underlay.rotation = number(rotation).value_or(0) * kDegree;
        if (const Node opacity = node.member("opacity")) {
            underlay.opacity = number(opacity).value_or(underlay.opacity);
            if (underlay.opacity < 0 || underlay.opacity > 1) error(opacity, "an opacity is from 0 to 1");
        }
        out_.pattern.underlays.push_back(std::move(underlay));
    }

    void read_sett_size(const Node& node) {
        const auto size = length(node);
        if (size && (*size < kSmallestSett || *size > kLargestSett)) {
            return error(node, node.value->number_text() + " is no size of a sett's repeat: 0.1 to 500 cm are");
        }
        out_.pattern.sett_size = size;
    }

    void read_matched_sett(const Node& node) {
        if (!expect(node, Json::Kind::Object)) return;
        MatchedSett matched;
        if (const Node tartan = node.member("tartan")) matched.tartan = text(tartan).value_or("");
        const Node repeat = node.member("repeat");
        if (!repeat) return error(node, "no key 'repeat'");
        const auto size = point(repeat);
        if (size && size->minCoeff() <= 0) return error(repeat, "the repeat must be positive");
        matched.repeat = size.value_or(Vec2d::Zero());
        out_.pattern.matched_sett = std::move(matched);
    }

    // {NAME: {"panel", "edge"}}: names the seam at that edge.
    void read_seam_names(const Node& names) {
        if (!expect(names, Json::Kind::Object)) return;
        for (const Json::Member& member : names.value->members()) {
            const Node node{&member.value, json_path(names.path, member.key)};
            if (member.key.empty() || member.key.find_first_of(",+") != std::string::npos) {
                error(node, "a seam's name is not empty, and has no comma and no plus sign");
            }
            Seam* seam = read_seam_at(node);
            if (seam && !seam->name.empty()) error(node, "the seam is named '" + seam->name + "' already");
            if (seam && seam->name.empty()) seam->name = member.key;
        }
    }

    // [{"panel", "edge"}]: marks the seams at those edges as eased.
    void read_eased(const Node& eased) {
        if (!expect(eased, Json::Kind::Array)) return;
        for (std::size_t i = 0; i < eased.size(); ++i) {
            Seam* seam = read_seam_at(eased.element(i));
            if (seam && seam->is_eased) error(eased.element(i), "the seam is listed already");
            if (seam) seam->is_eased = true;
        }
    }

    // {NAME: [{"panel", "edge"}]}: the seams at those edges are one sewing.
    void read_sewings(const Node& sewings) {
        if (!expect(sewings, Json::Kind::Object)) return;
        for (const Json::Member& member : sewings.value->members()) {
            const Node node{&member.value, json_path(sewings.path, member.key)};
            if (member.key.empty()) error(node, "a sewing's name is not empty");
            if (!expect(node, Json::Kind::Array)) continue;
            for (std::size_t i = 0; i < node.size(); ++i) {
                Seam* seam = read_seam_at(node.element(i));
                if (seam && !seam->sewing.empty()) {
                    error(node.element(i), "the seam is a part of sewing '" + seam->sewing + "' already");
                }
                if (seam && seam->sewing.empty()) seam->sewing = member.key;
            }
        }
    }

    // The seam at the edge {"panel", "edge"}. Returns nullptr and records an error if there is none.
    Seam* read_seam_at(const Node& node) {
        const auto side = read_edge(node);
        if (!side) return nullptr;
        const auto seam = seam_at_.find(*side);
        if (seam != seam_at_.end()) return &out_.pattern.seams[seam->second];
        error(node, "this edge is not sewn");
        return nullptr;
    }

    std::string read_fabric_name(const Node& node) {
        const auto name = text(node);
        if (!name || name->empty() || is_fabric_file(*name)) return name.value_or("");
        const std::vector<std::string> known = fabric_names();
        if (std::find(known.begin(), known.end(), *name) == known.end()) {
            warn(node, "no fabric '" + *name + "' ships with the program");
        }
        return *name;
    }

    struct Mirror {
        Node node;
        std::string panel;
        std::string of;
    };

    Node root_;
    PatternReading out_;
    bool is_relative_ = true;
    std::map<std::string, int> panel_index_;
    std::map<SeamSide, std::string> sewn_;       // where in the file each edge is sewn
    std::map<SeamSide, std::size_t> seam_at_{};  // index into Pattern::seams
    std::vector<Mirror> mirrors_;
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
        if (edges.size() > kMaxEdges) {
            return reader_.error(edges, std::to_string(edges.size()) + " edges: at most " + std::to_string(kMaxEdges));
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
        if (const JsonNode own = node.member("selvedge")) read_edge_additions(own, edge);
        if (!start || !end) return;
        edge.start = *start;
        edge.end = *end;
        if (*start == *end) return reader_.error(endpoints, "the edge starts and ends at the same vertex");
        const JsonNode curvature = node.member("curvature");
        if (curvature && !curvature.value->is_null()) read_curvature(curvature, edge);
    }

    void read_edge_additions(const JsonNode& node, OutlineEdge& edge) {
        if (!reader_.expect(node, Json::Kind::Object)) return;
        if (const JsonNode width = node.member("allowance")) edge.allowance = read_allowance(reader_, width);
        if (const JsonNode corner = node.member("allowance_corner"))
            read_choice(reader_, corner, edge.allowance_corner);
    }

    void read_curvature(const JsonNode& node, OutlineEdge& edge) {
        if (node.value->is_array()) {  // format of older files
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
        if (!(control.cwiseAbs().maxCoeff() <= kMaxCoordinate)) {
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
        edge.turns_right = !*bulges_right;  // an arc to the right of its chord turns left
        if (*radius <= 0) return reader_.error(radius_node, "the radius of an arc must be positive");
        const double span = chord(edge).norm();
        if (!has_sound_vertices_ || *radius * 2 >= span * (1 - 1e-6)) return;
        reader_.error(radius_node, "a radius of " + radius_node.value->number_text() + " is too small for a chord of " +
                                       Json(std::round(span * reader_.units_in_meter * 1e3) / 1e3).number_text());
    }

    // Checks that the edges form one loop in file order. Seams refer to edges by their index in the file, so the edges
    // cannot be reordered.
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

// GarmentCode draws back panels clockwise, seen from the front: the orientation of the loop tells which way a panel
// faces. Mirroring x makes such a loop counter-clockwise and keeps the order and direction of its edges. So an edge has
// the same index, start and end in the file and in the Panel, and seams need no conversion.
void convert_to_panel_frame(FaultReader& reader, const JsonNode& panel_node, Panel& panel) {
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
    for (Vec2d& p : panel.drill_points) p.x() = -p.x();
    if (panel.wrap_cone) panel.wrap_cone->apex.x() = -panel.wrap_cone->apex.x();
    panel.grain_angle = -panel.grain_angle;
}

}  // namespace selvedge::sim

#include "sim/pattern/pattern_read.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "sim/core/math.h"
#include "sim/core/printable.h"
#include "sim/pattern/fault.h"
#include "sim/pattern/field_moves.h"
#include "sim/pattern/field_read.h"
#include "sim/pattern/limits.h"
#include "sim/pattern/outline.h"
#include "sim/pattern/pattern_fields.h"
#include "sim/pattern/pattern_file.h"

namespace selvedge::sim {
namespace {

constexpr std::size_t kMostPanels = 10'000;

using Node = JsonNode;

template <auto kMember>
using ByHand = Field<kMember, FileForm::ByHand>;

constexpr auto kEach = [](const auto&) { return true; };

class Reader : private FaultReader {
 public:
    Reader(const Json& root, const std::string& file) : FaultReader(file), root_{&root, ""} {}

    PatternReading read() {
        if (expect(root_, Json::Kind::Object)) read_root();
        out_.faults = take_faults();
        return std::move(out_);
    }

 private:
    struct Mirror {
        Node node;
        std::string panel;
        std::string of;
    };

    void read_root() {
        read_properties();
        const Node pattern = root_.member("pattern");
        if (!pattern) return error(root_, "no key 'pattern': not a garment specification");
        if (!expect(pattern, Json::Kind::Object)) return;
        const bool are_panels_known = read_panels(pattern);
        check_mirrors();
        if (are_panels_known) read_seams(pattern);
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

    // Whether it is known which panels there are: else each stitch would be said to have none.
    bool read_panels(const Node& pattern) {
        const Node panels = pattern.member("panels");
        if (!panels) error(pattern, "no key 'panels'");
        if (!panels || !expect(panels, Json::Kind::Object)) return false;
        // A garment that was only begun can be saved and opened; one with a photo to trace is at its usual beginning.
        const Json* own = root_.value->find("selvedge");
        const bool has_photos = own && own->find("underlays");
        const std::size_t count = panels.value->members().size();
        if (count == 0 && !has_photos) warn(panels, "no panels");
        if (count > kMostPanels) {
            error(panels, std::to_string(count) + " panels: at most " + std::to_string(kMostPanels));
            return false;
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
        return true;
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
        const FieldReader values(*this, &panel);
        std::vector<std::string_view> known;
        visit_fields(panel, [&]<class SomeField>(const SomeField& field, auto& value) {
            if constexpr (SomeField::is_key) {
                values.read_field(node, field, value);
                known.push_back(field.key);
            } else if constexpr (requires(Node at) { this->read_by_hand(field, at, panel); }) {
                if (const Node at = node.member(field.key)) read_by_hand(field, at, panel);
                known.push_back(field.key);
            }
        });
        warn_of_unknown_keys(node, known);
    }

    void read_by_hand(const ByHand<&Panel::interlinings>&, const Node& node, Panel& panel) {
        if (!expect(node, Json::Kind::Array)) return;
        if (node.size() > kMostInterlinings) {
            return error(node,
                         std::to_string(node.size()) + " interlinings: at most " + std::to_string(kMostInterlinings));
        }
        for (std::size_t i = 0; i < node.size(); ++i) {
            panel.interlinings.push_back(read_fabric_name(*this, node.element(i)));
            if (panel.interlinings.back().empty()) error(node.element(i), "an interlining names a fabric");
        }
    }

    void read_by_hand(const ByHand<&Panel::surface>&, const Node& node, Panel& panel) {
        panel.surface = read_design(*this, node);
    }

    void read_by_hand(const ByHand<&Panel::wrap_cone>&, const Node& node, Panel& panel) {
        if (!expect(node, Json::Kind::Object)) return;
        warn_of_unknown_keys(node, keys_of<WrapCone>(kEach));
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

    void read_by_hand(const ByHand<&Panel::mirror_of>&, const Node& node, Panel& panel) {
        const auto name = text(node);
        if (name) mirrors_.push_back({node, panel.name, *name});
        panel.mirror_of = name.value_or("");
    }

    void read_by_hand(const ByHand<&Panel::copy_of>&, const Node& node, Panel& panel) {
        const auto name = text(node);
        if (name) copies_.push_back({node, panel.name, *name});
        if (!panel.mirror_of.empty()) error(node, "a panel has mirror_of or copy_of, not both");
        panel.copy_of = name.value_or("");
    }

    // Ignores the keys if another program changed the outline without them.
    void read_by_hand(const ByHand<&Panel::last_key>&, const Node& node, Panel& panel) {
        if (!expect(node, Json::Kind::Object)) return;
        const Node keys = node.member("keys"), last = node.member("last");
        warn_of_unknown_keys(node, std::array<std::string_view, 2>{"keys", "last"});
        if (!keys || !last) return error(node, std::string("no key '") + (keys ? "last" : "keys") + "'");
        if (!expect(keys, Json::Kind::Array)) return;
        const auto most = whole_number(last, 1, kMostKeys);
        if (most == kMostKeys) return warn(last, "no number is left for a new key: the edges are numbered anew");
        std::vector<EdgeKey> read;
        for (std::size_t i = 0; i < keys.size(); ++i) {
            const auto key = read_key(keys.element(i), most.value_or(kMostKeys));
            if (!key || !most) return;
            read.push_back(*key);
        }
        const std::set<EdgeKey> different(read.begin(), read.end());
        if (read.size() != panel.edges.size() || different.size() != read.size()) {
            return warn(keys, count_text(different.size(), "different key") + " for " +
                                  count_text(panel.edges.size(), "edge") + ": the edges are numbered anew");
        }
        for (std::size_t e = 0; e < read.size(); ++e) {
            panel.edges[e].key = read[e];
            if (read[e].role == EdgeRole::Image && !different.contains(EdgeKey{read[e].number}))
                warn(keys.element(e),
                     "no edge has the key " + std::to_string(read[e].number) + ", of which this is the image");
        }
        panel.last_key = *most;
    }

    void read_by_hand(const ByHand<&Panel::fold_key>& field, const Node& node, Panel& panel) {
        const auto key = whole_number(node, 0, static_cast<int>(field.range.most));
        panel.fold_key = key.value_or(0);
        if (panel.last_key == 0 || panel.fold_key <= panel.last_key) return;
        warn(node, "no edge had this key: the last that was given is " + std::to_string(panel.last_key));
        panel.fold_key = 0;
    }

    // A number, or {ROLE: number}.
    std::optional<EdgeKey> read_key(const Node& node, int most) {
        if (!node.value->is_object()) {
            const auto number = whole_number(node, 1, most);
            return number ? std::optional(EdgeKey{*number}) : std::nullopt;
        }
        const Node image = node.member(name_of_value(EdgeRole::Image));
        const auto number = image ? whole_number(image, 1, most) : std::nullopt;
        if (!image) error(node, "no key 'image'");
        return number ? std::optional(EdgeKey{*number, EdgeRole::Image}) : std::nullopt;
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
        for (const Mirror& copy : copies_) check_copy(copy);
    }

    // The panel that it names must exist, and not be derived from this one. A fault of the panels that it leads to is
    // said of them.
    void check_copy(const Mirror& copy) {
        if (!panel_index_.contains(copy.of)) return error(copy.node, "no panel '" + copy.of + "'");
        if (copy.of == copy.panel) return error(copy.node, "a panel is no copy of itself");
        std::set<std::string> passed;
        for (std::string at = copy.of; passed.insert(at).second;) {
            if (at == copy.panel)
                return error(copy.node, "panel '" + copy.of + "' is made from '" + copy.panel +
                                            "' itself: one of them must be drawn");
            const auto found = panel_index_.find(at);
            if (found == panel_index_.end()) return;
            const Panel& panel = out_.pattern.panels[static_cast<std::size_t>(found->second)];
            at = panel.mirror_of.empty() ? panel.copy_of : panel.mirror_of;
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
            error(node, count_text(node.size(), "value") + ": a stitch joins two edges");
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
        if (const Node format = node.member("format"); format && whole_number(format, 1, kMostKeys)) {
            if (const auto newer = newer_format(*root_.value)) warn(format, *newer);
        }
        Pattern& pattern = out_.pattern;
        const FieldReader values(*this);
        // What is listed of seams that has no place in the list `seams`.
        std::vector<std::string_view> known = keys_of<Seam>([]<class SomeField>(const SomeField& field) {
            return !SomeField::is_key && field.descent != Descent::Shape;
        });
        known.emplace_back("format");
        visit_fields(pattern, [&]<class SomeField>(const SomeField& field, auto& value) {
            if constexpr (SomeField::is_key) {
                values.read_field(node, field, value);
                known.push_back(field.key);
            } else if constexpr (requires { this->read_by_hand(field, node, pattern); }) {
                read_by_hand(field, node, pattern);
                known.push_back(field.key);
            }
        });
        warn_of_unknown_keys(node, known);
    }

    // Of the pattern: `own` has the keys.

    void read_by_hand(const ByHand<&Pattern::surface>&, const Node& own, Pattern& pattern) {
        if (const Node surface = own.member("surface")) pattern.surface = read_design(*this, surface);
    }
    void read_by_hand(const ByHand<&Pattern::matched_sett>&, const Node& own, Pattern&) {
        if (const Node matched = own.member("matched_sett")) read_matched_sett(matched);
    }
    void read_by_hand(const ByHand<&Pattern::seams>&, const Node& own, Pattern&) {
        if (const Node names = own.member("seam_names")) read_seam_names(names);
        if (const Node eased = own.member("eased")) read_eased(eased);
        if (const Node sewings = own.member("sewings")) read_sewings(sewings);
        if (const Node seams = own.member("seams")) read_seam_fields(seams);
    }
    void read_by_hand(const ByHand<&Pattern::body>&, const Node& own, Pattern& pattern) {
        if (const Node body = own.member("body")) pattern.body = text(body).value_or("");
    }
    void read_by_hand(const ByHand<&Pattern::underlays>&, const Node& own, Pattern&) {
        if (const Node underlays = own.member("underlays")) read_underlays(underlays);
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
        warn_of_unknown_keys(node, keys_of<Underlay>(kEach));
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

    void read_matched_sett(const Node& node) {
        if (!expect(node, Json::Kind::Object)) return;
        warn_of_unknown_keys(node, keys_of<MatchedSett>(kEach));
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
            Seam* seam = read_named_seam(node);
            if (seam && !seam->name.empty()) error(node, "the seam is named '" + seam->name + "' already");
            if (seam && seam->name.empty()) seam->name = member.key;
        }
    }

    // [{"panel", "edge"}]: marks the seams at those edges as eased.
    void read_eased(const Node& eased) {
        if (!expect(eased, Json::Kind::Array)) return;
        for (std::size_t i = 0; i < eased.size(); ++i) {
            Seam* seam = read_named_seam(eased.element(i));
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
                Seam* seam = read_named_seam(node.element(i));
                if (seam && !seam->sewing.empty()) {
                    error(node.element(i), "the seam is a part of sewing '" + seam->sewing + "' already");
                }
                if (seam && seam->sewing.empty()) seam->sewing = member.key;
            }
        }
    }

    // [{"panel", "edge", KEY: ...}]: the fields of the seams at those edges that are keys.
    void read_seam_fields(const Node& seams) {
        if (!expect(seams, Json::Kind::Array)) return;
        std::set<const Seam*> listed;
        for (std::size_t i = 0; i < seams.size(); ++i) {
            Seam* seam = read_seam_at(seams.element(i));
            if (!seam) continue;
            if (!listed.insert(seam).second) error(seams.element(i), "the seam is listed already");
            FieldReader(*this).read(seams.element(i), *seam, keys_of<SeamSide>(kEach));
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

    // The same, of an object with nothing else.
    Seam* read_named_seam(const Node& node) {
        if (node.value->is_object()) warn_of_unknown_keys(node, keys_of<SeamSide>(kEach));
        return read_seam_at(node);
    }

    Node root_;
    PatternReading out_;
    bool is_relative_ = true;
    std::map<std::string, int> panel_index_;
    std::map<SeamSide, std::string> sewn_;       // where in the file each edge is sewn
    std::map<SeamSide, std::size_t> seam_at_{};  // index into Pattern::seams
    std::vector<Mirror> mirrors_, copies_;
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
        if (const JsonNode own = node.member("selvedge"); own && reader_.expect(own, Json::Kind::Object))
            FieldReader(reader_, &panel_).read(own, edge);
        if (!start || !end) return;
        edge.start = *start;
        edge.end = *end;
        if (*start == *end) return reader_.error(endpoints, "the edge starts and ends at the same vertex");
        const JsonNode curvature = node.member("curvature");
        if (curvature && !curvature.value->is_null()) read_curvature(curvature, edge);
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
    flip_fields(panel);
}

}  // namespace selvedge::sim

#include "sim/pattern/pattern_file.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/file_path.h"
#include "sim/core/json.h"
#include "sim/core/math.h"
#include "sim/pattern/edge_keys.h"
#include "sim/pattern/enum_names.h"
#include "sim/pattern/field_write.h"
#include "sim/pattern/named_file.h"
#include "sim/pattern/pattern_fields.h"
#include "sim/pattern/pattern_read.h"
#include "sim/pattern/sources.h"

namespace selvedge::sim {
namespace {

// The garment's name from its file name: "patterns/shirt_mean_specification.json" gives "shirt_mean", and so does
// "shirt_mean.garment.json".
std::string garment_name(const std::string& file) {
    std::string name = std::filesystem::path(file).stem().string();
    for (const std::string_view suffix : {"_specification", ".garment"}) {
        if (name.size() > suffix.size() && name.ends_with(suffix)) name.resize(name.size() - suffix.size());
    }
    return name;
}

// Warns of links that end when the pattern is edited. It keeps them here.
void check_links(PatternReading& reading, const std::string& file) {
    if (!has_links(reading.pattern)) return;
    Pattern pattern = reading.pattern;
    for (EndedLink& link : end_broken_links(pattern)) {
        reading.faults.push_back(
            {Severity::Warning, file, json_path("pattern.panels", link.panel), std::move(link.problem)});
    }
}

PatternReading examine(const Json& json, const std::string& file) {
    PatternReading reading = read_pattern(json, file);
    check_shapes(reading, file, units_in_meter(json));
    reading.pattern.name = garment_name(file);
    resolve_named_files(reading.pattern, file);
    if (!has_error(reading.faults)) check_links(reading, file);
    return reading;
}

PatternDocument accept(Json json, const std::string& file) {
    PatternReading reading = examine(json, file);
    for (const Fault& fault : reading.faults) {
        if (fault.severity == Severity::Error) throw InputError(fault.file, fault.place, fault.problem);
    }
    return {std::move(reading.pattern), std::move(json), std::move(reading.faults)};
}

// Smaller than what JSON may be otherwise: a pattern takes many times its file in memory.
Json read_document(const std::filesystem::path& path) {
    constexpr std::size_t kMostBytes = std::size_t{16} << 20;
    return parse_json(read_file(path, kMostBytes), path.string());
}

template <class ReadJson>
std::vector<Fault> check(const std::string& file, ReadJson read_json_of_file) {
    try {
        return examine(read_json_of_file(), file).faults;
    } catch (const InputError& error) {
        return {{Severity::Error, error.file(), error.place(), error.problem()}};
    }
}

}  // namespace

PatternDocument load_pattern(const std::filesystem::path& path) {
    return accept(read_document(path), path.string());
}

PatternDocument parse_pattern(std::string_view text, const std::string& file) {
    return accept(parse_json(text, file), file);
}

std::vector<Fault> check_pattern_file(const std::filesystem::path& path) {
    return check(path.string(), [&] { return read_document(path); });
}

std::vector<Fault> check_pattern_text(std::string_view text, const std::string& file) {
    return check(file, [&] { return parse_json(text, file); });
}

std::optional<std::string> newer_format(const Json& root) {
    const Json* own = root.find("selvedge");
    const Json* format = own ? own->find("format") : nullptr;
    if (!format || !format->is_number() || !(format->number() > kGarmentFormat)) return {};
    return "written by a newer program, in format " + format->number_text() + "; this one knows formats up to " +
           std::to_string(kGarmentFormat) + " and would lose what is new in it";
}

std::string write_pattern(const PatternDocument& document, const std::filesystem::path& file) {
    return write_json(pattern_as_json(document.pattern, document.json, file));
}

namespace {

// What stands at the path, if it is a garment of a newer program. What cannot be read is none.
std::optional<std::string> newer_garment_at(const std::filesystem::path& path) {
    if (!is_file(path)) return {};
    try {
        return newer_format(read_document(path));
    } catch (const InputError&) {
        return {};
    }
}

}  // namespace

void save_pattern(const PatternDocument& document, const std::filesystem::path& path) {
    if (const auto newer = newer_format(document.json)) throw InputError(path.string(), "selvedge.format", *newer);
    if (const auto newer = newer_garment_at(path))
        throw InputError(path.string(), "selvedge.format", "not written over: the garment there was " + *newer);
    write_file_atomically(path, write_pattern(document, path));
}

namespace {

void set_numbers(Json& place, std::initializer_list<double> values) {
    if (!place.is_array()) place = Json::array();
    place.elements().resize(values.size());
    std::size_t i = 0;
    for (const double value : values) set_number(place.elements()[i++], value);
}

// Does not add a key whose value is the default `usual`; updates a key that exists.
template <class T>
void set_unless_default(Json& object, const char* key, const T& value, const T& usual) {
    if (value == usual && !object.find(key)) return;
    object[key] = Json(value);
}

void set_number_unless_zero(Json& object, const char* key, double value) {
    if (value == 0 && !object.find(key)) return;
    set_number(object[key], value);
}

template <auto kMember>
using ByHand = Field<kMember, FileForm::ByHand>;

class Writer {
 public:
    Writer(const Pattern& pattern, const Json& base, const std::filesystem::path& file)
        : pattern_(pattern),
          root_(base.is_object() ? base : Json::object()),
          file_(file),
          units_(units_in_meter(root_)) {}

    Json write() {
        if (!root_.find("pattern")) begin_specification();
        Json& garment = root_["pattern"];
        write_panels(garment["panels"]);
        write_seams(garment["stitches"]);
        if (Json* order = garment.find("panel_order")) write_panel_order(*order);
        write_garment_additions();
        return std::move(root_);
    }

 private:
    void begin_specification() {
        Json& garment = root_["pattern"];
        garment["panels"] = Json::object();
        garment["stitches"] = Json::array();
        garment["panel_order"] = Json::array();
        root_["parameters"] = Json::object();
        root_["parameter_order"] = Json::array();
        Json& properties = root_["properties"];
        properties["curvature_coords"] = "relative";
        properties["normalize_panel_translation"] = false;
        properties["normalized_edge_loops"] = true;
        properties["units_in_meter"] = 100;
    }

    bool is_relative() const {
        const Json* properties = root_.find("properties");
        const Json* coords = properties ? properties->find("curvature_coords") : nullptr;
        return !coords || !coords->is_string() || coords->string() != "absolute";
    }

    Vec2d in_file(const Panel& panel, const Vec2d& p) const {
        return units_ * Vec2d(panel.is_mirrored ? -p.x() : p.x(), p.y());
    }

    void write_panels(Json& panels) {
        if (!panels.is_object()) panels = Json::object();
        std::map<std::string, const Panel*> by_name;
        for (const Panel& panel : pattern_.panels) by_name[panel.name] = &panel;
        std::erase_if(panels.members(), [&](const Json::Member& member) { return !by_name.contains(member.key); });
        for (Json::Member& member : panels.members()) {
            write_panel(member.value, *by_name[member.key]);
            by_name.erase(member.key);
        }
        for (const Panel& panel : pattern_.panels) {
            if (by_name.contains(panel.name)) write_panel(panels[panel.name], panel);
        }
    }

    void write_panel(Json& json, const Panel& panel) {
        const Vec3d shift = units_ * panel.translation;
        if (json.find("translation") || !shift.isZero(0)) {
            set_numbers(json["translation"], {shift.x(), shift.y(), shift.z()});
        }
        write_rotation(json, panel);
        write_vertices(json["vertices"], panel);
        write_edges(json["edges"], panel);
        if (const Json* label = json.find("label"); !label || label->is_string())
            set_unless_default(json, "label", panel.label, std::string());
        write_panel_additions(json, panel);
    }

    // Keeps the file's angles if they give the panel's rotation, because several triples give the same rotation.
    void write_rotation(Json& json, const Panel& panel) {
        Vec3d angles = Vec3d::Zero();
        if (const Json* rotation = json.find("rotation")) {
            for (Eigen::Index i = 0; i < 3; ++i) {
                angles[i] = rotation->elements()[static_cast<std::size_t>(i)].number();
            }
        }
        if (rotation_from_degrees(angles).isApprox(panel.rotation, 1e-12)) return;
        const Vec3d zyx = panel.rotation.eulerAngles(2, 1, 0) / kDegree;
        set_numbers(json["rotation"], {zyx[2], zyx[1], zyx[0]});
    }

    void write_vertices(Json& json, const Panel& panel) {
        if (!json.is_array()) json = Json::array();
        json.elements().resize(panel.vertices.size());
        for (std::size_t i = 0; i < panel.vertices.size(); ++i) {
            const Vec2d p = in_file(panel, panel.vertices[i]);
            set_numbers(json.elements()[i], {p.x(), p.y()});
        }
    }

    void write_edges(Json& json, const Panel& panel) {
        if (!json.is_array()) json = Json::array();
        json.elements().resize(panel.edges.size());
        for (std::size_t i = 0; i < panel.edges.size(); ++i) {
            const OutlineEdge& edge = panel.edges[i];
            Json& place = json.elements()[i];
            if (!place.is_object()) place = Json::object();
            set_numbers(place["endpoints"], {double(edge.start), double(edge.end)});
            set_unless_default(place, "label", edge.label, std::string());
            write_additions(place, [&](Json& own) { values_of(panel).write(own, edge); });
            write_curvature(place, panel, edge);
        }
    }

    FieldWriter values_of(const Panel& panel) const { return FieldWriter(units_, panel.is_mirrored, file_); }

    // Additions are under the key `selvedge` of a panel, an edge or the file, which is created only if it has members.
    template <class Write>
    static void write_additions(Json& object, const Write& write) {
        const Json* found = object.find("selvedge");
        Json own = found ? *found : Json::object();
        write(own);
        if (found || !own.members().empty()) object["selvedge"] = std::move(own);
    }

    void write_curvature(Json& place, const Panel& panel, const OutlineEdge& edge) {
        if (edge.kind == CurveKind::Line) {
            if (const Json* curvature = place.find("curvature"); curvature && !curvature->is_null()) {
                place.erase("curvature");
            }
            return;
        }
        Json& curvature = place["curvature"];
        if (edge.kind == CurveKind::Quadratic && curvature.is_array()) return write_control(curvature, panel, edge, 0);
        if (!curvature.is_object()) curvature = Json::object();
        curvature["type"] = edge.kind == CurveKind::Arc     ? "circle"
                            : edge.kind == CurveKind::Cubic ? "cubic"
                                                            : "quadratic";
        Json& params = curvature["params"];
        if (!params.is_array()) params = Json::array();
        if (edge.kind == CurveKind::Arc) return write_arc(params, panel, edge);
        const std::size_t count = edge.kind == CurveKind::Cubic ? 2 : 1;
        params.elements().resize(count);
        for (std::size_t i = 0; i < count; ++i) write_control(params.elements()[i], panel, edge, i);
    }

    void write_control(Json& place, const Panel& panel, const OutlineEdge& edge, std::size_t which) {
        const Vec2d control = in_file(panel, edge.control[which]);
        if (!is_relative()) return set_numbers(place, {control.x(), control.y()});
        const Vec2d start = in_file(panel, panel.vertices[static_cast<std::size_t>(edge.start)]);
        const Vec2d chord = in_file(panel, panel.vertices[static_cast<std::size_t>(edge.end)]) - start;
        const Vec2d offset = control - start;
        const double squared = chord.squaredNorm();
        set_numbers(place, {offset.dot(chord) / squared, cross2(chord, offset) / squared});
    }

    void write_arc(Json& params, const Panel& panel, const OutlineEdge& edge) {
        std::vector<Json>& values = params.elements();
        values.resize(3);
        set_number(values[0], units_ * edge.arc_radius);
        set_flag(values[1], edge.is_large_arc);
        set_flag(values[2], edge.turns_right == panel.is_mirrored);
    }

    static void set_flag(Json& place, bool value) {
        if (place.is_bool()) {
            place = Json(value);
        } else {
            set_number(place, value ? 1 : 0);
        }
    }

    void write_panel_additions(Json& json, const Panel& panel) {
        static const Panel usual;
        const FieldWriter values = values_of(panel);
        write_additions(json, [&](Json& own) {
            visit_fields(panel, [&]<class SomeField>(const SomeField& field, const auto& value) {
                if constexpr (SomeField::is_key) {
                    values.write_field(own, field, value, usual.*SomeField::member);
                } else if constexpr (requires { this->write_by_hand(field, own, panel); }) {
                    write_by_hand(field, own, panel);
                }
            });
        });
    }

    void write_by_hand(const ByHand<&Panel::interlinings>&, Json& own, const Panel& panel) const {
        if (own.find("interlinings") || !panel.interlinings.empty()) write_interlinings(own["interlinings"], panel);
    }
    void write_by_hand(const ByHand<&Panel::surface>&, Json& own, const Panel& panel) const {
        write_surface(own, panel.surface);
    }
    void write_by_hand(const ByHand<&Panel::wrap_cone>&, Json& own, const Panel& panel) const {
        if (!panel.wrap_cone) return own.erase("wrap_cone");
        Json& bent = own["wrap_cone"];
        if (!bent.is_object()) bent = Json::object();
        const Vec2d apex = in_file(panel, panel.wrap_cone->apex);
        set_numbers(bent["apex"], {apex.x(), apex.y()});
        set_number(bent["sine"], panel.wrap_cone->sine);
    }
    void write_by_hand(const ByHand<&Panel::mirror_of>&, Json& own, const Panel& panel) const {
        if (panel.mirror_of.empty()) return own.erase("mirror_of");
        own["mirror_of"] = Json(panel.mirror_of);
    }
    void write_by_hand(const ByHand<&Panel::copy_of>&, Json& own, const Panel& panel) const {
        if (panel.copy_of.empty()) return own.erase("copy_of");
        own["copy_of"] = Json(panel.copy_of);
    }

    void write_by_hand(const ByHand<&Panel::fold_key>&, Json& own, const Panel& panel) const {
        if (panel.fold_key == 0) return own.erase("fold_key");
        set_number(own["fold_key"], panel.fold_key);
    }

    // The keys of derived panels are those of their sources, and plain ones are the edges' numbers.
    static bool has_written_keys(const Panel& panel) {
        return !link_of(panel) && has_keys(panel) && !has_plain_keys(panel);
    }

    void write_by_hand(const ByHand<&Panel::last_key>&, Json& own, const Panel& panel) const {
        if (!has_written_keys(panel)) return own.erase("edge_keys");
        Json& keys = own["edge_keys"];
        if (!keys.is_object()) keys = Json::object();
        set_number(keys["last"], panel.last_key);
        Json& list = keys["keys"];
        if (!list.is_array()) list = Json::array();
        list.elements().resize(panel.edges.size());
        for (std::size_t e = 0; e < panel.edges.size(); ++e) {
            const EdgeKey& key = panel.edges[e].key;
            const bool is_drawn = key.role == EdgeRole::Drawn;
            if (list.elements()[e].is_object() == is_drawn) list.elements()[e] = is_drawn ? Json() : Json::object();
            set_number(is_drawn ? list.elements()[e] : list.elements()[e][std::string(name_of_value(key.role))],
                       key.number);
        }
    }

    void write_seams(Json& json) {
        if (!json.is_array()) json = Json::array();
        json.elements().resize(pattern_.seams.size());
        for (std::size_t i = 0; i < pattern_.seams.size(); ++i) {
            const Seam& seam = pattern_.seams[i];
            Json& place = json.elements()[i];
            if (!place.is_array()) place = Json::array();
            place.elements().resize(joins_right_to_wrong(seam) ? 3 : 2);
            write_side(place.elements()[0], seam.first);
            write_side(place.elements()[1], seam.second);
            if (joins_right_to_wrong(seam)) place.elements()[2] = "right_wrong";
        }
    }

    void write_side(Json& json, const SeamSide& side) const {
        if (!json.is_object()) json = Json::object();
        json["panel"] = pattern_.panels[static_cast<std::size_t>(side.panel)].name;
        set_number(json["edge"], side.edge);
    }

    // Removes the names of deleted panels and appends the names of new ones.
    void write_panel_order(Json& order) {
        if (!order.is_array()) return;
        const auto is_listed = [&](const std::string& name) {
            return std::any_of(order.elements().begin(), order.elements().end(),
                               [&](const Json& element) { return element.is_string() && element.string() == name; });
        };
        std::erase_if(order.elements(), [&](const Json& element) {
            return element.is_string() &&
                   std::none_of(pattern_.panels.begin(), pattern_.panels.end(),
                                [&](const Panel& panel) { return panel.name == element.string(); });
        });
        for (const Panel& panel : pattern_.panels) {
            if (!is_listed(panel.name)) order.push_back(panel.name);
        }
    }

    void write_garment_additions() {
        static const Pattern usual;
        const FieldWriter values(units_, false, file_);
        write_additions(root_, [&](Json& own) {
            write_format(own);
            visit_fields(pattern_, [&]<class SomeField>(const SomeField& field, const auto& value) {
                if constexpr (SomeField::is_key) {
                    values.write_field(own, field, value, usual.*SomeField::member);
                } else if constexpr (requires { this->write_by_hand(field, own, pattern_); }) {
                    write_by_hand(field, own, pattern_);
                }
            });
        });
    }

    // Older programs would misread links to copies, and keys of edges whose outline they change.
    void write_format(Json& own) const {
        const bool is_needed = std::ranges::any_of(
            pattern_.panels, [](const Panel& panel) { return !panel.copy_of.empty() || has_written_keys(panel); });
        if (newer_format(root_)) return;
        Json* found = own.find("format");
        if (is_needed) own["format"] = Json(kGarmentFormat);
        if (!is_needed && found && found->is_number() && found->number() == kGarmentFormat) own.erase("format");
    }

    void write_by_hand(const ByHand<&Pattern::surface>&, Json& own, const Pattern& pattern) const {
        write_surface(own, pattern.surface);
    }
    void write_by_hand(const ByHand<&Pattern::matched_sett>&, Json& own, const Pattern&) const {
        write_matched_sett(own);
    }
    void write_by_hand(const ByHand<&Pattern::seams>&, Json& own, const Pattern&) const {
        write_seam_names(own);
        write_listed(own, "eased", [](const Seam& seam) { return seam.is_eased; });
        write_sewings(own);
        write_seam_fields(own);
    }
    void write_by_hand(const ByHand<&Pattern::body>&, Json& own, const Pattern& pattern) const {
        if (is_body_file(pattern.body)) return set_named_file(own["body"], pattern.body, file_);
        set_unless_default(own, "body", pattern.body, std::string());
    }
    void write_by_hand(const ByHand<&Pattern::underlays>&, Json& own, const Pattern&) const { write_underlays(own); }

    void write_interlinings(Json& json, const Panel& panel) const {
        if (!json.is_array()) json = Json::array();
        json.elements().resize(panel.interlinings.size());
        for (std::size_t i = 0; i < panel.interlinings.size(); ++i)
            set_fabric(json.elements()[i], panel.interlinings[i], file_);
    }

    void write_underlays(Json& own) const {
        if (pattern_.underlays.empty()) return own.erase("underlays");
        Json& list = own["underlays"];
        if (!list.is_array()) list = Json::array();
        list.elements().resize(pattern_.underlays.size());
        for (std::size_t i = 0; i < pattern_.underlays.size(); ++i) {
            const Underlay& underlay = pattern_.underlays[i];
            Json& place = list.elements()[i];
            if (!place.is_object()) place = Json::object();
            set_named_file(place["file"], underlay.file, file_);
            set_numbers(place["position"], {units_ * underlay.position.x(), units_ * underlay.position.y()});
            set_number(place["pixel_size"], units_ * underlay.pixel_size);
            set_number_unless_zero(place, "rotation", underlay.rotation / kDegree);
            set_number(place["opacity"], underlay.opacity);
        }
    }

    void write_surface(Json& own, const std::optional<SurfaceDesign>& surface) const {
        if (!surface) return own.erase("surface");
        Json& place = own["surface"];
        if (!place.is_object()) place = Json::object();
        place["kind"] = std::string(name_of_value(surface->kind));
        const auto keep = [&](const char* key, DesignKind kind, const std::string& text) {
            if (surface->kind != kind || text.empty()) return place.erase(key);
            place[key] = text;
        };
        keep("tartan", DesignKind::Tartan, surface->source);
        keep("colour", DesignKind::Colour, surface->source);
        if (surface->kind == DesignKind::Picture) set_named_file(place["file"], surface->source, file_);
        if (surface->kind != DesignKind::Picture) place.erase("file");
        if (!surface->size) place.erase("size");
        if (surface->size) set_number(place["size"], units_ * *surface->size);
        const Vec2d position = units_ * surface->position;
        if (place.find("position") || !position.isZero(0)) set_numbers(place["position"], {position.x(), position.y()});
        set_number_unless_zero(place, "rotation", surface->rotation / kDegree);
        if (place.find("repeats") || !surface->is_repeated) place["repeats"] = Json(surface->is_repeated);
        set_unless_default(place, "ground", surface->ground, std::string());
    }

    void write_matched_sett(Json& own) const {
        if (!pattern_.matched_sett) return own.erase("matched_sett");
        const MatchedSett& matched = *pattern_.matched_sett;
        Json& json = own["matched_sett"];
        if (!json.is_object()) json = Json::object();
        set_unless_default(json, "tartan", matched.tartan, std::string());
        set_numbers(json["repeat"], {units_ * matched.repeat.x(), units_ * matched.repeat.y()});
    }

    // Keeps an existing entry that refers to either side of its seam.
    void write_seam_names(Json& own) const {
        std::map<std::string, const Seam*> by_name;
        for (const Seam& seam : pattern_.seams) {
            if (!seam.name.empty()) by_name[seam.name] = &seam;
        }
        if (by_name.empty()) return own.erase("seam_names");
        Json& names = own["seam_names"];
        if (!names.is_object()) names = Json::object();
        std::erase_if(names.members(), [&](const Json::Member& member) { return !by_name.contains(member.key); });
        for (const auto& [name, seam] : by_name) {
            Json& place = names[name];
            if (!is_at(place, seam->first) && !is_at(place, seam->second)) write_side(place, seam->first);
        }
    }

    void write_sewings(Json& own) const {
        std::set<std::string> names;
        for (const Seam& seam : pattern_.seams) {
            if (!seam.sewing.empty()) names.insert(seam.sewing);
        }
        if (names.empty()) return own.erase("sewings");
        Json& sewings = own["sewings"];
        if (!sewings.is_object()) sewings = Json::object();
        std::erase_if(sewings.members(), [&](const Json::Member& member) { return !names.contains(member.key); });
        for (const std::string& name : names) {
            write_listed(sewings, name, [&](const Seam& seam) { return seam.sewing == name; });
        }
    }

    // Lists the seams that `is_listed` tells, each by one of its edges. Keeps existing entries of theirs, which may
    // refer to either side, in their order; appends new ones.
    template <class Listed>
    void write_listed(Json& own, const std::string& key, const Listed& is_listed) const {
        Json* found = own.find(key);
        Json list = found && found->is_array() ? *found : Json::array();
        const auto is_of = [&](const Seam& seam, const Json& json) {
            return is_listed(seam) && (is_at(json, seam.first) || is_at(json, seam.second));
        };
        const std::size_t removed = std::erase_if(list.elements(), [&](const Json& json) {
            return std::none_of(pattern_.seams.begin(), pattern_.seams.end(),
                                [&](const Seam& seam) { return is_of(seam, json); });
        });
        for (const Seam& seam : pattern_.seams) {
            const std::vector<Json>& listed = list.elements();
            if (!is_listed(seam) ||
                std::any_of(listed.begin(), listed.end(), [&](const Json& json) { return is_of(seam, json); })) {
                continue;
            }
            Json place;
            write_side(place, seam.first);
            list.push_back(std::move(place));
        }
        if (list.elements().empty() && (removed > 0 || !found)) return own.erase(key);
        own[key] = std::move(list);
    }

    // The fields of seams that are keys, each with one of the seam's edges. Keeps existing entries of seams that are
    // still there; removes one that has nothing left to say.
    void write_seam_fields(Json& own) const {
        const Json* found = own.find("seams");
        Json list = found && found->is_array() ? *found : Json::array();
        std::vector<Json>& entries = list.elements();
        const auto is_of = [&](const Seam& seam, const Json& entry) {
            return is_at(entry, seam.first) || is_at(entry, seam.second);
        };
        std::erase_if(entries, [&](const Json& entry) {
            return std::ranges::none_of(pattern_.seams, [&](const Seam& seam) { return is_of(seam, entry); });
        });
        const FieldWriter values(units_, false, file_);
        for (const Seam& seam : pattern_.seams) {
            const auto old = std::ranges::find_if(entries, [&](const Json& entry) { return is_of(seam, entry); });
            Json entry;
            write_side(entry, seam.first);
            const std::size_t bare = entry.members().size();
            if (old != entries.end()) entry = *old;
            const std::size_t before = entry.members().size();
            values.write(entry, seam);
            const bool is_bare = entry.members().size() == bare;
            if (old != entries.end()) *old = entry;
            if (old == entries.end() && !is_bare) entries.push_back(entry);
            if (old != entries.end() && is_bare && before > bare) entries.erase(old);
        }
        if (entries.empty()) return own.erase("seams");
        own["seams"] = std::move(list);
    }

    bool is_at(const Json& json, const SeamSide& side) const {
        const Json* panel = json.find("panel");
        const Json* edge = json.find("edge");
        return panel && edge && panel->is_string() && edge->is_number() && edge->number() == side.edge &&
               panel->string() == pattern_.panels[static_cast<std::size_t>(side.panel)].name;
    }

    const Pattern& pattern_;
    Json root_;
    const std::filesystem::path& file_;
    double units_;
};

}  // namespace

Json pattern_as_json(const Pattern& pattern, const Json& base, const std::filesystem::path& file) {
    return Writer(pattern, base, file).write();
}

}  // namespace selvedge::sim

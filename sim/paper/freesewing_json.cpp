#include "sim/paper/freesewing_json.h"

#include <array>

#include "sim/paper/freesewing_lines.h"
#include "sim/paper/path_builder.h"

namespace selvedge::sim {
namespace {

constexpr double kMm = 0.001;               // m
constexpr double kShortestLine = 1e-3;      // mm, of an edge
constexpr double kLargestCoordinate = 1e5;  // mm, of a coordinate

Vec2d read_point(const JsonView& view) {
    return {view.at(std::size_t{0}).number_between(-kLargestCoordinate, kLargestCoordinate),
            view.at(std::size_t{1}).number_between(-kLargestCoordinate, kLargestCoordinate)};
}

void read_operation(const JsonView& op, PathBuilder& pen) {
    const std::string type = op.at("type").string();
    if (type == "move") return pen.move(read_point(op.at("to")));
    if (type == "line") return pen.line(read_point(op.at("to")));
    if (type == "close") return pen.close();
    if (type == "noop") return;  // a place where an option adds nothing
    if (type != "curve") op.fail("'" + type + "' is none of move, line, curve, close");
    pen.cubic(read_point(op.at("cp1")), read_point(op.at("cp2")), read_point(op.at("to")));
}

std::string text_of(const JsonView& view, const char* key) {
    return view.has(key) && view.at(key).value().is_string() ? view.at(key).string() : std::string();
}

void read_path(const JsonView& view, const std::string& name, DrawnPart& part) {
    if (!view.has("ops")) return;
    PathBuilder pen;
    const JsonView ops = view.at("ops");
    for (std::size_t i = 0; i < ops.size(); ++i) read_operation(ops.at(i), pen);
    for (DrawnPath& path : pen.take(kShortestLine, kShortestLine)) {
        path.kind = kind_of({.classes = text_of(view, "class"),
                             .name = name + " " + text_of(view, "text"),
                             .is_closed = path.is_closed});
        path.name = name;
        path.place = view.path();
        flip(path);
        part.paths.push_back(std::move(path));
    }
}

void read_snippets(const JsonView& snippets, DrawnPart& part) {
    for (const std::string& key : snippets.keys()) {
        const JsonView view = snippets.at(key);
        DrawnMark mark;
        if (!read_snippet(view.at("def").string(), mark)) continue;
        mark.at = read_point(view.at("at"));
        mark.at.y() = -mark.at.y();
        part.marks.push_back(mark);
    }
}

// "teagan.front" of the design teagan is the front.
std::string short_name(const std::string& name, const std::string& design) {
    return name.starts_with(design + ".") ? name.substr(design.size() + 1) : name;
}

// Lengths only: slopes are in degrees.
void read_measurements(const JsonView& view, Drawing& drawing) {
    for (const std::string& key : view.keys()) {
        if (key == "shoulderSlope") continue;
        drawing.measurements.push_back(
            {key, kMm * view.at(key).number_between(-kLargestCoordinate, kLargestCoordinate)});
    }
}

}  // namespace

bool looks_like_freesewing(const Json& root) {
    return root.is_object() && root.find("parts") && root.find("parts")->is_object();
}

Drawing read_freesewing(const Json& root, const std::string& file) {
    const JsonView view(root, file);
    Drawing drawing;
    drawing.format = "FreeSewing JSON";
    drawing.is_y_down = true;
    drawing.title = text_of(view, "design");
    drawing.metres_per_unit = kMm;
    if (view.has("sa")) drawing.allowance = kMm * view.at("sa").number_between(0, 500);
    if (view.has("measurements")) read_measurements(view.at("measurements"), drawing);
    drawing.measurement_set = text_of(view, "measurementSet");
    const JsonView parts = view.at("parts");
    for (const std::string& name : parts.keys()) {
        const JsonView from = parts.at(name);
        DrawnPart part;
        part.name = short_name(name, drawing.title);
        const JsonView paths = from.at("paths");
        for (const std::string& path : paths.keys()) read_path(paths.at(path), path, part);
        if (from.has("snippets")) read_snippets(from.at("snippets"), part);
        if (!part.paths.empty()) drawing.parts.push_back(std::move(part));
    }
    return drawing;
}

}  // namespace selvedge::sim

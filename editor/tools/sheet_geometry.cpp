#include "editor/tools/sheet_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "editor/geometry/panel_edit.h"
#include "sim/pattern/field_moves.h"
#include "sim/pattern/outline.h"

namespace selvedge::editor {
namespace {

EdgeShape shape_of(const sim::Panel& panel, const sim::OutlineEdge& edge) {
    EdgeShape shape;
    shape.points = outline_polyline(panel, edge, kShapeError);
    shape.reached.push_back(0);
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
        shape.box.extend(shape.points[i]);
        if (i == 0) continue;
        shape.reached.push_back(shape.reached.back() + (shape.points[i] - shape.points[i - 1]).norm());
    }
    shape.length = shape.reached.back();
    return shape;
}

PanelShape shape_of(const sim::Panel& panel) {
    PanelShape shape;
    shape.panel = panel;
    for (const sim::OutlineEdge& edge : panel.edges) {
        shape.edges.push_back(shape_of(panel, edge));
        const EdgeShape& last = shape.edges.back();
        shape.outline.insert(shape.outline.end(), last.points.begin(), last.points.end() - 1);
        shape.box.extend(last.box);
    }
    return shape;
}

// A position on a polyline: the segment and the fraction of its length.
struct Segment {
    std::size_t index = 0;
    double share = 0;
};

Segment segment_at(const EdgeShape& shape, double t) {
    const double wanted = std::clamp(t, 0.0, 1.0) * shape.length;
    const auto above = std::upper_bound(shape.reached.begin() + 1, shape.reached.end() - 1, wanted);
    const auto index = static_cast<std::size_t>(above - shape.reached.begin() - 1);
    const double length = shape.reached[index + 1] - shape.reached[index];
    return {index, length > 0 ? std::clamp((wanted - shape.reached[index]) / length, 0.0, 1.0) : 0};
}

bool is_index(int index, std::size_t size) {
    return index >= 0 && static_cast<std::size_t>(index) < size;
}

}  // namespace

Vec2d EdgeShape::at(double t) const {
    const auto [i, share] = segment_at(*this, t);
    return points[i] + share * (points[i + 1] - points[i]);
}

Vec2d EdgeShape::tangent(double t) const {
    const std::size_t i = segment_at(*this, t).index;
    const Vec2d along = points[i + 1] - points[i];
    const double size = along.norm();
    return size > 0 ? Vec2d(along / size) : Vec2d(0, 0);
}

EdgeHit nearest(const EdgeShape& shape, const Vec2d& u) {
    EdgeHit best{0, shape.points.front(), (u - shape.points.front()).norm()};
    for (std::size_t i = 0; i + 1 < shape.points.size(); ++i) {
        const Vec2d along = shape.points[i + 1] - shape.points[i];
        const double square = along.squaredNorm();
        const double share = square > 0 ? std::clamp((u - shape.points[i]).dot(along) / square, 0.0, 1.0) : 0;
        const Vec2d point = shape.points[i] + share * along;
        const double distance = (u - point).norm();
        if (distance >= best.distance) continue;
        const double reached = shape.reached[i] + share * (shape.reached[i + 1] - shape.reached[i]);
        best = {shape.length > 0 ? reached / shape.length : 0, point, distance};
    }
    return best;
}

bool PanelShape::contains(const Vec2d& u) const {
    return outline.size() > 2 && box.contains(u) && sim::is_inside(u, outline);
}

void SheetGeometry::take(const PanelStates& states) {
    states_ = states;
    for (PanelShape& shape : panels_) {
        shape.is_hidden = states.hidden.contains(shape.panel.name);
        shape.may_be_picked = states.may_be_picked(shape.panel.name);
    }
}

void SheetGeometry::update(const sim::Pattern& pattern, std::uint64_t revision, const PanelStates& states) {
    if (revision_ == revision) {
        if (states_ != states) take(states);
        return;
    }
    revision_ = revision;
    const std::vector<Vec2d> origins = sheet_positions(pattern);
    std::vector<PanelShape> kept = std::move(panels_);
    panels_.clear();
    for (std::size_t i = 0; i < pattern.panels.size(); ++i) {
        const sim::Panel& panel = pattern.panels[i];
        const auto same = std::find_if(kept.begin(), kept.end(), [&](const PanelShape& old) {
            return old.panel.name == panel.name && has_same_outline(old.panel, panel);
        });
        if (same != kept.end()) {
            panels_.push_back(std::move(*same));
            kept.erase(same);
            panels_.back().panel = panel;
        } else {
            panels_.push_back(shape_of(panel));
            panels_.back().outline_version = next_outline_version_++;
        }
        panels_.back().origin = origins[i];
    }
    seams_ = pattern.seams;
    take(states);
}

const PanelShape* SheetGeometry::find(const std::string& panel) const {
    const auto found = std::find_if(panels_.begin(), panels_.end(),
                                    [&](const PanelShape& shape) { return shape.panel.name == panel; });
    return found == panels_.end() ? nullptr : &*found;
}

const EdgeShape* SheetGeometry::edge(const PartRef& ref) const {
    const PanelShape* shape = find(ref.panel);
    if (shape == nullptr || !is_index(ref.index, shape->edges.size())) return nullptr;
    return &shape->edges[static_cast<std::size_t>(ref.index)];
}

std::optional<Vec2d> SheetGeometry::vertex(const PartRef& ref) const {
    const PanelShape* shape = find(ref.panel);
    if (shape == nullptr || !is_index(ref.index, shape->panel.vertices.size())) return {};
    return shape->on_sheet(shape->panel.vertices[static_cast<std::size_t>(ref.index)]);
}

std::optional<int> SheetGeometry::seam_of(const PartRef& edge) const {
    const auto is_it = [&](const sim::SeamSide& side) {
        return side.edge == edge.index && is_index(side.panel, panels_.size()) &&
               panels_[static_cast<std::size_t>(side.panel)].panel.name == edge.panel;
    };
    for (std::size_t i = 0; i < seams_.size(); ++i) {
        if (is_it(seams_[i].first) || is_it(seams_[i].second)) return static_cast<int>(i);
    }
    return {};
}

SheetBox SheetGeometry::box() const {
    SheetBox box;
    for (const PanelShape& shape : panels_) box.extend(shape.sheet_box());
    return box;
}

SheetBox SheetGeometry::drawn_box() const {
    SheetBox box;
    for (const PanelShape& shape : panels_)
        if (!shape.is_hidden) box.extend(shape.sheet_box());
    return box;
}

SheetBox SheetGeometry::box_of(const Selection& selection) const {
    SheetBox box;
    const auto extend_edge = [&](const PartRef& ref) {
        const PanelShape* shape = find(ref.panel);
        if (const EdgeShape* found = edge(ref)) box.extend(SheetBox(found->box).translate(shape->origin));
    };
    for (const std::string& panel : selection.panels) {
        if (const PanelShape* shape = find(panel)) box.extend(shape->sheet_box());
    }
    for (const PartRef& ref : selection.vertices) {
        if (const std::optional<Vec2d> point = vertex(ref)) box.extend(*point);
    }
    for (const PartRef& ref : selection.edges) extend_edge(ref);
    for (const int seam : selection.seams) {
        if (!is_index(seam, seams_.size())) continue;
        for (const sim::SeamSide& side :
             {seams_[static_cast<std::size_t>(seam)].first, seams_[static_cast<std::size_t>(seam)].second}) {
            if (is_index(side.panel, panels_.size())) {
                extend_edge({panels_[static_cast<std::size_t>(side.panel)].panel.name, side.edge});
            }
        }
    }
    return box;
}

Vec2d sheet_point(const PanelShape& shape, int edge, double t) {
    return shape.on_sheet(shape.edges.at(static_cast<std::size_t>(edge)).at(t));
}

namespace {

constexpr double kNotch = 1.18;

Vec2d middle_px(const SheetCamera& camera) {
    return camera.view_low + camera.view_size / 2;
}

}  // namespace

Vec2d to_px(const SheetCamera& camera, const Vec2d& sheet) {
    const Vec2d away = (sheet - camera.centre) * camera.scale;
    return middle_px(camera) + Vec2d(away.x(), -away.y());
}

Vec2d to_sheet(const SheetCamera& camera, const Vec2d& px) {
    const Vec2d away = (px - middle_px(camera)) / camera.scale;
    return camera.centre + Vec2d(away.x(), -away.y());
}

SheetBox visible_box(const SheetCamera& camera) {
    const Vec2d half = camera.view_size / (2 * camera.scale);
    return {camera.centre - half, camera.centre + half};
}

void pan(SheetCamera& camera, const Vec2d& by_px) {
    camera.centre -= Vec2d(by_px.x(), -by_px.y()) / camera.scale;
}

void zoom_at(SheetCamera& camera, const Vec2d& px, double notches) {
    if (!std::isfinite(notches)) return;
    const Vec2d held = to_sheet(camera, px);
    const double factor = std::pow(kNotch, std::clamp(notches, -100.0, 100.0));
    camera.scale = std::clamp(camera.scale * factor, kMinSheetScale, kMaxSheetScale);
    camera.centre += held - to_sheet(camera, px);
}

void frame(SheetCamera& camera, const SheetBox& box, double margin_px) {
    if (box.isEmpty() || !box.min().allFinite() || !box.max().allFinite()) return;
    const Vec2d room = (camera.view_size - Vec2d::Constant(2 * margin_px)).cwiseMax(Vec2d(20, 20));
    const Vec2d size = box.sizes().cwiseMax(Vec2d(0.01, 0.01));
    camera.scale = std::clamp((room.array() / size.array()).minCoeff(), kMinSheetScale, kMaxSheetScale);
    camera.centre = box.center();
}

double grid_step(const SheetCamera& camera, double at_least_px) {
    constexpr std::array<double, 7> steps{0.001, 0.005, 0.01, 0.05, 0.1, 0.5, 1.0};
    for (const double step : steps) {
        if (step * camera.scale >= at_least_px) return step;
    }
    return steps.back();
}

}  // namespace selvedge::editor

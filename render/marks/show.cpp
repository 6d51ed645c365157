#include "render/marks/show.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstdio>
#include <map>

#include "render/draw/edge_marks.h"
#include "render/draw/renderer.h"
#include "render/scene/colour.h"
#include "render/scene/solids.h"
#include "sim/core/assert.h"
#include "sim/core/math.h"
#include "sim/mesh/garment_mesh.h"

namespace selvedge::render {
namespace {

constexpr sim::Rgb8 kQuietCloth{0xEC, 0xE9, 0xE3};
constexpr sim::Rgb8 kHemColour{0x55, 0x55, 0x5A};
constexpr float kBallShare = 0.19F;  // radius of a vertex of level 0 / length of a base edge

// The cloths of a scene that are parts of the first one's garment, such as its panels of another fabric, and all their
// triangles as one mesh: one scale and one legend hold for the whole garment.
struct GarmentParts {
    std::vector<ClothItem*> cloths;
    std::optional<sim::DrawMesh> joined;  // if there are several

    const sim::DrawMesh& mesh() const { return joined ? *joined : cloths.front()->mesh; }
};

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

GarmentParts find_parts(Scene& scene) {
    const sim::DrawMesh& first = scene.cloths.front().mesh;
    GarmentParts parts;
    for (ClothItem& cloth : scene.cloths) {
        if (cloth.mesh.x == first.x && cloth.mesh.panel_names == first.panel_names) parts.cloths.push_back(&cloth);
    }
    if (parts.cloths.size() == 1) return parts;
    parts.joined = first;
    for (std::size_t i = 1; i < parts.cloths.size(); ++i) {
        const sim::DrawMesh& mesh = parts.cloths[i]->mesh;
        append(parts.joined->triangles, mesh.triangles);
        append(parts.joined->u, mesh.u);
        append(parts.joined->panel, mesh.panel);
        append(parts.joined->level, mesh.level);
        append(parts.joined->turned_corners, mesh.turned_corners);
    }
    return parts;
}

// `paint` has the places of all parts' triangles, one part after the other.
void paint_parts(const GarmentParts& parts, const ClothPaint& paint) {
    auto next = paint.places.begin();
    for (ClothItem* cloth : parts.cloths) {
        const auto end = next + static_cast<std::ptrdiff_t>(cloth->mesh.triangles.size());
        cloth->paint = ClothPaint{.map = paint.map, .places = {next, end}};
        next = end;
    }
}

// Position of the i-th of n kinds along their colour map, 0..1.
float place_of(std::size_t i, std::size_t n) {
    return n < 2 ? 0.0F : float(i) / float(n - 1);
}

std::vector<sim::Rgb8> level_colours() {
    std::vector<sim::Rgb8> map;
    map.reserve(kLevelColours);
    for (int level = 0; level < kLevelColours; ++level) map.push_back(level_colour(level));
    return map;
}

std::size_t colour_index(int level) {
    return static_cast<std::size_t>(std::clamp(level, 0, kLevelColours - 1));
}

// One row for each level up to the highest, with its number of elements.
template <class Levels>
std::vector<LegendRow> level_rows(const Levels& levels) {
    std::array<std::size_t, kLevelColours> counts{};
    std::size_t highest = 0;
    for (const auto level : levels) {
        ++counts[colour_index(level)];
        highest = std::max(highest, colour_index(level));
    }
    std::vector<LegendRow> rows;
    for (std::size_t level = 0; level <= highest; ++level)
        rows.push_back({level_colour(static_cast<int>(level)), std::to_string(level), std::to_string(counts[level])});
    return rows;
}

// A mesh that was read from a file has no levels: everything is drawn as level 0.
std::vector<std::array<std::string, 2>> level_notes(bool are_known) {
    if (are_known) return {};
    return {{"levels", "not known"}};
}

std::vector<float> chosen_strain(const sim::DrawMesh& mesh, ShowMode mode) {
    std::vector<float> values;
    for (const sim::MeshStrain& strain : measure_strain(mesh)) {
        const float greater = std::max(strain.warp, strain.weft);
        values.push_back(mode == ShowMode::StrainWarp ? strain.warp
                                                      : (mode == ShowMode::StrainWeft ? strain.weft : greater));
    }
    return values;
}

const char* strain_title(ShowMode mode) {
    if (mode == ShowMode::StrainWarp) return "Strain along the warp";
    if (mode == ShowMode::StrainWeft) return "Strain along the weft";
    return "Strain, the greater";
}

// The map covers 99 % of the values; larger ones get the colours at its ends.
Legend show_strain(const GarmentParts& garment) {
    constexpr double min_limit = 0.01;
    const ShowMode mode = garment.cloths.front()->show;
    const std::vector<float> strain = chosen_strain(garment.mesh(), mode);
    std::vector<double> sizes, values(strain.begin(), strain.end());
    for (const double value : values) sizes.push_back(std::abs(value));
    const double limit = round_up(std::max(sim::quantile(sizes, 0.99), min_limit));
    ClothPaint paint{.map = diverging_map(), .places = smooth_in_panels(garment.mesh(), strain)};
    for (auto& corners : paint.places) {
        for (float& place : corners) place = 0.5F + 0.5F * place / static_cast<float>(limit);
    }
    paint_parts(garment, paint);
    return strain_legend(strain_title(mode), limit, values);
}

Legend show_clearance(const GarmentParts& garment, const std::vector<float>& clearance) {
    SELVEDGE_ASSERT(clearance.size() == garment.mesh().x.size());
    constexpr double min_limit = 0.01;  // m
    const std::vector<double> values(clearance.begin(), clearance.end());
    const double limit = round_up(std::max(sim::quantile(values, 0.95), min_limit));
    ClothPaint paint{.map = sequential_map(), .places = {}};
    for (const auto& [a, b, c] : garment.mesh().triangles) {
        const auto place = [&](std::uint32_t v) { return clearance[v] / static_cast<float>(limit); };
        paint.places.push_back({place(a), place(b), place(c)});
    }
    paint_parts(garment, paint);
    return clearance_legend(limit, values);
}

std::string panel_name(const sim::DrawMesh& mesh, std::size_t panel) {
    if (panel >= mesh.panel_names.size()) return "panel " + std::to_string(panel);
    std::string name = mesh.panel_names[panel];
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

Legend show_panels(const GarmentParts& garment) {
    const sim::DrawMesh& mesh = garment.mesh();
    const std::size_t panels =
        mesh.panel.empty() ? 1 : std::size_t{1} + *std::max_element(mesh.panel.begin(), mesh.panel.end());
    Legend legend{.title = "Panels"};
    ClothPaint paint;
    constexpr std::size_t kMaxColours = 256;  // the map must fit a texture; so many colours look alike anyway
    for (std::size_t panel = 0; panel < panels; ++panel) {
        if (panel < kMaxColours) paint.map.push_back(kind_colour(panel));
        legend.rows.push_back({kind_colour(panel % kMaxColours), panel_name(mesh, panel)});
    }
    if (panels == 1) paint.map.push_back(paint.map.front());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::size_t panel = panel_of(mesh, t);
        const float place = place_of(panel % kMaxColours, paint.map.size());
        paint.places.push_back({place, place, place});
    }
    paint_parts(garment, paint);
    return legend;
}

// For example "left sleeve front + back": leading words that both names share are written only once.
std::string seam_name(const sim::DrawMesh& mesh, const SeamLine& seam) {
    const std::string first = panel_name(mesh, seam.panels[0]), second = panel_name(mesh, seam.panels[1]);
    if (seam.panels[0] == seam.panels[1]) return first;
    std::size_t last_word = 0;
    for (std::size_t i = 0; i < std::min(first.size(), second.size()) && first[i] == second[i]; ++i) {
        if (first[i] == ' ') last_word = i + 1;
    }
    return first + " + " + second.substr(last_word);
}

std::string centimetres(double metres) {
    return std::to_string(std::lround(100 * metres)) + " cm";
}

void add_lines(SolidItem& solid, const sim::DrawMesh& mesh, const SeamLine& line, float radius,
               const sim::Rgb8& colour) {
    for (const VertexPath& path : line.paths) {
        std::vector<Vec3f> points;
        for (const std::uint32_t v : path) points.push_back(mesh.x[v]);
        add_tube(solid, points, radius, colour);
    }
}

Legend show_seams(Scene& scene, const GarmentParts& garment, float radius) {
    for (ClothItem* cloth : garment.cloths) cloth->colour = kQuietCloth;
    const sim::DrawMesh& mesh = garment.mesh();
    const SeamLines lines = find_seam_lines(mesh);
    Legend legend{.title = "Seams and hems"};
    SolidItem solid;
    for (std::size_t i = 0; i < lines.seams.size(); ++i) {
        const SeamLine& seam = lines.seams[i];
        legend.rows.push_back({line_colour(i), seam_name(mesh, seam), centimetres(seam.length)});
        add_lines(solid, mesh, seam, radius, line_colour(i));
    }
    double hems = 0;
    for (const SeamLine& hem : lines.hems) {
        hems += hem.length;
        add_lines(solid, mesh, hem, 0.5F * radius, kHemColour);
    }
    if (!lines.hems.empty()) legend.rows.push_back({kHemColour, "hems", centimetres(hems)});
    scene.solids.push_back(std::move(solid));
    return legend;
}

// m: the median over all triangles' edges of their lengths at level 0 (length x 2^level).
float base_edge(const sim::DrawMesh& mesh) {
    std::vector<double> lengths;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const double halvings = std::exp2(mesh.level.empty() ? 0 : mesh.level[t]);
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3f edge = mesh.x[mesh.triangles[t][(i + 1) % 3]] - mesh.x[mesh.triangles[t][i]];
            lengths.push_back(halvings * static_cast<double>(edge.norm()));
        }
    }
    return static_cast<float>(sim::quantile(lengths, 0.5));
}

std::vector<bool> drawn_vertices(const sim::DrawMesh& mesh) {
    std::vector<bool> is_drawn(mesh.x.size(), false);
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t v : triangle) is_drawn[v] = true;
    }
    return is_drawn;
}

Legend show_vertices(Scene& scene, const GarmentParts& garment) {
    const sim::DrawMesh& mesh = garment.mesh();
    for (ClothItem* cloth : garment.cloths) {
        cloth->colour = kQuietCloth;
        cloth->ink = 0.45F;
    }
    const float radius = kBallShare * base_edge(mesh);
    const std::vector<bool> is_drawn = drawn_vertices(mesh);
    std::vector<std::uint8_t> levels;
    SolidItem solid;
    for (std::size_t v = 0; v < mesh.x.size(); ++v) {
        if (!is_drawn[v]) continue;
        levels.push_back(mesh.vertex_level.empty() ? std::uint8_t{0} : mesh.vertex_level[v]);
        const int level = levels.back();
        add_ball(solid, mesh.x[v], radius * std::exp2(-float(level)), level_colour(level),
                 level < 2 ? BallDetail::Fine : BallDetail::Coarse);
    }
    scene.solids.push_back(std::move(solid));
    return {.title = "Vertices by level", .rows = level_rows(levels), .notes = level_notes(!mesh.vertex_level.empty())};
}

void paint_levels(ClothItem& cloth) {
    ClothPaint paint{.map = level_colours(), .places = {}};
    for (const std::uint8_t level : cloth.mesh.level) {
        const float place = place_of(colour_index(level), paint.map.size());
        paint.places.push_back({place, place, place});
    }
    cloth.paint = std::move(paint);
}

sim::Rgb8 darkened(const sim::Rgb8& colour) {
    Vec3f lab = to_oklab(colour);
    lab[0] *= 0.82F;
    return from_oklab(lab);
}

}  // namespace

bool wants_material(ShowMode mode) {
    return mode == ShowMode::StrainWarp || mode == ShowMode::StrainWeft || mode == ShowMode::Strain;
}

bool is_painted(ShowMode mode) {
    return mode > ShowMode::Plain;
}

std::optional<Legend> fill_show(Scene& scene, const ShowInput& facts) {
    const ShowMode mode = scene.cloths.front().show;
    if (!is_painted(mode) && mode != ShowMode::Level) return std::nullopt;
    const GarmentParts garment = find_parts(scene);
    SELVEDGE_ASSERT(mode != ShowMode::Hierarchy && (!wants_material(mode) || !garment.mesh().u.empty()));
    switch (mode) {
        case ShowMode::Level:
            return level_legend(garment.mesh());
        case ShowMode::Vertices:
            return show_vertices(scene, garment);
        case ShowMode::StrainWarp:
        case ShowMode::StrainWeft:
        case ShowMode::Strain:
            return show_strain(garment);
        case ShowMode::Clearance:
            return show_clearance(garment, facts.clearance);
        case ShowMode::Panels:
            return show_panels(garment);
        case ShowMode::Seams:
            return show_seams(scene, garment, facts.line_radius);
        default:
            return std::nullopt;
    }
}

Legend fill_hierarchy(Scene& scene, const sim::TriangleHierarchy& hierarchy, StackSide side, const ShowInput& facts) {
    HierarchyModel model = model_hierarchy(hierarchy, side);
    ClothItem cloth;
    cloth.mesh = std::move(model.mesh);
    cloth.show = ShowMode::Hierarchy;
    cloth.ink = 0.75F;
    paint_levels(cloth);
    scene.cloths = {std::move(cloth)};
    SolidItem solid;
    for (const HierarchyModel::Outline& outline : model.refined)
        add_outline(solid, outline.x, facts.line_radius, darkened(level_colour(outline.level)));
    scene.solids = {std::move(solid)};

    std::vector<std::uint8_t> levels;
    std::size_t leaves = 0;
    for (const sim::HierarchyTriangle& t : hierarchy) {
        levels.push_back(t.level);
        leaves += t.is_leaf ? 1 : 0;
    }
    return {.title = "Triangles by level",
            .rows = level_rows(levels),
            .notes = {{"in all", std::to_string(hierarchy.size())}, {"leaves", std::to_string(leaves)}}};
}

Legend level_legend(const sim::DrawMesh& mesh) {
    if (!mesh.level.empty()) return {.title = "Triangles by level", .rows = level_rows(mesh.level)};
    return {.title = "Triangles by level",
            .rows = level_rows(std::vector<int>(mesh.triangles.size(), 0)),
            .notes = level_notes(false)};
}

namespace {

// Without trailing zeros: 5, 2.5, 0.15.
std::string short_number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", value);
    return text.data();
}

std::string percent(double strain) {
    std::array<char, 32> text{};
    const double tenths = std::round(1000 * strain);
    std::snprintf(text.data(), text.size(), "%+.1f %%", tenths == 0 ? 0.0 : tenths / 10);
    return text.data();
}

std::string millimetres(double metres) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), std::abs(metres) < 0.00995 ? "%.1f mm" : "%.0f mm", 1000 * metres);
    return text.data();
}

}  // namespace

double round_up(double value) {
    SELVEDGE_ASSERT(value > 0 && std::isfinite(value));
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double step : {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0}) {
        if (value <= step * power * (1 + 1e-6)) return step * power;
    }
    return 10 * power;
}

Legend strain_legend(const std::string& title, double limit, const std::vector<double>& strains) {
    const std::string end = short_number(100 * limit);
    return {.title = title,
            .scale = LegendScale{.map = diverging_map(),
                                 .ticks = {{0, "-" + end + " %"}, {0.5F, "0"}, {1, "+" + end + " %"}}},
            .notes = {{"99th percentile", percent(sim::quantile(strains, 0.99))},
                      {"largest", percent(*std::max_element(strains.begin(), strains.end()))},
                      {"smallest", percent(*std::min_element(strains.begin(), strains.end()))}}};
}

Legend clearance_legend(double limit, const std::vector<double>& clearances) {
    const std::string half = short_number(500 * limit), end = short_number(1000 * limit);
    Legend legend{.title = "Distance from the body",
                  .scale = LegendScale{.map = sequential_map(), .ticks = {{0, "0"}, {0.5F, half}, {1, end + " mm"}}},
                  .notes = {{"median", millimetres(sim::quantile(clearances, 0.5))},
                            {"99th percentile", millimetres(sim::quantile(clearances, 0.99))},
                            {"largest", millimetres(*std::max_element(clearances.begin(), clearances.end()))}}};
    const double least = *std::min_element(clearances.begin(), clearances.end());
    if (least < 0) legend.notes.push_back({"deepest inside", millimetres(-least)});
    return legend;
}

namespace {

using Panels = std::array<std::uint16_t, 2>;

// One triangle's side of a marked edge, identified by the edge's vertices in ascending order.
struct MarkedSide {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    std::uint16_t panel = 0;

    auto operator<=>(const MarkedSide&) const = default;
};

struct MarkedEdge {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    bool is_taken = false;

    std::uint32_t other(std::uint32_t vertex) const { return vertex == low ? high : low; }
};

using EdgesOfPanels = std::map<Panels, std::vector<MarkedEdge>>;

EdgesOfPanels marked_edges(const sim::DrawMesh& mesh, const std::vector<TriangleMarks>& marks,
                           std::uint32_t TriangleMarks::*kind) {
    std::vector<MarkedSide> sides;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::uint16_t panel = panel_of(mesh, t);
        for (std::size_t edge = 0; edge < 3; ++edge) {
            if ((marks[t].*kind >> edge & 1U) == 0) continue;
            const auto [low, high] = std::minmax(mesh.triangles[t][(edge + 1) % 3], mesh.triangles[t][(edge + 2) % 3]);
            sides.push_back({low, high, panel});
        }
    }
    std::sort(sides.begin(), sides.end());
    EdgesOfPanels edges;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const bool is_second = i > 0 && sides[i].low == sides[i - 1].low && sides[i].high == sides[i - 1].high;
        const bool has_second =
            i + 1 < sides.size() && sides[i].low == sides[i + 1].low && sides[i].high == sides[i + 1].high;
        if (!is_second) {
            const std::uint16_t other = has_second ? sides[i + 1].panel : sides[i].panel;
            edges[{sides[i].panel, other}].push_back({sides[i].low, sides[i].high});
        }
    }
    return edges;
}

// Walks along edges that are not taken yet, and marks them as taken.
class Walker {
 public:
    Walker(const sim::DrawMesh& mesh, std::vector<MarkedEdge>& edges) : mesh_(mesh), edges_(edges) {
        for (std::size_t i = 0; i < edges.size(); ++i) {
            at_[edges[i].low].push_back(i);
            at_[edges[i].high].push_back(i);
        }
    }

    // All lines. Each starts at its smallest end vertex, or at its smallest vertex if it has no end.
    std::vector<SeamLine> lines(const Panels& panels) {
        std::vector<SeamLine> found;
        for (const auto& [vertex, edges] : at_) {
            if (std::all_of(edges.begin(), edges.end(), [&](std::size_t e) { return edges_[e].is_taken; })) continue;
            found.push_back(line_through(vertex));
            found.back().panels = panels;
        }
        return found;
    }

 private:
    SeamLine line_through(std::uint32_t vertex) {
        const std::vector<std::uint32_t> connected_vertices = connected(vertex);
        SeamLine line;
        for (const bool starts_at_ends : {true, false}) {
            for (const std::uint32_t v : connected_vertices) {
                if (starts_at_ends && at_[v].size() == 2) continue;
                for (VertexPath path = walk(v, line.length); path.size() > 1; path = walk(v, line.length))
                    line.paths.push_back(path);
            }
        }
        return line;
    }

    std::vector<std::uint32_t> connected(std::uint32_t from) {
        std::vector<std::uint32_t> connected_vertices{from};
        for (std::size_t i = 0; i < connected_vertices.size(); ++i) {
            for (const std::size_t e : at_[connected_vertices[i]]) {
                const std::uint32_t next = edges_[e].other(connected_vertices[i]);
                if (reached_.emplace(next, true).second && next != from) connected_vertices.push_back(next);
            }
        }
        std::sort(connected_vertices.begin(), connected_vertices.end());
        return connected_vertices;
    }

    VertexPath walk(std::uint32_t vertex, double& length) {
        VertexPath path{vertex};
        while (true) {
            const std::vector<std::size_t>& edges = at_[vertex];
            const auto free =
                std::find_if(edges.begin(), edges.end(), [&](std::size_t e) { return !edges_[e].is_taken; });
            if (free == edges.end()) return path;
            edges_[*free].is_taken = true;
            const std::uint32_t next = edges_[*free].other(vertex);
            length += static_cast<double>((mesh_.x[next] - mesh_.x[vertex]).norm());
            path.push_back(next);
            vertex = next;
            if (at_[vertex].size() != 2) return path;
        }
    }

    const sim::DrawMesh& mesh_;
    std::vector<MarkedEdge>& edges_;
    std::map<std::uint32_t, std::vector<std::size_t>> at_;
    std::map<std::uint32_t, bool> reached_;
};

std::vector<SeamLine> lines_of(const sim::DrawMesh& mesh, EdgesOfPanels&& all) {
    std::vector<SeamLine> lines;
    for (auto& [panels, edges] : all) {
        std::vector<SeamLine> found = Walker(mesh, edges).lines(panels);
        std::move(found.begin(), found.end(), std::back_inserter(lines));
    }
    return lines;
}

}  // namespace

SeamLines find_seam_lines(const sim::DrawMesh& mesh) {
    const std::vector<TriangleMarks> marks = mark_edges(mesh);
    return {.seams = lines_of(mesh, marked_edges(mesh, marks, &TriangleMarks::seam)),
            .hems = lines_of(mesh, marked_edges(mesh, marks, &TriangleMarks::hem))};
}

}  // namespace selvedge::render

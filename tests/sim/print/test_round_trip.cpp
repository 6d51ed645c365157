// What is written as SVG or DXF is read back: the same outlines, notches, grain, lines and seams.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/paper/drawing_file.h"
#include "sim/paper/make_panels.h"
#include "sim/pattern/edge_shape.h"
#include "sim/pattern/outline.h"
#include "sim/print/dxf_file.h"
#include "sim/print/svg_file.h"
#include "tests/sim/print/sample_pattern.h"
#include "tests/support/darted_panel.h"

namespace selvedge::sim {
namespace {

constexpr double kOff = 5e-5;  // m

// Moves a panel so that its edge 0 begins where the other's does.
Panel moved_to(const Panel& panel, const Panel& other) {
    const Vec2d from = panel.vertices[static_cast<std::size_t>(panel.edges[0].start)];
    const Vec2d to = other.vertices[static_cast<std::size_t>(other.edges[0].start)];
    return mapped_panel(panel, Eigen::Affine2d(Eigen::Translation2d(to - from)));
}

void expect_same_panel(const Panel& drawn, const Panel& original) {
    EXPECT_EQ(drawn.name, original.name);
    EXPECT_EQ(drawn.pieces, original.pieces);
    ASSERT_EQ(drawn.edges.size(), original.edges.size());
    const Panel panel = moved_to(drawn, original);
    for (std::size_t e = 0; e < panel.edges.size(); ++e) {
        EXPECT_EQ(panel.edges[e].kind, original.edges[e].kind) << original.name << " " << e;
        for (int k = 0; k <= 20; ++k) {
            const double t = k / 20.0;
            EXPECT_LT((outline_point(panel, panel.edges[e], t) - outline_point(original, original.edges[e], t)).norm(),
                      kOff)
                << original.name << " edge " << e << " at " << t;
        }
    }
    ASSERT_EQ(panel.notches.size(), original.notches.size());
    for (std::size_t i = 0; i < panel.notches.size(); ++i) {
        EXPECT_EQ(panel.notches[i].edge, original.notches[i].edge);
        EXPECT_EQ(panel.notches[i].kind, original.notches[i].kind);
        EXPECT_EQ(panel.notches[i].count, original.notches[i].count);
        EXPECT_NEAR(panel.notches[i].t, original.notches[i].t, 1e-3);
    }
    // A grain line has no head end.
    EXPECT_NEAR(std::sin(panel.grain_angle - original.grain_angle), 0, 1e-5) << original.name;
    ASSERT_EQ(panel.drill_points.size(), original.drill_points.size());
    for (std::size_t i = 0; i < panel.drill_points.size(); ++i)
        EXPECT_LT((panel.drill_points[i] - original.drill_points[i]).norm(), kOff);
    ASSERT_EQ(panel.internal_lines.size(), original.internal_lines.size());
    for (const InternalLine& line : original.internal_lines) {
        const auto same = std::ranges::find(panel.internal_lines, line.name, &InternalLine::name);
        ASSERT_NE(same, panel.internal_lines.end()) << line.name;
        EXPECT_EQ(same->use, line.use);
        ASSERT_EQ(same->points.size(), line.points.size());
        for (std::size_t i = 0; i < line.points.size(); ++i) EXPECT_LT((same->points[i] - line.points[i]).norm(), kOff);
    }
}

std::vector<Vec2d> pinned_places(const Panel& panel) {
    std::vector<Vec2d> places;
    for (const int pin : panel.pins) places.push_back(panel.vertices[static_cast<std::size_t>(pin)]);
    std::ranges::sort(places, {}, [](const Vec2d& p) { return std::pair(p.x(), p.y()); });
    return places;
}

// Where the panel starts round the body, and how it is worn.
void expect_same_placement(const Panel& read, const Panel& original) {
    ASSERT_EQ(read.edges.size(), original.edges.size());
    for (std::size_t e = 0; e < read.edges.size(); ++e) {
        const Vec2d own = outline_point(read, read.edges[e], 0.3);
        const Vec2d other = outline_point(original, original.edges[e], 0.3);
        EXPECT_LT((own - other).norm(), kOff) << original.name << " " << e;
        EXPECT_LT((read.place(own) - original.place(other)).norm(), kOff) << original.name << " " << e;
    }
    EXPECT_NEAR(read.wrap_radius, original.wrap_radius, 1e-8);
    ASSERT_EQ(read.wrap_cone.has_value(), original.wrap_cone.has_value());
    if (read.wrap_cone) {
        EXPECT_NEAR(read.wrap_cone->sine, original.wrap_cone->sine, 1e-6);
        EXPECT_LT((read.wrap_cone->apex - original.wrap_cone->apex).norm(), kOff);
    }
    EXPECT_EQ(read.is_mirrored, original.is_mirrored);
    EXPECT_EQ(read.layer, original.layer);
    EXPECT_EQ(read.label, original.label);
    EXPECT_EQ(read.is_worn, original.is_worn);
    const std::vector<Vec2d> pins = pinned_places(read), wanted = pinned_places(original);
    ASSERT_EQ(pins.size(), wanted.size());
    for (std::size_t i = 0; i < pins.size(); ++i) EXPECT_LT((pins[i] - wanted[i]).norm(), kOff);
}

void expect_same_placement(const std::string& text, const Pattern& original) {
    const PanelsOfDrawing read = make_panels(parse_drawing(text, "written"), "written");
    ASSERT_TRUE(read.is_placed);
    EXPECT_EQ(read.pattern.body, original.body);
    EXPECT_NEAR(read.pattern.body_height, original.body_height, 1e-6);
    ASSERT_EQ(read.pattern.panels.size(), original.panels.size());
    for (std::size_t p = 0; p < original.panels.size(); ++p)
        expect_same_placement(read.pattern.panels[p], original.panels[p]);
}

void expect_same(const std::string& text, const Pattern& original) {
    const PanelsOfDrawing read = make_panels(parse_drawing(text, "written"), "written");
    ASSERT_EQ(read.pattern.panels.size(), original.panels.size());
    for (std::size_t p = 0; p < original.panels.size(); ++p)
        expect_same_panel(read.pattern.panels[p], original.panels[p]);
    ASSERT_EQ(read.pattern.seams.size(), original.seams.size());
    for (std::size_t s = 0; s < original.seams.size(); ++s) EXPECT_EQ(read.pattern.seams[s], original.seams[s]) << s;
    EXPECT_EQ(read.pattern.size, original.size);
}

std::string svg_of(const Pattern& pattern) {
    return svg_of(pattern, paper_sheet(pattern, paper_pieces(pattern), 1.5));
}

TEST(RoundTrip, svg_gives_the_sample_back) {
    expect_same(svg_of(sample_pattern()), sample_pattern());
}

TEST(RoundTrip, dxf_aama_gives_the_sample_back) {
    expect_same(dxf_of(sample_pattern(), DxfStandard::Aama), sample_pattern());
}

TEST(RoundTrip, dxf_astm_gives_the_sample_back) {
    expect_same(dxf_of(sample_pattern(), DxfStandard::Astm), sample_pattern());
}

TEST(RoundTrip, topstitch_comes_back_from_svg_and_dxf) {
    Pattern pattern = sample_pattern();
    const Topstitch stitches{.distances = {0.006, -0.004},
                             .rows = 2,
                             .stitch_length = 0.0025,
                             .thread = {.colour = "#102030", .thickness = 0.0005}};
    pattern.panels[0].edges[3].topstitch = stitches;
    pattern.panels[1].edges[0].topstitch = Topstitch{};
    pattern.panels[0].internal_lines[1].topstitch = stitches;
    pattern.seams[1].topstitch = stitches;
    for (const std::string& text : {svg_of(pattern), dxf_of(pattern), dxf_of(pattern, DxfStandard::Astm)}) {
        expect_same(text, pattern);
        const Pattern read = make_panels(parse_drawing(text, "written"), "written").pattern;
        EXPECT_EQ(read.panels[0].edges[3].topstitch, stitches);
        EXPECT_EQ(read.panels[0].edges[2].topstitch, std::nullopt);
        EXPECT_EQ(read.panels[1].edges[0].topstitch, Topstitch{});
        for (const InternalLine& line : read.panels[0].internal_lines)
            EXPECT_EQ(line.topstitch.has_value(), line.name == "middle");
    }
}

TEST(RoundTrip, an_elastic_comes_back_from_svg_and_dxf) {
    Pattern pattern = sample_pattern();
    pattern.panels[0].edges[3].elastic = Elastic{.share = 0.65, .stiffness = 12.5};
    for (const std::string& text : {svg_of(pattern), dxf_of(pattern), dxf_of(pattern, DxfStandard::Astm)}) {
        const Pattern read = make_panels(parse_drawing(text, "written"), "written").pattern;
        EXPECT_EQ(read.panels[0].edges[3].elastic, pattern.panels[0].edges[3].elastic);
        EXPECT_EQ(read.panels[0].edges[2].elastic, std::nullopt);
    }
}

TEST(RoundTrip, shipped_patterns_come_back_from_svg_and_dxf) {
    ASSERT_GE(shipped_patterns().size(), 5U);
    for (const std::filesystem::path& file : shipped_patterns()) {
        SCOPED_TRACE(file.filename().string());
        Pattern pattern = load_pattern(file).pattern;
        pattern.allowance = 0.012;
        expect_same(svg_of(pattern), pattern);
        expect_same(dxf_of(pattern), pattern);
    }
}

TEST(RoundTrip, fabrics_that_are_shipped_come_back) {
    Pattern pattern = sample_pattern();
    const auto read_back = [&](const std::string& text) { return make_panels(parse_drawing(text, ""), "").pattern; };
    pattern.fabric = "linen";
    for (const Pattern& read : {read_back(svg_of(pattern)), read_back(dxf_of(pattern))}) {
        EXPECT_EQ(read.fabric, "linen");
        for (const Panel& panel : read.panels) EXPECT_EQ(panel.fabric, "");
    }
    pattern.panels[1].fabric = "denim";
    for (const Pattern& read : {read_back(svg_of(pattern)), read_back(dxf_of(pattern))}) {
        EXPECT_EQ(read.fabric, "");
        EXPECT_EQ(read.panels[0].fabric, "linen");
        EXPECT_EQ(read.panels[1].fabric, "denim");
    }
    // A fabric of one's own is a file elsewhere.
    pattern.panels[1].fabric.clear();
    pattern.fabric = "/fabrics/my_linen.json";
    for (const Pattern& read : {read_back(svg_of(pattern)), read_back(dxf_of(pattern))}) {
        EXPECT_EQ(read.fabric, "");
        EXPECT_TRUE(read.panels[1].fabric.empty() && read.panels[1].is_worn);
    }
}

TEST(RoundTrip, notches_at_corners_keep_their_edge) {
    Pattern pattern = darted_pattern();
    pattern.allowance = 0.01;
    std::vector<Notch>& notches = pattern.panels[0].notches;
    for (int e = 0; e < 10; ++e) {
        notches.push_back({.edge = e, .t = 1});
        notches.push_back({.edge = (e + 1) % 10, .t = 0});
    }
    expect_same(svg_of(pattern), pattern);
    expect_same(dxf_of(pattern), pattern);
}

// Another program's curves of many points are fitted; ours are told by records, and the rest stays as it is.
TEST(RoundTrip, dxf_keeps_the_points_of_internal_lines_and_the_width_of_allowances) {
    Pattern pattern = darted_pattern();
    pattern.allowance = 0.01;
    Panel& panel = pattern.panels[0];
    InternalLine arc{.name = "pocket bag", .points = {}, .use = LineUse::Mark};
    for (int k = 0; k <= 16; ++k) arc.points.push_back(turned_about({0.08, 0.3}, {0.12, 0.3}, 0.1 * k));
    panel.internal_lines = {arc};
    expect_same(dxf_of(pattern), pattern);
    // Beside the cap of a dart the cut line turns by a slight angle only.
    panel.vertices[1] = {0.1, 0};
    panel.vertices[3] = turned_about(panel.vertices[2], panel.vertices[1], 0.06);
    const Panel read = make_panels(parse_drawing(dxf_of(pattern), "written"), "written").pattern.panels[0];
    ASSERT_TRUE(read.allowance);
    for (const OutlineEdge& edge : read.edges) EXPECT_NEAR(edge.allowance.value_or(*read.allowance), 0.01, 1.5e-4);
}

TEST(RoundTrip, darts_with_caps_come_back_from_svg_and_dxf) {
    Pattern pattern = darted_pattern();
    pattern.allowance = 0.01;
    pattern.panels[0].notches = {{.edge = 5, .t = 0.3}, {.edge = 9, .t = 0.5}};
    for (const std::string& text : {svg_of(pattern), dxf_of(pattern)}) {
        expect_same(text, pattern);
        const Panel panel = make_panels(parse_drawing(text, "written"), "written").pattern.panels[0];
        ASSERT_TRUE(panel.allowance);
        EXPECT_NEAR(*panel.allowance, 0.01, 1e-4);
        for (const OutlineEdge& edge : panel.edges) EXPECT_FALSE(edge.allowance);
    }
}

TEST(RoundTrip, allowances_come_back_from_the_distance_of_the_cut_line) {
    const Pattern original = sample_pattern();
    for (const std::string& text : {svg_of(original), dxf_of(original)}) {
        const Panel cap = make_panels(parse_drawing(text, "written"), "written").pattern.panels[0];
        ASSERT_TRUE(cap.allowance);
        EXPECT_NEAR(*cap.allowance, 0.01, 1e-4);
        ASSERT_TRUE(cap.edges[0].allowance);
        EXPECT_NEAR(*cap.edges[0].allowance, 0.03, 1e-4);
        EXPECT_FALSE(cap.edges[1].allowance);
    }
}

TEST(RoundTrip, dxf_tells_sewings_apart_whose_names_it_cannot_hold) {
    Pattern original = sample_pattern();
    original.seams[0].sewing = " ";
    original.seams[1].sewing = std::string(300, 'x') + "A";
    ASSERT_EQ(original.seams.size(), 2U);
    const PanelsOfDrawing read = make_panels(parse_drawing(dxf_of(original), "written"), "written");
    ASSERT_EQ(read.pattern.seams.size(), 2U);
    EXPECT_FALSE(read.pattern.seams[0].sewing.empty());
    EXPECT_FALSE(read.pattern.seams[1].sewing.empty());
    EXPECT_NE(read.pattern.seams[0].sewing, read.pattern.seams[1].sewing);
}

// An outline that another program moved by 2 mm wins over the record of our curves.
TEST(RoundTrip, dxf_that_was_changed_is_read_as_it_is_drawn) {
    Pattern pattern = sample_pattern();
    pattern.seams.clear();
    pattern.panels.erase(pattern.panels.begin());
    std::string text = dxf_of(pattern);
    const std::string from = "500.000000\n20\n60.000000", to = "502.000000\n20\n60.000000";
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + 1))
        text.replace(at, from.size(), to);
    const PanelsOfDrawing read = make_panels(parse_drawing(text, "changed"), "changed");
    ASSERT_EQ(read.pattern.panels.size(), 1U);
    EXPECT_NEAR(outline_box(read.pattern.panels[0]).sizes().x(), 0.502, 1e-4);
}

// The sample, round a body: one panel bent to a cone, one to a cylinder, turned, mirrored, pinned, not worn.
Pattern placed_sample() {
    Pattern pattern = sample_pattern();
    pattern.body = "mannequin:sex=female";
    pattern.body_height = 1.606;
    Panel& cap = pattern.panels[0];
    cap.translation = {0.1, 1.2, -0.05};
    cap.rotation = Eigen::AngleAxisd(1.1, Vec3d(0.3, 0.9, -0.2).normalized()).toRotationMatrix();
    cap.wrap_cone = WrapCone{.apex = {0.15, 0.9}, .sine = -0.4};
    cap.layer = -2;
    cap.label = "arm; \"upper\"";
    cap.pins = {0, 3};
    Panel& strip = pattern.panels[1];
    strip.translation = {0, 0.9, 0};
    strip.is_mirrored = true;
    strip.wrap_radius = 0.2;
    strip.is_worn = false;
    return pattern;
}

TEST(RoundTrip, placements_come_back) {
    Pattern original = placed_sample();
    const std::string svg = svg_of(original), dxf = dxf_of(original);
    original.panels[0].label = "arm  \"upper\"";  // ';' parts phrases
    expect_same_placement(svg, original);
    expect_same_placement(dxf, original);
    for (const std::filesystem::path& file : shipped_patterns()) {
        SCOPED_TRACE(file.filename().string());
        const Pattern pattern = load_pattern(file).pattern;
        expect_same_placement(svg_of(pattern), pattern);
        expect_same_placement(dxf_of(pattern), pattern);
    }
}

// The SVG with attributes added to the group of the first piece.
std::string with_first_group(std::string svg, const std::string& attributes) {
    const std::string piece = "<g id=\"panel-0\"";
    EXPECT_NE(svg.find(piece), std::string::npos);
    return svg.replace(svg.find(piece), piece.size(), "<g " + attributes + " id=\"panel-0\"");
}

// As drawing programs do it: they leave what they do not know.
TEST(RoundTrip, pieces_of_svg_that_were_moved_and_turned_keep_notches_and_placement) {
    Pattern original = placed_sample();
    original.panels[0].label.clear();
    const std::string text = with_first_group(svg_of(original), "transform=\"translate(420,90) rotate(35)\"");
    expect_same_placement(text, original);
    const Panel read = make_panels(parse_drawing(text, "moved"), "moved").pattern.panels[0];
    expect_same_panel(read, original.panels[0]);
}

TEST(RoundTrip, pieces_of_svg_that_were_scaled_or_mirrored_are_placed_anew) {
    const std::string svg = svg_of(placed_sample());
    for (const char* transform : {"transform=\"scale(1.02)\"", "transform=\"scale(-1,1)\""}) {
        const Drawing drawing = parse_drawing(with_first_group(svg, transform), "changed");
        EXPECT_FALSE(make_panels(drawing, "changed").is_placed) << transform;
    }
}

// Its edges run the other way round, and are counted so.
TEST(RoundTrip, a_piece_of_svg_that_was_mirrored_keeps_its_seams_corner_to_corner) {
    const Pattern original = load_pattern(shipped_patterns().front()).pattern;
    ASSERT_FALSE(original.seams.empty());
    const std::string text = with_first_group(svg_of(original), "transform=\"scale(-1,1)\"");
    const PanelsOfDrawing made = make_panels(parse_drawing(text, "mirrored"), "mirrored");
    EXPECT_FALSE(made.is_placed);
    const Pattern& read = made.pattern;
    ASSERT_EQ(read.seams.size(), original.seams.size());
    for (std::size_t s = 0; s < read.seams.size(); ++s) {
        const auto lengths = [&](const Pattern& pattern) {
            const auto length = [&](const SeamSide& side) {
                const Panel& panel = panel_of(pattern, side);
                return outline_length(panel, panel.edges[static_cast<std::size_t>(side.edge)]);
            };
            return std::pair(length(pattern.seams[s].first), length(pattern.seams[s].second));
        };
        EXPECT_NEAR(lengths(read).first, lengths(original).first, kOff) << s;
        EXPECT_NEAR(lengths(read).second, lengths(original).second, kOff) << s;
        const bool is_turned = (read.seams[s].first.panel == 0) != (read.seams[s].second.panel == 0);
        EXPECT_EQ(read.seams[s].is_reversed, original.seams[s].is_reversed != is_turned) << s;
    }
}

TEST(RoundTrip, a_piece_of_svg_that_was_deleted_takes_its_seams_along) {
    const Pattern original = sample_pattern();
    std::string text = svg_of(original);
    const std::size_t begin = text.find("<g id=\"panel-1\"");
    ASSERT_NE(begin, std::string::npos);
    text.replace(begin, text.rfind("</svg>") - begin, "");
    const PanelsOfDrawing read = make_panels(parse_drawing(text, "deleted"), "deleted");
    EXPECT_EQ(read.pattern.panels.size(), 1U);
    EXPECT_EQ(read.pattern.seams.size(), 1U) << "the one that lies on the panel that is left";
    EXPECT_TRUE(std::ranges::any_of(read.notes, [](const std::string& note) {
        return note.find("one of its panels is not there") != std::string::npos;
    }));
}

TEST(RoundTrip, a_corner_that_was_moved_leaves_the_placement) {
    Pattern original = placed_sample(), longer = original;
    Panel& strip = longer.panels[1];
    strip.vertices[2].x() += 0.05;
    // The file says where the corner was.
    std::string text = svg_of(longer);
    const std::string now = "start 2 550 60", before = "start 2 500 60";
    ASSERT_NE(text.find(now), std::string::npos);
    text.replace(text.find(now), now.size(), before);
    const PanelsOfDrawing read = make_panels(parse_drawing(text, "changed"), "changed");
    ASSERT_TRUE(read.is_placed);
    expect_same_placement(read.pattern.panels[1], strip);
}

TEST(RoundTrip, dxf_keeps_a_body_with_all_measurements) {
    Pattern original = placed_sample();
    original.body = "mannequin:sex=female";
    for (const char* name : {"bust", "underbust", "waist", "hip", "neck", "biceps", "elbow", "forearm", "wrist"})
        original.body += std::string(",") + name + "=31.2525";
    for (const char* name : {"thigh", "mid_thigh", "knee", "calf", "ankle", "shoulder", "arm", "back", "inseam"})
        original.body += std::string(",") + name + "=48.5525";
    ASSERT_GT(original.body.size(), 250U);
    expect_same_placement(dxf_of(original), [&] {
        Pattern read_back = original;
        read_back.panels[0].label = "arm  \"upper\"";
        return read_back;
    }());
}

TEST(RoundTrip, placements_round_a_body_file_are_not_written) {
    Pattern original = placed_sample();
    original.body = "/bodies/somebody.obj";
    for (const std::string& text : {svg_of(original), dxf_of(original)}) {
        EXPECT_EQ(text.find("somebody"), std::string::npos);
        EXPECT_FALSE(make_panels(parse_drawing(text, "written"), "written").is_placed);
    }
}

TEST(RoundTrip, broken_placements_are_left_out) {
    const std::string svg = svg_of(placed_sample());
    const std::string body = "body=\"1606 mannequin:sex=female\"";
    const auto changed = [&](const std::string& from, const std::string& to) {
        std::string text = svg;
        EXPECT_NE(text.find(from), std::string::npos) << from;
        if (text.find(from) != std::string::npos) text.replace(text.find(from), from.size(), to);
        return make_panels(parse_drawing(text, "broken"), "broken").is_placed;
    };
    EXPECT_TRUE(changed(body, body));
    EXPECT_FALSE(changed(body, "body=\"16060 mannequin:sex=female\""));
    EXPECT_FALSE(changed(body, "body=\"1606 /dev/zero\""));
    EXPECT_FALSE(changed("layer -2", "layer 100000"));
    EXPECT_FALSE(changed("cylinder 200", "cylinder -200"));
    EXPECT_FALSE(changed("cylinder 200", "cylinder nan"));
    EXPECT_FALSE(changed("at 0 900 0", "at 0 900000 0"));
    EXPECT_FALSE(changed("start 0 0 0", "start 9 0 0"));
    EXPECT_FALSE(changed("unworn", "unworn never"));
    EXPECT_FALSE(changed("at 0 900 0", "at 0 900 0 0"));
    EXPECT_FALSE(changed("cone 150 900", "cone 150 900000"));
    EXPECT_FALSE(changed(" -0.4;", " -0.001;"));
    std::string far = svg;
    for (const std::string start : {"start 0 0 0;", "start 1 500 0;", "start 2 500 60;", "start 3 0 60;"}) {
        ASSERT_NE(far.rfind(start), std::string::npos) << start;
        const std::size_t number = far.rfind(start) + 8;
        far.insert(number, "999");
        if (far[number + 3] == '0') far.insert(number + 3, "00");
    }
    EXPECT_FALSE(make_panels(parse_drawing(far, "far"), "far").is_placed) << "100 m away";
    std::string dxf = dxf_of(placed_sample());
    const std::string layer = "PLACED layer -2";
    dxf.replace(dxf.find(layer), layer.size(), "PLACED layer x");
    EXPECT_FALSE(make_panels(parse_drawing(dxf, "broken"), "broken").is_placed);
}

TEST(RoundTrip, same_pattern_gives_the_same_bytes) {
    EXPECT_EQ(svg_of(sample_pattern()), svg_of(sample_pattern()));
    EXPECT_EQ(dxf_of(sample_pattern()), dxf_of(sample_pattern()));
    const std::string dxf = dxf_of(sample_pattern());
    EXPECT_TRUE(std::ranges::all_of(dxf, [](char c) { return static_cast<unsigned char>(c) < 0x7F; }));
}

}  // namespace
}  // namespace selvedge::sim

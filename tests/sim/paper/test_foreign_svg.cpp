// SVG as people's own programs write it: outlines in pieces, scales, hidden layers, frames, several sizes.
#include <gtest/gtest.h>

#include "sim/paper/make_panels.h"
#include "sim/paper/not_panels.h"
#include "sim/paper/size_names.h"
#include "sim/paper/svg_drawing.h"
#include "sim/pattern/edge_shape.h"
#include "tests/sim/paper/drawings.h"
#include "tests/support/notes.h"

namespace selvedge::sim {
namespace {

// A skirt's front, its corners 520 mm apart at the hem and 560 mm from hem to waist, and its back beside it.
const std::string kFront = "M40,620C200,645 400,645 560,620L472,60C380,75 220,75 128,60Z";
const std::string kBack = "M640,620C800,645 1000,645 1160,620L1072,60C980,70 820,70 728,60Z";

std::string path(const std::string& id, const std::string& data, const std::string& attributes = "") {
    return "<path id='" + id + "' d='" + data + "' fill='none' stroke='black' " + attributes + "/>\n";
}

const std::string kSkirt = path("Front", kFront) + path("Back", kBack);

std::string page(const std::string& elements, const std::string& attributes) {
    return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' "
           "xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' " +
           attributes + ">\n" + elements + "</svg>\n";
}

std::string in_mm(const std::string& elements) {
    return page(elements, "width='1300mm' height='700mm' viewBox='0 0 1300 700'");
}

PanelsOfDrawing svg_panels(const std::string& text, const MakePanelsOptions& options = {}) {
    return make_panels(read_svg(text, "a.svg"), "a.svg", options);
}

void expect_skirt(const PanelsOfDrawing& made, const std::string& what) {
    ASSERT_EQ(made.pattern.panels.size(), 2U) << what;
    for (const Panel& panel : made.pattern.panels) {
        const Vec2d size = outline_box(panel, 1e-5).sizes();
        EXPECT_NEAR(size.x(), 0.520, 5e-4) << what;
        EXPECT_NEAR(size.y(), 0.579, 5e-4) << what;
        EXPECT_EQ(panel.edges.size(), 4U) << what;
        EXPECT_TRUE(panel.internal_lines.empty()) << what;
    }
}

TEST(ForeignSvg, joins_outlines_that_are_drawn_in_pieces) {
    const std::string pieces = "<g id='Front'>" + path("a", "M40,620C200,645 400,645 560,620") +
                               path("b", "M472,60L560,620") + path("c", "M472,60C380,75 220,75 128,60") +
                               path("d", "M128,60L40,620.4") + "</g>" + path("Back", kBack);
    const PanelsOfDrawing made = svg_panels(in_mm(pieces));
    expect_skirt(made, "in pieces");
    EXPECT_TRUE(has_note(made.notes, "1 outline drawn in pieces: joined where lines meet, up to 0.4 mm apart"));
    EXPECT_EQ(made.pattern.panels[0].name, "Front");
}

TEST(ForeignSvg, keeps_a_line_of_another_colour_within_an_outline_in_pieces) {
    const std::string pieces = path("a", "M40,620C200,645 400,645 560,620") + path("b", "M472,60L560,620") +
                               path("c", "M472,60C380,75 220,75 128,60") + path("d", "M128,60L40,620") +
                               "<path d='M128,60L560,620' fill='none' stroke='blue'/>" + path("Back", kBack);
    const PanelsOfDrawing made = svg_panels(in_mm(pieces));
    ASSERT_EQ(made.pattern.panels.size(), 2U);
    EXPECT_EQ(made.pattern.panels[0].internal_lines.size() + made.pattern.panels[1].internal_lines.size(), 1U);
}

TEST(ForeignSvg, counts_pixels_as_its_program_does) {
    const auto scaled = [](double pixels_per_inch) {
        return "<g transform='scale(" + std::to_string(pixels_per_inch / 25.4) + ")'>" + kSkirt + "</g>";
    };
    const std::string size = "width='4000' height='2500' ";
    expect_skirt(svg_panels(page(scaled(90), size + "inkscape:version='0.48.4 r9939'")), "Inkscape 0.48");
    expect_skirt(svg_panels(page(scaled(96), size + "inkscape:version='0.92.4 (unknown)'")), "Inkscape 0.92");
    expect_skirt(svg_panels(page(scaled(96), size + "inkscape:version='1.2 (dc2aeda)'")), "Inkscape 1.2");
    const std::string adobe = "<!-- Generator: Adobe Illustrator 24.0, SVG Export Plug-In -->";
    expect_skirt(svg_panels(page(adobe + scaled(72), "viewBox='0 0 4000 2500'")), "Illustrator");
    expect_skirt(svg_panels(page(scaled(96), "width='4000px' height='2500px'")), "pixels");
    // A size of the world says it, whoever drew it.
    expect_skirt(svg_panels(page(adobe + kSkirt, "width='1300mm' height='700mm' viewBox='0 0 1300 700'")), "mm");
    EXPECT_TRUE(
        has_note(svg_panels(page(scaled(90), size + "inkscape:version='0.48'")).notes, "90 pixels to the inch"));
}

TEST(ForeignSvg, scales_what_lies_in_viewports_of_its_own) {
    const std::string inner =
        "<svg x='0' y='0' width='1300' height='700' viewBox='0 0 13000 7000'><g transform='scale(10)'>" + kSkirt +
        "</g></svg>";
    expect_skirt(svg_panels(in_mm(inner)), "an inner svg");
    const std::string share =
        "<svg width='100%' height='100%' viewBox='0 0 2600 1400'><g transform='scale(2)'>" + kSkirt + "</g></svg>";
    expect_skirt(svg_panels(in_mm(share)), "a share of the page");
    const std::string symbol = "<symbol id='s' viewBox='0 0 2600 1400'><g transform='scale(2)'>" + kSkirt +
                               "</g></symbol><use xlink:href='#s' width='1300' height='700'/>";
    expect_skirt(svg_panels(in_mm(symbol)), "a symbol");
    const std::string css =
        "<style>.half{transform: translate(10px, 0) scale(0.5) rotate(0.5turn)}</style>"
        "<g class='half'><g transform='scale(2)'>" +
        kSkirt + "</g></g>";
    expect_skirt(svg_panels(in_mm(css)), "a transform of the style");
}

TEST(ForeignSvg, leaves_out_what_is_hidden) {
    const std::string old = path("Old", "M0,0H500V600H0Z");
    for (const std::string& hidden :
         {"<g style='display : none'>" + old + "</g>", "<g display='none'>" + old + "</g>",
          "<g visibility='hidden'>" + old + "</g>", "<g opacity='0'>" + old + "</g>",
          "<style>.off{display:none}</style><g class='on off'>" + old + "</g>",
          "<style>#x path{visibility:hidden !important}</style><g id='x'>" + old + "</g>",
          "<style>/* a */ @media screen,print { g > path { opacity: 0.0 } }</style><g>" + old + "</g>",
          "<svg width='0' height='0'>" + old + "</svg>", "<g stroke-opacity='0'>" + old + "</g>",
          "<g stroke-width='0'>" + old + "</g>", std::string("<path d='M0,0H500V600H0Z' fill='rgba(0,0,0,0)'/>"),
          std::string("<path d='M0,0H500V600H0Z' fill='none'/>")}) {
        const PanelsOfDrawing made = svg_panels(in_mm(hidden + kSkirt));
        expect_skirt(made, hidden);
        EXPECT_TRUE(has_note(made.notes, "1 hidden element left out")) << hidden;
    }
    // What is shown again within is seen; a print style is not the screen's.
    const std::string shown =
        "<style>@media print{path{display:none}}</style><g visibility='hidden'><g visibility='visible'>" + kSkirt +
        "</g></g>";
    expect_skirt(svg_panels(in_mm(shown)), "shown again");
}

TEST(ForeignSvg, takes_no_page_frame_for_a_panel) {
    for (const std::string& frame :
         {std::string("<rect width='1300' height='700' fill='white'/>"),
          std::string("<path d='M5,5H1295V695H5Z' fill='none' stroke='red'/>"),
          std::string("<rect x='10' y='10' width='1280' height='680' fill='none' stroke='black'/>"
                      "<rect x='15' y='15' width='1270' height='670' fill='none' stroke='black'/>"),
          std::string("<rect id='frame' x='10' y='20' width='1200' height='650' fill='none' stroke='black'/>"),
          std::string("<rect x='10' y='10' width='1280' height='680' rx='30' fill='none' stroke='black'/>"),
          std::string("<path d='M5,5H1295V600H1180V695H5Z' fill='none' stroke='red'/>")}) {
        const PanelsOfDrawing made = svg_panels(in_mm(frame + kSkirt));
        expect_skirt(made, frame);
        EXPECT_TRUE(has_note(made.notes, "a page frame, left out")) << frame;
    }
    // A rectangle with its sewing line is a panel.
    const PanelsOfDrawing scarf =
        svg_panels(page("<rect width='1300' height='700'/><rect x='10' y='10' width='1280' height='680'/>",
                        "width='1300mm' height='700mm' viewBox='0 0 1300 700'"));
    EXPECT_EQ(scarf.pattern.panels.size(), 1U);
}

TEST(ForeignSvg, leaves_out_letters_logos_legends_and_bars) {
    const std::string letters =
        "<path d='M600,20h10v14h-10zM602,22v10h6v-10z'/><path d='M620,20h10v14h-4v-8h-6z'/>"
        "<rect x='580' y='660' width='100' height='5'/>";
    const std::string logo = "<g id='Logo'><circle cx='620' cy='300' r='40' fill='none' stroke='black'/></g>";
    const std::string legend =
        "<rect x='570' y='400' width='60' height='90' fill='none' stroke='black'/><text x='575' y='410'>Legend</text>";
    const PanelsOfDrawing made = svg_panels(in_mm(kSkirt + letters + logo + legend));
    expect_skirt(made, "ornaments");
    EXPECT_TRUE(has_note(made.notes, "lettering or marks, left out"));
    EXPECT_TRUE(has_note(made.notes, "a logo or a legend by its name, left out"));
    EXPECT_TRUE(has_note(made.notes, "a legend by its text, left out"));
    // A page that says something is a page, with what lies on it.
    expect_skirt(svg_panels(in_mm("<rect width='1300' height='700' fill='white'/>" + kSkirt +
                                  "<text x='600' y='30'>Legend, test square, copyright</text>")),
                 "a page with texts");
}

TEST(ForeignSvg, takes_the_scale_from_a_labelled_test_square) {
    const std::string square = "<rect x='590' y='20' width='50' height='50' fill='none' stroke='black'/>";
    // True to its label: only left out.
    PanelsOfDrawing made = svg_panels(in_mm(kSkirt + square + "<text x='595' y='40'>5 cm</text>"));
    expect_skirt(made, "a true square");
    EXPECT_TRUE(has_note(made.notes, "a test square, left out"));
    // Everything is drawn at 90 of 96.
    const std::string small =
        "<g transform='scale(0.9375)'>" + kSkirt + square + "<text x='595' y='40'>Test square 5 cm</text></g>";
    made = svg_panels(in_mm(small));
    expect_skirt(made, "a square that proves the scale");
    EXPECT_TRUE(has_note(made.notes, "the test square of 5 cm is drawn as 4.688 cm: the scale is taken from it"));
    made = svg_panels(page("<g transform='scale(7)'>" + kSkirt + square + "<text x='595' y='40'>2 in</text></g>", ""));
    ASSERT_EQ(made.pattern.panels.size(), 2U);
    EXPECT_NEAR(outline_box(made.pattern.panels[0]).sizes().x(), 0.52 * 50.8 / 50, 1e-3);
}

TEST(ForeignSvg, takes_the_scale_from_a_named_test_square_however_far_it_is_off) {
    const std::string square =
        "<rect x='590' y='20' width='50' height='50' fill='none' stroke='black'/>"
        "<text x='595' y='40'><tspan x='595' y='40'>Testquadrat</tspan><tspan x='595' y='50'>5x5cm</tspan></text>";
    const PanelsOfDrawing made = svg_panels(in_mm("<g transform='scale(0.4)'>" + kSkirt + square + "</g>"));
    expect_skirt(made, "a named square");
    EXPECT_TRUE(has_note(made.notes, "the test square of 5 cm is drawn as 2 cm: the scale is taken from it"));
}

TEST(ForeignSvg, leaves_out_title_blocks_in_the_corners_of_a_frame) {
    const std::string frame = "<path d='M5,5H1295V695H5Z' fill='none' stroke='black'/>";
    for (const std::string& title : {path("", "M1200,640H1295V695H1200Z"), path("", "M5,5H100V55H5Z")}) {
        const PanelsOfDrawing made = svg_panels(in_mm(frame + kSkirt + title));
        expect_skirt(made, title);
        EXPECT_TRUE(has_note(made.notes, "a title block in a corner of the page frame, left out")) << title;
    }
}

TEST(ForeignSvg, names_parts_by_what_uses_them) {
    const std::string defs = "<defs>" + path("a", kFront) + "<g id='b'><use xlink:href='#a'/></g></defs>";
    for (const std::string& uses : {defs + "<use id='Front' href='#a'/><use id='Back' href='#a' x='600'/>",
                                    defs + "<use id='Front' href='#b'/><use id='Back' href='#b' x='600'/>",
                                    "<symbol id='Front'>" + path("", kFront) + "</symbol><symbol id='Back'>" +
                                        path("", kBack) + "</symbol><use href='#Front'/><use href='#Back'/>"}) {
        const PanelsOfDrawing made = svg_panels(in_mm(uses));
        expect_skirt(made, uses);
        EXPECT_EQ(made.pattern.panels.at(0).name, "Front") << uses;
        EXPECT_EQ(made.pattern.panels.at(1).name, "Back") << uses;
    }
}

TEST(ForeignSvg, names_no_part_by_what_is_written_along_its_lines) {
    const std::string texts =
        "<text x='250' y='240'>Grainline</text><text x='250' y='260'>SA 1 cm included</text>"
        "<text x='250' y='280'>www.example.com</text><text x='250' y='300'>Skirt Front</text>";
    const PanelsOfDrawing made = svg_panels(in_mm(path("", kFront) + path("Back", kBack) + texts));
    ASSERT_EQ(made.pattern.panels.size(), 2U);
    EXPECT_EQ(made.pattern.panels[0].name, "Skirt Front");
}

TEST(ForeignSvg, joins_lines_that_are_shorter_than_the_gap) {
    std::string lines;
    const auto add = [&](const Vec2d& from, const Vec2d& to) {
        constexpr int kPieces = 800;
        for (int i = 0; i < kPieces; ++i) {
            const Vec2d a = from + (to - from) * i / kPieces, b = from + (to - from) * (i + 1) / kPieces;
            lines += "<path d='M" + std::to_string(a.x()) + "," + std::to_string(a.y()) + "L" + std::to_string(b.x()) +
                     "," + std::to_string(b.y()) + "' stroke='black'/>";
        }
    };
    add({100, 100}, {600, 100});
    add({600, 100}, {600, 500});
    add({600, 500}, {100, 500});
    add({100, 500}, {100, 100});
    const PanelsOfDrawing made = svg_panels(in_mm(lines));
    ASSERT_EQ(made.pattern.panels.size(), 1U);
    EXPECT_NEAR(outline_box(made.pattern.panels[0]).sizes().x(), 0.5, 1e-6);
}

TEST(ForeignSvg, takes_no_square_part_for_a_test_square) {
    const std::string pocket =
        "<rect id='square pocket' x='570' y='20' width='120' height='120' fill='none' stroke='black'/>";
    for (const char* words : {"1 cm", "Pocket: cut 2 from print fabric, 1 cm seam allowance", "Cut 2 interfacing"}) {
        const PanelsOfDrawing made = svg_panels(in_mm(kSkirt + pocket + "<text x='575' y='40'>" + words + "</text>"));
        ASSERT_GE(made.pattern.panels.size(), 3U) << words;
        EXPECT_NEAR(outline_box(made.pattern.panels[0]).sizes().x(), 0.52, 1e-3) << words;
    }
}

TEST(ForeignSvg, keeps_a_pocket_that_is_drawn_within_the_sewing_line) {
    const std::string lines =
        "<rect width='300' height='400'/><rect x='10' y='10' width='280' height='380'/>"
        "<rect x='100' y='100' width='80' height='90'/>";
    const PanelsOfDrawing made = svg_panels(in_mm(lines));
    ASSERT_EQ(made.pattern.panels.size(), 1U);
    EXPECT_EQ(made.pattern.panels[0].internal_lines.size(), 1U);
    EXPECT_NEAR(outline_box(made.pattern.panels[0]).sizes().x(), 0.28, 1e-4);
}

TEST(ForeignSvg, takes_no_numbers_of_pieces_for_sizes) {
    const PanelsOfDrawing made = svg_panels(in_mm(path("31", kFront) + path("32", kBack)));
    EXPECT_EQ(made.pattern.panels.size(), 2U);
    EXPECT_TRUE(made.sizes.empty());
}

TEST(ForeignSvg, takes_the_length_that_the_unit_makes_true) {
    const std::string square = "<rect x='570' y='20' width='100' height='100' fill='none' stroke='black'/>";
    expect_skirt(svg_panels(in_mm(kSkirt + square + "<text x='575' y='40'>4\" / 10 cm</text>")), "two lengths");
    const std::string small = "<g transform='scale(0.8)'>" + kSkirt + square + "<text x='575' y='40'>10 cm</text></g>";
    expect_skirt(svg_panels(in_mm(small)), "a text of nothing but a length");
}

TEST(ForeignSvg, tells_of_an_outline_that_is_not_closed) {
    const PanelsOfDrawing made = svg_panels(
        in_mm(path("Front", kFront) + path("Back", "M640,620C800,645 1000,645 1160,620L1072,60C980,70 820,70 728,60")));
    EXPECT_EQ(made.pattern.panels.size(), 1U);
    EXPECT_TRUE(has_note(made.notes, "1 open line in no part, left out: is an outline not closed?"));
}

TEST(ForeignSvg, reads_a_size_however_it_is_written) {
    for (const char* size : {"width='1300 mm' height='700 mm'", "width='1300MM' height='700MM'",
                             "width='1300,0mm' height='700,0mm'", "style='width: 1300mm; height:700mm'"})
        expect_skirt(svg_panels(page("<g transform='scale(0.5)'>" + kSkirt + "</g>",
                                     std::string(size) + " viewBox='0 0 650 350'")),
                     size);
}

TEST(Lengths, of_a_text_are_those_with_a_unit) {
    EXPECT_EQ(lengths_in("5 cm x 5cm"), (std::vector<double>{0.05, 0.05}));
    const std::vector<double> inches = lengths_in("2\" / 50,8 mm, page 3");
    ASSERT_EQ(inches.size(), 2U);
    EXPECT_NEAR(inches[0], inches[1], 1e-12);
    EXPECT_TRUE(lengths_in("cut 2, size 38").empty());
}

// A skirt front in three sizes, drawn on each other; the side seams differ.
std::string nest(const std::array<std::string, 3>& attributes) {
    std::string all;
    for (const double shift : {0.0, 650.0}) {
        for (std::size_t k = 0; k < attributes.size(); ++k) {
            const double width = 400 + 40 * static_cast<double>(k), x = 20 + shift;
            all += "<path d='M" + std::to_string(x) + ",60h" + std::to_string(0.8 * width) + "L" +
                   std::to_string(x + width) + ",600H" + std::to_string(x) + "Z' fill='none' " + attributes[k] + "/>";
        }
    }
    return all;
}

TEST(ForeignSvg, tells_the_sizes_of_a_nest_apart) {
    const auto widths = [](const PanelsOfDrawing& made) {
        std::vector<long> all;
        for (const Panel& panel : made.pattern.panels)
            all.push_back(std::lround(1000 * outline_box(panel).sizes().x()));
        return all;
    };
    const std::string colours =
        nest({"stroke='red'", "stroke='green'", "stroke='blue'"}) +
        "<text x='600' y='20'>L</text><text x='600' y='40'>S</text><text x='600' y='60'>M</text>";
    PanelsOfDrawing made = svg_panels(in_mm(colours));
    EXPECT_EQ(made.pattern.size, "M");
    EXPECT_EQ(widths(made), (std::vector<long>{440, 440}));
    EXPECT_EQ(widths(svg_panels(in_mm(colours), {.size = "l"})), (std::vector<long>{480, 480}));
    const std::string dashes =
        nest({"stroke='black'", "stroke='black' stroke-dasharray='5,5'", "stroke='black' stroke-dasharray='1,5'"});
    made = svg_panels(in_mm(dashes), {.size = "1"});
    EXPECT_EQ(made.sizes, (std::vector<std::string>{"1", "2", "3"}));
    EXPECT_EQ(widths(made), (std::vector<long>{400, 400}));
    std::string layers;
    for (const char* size : {"34", "36", "38"}) {
        layers += std::string("<g inkscape:groupmode='layer' inkscape:label='Size ") + size + "'>" +
                  path(std::string("Front") + size, size[1] == '4' ? "M0,0H400V600H0Z" : "M0,0H440V610H0Z") + "</g>";
    }
    made = svg_panels(in_mm(layers), {.size = "34"});
    EXPECT_EQ(widths(made), (std::vector<long>{400}));
    EXPECT_EQ(made.sizes, (std::vector<std::string>{"34", "36", "38"}));
    const std::string names = path("Front_S", "M0,0H400V600H0Z") + path("Front_M", "M0,0H440V600H0Z") +
                              path("Back_S", "M500,0H900V600H500Z") + path("Back_M", "M500,0H940V600H500Z");
    made = svg_panels(in_mm(names), {.size = "S"});
    EXPECT_EQ(widths(made), (std::vector<long>{400, 400}));
    EXPECT_THROW(svg_panels(in_mm(names), {.size = "XL"}), InputError);
}

TEST(SizeNames, are_told_from_other_names) {
    EXPECT_EQ(size_of_name("Size M"), "M");
    EXPECT_EQ(size_of_name("SIZE NAME: xl"), "XL");
    EXPECT_EQ(size_of_name("Gr. 38"), "38");
    EXPECT_EQ(size_of_name("2XL"), "2XL");
    EXPECT_EQ(size_of_name("34/36"), "34/36");
    EXPECT_EQ(size_of_name("US 8"), "8");
    EXPECT_EQ(size_of_name("EU 38 / UK 10"), "38");
    EXPECT_EQ(split_size("M_Front"), std::pair(std::string("Front"), std::string("M")));
    EXPECT_EQ(split_size("Skirt front"), std::nullopt);
    for (const char* other : {"", "8", "Front", "slip", "layer1", "100 %", "Size", "M1", "deck"})
        EXPECT_EQ(size_of_name(other), std::nullopt) << other;
    std::vector<std::string> sizes{"XL", "M", "XXS", "S", "L"};
    sort_sizes(sizes);
    EXPECT_EQ(sizes, (std::vector<std::string>{"XXS", "S", "M", "L", "XL"}));
}

TEST(ForeignSvg, unfolds_what_its_text_says_is_cut_on_the_fold) {
    const std::string half = "M60,680L305,680L305,285C250,280 225,210 245,70L140,25C138,80 105,105 60,105Z";
    PanelsOfDrawing made = svg_panels(in_mm(path("Front", half) + "<text x='80' y='520'>Cut 1 on fold</text>"));
    ASSERT_EQ(made.pattern.panels.size(), 1U);
    EXPECT_NEAR(outline_box(made.pattern.panels[0]).sizes().x(), 0.49, 1e-4);
    EXPECT_TRUE(has_note(made.notes, "cut on the fold by its text: unfolded over the straight edge of 57.5 cm"));
    for (const char* words :
         {"Place on fold", "Stoffbruch", "1 x im Bruch", "sur la pliure", "op de vouw", "C.F. FOLD"}) {
        made = svg_panels(in_mm(path("Front", half) + "<text x='80' y='520'>" + words + "</text>"));
        EXPECT_NEAR(outline_box(made.pattern.panels.at(0)).sizes().x(), 0.49, 1e-4) << words;
    }
    for (const char* words : {"Cut 1 on fold, no seam allowance", "No. 3: cut 1 on fold"}) {
        made = svg_panels(in_mm(path("Front", half) + "<text x='80' y='520'>" + words + "</text>"));
        EXPECT_NEAR(outline_box(made.pattern.panels.at(0)).sizes().x(), 0.49, 1e-4) << words;
    }
    for (const char* words : {"Do not cut on fold", "fold", "fold line"}) {
        made = svg_panels(in_mm(path("Front", half) + "<text x='180' y='520'>" + words + "</text>"));
        EXPECT_NEAR(outline_box(made.pattern.panels.at(0)).sizes().x(), 0.245, 1e-4) << words;
    }
    // Either end of a waistband may be the fold; a text beside one tells.
    const std::string band = path("Band", "M0,0H400V300H0Z");
    made = svg_panels(in_mm(band + "<text x='200' y='150'>cut 1 on fold</text>"));
    EXPECT_NEAR(outline_box(made.pattern.panels[0]).sizes().x(), 0.4, 1e-4);
    EXPECT_TRUE(has_note(made.notes, "several edges could be the fold: not unfolded"));
    made = svg_panels(in_mm(band + "<text x='200' y='150'>cut 1 on fold</text><text x='10' y='150'>FOLD</text>"));
    EXPECT_NEAR(outline_box(made.pattern.panels[0]).sizes().x(), 0.8, 1e-4);
}

TEST(ForeignSvg, unfolds_a_part_along_the_edge_beside_which_its_text_stands_outside) {
    const std::string half = path("Front", "M300,60L470,60L560,620L300,620Z");
    const std::string beside = "<text x='290' y='400' transform='rotate(-90 290 400)'>place on fold</text>";
    EXPECT_NEAR(outline_box(svg_panels(in_mm(half + beside)).pattern.panels.at(0)).sizes().x(), 0.52, 1e-4);
    const std::string far = "<text x='200' y='400'>place on fold</text>";
    EXPECT_NEAR(outline_box(svg_panels(in_mm(half + far)).pattern.panels.at(0)).sizes().x(), 0.26, 1e-4);
}

TEST(ForeignSvg, doubts_a_size_that_no_garment_has) {
    const PanelsOfDrawing made = svg_panels(page(kSkirt, "width='130mm' height='70mm' viewBox='0 0 1300 700'"));
    EXPECT_TRUE(has_note(made.notes, "the largest part is 5.79 cm long: no garment is so small"));
    EXPECT_TRUE(has_note(made.notes, "--unit mm would make it 57.9 cm"));
}

}  // namespace
}  // namespace selvedge::sim

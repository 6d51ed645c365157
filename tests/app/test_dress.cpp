// selvedge dress and render, as black boxes: their output files, identical output for any thread count, exit codes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <utility>

#include "render/image/image.h"
#include "sim/core/json.h"
#include "sim/core/sha256.h"
#include "sim/pattern/fabric_file.h"
#include "sim/pattern/pattern_file.h"
#include "tests/app/selvedge_program.h"
#include "tests/support/checkout.h"

namespace selvedge::app {
namespace {

const std::vector<std::string> kWritten = {"picture.png", "garment.obj", "garment.glb",
                                           "body.obj",    "body.glb",    "report.json"};

// Dresses two squares at a low resolution and writes every kind of output.
ProgramResult dress_into(const ScratchFolder& folder, const std::string& options) {
    return run_selvedge("dress " + shipped("two_squares.json") + " --body mannequin:resolution=1 --max-level 1" +
                        " --texture-size 256 --render '" + folder / "picture.png" + "' --size 160x120 --export '" +
                        folder / "garment.obj" + "' --export '" + folder / "garment.glb" + "' --export-body '" +
                        folder / "body.obj" + "' --export-body '" + folder / "body.glb" + "' --report '" +
                        folder / "report.json" + "' " + options);
}

class DressCommand : public testing::Test {
 protected:
    static void SetUpTestSuite() {
        folder_ = new ScratchFolder;
        result_ = new ProgramResult(dress_into(*folder_, "--threads 1"));
    }
    static void TearDownTestSuite() {
        delete folder_;
        delete result_;
    }
    static std::string file(const std::string& name) { return *folder_ / name; }
    static const ProgramResult& result() { return *result_; }

 private:
    static inline ScratchFolder* folder_ = nullptr;
    static inline ProgramResult* result_ = nullptr;
};

sim::Json report_without_timing(const std::string& file) {
    sim::Json report = sim::read_json(file);
    report.erase("timing");
    return report;
}

std::vector<std::string> lines_with(const std::string& text, const std::string& beginning) {
    std::vector<std::string> found;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind(beginning, 0) == 0) found.push_back(line);
    }
    return found;
}

TEST_F(DressCommand, two_squares_dress_without_a_fault) {
    EXPECT_EQ(result().exit_code, 0) << result().out << result().err;
    const sim::Json report = sim::read_json(file("report.json"));
    ASSERT_NE(report.find("faults"), nullptr);
    EXPECT_TRUE(report.find("faults")->elements().empty()) << write_json(*report.find("faults"));
    ASSERT_NE(report.find("settled"), nullptr);
    EXPECT_TRUE(report.find("settled")->boolean());
}

TEST_F(DressCommand, writes_every_file_it_was_asked_for) {
    for (const std::string& name : kWritten) EXPECT_GT(content_of(file(name)).size(), 100U) << name;
    const render::Image picture = render::read_png(file("picture.png"));
    EXPECT_EQ(picture.width_px, 160);
    EXPECT_EQ(picture.height_px, 120);
}

TEST_F(DressCommand, the_report_has_every_key_that_scripts_rely_on) {
    const sim::Json report = sim::read_json(file("report.json"));
    for (const char* key : {"garment", "body", "settled", "stopped_because", "simulated_seconds", "faults"})
        EXPECT_NE(report.find(key), nullptr) << key;
    const std::vector<std::pair<std::string, std::vector<std::string>>> groups = {
        {"mesh",
         {"base_triangles", "leaf_triangles", "leaf_vertices", "by_level", "min_angle_deg", "splits", "rejoins",
          "transitions"}},
        {"seams", {"count", "open", "worst_length_mismatch"}},
        {"contact", {"inside", "deepest_m", "faces_in_body", "edges_in_body", "deepest_face_m", "deepest_face_at"}},
        {"stretch", {"warp_weft_p50", "warp_weft_p99", "warp_weft_max", "shear_deg_p99"}},
        {"timing",
         {"wall_s", "ms_per_adaptation", "ms_per_step", "ms_adapt_plus_4_steps", "phases", "peak_memory_mb"}}};
    for (const auto& [group, keys] : groups) {
        ASSERT_NE(report.find(group), nullptr) << group;
        for (const std::string& key : keys) EXPECT_NE(report.find(group)->find(key), nullptr) << group << '.' << key;
    }
}

TEST_F(DressCommand, the_obj_carries_metres_material_coordinates_and_a_group_per_panel) {
    const std::string text = content_of(file("garment.obj"));
    const sim::Json report = sim::read_json(file("report.json"));
    EXPECT_EQ(lines_with(text, "g ").size(), 2U);
    EXPECT_EQ(static_cast<double>(lines_with(text, "f ").size()),
              report.find("mesh")->find("leaf_triangles")->number());
    EXPECT_FALSE(lines_with(text, "vt ").empty());
    for (const std::string& line : lines_with(text, "v ")) {
        double x = 0, y = 0, z = 0;
        std::istringstream(line.substr(2)) >> x >> y >> z;
        ASSERT_TRUE(std::abs(x) < 1.5 && y > -0.1 && y < 2.2 && std::abs(z) < 1.5) << line;
    }
}

TEST_F(DressCommand, two_threads_write_the_same_bytes_as_one) {
    const ScratchFolder other;
    const ProgramResult again = dress_into(other, "--threads 2");
    EXPECT_EQ(again.exit_code, result().exit_code);
    for (const std::string& name : kWritten) {
        if (name == "report.json") continue;
        EXPECT_TRUE(content_of(file(name)) == content_of(other / name)) << name << " differs";
    }
    EXPECT_EQ(write_json(report_without_timing(file("report.json"))),
              write_json(report_without_timing(other / "report.json")));
}

TEST_F(DressCommand, a_fault_exits_3_is_named_and_still_makes_the_picture) {
    const ScratchFolder folder;
    const ProgramResult hasty = dress_into(folder, "--seconds 0.05");
    EXPECT_EQ(hasty.exit_code, 3) << hasty.err;
    const sim::Json report = sim::read_json(folder / "report.json");
    ASSERT_FALSE(report.find("faults")->elements().empty());
    EXPECT_EQ(report.find("faults")->elements().front().find("kind")->string(), "not_settled");
    EXPECT_EQ(report.find("faults")->elements().front().find("class")->string(), "defect");
    EXPECT_EQ(lines_with(hasty.out, "defect: not settled: ").size(), 1U) << hasty.out;
    EXPECT_EQ(render::read_png(folder / "picture.png").width_px, 160);
}

TEST_F(DressCommand, what_is_refused_has_a_report_too_in_place_of_an_old_one) {
    const ScratchFolder folder;
    std::ofstream(folder / "report.json") << "{\"outcome\": \"dressed\"}";
    const ProgramResult refused =
        run_selvedge("dress '" + folder / "none.json" + "' --report '" + folder / "report.json" + "'");
    EXPECT_EQ(refused.exit_code, 2);
    const sim::Json report = sim::read_json(folder / "report.json");
    EXPECT_EQ(report.find("outcome")->string(), "refused");
    EXPECT_NE(refused.err.find(report.find("problem")->string()), std::string::npos) << refused.err;
    EXPECT_TRUE(report.find("faults")->elements().empty());
}

TEST(RefusedReport, names_the_inputs_of_a_garment_whose_fabric_is_refused) {
    const ScratchFolder folder;
    std::ofstream(folder / "no_fabric.json") << "{}";
    EXPECT_EQ(run_selvedge("dress " + shipped("two_squares.json") + " --fabric '" + folder / "no_fabric.json" +
                           "' --report '" + folder / "report.json" + "'")
                  .exit_code,
              2);
    const sim::Json report = sim::read_json(folder / "report.json");
    EXPECT_EQ(report.find("outcome")->string(), "refused");
    std::vector<std::string> roles;
    for (const sim::Json& input : report.find("inputs")->elements()) roles.push_back(input.find("role")->string());
    EXPECT_EQ(roles, (std::vector<std::string>{"garment", "body", "fabric"}));
}

TEST(RefusedReport, replaces_an_older_one_but_no_other_file) {
    const ScratchFolder folder;
    const std::string report = folder / "report.json", garment = folder / "garment.json";
    std::filesystem::copy_file(source_folder() + "/patterns/two_squares.json", garment);
    for (const char* wrong : {"--edge-length 900", "--view frnt", "--bodi mannequin"}) {
        std::ofstream(report) << R"({"schema": 1, "outcome": "dressed"})";
        const ProgramResult run = run_selvedge("dress '" + garment + "' " + wrong + " --report '" + report + "'");
        EXPECT_EQ(run.exit_code, 2) << run.err;
        EXPECT_EQ(sim::read_json(report).find("outcome")->string(), "refused") << wrong;
    }
    std::ofstream(report) << "another file";
    EXPECT_EQ(run_selvedge("dress '" + garment + "' --view frnt '--report=" + report + "'").exit_code, 2);
    EXPECT_EQ(content_of(report), "another file");
}

TEST_F(DressCommand, a_report_names_its_inputs_by_content) {
    const sim::Json report = sim::read_json(file("report.json"));
    const sim::Json& input = report.find("inputs")->elements().at(0);
    EXPECT_EQ(input.find("role")->string(), "garment");
    EXPECT_EQ(input.find("sha256")->string(), sim::sha256(content_of(input.find("file")->string())));
    EXPECT_EQ(report.find("fit")->elements().size(), 8U);
}

TEST_F(DressCommand, a_report_names_the_pictures_of_a_design_and_of_a_fabrics_file) {
    const ScratchFolder folder;
    for (const char* picture : {"roses.png", "lace.png"}) write_png(folder / picture, render::Image(8, 4));
    std::string fabric = sim::read_fabric_file("silk").text;
    fabric.insert(fabric.find('{') + 1, R"("surface": {"kind": "picture", "file": "roses.png"},)");
    std::ofstream(folder / "my_silk.json") << fabric;
    const auto inputs_with = [&](const std::string& options) {
        const ProgramResult run = run_selvedge(
            "dress " + shipped("two_squares.json") + " --body mannequin:resolution=1 --max-level 0 --seconds 0.05" +
            " --fabric '" + folder / "my_silk.json" + "' --report '" + folder / "inputs.json" + "'" + options);
        EXPECT_NE(run.exit_code, 2) << run.err;
        std::vector<std::string> inputs;
        const sim::Json report = sim::read_json(folder / "inputs.json");
        for (const sim::Json& input : report.find("inputs")->elements()) {
            const std::filesystem::path path = input.find("file")->string();
            const bool is_text = input.find("role")->string() == "body";
            EXPECT_EQ(input.find("sha256")->string(), sim::sha256(is_text ? path.string() : content_of(path))) << path;
            inputs.push_back(input.find("role")->string() + " " + path.filename().string());
        }
        return inputs;
    };
    std::vector<std::string> expected{"garment two_squares.json", "body mannequin:resolution=1", "fabric my_silk.json",
                                      "picture roses.png"};
    EXPECT_EQ(inputs_with(""), expected);
    expected.emplace_back("picture lace.png");
    EXPECT_EQ(inputs_with(" --design '" + folder / "lace.png" + "'"), expected);
}

TEST_F(DressCommand, shows_the_hierarchy_and_films_it) {
    const ScratchFolder folder;
    const ProgramResult shown = run_command("cd '" + folder.path().string() + "' && '" + program_folder() +
                                            "/selvedge' dress " + shipped("two_squares.json") +
                                            " --body mannequin:resolution=1 --max-level 1 --seconds 0.05 -q --size "
                                            "96x96 --show hierarchy --render x.png --turntable out/ --frames 2");
    EXPECT_EQ(shown.exit_code, 3) << shown.err;
    EXPECT_EQ(render::read_png(folder / "x.png").width_px, 96);
    EXPECT_EQ(render::read_png(folder / "out/frame_0002.png").width_px, 96);
    EXPECT_EQ(shown.err, "");
}

TEST_F(DressCommand, keeps_coarse_what_the_camera_does_not_see) {
    const ScratchFolder folder;
    const auto triangles = [&](const std::string& options) {
        run_selvedge("dress " + shipped("two_squares.json") + " --body mannequin:resolution=1 -q --report '" +
                     folder / "x.json" + "' " + options);
        return sim::read_json(folder / "x.json").find("mesh")->find("leaf_triangles")->number();
    };
    const double all = triangles(""), front = triangles("--coarse-back-faces");
    EXPECT_LT(front, 0.9 * all);
    EXPECT_NE(triangles("--coarse-back-faces --camera 2,1,0,0,1,0"), front) << "as the camera stands";
    const ProgramResult refused = run_selvedge("dress " + shipped("two_squares.json") +
                                               " --coarse-back-faces --turntable '" + folder / "x.frames" + "'");
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_NE(refused.err.find("a turntable shows all sides"), std::string::npos) << refused.err;
}

TEST_F(DressCommand, exports_carry_the_curved_surface_when_asked_to) {
    const ScratchFolder folder;
    const auto triangles = [&](const std::string& options) {
        const ProgramResult dressed = run_selvedge("dress " + shipped("two_squares.json") +
                                                   " --body mannequin:resolution=1 --max-level 0 --seconds 0.05 -q "
                                                   "--export '" +
                                                   folder / "x.obj" + "' " + options);
        EXPECT_EQ(dressed.exit_code, 3) << dressed.err;
        return lines_with(content_of(folder / "x.obj"), "f ").size();
    };
    const std::size_t own = triangles("");
    EXPECT_EQ(triangles("--surface quadratic --surface-level 1 --export-surface"), 4 * own);
    EXPECT_EQ(triangles("--surface quadratic --surface-level 1"), own);
}

TEST_F(DressCommand, runs_from_any_folder) {
    const ScratchFolder folder;
    const ProgramResult elsewhere = run_command("cd '" + folder.path().string() + "' && '" + program_folder() +
                                                "/selvedge' dress " + shipped("two_squares.json") +
                                                " --body mannequin:resolution=1 --max-level 0 --seconds 0.05 "
                                                "--tartan black_watch --fabric denim --render x.png --size 64x64");
    EXPECT_EQ(elsewhere.exit_code, 3) << elsewhere.err;
    EXPECT_EQ(render::read_png(folder / "x.png").width_px, 64);
}

TEST_F(DressCommand, what_was_exported_can_be_rendered_again) {
    for (const std::string garment : {"garment.obj", "garment.glb"}) {
        const ScratchFolder folder;
        const ProgramResult rendered = run_selvedge("render '" + file(garment) + "' --body '" + file("body.obj") +
                                                    "' -o '" + folder / "again.png" + "' --size 96x128");
        EXPECT_EQ(rendered.exit_code, 0) << rendered.err;
        EXPECT_EQ(render::read_png(folder / "again.png").height_px, 128);
    }
}

TEST_F(DressCommand, exports_carry_colour_beside_or_inside_unless_they_are_not_to) {
    EXPECT_EQ(render::read_png(file("garment_colour.png")).width_px, 256);
    EXPECT_NE(content_of(file("garment.mtl")).find("map_Kd garment_colour.png"), std::string::npos);
    EXPECT_NE(content_of(file("garment.glb")).find("image/png"), std::string::npos);
    const ScratchFolder folder;
    const ProgramResult plain = run_selvedge("dress " + shipped("two_squares.json") +
                                             " --body mannequin:resolution=1 --max-level 0 --no-textures --with-body" +
                                             " --export '" + folder / "plain.obj" + "'");
    EXPECT_NE(plain.exit_code, 2) << plain.err;
    EXPECT_EQ(content_of(folder / "plain.obj").find("mtllib"), std::string::npos);
    EXPECT_NE(content_of(folder / "plain.obj").find("\ng mannequin"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder / "plain.mtl"));
}

TEST_F(DressCommand, exports_of_all_formats_hold_the_body_when_asked_to) {
    const ScratchFolder folder;
    const ProgramResult dressed =
        run_selvedge("dress " + shipped("two_squares.json") +
                     " --body mannequin:resolution=1 --max-level 0 --seconds 0.05 -q --with-body --export '" +
                     folder / "x.ply" + "' --export '" + folder / "x.stl" + "'");
    EXPECT_EQ(dressed.exit_code, 3) << dressed.err;
    EXPECT_NE(content_of(folder / "x.ply").find("comment panel -1 is the body"), std::string::npos);
    EXPECT_NE(content_of(folder / "x.stl").find("triangles, then the body"), std::string::npos);
}

// How often each edge of an STL file occurs in each direction, by the bytes of its ends.
std::map<std::pair<std::string, std::string>, int> edges_in_stl(const std::string& bytes) {
    constexpr std::size_t kHeader = 84, kTriangle = 50, kVector = 12;
    std::map<std::pair<std::string, std::string>, int> uses;
    for (std::size_t at = kHeader; at + kTriangle <= bytes.size(); at += kTriangle) {
        const auto corner = [&](std::size_t k) { return bytes.substr(at + (1 + k % 3) * kVector, kVector); };
        for (std::size_t k = 0; k < 3; ++k) ++uses[{corner(k), corner(k + 1)}];
    }
    return uses;
}

TEST_F(DressCommand, cloth_with_a_thickness_is_a_closed_solid) {
    const ScratchFolder folder;
    const auto dress = [&](const std::string& options) {
        const ProgramResult dressed =
            run_selvedge("dress " + shipped("two_squares.json") +
                         " --body mannequin:resolution=1 --max-level 1 --seconds 0.3 -q --export '" + folder / "x.stl" +
                         "' " + options);
        EXPECT_EQ(dressed.exit_code, 3) << dressed.err;
        return edges_in_stl(content_of(folder / "x.stl"));
    };
    const auto open_edges = [](const auto& edges) {
        return std::ranges::count_if(edges, [&](const auto& edge) {
            const auto back = edges.find({edge.first.second, edge.first.first});
            return edge.second != 1 || back == edges.end();
        });
    };
    EXPECT_GT(open_edges(dress("")), 0);
    for (const std::string thickness : {"2.5", "fabric"}) {
        const auto edges = dress("--thickness " + thickness);
        EXPECT_GT(edges.size(), 100U);
        EXPECT_EQ(open_edges(edges), 0) << thickness;
    }
}

std::vector<std::string> lines_of(const std::string& file) {
    return lines_with(content_of(file), "");
}

TEST_F(DressCommand, an_element_of_garmentcodedata_has_a_line_of_segmentation_per_vertex) {
    const ScratchFolder folder;
    const std::string element = folder / "element";
    const ProgramResult dressed =
        run_selvedge("dress " + shipped("two_squares.json") +
                     " --body mannequin:resolution=1 --max-level 1 --seconds 0.3 -q --export-garmentcode '" + element +
                     "/' --export '" + folder / "x.obj" + "'");
    EXPECT_EQ(dressed.exit_code, 3) << dressed.err;
    const std::vector<std::string> rows = lines_of(element + "/two_squares_sim_segmentation.txt");
    const std::string obj = content_of(element + "/two_squares_sim.obj");
    EXPECT_EQ(rows.size(), lines_with(obj, "v ").size());
    EXPECT_EQ(lines_with(obj, "v ").size(), lines_with(content_of(folder / "x.obj"), "v ").size());
    EXPECT_EQ(lines_with(obj, "f ").size(), lines_with(content_of(folder / "x.obj"), "f ").size());
    EXPECT_NE(content_of(element + "/two_squares_sim.ply").find("element vertex " + std::to_string(rows.size()) + "\n"),
              std::string::npos);
    for (const std::string name : {"front", "back", "stitch_0", "stitch_1", "stitch_2", "stitch_3"})
        EXPECT_GT(std::ranges::count(rows, name), 0) << name;
    EXPECT_TRUE(std::ranges::is_partitioned(rows, [](const std::string& row) { return row.starts_with("stitch_"); }));
    EXPECT_EQ(content_of(element + "/two_squares_vertex_labels.yaml"), "{}\n");
    EXPECT_EQ(sim::load_pattern(element + "/two_squares_specification.json").pattern,
              sim::load_pattern(source_folder() + "/patterns/two_squares.json").pattern);
}

TEST(DressOutputs, an_element_of_garmentcodedata_does_not_replace_the_garment_that_is_dressed) {
    const ScratchFolder folder;
    const std::string garment = folder / "mine_specification.json";
    std::filesystem::copy_file(source_folder() + "/patterns/two_squares.json", garment);
    const ProgramResult refused =
        run_selvedge("dress '" + garment + "' --export-garmentcode '" + folder.path().string() + "'");
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_NE(refused.err.find("mine_specification.json"), std::string::npos) << refused.err;
    const ProgramResult nowhere =
        run_selvedge("dress '" + garment + "' --export-garmentcode '" + folder / "no/such" + "'");
    EXPECT_EQ(nowhere.exit_code, 2);
    EXPECT_EQ(count_lines(nowhere.err), 1) << nowhere.err;
    const ProgramResult file = run_selvedge("dress '" + garment + "' --export-garmentcode '" + garment + "'");
    EXPECT_EQ(file.exit_code, 2);
    EXPECT_NE(file.err.find("is a file: a folder is needed"), std::string::npos) << file.err;
}

TEST(DressOutputs, a_thickness_that_no_cloth_has_is_refused) {
    const ScratchFolder folder;
    for (const std::string thickness : {"0", "-1", "thick", "nan", "1,2", "51"}) {
        const ProgramResult refused = run_selvedge("dress " + shipped("two_squares.json") + " --export '" +
                                                   folder / "x.stl" + "' --thickness=" + thickness);
        EXPECT_EQ(refused.exit_code, 2) << thickness;
        EXPECT_EQ(count_lines(refused.err), 1) << refused.err;
        EXPECT_NE(refused.err.find("--thickness"), std::string::npos) << refused.err;
    }
    const ProgramResult alone = run_selvedge("dress " + shipped("two_squares.json") + " --thickness 1");
    EXPECT_EQ(alone.exit_code, 2);
    EXPECT_EQ(count_lines(alone.err), 1) << alone.err;
}

TEST(DressOutputs, a_texture_beside_an_export_is_an_output_like_others) {
    const ScratchFolder folder;
    const ProgramResult twice = run_selvedge("dress " + shipped("two_squares.json") + " --export '" + folder / "x.obj" +
                                             "' --render '" + folder / "x_colour.png" + "'");
    EXPECT_EQ(twice.exit_code, 2);
    EXPECT_NE(twice.err.find("x_colour.png"), std::string::npos) << twice.err;
}

TEST_F(DressCommand, each_way_of_looking_gives_another_picture) {
    const ScratchFolder folder;
    std::vector<std::string> pictures;
    for (const std::string options : {"--view front", "--view back", "--view left", "--view three-quarter"}) {
        const std::string picture = folder / std::to_string(pictures.size()) + ".png";
        const ProgramResult rendered =
            run_selvedge("render '" + file("garment.obj") + "' --size 96x96 " + options + " -o '" + picture + "'");
        ASSERT_EQ(rendered.exit_code, 0) << rendered.err;
        pictures.push_back(content_of(picture));
    }
    for (std::size_t i = 0; i < pictures.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(pictures[i] == pictures[j]) << i << " and " << j;
}

// A garment file that names the body in its folder, whose origin is at the chest, in decimetres.
TEST(DressOnAFile, takes_the_body_that_the_garment_names_and_raises_both_to_the_floor) {
    const ScratchFolder folder;
    ASSERT_EQ(run_selvedge("mannequin --resolution 1 -o '" + folder / "stand.obj" + "'").exit_code, 0);
    std::istringstream lines(content_of(folder / "stand.obj"));
    std::ofstream lowered(folder / "anna.obj");
    for (std::string line; std::getline(lines, line);) {
        double x = 0, y = 0, z = 0;
        if (std::sscanf(line.c_str(), "v %lf %lf %lf", &x, &y, &z) == 3) {
            lowered << "v " << 10 * x << ' ' << 10 * (y - 1.1) << ' ' << 10 * z << '\n';
        } else {
            lowered << line << '\n';
        }
    }
    lowered.close();
    sim::PatternDocument garment = sim::load_pattern(source_folder() + "/patterns/two_squares.json");
    garment.pattern.body = folder / "anna.obj";
    for (sim::Panel& panel : garment.pattern.panels) panel.translation.y() -= 1.1;
    save_pattern(garment, folder / "anna.json");
    EXPECT_NE(content_of(folder / "anna.json").find("\"body\": \"anna.obj\""), std::string::npos);

    const ProgramResult own = run_selvedge("dress '" + folder / "anna.json" + "' --max-level 0");
    EXPECT_EQ(own.exit_code, 0) << own.out << own.err;
    EXPECT_NE(own.out.find("on anna"), std::string::npos) << own.out;
    EXPECT_NE(own.out.find("note: assumed decimetres: 1.61 m tall"), std::string::npos) << own.out;
    EXPECT_NE(own.out.find("all panels moved up 1100 mm"), std::string::npos) << own.out;
    const ProgramResult other =
        run_selvedge("dress '" + folder / "anna.json" + "' --body mannequin:resolution=1 --max-level 0");
    EXPECT_EQ(other.exit_code, 0) << other.out << other.err;
    const ProgramResult over =
        run_selvedge("dress '" + folder / "anna.json" + "' --export-body '" + folder / "anna.obj" + "'");
    EXPECT_EQ(over.exit_code, 2) << over.out;
}

TEST(DressOnAFile, tells_warnings_as_notes_and_in_the_report_when_a_usable_file_has_faults) {
    const ScratchFolder folder;
    sim::Json garment = sim::read_json(source_folder() + "/patterns/two_squares.json");
    sim::Json& back = garment["pattern"]["panels"]["back"]["selvedge"];
    back["copy_of"] = "front";
    back["edge_keys"] = sim::parse_json(R"({"keys": [1], "last": 9})", "");
    back["grainlin"] = sim::Json(0.0);
    const std::string file = folder / "odd.json";
    std::ofstream(file) << write_json(garment);
    const ProgramResult checked = run_selvedge("check '" + file + "'");
    EXPECT_EQ(checked.exit_code, 0) << checked.out;
    EXPECT_EQ(count_lines(checked.out), 3) << checked.out;
    const ProgramResult dressed = run_selvedge("dress '" + file + "' --body mannequin:resolution=1 --max-level 0 " +
                                               "--report '" + folder / "report.json" + "'");
    EXPECT_EQ(dressed.exit_code, 0) << dressed.out << dressed.err;
    std::istringstream warnings(checked.out);
    const sim::Json report = sim::read_json(folder / "report.json");
    std::vector<std::string> notes;
    for (const sim::Json& note : report.find("notes")->elements()) notes.push_back(note.string());
    for (std::string line; std::getline(warnings, line);) {
        EXPECT_NE(line.find("pattern.panels.back"), std::string::npos) << line;
        EXPECT_NE(dressed.out.find("note: " + line + "\n"), std::string::npos) << line << '\n' << dressed.out;
        EXPECT_NE(std::ranges::find(notes, line), notes.end()) << line;
    }
}

TEST(DressDesigns, each_panel_shows_its_own_and_a_missing_picture_is_told_first) {
    const ScratchFolder folder;
    sim::PatternDocument document =
        sim::load_pattern(shipped("two_squares.json").substr(1, shipped("two_squares.json").size() - 2));
    document.pattern.surface = sim::SurfaceDesign{.kind = sim::DesignKind::Colour, .source = "#C81414"};
    document.pattern.panels[1].surface = sim::SurfaceDesign{.kind = sim::DesignKind::Colour, .source = "#1428C8"};
    sim::save_pattern(document, folder / "two.json");
    const std::string rest = " --body mannequin:resolution=1 --max-level 0 --size 128x128 --frame garment --view ";
    const auto mean = [&](const std::string& view) {
        const std::string file = folder / view + ".png";
        const ProgramResult result =
            run_selvedge("dress '" + (folder / "two.json") + "'" + rest + view + " --render '" + file + "'");
        EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
        const render::Image image = render::read_png(file);
        std::array<double, 3> sum{};
        for (const render::Rgba8& pixel : image.pixels) {
            for (std::size_t i = 0; i < 3; ++i) sum[i] += pixel[i];
        }
        return sum;
    };
    const auto front = mean("front"), back = mean("back");
    const bool is_front_red = document.pattern.panels[0].translation.z() > document.pattern.panels[1].translation.z();
    EXPECT_EQ(front[0] > front[2] + 1e5, is_front_red);
    EXPECT_EQ(back[2] > back[0] + 1e5, is_front_red);

    document.pattern.panels[1].surface = sim::SurfaceDesign{.kind = sim::DesignKind::Picture, .source = "gone.png"};
    sim::save_pattern(document, folder / "gone.json");
    const ProgramResult gone = run_selvedge("dress '" + (folder / "gone.json") + "'" + rest + "front");
    EXPECT_EQ(gone.exit_code, 2);
    EXPECT_NE(gone.err.find("gone.png"), std::string::npos) << gone.err;
    EXPECT_EQ(run_selvedge("check '" + (folder / "gone.json") + "'").exit_code, 2);
}

TEST(DressOver, names_the_garments_from_the_inside_out_and_what_is_assumed) {
    const ScratchFolder folder;
    const ProgramResult result =
        run_selvedge("dress " + shipped("tshirt.json") + " --over " + shipped("vest.json") +
                     " --body mannequin:resolution=1 --max-level 1 --report '" + folder / "report.json" + "'");
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
    EXPECT_NE(result.out.find("tshirt + vest on"), std::string::npos) << result.out;
    EXPECT_EQ(result.out.find("another tartan"), std::string::npos) << "each keeps its own";
    const sim::Json report = sim::read_json(folder / "report.json");
    const std::vector<sim::Json>& garments = report.find("garments")->elements();
    ASSERT_EQ(garments.size(), 2U);
    EXPECT_EQ(garments[0].string(), "tshirt");
    EXPECT_EQ(garments[1].string(), "vest");
}

TEST(DressOver, refuses_a_garment_that_cannot_be_worn_over_it_on_one_line) {
    for (const std::string& wrong : {std::string("--over nothing.json"), "--over " + shipped("fabrics/denim.json"),
                                     "--over " + shipped("vest.json") + " --no-self-collision"}) {
        const ProgramResult result = run_selvedge("dress " + shipped("tshirt.json") + " " + wrong);
        EXPECT_EQ(result.exit_code, 2) << wrong;
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
    }
}

}  // namespace
}  // namespace selvedge::app

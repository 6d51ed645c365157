// The library as its callers see it: this program is linked with the shared library and includes its public headers
// alone. What it writes is compared with the files of the program.
#include <selvedge/selvedge.h>

#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tests/app/run_program.h"
#include "tests/app/selvedge_program.h"
#include "tests/support/checkout.h"

namespace selvedge {
namespace {

std::filesystem::path pattern_file(const std::string& name) {
    return source_folder() + "/patterns/" + name;
}

// A drape that has hardly begun: quick, and with a defect.
constexpr double kMoment = 0.05;  // s

Result dressed_skirt(const DressOptions& options = {.seconds = kMoment}) {
    static const Body body = make_mannequin();
    return dress(load_pattern(pattern_file("skirt.json")), body, options);
}

const Result& skirt() {
    static const Result result = dressed_skirt();
    return result;
}

// The bits of positions.
std::string bits(const Mesh& mesh) {
    std::string text(mesh.positions.size() * sizeof mesh.positions.front(), '\0');
    std::memcpy(text.data(), mesh.positions.data(), text.size());
    return text;
}

template <class Run>
InputError error_of(const Run& run) {
    try {
        run();
    } catch (const InputError& error) {
        return error;
    }
    ADD_FAILURE() << "no InputError";
    return {"", "", ""};
}

TEST(Library, has_the_version_of_its_headers) {
    EXPECT_EQ(version(), std::to_string(SELVEDGE_VERSION_MAJOR) + "." + std::to_string(SELVEDGE_VERSION_MINOR) + "." +
                             std::to_string(SELVEDGE_VERSION_PATCH));
}

TEST(Library, writes_the_files_and_draws_the_picture_of_the_program) {
    const app::ScratchFolder folder;
    const app::ProgramResult program = app::run_selvedge(
        "dress " + app::shipped("skirt.json") + " -q --seconds 0.05 --texture-size 64 --with-body" +
        " --tartan 'Black Watch' --export " + folder / "p.obj" + " --export " + folder / "p.glb" + " --export " +
        folder / "p.ply" + " --size 120x160 --show strain --render " + folder / "p.png");
    ASSERT_EQ(program.exit_code, 3) << program.err;
    for (const std::string extension : {".obj", ".glb", ".ply"}) {
        write_garment(skirt(), folder / ("l" + extension),
                      {.looks = {.tartan = "Black Watch"}, .texture_size_px = 64, .has_body = true});
        std::string ours = app::content_of(folder / ("l" + extension));
        std::string theirs = app::content_of(folder / ("p" + extension));
        for (std::string* text : {&ours, &theirs})  // an .obj names the file with its materials
            if (const std::size_t at = text->find(".mtl"); extension == ".obj" && at != std::string::npos)
                text->erase(at - 1, 1);
        EXPECT_FALSE(ours.empty());
        EXPECT_TRUE(ours == theirs) << extension;
    }
    const Image image =
        draw(skirt(), {.width_px = 120, .height_px = 160, .show = "strain", .looks = {.tartan = "Black Watch"}});
    EXPECT_TRUE(encode_png(image) == app::content_of(folder / "p.png"));
    write_png(image, folder / "l.png");
    EXPECT_TRUE(encode_png(image) == app::content_of(folder / "l.png"));
}

TEST(Library, writes_a_solid_as_the_program_does) {
    const app::ScratchFolder folder;
    app::run_selvedge("dress " + app::shipped("skirt.json") + " -q --seconds 0.05 --thickness 2.5 --export " +
                      folder / "p.stl");
    write_garment(skirt(), folder / "l.stl", {.thickness = 0.0025});
    EXPECT_FALSE(app::content_of(folder / "p.stl").empty());
    EXPECT_TRUE(app::content_of(folder / "l.stl") == app::content_of(folder / "p.stl"));
}

TEST(Library, gives_a_mesh_whose_parts_fit_together) {
    const Mesh& mesh = skirt().mesh();
    const std::size_t count = mesh.triangles.size();
    ASSERT_GT(count, 0U);
    EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
    EXPECT_EQ(mesh.material.size(), count);
    EXPECT_EQ(mesh.panel.size(), count);
    EXPECT_EQ(mesh.level.size(), count);
    EXPECT_EQ(skirt().strain().size(), count);
    EXPECT_EQ(skirt().clearance().size(), mesh.positions.size());
    EXPECT_EQ(mesh.panel_names, skirt().pattern().panel_names());
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle) ASSERT_LT(vertex, mesh.positions.size());
    std::vector<bool> is_seen(skirt().pattern().seam_names().size());
    for (const std::vector<int>& seams : skirt().seams_of_vertices())
        for (const int seam : seams) is_seen.at(static_cast<std::size_t>(seam)) = true;
    EXPECT_EQ(std::count(is_seen.begin(), is_seen.end(), true), static_cast<long>(is_seen.size()));
}

TEST(Library, lists_faults_in_sentences_and_in_the_report_when_a_drape_has_defects) {
    EXPECT_EQ(skirt().verdict(), Verdict::Defect);
    EXPECT_FALSE(skirt().is_settled());
    ASSERT_FALSE(skirt().faults().empty());
    EXPECT_EQ(skirt().faults().front().kind, "not_settled");
    EXPECT_FALSE(skirt().faults().front().sentence.empty());
    EXPECT_NE(skirt().report().find("\"not_settled\""), std::string::npos);
}

TEST(Library, names_file_place_and_problem_of_wrong_input) {
    const InputError absent = error_of([] { load_pattern("absent.json"); });
    EXPECT_EQ(absent.file(), "absent.json");
    EXPECT_FALSE(absent.problem().empty());
    EXPECT_EQ(std::string(absent.what()), absent.file() + ": " + absent.problem());
    EXPECT_FALSE(absent.may_pass());
    EXPECT_EQ(error_of([] { parse_pattern("{\"pattern\": {\"panels\": 3}}", "it"); }).place(), "pattern.panels");
    const Pattern pattern = load_pattern(pattern_file("skirt.json"));
    EXPECT_EQ(error_of([&] { dress(pattern, {.seconds = 0}); }).place(), "seconds");
    EXPECT_EQ(error_of([&] { dress(pattern, {.threads = 0}); }).place(), "threads");
    EXPECT_NE(error_of([&] { dress(pattern, {.fabric = "nosuch"}); }).problem(), "");
    EXPECT_EQ(error_of([] { make_mannequin({.measures = {{"waste", 0.7}}}); }).place(), "waste");
    EXPECT_EQ(error_of([] { make_mannequin({.sex = static_cast<Sex>(2)}); }).place(), "sex");
    EXPECT_EQ(error_of([] { load_body("absent.obj"); }).file(), "absent.obj");
    EXPECT_EQ(error_of([] { write_garment(skirt(), "x.xyz"); }).file(), "x.xyz");
    EXPECT_EQ(error_of([] { write_garment(skirt(), "x.obj", {.texture_size_px = 3}); }).place(), "texture_size_px");
    EXPECT_EQ(error_of([] { draw(skirt(), {.looks = {.sett_size = 9}}); }).place(), "sett_size");
    EXPECT_EQ(error_of([] { draw(skirt(), {.view = "inside"}); }).place(), "view");
    EXPECT_EQ(error_of([] { draw(skirt(), {.camera = "1"}); }).place(), "camera");
    EXPECT_EQ(error_of([] { draw(skirt(), {.width_px = 0}); }).place(), "size");
    EXPECT_EQ(error_of([] { draw(skirt(), {.surface = "bumpy"}); }).place(), "surface");
    EXPECT_EQ(error_of([] { encode_png({.width_px = 2, .height_px = 2}); }).place(), "image");
}

TEST(Library, lists_the_faults_of_a_file_that_it_does_not_load) {
    const app::ScratchFolder folder;
    const std::vector<Fault> faults = check_pattern(folder / "absent.json");
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(faults.front().severity, Severity::Error);
    EXPECT_TRUE(load_pattern(pattern_file("skirt.json")).faults().empty());
    EXPECT_EQ(parse_pattern(load_pattern(pattern_file("skirt.json")).text()).seam_names(),
              load_pattern(pattern_file("skirt.json")).seam_names());
}

TEST(Library, ends_a_dressing_when_the_callers_function_says_so) {
    int calls = 0;
    const std::thread::id caller = std::this_thread::get_id();
    const DressOptions options{.seconds = kMoment, .progress = [&](double done, std::string_view phase) {
                                   EXPECT_EQ(std::this_thread::get_id(), caller);
                                   EXPECT_GE(done, 0);
                                   EXPECT_LE(done, 1);
                                   EXPECT_FALSE(phase.empty());
                                   return ++calls < 2;
                               }};
    EXPECT_THROW(dressed_skirt(options), Cancelled);
    EXPECT_EQ(calls, 2);
}

TEST(Library, throws_the_same_exception_when_the_progress_function_throws_one) {
    struct Own {};
    const auto throws_own = [](double, std::string_view) -> bool { throw Own(); };
    const auto throws_range = [](double, std::string_view) -> bool { throw std::range_error("the caller's"); };
    EXPECT_THROW(dressed_skirt({.seconds = kMoment, .progress = throws_own}), Own);
    EXPECT_THROW(dressed_skirt({.seconds = kMoment, .progress = throws_range}), std::range_error);
    EXPECT_EQ(bits(dressed_skirt().mesh()), bits(skirt().mesh())) << "it dresses as before";
}

TEST(Library, gives_the_same_bits_in_several_threads_at_once) {
    const Image picture = draw(skirt(), {.width_px = 64, .height_px = 64});
    std::vector<std::string> positions(2);
    std::vector<Image> pictures(2);
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < 2; ++i) {
        threads.emplace_back([&, i] {
            const Result result = dressed_skirt();
            positions[i] = bits(result.mesh());
            pictures[i] = draw(result, {.width_px = 64, .height_px = 64});
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (const std::string& one : positions) EXPECT_TRUE(one == bits(skirt().mesh()));
    for (const Image& one : pictures) EXPECT_TRUE(one.pixels == picture.pixels);
}

TEST(Library, dresses_garments_over_each_other_on_a_body_by_its_text) {
    const Pattern outer = load_pattern(pattern_file("two_squares.json")),
                  inner = load_pattern(pattern_file("skirt.json"));
    const Result result = dress(inner, make_body("mannequin:sex=male,height=180"),
                                {.over = {outer}, .seconds = 0.01, .edge_length = 0.1, .max_level = 0});
    EXPECT_EQ(result.pattern().panel_names().size(), inner.panel_names().size() + outer.panel_names().size());
    EXPECT_NEAR(result.body().measures().at("height"), 1.80, 0.01);
    EXPECT_NEAR(result.body().height(), 1.80, 0.01);
    EXPECT_EQ(result.mesh().level, std::vector<std::uint8_t>(result.mesh().triangles.size()));
}

}  // namespace
}  // namespace selvedge

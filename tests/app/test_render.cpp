// selvedge render, as a black box: every mode, camera and film; errors on one line for what cannot be drawn.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "render/image/image.h"
#include "tests/app/selvedge_program.h"
#include "tests/support/checkout.h"

namespace selvedge::app {
namespace {

// A square of two panels, each at an angle, with material coordinates.
constexpr const char* kGarment =
    "v -0.3 0.5 0.25\nv 0 0.5 0.3\nv 0.3 0.5 0.25\nv -0.3 1.1 0.25\nv 0 1.1 0.3\nv 0.3 1.1 0.25\n"
    "vt 0 0\nvt 0.3 0\nvt 0 0.6\nvt 0.3 0.6\n"
    "g left\nf 1/1 2/2 5/4\nf 1/1 5/4 4/3\n"
    "g right\nf 2/1 3/2 6/4\nf 2/1 6/4 5/3\n";

class RenderCommand : public testing::Test {
 protected:
    RenderCommand() { std::ofstream(folder_ / "garment.obj") << kGarment; }

    ProgramResult render(const std::string& options) const {
        const std::string size = options.find("--size") == std::string::npos ? "--size 64x64 " : "";
        return run_command(in_folder() + "'" + program_folder() + "/selvedge' render garment.obj " + size + options);
    }
    std::string in_folder() const { return "cd '" + folder_.path().string() + "' && "; }
    render::Image picture(const std::string& name) const { return render::read_png(folder_ / name); }
    std::string content(const std::string& name) const { return content_of(folder_ / name); }
    bool is_there(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
    int files() const {
        int count = 0;
        for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder_.path())) ++count;
        return count;
    }
    void expect_refused(const std::string& options, const std::string& word) const {
        SCOPED_TRACE(options);
        const int before = files();
        const ProgramResult result = render(options);
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_EQ(count_lines(result.err), 1) << result.err;
        EXPECT_EQ(result.err.rfind("selvedge: ", 0), 0U) << result.err;
        EXPECT_NE(result.err.find(word), std::string::npos) << result.err;
        EXPECT_EQ(files(), before) << "nothing is left behind";
    }

    ScratchFolder folder_;
};

TEST_F(RenderCommand, shows_a_colour_a_picture_or_the_test_pattern) {
    render::Image blue(4, 4, render::Rgba8{20, 40, 200, 255});
    write_png(folder_ / "blue.png", blue);
    ASSERT_EQ(render("-o tartan.png").exit_code, 0);
    ASSERT_EQ(render("--design '#1428C8' -o colour.png").exit_code, 0);
    ASSERT_EQ(render("--design blue.png --sett-size 10 -o picture.png").exit_code, 0);
    ASSERT_EQ(render("--design test -o test.png").exit_code, 0);
    const auto middle = [&](const std::string& name) { return picture(name).at(32, 32); };
    EXPECT_GT(middle("colour.png")[2], 2 * middle("colour.png")[0]);
    EXPECT_GT(middle("picture.png")[2], 2 * middle("picture.png")[0]);
    EXPECT_FALSE(picture("test.png") == picture("tartan.png"));
    expect_refused("--design '#12' -o bad.png", "'#12' is no colour");
    expect_refused("--design none.png -o bad.png", "none.png");
    expect_refused("--design garment.obj -o bad.png", "neither a PNG nor a JPEG");
    expect_refused("--design test --tartan gingham -o bad.png", "--tartan");
}

TEST_F(RenderCommand, a_curved_surface_is_another_picture_and_flat_with_its_own_triangles_is_not) {
    ASSERT_EQ(render("--show plain -o own.png").exit_code, 0);
    ASSERT_EQ(render("--show plain --surface flat --surface-level 0 -o flat.png").exit_code, 0);
    ASSERT_EQ(render("--show plain --surface constant --surface-level 3 -o curved.png").exit_code, 0);
    ASSERT_EQ(render("--show plain --surface constant -o adaptive.png").exit_code, 0);
    EXPECT_EQ(picture("own.png"), picture("flat.png"));
    EXPECT_FALSE(picture("own.png") == picture("curved.png"));
    EXPECT_FALSE(picture("own.png") == picture("adaptive.png"));
}

TEST_F(RenderCommand, a_curve_modifier_is_given_by_name_or_by_its_coefficients_and_soft_cap) {
    const std::string level = "--show plain --surface-level 2 ";
    ASSERT_EQ(render(level + "--surface quadratic -o named.png").exit_code, 0);
    ASSERT_EQ(render(level + "--surface 0,0,1,0 -o same.png").exit_code, 0);
    ASSERT_EQ(render(level + "--surface 2,0,1,0 -o more.png").exit_code, 0);
    ASSERT_EQ(render(level + "--surface 2,0,1,0 --surface-soft-cap 3 -o uncapped.png").exit_code, 0);
    EXPECT_EQ(picture("named.png"), picture("same.png"));
    EXPECT_FALSE(picture("named.png") == picture("more.png"));
    EXPECT_FALSE(picture("more.png") == picture("uncapped.png"));
}

TEST_F(RenderCommand, back_faces_are_coarse_only_where_they_are_not_seen) {
    const std::string edges = "--show edges --surface constant --size 256x256 ";
    ASSERT_EQ(render(edges + "-o front.png").exit_code, 0);
    ASSERT_EQ(render(edges + "--back-face-coarsening -o front_coarsened.png").exit_code, 0);
    EXPECT_EQ(picture("front.png"), picture("front_coarsened.png"));
    ASSERT_EQ(render(edges + "--view back -o back.png").exit_code, 0);
    ASSERT_EQ(render(edges + "--view back --back-face-coarsening -o back_coarsened.png").exit_code, 0);
    EXPECT_FALSE(picture("back.png") == picture("back_coarsened.png"));
}

TEST_F(RenderCommand, surfaces_are_refused_by_one_line) {
    expect_refused("-o x.png --surface wavy", "--surface: 'wavy' is none of flat, constant");
    expect_refused("-o x.png --surface 1,2,3", "nor four numbers K0,K1,K2,K3");
    expect_refused("-o x.png --surface 1,2,3,nan", "nor four numbers K0,K1,K2,K3");
    expect_refused("-o x.png --surface 1,2,3,101", "each of K0 to K3 must be from -100 to 100");
    expect_refused("-o x.png --surface flat --surface-soft-cap 0", "'0' is not a number from 0.001 to 100");
    expect_refused("-o x.png --surface-soft-cap 1", "--surface");
    expect_refused("-o x.png --surface flat --surface-level 9", "'9' is neither adaptive nor a level from 0 to 6");
    expect_refused("-o x.png --surface flat --surface-level -1", "neither adaptive nor a level");
    expect_refused("-o x.png --surface-level 2", "--surface");
    expect_refused("-o x.png --surface flat --surface-normals rough", "none of recomputed, interpolated");
    expect_refused("-o x.png --fabric velour", "no fabric 'velour'");
}

TEST_F(RenderCommand, a_mesh_on_which_no_surface_can_stand_is_refused_by_its_edge) {
    std::ofstream(folder_ / "garment.obj") << kGarment << "f 2/2 5/4 4/3\n";
    expect_refused("-o x.png --surface constant", "--surface: edge 1-2: is shared by 3 triangles");
}

TEST_F(RenderCommand, from_below_the_floor_the_figure_is_seen_whole) {
    const std::string figure = "--body mannequin:resolution=1 --show plain --size 128x128 --transparent --camera ";
    ASSERT_EQ(render(figure + "30,10 -o above.png").exit_code, 0);
    ASSERT_EQ(render(figure + "30,-60 -o below.png").exit_code, 0);
    const auto opaque = [](const render::Image& image) {
        return std::count_if(image.pixels.begin(), image.pixels.end(),
                             [](const render::Rgba8& p) { return p[3] == 255; });
    };
    EXPECT_GT(opaque(picture("above.png")), 500);
    EXPECT_GT(opaque(picture("below.png")), 500);
}

TEST_F(RenderCommand, silk_takes_light_otherwise_than_wool) {
    ASSERT_EQ(render("--show plain --fabric silk -o silk.png").exit_code, 0);
    ASSERT_EQ(render("--show plain --fabric wool_twill -o wool.png").exit_code, 0);
    EXPECT_FALSE(picture("silk.png") == picture("wool.png"));
}

TEST_F(RenderCommand, every_mode_that_a_mesh_file_can_show_gives_another_picture) {
    std::vector<render::Image> pictures;
    for (const std::string mode : {"tartan", "plain", "edges", "level", "vertices", "strain-warp", "strain-weft",
                                   "clearance", "panels", "seams"}) {
        const ProgramResult result =
            render("--body mannequin:resolution=1 --frame garment --show " + mode + " -o x.png");
        ASSERT_EQ(result.exit_code, 0) << mode << result.err;
        for (const render::Image& other : pictures) EXPECT_FALSE(picture("x.png") == other) << mode;
        pictures.push_back(picture("x.png"));
    }
}

TEST_F(RenderCommand, what_a_mode_lacks_is_said_on_one_line) {
    expect_refused("--show hierarchy -o x.png", "dress");
    expect_refused("--show clearance -o x.png", "--body");
    std::ofstream(folder_ / "garment.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    expect_refused("--show strain -o x.png", "material coordinates");
}

TEST_F(RenderCommand, cameras_in_numbers_look_from_there) {
    ASSERT_EQ(render("--camera 0,4.010704565915763 -o a.png").exit_code, 0);
    ASSERT_EQ(render("--view front -o b.png").exit_code, 0);
    EXPECT_TRUE(picture("a.png") == picture("b.png")) << "the front, as degrees";
    ASSERT_EQ(render("--camera -30,-10,2 -o c.png").exit_code, 0) << "a negative number is no option";
    ASSERT_EQ(render("--camera 0,0.8,3,0,0.8,0 -o d.png").exit_code, 0);
    ASSERT_EQ(render("--camera 0,3,0,0,0.8,0 -o e.png").exit_code, 0) << "straight down";
    EXPECT_FALSE(picture("a.png") == picture("c.png"));
    EXPECT_FALSE(picture("a.png") == picture("d.png"));
}

TEST_F(RenderCommand, every_view_gives_another_picture) {
    std::vector<render::Image> pictures;
    for (const std::string view :
         {"front", "back", "left", "right", "three-quarter", "three-quarter-back", "top", "close", "hem"}) {
        ASSERT_EQ(render("--view " + view + " -o x.png").exit_code, 0) << view;
        for (const render::Image& other : pictures) EXPECT_FALSE(picture("x.png") == other) << view;
        pictures.push_back(picture("x.png"));
    }
}

TEST_F(RenderCommand, cameras_samples_and_films_that_cannot_be_are_said_on_one_line) {
    for (const char* numbers : {"1", "1,2,3,4", "a,b", "10,95", "10,10,0", "10,10,-2", "nan,0", "0,0,0,0,0,0",
                                "0,0,9999,0,0,0", "1,2,", ",1,2", "1 2"})
        expect_refused(std::string("-o x.png --camera '") + numbers + "'", "--camera");
    expect_refused("-o x.png --camera 0,0 --view front", "--camera");
    expect_refused("-o x.png --samples 3", "--samples");
    expect_refused("-o x.png --supersample 0", "--supersample");
    expect_refused("-o x.png --supersample 5", "--supersample");
    expect_refused("", "--turntable");
    expect_refused("--turntable film.avi", "film.avi");
    expect_refused("--turntable no/such/folder/film.mp4", "cannot write");
    expect_refused("--turntable no/such/folder/", "cannot write");
    expect_refused("--turntable out/ --frames 0", "--frames");
    expect_refused("--turntable out/ --fps 0", "--fps");
    expect_refused("--turntable out/ --fps 1000", "--fps");
    expect_refused("--turntable film.gif --fps 60", "at most 50");
    expect_refused("-o x.png --frames 3", "--turntable");
    std::ofstream(folder_ / "out") << "a file\n";
    expect_refused("--turntable out/", "not a folder");
}

TEST_F(RenderCommand, more_samples_than_there_are_get_one_line_that_names_another_way) {
    const ProgramResult result = render("-o x.png --samples 8");
    if (result.exit_code == 0) GTEST_SKIP() << "eight samples can be drawn here";
    expect_refused("-o x.png --samples 8", "--supersample");
    EXPECT_EQ(render("-o x.png --samples 1 --supersample 2").exit_code, 0);
}

TEST_F(RenderCommand, a_turntable_of_frames_turns_once_and_begins_with_the_picture) {
    const ProgramResult result = render("--view three-quarter --turntable out/ --frames 4 --transparent");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    std::vector<render::Image> frames;
    for (const char* name : {"out/frame_0001.png", "out/frame_0002.png", "out/frame_0003.png", "out/frame_0004.png"}) {
        frames.push_back(picture(name));
        EXPECT_EQ(frames.back().at(0, 0)[3], 0) << "transparent";
        for (std::size_t i = 0; i + 1 < frames.size(); ++i) EXPECT_FALSE(frames[i] == frames.back());
    }
    EXPECT_FALSE(is_there("out/frame_0005.png"));
    expect_refused("--turntable out/ --frames 3", "of an earlier, longer film");
    ASSERT_EQ(render("--view three-quarter --turntable turn.frames --frames 2 --transparent").exit_code, 0);
    EXPECT_TRUE(is_there("turn.frames/frame_0002.png"));
}

// The bounding box of what is drawn, px: rows show the zoom, columns show whether something is cut off.
struct Extent {
    int left = 1000, right = -1, top = 1000, bottom = -1;
};

Extent extent_of(const render::Image& image) {
    Extent extent;
    for (int y = 0; y < image.height_px; ++y) {
        for (int x = 0; x < image.width_px; ++x) {
            if (image.at(x, y)[3] < 250) continue;
            extent = {std::min(extent.left, x), std::max(extent.right, x), std::min(extent.top, y),
                      std::max(extent.bottom, y)};
        }
    }
    return extent;
}

TEST_F(RenderCommand, the_figure_stays_in_the_frame_of_a_turntable_and_its_size_does_not_pump) {
    ASSERT_EQ(render("--turntable out/ --frames 12 --transparent --show panels").exit_code, 0);
    int shortest = 1000, tallest = 0;
    for (int i = 1; i <= 12; ++i) {
        const std::string name = "out/frame_00" + std::string(i < 10 ? "0" : "") + std::to_string(i) + ".png";
        const Extent extent = extent_of(picture(name));
        EXPECT_GT(extent.left, 0) << name;
        EXPECT_LT(extent.right, 63) << name;
        EXPECT_GT(extent.top, 0) << name;
        EXPECT_LT(extent.bottom, 63) << name;
        shortest = std::min(shortest, extent.bottom - extent.top);
        tallest = std::max(tallest, extent.bottom - extent.top);
    }
    EXPECT_GT(shortest, 30);
    EXPECT_LT(tallest - shortest, 12) << "what perspective does, and no more";
}

TEST_F(RenderCommand, films_are_whole_and_leave_no_other_file) {
    if (run_command("command -v ffmpeg").exit_code != 0) GTEST_SKIP() << "ffmpeg is not installed";
    const int before = files();
    ASSERT_EQ(render("--turntable film.mp4 --frames 5 --fps 10").exit_code, 0);
    ASSERT_EQ(render("--turntable film.gif --frames 5 --fps 10").exit_code, 0);
    EXPECT_EQ(content("film.mp4").substr(4, 4), "ftyp");
    EXPECT_EQ(content("film.gif").substr(0, 6), "GIF89a");
    EXPECT_EQ(files(), before + 2);
    const ProgramResult count = run_command(in_folder() +
                                            "ffprobe -v error -count_frames -show_entries stream=nb_read_frames -of "
                                            "csv=p=0 film.mp4");
    EXPECT_EQ(count.out, "5\n") << count.err;
    const std::string first = content("film.mp4");
    ASSERT_EQ(render("--turntable film.mp4 --frames 5 --fps 10").exit_code, 0);
    EXPECT_TRUE(content("film.mp4") == first) << "same scene, same bytes";
}

TEST_F(RenderCommand, a_film_that_cannot_be_encoded_leaves_the_old_one) {
    if (run_command("command -v ffmpeg").exit_code != 0) GTEST_SKIP() << "ffmpeg is not installed";
    expect_refused("--turntable film.mp4 --size 65x64", "even");
    expect_refused("--turntable film.gif --transparent", "transparen");
    std::ofstream(folder_ / "film.mp4") << "old\n";
    std::filesystem::create_directory(folder_ / "bin");
    std::ofstream(folder_ / "bin/ffmpeg") << "#!/bin/sh\necho 'no such encoder' >&2\nexit 1\n";
    ASSERT_EQ(run_command("chmod +x '" + folder_ / "bin/ffmpeg" + "'").exit_code, 0);
    const ProgramResult result =
        run_command(in_folder() + "PATH=\"$PWD/bin:$PATH\" '" + program_folder() +
                    "/selvedge' render garment.obj --size 64x64 -q --turntable film.mp4 --frames 3");
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(count_lines(result.err), 1) << result.err;
    EXPECT_NE(result.err.find("no such encoder"), std::string::npos) << result.err;
    EXPECT_EQ(content("film.mp4"), "old\n");
    EXPECT_EQ(files(), 3) << "garment, old film, bin";
}

TEST_F(RenderCommand, without_ffmpeg_the_missing_package_is_named) {
    const ProgramResult result = run_command(in_folder() + "PATH=/no/such/folder '" + program_folder() +
                                             "/selvedge' render garment.obj --turntable film.mp4");
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(count_lines(result.err), 1) << result.err;
    EXPECT_NE(result.err.find("package ffmpeg"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace selvedge::app

// selvedge animate, as a black box: films, caches and reports, an early stop, and wrong input.
#include <gtest/gtest.h>
#include <algorithm>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>

#include "render/image/image.h"
#include "sim/core/json.h"
#include "tests/app/selvedge_program.h"
#include "tests/support/checkout.h"

namespace selvedge::app {
namespace {

const std::string kQuick = " --body mannequin:resolution=1 --max-level 0 --blend 0.2 --fps 10 --size 96x128 ";

std::size_t files_in(const std::filesystem::path& folder) {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder)) ++count;
    return count;
}

TEST(AnimateCommand, writes_a_film_caches_and_a_report) {
    const ScratchFolder folder;
    const ProgramResult run =
        run_selvedge("animate " + shipped("tshirt.json") + kQuick + "--motion walk --seconds 0.4 --film '" +
                     folder / "walk.frames" + "' --export '" + folder / "walk.pc2" + "' --export '" +
                     folder / "walk.glb" + "' --texture-size 128 --report '" + folder / "walk.json" + "'");
    ASSERT_TRUE(run.exit_code == 0 || run.exit_code == 3) << run.err;
    EXPECT_EQ(files_in(folder / "walk.frames"), 7U) << "0.6 s at 10 frames per second, and the first";
    EXPECT_EQ(render::read_png(folder / "walk.frames/frame_0007.png").height_px, 128);
    const sim::Json report = sim::read_json(folder / "walk.json");
    const sim::Json& animation = *report.find("animation");
    EXPECT_EQ(animation.find("motion")->string(), "walk");
    EXPECT_EQ(animation.find("frames")->number(), 7);
    EXPECT_FALSE(animation.find("has_bad_number")->boolean());
    const bool has_motion_fault = animation.find("faults")->elements().size() > 0;
    const bool has_defect = report.find("outcome")->string() == "defect";
    EXPECT_TRUE(has_defect || !has_motion_fault);
    EXPECT_EQ(run.exit_code == 3, has_defect);
    EXPECT_EQ(run.out.find("defect: in motion:") != std::string::npos, has_motion_fault);
    EXPECT_GT(report.find("timing")->find("ms_per_frame")->number(), 0);
    EXPECT_EQ(report.find("inputs")->elements().at(0).find("sha256")->string().size(), 64U);
    EXPECT_EQ(content_of(folder / "walk.pc2").substr(0, 11), "POINTCACHE2");
    EXPECT_TRUE(std::filesystem::exists(folder / "walk.obj")) << "the mesh of the cache";
    EXPECT_EQ(content_of(folder / "walk.glb").substr(0, 4), "glTF");
    EXPECT_NE(content_of(folder / "walk.glb").find("baseColorTexture"), std::string::npos);
}

TEST(AnimateCommand, gives_the_same_frames_for_any_number_of_threads) {
    const ScratchFolder folder;
    for (const std::string threads : {"1", "2"}) {
        const ProgramResult run =
            run_selvedge("animate " + shipped("tshirt.json") + kQuick + "--motion arms_up --seconds 0.2 --threads " +
                         threads + " --export '" + folder / ("up" + threads + ".pc2") + "'");
        ASSERT_EQ(run.exit_code, 0) << run.err;
    }
    EXPECT_EQ(content_of(folder / "up1.pc2"), content_of(folder / "up2.pc2"));
}

TEST(AnimateCommand, leaves_a_film_of_what_was_done_when_it_is_stopped) {
    const ScratchFolder folder;
    const ProgramResult run = run_command(
        "'" + program_folder() + "/selvedge' animate " + shipped("tshirt.json") + kQuick +
        "--motion walk --seconds 600 --export '" + folder / "walk.pc2" + "' --film '" + folder / "walk.frames" +
        "' & task=$!; for i in $(seq 300); do [ -e '" + folder / "walk.frames/frame_0003.png" +
        "' ] && break; sleep 0.1; done; kill -TERM $task; wait $task");
    EXPECT_EQ(run.exit_code, 128 + SIGTERM) << run.err;
    EXPECT_NE(run.err.find("stopped after"), std::string::npos) << run.err;
    EXPECT_TRUE(std::filesystem::exists(folder / "walk.pc2"));
    EXPECT_EQ(files_in(folder.path()), 3U) << "film, cache and its mesh, and no temporary file";
}

// How many pixels of a picture are strongly red, as the tartan is.
int red_pixels(const render::Image& image) {
    int red = 0;
    for (const render::Rgba8& pixel : image.pixels) red += pixel[0] > 2 * pixel[1] && pixel[0] > 2 * pixel[2] ? 1 : 0;
    return red;
}

TEST(AnimateCommand, fills_the_picture_with_the_garment_and_notes_the_end_of_the_motion) {
    const ScratchFolder folder;
    const auto film = [&](const std::string& name, const std::string& options) {
        return run_selvedge("animate " + shipped("tshirt.json") + kQuick +
                            "--motion arms_up --from 2.2 --to 2.5 --film '" + folder / name + "' " + options);
    };
    const ProgramResult all = film("all.frames", "");
    EXPECT_NE(all.out.find("note: 'arms_up' ends after 2.3 s"), std::string::npos) << all.out << all.err;
    film("garment.frames", "--frame garment");
    EXPECT_GT(red_pixels(render::read_png(folder / "garment.frames/frame_0002.png")),
              2 * red_pixels(render::read_png(folder / "all.frames/frame_0002.png")));
}

TEST(AnimateCommand, keeps_coarse_what_faces_away_from_the_camera) {
    const ScratchFolder folder;
    const auto triangles = [&](const std::string& options) {
        const ProgramResult run = run_selvedge(
            "animate " + shipped("tshirt.json") +
            " --body mannequin:resolution=1 --max-level 2 --motion A --blend 0.2 --seconds 0.2 --report '" +
            folder / "A.json" + "'" + options);
        const std::size_t at = run.out.find("about ");
        EXPECT_NE(at, std::string::npos) << run.out << run.err;
        return at == std::string::npos ? 0 : std::stoi(run.out.substr(at + 6));
    };
    const int all = triangles(""), fewer = triangles(" --coarse-back-faces");
    EXPECT_LT(fewer, 0.95 * all) << "so coarse a mesh keeps most triangles: those round a visible one stay fine";
}

TEST(AnimateCommand, notes_the_limbs_that_a_motion_has_no_joints_for) {
    const ScratchFolder folder;
    std::ofstream(folder / "nod.bvh")
        << "HIERARCHY ROOT Hips { OFFSET 0 0 0 CHANNELS 3 Xposition Yposition Zposition JOINT Neck { OFFSET 0 50 0 "
           "CHANNELS 1 Xrotation End Site { OFFSET 0 10 0 } } } MOTION Frames: 2 Frame Time: 0.1 0 90 0 0 0 90 0 20";
    const ProgramResult run =
        run_selvedge("animate " + shipped("tshirt.json") + kQuick + "--motion '" + folder / "nod.bvh" +
                     "' --seconds 0.2 --report '" + folder / "nod.json" + "'");
    EXPECT_NE(run.out.find("note: the motion's skeleton has no joint that is known as left_upper_arm, "
                           "right_upper_arm, left_upper_leg, right_upper_leg: not moved"),
              std::string::npos)
        << run.out << run.err;
    const sim::Json report = sim::read_json(folder / "nod.json");
    EXPECT_TRUE(std::ranges::any_of(report.find("notes")->elements(), [](const sim::Json& note) {
        return note.string().starts_with("the motion's skeleton has no joint");
    }));
    const sim::Json& input = report.find("inputs")->elements().at(2);  // after the garment and the body
    EXPECT_EQ(input.find("role")->string(), "motion");
    EXPECT_EQ(input.find("file")->string(), folder / "nod.bvh");
}

TEST(AnimateCommand, refuses_wrong_input_in_one_line) {
    const ScratchFolder folder;
    const std::string film = " --film '" + folder / "x.frames" + "'";
    const auto refused = [&](const std::string& options, const std::string& reason) {
        const ProgramResult run = run_selvedge("animate " + shipped("tshirt.json") + options);
        EXPECT_EQ(run.exit_code, 2) << options;
        EXPECT_EQ(count_lines(run.err), 1) << run.err;
        EXPECT_NE(run.err.find(reason), std::string::npos) << run.err;
    };
    refused("", "nothing to write");
    refused(film + " --motion moonwalk", "moonwalk");
    refused(film, "--motion");
    refused(film + " --motion walk --from 99", "--from");
    refused(film + " --motion walk --speed 0", "--speed");
    refused(" --motion walk --film '" + folder / "x.avi" + "'", "x.avi");
    refused(" --motion walk --export '" + folder / "x.abc" + "'", "x.abc");
    refused(film + " --motion walk --show hierarchy", "hierarchy");
    refused(film + " --motion '" + folder.path().string() + "'", "a folder is no motion");
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace selvedge::app

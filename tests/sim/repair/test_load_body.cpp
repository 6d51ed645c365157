#include "sim/repair/load_body.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <random>
#include <sstream>

#include "sim/collide/body_collider.h"
#include "sim/core/error.h"
#include "tests/support/bodies.h"
#include "tests/support/notes.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim {
namespace {

// A box as tall as a person, 40 cm wide, standing on the floor.
Body post() {
    return shapes::box({-0.2, 0, -0.1}, {0.2, 1.7, 0.1}, 6);
}

std::string obj_of(const Body& body, double scale = 1) {
    std::ostringstream text;
    text.precision(9);
    for (const Vec3d& p : body.x) text << "v " << scale * p.x() << ' ' << scale * p.y() << ' ' << scale * p.z() << '\n';
    for (const auto& [a, b, c] : body.triangles) text << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
    return text.str();
}

void write(const std::filesystem::path& path, const std::string& content) {
    std::ofstream(path, std::ios::binary) << content;
}

class LoadBody : public testing::Test {
 protected:
    Body load_text(const std::string& content, const LoadBodyOptions& options = {}) {
        write(folder_ / "body.obj", content);
        return load_body(folder_ / "body.obj", options, &report_);
    }
    std::string problem_of(const std::string& content, const char* name = "body.obj") {
        write(folder_ / name, content);
        try {
            load_body(folder_ / name);
        } catch (const InputError& error) {
            return error.problem();
        }
        return "none";
    }
    bool noted(const std::string& text) const { return has_note(report_.notes, text); }

    TemporaryFolder folder_;
    LoadBodyReport report_;
};

TEST_F(LoadBody, takes_a_sound_body_as_it_is_and_notes_nothing) {
    const Body body = load_text(obj_of(post()));
    EXPECT_EQ(body.x.size(), post().x.size());
    EXPECT_EQ(body.triangles.size(), post().triangles.size());
    EXPECT_TRUE(shapes::is_closed(body));
    EXPECT_NEAR(shapes::volume(body), 0.4 * 1.7 * 0.2, 1e-6);
    EXPECT_TRUE(report_.notes.empty());
    EXPECT_EQ(body.name, "body");
}

TEST_F(LoadBody, tells_centimetres_and_millimetres_by_the_height) {
    for (const double scale : {100.0, 1000.0}) {
        const Body body = load_text(obj_of(post(), scale));
        EXPECT_NEAR(height_range(body).high, 1.7, 1e-5);
        EXPECT_TRUE(noted("metres"));
    }
}

TEST_F(LoadBody, assumes_the_unit_in_which_the_body_has_the_size_of_a_person_and_says_so) {
    const Body grown = shapes::box({-0.2, 0, -0.15}, {0.2, 1.68, 0.15}, 6);
    const Body bust = shapes::box({-0.2, 0, -0.14}, {0.2, 0.75, 0.14}, 6);
    const std::array<std::pair<double, std::string>, 5> units{{{1, ""},
                                                               {10, "assumed decimetres"},
                                                               {100, "assumed centimetres"},
                                                               {1000, "assumed millimetres"},
                                                               {1 / 0.0254, "assumed inches"}}};
    for (const auto& [scale, note] : units) {
        for (const Body& whole : {grown, bust}) {
            const double height = height_range(whole).high;
            EXPECT_NEAR(height_range(load_text(obj_of(whole, scale))).high, height, 1e-5) << note << ' ' << height;
            EXPECT_EQ(report_.notes.empty(), note.empty());
            EXPECT_TRUE(note.empty() || noted(note + (height > 1 ? ": 1.68 m tall" : ": 0.75 m tall"))) << note;
        }
    }
}

TEST_F(LoadBody, takes_a_unit_that_is_named_and_refuses_a_size_that_no_unit_explains) {
    EXPECT_NEAR(height_range(load_text(obj_of(post(), 10), {.unit = LengthUnit::Centimetres})).high, 0.17, 1e-6);
    EXPECT_TRUE(noted("read as centimetres: 0.17 m tall"));
    EXPECT_NEAR(height_range(load_text(obj_of(post(), 40), {.unit = LengthUnit::Inches})).high, 1.7272, 1e-6);
    EXPECT_NE(problem_of(obj_of(post(), 0.01)).find("name its unit"), std::string::npos);
    EXPECT_NE(problem_of(obj_of(post(), 1e5)).find("name its unit"), std::string::npos);
}

TEST_F(LoadBody, turns_a_body_that_lies_along_z_upright_with_its_front_to_the_front) {
    Body lying = post();
    lying.x[0] -= Vec3d(0, 0, 0.05);  // a nose, towards -z at this point
    Body z_up = lying;
    for (Vec3d& p : z_up.x) p = Vec3d(p.x(), -p.z(), p.y());
    const Body body = load_text(obj_of(z_up));
    EXPECT_EQ(report_.up, UpAxis::Z);
    EXPECT_TRUE(noted("z up"));
    EXPECT_NEAR(height_range(body).high, 1.7, 1e-6);
    EXPECT_GT(shapes::volume(body), 0);
    for (std::size_t v = 0; v < body.x.size(); ++v) {
        double nearest = 1;
        for (const Vec3d& p : lying.x) nearest = std::min(nearest, (p - body.x[v]).norm());
        EXPECT_LT(nearest, 1e-6);
    }
}

TEST_F(LoadBody, stands_it_on_the_floor_and_says_so) {
    Body floating = post();
    for (Vec3d& p : floating.x) p.y() += 0.25;
    EXPECT_NEAR(height_range(load_text(obj_of(floating))).low, 0, 1e-9);
    EXPECT_NEAR(load_text(obj_of(floating)).lift, -0.25, 1e-6);
    EXPECT_TRUE(noted("floor"));
    EXPECT_NEAR(height_range(load_text(obj_of(floating), {.stands_on_floor = false})).low, 0.25, 1e-6);
}

TEST_F(LoadBody, welds_triangles_that_share_no_vertices) {
    Body soup;
    for (const auto& triangle : post().triangles) {
        const int first = int(soup.x.size());
        for (const int v : triangle) soup.x.push_back(post().x[std::size_t(v)]);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    const Body body = load_text(obj_of(soup));
    EXPECT_EQ(body.x.size(), post().x.size());
    EXPECT_TRUE(shapes::is_closed(body));
}

TEST_F(LoadBody, caps_a_small_hole_and_says_so) {
    Body holed = shapes::box({-0.2, 0, -0.1}, {0.2, 1.7, 0.1}, 14);
    holed.triangles.erase(holed.triangles.begin() + 4, holed.triangles.begin() + 6);
    const Body body = load_text(obj_of(holed));
    EXPECT_TRUE(shapes::is_closed(body));
    EXPECT_TRUE(noted("capped"));
    EXPECT_EQ(report_.repair.capped_holes, 1);
    EXPECT_NEAR(shapes::volume(body), 0.4 * 1.7 * 0.2, 1e-6);
}

TEST_F(LoadBody, refuses_a_body_with_a_missing_side) {
    Body open = post();
    std::erase_if(open.triangles, [&](const auto& triangle) {
        return std::all_of(triangle.begin(), triangle.end(), [&](int v) { return open.x[std::size_t(v)].z() > 0.09; });
    });
    EXPECT_NE(problem_of(obj_of(open)).find("it is open"), std::string::npos);
}

TEST_F(LoadBody, turns_an_inside_out_body_and_single_wrong_triangles) {
    Body wrong = post();
    for (auto& triangle : wrong.triangles) std::swap(triangle[0], triangle[1]);
    for (std::size_t t = 0; t < wrong.triangles.size(); t += 7) std::swap(wrong.triangles[t][0], wrong.triangles[t][1]);
    const Body body = load_text(obj_of(wrong));
    EXPECT_TRUE(shapes::is_closed(body));
    EXPECT_NEAR(shapes::volume(body), 0.4 * 1.7 * 0.2, 1e-6);
    EXPECT_TRUE(noted("turned"));
}

TEST_F(LoadBody, keeps_closed_pieces_and_leaves_out_open_and_inner_ones) {
    const Body hat = shapes::box({-0.1, 1.75, -0.1}, {0.1, 1.8, 0.1}, 2);
    const Body heart = shapes::box({-0.05, 1.0, -0.05}, {0.05, 1.1, 0.05}, 2);
    Body lashes;
    lashes.x = {{0, 1.6, 0.2}, {0.5, 1.6, 0.2}, {0, 1.9, 0.2}};
    lashes.triangles = {{0, 1, 2}};
    const Body body =
        load_text(obj_of(shapes::together(shapes::together(shapes::together(lashes, post()), hat), heart)));
    EXPECT_EQ(report_.repair.pieces, 2);
    EXPECT_EQ(report_.repair.dropped_pieces.size(), 2U);
    EXPECT_TRUE(noted("inside the body"));
    EXPECT_TRUE(noted("it is open"));
    EXPECT_TRUE(shapes::is_closed(body));
    EXPECT_EQ(body.triangles.size(), post().triangles.size() + hat.triangles.size());
}

// Two boxes, one on the other with a gap, each with a flat side of equal squares.
Body stacked(double gap) {
    return shapes::together(shapes::box({-0.2, 0, -0.1}, {0.2, 0.8, 0.1}, 4),
                            shapes::box({-0.2, 0.8 + gap, -0.1}, {0.2, 1.7, 0.1}, 4));
}

TEST_F(LoadBody, takes_a_closed_body_whose_parts_nearly_touch_as_it_is) {
    const Body body = load_text(obj_of(stacked(5e-7)));
    EXPECT_TRUE(shapes::is_closed(body));
    EXPECT_EQ(report_.repair.pieces, 2);
    EXPECT_EQ(body.x.size(), stacked(0).x.size());
    EXPECT_EQ(body.triangles.size(), stacked(0).triangles.size());
    EXPECT_TRUE(report_.notes.empty()) << report_.notes.front();
}

TEST_F(LoadBody, joins_parts_that_share_a_face_and_says_where) {
    const Body body = load_text(obj_of(stacked(0)));
    EXPECT_TRUE(shapes::is_closed(body));
    EXPECT_EQ(report_.repair.pieces, 1);
    EXPECT_NEAR(shapes::volume(body), 0.4 * 1.7 * 0.2, 1e-6);
    EXPECT_TRUE(noted("more than two triangles meet, the first at ("));
    EXPECT_TRUE(noted(", 0.800, "));
}

TEST_F(LoadBody, parts_what_touches_along_a_line) {
    const Body left = shapes::box({-0.2, 0, -0.1}, {0.2, 1.7, 0.1}, 4);
    const Body right = shapes::box({0.2, 0, 0.1}, {0.6, 1.7, 0.3}, 4);
    const Body body = load_text(obj_of(shapes::together(left, right)));
    EXPECT_TRUE(shapes::is_closed(body));
    EXPECT_EQ(report_.repair.pieces, 2);
    EXPECT_EQ(report_.repair.cuts.edges, 4);
    EXPECT_EQ(report_.repair.cuts.dropped, 0);
    EXPECT_EQ(body.triangles.size(), left.triangles.size() + right.triangles.size());
    Body inward = shapes::together(left, right);
    for (auto& triangle : inward.triangles) std::swap(triangle[0], triangle[1]);
    EXPECT_TRUE(shapes::is_closed(load_text(obj_of(inward))));
    EXPECT_EQ(report_.repair.pieces, 2);
}

TEST_F(LoadBody, leaves_out_a_fin_and_says_where) {
    Body forked = post();
    const auto [a, b, c] = forked.triangles.front();
    forked.x.emplace_back(0.5, 0.5, 0.5);
    forked.triangles.push_back({a, b, int(forked.x.size()) - 1});
    const Body body = load_text(obj_of(forked));
    EXPECT_TRUE(shapes::is_closed(body));
    EXPECT_EQ(body.triangles.size(), post().triangles.size());
    EXPECT_TRUE(noted("left out 1 triangle there")) << report_.notes.size();
}

TEST_F(LoadBody, leaves_out_a_wall_across_the_body) {
    Body walled = shapes::box({-0.2, 0, -0.1}, {0.2, 1.6, 0.1}, 4);
    const Body half = shapes::box({-0.2, 0.8, -0.1}, {0.2, 1.6, 0.1}, 4);
    const std::size_t outer = walled.triangles.size();
    const auto at = [&](const Vec3d& p) {
        const auto same = [&](const Vec3d& q) { return (p - q).norm() < 1e-9; };
        return int(std::find_if(walled.x.begin(), walled.x.end(), same) - walled.x.begin());
    };
    for (const auto& triangle : half.triangles) {
        std::array<int, 3> copy{};
        bool is_floor = true;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3d& p = half.x[std::size_t(triangle[k])];
            is_floor = is_floor && std::abs(p.y() - 0.8) < 1e-9;
            copy[k] = at(p);
            if (is_floor && copy[k] == int(walled.x.size())) walled.x.push_back(p);
        }
        if (is_floor) walled.triangles.push_back(copy);
    }
    ASSERT_EQ(walled.triangles.size(), outer + 32);
    const Body body = load_text(obj_of(walled));
    EXPECT_TRUE(shapes::is_closed(body));
    EXPECT_EQ(body.triangles.size(), outer);
    EXPECT_NEAR(shapes::volume(body), 0.4 * 1.6 * 0.2, 1e-6);
}

TEST_F(LoadBody, closes_a_body_with_a_bubble_on_one_edge) {
    Body pinched = shapes::box({-0.2, 0, -0.1}, {0.2, 1.7, 0.1}, 14);
    const auto [a, b, c] = pinched.triangles.front();
    const int tip = int(pinched.x.size());
    pinched.x.emplace_back(0.05, 0.3, -0.2);
    pinched.x.emplace_back(0.05, 0.3, -0.22);
    for (const auto& triangle : {std::array{a, b, tip}, {b, a, tip + 1}, {a, tip, tip + 1}, {b, tip + 1, tip}})
        pinched.triangles.push_back(triangle);
    EXPECT_TRUE(shapes::is_closed(load_text(obj_of(pinched))));
    EXPECT_EQ(report_.repair.cuts.edges, 1);
}

TEST_F(LoadBody, leaves_out_triangles_without_corners_of_their_own_or_twice_there) {
    Body doubled = post();
    doubled.triangles.push_back(doubled.triangles.front());
    doubled.triangles.push_back({3, 3, 4});
    const Body body = load_text(obj_of(doubled));
    EXPECT_EQ(body.triangles.size(), post().triangles.size());
    EXPECT_EQ(report_.repair.dropped_triangles, 2);
}

TEST_F(LoadBody, refuses_formats_that_are_not_on_the_list_by_name_and_by_content) {
    EXPECT_NE(problem_of("ply\nformat ascii 1.0\n", "body.ply").find("is not read"), std::string::npos);
    EXPECT_NE(problem_of("ply\nformat ascii 1.0\nelement vertex 3\n").find("not Wavefront OBJ"), std::string::npos);
    EXPECT_NE(problem_of("<COLLADA/>", "body.gltf").find("not glTF"), std::string::npos);
    EXPECT_NE(problem_of("v 0 0 0\n", "body.glb").find("not binary glTF"), std::string::npos);
    EXPECT_NE(problem_of("", "body.obj").find("not Wavefront OBJ"), std::string::npos);
    EXPECT_THROW(load_body(folder_ / "nothing_here.obj"), InputError);
}

TEST_F(LoadBody, refuses_numbers_that_are_not_finite_or_without_measure) {
    EXPECT_NE(problem_of("v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n"), "none");
    EXPECT_NE(problem_of("v 0 0 0\nv 1 0 0\nv 0 1e30 0\nf 1 2 3\n"), "none");
    EXPECT_NE(problem_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"), "none");
    EXPECT_NE(problem_of("v 0 0 0\nv 1 0 0\nv 0 1 0\n"), "none");
    EXPECT_NE(problem_of("v 0 0 0\nv 0 1 0\nv 0 2 0\nf 1 1 2\n"), "none");
}

TEST_F(LoadBody, survives_bytes_changed_anywhere) {
    std::mt19937 random(17);
    const std::string sound = obj_of(shapes::box({-0.2, 0, -0.1}, {0.2, 1.7, 0.1}, 2));
    for (int round = 0; round < 60; ++round) {
        std::string content = sound;
        for (unsigned i = 0; i <= random() % 4; ++i) content[random() % content.size()] = char(random());
        if (round % 5 == 0) content.resize(random() % content.size());
        write(folder_ / "mutant.obj", content);
        try {
            EXPECT_TRUE(shapes::is_closed(load_body(folder_ / "mutant.obj"))) << round;
        } catch (const InputError&) {
        }
    }
}

// Bodies from other sources.
class OutsideBodies : public testing::Test {
 protected:
    void SetUp() override {
        const char* folder = std::getenv("SELVEDGE_TEST_DATA");
        if (!folder) GTEST_SKIP() << "SELVEDGE_TEST_DATA is not set";
        data_ = folder;
    }
    std::filesystem::path data_;
};

TEST_F(OutsideBodies, serve_as_closed_bodies) {
    for (const char* name : {"mh_female.obj", "mh_female_cc1.obj", "mh_female_cmu01_01.glb", "CesiumMan.glb"}) {
        LoadBodyReport report;
        const Body body = load_body(data_ / "bodies" / name, {}, &report);
        EXPECT_TRUE(shapes::is_closed(body)) << name;
        EXPECT_GT(shapes::volume(body), 0.03) << name;
        EXPECT_NEAR(height_range(body).low, 0, 1e-6) << name;
        EXPECT_GT(height_range(body).high, 1.4) << name;
        EXPECT_LT(height_range(body).high, 2.0) << name;
        EXPECT_EQ(report.repair.pieces, 1) << name;
    }
}

TEST_F(OutsideBodies, bring_their_bones_and_weights_along) {
    const Body body = load_body(data_ / "bodies" / "mh_female_cmu01_01.glb");
    ASSERT_EQ(body.bones.size(), 31U) << "its joints, without the mesh's node and the root of the scene";
    ASSERT_EQ(body.skin.size(), body.x.size());
    for (std::size_t i = 0; i < body.bones.size(); ++i) {
        EXPECT_LT(body.bones[i].parent, int(i));
        EXPECT_GE(body.bones[i].joint.y(), 0);
        EXPECT_LE(body.bones[i].joint.y(), 1.7);
    }
    for (const SkinWeights& skin : body.skin)
        EXPECT_NEAR(skin.weights[0] + skin.weights[1] + skin.weights[2] + skin.weights[3], 1, 1e-5);
}

TEST_F(OutsideBodies, stand_at_rest_where_their_skeletons_hold_them) {
    // glTF of a body modelled with z up: only the skin's matrices turn it upright.
    const Body figure = load_body(data_ / "bodies" / "RiggedFigure.gltf");
    EXPECT_NEAR(height_range(figure).high, 1.45, 0.05);
    EXPECT_TRUE(shapes::is_closed(figure));
}

TEST_F(OutsideBodies, that_crash_readers_are_refused) {
    TemporaryFolder folder;
    ASSERT_FALSE(std::filesystem::is_empty(data_ / "hostile"));
    for (const auto& entry : std::filesystem::directory_iterator(data_ / "hostile")) {
        EXPECT_THROW(load_body(entry.path()), InputError) << entry.path();
        for (const char* disguise : {"disguised.obj", "disguised.gltf", "disguised.glb"}) {
            std::filesystem::copy_file(entry.path(), folder / disguise,
                                       std::filesystem::copy_options::overwrite_existing);
            std::filesystem::permissions(folder / disguise, std::filesystem::perms::owner_all);
            EXPECT_THROW(load_body(folder / disguise), InputError) << entry.path() << " as " << disguise;
        }
    }
}

TEST_F(OutsideBodies, have_a_distance_field_within_a_sixth_of_a_millimetre) {
    const Body body = load_body(data_ / "bodies" / "mh_female_cc1.obj");
    const BodyCollider collider(body);
    std::mt19937 random(9);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<float> errors;
    while (errors.size() < 20000) {
        const auto [a, b, c] = body.triangles[random() % body.triangles.size()];
        const Vec3d& at = body.x[std::size_t(a)];
        if (at.y() < 0.5 || at.y() > 1.36 || std::abs(at.x()) > 0.34) continue;  // where garments are
        const Vec3d normal = (body.x[std::size_t(b)] - at).cross(body.x[std::size_t(c)] - at).normalized();
        const Vec3f p = (at + normal * (0.016 * unit(random) - 0.004)).cast<float>();
        const float exact = collider.surface().closest(p, 1)->distance;
        const Contact contact = collider.contact(p);
        errors.push_back(std::abs(contact.distance - std::min(exact, collider.band())));
        if (std::abs(exact) > collider.max_error()) {
            EXPECT_EQ(contact.distance < 0, exact < 0);
        }
    }
    std::sort(errors.begin(), errors.end());
    EXPECT_LT(errors[errors.size() * 99 / 100], 0.00015F);
    EXPECT_LT(errors.back(), collider.max_error());
}

}  // namespace
}  // namespace selvedge::sim

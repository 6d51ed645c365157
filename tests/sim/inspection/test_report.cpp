// The report finds planted faults, names their places, and reports nothing else.
#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>

#include "sim/body/section.h"
#include "sim/collide/body_collider.h"
#include "sim/core/json.h"
#include "sim/inspection/inspection.h"
#include "sim/mesh/sew.h"
#include "tests/sim/dress/shapes.h"
#include "tests/support/bodies.h"
#include "tests/support/mannequin.h"

namespace selvedge::sim::test {
namespace {

using Keys = std::set<std::string>;

Keys keys_of(const Json& object) {
    Keys keys;
    for (const Json::Member& member : object.members()) keys.insert(member.key);
    return keys;
}

DressReport full_report() {
    DressReport report;
    report.inputs = {{.role = "garment", .file = "tshirt.json", .sha256 = std::string(64, 'a')}};
    report.fit = {{.measure = "waist",
                   .body_girth = 0.7,
                   .garment_girth = 0.9,
                   .plane = Plane{.point = {0, 1.02, 0}, .normal = {0, 1, 0}}}};
    report.garment = "tshirt";
    report.body = "mannequin";
    report.settled = true;
    report.stopped_because = "settled";
    report.simulated_seconds = 3.5;
    report.faults = {{"open_seam", "seam 2, 'front' edge 1 to 'back' edge 3", 0.012}};
    report.notes = {"panel 'front' moved 20 mm outward, clear of the body"};
    report.mesh = {.base_triangles = 700,
                   .leaf_triangles = 6000,
                   .leaf_vertices = 3100,
                   .by_level = {10, 20, 30, 40},
                   .min_angle_deg = 27.5,
                   .splits = 5000000000,
                   .rejoins = 12,
                   .transitions = 34};
    report.seams = {.count = 12, .open = 1, .worst_length_mismatch = 0.04};
    report.contact = {.inside = 3, .deepest_m = 0.0004};
    report.stretch = {.warp_weft_p50 = 0.001, .warp_weft_p99 = 0.02, .warp_weft_max = 0.03, .shear_deg_p99 = 12};
    report.timing = {.wall_s = 9,
                     .ms_per_adaptation = 1,
                     .ms_per_step = 2,
                     .ms_adapt_plus_4_steps = 9,
                     .phases_s = {{"draping", 7.0}, {"sewing", 2.0}},
                     .peak_memory_mb = 80};
    return report;
}

Json parsed(const DressReport& report) {
    return parse_json(to_json(report), "report.json");
}

TEST(Report, has_the_keys_that_were_promised_and_no_others) {
    const Json json = parsed(full_report());
    EXPECT_EQ(
        keys_of(json),
        (Keys{"schema", "version", "outcome",         "problem",           "inputs", "options", "garment", "garments",
              "body",   "settled", "stopped_because", "simulated_seconds", "work",   "faults",  "notes",   "fit",
              "mesh",   "seams",   "contact",         "stretch",           "timing"}));
    EXPECT_EQ(keys_of(json.find("inputs")->elements().at(0)), (Keys{"role", "file", "sha256"}));
    EXPECT_EQ(keys_of(*json.find("options")), (Keys{"fabric", "edge_length_m", "max_level", "shortest_edge_m",
                                                    "triangles", "criteria", "max_seconds", "self_collision"}));
    EXPECT_EQ(keys_of(json.find("faults")->elements().at(0)),
              (Keys{"kind", "class", "place", "value", "unit", "cause"}));
    EXPECT_EQ(keys_of(json.find("fit")->elements().at(0)),
              (Keys{"measure", "body_girth_m", "garment_girth_m", "ease_m", "plane_point_m", "plane_normal"}));
    EXPECT_EQ(keys_of(*json.find("mesh")), (Keys{"base_triangles", "leaf_triangles", "leaf_vertices", "by_level",
                                                 "min_angle_deg", "splits", "rejoins", "transitions"}));
    EXPECT_EQ(keys_of(*json.find("seams")), (Keys{"count", "open", "worst_length_mismatch"}));
    EXPECT_EQ(keys_of(*json.find("contact")),
              (Keys{"inside", "deepest_m", "faces_in_body", "edges_in_body", "deepest_face_m", "deepest_face_at",
                    "self_crossings", "self_crossing_m", "self_crossing_at", "on_lower_layer", "wrong_layer_order"}));
    EXPECT_EQ(keys_of(*json.find("stretch")),
              (Keys{"warp_weft_p50", "warp_weft_p99", "warp_weft_max", "shear_deg_p99"}));
    EXPECT_EQ(keys_of(*json.find("timing")), (Keys{"wall_s", "ms_per_adaptation", "ms_per_step",
                                                   "ms_adapt_plus_4_steps", "phases", "peak_memory_mb"}));
}

TEST(Report, has_the_same_keys_when_there_is_nothing_to_say) {
    const Json full = parsed(full_report());
    const Json empty = parsed(DressReport{});
    EXPECT_EQ(keys_of(empty), keys_of(full));
    EXPECT_TRUE(empty.find("faults")->elements().empty());
    EXPECT_EQ(keys_of(*empty.find("mesh")), keys_of(*full.find("mesh")));
}

TEST(Report, gives_back_what_was_put_in) {
    const Json json = parsed(full_report());
    const JsonView view(json, "report.json");
    EXPECT_EQ(view.at("garment").string(), "tshirt");
    EXPECT_TRUE(view.at("settled").boolean());
    EXPECT_EQ(view.at("simulated_seconds").number(), 3.5);
    EXPECT_EQ(view.at("faults").at(0).at("kind").string(), "open_seam");
    EXPECT_EQ(view.at("faults").at(0).at("value").number(), 0.012);
    EXPECT_EQ(view.at("inputs").at(0).at("file").string(), "tshirt.json");
    EXPECT_NEAR(view.at("fit").at(0).at("ease_m").number(), 0.2, 1e-12);
    EXPECT_EQ(view.at("fit").at(0).at("plane_point_m").numbers(), (std::vector<double>{0, 1.02, 0}));
    EXPECT_EQ(view.at("mesh").at("by_level").numbers(), (std::vector<double>{10, 20, 30, 40}));
    EXPECT_EQ(view.at("mesh").at("splits").number(), 5e9);
    EXPECT_EQ(view.at("contact").at("deepest_m").number(), 0.0004);
    EXPECT_EQ(view.at("stretch").at("warp_weft_max").number(), 0.03);
    EXPECT_EQ(view.at("timing").at("phases").at("sewing").number(), 2.0);
}

TEST(Report, notes_what_is_smaller_than_a_fault_of_its_kind) {
    for (const auto& [kind, small, large] :
         {std::tuple("self_crossing", 0.001, 0.003), {"not_settled", 0.009, 0.011}, {"wrong_layer_order", 2.0, 3.0}}) {
        DressReport report;
        add_fault(report, {.kind = kind, .place = "somewhere", .value = small});
        EXPECT_TRUE(report.faults.empty()) << kind;
        ASSERT_EQ(report.notes.size(), 1U) << kind;
        EXPECT_EQ(outcome_of(report), Outcome::Dressed) << kind;
        add_fault(report, {.kind = kind, .place = "somewhere", .value = large});
        EXPECT_EQ(report.faults.size(), 1U) << kind;
        EXPECT_EQ(outcome_of(report), Outcome::Defect) << kind;
    }
    DressReport report;
    add_fault(report, {.kind = "broken_mesh", .place = "edge 3", .value = 0});
    EXPECT_EQ(report.faults.size(), 1U) << "at any size";
    EXPECT_NEAR(note_below("not_settled"), static_cast<double>(DrapeOptions{}.rest_speed), 1e-6);
}

TEST(Report, tells_a_garment_that_does_not_fit_from_a_defect_of_the_drape) {
    DressReport report = full_report();
    report.faults.push_back({"does_not_fit", "too small at the waist (y 1.02 m) by 36.5 cm", 0.365});
    const Json json = parsed(report);
    const JsonView faults = JsonView(json, "report.json").at("faults");
    EXPECT_EQ(faults.at(0).at("class").string(), "defect");
    EXPECT_EQ(faults.at(1).at("class").string(), "does_not_fit");
}

TEST(Report, says_what_is_wrong_in_a_sentence_with_its_unit) {
    const auto cause = [](const char* kind, const char* place, double value) {
        return cause_of({.kind = kind, .place = place, .value = value});
    };
    EXPECT_EQ(cause("not_settled", "whole garment", 0.0123), "still moving by 12 mm/s at the end of its time");
    EXPECT_EQ(cause("open_seam", "seam 3", 0.012), "seam open by 1.2 cm: seam 3");
    EXPECT_EQ(cause("inside_body", "'front'", 0.0031), "3.1 mm inside the body: 'front'");
    EXPECT_EQ(cause("self_crossing", "12 pairs", 0.014), "crossing itself over 1.4 cm: 12 pairs");
    EXPECT_EQ(cause("overstretched", "'cuff'", 0.72), "stretched by 72 %: 'cuff'");
    EXPECT_EQ(cause("does_not_fit", "too small at the waist by 3.2 cm", 0.032), "too small at the waist by 3.2 cm");

    DressReport report = full_report();
    report.faults.push_back({.kind = "does_not_fit", .place = "too stretchy", .value = 3, .unit = "N"});
    const Json json = parsed(report);
    const JsonView faults = JsonView(json, "report.json").at("faults");
    EXPECT_EQ(faults.at(0).at("unit").string(), "m");
    EXPECT_EQ(faults.at(1).at("unit").string(), "N");
}

TEST(Report, an_outcome_is_that_of_its_worst_fault_and_has_its_exit_code) {
    const auto outcome = [](const DressReport& report) { return std::pair(outcome_of(report), parsed(report)); };
    DressReport report;
    EXPECT_EQ(outcome(report).first, Outcome::Dressed);
    report.faults.push_back({.kind = "does_not_fit", .place = "too small", .value = 0.1});
    EXPECT_EQ(outcome(report).first, Outcome::DoesNotFit);
    report.faults.push_back({.kind = "self_crossing", .place = "somewhere", .value = 0.1});
    EXPECT_EQ(outcome(report).first, Outcome::Defect);
    EXPECT_TRUE(outcome(report).second.find("problem")->is_null());
    report.problem = "x.json: no such file";
    EXPECT_EQ(outcome(report).second.find("outcome")->string(), "refused");
    EXPECT_EQ(outcome(report).second.find("problem")->string(), report.problem);
    const std::array codes{exit_code_of(Outcome::Dressed), exit_code_of(Outcome::Refused),
                           exit_code_of(Outcome::Defect), exit_code_of(Outcome::DoesNotFit)};
    EXPECT_EQ(codes, (std::array{0, 2, 3, 4}));
}

TEST(Report, survives_places_that_need_escaping) {
    DressReport report = full_report();
    report.faults[0].place = "panel \"a\\b\"\n'\u00e4rmel'";
    EXPECT_EQ(parsed(report).find("faults")->elements()[0].find("place")->string(), report.faults[0].place);
}

// A sewn cotton tube, 0.4 m wide and flat: front and back are 0.3 m apart, with a ball between them.
class Validate : public testing::Test {
 protected:
    Validate() { draped_.settled = true; }

    DressReport look() const {
        DressReport report;
        validate(cloth_, collider_, pattern_, open_seams_, draped_, report);
        return report;
    }
    const DressFault* find(const DressReport& report, const std::string& kind) const {
        const auto at = std::find_if(report.faults.begin(), report.faults.end(),
                                     [&](const DressFault& fault) { return fault.kind == kind; });
        return at == report.faults.end() ? nullptr : &*at;
    }
    // Replaces each position x by map(x).
    template <class Map>
    void deform(const Map& map) {
        for (Vec4f& x : cloth_.x) x = with_zero_w(map(Vec3f(x.head<3>())));
        cloth_.x_prev = cloth_.x;
    }

    static Pattern apart() {
        Pattern pattern = tube(0.4, 0.3, 0.8, 0.15);
        pattern.seams.clear();
        return pattern;
    }

    const Body ball_ = shapes::sphere(Vec3d(0, 0.95, 0), 0.1, 12);
    const BodyCollider collider_{ball_, {.cell = 0.006F, .band = 0.024F}};
    const Pattern pattern_ = apart();
    Cloth cloth_ = make_cloth(assemble(pattern_), {Fabric{}, Fabric{}});
    std::vector<OpenSeam> open_seams_;
    DrapeResult draped_;
};

TEST_F(Validate, finds_no_fault_where_there_is_none) {
    const DressReport report = look();
    EXPECT_TRUE(report.faults.empty()) << report.faults[0].kind << " " << report.faults[0].place;
    EXPECT_EQ(report.contact.inside, 0);
    EXPECT_EQ(report.contact.deepest_m, 0);
    EXPECT_NEAR(report.stretch.warp_weft_max, 0, 1e-4);
    EXPECT_EQ(report.mesh.leaf_triangles, int(cloth_.mesh.leaf_triangles().size()));
    EXPECT_EQ(report.mesh.leaf_vertices, int(cloth_.mesh.leaf_vertices().size()));
    ASSERT_EQ(report.mesh.by_level.size(), std::size_t(cloth_.mesh.max_level()) + 1);
    EXPECT_EQ(report.mesh.by_level[0], report.mesh.leaf_triangles);
}

TEST_F(Validate, finds_cloth_that_is_stretched_throughout) {
    deform([](const Vec3f& x) { return Vec3f(x.x(), 1.08F * x.y(), x.z()); });
    const DressReport report = look();
    EXPECT_NEAR(report.stretch.warp_weft_p99, 0.08, 1e-3);
    const DressFault* fault = find(report, "overstretched");
    ASSERT_NE(fault, nullptr);
    EXPECT_NEAR(fault->value, 0.08, 1e-3);
    EXPECT_EQ(report.faults.size(), 1U) << "8 % is no fault of the maximum";
}

TEST_F(Validate, lets_a_fabric_stretch_that_is_made_to) {
    for (Fabric& fabric : cloth_.material.fabrics) fabric.strain_limit = 0.1;  // a knit's
    deform([](const Vec3f& x) { return Vec3f(x.x(), 1.08F * x.y(), x.z()); });
    EXPECT_EQ(find(look(), "overstretched"), nullptr);
    deform([](const Vec3f& x) { return Vec3f(x.x(), 1.08F * x.y(), x.z()); });
    EXPECT_NE(find(look(), "overstretched"), nullptr);
}

TEST_F(Validate, finds_one_triangle_that_is_torn_apart_and_says_where) {
    const LeafTriangle& torn = cloth_.mesh.leaf_triangles()[3];
    cloth_.x[torn.v[0].value].z() += 0.1F;
    const DressReport report = look();
    EXPECT_GT(report.stretch.warp_weft_max, 0.15);
    const DressFault* fault = find(report, "overstretched");
    ASSERT_NE(fault, nullptr);
    EXPECT_NE(fault->place.find("'front'"), std::string::npos) << fault->place;
}

TEST_F(Validate, does_not_take_shear_for_stretch) {
    deform([](const Vec3f& x) { return Vec3f(x.x() + 0.2F * (x.y() - 1), x.y(), x.z()); });
    const DressReport report = look();
    EXPECT_NEAR(report.stretch.shear_deg_p99, 11.3, 0.2);
    EXPECT_EQ(find(report, "overstretched"), nullptr);
}

TEST_F(Validate, finds_cloth_in_the_body_and_how_deep) {
    deform([](const Vec3f& x) { return Vec3f(x.x(), x.y(), x.z() > 0 ? x.z() - 0.07F : x.z()); });
    const DressReport report = look();
    const DressFault* fault = find(report, "inside_body");
    ASSERT_NE(fault, nullptr);
    EXPECT_NE(fault->place.find("'front'"), std::string::npos) << fault->place;
    EXPECT_EQ(fault->place.find("'back'"), std::string::npos) << fault->place;
    EXPECT_GT(fault->value, 0.01);
    EXPECT_LT(fault->value, 0.0205) << "the plane at 0.08 m cuts a ball of 0.1 m by 0.02 m";
    EXPECT_EQ(report.contact.deepest_m, fault->value);
    EXPECT_GT(report.contact.inside, 0);
    EXPECT_EQ(report.faults.size(), 1U);
}

TEST_F(Validate, counts_but_forgives_what_is_inside_by_less_than_half_a_millimetre) {
    const std::uint32_t vertex = cloth_.mesh.leaf_vertices()[0].value;
    cloth_.x[vertex] = Vec4f(0, 0.95F, 0.0997F, 0);
    const DressReport report = look();
    EXPECT_EQ(report.contact.inside, 1);
    EXPECT_EQ(find(report, "inside_body"), nullptr);
}

TEST_F(Validate, says_that_a_garment_did_not_settle) {
    draped_.settled = false;
    draped_.fall_speed = 0.3F;
    const DressReport report = look();
    const DressFault* fault = find(report, "not_settled");
    ASSERT_NE(fault, nullptr);
    EXPECT_NEAR(fault->value, 0.3, 1e-6);
    EXPECT_EQ(report.faults.size(), 1U);
}

TEST_F(Validate, says_which_seam_is_open_between_which_panels) {
    Pattern sewn = tube(0.4, 0.3, 0.8, 0.15);
    open_seams_ = {{.seam = 1, .gap = 0.04F}};
    DressReport report;
    validate(cloth_, collider_, sewn, open_seams_, draped_, report);
    ASSERT_EQ(report.faults.size(), 1U);
    EXPECT_EQ(report.seams.open, 1);
    EXPECT_EQ(report.faults[0].kind, "open_seam");
    EXPECT_NEAR(report.faults[0].value, 0.04, 1e-6);
    EXPECT_NE(report.faults[0].place.find("front"), std::string::npos) << report.faults[0].place;
    EXPECT_NE(report.faults[0].place.find("back"), std::string::npos) << report.faults[0].place;
}

TEST_F(Validate, says_that_a_number_went_bad_and_trusts_no_other_figure) {
    const VertexId bad = cloth_.mesh.leaf_vertices()[5];
    cloth_.x[bad.value].setConstant(std::numeric_limits<float>::quiet_NaN());
    draped_.bad_vertex = bad;
    draped_.settled = false;
    const DressReport report = look();
    EXPECT_NE(find(report, "not_finite"), nullptr);
    EXPECT_NE(find(report, "not_settled"), nullptr);
    EXPECT_EQ(find(report, "inside_body"), nullptr);
}

TEST_F(Validate, describes_a_place_by_its_panel_and_its_coordinates) {
    const std::string place = describe_place(cloth_, pattern_, cloth_.mesh.leaf_vertices()[0]);
    EXPECT_NE(place.find("'front'"), std::string::npos) << place;
    EXPECT_NE(place.find("0.8"), std::string::npos) << place;
}

TEST_F(Validate, gives_the_leaves_as_a_draw_mesh) {
    const DrawMesh mesh = draw_mesh(cloth_, {"front", "back"});
    EXPECT_EQ(mesh.x.size(), cloth_.mesh.leaf_vertices().size());
    EXPECT_EQ(mesh.normals.size(), mesh.x.size());
    ASSERT_EQ(mesh.triangles.size(), cloth_.mesh.leaf_triangles().size());
    EXPECT_EQ(mesh.u.size(), mesh.triangles.size());
    EXPECT_EQ(mesh.level.size(), mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t v = mesh.triangles[t][k];
            ASSERT_LT(v, mesh.x.size());
            EXPECT_NEAR(mesh.normals[v].z(), mesh.panel[t] == 0 ? 1.0F : -1.0F, 1e-5F) << "outward, both of them";
        }
    }
}

// One triangle over the ball, whose edges pass it by.
class ValidateTriangle : public Validate {
 protected:
    DressReport report_at(double y) {
        GarmentMesh mesh;
        mesh.panel_names = {"front"};
        mesh.panel_grain_angles = {0};
        mesh.x = {Vec3d(-0.08, y, -0.06), Vec3d(0.08, y, -0.06), Vec3d(0, y, 0.1)};
        mesh.triangles = {{.vertices = {0, 1, 2}, .u = {Vec2d(-0.08, -0.06), Vec2d(0.08, -0.06), Vec2d(0, 0.1)}}};
        cloth_ = make_cloth(mesh, {Fabric{}});
        return look();
    }
};

TEST_F(ValidateTriangle, is_found_in_the_body_although_its_vertices_and_edges_are_outside) {
    const DressReport report = report_at(1.049);
    EXPECT_EQ(report.contact.inside, 0);
    EXPECT_EQ(report.contact.edges_in_body, 0);
    EXPECT_EQ(report.contact.faces_in_body, 1);
    EXPECT_NEAR(report.contact.deepest_face_m, 0.001, 4e-4);
    EXPECT_NE(report.contact.deepest_face_at.find("'front'"), std::string::npos) << report.contact.deepest_face_at;
    EXPECT_TRUE(report.faults.empty()) << "less than the contact offset";
}

TEST_F(ValidateTriangle, is_a_fault_where_it_is_deeper_than_the_contact_offset) {
    const DressReport report = report_at(1.044);
    EXPECT_EQ(report.contact.inside, 0);
    const DressFault* fault = find(report, "inside_body");
    ASSERT_NE(fault, nullptr);
    EXPECT_NEAR(fault->value, 0.006, 1e-3);
}

TEST_F(Validate, finds_a_triangle_that_passes_right_through_the_body) {
    const LeafTriangle& t = cloth_.mesh.leaf_triangles()[0];
    cloth_.x[t.v[0].value] = Vec4f(-0.2F, 0.95F, 0, 0);
    cloth_.x[t.v[1].value] = Vec4f(0.2F, 0.95F, 0, 0);
    const DressReport report = look();
    EXPECT_EQ(report.contact.inside, 0);
    EXPECT_GE(report.contact.edges_in_body, 1);
    const DressFault* fault = find(report, "through_body");
    ASSERT_NE(fault, nullptr);
    EXPECT_NEAR(fault->value, 0.1, 2e-3);
    EXPECT_NE(fault->place.find("'front'"), std::string::npos) << fault->place;
}

// A sewn cotton tube of this girth round a post of 0.7 m, stretched alike everywhere.
class ValidateTube : public testing::Test {
 protected:
    static constexpr double kGirth = 0.7, kHeight = 0.4;

    static Body post() {
        Body body = shapes::box(Vec3d(-1, 0, -1), Vec3d(1, 1.7, 1), 24);
        for (Vec3d& x : body.x) {
            const double out = std::max(std::abs(x.x()), std::abs(x.z()));
            if (out == 0) continue;
            const double radius = out * kGirth / (2 * std::numbers::pi);
            const Vec2d round = radius * Vec2d(x.x(), x.z()).normalized();
            x = {round.x(), x.y(), round.y()};
        }
        return body;
    }

    static Cloth cloth_on(double girth, double strain) {
        const Pattern pattern = tube(girth / 2, kHeight, 0.8, 0.3);
        GarmentMesh mesh = assemble(pattern, {.target_edge = 0.03});
        const double radius = (1 + strain) * girth / (2 * std::numbers::pi);
        for (Vec3d& x : mesh.x) {
            const double angle = std::numbers::pi * (x.z() > 0 ? x.x() / (girth / 2) : 1 - x.x() / (girth / 2));
            x = {radius * std::sin(angle), x.y(), radius * std::cos(angle)};
        }
        merge_seams(mesh);
        return make_cloth(mesh, {Fabric{}, Fabric{}});
    }

    static DrapeResult settled() {
        DrapeResult draped;
        draped.settled = true;
        return draped;
    }

    static DressReport report_on(double girth, double strain, const DrapeResult& draped = settled()) {
        const Pattern pattern = tube(girth / 2, kHeight, 0.8, 0.3);
        const Body body = post();
        const Cloth cloth = cloth_on(girth, strain);
        DressReport report;
        validate(cloth, BodyCollider(body, {.cell = 0.006F, .band = 0.024F}), pattern, {}, draped, report);
        return report;
    }

    static int count(const DressReport& report, const std::string& kind) {
        return int(std::ranges::count(report.faults, kind, &DressFault::kind));
    }
};

TEST_F(ValidateTube, excuses_the_stretch_that_tightness_explains) {
    const DressReport report = report_on(kGirth / 1.02, 0.06);  // 2 % too small; limit of the fabric 3 %
    EXPECT_EQ(count(report, "overstretched"), 0);
    EXPECT_EQ(count(report, "does_not_fit"), 0) << "2 % are within the fabric's limit";
    ASSERT_EQ(report.notes.size(), 1U);
    EXPECT_NE(report.notes[0].find("smaller than the body"), std::string::npos) << report.notes[0];
}

TEST_F(ValidateTube, does_not_excuse_more_stretch_than_tightness_explains) {
    const DressReport report = report_on(kGirth / 1.02, 0.30);
    EXPECT_EQ(count(report, "overstretched"), 2) << "the 99th percentile and the maximum";
}

TEST_F(ValidateTube, says_by_how_much_and_where_a_garment_is_too_small) {
    const DressReport report = report_on(kGirth - 0.1, 0.2);
    ASSERT_EQ(count(report, "does_not_fit"), 1);
    const DressFault& fault = *std::ranges::find(report.faults, "does_not_fit", &DressFault::kind);
    EXPECT_NEAR(fault.value, 0.1, 0.004);
    EXPECT_NE(fault.place.find("too small at the "), std::string::npos) << fault.place;
    EXPECT_NE(fault.place.find(" m) by 10."), std::string::npos) << fault.place;
    EXPECT_EQ(count(report, "overstretched"), 0) << "0.1 m of 0.6 m explain 17 %";
}

TEST_F(ValidateTube, blames_the_size_for_what_is_stretched_where_it_is_too_small) {
    const DressReport small = report_on(kGirth - 0.1, 0.5);
    EXPECT_EQ(count(small, "does_not_fit"), 1);
    EXPECT_EQ(count(small, "overstretched"), 0) << "50 %, of which tightness explains 17";
    EXPECT_EQ(outcome_of(small), Outcome::DoesNotFit);
    EXPECT_TRUE(std::ranges::any_of(small.notes, [](const std::string& note) {
        return note.starts_with("stretched by up to ") && note.ends_with(" % where it is too small");
    }));
    EXPECT_EQ(outcome_of(report_on(kGirth + 0.1, 0.5)), Outcome::Defect) << "nothing is too small there";
}

// Of a tube round both legs that is too small for them by so much, relative, with a stretched panel far above it.
Outcome outcome_of_tube_and_panel(double by, const std::string& garment_of_panel = {}) {
    const double y = 0.6, radius = 0.25, stretch = 1.5;
    const Plane level{.point = Vec3d(0, y, 0)};
    SectionLoop legs;
    for (const SectionLoop& loop : section(mannequin(), level))
        if (std::abs(loop.centre.x()) < radius) std::ranges::copy(loop.points, std::back_inserter(legs.points));
    const double girth = tape_length(legs, level) / (1 + by);
    Pattern pattern = tube(girth / 2, 0.1, y, 0.3);
    pattern.panels.push_back(pattern.panels[0]);
    pattern.panels.back().name = "above";
    pattern.panels.back().garment = garment_of_panel;
    pattern.panels.back().translation.y() += 1;
    GarmentMesh mesh = assemble(pattern, {.target_edge = 0.03});
    for (Vec3d& x : mesh.x) {
        const double angle = std::numbers::pi * (x.z() > 0 ? x.x() / (girth / 2) : 1 - x.x() / (girth / 2));
        if (x.y() > 1.2) {
            x.x() *= stretch;
        } else {
            x = {radius * std::sin(angle), x.y(), radius * std::cos(angle)};
        }
    }
    merge_seams(mesh);
    DrapeResult settled;
    settled.settled = true;
    DressReport report;
    validate(make_cloth(mesh, {Fabric{}, Fabric{}, Fabric{}}),
             BodyCollider(mannequin(), {.cell = 0.012F, .band = 0.048F}), pattern, {}, settled, report);
    EXPECT_TRUE(std::ranges::any_of(report.faults, [](const DressFault& f) { return f.kind == "does_not_fit"; }));
    return outcome_of(report);
}

TEST(ValidateTubeRoundLegs, blames_the_size_for_all_stretch_of_a_garment_that_is_far_too_small) {
    EXPECT_EQ(outcome_of_tube_and_panel(0.2), Outcome::DoesNotFit);
    EXPECT_EQ(outcome_of_tube_and_panel(0.05), Outcome::Defect) << "of the panel, which is far from the legs";
    EXPECT_EQ(outcome_of_tube_and_panel(0.2, "other"), Outcome::Defect) << "of another garment";
}

TEST_F(ValidateTube, knows_what_no_drape_makes_fit) {
    EXPECT_TRUE(is_too_small(cloth_on(kGirth - 0.1, 0.2), post()));
    EXPECT_FALSE(is_too_small(cloth_on(kGirth / 1.02, 0.06), post())) << "2 % are within the fabric's limit";
    EXPECT_FALSE(is_too_small(cloth_on(kGirth + 0.1, 0), post()));
}

TEST_F(ValidateTube, knows_how_far_beyond_its_limit_it_must_stretch) {
    const auto small = fits_nowhere(cloth_on(kGirth / 1.25, 0.25), post());
    ASSERT_TRUE(small);
    EXPECT_NEAR(excess_stretch(*small), 1.25 / (1 + Fabric{}.strain_limit) - 1, 0.01);
    EXPECT_FALSE(fits_nowhere(cloth_on(kGirth / 1.04, 0.04), post())) << "1 % beyond the fabric's limit is no fault";
    EXPECT_FALSE(fits_nowhere(cloth_on(kGirth + 0.1, 0), post()));
}

TEST_F(ValidateTube, is_called_too_small_for_what_it_was_when_it_was_sewn) {
    const auto small = fits_nowhere(cloth_on(kGirth - 0.1, 0.2), post());
    const Cloth crumpled = cloth_on(kGirth + 0.1, 0);  // its level cuts are longer than the loops round the body
    DressReport report;
    validate(crumpled, BodyCollider(post(), {.cell = 0.006F, .band = 0.024F}), tube(kGirth / 2, kHeight, 0.8, 0.3), {},
             settled(), report, {}, small);
    ASSERT_EQ(count(report, "does_not_fit"), 1);
    EXPECT_NEAR(std::ranges::find(report.faults, "does_not_fit", &DressFault::kind)->value, 0.1, 0.004);
}

TEST_F(ValidateTube, does_not_blame_the_drape_of_what_was_given_up) {
    DrapeResult given_up;
    given_up.given_up = GiveUp::TooSmall;
    const DressReport small = report_on(kGirth - 0.1, 0.2, given_up);
    EXPECT_EQ(count(small, "does_not_fit"), 1);
    EXPECT_EQ(count(small, "not_settled"), 0);
    EXPECT_EQ(count(report_on(kGirth - 0.1, 0.5, given_up), "overstretched"), 0) << "more than its tightness explains";
    EXPECT_EQ(count(report_on(kGirth + 0.1, 0, given_up), "not_settled"), 1) << "it was given up without a reason";
    given_up.given_up = GiveUp::SlipsDown;
    EXPECT_EQ(count(report_on(kGirth + 0.1, 0.5, given_up), "not_settled"), 0);
    EXPECT_EQ(count(report_on(kGirth + 0.1, 0.5, given_up), "overstretched"), 0);
}

TEST_F(ValidateTube, does_not_call_a_garment_without_ease_too_small) {
    const DressReport report = report_on(kGirth, 0.027);
    EXPECT_TRUE(report.faults.empty()) << report.faults[0].kind << " " << report.faults[0].place;
    EXPECT_TRUE(report.notes.empty()) << report.notes[0];
}

}  // namespace
}  // namespace selvedge::sim::test

// Garments that are worn over each other: the order in which they are sewn is the order in which they lie.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "sim/cloth/contact_surface.h"
#include "sim/collide/body_collider.h"
#include "sim/core/error.h"
#include "sim/dress/anchor.h"
#include "sim/dress/carry_over.h"
#include "sim/dress/dressing.h"
#include "sim/dress/garment_sewing.h"
#include "sim/inspection/layer_order.h"
#include "sim/mesh/sew.h"
#include "sim/pattern/garments.h"
#include "sim/session/dress.h"
#include "tests/sim/dress/shapes.h"
#include "tests/sim/dress/support.h"
#include "tests/support/mannequin.h"

namespace selvedge::sim::test {
namespace {

constexpr DistanceFieldOptions kCoarse{.cell = 0.006F, .band = 0.024F};

// The axis is the y axis.
Body post(double radius, double height) {
    constexpr int kAround = 24, kUp = 12;
    Body body;
    for (int j = 0; j <= kUp; ++j) {
        for (int i = 0; i < kAround; ++i) {
            const double angle = 2 * 3.14159265358979 * i / kAround;
            body.x.emplace_back(radius * std::sin(angle), height * j / kUp, radius * std::cos(angle));
        }
    }
    const auto at = [](int i, int j) { return j * kAround + i % kAround; };
    for (int j = 0; j < kUp; ++j) {
        for (int i = 0; i < kAround; ++i) {
            body.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            body.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    const int bottom = static_cast<int>(body.x.size()), top = bottom + 1;
    body.x.emplace_back(0, 0, 0);
    body.x.emplace_back(0, height, 0);
    for (int i = 0; i < kAround; ++i) {
        body.triangles.push_back({bottom, at(i + 1, 0), at(i, 0)});
        body.triangles.push_back({top, at(i, kUp), at(i + 1, kUp)});
    }
    return body;
}

// Two tubes, the second over the first, although its panels are placed nearer to the body.
Pattern two_tubes(double width = 0.36) {
    Pattern pattern = tube(width, 0.3, 0.85, 0.15), outer = tube(width + 0.04, 0.2, 0.9, 0.11);
    pattern.name = "inner";
    outer.name = "outer";
    pattern.body = outer.body = "mannequin:sex=female";
    put_over(pattern, outer);
    return pattern;
}

// The mean distance of a garment's leaf vertices from the y axis, m.
double mean_radius(const DrawMesh& mesh, std::uint16_t first_panel, std::uint16_t last_panel) {
    double sum = 0;
    int count = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (mesh.panel[t] < first_panel || mesh.panel[t] > last_panel) continue;
        for (const auto v : mesh.triangles[t]) {
            const Vec3f& x = mesh.x[static_cast<std::size_t>(v)];
            sum += static_cast<double>(std::hypot(x.x(), x.z()));
            ++count;
        }
    }
    return sum / count;
}

TEST(Dress, does_not_give_up_an_outfit_because_one_of_its_garments_slips) {
    Pattern skirt = tube(0.6, 0.5, 0.5, 0.2), top = tube(0.36, 0.3, 0.95, 0.15);
    skirt.name = "skirt";
    top.name = "top";
    skirt.body = top.body = "mannequin:sex=female";
    put_over(skirt, top);
    DressOptions options{.max_level = 0};
    options.max_seconds = 2;
    const DressReport report = dress(skirt, mannequin(), options).report;
    EXPECT_EQ(report.stopped_because, "time limit");
    EXPECT_NE(list_faults(report).find("does_not_fit: too large above the hips"), std::string::npos)
        << list_faults(report);
}

TEST(Dress, gives_up_what_takes_too_much_work_and_tells_what_moves) {
    Pattern top = tube(0.36, 0.3, 0.95, 0.15);
    top.body = "mannequin:sex=female";
    const DressReport report = dress(top, mannequin(), {.max_level = 0, .most_work = 1}).report;
    EXPECT_EQ(report.stopped_because, "work limit");
    EXPECT_LT(report.simulated_seconds, DrapeOptions{}.relax_time) << "the limit counts while it relaxes, too";
    EXPECT_FALSE(report.settled);
    const auto fault = std::ranges::find(report.faults, "not_settled", &DressFault::kind);
    ASSERT_NE(fault, report.faults.end()) << list_faults(report);
    EXPECT_NE(fault->place, kWholeGarment);
    EXPECT_GT(fault->value, 0);
    EXPECT_EQ(std::ranges::count(report.notes, "its fall was ended early, because it took more work than a drape may"),
              1);
}

TEST(Dress, says_of_an_outfit_known_to_be_too_small_that_it_does_not_fit_when_it_takes_too_much_work) {
    const DressReport report = dress(two_tubes(0.26), mannequin(), {.max_level = 0, .most_work = 1}).report;
    EXPECT_EQ(report.stopped_because, "too small");
    EXPECT_NE(list_faults(report).find("does_not_fit: too small"), std::string::npos) << list_faults(report);
}

TEST(GarmentSewing, closes_the_seams_of_the_outer_tube_outside_of_the_inner_one) {
    const Body body = post(0.1, 1.7);
    const BodyCollider collider(body, kCoarse);
    const Pattern pattern = two_tubes();
    GarmentSewing sewing(assemble(pattern), garments_of(pattern), fabrics_of(pattern), collider, {});
    double fraction = 0;
    do {
        EXPECT_GE(sewing.fraction(), fraction - 1e-9);
        fraction = sewing.fraction();
    } while (sewing.advance(collider));
    const std::vector<std::string> notes = sewing.take_notes();
    EXPECT_TRUE(std::ranges::any_of(notes, [](const std::string& note) {
        return note.find("'outer_front' moved ") != std::string::npos &&
               note.find("worn under it") != std::string::npos;
    }));
    const SewingResult result = std::move(sewing).result();
    const Cloth cloth = make_cloth(result.sewn, fabrics_of(pattern), {});
    const LayerOrder order = measure_layer_order(cloth);
    EXPECT_GT(order.judged, 30);
    EXPECT_EQ(order.wrong, 0);
    EXPECT_TRUE(find_crossing_triangles(contact_surface(cloth), cloth.x.front().data()).empty());
    EXPECT_TRUE(result.open.empty());
    EXPECT_FALSE(result.bad_vertex);
    EXPECT_TRUE(check_mesh(result.sewn).empty());
    GarmentMesh at_once = assemble(pattern);
    merge_seams(at_once);
    ASSERT_EQ(result.sewn.triangles.size(), at_once.triangles.size());
    for (std::size_t t = 0; t < at_once.triangles.size(); ++t)
        EXPECT_EQ(result.sewn.triangles[t].u, at_once.triangles[t].u);
}

TEST(GarmentSewing, of_one_garment_does_what_a_sewing_run_does) {
    const Body body = post(0.1, 1.7);
    const BodyCollider collider(body, kCoarse);
    const Pattern pattern = tube(0.36, 0.3, 0.8, 0.15);
    SewingRun alone(assemble(pattern), fabrics_of(pattern), {});
    while (alone.advance(collider)) {
    }
    GarmentSewing one(assemble(pattern), garments_of(pattern), fabrics_of(pattern), collider, {});
    while (one.advance(collider)) {
    }
    EXPECT_EQ(std::move(one).result().sewn.x, std::move(alone).result().sewn.x);
}

TEST(GarmentSewing, closes_a_seam_between_two_garments_with_the_outer_one) {
    const Body body = post(0.1, 1.7);
    const BodyCollider collider(body, kCoarse);
    Pattern pattern = two_tubes();
    pattern.seams.push_back({.first = {0, 2}, .second = {2, 2}, .is_reversed = false});  // upper edges of the fronts
    GarmentSewing sewing(assemble(pattern), garments_of(pattern), fabrics_of(pattern), collider, {});
    while (sewing.advance(collider)) {
    }
    const SewingResult result = std::move(sewing).result();
    EXPECT_TRUE(result.open.empty());
    GarmentMesh at_once = assemble(pattern);
    merge_seams(at_once);
    EXPECT_EQ(result.sewn.x.size(), at_once.x.size());
}

TEST(LayerOrder, counts_flat_vertices_that_lie_inside_of_a_lower_layer) {
    for (const bool is_right : {true, false}) {
        Pattern pattern;
        pattern.panels = {rectangle("inner", {.width = 0.3, .y = 1, .z = 0.1}),
                          rectangle("outer", {.width = 0.2, .height = 0.2, .y = 1.05, .z = is_right ? 0.11 : 0.09})};
        pattern.panels[1].layer = 1;
        const GarmentMesh mesh = assemble(pattern);
        const Cloth cloth = make_cloth(mesh, fabrics_of(pattern), {});
        const LayerOrder order = measure_layer_order(cloth);
        EXPECT_GT(order.judged, 10);
        EXPECT_EQ(order.wrong, is_right ? 0 : order.judged);
        EXPECT_EQ(order.wrong_vertex.has_value(), !is_right);
    }
}

TEST(LayerOrder, does_not_judge_panels_that_are_apart_or_of_one_layer) {
    Pattern pattern;
    pattern.panels = {rectangle("inner", {.z = 0.1}), rectangle("outer", {.z = 0.05})};
    pattern.panels[1].layer = 1;
    EXPECT_EQ(measure_layer_order(make_cloth(assemble(pattern), fabrics_of(pattern), {})).judged, 0);
    pattern.panels[1].translation.z() = 0.09;
    pattern.panels[1].layer = 0;
    EXPECT_EQ(measure_layer_order(make_cloth(assemble(pattern), fabrics_of(pattern), {})).judged, 0);
}

TEST(DressOver, two_tubes_hang_in_order) {
    DressOptions options;
    options.has_gravity = false;
    options.max_level = 2;
    options.max_seconds = 3;
    const DressedGarment dressed = dress(two_tubes(0.52), mannequin(), options);
    EXPECT_EQ(dressed.report.garments, (std::vector<std::string>{"inner", "outer"}));
    EXPECT_EQ(dressed.report.contact.self_crossings, 0);
    EXPECT_GT(dressed.report.contact.on_lower_layer, 50);
    EXPECT_EQ(dressed.report.contact.wrong_layer_order, 0);
    EXPECT_GT(mean_radius(dressed.mesh, 2, 3), mean_radius(dressed.mesh, 0, 1));
}

TEST(DressOver, a_vest_sits_over_a_tshirt_everywhere) {
    Pattern pattern = shipped("tshirt");
    put_over(pattern, shipped("vest"));
    const DressReport report = dress(pattern, mannequin()).report;
    EXPECT_EQ(list_faults(report), "");
    EXPECT_EQ(report.garments, (std::vector<std::string>{"tshirt", "vest"}));
    EXPECT_EQ(report.contact.self_crossings, 0);
    EXPECT_GT(report.contact.on_lower_layer, 200);
    EXPECT_EQ(report.contact.wrong_layer_order, 0);
}

class PutOverWhatHangs : public testing::Test {
 protected:
    PutOverWhatHangs() {
        dressing_.set_options({.max_level = 1, .max_seconds = 3, .has_gravity = false});
        dressing_.set_body(std::shared_ptr<const Body>(std::shared_ptr<void>(), &mannequin()));
        Pattern inner = two_tubes(0.52);
        inner.panels.resize(2);
        inner.seams.resize(2);
        dressing_.set_pattern(inner);
        while (dressing_.advance()) continue;
        hanging_ = dressing_.cloth()->x;
        hanging_.resize(dressing_.sewn_mesh().x.size());
    }

    Dressing dressing_;
    std::vector<Vec4f> hanging_;  // m, of level 0
};

TEST_F(PutOverWhatHangs, a_garment_is_sewn_round_it) {
    const double seconds = dressing_.simulated_seconds();
    dressing_.set_pattern(two_tubes(0.52));
    EXPECT_EQ(dressing_.stage(), DressingStage::Sew);
    for (std::size_t v = 0; v < hanging_.size(); ++v)
        ASSERT_EQ(dressing_.cloth()->x[v].head<3>(), hanging_[v].head<3>()) << v;
    while (dressing_.advance()) continue;
    EXPECT_TRUE(dressing_.open_seams().empty());
    EXPECT_GT(dressing_.simulated_seconds(), seconds + 2) << "it counts from when the inner one was sewn";
    const Cloth& cloth = *dressing_.cloth();
    EXPECT_TRUE(find_crossing_triangles(contact_surface(cloth), cloth.x.front().data()).empty());
    EXPECT_GT(measure_layer_order(cloth).judged, 30);
    EXPECT_EQ(measure_layer_order(cloth).wrong, 0);
    for (const std::string& note : dressing_.take_notes()) EXPECT_EQ(note.find("sewn anew"), std::string::npos) << note;
}

TEST(PutOverATshirtThatHangs, a_vest_sits_over_it_everywhere) {
    Dressing dressing;
    dressing.set_body(std::shared_ptr<const Body>(std::shared_ptr<void>(), &mannequin()));
    Pattern pattern = shipped("tshirt");
    dressing.set_pattern(pattern);
    while (dressing.advance()) continue;
    put_over(pattern, shipped("vest"));
    dressing.set_pattern(pattern);
    EXPECT_EQ(dressing.stage(), DressingStage::Sew);
    while (dressing.advance()) continue;
    EXPECT_TRUE(dressing.result().settled);
    EXPECT_TRUE(dressing.open_seams().empty());
    const Cloth& cloth = *dressing.cloth();
    EXPECT_TRUE(find_crossing_triangles(contact_surface(cloth), cloth.x.front().data()).empty());
    const LayerOrder order = measure_layer_order(cloth);
    EXPECT_GT(order.judged, 200);
    EXPECT_EQ(order.wrong, 0);
}

TEST_F(PutOverWhatHangs, a_garment_is_sewn_with_it_if_it_is_changed_too_or_may_not_touch_it) {
    Pattern shorter = two_tubes(0.52), joined = shorter;
    shorter.panels[0].vertices[0].y() += 0.01;
    joined.seams.push_back({.first = {0, 2}, .second = {2, 2}, .is_reversed = false});
    Pattern before = shorter;
    before.panels.resize(2);
    before.seams.resize(2);
    EXPECT_EQ(count_worn_under(before, shorter), 1U);
    EXPECT_EQ(count_worn_under(before, two_tubes(0.52)), 0U) << "other outlines";
    EXPECT_EQ(count_worn_under(before, before), 0U) << "nothing over it";
    EXPECT_EQ(count_worn_under(dressing_.pattern(), joined), 0U);
    Pattern under = two_tubes(0.52);
    for (const std::size_t p : {2U, 3U}) under.panels[p].layer = -5;
    EXPECT_EQ(count_worn_under(dressing_.pattern(), under), 0U);
    dressing_.set_pattern(shorter);
    EXPECT_EQ(dressing_.stage(), DressingStage::Place);
}

TEST(DressOver, refuses_layers_without_contact_between_them) {
    DressOptions options;
    options.self_collision = false;
    EXPECT_THROW(dress(two_tubes(0.52), mannequin(), options), InputError);
    Pattern layered = tube(0.52, 0.3, 0.85, 0.15);
    layered.panels[1].layer = 2;
    EXPECT_THROW(dress(layered, mannequin(), options), InputError);
}

TEST(DressOver, another_order_of_the_garments_is_another_kind_of_pattern) {
    const Pattern before = two_tubes();
    Pattern after = before;
    for (std::size_t p : {2U, 3U}) after.panels[p].layer = 5;
    EXPECT_LT(compare(before, after), PatternChange::Outlines) << "the same order";
    for (std::size_t p : {2U, 3U}) after.panels[p].layer = -5;
    EXPECT_EQ(compare(before, after), PatternChange::Kind);
    EXPECT_EQ(restart_reason(before, after),
              "garments are worn in another order: sewn anew from where the panels are placed");
}

TEST(MovedToBodyOf, keeps_panels_that_were_placed_for_the_same_body_and_moves_others) {
    std::vector<std::string> notes;
    EXPECT_EQ(moved_to_body_of(shipped("tshirt"), shipped("vest"), notes), shipped("vest"));
    EXPECT_TRUE(notes.empty());
    Pattern tall = shipped("vest");
    tall.body = "mannequin:sex=female,height=180";
    const Pattern moved = moved_to_body_of(shipped("tshirt"), tall, notes);
    EXPECT_LT(moved.panels[0].translation.y(), tall.panels[0].translation.y() - 0.05);
}

TEST(MovedToBodyOf, puts_panels_into_the_frame_of_a_pattern_that_lies_below_the_floor) {
    Pattern low = shipped("tshirt"), vest = shipped("vest");
    low.body.clear();
    for (Panel& panel : low.panels) panel.translation.y() -= 1.12;
    std::vector<std::string> notes;
    Pattern worn = low;
    put_over(worn, moved_to_body_of(low, vest, notes));
    EXPECT_TRUE(is_placed_below_floor(worn));
    EXPECT_LT(std::abs(worn.panels[6].translation.y() - low.panels[0].translation.y()), 0.15);
}

}  // namespace
}  // namespace selvedge::sim::test

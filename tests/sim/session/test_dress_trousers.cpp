// Trousers, of which none ships: each leg has a tube of its own, and the four panels meet at the crotch.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <numbers>
#include <string>

#include "sim/body/landmarks.h"
#include "sim/exchange/mesh_file.h"
#include "sim/mannequin/mannequin.h"
#include "sim/session/dress.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/touching_thighs.h"

namespace selvedge::sim {
namespace {

// Edges of a panel as it is drawn for the left of the front; a mirrored panel has them in the other order.
enum class TrouserEdge { Hem, LowerSide, UpperSide, Waist, Middle, Crotch, Inseam };

int trouser_edge(TrouserEdge edge, bool is_mirrored) {
    const int index = static_cast<int>(edge);
    return !is_mirrored || edge == TrouserEdge::Inseam ? index : static_cast<int>(TrouserEdge::Crotch) - index;
}

enum class Facing { Front, Back };

// For a waist of 70 cm, hips of 95 and a stature of 1.68 m; heights are the body's.
Panel trouser_panel(const std::string& name, bool is_mirrored, Facing facing) {
    const double gusset = facing == Facing::Front ? 0.05 : 0.09;  // m, beyond the middle at the crotch
    Panel panel;
    panel.name = name;
    panel.vertices = {{0.0, 0.45}, {0.23, 0.45}, {0.255, 0.86},   {0.185, 1.06},
                      {0.0, 1.06}, {0.0, 0.84},  {-gusset, 0.765}};
    if (is_mirrored) {
        for (Vec2d& vertex : panel.vertices) vertex.x() *= -1;
        std::ranges::reverse(panel.vertices);
    }
    const int count = static_cast<int>(panel.vertices.size());
    for (int i = 0; i < count; ++i) panel.edges.push_back({.start = i, .end = (i + 1) % count});
    const bool is_left = is_mirrored == (facing == Facing::Back);
    panel.translation = Vec3d(is_left ? 0.09 : -0.09, 0, 0.22);  // the gussets of both sides are beside each other
    if (facing == Facing::Back) {
        panel.rotation = Eigen::AngleAxisd(std::numbers::pi, Vec3d::UnitY()).toRotationMatrix();
        panel.translation.z() *= -1;
    }
    return panel;
}

Pattern trousers() {
    constexpr std::array<bool, 4> kMirrored{false, true, true, false};
    Pattern pattern;
    pattern.name = "trousers";
    pattern.panels = {trouser_panel("left_front", kMirrored[0], Facing::Front),
                      trouser_panel("right_front", kMirrored[1], Facing::Front),
                      trouser_panel("left_back", kMirrored[2], Facing::Back),
                      trouser_panel("right_back", kMirrored[3], Facing::Back)};
    const auto sew = [&](int a, int b, std::initializer_list<TrouserEdge> edges) {
        for (const TrouserEdge edge : edges)
            pattern.seams.push_back({{a, trouser_edge(edge, kMirrored[static_cast<std::size_t>(a)])},
                                     {b, trouser_edge(edge, kMirrored[static_cast<std::size_t>(b)])}});
    };
    using enum TrouserEdge;
    for (const int side : {0, 1}) sew(side, side + 2, {LowerSide, UpperSide, Inseam});
    sew(0, 1, {Middle, Crotch});
    sew(2, 3, {Middle, Crotch});
    return pattern;
}

void expect_dressed_in_trousers(const Body& body, const std::string& what) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "body.obj";
    write_body(body, file);
    const auto prepared = std::make_shared<const PreparedBody>(make_body(file.string(), {.must_be_person = true}, {}));
    const DressReport report = dress(trousers(), prepared).report;
    for (const DressFault& fault : report.faults) ADD_FAILURE() << what << ": " << cause_of(fault);
    EXPECT_TRUE(report.settled) << what;
    EXPECT_EQ(report.contact.faces_in_body, 0) << what;
    EXPECT_EQ(report.contact.self_crossings, 0) << what;
}

TEST(DressTrousers, have_a_leg_for_each_thigh_when_these_are_apart_nearly_touch_or_overlap) {
    const Body body = make_mannequin({}).body;
    expect_dressed_in_trousers(body, "apart");
    const double crotch = find_landmarks(body).crotch.value();
    for (const double overlap : {-0.001, 0.006})  // m
        expect_dressed_in_trousers(test::with_touching_thighs(body, crotch, overlap), std::to_string(overlap));
}

}  // namespace
}  // namespace selvedge::sim

// What a session says of a garment that has come to rest.
#include <algorithm>

#include <gtest/gtest.h>

#include "sim/inspection/report.h"
#include "sim/session/session.h"
#include "tests/sim/session/session_support.h"

namespace selvedge::sim::test {
namespace {

TEST(SessionReport, is_what_dress_reports_once_the_garment_rests) {
    Pattern pattern = session_pattern("two_squares");
    SessionOptions options = coarse_options();
    options.reports_faults = true;
    Session session(SessionDrive::Caller);
    session.set_body(session_body());
    session.set_options(options);
    session.set_pattern(pattern);
    session.start();
    session.advance(2);
    EXPECT_EQ(session.frame()->report, nullptr) << "it is not at rest";
    session.advance(2000);
    ASSERT_EQ(session.frame()->stage, SessionStage::Settled);
    const std::shared_ptr<const DressReport> report = session.frame()->report;
    ASSERT_NE(report, nullptr);
    EXPECT_EQ(report->fit.size(), 8U);
    EXPECT_TRUE(report->settled);
    session.advance(0);
    EXPECT_EQ(session.frame()->report, report) << "found once";
    pattern.fabric = "silk";
    session.set_pattern(pattern);
    session.advance(1);
    EXPECT_EQ(session.frame()->report, nullptr) << "it hangs otherwise now";
}

TEST(SessionReport, tells_what_is_too_small_while_it_still_moves) {
    Pattern pattern = session_pattern("skirt");
    for (Panel& panel : pattern.panels) {
        for (Vec2d& v : panel.vertices) v.x() *= 0.6;
        for (OutlineEdge& edge : panel.edges) {
            for (Vec2d& control : edge.control) control.x() *= 0.6;
        }
    }
    SessionOptions options = coarse_options();
    options.reports_faults = true;
    Session session(SessionDrive::Caller);
    session.set_body(session_body());
    session.set_options(options);
    session.set_pattern(pattern);
    session.start();
    for (int i = 0; i < 600 && session.frame()->report == nullptr; ++i) session.advance(1);
    ASSERT_EQ(session.frame()->stage, SessionStage::Draping);
    const std::shared_ptr<const DressReport> report = session.frame()->report;
    ASSERT_NE(report, nullptr);
    EXPECT_FALSE(report->settled);
    EXPECT_EQ(
        std::ranges::count(report->faults, FaultClass::DoesNotFit, [](const DressFault& f) { return class_of(f); }), 1);
    session.advance(1);
    if (session.frame()->stage == SessionStage::Draping) {
        EXPECT_EQ(session.frame()->report, report) << "found once";
    }
}

TEST(SessionReport, is_not_made_unless_it_is_asked_for) {
    Session session(SessionDrive::Caller);
    session.set_body(session_body());
    session.set_options(coarse_options());
    session.set_pattern(session_pattern("two_squares"));
    session.start();
    session.advance(2000);
    ASSERT_EQ(session.frame()->stage, SessionStage::Settled);
    EXPECT_EQ(session.frame()->report, nullptr);
}

}  // namespace
}  // namespace selvedge::sim::test

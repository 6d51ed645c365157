// One process holds a body ready for others.
#include "app/last_body.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/support/temporary_folder.h"

namespace selvedge::app {
namespace {

BodyOptions named(const std::string& source) {
    return {.source = source, .load = {}};
}

TEST(LastBody, holds_the_body_that_was_asked_for_last) {
    LastBody last(nullptr);
    const BodyOptions wide = named("mannequin:bust=104,resolution=1"), narrow = named("mannequin:bust=84,resolution=1");
    EXPECT_EQ(last.find(wide), nullptr);
    last.prepare(wide);
    const auto ready = last.find(wide);
    ASSERT_NE(ready, nullptr);
    EXPECT_EQ(ready->body().x, make_body(wide).body->x);
    EXPECT_TRUE(ready->has_colliders());
    EXPECT_EQ(&ready->collider()->body(), ready->stands().get());
    last.prepare(wide);
    EXPECT_EQ(last.find(wide), ready);
    BodyOptions other_unit = wide;
    other_unit.load.unit = sim::LengthUnit::Centimetres;
    EXPECT_EQ(last.find(other_unit), nullptr);
    last.prepare(narrow);
    EXPECT_EQ(last.find(wide), nullptr);
    EXPECT_NE(last.find(narrow), nullptr);
}

TEST(LastBody, leaves_alone_what_cannot_be_made_or_was_written_since) {
    const sim::TemporaryFolder folder;
    const std::filesystem::path file = folder / "box.obj";
    LastBody last(nullptr);
    last.prepare(named(file));
    EXPECT_EQ(last.find(named(file)), nullptr);
    std::ofstream(file) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
    last.prepare(named(file));
    EXPECT_NE(last.find(named(file)), nullptr);
    std::filesystem::last_write_time(file, std::filesystem::last_write_time(file) + std::chrono::seconds(1));
    EXPECT_EQ(last.find(named(file)), nullptr);
}

}  // namespace
}  // namespace selvedge::app

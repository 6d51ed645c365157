// Bodies and their fields come out of the store with the bits that they were made with.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "sim/collide/body_collider.h"
#include "sim/core/content_store.h"
#include "sim/core/simd_level.h"
#include "sim/mannequin/stored_mannequin.h"
#include "sim/repair/body_bytes.h"
#include "tests/support/temporary_folder.h"

namespace selvedge::sim::test {
namespace {

std::size_t count_of(const std::filesystem::path& folder) {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder)) ++count;
    return count;
}

TEST(StoredMannequin, has_the_same_bits_when_it_is_found_again) {
    const TemporaryFolder folder;
    const ContentStore store(folder / "store", "test", 1 << 28);
    MannequinOptions options{.subdivisions = 1};
    options.measures.bust = 0.95;
    const Mannequin made = stored_mannequin(options, nullptr);
    const Mannequin kept = stored_mannequin(options, &store);
    EXPECT_EQ(count_of(folder / "store"), 1U);
    const Mannequin found = stored_mannequin(options, &store);
    EXPECT_EQ(to_bytes(made.body), to_bytes(kept.body));
    EXPECT_EQ(to_bytes(made.body), to_bytes(found.body));
    EXPECT_EQ(made.report.messages, found.report.messages);
    EXPECT_EQ(made.report.stance.made, found.report.stance.made);
    ASSERT_EQ(made.report.readings.size(), found.report.readings.size());
    for (std::size_t i = 0; i < made.report.readings.size(); ++i) {
        EXPECT_EQ(made.report.readings[i].name, found.report.readings[i].name);
        EXPECT_EQ(made.report.readings[i].requested, found.report.readings[i].requested);
        EXPECT_EQ(made.report.readings[i].measured, found.report.readings[i].measured);
        EXPECT_EQ(made.report.readings[i].level, found.report.readings[i].level);
    }
    options.measures.bust = 0.96;
    EXPECT_NE(to_bytes(stored_mannequin(options, &store).body), to_bytes(made.body));
    EXPECT_EQ(count_of(folder / "store"), 2U);
}

TEST(StoredMannequin, broken_bytes_are_no_body) {
    const std::string bytes = to_bytes(stored_mannequin({.subdivisions = 1}, nullptr).body);
    EXPECT_TRUE(body_from_bytes(bytes).has_value());
    EXPECT_FALSE(body_from_bytes(bytes.substr(0, bytes.size() / 2)).has_value());
    EXPECT_FALSE(body_from_bytes(bytes + "x").has_value());
    EXPECT_FALSE(body_from_bytes("").has_value());
}

TEST(StoredField, has_the_same_bits_when_it_is_found_again) {
    const TemporaryFolder folder;
    const ContentStore store(folder / "store", "test", 1 << 28);
    const Body body = make_mannequin({.subdivisions = 1}).body;
    const DistanceFieldOptions coarse{.cell = 0.01F, .band = 0.03F};
    const BodyCollider made(body, coarse);
    const BodyCollider kept(body, coarse, {}, &store);
    EXPECT_EQ(count_of(folder / "store"), 1U);
    const BodyCollider found(body, coarse, {}, &store);
    EXPECT_EQ(made.field().to_bytes(), found.field().to_bytes());
    EXPECT_EQ(made.thin_parts().size(), found.thin_parts().size());
    for (const Vec3f& p : {Vec3f(0, 1, 0.1F), Vec3f(0.1F, 1.2F, 0), Vec3f(0, 0.5F, 0)}) {
        EXPECT_EQ(made.contact(p).distance, found.contact(p).distance);
        EXPECT_EQ(made.contact(p).normal, found.contact(p).normal);
    }
    const BodyCollider finer(body, {.cell = 0.009F, .band = 0.03F}, {}, &store);
    EXPECT_EQ(count_of(folder / "store"), 2U);
}

TEST(StoredField, is_not_shared_by_levels_of_simd_that_round_differently) {
    if (simd_level() < SimdLevel::Avx2) GTEST_SKIP() << "this processor has plain kernels only";
    const TemporaryFolder folder;
    const ContentStore store(folder / "store", "test", 1 << 28);
    const Body body = make_mannequin({.subdivisions = 1}).body;
    const DistanceFieldOptions coarse{.cell = 0.01F, .band = 0.03F};
    const auto keep_field_of = [&](SimdLevel level) {
        const SimdLimit limit(level);
        const BodyCollider collider(body, coarse, {}, &store);
    };
    keep_field_of(SimdLevel::Avx2);
    EXPECT_EQ(count_of(folder / "store"), 1U);
    keep_field_of(SimdLevel::Plain);
    EXPECT_EQ(count_of(folder / "store"), 2U);
    keep_field_of(SimdLevel::Avx512);
    EXPECT_EQ(count_of(folder / "store"), 2U) << "with the bits of AVX2";
}

TEST(StoredField, broken_bytes_are_no_field) {
    const Body body = make_mannequin({.subdivisions = 1}).body;
    std::string bytes = BodyCollider(body, {.cell = 0.02F, .band = 0.05F}).field().to_bytes();
    EXPECT_TRUE(DistanceField::from_bytes(bytes).has_value());
    EXPECT_FALSE(DistanceField::from_bytes(bytes.substr(0, bytes.size() - 2)).has_value());
    constexpr std::size_t kSize = 6 * sizeof(float);  // behind cell, band, error and origin
    bytes[kSize] = char(bytes[kSize] + 1);
    EXPECT_FALSE(DistanceField::from_bytes(bytes).has_value()) << "sizes and blocks differ";
}

}  // namespace
}  // namespace selvedge::sim::test

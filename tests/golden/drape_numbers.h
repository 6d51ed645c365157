#pragma once
// The numbers of a dressed garment that hold from one CPU to another, and how near they must stay to those kept in
// tests/golden/reference/NAME.json.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sim/core/json.h"
#include "sim/dress/dress.h"

namespace selvedge::test {

struct DrapeNumbers {
    int base_triangles = 0;
    int leaf_triangles = 0;
    bool settled = false;
    std::vector<std::string> faults;  // their kinds
    double warp_weft_p99 = 0;         // strain
    double hem_height = 0;            // m, of the lowest vertex
    Vec3d centre = Vec3d::Zero();     // m, of the cloth's area
};

struct DrapeTolerances {
    double leaf_share = 0.1;  // of the reference's leaf triangles
    double strain = 0.01;
    double length = 0.01;  // m, of the hem's height and between the centres
};

DrapeNumbers drape_numbers(const sim::DressedGarment& garment);

sim::Json to_json(const DrapeNumbers& numbers);
DrapeNumbers parse_drape_numbers(const sim::JsonView& view);

// What is not as in the reference, a line each with both values. Empty when all is.
std::vector<std::string> differences(const DrapeNumbers& reference, const DrapeNumbers& now,
                                     const DrapeTolerances& tolerances = {});

// Fails when the reference is missing or anything differs. Where SELVEDGE_RENEW_GOLDENS has the name, the numbers
// become the reference instead.
testing::AssertionResult matches_numbers(const DrapeNumbers& numbers, const std::string& name);

}  // namespace selvedge::test

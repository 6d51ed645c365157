#pragma once
// Statistics of a dressed garment that hold on every CPU type, and their tolerances against the references in
// tests/golden/reference/NAME.json.
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "sim/core/json.h"
#include "sim/session/dress.h"

namespace selvedge::test {

struct DrapeNumbers {
    int base_triangles = 0;
    int leaf_triangles = 0;
    bool settled = false;
    std::vector<std::string> faults;  // the faults' kinds
    double warp_weft_p99 = 0;         // strain
    double hem_height = 0;            // m, height of the lowest vertex
    Vec3d centre = Vec3d::Zero();     // m, centroid of the cloth's area
};

struct DrapeTolerances {
    double leaf_share = 0.1;  // fraction of the reference's leaf triangles
    double strain = 0.01;
    double length = 0.01;  // m, for the hem's height and the distance of the centres
};

DrapeNumbers drape_numbers(const sim::DressedGarment& garment);

sim::Json to_json(const DrapeNumbers& numbers);
DrapeNumbers parse_drape_numbers(const sim::JsonView& view);

// One line for each value that differs from the reference, with both values. Empty if none does.
std::vector<std::string> differences(const DrapeNumbers& reference, const DrapeNumbers& now,
                                     const DrapeTolerances& tolerances = {});

// Fails if the reference is missing or a value differs. If SELVEDGE_RENEW_GOLDENS contains the name, writes the numbers
// as the new reference instead.
testing::AssertionResult matches_numbers(const DrapeNumbers& numbers, const std::string& name);

// Shipped garments on the coarse mannequin, for golden tests that run the whole pipeline.

// The female mannequin at its lowest resolution.
sim::Body coarse_mannequin();

// `garment`: a file name in patterns/, without extension.
sim::DressedGarment dress_shipped(const std::string& garment, const sim::DressOptions& options = {});

}  // namespace selvedge::test

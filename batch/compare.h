#pragma once
// What changed since an earlier run of a batch: outcomes, and pictures.
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim/core/json.h"

namespace selvedge::batch {

struct JobChange {
    std::string job;
    bool is_new = false;         // the earlier run did not do it
    std::string outcome_before;  // empty if it is new
    bool has_new_outcome = false;
    bool has_new_picture = false;  // by more than another CPU's rounding explains
    double differing_share = 0;    // of the pixels, beyond that; 1 if the sizes differ

    bool is_changed() const { return is_new || has_new_outcome || has_new_picture; }
};

// Throws InputError if `before` is not the output of a batch, or is the output of this one.
void check_earlier_run(const std::filesystem::path& before, const std::filesystem::path& output);

// One for each row, in their order. Where the pictures differ, OUTPUT/differences gets NAME@before.png, a copy, and
// NAME@difference.png, which shows where. Throws InputError if `before` is not the output of a batch.
std::vector<JobChange> compare_runs(const std::vector<sim::Json>& rows, const std::filesystem::path& output,
                                    const std::filesystem::path& before,
                                    const std::function<void(double fraction)>& progress = {});

}  // namespace selvedge::batch

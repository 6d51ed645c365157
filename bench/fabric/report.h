#pragma once
// All textile tests on all fabrics, as tables: what was expected, what was measured, by how much they differ, and what
// was missed.
#include <string>
#include <vector>

#include "bench/fabric/textile_test.h"
#include "bench/support/table.h"
#include "sim/core/parallel.h"

namespace selvedge::bench {

struct FabricExperiment {
    std::vector<std::string> fabrics{};  // empty: all that ship, or four of them when quick
    bool is_quick = false;               // levels 1 and 2 at 17 degrees alone
    Stepping stepping{};
};

// "cantilever", "strip", "bias", "drape", "swing", "energy".
std::vector<std::string> textile_test_names();

struct FabricTables {
    std::vector<Table> tables;
    int rows = 0;    // with a gate
    int missed = 0;  // of them
};

// Throws InputError for an unknown fabric. Pre: test is one of the names.
FabricTables measure_fabrics(const std::string& test, const FabricExperiment& experiment,
                             const sim::Progress& progress = {});

// How far off a level may be: 5 % at level 2 and finer and where the mesh adapts, 10 % at level 1, nothing is asked of
// level 0 (a negative number).
double allowed_error(const MeshSetting& mesh);

// Levels 0 to 3 and adaptive, or 1 and 2 when quick; the angles of the specimens on the mesher's grid, rad.
std::vector<MeshSetting> level_settings(const FabricExperiment& experiment);
std::vector<double> mesh_angles(const FabricExperiment& experiment);

// The drape coefficients published for such a fabric, %, or none known: both 0.
struct DrapeBand {
    double low = 0;
    double high = 0;
};
DrapeBand published_drape(const std::string& fabric_name);

}  // namespace selvedge::bench

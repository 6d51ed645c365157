#pragma once
// Runs the textile tests on fabrics and makes tables with the expected value, the measured values, the error and
// whether the gate was met.
#include <string>
#include <vector>

#include "bench/fabric/textile_test.h"
#include "bench/support/table.h"
#include "sim/core/parallel.h"

namespace selvedge::bench {

struct FabricExperiment {
    std::vector<std::string> fabrics{};  // empty: all built-in fabrics, or four of them if is_quick
    bool is_quick = false;               // levels 1 and 2 at a mesh angle of 17 degrees only
    Stepping stepping{};
};

// "cantilever", "strip", "bias", "drape", "swing", "energy".
std::vector<std::string> textile_test_names();

struct FabricTables {
    std::vector<Table> tables;
    int rows = 0;    // rows with a gate
    int missed = 0;  // rows whose gate was not met
};

// Throws InputError for an unknown fabric. Pre: test is one of the names.
FabricTables measure_fabrics(const std::string& test, const FabricExperiment& experiment,
                             const sim::Progress& progress = {});

// The allowed relative error: 0.05 at level 2 and finer and on adaptive meshes, 0.1 at level 1. Level 0 has no gate: a
// negative number.
double allowed_error(const MeshSetting& mesh);

// Levels 0 to 3 and adaptive, or levels 1 and 2 if is_quick. mesh_angles(): angles between the specimen and the
// mesher's grid, rad.
std::vector<MeshSetting> level_settings(const FabricExperiment& experiment);
std::vector<double> mesh_angles(const FabricExperiment& experiment);

// The range of drape coefficients published for this kind of fabric, %. Both 0: none is known.
struct DrapeBand {
    double low = 0;
    double high = 0;
};
DrapeBand published_drape(const std::string& fabric_name);

}  // namespace selvedge::bench

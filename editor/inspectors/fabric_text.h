#pragma once
// A fabric's figures as people who buy cloth read them.
#include <string>
#include <vector>

#include "sim/pattern/fabric.h"

namespace selvedge {

struct FabricRow {
    const char* label = "";
    std::string value;
    const char* tip = "";
};

// Weight, stretch, shear, bending, thickness, friction, damping, strain limit.
std::vector<FabricRow> fabric_rows(const Fabric& fabric);

// "wool_twill" as "Wool twill"; a file by its name without folders.
std::string readable_name(const std::string& name);

}  // namespace selvedge

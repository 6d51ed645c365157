#pragma once
// Patterns as DXF-AAMA (ANSI/AAMA 292) and DXF-ASTM (ASTM D6673): DXF R10, ASCII, millimetres, a block per panel.
// Layers: 1 the cut line and the texts, 2 turn points, 3 curve points, 4 notches (ASTM: 80 to 83 for T, castle, V and
// U), 7 grain, 8 internal lines, 13 drill points, 14 the sewing line, 15 annotation.
//
// DXF of these standards has polylines only and no seams. What it lacks stands in comments (group code 999), which no
// program draws or plots, and which sim/paper/dxf_records.h reads back: "SELVEDGE EDGE ...", "SELVEDGE NOTCH ...",
// "SELVEDGE LINE ...", "SELVEDGE PLACED ...", "SELVEDGE SEAM ...".
#include <string>

#include "sim/pattern/pattern.h"

namespace selvedge::sim {

enum class DxfStandard { Aama, Astm };

// Who wrote a file, and when; what is empty is left out.
struct DxfStamp {
    std::string version = {};  // of Selvedge
    std::string date = {};     // DD-MM-YYYY, as ASTM D6673 has it
    std::string time = {};     // HH:MM
};

// ASCII; other characters as \U+XXXX. The same pattern and stamp give the same bytes.
std::string dxf_of(const Pattern& pattern, DxfStandard standard = DxfStandard::Aama, const DxfStamp& stamp = {});

}  // namespace selvedge::sim

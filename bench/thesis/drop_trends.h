#pragma once
// Whether the drops show what the thesis reports of them, decided from the tables and series.  (thesis 3.8.2)
#include "bench/thesis/thesis.h"

namespace selvedge::bench {

// For whichever of the tables 3.1 and 3.12-3.14 and the figures 3.24-3.30 the result holds.
std::vector<Trend> drop_trends(const ThesisResult& result);

}  // namespace selvedge::bench

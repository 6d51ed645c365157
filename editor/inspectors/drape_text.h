#pragma once
// A drape's state in words.
#include <string>

#include "sim/dress/session.h"

namespace selvedge {

// "Sewing: seams close", "Settled: it hangs still".
std::string stage_words(SessionStage stage, bool is_running);

// "3.2 s", "1.40 ms", "0.8 cm/s".
std::string seconds_text(double seconds);
std::string milliseconds_text(double milliseconds);
std::string speed_text(double metres_per_second);

// "1,234".
std::string count_text(int count);

// Angles that the criteria can be asked with: rejoining stays below splitting.
CurvatureOptions curvature_with(CurvatureOptions options, std::optional<double> split, std::optional<double> rejoin);

// A name that is not among those yet: "drape", "drape 2".
std::string free_drape_name(const std::vector<std::string>& kept, const std::string& wanted);

}  // namespace selvedge

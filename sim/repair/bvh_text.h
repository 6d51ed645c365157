#pragma once
// Checks of a BVH file that assimp does not make: it takes "3.7" frames for 3, ignores what follows the rows that it
// counts, gives
// the rotations of two joints of one name to one of them, and asks for memory for as many frames as a file promises.
#include <string>
#include <string_view>

namespace selvedge::sim {

struct MotionLimits;

// Throws InputError(file, "line 7", ...) unless the text has a skeleton whose joints have names, offsets and channels,
// and as many rows of finite numbers as it says or more, one on a line if more, at a rate between 1 and 1,000 per
// second. (Meredith and Maddock 2001, Motion Capture File Formats Explained)
void check_bvh(std::string_view text, const std::string& file, const MotionLimits& limits);

}  // namespace selvedge::sim

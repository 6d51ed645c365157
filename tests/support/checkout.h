#pragma once
// Where the tests find what belongs to the checkout.
#include <string>

namespace selvedge {

// The folder of the checkout that the tests were built from, absolute, without a slash at its end.
const std::string& source_folder();

// The folder that the programs were built into, absolute, without a slash at its end.
const std::string& program_folder();

}  // namespace selvedge

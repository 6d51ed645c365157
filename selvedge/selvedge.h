#pragma once
// All of the library: patterns and bodies are loaded, a body is dressed, and the result is read, exported and drawn.
//
//   const selvedge::Result result = selvedge::dress(selvedge::load_pattern("shirt.json"));
//   for (const std::array<float, 3>& x : result.mesh().positions) ...
#include "selvedge/body.h"
#include "selvedge/dress.h"
#include "selvedge/errors.h"
#include "selvedge/pattern.h"
#include "selvedge/picture.h"
#include "selvedge/version.h"

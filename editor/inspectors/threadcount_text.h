#pragma once
// A sett as it is written, so that one that ships can be changed by hand.
#include <optional>
#include <string>

#include "sim/pattern/pattern.h"
#include "sim/tartan/sett.h"

namespace selvedge {

// "K/8 R24 W/4 weft: ... weave: denim", its colours that the usual letters do not have first. parse_threadcount makes
// the same threads of it.
std::string threadcount_of(const Sett& sett);

// Why it cannot be woven, in words; empty: it can. Also for names.
std::string wrong_with_tartan(const std::string& name_or_threadcount);

// What the garment is woven in, in its size. None: its name or threadcount is wrong.
std::optional<Sett> sett_of(const Pattern& pattern);

// Whether all words are in the text, in small or capital letters.
bool has_words(const std::string& text, const std::string& words);

}  // namespace selvedge

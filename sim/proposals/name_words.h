#pragma once
// The words of a panel's name, as people write them in many languages and scripts.
#include <string>
#include <string_view>
#include <vector>

namespace selvedge::sim {

// The words of a name (UTF-8; other bytes are no letters), in lower case and without accents: "FrontPanel_2" gives
// front, panel, 2; "Rückenteil" gives ruckenteil.
std::vector<std::string> words_of_name(std::string_view name);

// Whether the words name any word of a list with blanks between: a word begins with that one ("=col": is it), or it
// stands within a word, if it has five letters or more (FULLSLEEVE) or is written without blanks, as Chinese is.
// Words of up to two letters must be equal.
bool names_any(const std::vector<std::string>& words, std::string_view list);

}  // namespace selvedge::sim

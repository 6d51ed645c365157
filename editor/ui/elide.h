#pragma once
// Text that is longer than its place: a part of it makes room for three dots.
#include <functional>
#include <string>
#include <string_view>

namespace selvedge {

// What is left out. Of a sentence its end; of one with a file's path in it, the middle.
enum class Elide { Middle, End };

// The longest that is at most `width` px wide, by `width_of`; the text itself where it fits. Letters stay whole
// (UTF-8).
std::string elided(std::string_view text, float width, Elide what,
                   const std::function<float(std::string_view)>& width_of);

// With the present font.
std::string elided(std::string_view text, float width, Elide what);

// A tip with the whole text over the last item, where `shown` is not all of it.
void tip_of_whole(const std::string& text, const std::string& shown);

}  // namespace selvedge

#pragma once
// A tartan as weavers write it: the threadcount, expanded to one repeat of coloured threads. The weft repeats the warp
// unless it has a threadcount of its own.
// (Notation of the Scottish Register of Tartans.)
//
//   B/24 W4 B24 R2 K24 G24 W/2   a slash marks a pivot: laid once at its full count, the stripes between are mirrored
//   B18 G46 K6 Y40               no slash: repeated end to end
//   S=#A09060; S/20 K4 S/8       a colour of one's own, before the stripes
//   B/24 W4 R/2 weft: K8 W8      a weft of its own, with its own pivots or none
//   B24 W4 weft: W1 weave: denim how they cross: plain (1/1), twill (2/2, unless said) or denim (3/1)
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace selvedge::sim {

using Rgb8 = std::array<std::uint8_t, 3>;  // sRGB
using Palette = std::map<std::string, Rgb8, std::less<>>;

struct SettStripe {
    std::string code;  // letters of the threadcount, upper case
    Rgb8 colour{};
    int threads = 0;

    bool operator==(const SettStripe&) const = default;
};

// How warp and weft cross.
enum class Weave {
    Plain,    // over one, under one
    Twill22,  // over two, under two: tartans
    Twill31,  // warp over three, under one: denim
};

inline constexpr const char* kWeaveNames = "plain, twill, denim";

// By those names, in small or capital letters; none: no weave is called so.
std::optional<Weave> parse_weave(std::string_view name);

// One full repeat, mirrored half included.
struct Sett {
    std::string name;
    std::vector<SettStripe> stripes;  // of the warp
    bool is_mirrored = false;
    std::vector<SettStripe> weft_stripes{};  // empty: the weft repeats the warp
    bool is_weft_mirrored = false;           // read only when there are weft stripes
    Weave weave = Weave::Twill22;
    double thread_spacing = 0.00036;  // m from one thread to the next: 28 per cm, a medium kilting cloth
    std::string register_name{};      // as the Scottish Register of Tartans has it; empty: not there, or not known
    int register_number = 0;          // its reference number there; 0: none

    bool operator==(const Sett&) const = default;
};

inline constexpr int kMaxSettThreads = 4096;

// The stripes that the weft lays down: its own, or those of the warp where it has none.
const std::vector<SettStripe>& weft_stripes(const Sett& sett);

// Warp and weft may differ in their threads per repeat, and so in the size of it. The threads of the warp lie side by
// side along the weft, so the warp's repeat is measured along the weft, and the weft's along the warp.
int thread_count(const Sett& sett);  // of the warp's repeat
int weft_thread_count(const Sett& sett);
double repeat_size(const Sett& sett);                     // m, of the warp
double weft_repeat_size(const Sett& sett);                // m
std::vector<Rgb8> thread_colours(const Sett& sett);       // one per thread of the warp's repeat
std::vector<Rgb8> weft_thread_colours(const Sett& sett);  // one per thread of the weft's repeat

// The same stripes in a repeat of the warp of `size` m; the weft's keeps its proportion to it. Counts give
// proportions: they are multiplied by the whole number that brings the threads nearest to the sett's spacing, and the
// spacing takes up the rest. Pre: size > 0.
Sett with_repeat_size(Sett sett, double size);

// The usual letters (K black, B blue, ...). A tartan's own palette goes before them, since letters are not unique.
const Palette& standard_palette();

// "#RRGGBB". Throws InputError(file, place, ...).
Rgb8 parse_colour(std::string_view text, const std::string& file, const std::string& place);

// Throws InputError("threadcount", "stripe 3 'Q5'", what is wrong).
Sett parse_threadcount(std::string_view text, const Palette& palette = {});

}  // namespace selvedge::sim

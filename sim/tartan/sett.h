#pragma once
// A tartan's sett: the threadcount (notation of the Scottish Register of Tartans) parsed and expanded to one repeat of
// coloured stripes, with its colours, weave and size. The weft repeats the warp unless it has its own threadcount.
// Examples of the notation:
//
//   B/24 W4 B24 R2 K24 G24 W/2   slash: pivots at both ends, used once per repeat; the stripes between are mirrored
//   B18 G46 K6 Y40               no slash: repeated end to end
//   ...B18 G46 K6...             the same
//   S=#A09060; S/20 K4 S/8       defines a colour before the stripes
//   LT=E8CCB8LIGHT BROWN; ...    the same as the Register's "pallet" has it, with a name
//   B/24 W4 R/2 weft: K8 W8      a separate weft, with or without pivots
//   B24 W4 . K8 W8               the same as the Scottish Tartans Authority writes it, a dot before the weft
//   B24 W4 weft: W1 weave: denim the weave: plain (1/1), twill (2/2, the default) or denim (3/1)
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
    std::string code;  // colour code in the threadcount, upper case
    Rgb8 colour{};
    int threads = 0;

    bool operator==(const SettStripe&) const = default;
};

// How warp and weft interlace.
enum class Weave {
    Plain,    // over one, under one
    Twill22,  // over two, under two: usual for tartans
    Twill31,  // warp over three, under one: denim
};

inline constexpr const char* kWeaveNames = "plain, twill, denim";

// Parses one of kWeaveNames, in lower or upper case; nullopt for any other name.
std::optional<Weave> parse_weave(std::string_view name);

// One full repeat, including the mirrored half.
struct Sett {
    std::string name;
    std::vector<SettStripe> stripes;  // of the warp
    bool is_mirrored = false;
    std::vector<SettStripe> weft_stripes{};  // empty: the weft repeats the warp
    bool is_weft_mirrored = false;           // used only if there are weft stripes
    Weave weave = Weave::Twill22;
    double thread_spacing = 0.00036;  // m between threads; 28 per cm is a medium-weight kilt cloth
    std::string register_name{};      // name in the Scottish Register of Tartans; empty: none or unknown
    int register_number = 0;          // reference number in that register; 0: none

    bool operator==(const Sett&) const = default;
};

inline constexpr int kMaxSettThreads = 4096;

// The weft's stripes: its own, or the warp's if it has none.
const std::vector<SettStripe>& weft_stripes(const Sett& sett);

// Counts, sizes and colours of one repeat of warp and weft, which may differ. Warp threads are side by side along the
// weft, so the warp's repeat is measured along the weft, and the weft's along the warp.
int thread_count(const Sett& sett);  // of the warp's repeat
int weft_thread_count(const Sett& sett);
double repeat_size(const Sett& sett);                     // m, of the warp
double weft_repeat_size(const Sett& sett);                // m
std::vector<Rgb8> thread_colours(const Sett& sett);       // one per thread of the warp's repeat
std::vector<Rgb8> weft_thread_colours(const Sett& sett);  // one per thread of the weft's repeat

// The sett scaled so that the warp's repeat is `size` m; the weft's repeat is scaled by the same factor. All counts are
// multiplied by the integer that gives a thread spacing closest to the present one, and the spacing is then adjusted to
// the exact size. Pre: size > 0 and the sett has stripes.
Sett with_repeat_size(Sett sett, double size);

// The usual colour codes (K black, B blue, ...). A tartan's own palette has priority, because codes are not unique.
const Palette& standard_palette();

// Parses "#RRGGBB". Throws InputError(file, place, ...).
Rgb8 parse_colour(std::string_view text, const std::string& file, const std::string& place);

// The same without the number sign, and with a name after it, if there is one: "2C2C80BLUE".
Rgb8 parse_named_colour(std::string_view text, const std::string& file, const std::string& place);

// Parses colours as a threadcount defines them: "B=2C2C80BLUE;W=FFFFFFWHITE;". Throws InputError as
// parse_threadcount().
Palette parse_palette(std::string_view text);

// Parses a threadcount in the notation above, also after the words "Threadcount:" and "Pallet:". Codes are looked up in
// the colours that it defines, in `palette`, then in standard_palette(). Throws InputError("threadcount", "stripe 3
// 'Q5'", problem).
Sett parse_threadcount(std::string_view text, const Palette& palette = {});

}  // namespace selvedge::sim

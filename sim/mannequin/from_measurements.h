#pragma once
// A mannequin from the measurements that pattern programs keep, by the names of FreeSewing, of Seamly2D and Valentina,
// and of GarmentCode; and the list of what was used, what follows from others, and what is left to the base body.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/mannequin/mannequin.h"

namespace selvedge::sim {

struct NamedLength {
    std::string name;  // as the program has it: "chest", "waist_circ", "hips"
    double value = 0;  // m
};

struct MannequinFit {
    MannequinOptions options = {};
    std::vector<std::string> used = {};  // "bust 92.5 cm (chest)"
    std::vector<std::string> derived =
        {};  // "height 166.1 cm, from waistToFloor + hpsToWaistBack, which is 87 % of it"
    std::vector<std::string> guessed = {};  // measures that follow from the others by the base body's proportions; the
                                            // sex, if nothing tells it
    std::vector<std::string> refused = {};  // values that no mannequin has, with the range; not used
    std::vector<std::string> ignored = {};  // names that say nothing of the mannequin
};

// Does not throw: what cannot be used is in the lists. `sex`: as the file tells it; otherwise it is guessed, also by
// the words of the file's name (guess_sex.h).
MannequinFit mannequin_from_measurements(std::span<const NamedLength> lengths, std::optional<Sex> sex = {},
                                         std::string_view name = {});

// "mannequin:sex=female,bust=92.5,...", which parse_mannequin() reads back, to 0.1 mm.
std::string mannequin_text(const MannequinOptions& options);

}  // namespace selvedge::sim

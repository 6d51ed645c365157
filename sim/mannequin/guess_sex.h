#pragma once
// The sex of a person whose measures are known and whose sex is not told: by the measures together, by how far the bust
// stands over the underbust, and by the words of a file's name.
#include <optional>
#include <string>
#include <string_view>

#include "sim/mannequin/mannequin.h"

namespace selvedge::sim {

struct SexEvidence {
    const MannequinMeasures& measures;
    std::optional<double> shoulder_breadth = {};  // m, between the outermost points of the shoulder blades (biacromial)
    std::string_view name = {};                   // of a file: "mean_male", "cisFemaleAdult38"
};

struct SexGuess {
    Sex sex = Sex::Female;
    double probability = 0.5;  // of this sex, 0.5 to 1; of a person as often one as the other
    std::string reasons = {};  // "the measures, the bust 14.5 cm over the underbust, the name"; empty: nothing tells it

    bool is_sure() const { return probability >= 0.9; }
};

SexGuess guess_sex(const SexEvidence& evidence);

// What a name says, if it has such a word: "women", "Herren", "cisMaleAdult".
std::optional<Sex> sex_in_name(std::string_view name);

}  // namespace selvedge::sim

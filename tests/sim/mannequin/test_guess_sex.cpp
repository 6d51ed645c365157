// The sex of measures that do not tell it: of mean bodies, scaled bodies, and names of files.
#include "sim/mannequin/guess_sex.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "sim/mannequin/from_measurements.h"

namespace selvedge::sim {
namespace {

using Lengths = std::map<std::string, double>;  // by GarmentCode's and FreeSewing's names, m

MannequinFit fit_of(const Lengths& lengths, const char* name = "") {
    std::vector<NamedLength> list;
    for (const auto& [key, value] : lengths) list.push_back({key, value});
    return mannequin_from_measurements(list, {}, name);
}

std::string line_of_sex(const MannequinFit& fit) {
    for (const std::string& line : fit.guessed)
        if (line.starts_with("sex: ")) return line;
    return "";
}

// Of the mean bodies of a survey of civilians, and of a statistical body model.
const Lengths kMeanMale{{"height", 1.78873}, {"bust", 1.02787},   {"underbust", 0.930277}, {"waist", 0.89003},
                        {"hips", 1.0285},    {"wrist", 0.174648}, {"shoulder_w", 0.385276}};
const Lengths kMeanFemale{{"height", 1.66194}, {"bust", 0.974076},  {"underbust", 0.807483}, {"waist", 0.803442},
                          {"hips", 1.04091},   {"wrist", 0.158636}, {"shoulder_w", 0.347129}};
const Lengths kModelFemale{{"height", 1.65}, {"bust", 0.90},  {"underbust", 0.83}, {"waist", 0.80},
                           {"hips", 1.07},   {"wrist", 0.17}, {"shoulder_w", 0.38}};
const Lengths kModelMale{{"height", 1.781}, {"bust", 1.0},   {"underbust", 0.98},  {"waist", 0.80},
                         {"hips", 1.0},     {"wrist", 0.25}, {"shoulder_w", 0.382}};

TEST(GuessSex, tells_mean_bodies_by_their_measures_together) {
    EXPECT_EQ(fit_of(kMeanMale).options.sex, Sex::Male) << "though the bust stands 9.8 cm over the underbust";
    EXPECT_EQ(fit_of(kMeanFemale).options.sex, Sex::Female);
    EXPECT_EQ(fit_of(kModelFemale).options.sex, Sex::Female) << "though the bust stands 7 cm over the underbust";
    EXPECT_EQ(fit_of(kModelMale).options.sex, Sex::Male);
    EXPECT_TRUE(line_of_sex(fit_of(kMeanFemale)).starts_with("sex: female, by the measures, the bust 16.7 cm over"));
    EXPECT_EQ(line_of_sex(fit_of(kMeanFemale)).find("not sure"), std::string::npos);
}

TEST(GuessSex, says_when_it_is_not_sure_and_what_settles_it) {
    // The mean of both.
    Lengths both;
    for (const auto& [name, value] : kMeanMale) both[name] = (value + kMeanFemale.at(name)) / 2;
    for (const Lengths& lengths : {both, kModelFemale}) {
        const std::string line = line_of_sex(fit_of(lengths));
        EXPECT_NE(line.find("not sure"), std::string::npos) << line;
        EXPECT_NE(line.find("--sex settles it"), std::string::npos) << line;
    }
    const std::string nothing = line_of_sex(fit_of({{"knee", 0.36}}));
    EXPECT_TRUE(nothing.starts_with("sex: female, for nothing tells it (not sure, 50 %")) << nothing;
}

// FreeSewing's bodies are one woman and one man whose lengths and girths grow with the neck.
TEST(GuessSex, stays_when_a_body_is_scaled) {
    const Lengths woman{
        {"neck", 0.34},           {"chest", 0.925}, {"underbust", 0.78},           {"waist", 0.75},
        {"seat", 1.01},           {"wrist", 0.165}, {"shoulderToShoulder", 0.415}, {"waistToFloor", 1.05},
        {"hpsToWaistBack", 0.395}};
    const Lengths man{{"neck", 0.38},          {"chest", 1.0},   {"underbust", 0.98},          {"waist", 0.81},
                      {"seat", 1.02},          {"wrist", 0.175}, {"shoulderToShoulder", 0.45}, {"waistToFloor", 1.16},
                      {"hpsToWaistBack", 0.47}};
    const std::map<std::string, double> ratios{{"neck", 1},
                                               {"chest", 1},
                                               {"underbust", 1},
                                               {"waist", 0.85},
                                               {"seat", 0.6},
                                               {"wrist", 0.5},
                                               {"shoulderToShoulder", 0.65},
                                               {"waistToFloor", 0.4},
                                               {"hpsToWaistBack", 0.65}};
    const auto scaled = [&](Lengths lengths, double neck) {
        const double more = neck / lengths.at("neck") - 1;
        for (auto& [name, value] : lengths) value *= 1 + more * ratios.at(name);
        return lengths;
    };
    for (const double neck : {0.30, 0.34, 0.38, 0.42, 0.46}) {
        EXPECT_EQ(fit_of(scaled(woman, neck)).options.sex, Sex::Female) << neck;
        EXPECT_EQ(fit_of(scaled(man, neck + 0.02)).options.sex, Sex::Male) << neck;
    }
}

TEST(GuessSex, reads_the_words_of_a_files_name) {
    EXPECT_EQ(sex_in_name("mean_male"), Sex::Male);
    EXPECT_EQ(sex_in_name("cisFemaleAdult38"), Sex::Female);
    EXPECT_EQ(sex_in_name("Herren-Hose 52"), Sex::Male);
    EXPECT_EQ(sex_in_name("WOMENS"), Sex::Female);
    EXPECT_EQ(sex_in_name("men_and_women"), std::nullopt);
    EXPECT_EQ(sex_in_name("manual"), std::nullopt);
    EXPECT_EQ(sex_in_name("anna"), std::nullopt);
    EXPECT_EQ(fit_of({{"waist", 0.8}}, "smpl_male").options.sex, Sex::Male);
    EXPECT_EQ(line_of_sex(fit_of(kMeanMale, "mean_male")).find("not sure"), std::string::npos);
    // A name does not outweigh what all measures say.
    EXPECT_EQ(fit_of(kModelMale, "woman").options.sex, Sex::Male);
}

}  // namespace
}  // namespace selvedge::sim

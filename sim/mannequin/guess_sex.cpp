#include "sim/mannequin/guess_sex.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <vector>

namespace selvedge::sim {
namespace {

// Logarithms of lengths in metres.
struct MeasureStatistics {
    double female = 0;  // mean
    double male = 0;
    std::array<double, 7> covariance{};  // with each of them, within a sex
};

// Stature, biacromial breadth, chest, waist (at the navel), buttock, neck and wrist circumference of 1,986 women and
// 4,082 men. (Gordon et al. 2014, 2012 Anthropometric Survey of U.S. Army Personnel, Natick/TR-15/007; from its public
// data)
constexpr std::array<MeasureStatistics, 7> kStatistics{{
    {0.4869, 0.5624, {0.00153, 0.00101, 0.00083, 0.00099, 0.00104, 0.00055, 0.00101}},
    {-1.0082, -0.8789, {0.00101, 0.00226, 0.00174, 0.00190, 0.00155, 0.00129, 0.00125}},
    {-0.0584, 0.0536, {0.00083, 0.00174, 0.00702, 0.00857, 0.00506, 0.00401, 0.00245}},
    {-0.1564, -0.0683, {0.00099, 0.00190, 0.00857, 0.01377, 0.00749, 0.00534, 0.00317}},
    {0.0183, 0.0165, {0.00104, 0.00155, 0.00506, 0.00749, 0.00557, 0.00321, 0.00227}},
    {-1.1110, -0.9243, {0.00055, 0.00129, 0.00401, 0.00534, 0.00321, 0.00386, 0.00189}},
    {-1.8669, -1.7390, {0.00101, 0.00125, 0.00245, 0.00317, 0.00227, 0.00189, 0.00257}},
}};

// Programs measure at other places than the survey: 5 % of a length on their own. And they scale bodies up and down, so
// that size alone says little: 50 % of all lengths together.
constexpr double kOtherPlace = 0.05;
constexpr double kOtherSize = 0.5;

// The logarithm of the odds of a man, of measures that are jointly normal with one covariance for both sexes. (Fisher
// 1936, The use of multiple measurements in taxonomic problems)
double odds_of_measures(const std::array<std::optional<double>, kStatistics.size()>& measures) {
    std::vector<std::size_t> given;
    for (std::size_t i = 0; i < measures.size(); ++i)
        if (measures[i] && *measures[i] > 0) given.push_back(i);
    const auto count = static_cast<Eigen::Index>(given.size());
    if (count == 0) return 0;
    Eigen::MatrixXd covariance(count, count);
    Eigen::VectorXd apart(count), from_middle(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const MeasureStatistics& own = kStatistics[given[static_cast<std::size_t>(i)]];
        for (Eigen::Index k = 0; k < count; ++k) {
            covariance(i, k) = own.covariance[given[static_cast<std::size_t>(k)]] + kOtherSize * kOtherSize;
            if (i == k) covariance(i, k) += kOtherPlace * kOtherPlace;
        }
        apart[i] = own.male - own.female;
        from_middle[i] = std::log(*measures[given[static_cast<std::size_t>(i)]]) - (own.male + own.female) / 2;
    }
    return covariance.llt().solve(apart).dot(from_middle);
}

// By how far the bust stands over the underbust: 16.7 cm on the mean woman's body of the CAESAR survey and 9.8 cm on
// the mean man's, as published with GarmentCode (Korosteleva and Sorkine-Hornung 2023: mean_female, mean_male). The
// spread is an estimate: it keeps both within 1.3 of it from their middle.
double odds_of_bust(const MannequinMeasures& measures) {
    constexpr double kFemale = 0.1666, kMale = 0.0976, kSpread = 0.055;  // m
    if (!measures.bust || !measures.underbust) return 0;
    const double over = *measures.bust - *measures.underbust;
    const double to_female = over - kFemale, to_male = over - kMale;
    return (to_female * to_female - to_male * to_male) / (2 * kSpread * kSpread);
}

constexpr std::array kFemaleWords = std::to_array<std::string_view>(
    {"female", "woman", "women", "womens", "womenswear", "lady",    "ladies", "girl",  "girls", "frau",    "frauen",
     "dame",   "damen", "femme", "femmes", "mujer",      "mujeres", "donna",  "donne", "vrouw", "vrouwen", "dames"});
constexpr std::array kMaleWords = std::to_array<std::string_view>(
    {"male",   "man",  "men",     "mens",  "menswear", "gent",   "gents",   "boy",  "boys",   "herr",
     "herren", "mann", "maenner", "homme", "hommes",   "hombre", "hombres", "uomo", "uomini", "heren"});

// Words in lower case; a capital after a small letter begins a new one.
std::vector<std::string> words_of(std::string_view name) {
    std::vector<std::string> words(1);
    bool was_small = false;
    for (const char c : name) {
        const bool is_capital = c >= 'A' && c <= 'Z', is_small = c >= 'a' && c <= 'z';
        if ((!is_capital && !is_small) || (is_capital && was_small)) words.emplace_back();
        if (is_capital || is_small) words.back() += is_capital ? static_cast<char>(c - 'A' + 'a') : c;
        was_small = is_small;
    }
    return words;
}

double odds_of_name(std::string_view name) {
    constexpr double kWord = 4;  // logarithm of the odds: a name is wrong one time in fifty
    const std::optional<Sex> sex = sex_in_name(name);
    return !sex ? 0 : *sex == Sex::Male ? kWord : -kWord;
}

std::string text_of_bust(const MannequinMeasures& measures) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "the bust %.1f cm over the underbust",
                  100 * (*measures.bust - *measures.underbust));
    return text.data();
}

}  // namespace

std::optional<Sex> sex_in_name(std::string_view name) {
    std::optional<Sex> found;
    for (const std::string& word : words_of(name)) {
        const bool is_female = std::ranges::find(kFemaleWords, word) != kFemaleWords.end();
        if (!is_female && std::ranges::find(kMaleWords, word) == kMaleWords.end()) continue;
        const Sex sex = is_female ? Sex::Female : Sex::Male;
        if (found && *found != sex) return std::nullopt;  // "men_and_women"
        found = sex;
    }
    return found;
}

SexGuess guess_sex(const SexEvidence& evidence) {
    const MannequinMeasures& measures = evidence.measures;
    const double of_measures = odds_of_measures({measures.height, evidence.shoulder_breadth, measures.bust,
                                                 measures.waist, measures.hip, measures.neck, measures.wrist});
    const double of_bust = odds_of_bust(measures), of_name = odds_of_name(evidence.name);
    const double odds = of_measures + of_bust + of_name;
    SexGuess guess{.sex = odds > 0 ? Sex::Male : Sex::Female, .probability = 1 / (1 + std::exp(-std::abs(odds)))};
    const auto add = [&](const std::string& reason) { guess.reasons += (guess.reasons.empty() ? "" : ", ") + reason; };
    if (of_measures != 0) add("the measures");
    if (of_bust != 0) add(text_of_bust(measures));
    if (of_name != 0) add("the name");
    return guess;
}

}  // namespace selvedge::sim

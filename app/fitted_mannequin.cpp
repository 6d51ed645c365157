#include "app/fitted_mannequin.h"

#include "sim/paper/measurement_file.h"

namespace selvedge::app {
namespace {

void add_list(const char* title, const std::vector<std::string>& words, std::vector<std::string>& lines) {
    if (words.empty()) return;
    std::string line = title;
    for (const std::string& word : words) line += (&word == &words.front() ? "" : ", ") + word;
    lines.push_back(std::move(line));
}

FittedMannequin body_of(std::span<const sim::Measurement> measurements, std::optional<sim::Sex> sex,
                        const std::string& name) {
    std::vector<sim::NamedLength> lengths;
    for (const sim::Measurement& one : measurements) lengths.push_back({one.name, one.value});
    FittedMannequin body{.fit = mannequin_from_measurements(lengths, sex, name), .lines = {}};
    add_list("used: ", body.fit.used, body.lines);
    for (const std::string& one : body.fit.derived) body.lines.push_back("follows: " + one);
    for (const std::string& one : body.fit.refused) body.lines.push_back("not used: " + one);
    add_list("guessed by the base body: ", body.fit.guessed, body.lines);
    add_list("no measure of a mannequin: ", body.fit.ignored, body.lines);
    return body;
}

}  // namespace

FittedMannequin read_fitted_mannequin(const std::filesystem::path& path) {
    const sim::MeasurementFile file = sim::read_measurements(path);
    std::optional<sim::Sex> sex;
    if (file.sex == sim::MeasuredSex::Female) sex = sim::Sex::Female;
    if (file.sex == sim::MeasuredSex::Male) sex = sim::Sex::Male;
    FittedMannequin body = body_of(file.lengths, sex, path.stem().string());
    std::vector<std::string> lines{path.string() + ": " + file.format + ", " + std::to_string(file.lengths.size()) +
                                   " lengths"};
    lines.insert(lines.end(), file.notes.begin(), file.notes.end());
    lines.insert(lines.end(), body.lines.begin(), body.lines.end());
    body.lines = std::move(lines);
    return body;
}

FittedMannequin fitted_mannequin(std::span<const sim::Measurement> measurements, const std::string& name) {
    return body_of(measurements, {}, name);
}

}  // namespace selvedge::app

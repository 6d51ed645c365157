#include "sim/pattern/pattern_file.h"

#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/pattern/pattern_read.h"
#include "sim/pattern/pattern_write.h"

namespace selvedge {
namespace {

// "patterns/shirt_mean_specification.json" is the garment "shirt_mean".
std::string garment_name(const std::string& file) {
    std::string name = std::filesystem::path(file).stem().string();
    constexpr std::string_view suffix = "_specification";
    if (name.ends_with(suffix)) name.resize(name.size() - suffix.size());
    return name;
}

PatternReading examine(const Json& json, const std::string& file) {
    PatternReading reading = read_pattern(json, file);
    check_shapes(reading, file, units_in_meter(json));
    reading.pattern.name = garment_name(file);
    return reading;
}

PatternDocument accept(Json json, const std::string& file) {
    PatternReading reading = examine(json, file);
    for (const Fault& fault : reading.faults) {
        if (fault.severity == Severity::Error) throw InputError(fault.file, fault.place, fault.problem);
    }
    return {std::move(reading.pattern), std::move(json)};
}

template <class ReadJson>
std::vector<Fault> check(const std::string& file, ReadJson read_json_of_file) {
    try {
        return examine(read_json_of_file(), file).faults;
    } catch (const InputError& error) {
        return {{Severity::Error, error.file(), error.place(), error.problem()}};
    }
}

}  // namespace

PatternDocument load_pattern(const std::filesystem::path& path) {
    return accept(read_json(path), path.string());
}

PatternDocument parse_pattern(std::string_view text, const std::string& file) {
    return accept(parse_json(text, file), file);
}

std::vector<Fault> check_pattern_file(const std::filesystem::path& path) {
    return check(path.string(), [&] { return read_json(path); });
}

std::vector<Fault> check_pattern_text(std::string_view text, const std::string& file) {
    return check(file, [&] { return parse_json(text, file); });
}

std::string write_pattern(const PatternDocument& document) {
    return write_json(pattern_as_json(document.pattern, document.json));
}

void save_pattern(const PatternDocument& document, const std::filesystem::path& path) {
    write_file_atomically(path, write_pattern(document));
}

}  // namespace selvedge

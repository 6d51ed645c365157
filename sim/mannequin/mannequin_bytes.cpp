#include "sim/mannequin/mannequin_bytes.h"

#include <optional>
#include <string_view>

namespace selvedge::sim {
namespace {

void write_optional(FlatWriter& writer, const std::optional<double>& number) {
    writer.value(number.has_value());
    if (number) writer.value(*number);
}

std::optional<double> read_optional(FlatReader& reader) {
    return reader.value<bool>() ? std::optional(reader.value<double>()) : std::nullopt;
}

}  // namespace

void write(FlatWriter& writer, const MannequinReadings& readings) {
    for (const MeasureReading& reading : readings.readings) {
        write_optional(writer, reading.requested);
        writer.value(reading.measured);
        write_optional(writer, reading.level);
    }
    write_optional(writer, readings.stance.requested);
    writer.value(readings.stance.made);
    writer.value(readings.stance.is_opened);
    writer.value(readings.stance.gap);
}

MannequinReadings read_readings(FlatReader& reader) {
    MannequinReadings readings;
    for (const std::string_view name : measure_names()) {
        MeasureReading& reading =
            readings.readings.emplace_back(MeasureReading{.name = name, .requested = {}, .level = {}});
        reading.requested = read_optional(reader);
        reading.measured = reader.value<double>();
        reading.level = read_optional(reader);
    }
    readings.stance.requested = read_optional(reader);
    readings.stance.made = reader.value<double>();
    readings.stance.is_opened = reader.value<bool>();
    readings.stance.gap = reader.value<double>();
    return readings;
}

}  // namespace selvedge::sim

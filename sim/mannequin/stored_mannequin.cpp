#include "sim/mannequin/stored_mannequin.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "sim/core/flat_bytes.h"
#include "sim/repair/body_bytes.h"

namespace selvedge::sim {
namespace {

void write(FlatWriter& writer, const std::optional<double>& number) {
    writer.value(number.has_value());
    if (number) writer.value(*number);
}

std::optional<double> read_optional(FlatReader& reader) {
    return reader.value<bool>() ? std::optional(reader.value<double>()) : std::nullopt;
}

std::string bytes_of(const Mannequin& mannequin) {
    const MeasureReport& report = mannequin.report;
    FlatWriter writer;
    writer.text(to_bytes(mannequin.body));
    for (const MeasureReading& reading : report.readings) {  // of every measure, in the order of measure_names()
        write(writer, reading.requested);
        writer.value(reading.measured);
        write(writer, reading.level);
    }
    write(writer, report.stance.requested);
    writer.value(report.stance.made);
    writer.value(report.stance.is_opened);
    writer.value(report.stance.gap);
    writer.value(std::uint64_t(report.messages.size()));
    for (const std::string& message : report.messages) writer.text(message);
    writer.value(report.iterations);
    return writer.bytes();
}

std::optional<Mannequin> mannequin_from_bytes(std::string_view bytes) {
    FlatReader reader(bytes);
    std::optional<Body> body = body_from_bytes(reader.text());
    if (!body) return std::nullopt;
    Mannequin mannequin{.body = std::move(*body), .report = {}};
    MeasureReport& report = mannequin.report;
    for (const std::string_view name : measure_names()) {
        MeasureReading& reading =
            report.readings.emplace_back(MeasureReading{.name = name, .requested = {}, .level = {}});
        reading.requested = read_optional(reader);
        reading.measured = reader.value<double>();
        reading.level = read_optional(reader);
    }
    report.stance.requested = read_optional(reader);
    report.stance.made = reader.value<double>();
    report.stance.is_opened = reader.value<bool>();
    report.stance.gap = reader.value<double>();
    const std::uint64_t messages = reader.value<std::uint64_t>();
    for (std::uint64_t i = 0; i < messages && reader.is_sound(); ++i) report.messages.push_back(reader.text());
    report.iterations = reader.value<int>();
    if (!reader.is_sound() || !reader.is_at_end()) return std::nullopt;
    return mannequin;
}

}  // namespace

Mannequin stored_mannequin(const MannequinOptions& options, const ContentStore* store) {
    return find_or_make(
        store, "mannequin", made_from(options), [&] { return make_mannequin(options); }, bytes_of,
        mannequin_from_bytes);
}

}  // namespace selvedge::sim

#include "sim/mannequin/stored_mannequin.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "sim/core/flat_bytes.h"
#include "sim/mannequin/mannequin_bytes.h"
#include "sim/repair/body_bytes.h"

namespace selvedge::sim {
namespace {

std::string bytes_of(const Mannequin& mannequin) {
    const MeasureReport& report = mannequin.report;
    FlatWriter writer;
    writer.text(to_bytes(mannequin.body));
    write(writer, report);
    writer.texts(report.messages);
    writer.value(report.iterations);
    return writer.bytes();
}

std::optional<Mannequin> mannequin_from_bytes(std::string_view bytes) {
    FlatReader reader(bytes);
    std::optional<Body> body = body_from_bytes(reader.text());
    if (!body) return std::nullopt;
    Mannequin mannequin{.body = std::move(*body), .report = {}};
    MeasureReport& report = mannequin.report;
    static_cast<MannequinReadings&>(report) = read_readings(reader);
    report.messages = reader.texts();
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

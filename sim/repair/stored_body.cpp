#include "sim/repair/stored_body.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "sim/core/file_extension.h"
#include "sim/core/flat_bytes.h"
#include "sim/core/sha256.h"
#include "sim/repair/body_bytes.h"

namespace selvedge::sim {
namespace {

constexpr std::string_view kKind = "body";

std::string to_bytes(const MadeBody& made) {
    FlatWriter writer;
    writer.text(to_bytes(made.body));
    writer.value(std::uint64_t(made.notes.size()));
    for (const std::string& note : made.notes) writer.text(note);
    return writer.bytes();
}

std::optional<MadeBody> made_body_from_bytes(std::string_view bytes) {
    FlatReader reader(bytes);
    std::optional<Body> body = body_from_bytes(reader.text());
    if (!body) return std::nullopt;
    MadeBody made{.body = std::move(*body), .notes = {}};
    const std::uint64_t notes = reader.value<std::uint64_t>();
    for (std::uint64_t i = 0; i < notes && reader.is_sound(); ++i) made.notes.push_back(reader.text());
    if (!reader.is_sound() || !reader.is_at_end()) return std::nullopt;
    return made;
}

}  // namespace

MadeBody stored_body(const std::string& made_from, const ContentStore* store, const std::function<MadeBody()>& make) {
    if (store == nullptr) return make();
    if (const std::optional<std::string> bytes = store->find(kKind, made_from)) {
        if (std::optional<MadeBody> made = made_body_from_bytes(*bytes)) return std::move(*made);
    }
    MadeBody made = make();
    store->keep(kKind, made_from, to_bytes(made));
    return made;
}

MadeBody load_stored_body(const std::filesystem::path& path, const LoadBodyOptions& options,
                          const ContentStore* store) {
    const auto load = [&] {
        LoadBodyReport report;
        Body body = load_body(path, options, &report);
        return MadeBody{.body = std::move(body), .notes = std::move(report.notes)};
    };
    if (store == nullptr || lower_extension(path) == ".gltf") return load();
    FlatWriter key;
    key.text(canonical_name(path));
    key.text(sha256_of_file(path));
    key.value(options.unit);
    key.value(options.up);
    key.value(options.stands_on_floor);
    return stored_body(key.bytes(), store, load);
}

}  // namespace selvedge::sim

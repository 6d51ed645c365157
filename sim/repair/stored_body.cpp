#include "sim/repair/stored_body.h"

#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

#include "sim/core/file_extension.h"
#include "sim/core/flat_bytes.h"
#include "sim/core/sha256.h"
#include "sim/repair/body_bytes.h"

namespace selvedge::sim {
namespace {

struct NotedBody {
    BodyClips content;
    std::vector<std::string> notes;
};

std::string bytes_of(const NotedBody& noted) {
    FlatWriter writer;
    writer.text(to_bytes(noted.content.body));
    writer.each(noted.content.clips, [&](const Clip& clip) { write(writer, clip); });
    writer.texts(noted.notes);
    return writer.bytes();
}

std::optional<NotedBody> noted_body(std::string_view bytes) {
    FlatReader reader(bytes);
    std::optional<Body> body = body_from_bytes(reader.text());
    if (!body) return std::nullopt;
    NotedBody noted{.content = {.body = std::move(*body), .clips = {}}, .notes = {}};
    noted.content.clips = reader.each<Clip>([&](Clip& clip) { read(reader, clip); });
    noted.notes = reader.texts();
    if (!reader.is_sound() || !reader.is_at_end()) return std::nullopt;
    return noted;
}

std::string key_of(const std::filesystem::path& path, const LoadBodyOptions& options) {
    FlatWriter key;
    key.text(canonical_name(path));
    key.text(sha256_of_file(path));
    key.value(options.unit);
    key.value(options.up);
    key.value(options.must_be_person);
    key.value(options.stands_on_floor);
    return key.bytes();
}

}  // namespace

BodyClips load_stored_body(const std::filesystem::path& path, const LoadBodyOptions& options, const ContentStore* store,
                           std::vector<std::string>& notes) {
    const auto load = [&] {
        LoadBodyReport report;
        BodyClips content = load_moving_body(path, options, &report);
        return NotedBody{.content = std::move(content), .notes = std::move(report.notes)};
    };
    const bool is_kept = store != nullptr && lower_extension(path) != ".gltf";
    NotedBody noted = is_kept ? find_or_make(store, "body", key_of(path, options), load, bytes_of, noted_body) : load();
    std::ranges::move(noted.notes, std::back_inserter(notes));
    return std::move(noted.content);
}

}  // namespace selvedge::sim

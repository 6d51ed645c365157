#include "app/editor_services.h"

#include <algorithm>
#include <cmath>

#include "app/edit_loop.h"
#include "render/image/image.h"
#include "sim/body/load_body.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/json.h"
#include "sim/exchange/mesh_file.h"

namespace selvedge {
std::span<const EmbeddedFile> embedded_examples();

namespace {

namespace fs = std::filesystem;

FolderListing list_folder(const std::string& folder) {
    std::error_code error;
    const fs::path path = fs::absolute(folder.empty() ? fs::current_path() : fs::path(folder)).lexically_normal();
    FolderListing listing{
        .folder = path.string(), .parent = path.has_relative_path() ? path.parent_path().string() : "", .entries = {}};
    for (const fs::directory_entry& entry : fs::directory_iterator(path, error)) {
        const std::string name = entry.path().filename().string();
        std::error_code unreadable;
        if (!name.starts_with('.')) listing.entries.push_back({name, entry.is_directory(unreadable)});
    }
    if (error) throw InputError(path.string(), "", error.message());
    std::sort(listing.entries.begin(), listing.entries.end(), [](const FolderEntry& a, const FolderEntry& b) {
        return a.is_folder != b.is_folder ? a.is_folder : a.name < b.name;
    });
    return listing;
}

WornBody make_body(const std::string& text) {
    if (text.starts_with("mannequin")) return make_worn_mannequin(text);
    WornBody worn{.text = text, .body = std::make_shared<const Body>(load_body(text)), .measures = {}, .points = {}};
    worn.points = arrangement_points(*worn.body);
    return worn;
}

std::string age_words(double seconds) {
    const auto counted = [](double count, const char* what) {
        const long whole = std::lround(count);
        return std::to_string(whole) + " " + what + (whole == 1 ? " ago" : "s ago");
    };
    if (seconds < 90) return "a moment ago";
    if (seconds < 5400) return counted(seconds / 60, "minute");
    if (seconds < 129600) return counted(seconds / 3600, "hour");
    return counted(seconds / 86400, "day");
}

std::vector<LeftJournal> left_journals(const JournalStore& store) {
    std::vector<LeftJournal> left;
    for (const StoredJournal& stored : store.left()) {
        const auto recovery = recover(stored.text);
        if (recovery && recovery->changes > 0) {
            left.push_back({stored.path.string(), *recovery, age_words(stored.age_seconds)});
        } else {
            JournalStore::discard(stored.path);  // nothing was changed
        }
    }
    return left;
}

std::vector<Example> examples() {
    const std::span<const EmbeddedFile> files = embedded_examples();
    const auto text_of = [&](std::string_view name) {
        const auto found =
            std::find_if(files.begin(), files.end(), [&](const EmbeddedFile& file) { return file.name == name; });
        return std::string(found->text);
    };
    return {
        {"T-shirt", "Six panels, with sleeves; its tartan is matched at the seams.", text_of("patterns/tshirt.json")},
        {"Skirt", "Flared, sewn at the sides: the shortest way to a garment.", text_of("patterns/skirt.json")},
        {"Poncho", "One large square with a slit, wool that falls in folds.", text_of("patterns/poncho.json")}};
}

void write_export(const ExportRequest& request, const EditorServicesOptions& options) {
    if (!request.file.ends_with(".png")) return write_garment(request.garment, request.file);
    Scene scene = *request.scene;
    scene.camera = request.camera;
    scene.light = request.light;
    write_file_atomically(request.file, encode_png(options.draw_finely(scene)));
}

}  // namespace

Services make_editor_services(const EditorServicesOptions& options) {
    const auto journals = std::make_shared<JournalStore>(options.state / "journals");
    const auto recent = std::make_shared<const RecentFiles>(options.state / "recent.json");
    Services services;
    services.load = [](const std::string& file) { return load_pattern(file); };
    services.save = [](const std::string& file, const std::string& text) { write_file_atomically(file, text); };
    services.list_folder = list_folder;
    services.exists = [](const std::string& file) { return fs::exists(file); };
    services.write_export = [options](const ExportRequest& request) { write_export(request, options); };
    services.make_body = make_body;
    services.recent_files = [recent] { return recent->list(); };
    services.remember_file = [recent](const std::string& file) { recent->add(file); };
    services.examples = examples();
    services.begin_journal = [journals](const std::string& head) { journals->begin(head); };
    services.note_in_journal = [journals](std::string_view line) { journals->note(line); };
    services.end_journal = [journals] { journals->end(); };
    services.left_journals = [journals] { return left_journals(*journals); };
    services.discard_journal = [](const std::string& id) { JournalStore::discard(id); };
    return services;
}

std::vector<std::string> RecentFiles::list() const {
    std::vector<std::string> files;
    try {
        const Json json = read_json(file_);
        const JsonView view(json, file_.string());
        for (std::size_t i = 0; i < view.size(); ++i) {
            if (std::filesystem::exists(view.at(i).string())) files.push_back(view.at(i).string());
        }
    } catch (const InputError&) {  // none yet, or not ours: nothing was opened
    }
    return files;
}

void RecentFiles::add(const std::string& path) const {
    constexpr std::size_t kMost = 12;
    std::vector<std::string> files = list();
    const std::string whole = std::filesystem::absolute(path).lexically_normal().string();
    std::erase(files, whole);
    files.insert(files.begin(), whole);
    if (files.size() > kMost) files.resize(kMost);
    Json json = Json::array();
    for (const std::string& file : files) json.push_back(Json(file));
    try {
        write_file_atomically(file_, write_json(json));
    } catch (const InputError&) {  // a list of files is not worth an error
    }
}

FrameOutput EditorSurface::frame(const FrameInput& input) {
    const FrameSize size{.width_px = input.width_px, .height_px = input.height_px, .scale = input.scale};
    return editor_.frame(input.events, size, input.seconds);
}

FontBytes read_fonts() {
    constexpr std::size_t kLargestFont = 64U << 20U;
    const FontFiles files = find_fonts();
    const auto read = [](const std::filesystem::path& path) {
        return path.empty() ? std::string() : read_file(path, kLargestFont);
    };
    return {.regular = read(files.regular), .bold = read(files.medium)};
}

}  // namespace selvedge

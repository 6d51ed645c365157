#include "app/editor_services.h"

#include <algorithm>
#include <cmath>

#include "app/edit_loop.h"
#include "app/import_garment.h"
#include "app/print_files.h"
#include "render/image/image.h"
#include "render/image/photo.h"
#include "render/output/baked_textures.h"
#include "render/output/interface_fonts.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/file_path.h"
#include "sim/core/json.h"
#include "sim/core/printable.h"
#include "sim/core/sha256.h"
#include "sim/dress/dressing.h"
#include "sim/exchange/mesh_file.h"
#include "sim/exchange/thick_cloth.h"
#include "sim/motion/motion_file.h"
#include "sim/paper/drawing_file.h"
#include "sim/pattern/fabric_file.h"
#include "sim/pattern/pattern.h"

namespace selvedge::app {
std::span<const sim::EmbeddedFile> embedded_examples();
std::span<const sim::EmbeddedFile> embedded_manual();

namespace {

namespace fs = std::filesystem;

editor::FolderListing list_folder(const std::string& folder) {
    std::error_code error;
    fs::path path = sim::absolute_path(folder.empty() ? "." : folder).lexically_normal();
    if (path.has_relative_path() && !path.has_filename()) path = path.parent_path();  // "shirts/" is "shirts"
    editor::FolderListing listing{
        .folder = path.string(), .parent = path.has_relative_path() ? path.parent_path().string() : "", .entries = {}};
    for (const fs::path& entry : sim::entries_of(path, error)) {
        const std::string name = entry.filename().string();
        if (!name.starts_with('.')) listing.entries.push_back({name, sim::is_folder(entry)});
    }
    if (error) throw sim::InputError(path.string(), "", error.message());
    std::sort(listing.entries.begin(), listing.entries.end(),
              [](const editor::FolderEntry& a, const editor::FolderEntry& b) {
                  return a.is_folder != b.is_folder ? a.is_folder : a.name < b.name;
              });
    return listing;
}

editor::CurrentBody make_current_body(const std::string& text) {
    return sim::is_body_file(text) ? editor::current_body(sim::make_body(text, {.must_be_person = true}))
                                   : editor::make_mannequin_body(text);
}

std::string age_text(double seconds) {
    const auto counted = [](double count, const char* what) {
        const long whole = std::lround(count);
        return std::to_string(whole) + " " + what + (whole == 1 ? " ago" : "s ago");
    };
    if (seconds < 90) return "a moment ago";
    if (seconds < 5400) return counted(seconds / 60, "minute");
    if (seconds < 129600) return counted(seconds / 3600, "hour");
    return counted(seconds / 86400, "day");
}

std::vector<editor::OrphanedJournal> orphaned_journals(const JournalStore& store) {
    std::vector<editor::OrphanedJournal> left;
    for (const StoredJournal& stored : store.left()) {
        std::optional<editor::Recovery> recovery = editor::recover(stored.text);
        const bool has_content = recovery && (recovery->has_changes() || !recovery->drafts.empty());
        const bool is_damaged = recovery ? recovery->unread_lines > 0 : !stored.text.empty();
        if (!has_content && !is_damaged) {
            JournalStore::discard(stored.path);  // contains no changes
            continue;
        }
        if (!has_content) recovery.reset();
        left.push_back({stored.path.string(), std::move(recovery), age_text(stored.age_seconds)});
    }
    return left;
}

std::vector<editor::Example> examples() {
    const std::span<const sim::EmbeddedFile> files = embedded_examples();
    const auto text_of = [&](std::string_view name) {
        const auto found =
            std::find_if(files.begin(), files.end(), [&](const sim::EmbeddedFile& file) { return file.name == name; });
        return std::string(found->text);
    };
    return {
        {"T-shirt", "Six panels, with sleeves; its tartan is matched at the seams.", text_of("patterns/tshirt.json")},
        {"Skirt", "Flared, sewn at the sides: the shortest way to a garment.", text_of("patterns/skirt.json")},
        {"Poncho", "One large square with a slit, wool that falls in folds.", text_of("patterns/poncho.json")}};
}

// Of each panel of the mesh, m. Throws InputError if a fabric cannot be read.
std::vector<float> thickness_of_panels(const editor::ExportRequest& request) {
    const std::vector<std::string>& names = request.garment.panel_names;
    if (request.thickness.kind == editor::ExportThickness::Kind::Given)
        return std::vector<float>(std::max<std::size_t>(1, names.size()), static_cast<float>(request.thickness.metres));
    const std::vector<sim::Fabric> fabrics = fabrics_of(request.pattern);
    std::vector<float> thickness;
    for (const std::string& name : names) {
        const auto panel = std::ranges::find(request.pattern.panels, name, &sim::Panel::name);
        const auto index = static_cast<std::size_t>(panel - request.pattern.panels.begin());
        const bool is_known = panel != request.pattern.panels.end();  // it may have been renamed since
        const sim::Fabric fabric = is_known ? fabrics[index] : sim::find_fabric(request.pattern.fabric);
        thickness.push_back(static_cast<float>(fabric.thickness));
    }
    return thickness;
}

void write_export(const editor::ExportRequest& request, const EditorServicesOptions& options) {
    if (!request.file.ends_with(".png")) {
        sim::GarmentExport content;
        if (sim::mesh_format_of(request.file).takes_textures)
            content.textures = render::bake_pngs(request.garment, request.scene->cloths, content.atlas);
        if (request.thickness.kind == editor::ExportThickness::Kind::None)
            return write_garment(request.garment, request.file, content);
        return write_garment(with_thickness(request.garment, thickness_of_panels(request)), request.file, content);
    }
    render::Scene scene = *request.scene;
    scene.camera = request.camera;
    scene.light = request.light;
    sim::write_file_atomically(request.file, encode_png(options.render_full_quality(scene)));
}

std::string lower_ending(const std::string& file) {
    std::string ending = fs::path(file).extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return ending;
}

bool is_photo(const std::string& file) {
    const std::string ending = lower_ending(file);
    return ending == ".png" || ending == ".jpg" || ending == ".jpeg";
}

// SVG, DXF and PDF by their endings, FreeSewing's data by its content.
bool is_drawing(const std::string& file) {
    const std::string ending = lower_ending(file);
    if (ending == ".svg" || ending == ".dxf" || ending == ".pdf") return true;
    if (ending != ".json") return false;
    try {
        sim::read_drawing(file);
        return true;
    } catch (const sim::InputError&) {
        return false;
    }
}

editor::ImportedDrawing import_drawing(const std::string& file, const sim::ImportOptions& options) {
    ImportedGarment garment = import_garment({file}, options);
    editor::ImportedDrawing drawing;
    drawing.sewn = sim::count_text(garment.pattern.panels.size(), "panel") + ", " +
                   sim::count_text(garment.pattern.seams.size(), "seam");
    name_beside(garment.pictures, garment.pattern, file);
    for (UnderlayFile& picture : garment.pictures)
        drawing.pictures.push_back({picture.path.string(), std::move(picture.bytes)});
    if (!garment.possible.empty())
        drawing.sewn += "; " + sim::count_text(garment.possible.size(), "seam") + " less likely, not sewn";
    drawing.notes = std::move(garment.notes);
    drawing.hints = std::move(garment.hints);
    drawing.sizes = std::move(garment.sizes);
    drawing.garment.pattern = std::move(garment.pattern);
    return drawing;
}

// Of docs/editor.md: what a user needs, from the mark on.
std::string manual() {
    constexpr std::string_view kMark = "<!-- The manual in the menu Help begins here. -->";
    const std::string_view text = embedded_manual().front().text;
    const std::size_t mark = text.find(kMark);
    return std::string(mark == std::string_view::npos ? text : text.substr(mark + kMark.size()));
}

std::string print_from_editor(const sim::Pattern& pattern, const std::string& file,
                              const sim::PrintSettings& settings) {
    const Printed printed = print_pattern(pattern, file, settings);
    std::string text = printed.what;
    for (const std::string& note : printed.notes) text += "; " + note;
    return text;
}

}  // namespace

namespace {

void add_journals(editor::Services& services, const fs::path& folder) {
    const auto journals = std::make_shared<JournalStore>(folder);
    services.begin_journal = [journals](const std::string& text) { journals->begin(text); };
    services.note_in_journal = [journals](std::string_view line) { journals->note(line); };
    services.end_journal = [journals] { journals->end(); };
    services.journal_problem = [journals] { return journals->problem(); };
    services.orphaned_journals = [journals] { return orphaned_journals(*journals); };
    services.discard_journal = [](const std::string& id) { JournalStore::discard(id); };
    services.set_aside_journal = [](const std::string& id) { return JournalStore::set_aside(id).string(); };
}

void add_state(editor::Services& services, const fs::path& folder) {
    add_journals(services, folder / "journals");
    const auto recent = std::make_shared<const RecentFiles>(folder / "recent.json");
    const auto settings = std::make_shared<const SettingsFile>(folder / "settings.json");
    services.load_settings = [settings] { return settings->load(); };
    services.save_settings = [settings](const editor::UserSettings& chosen) { settings->save(chosen); };
    services.recent_files = [recent] { return recent->list(); };
    services.remember_file = [recent](const std::string& file) { recent->add(file); };
}

void add_no_state(editor::Services& services) {
    services.recent_files = [] { return std::vector<std::string>(); };
    services.remember_file = [](const std::string&) {};
    services.begin_journal = [](const std::string&) {};
    services.note_in_journal = [](std::string_view) {};
    services.end_journal = [] {};
    services.orphaned_journals = [] { return std::vector<editor::OrphanedJournal>(); };
    services.discard_journal = [](const std::string&) {};
    services.set_aside_journal = [](const std::string& id) { return id; };
}

}  // namespace

editor::Services make_editor_services(const EditorServicesOptions& options) {
    editor::Services services;
    options.state ? add_state(services, *options.state) : add_no_state(services);
    services.load = [](const std::string& file) { return sim::load_pattern(file); };
    services.save = [](const std::string& file, const std::string& text) { sim::write_file_atomically(file, text); };
    services.remove = [](const std::string& file) {
        std::error_code error;
        fs::remove(file, error);
    };
    services.is_drawing = is_drawing;
    services.import_drawing = import_drawing;
    services.is_photo = is_photo;
    services.read_photo = [](const std::string& file) { return render::read_photo(file); };
    services.full_path = [](const std::string& file) { return sim::canonical_path(file).string(); };
    services.print = print_from_editor;
    services.list_folder = list_folder;
    services.exists = [](const std::string& file) { return sim::file_exists(file); };
    services.hash_of = [](const std::string& file) -> std::optional<std::string> {
        try {
            return sim::sha256_of_file(file);
        } catch (const sim::InputError&) {
            return std::nullopt;
        }
    };
    services.write_export = [options](const editor::ExportRequest& request) { write_export(request, options); };
    services.make_body = make_current_body;
    services.find_motion = sim::find_motion;
    services.read_fabric = sim::read_fabric_file;
    services.examples = examples();
    services.manual = manual();
    return services;
}

std::vector<std::string> RecentFiles::list() const {
    std::vector<std::string> files;
    try {
        const sim::Json json = sim::read_json(file_);
        const sim::JsonView view(json, file_.string());
        for (std::size_t i = 0; i < view.size(); ++i) {
            if (sim::file_exists(view.at(i).string())) files.push_back(view.at(i).string());
        }
    } catch (const sim::InputError&) {  // no list yet, or an invalid one
    }
    return files;
}

void RecentFiles::add(const std::string& path) const {
    constexpr std::size_t kMaxRecentFiles = 12;
    std::vector<std::string> files = list();
    const std::string whole = sim::absolute_path(path).lexically_normal().string();
    std::erase(files, whole);
    files.insert(files.begin(), whole);
    if (files.size() > kMaxRecentFiles) files.resize(kMaxRecentFiles);
    sim::Json json = sim::Json::array();
    for (const std::string& file : files) json.push_back(sim::Json(file));
    try {
        sim::write_file_atomically(file_, write_json(json));
    } catch (const sim::InputError&) {  // not important enough to report
    }
}

namespace {

constexpr std::string_view kMarvelousDesigner = "marvelous_designer", kSelvedge = "selvedge", kDark = "dark",
                           kLight = "light";

bool is_text(const sim::Json& json, std::string_view key, std::string_view text) {
    const sim::Json* value = json.find(key);
    return value != nullptr && value->is_string() && value->string() == text;
}

}  // namespace

editor::UserSettings SettingsFile::load() const {
    editor::UserSettings settings;
    try {
        const sim::Json json = sim::read_json(file_);
        if (is_text(json, "keys", kMarvelousDesigner)) settings.keys = editor::KeyMap::MarvelousDesigner;
        settings.is_dark = is_text(json, "theme", kDark);
    } catch (const sim::InputError&) {  // no choice yet, or an invalid file
    }
    return settings;
}

void SettingsFile::save(const editor::UserSettings& settings) const {
    sim::Json json = sim::Json::object();
    json["keys"] = sim::Json(settings.keys == editor::KeyMap::MarvelousDesigner ? kMarvelousDesigner : kSelvedge);
    json["theme"] = sim::Json(settings.is_dark ? kDark : kLight);
    try {
        sim::write_file_atomically(file_, write_json(json));
    } catch (const sim::InputError&) {  // the choice holds until the editor ends
    }
}

editor::FrameOutput EditorSurface::frame(const FrameInput& input) {
    const editor::FrameSize size{.width_px = input.width_px, .height_px = input.height_px, .scale = input.scale};
    return editor_.frame(input.events, size, input.seconds);
}

editor::FontBytes read_fonts() {
    constexpr std::size_t kLargestFont = 64U << 20U;
    const render::FontFiles files = render::find_fonts();
    const auto read = [](const std::filesystem::path& path) {
        return path.empty() ? std::string() : sim::read_file(path, kLargestFont);
    };
    return {.regular = read(files.regular), .bold = read(files.medium)};
}

}  // namespace selvedge::app

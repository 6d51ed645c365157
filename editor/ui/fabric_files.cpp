#include "editor/ui/fabric_files.h"

#include <optional>
#include <utility>
#include <vector>

#include "editor/inspectors/material_inspector.h"
#include "editor/ui/app_state.h"
#include "editor/ui/files.h"
#include "sim/core/error.h"
#include "sim/pattern/fabric_file.h"

namespace selvedge::editor {
namespace {

// Writes the draft of `name` to `file`, and ends it. Throws InputError.
void write_draft(AppState& state, const std::string& name, const std::string& file) {
    FabricLibrary& fabrics = state.workspace.fabrics;
    const FabricLibrary::Entry& entry = fabrics.find(name);
    sim::Fabric fabric = entry.draft.value_or(entry.file.fabric);
    if (file != name) fabric.name = sim::fabric_title(file);
    sim::FabricFile written{.text = write_fabric(fabric, file, entry.file.text)};
    written.fabric = sim::parse_fabric(written.text, file);
    state.services.save(file, written.text);
    fabrics.take_written(file, std::move(written));
    fabrics.drop_draft(name);
    fabrics.drop_draft(file);  // it was to be replaced
    fabrics.show(file);
    state.workspace.drape.reread_fabrics();
}

// Whether the file holds something else than what was read of it.
bool was_changed_since(const AppState& state, const std::string& name, const std::string& text) {
    if (!state.services.exists(name)) return false;
    try {
        return state.services.read_fabric(name).text != text;
    } catch (const sim::InputError&) {
        return true;
    }
}

bool save_over(AppState& state, const std::string& name) {
    return try_to(state, [&] {
        write_draft(state, name, name);
        state.workspace.messages.note("Saved " + name);
    });
}

}  // namespace

void open_fabric(AppState& state, const std::string& file) {
    try_to(state, [&] {
        state.workspace.fabrics.open(state.services.full_path(file));
        state.workspace.drape.reread_fabrics();
    });
}

bool save_fabric(AppState& state, const std::string& name) {
    const FabricLibrary::Entry& entry = state.workspace.fabrics.find(name);
    if (!entry.draft) return true;
    if (!was_changed_since(state, name, entry.file.text)) return save_over(state, name);
    state.questions.push_front({"'" + name + "' was changed by another program since it was read.",
                                {{"Replace", [name](AppState& current) { save_over(current, name); }},
                                 {"Save as...", [name](AppState& current) { browse_to_save_fabric(current, name); }},
                                 {"Cancel", [](AppState&) {}}}});
    return false;
}

void save_fabric_as(AppState& state, const std::string& name, const std::string& file) {
    const std::string target = state.services.full_path(with_ending(file, ".json"));
    if (target == name) return void(save_fabric(state, name));
    const auto write = [name, target](AppState& current) {
        current.workspace.document->commit();
        try_to(current, [&] {
            write_draft(current, name, target);
            Workspace& workspace = current.workspace;
            const std::size_t before = workspace.document->position();
            workspace.run(ReplaceFabric{.from = name, .to = target});
            const bool is_used = workspace.document->position() != before;
            workspace.messages.note("Saved as " + target +
                                    (is_used ? "" : ". Nothing is made of it yet: the Cloth tab puts it to use"));
        });
    };
    if (!state.services.exists(target)) return write(state);
    ask_to_replace(state, target, write);
}

void browse_to_open_fabric(AppState& state) {
    state.browser.open({.title = "Open a fabric",
                        .verb = "Open",
                        .endings = {".json"},
                        .choose = [](AppState& current, const std::string& file) { open_fabric(current, file); }},
                       state.services);
}

void browse_to_save_fabric(AppState& state, const std::string& name) {
    state.browser.open(
        {.title = "Save the fabric",
         .verb = "Save",
         .endings = {".json"},
         .is_saving = true,
         .name = (sim::is_shipped_fabric(name) ? "my_" + name : sim::fabric_title(name)) + ".json",
         .choose = [name](AppState& current, const std::string& file) { save_fabric_as(current, name, file); }},
        state.services);
}

void browse_for_fabric_picture(AppState& state, const std::string& name) {
    const auto show = [name](AppState& current, const std::string& file) {
        FabricLibrary& fabrics = current.workspace.fabrics;
        if (!fabrics.find(name).draft) return;
        sim::Fabric draft = *fabrics.find(name).draft;
        if (!draft.surface) draft.surface.emplace();
        draft.surface->kind = sim::DesignKind::Picture;
        draft.surface->source = current.services.full_path(file);
        try_to(current, [&] {
            current.services.read_photo(file);  // so that a file that is none is refused
            fabrics.set_draft(name, draft);
        });
    };
    state.browser.open({.title = "Choose a picture that the fabric shows",
                        .verb = "Show",
                        .endings = {".png", ".jpg", ".jpeg", ".PNG", ".JPG", ".JPEG"},
                        .choose = show},
                       state.services);
}

void after_asking_about_fabrics(AppState& state, std::function<void(AppState&)> go_on) {
    const std::vector<std::string> changed = state.workspace.fabrics.changed();
    if (changed.empty()) return go_on(state);
    const std::string name = changed.front();
    const bool is_shipped = sim::is_shipped_fabric(name);
    const auto save_first = [name, is_shipped, go_on](AppState& current) {
        if (is_shipped) return browse_to_save_fabric(current, name);
        if (save_fabric(current, name)) after_asking_about_fabrics(current, go_on);
    };
    const auto drop = [name, go_on](AppState& current) {
        current.workspace.fabrics.drop_draft(name);
        after_asking_about_fabrics(current, go_on);
    };
    state.questions.push_front(
        {"The fabric '" + readable_name(name) + "' has changes that are not saved.",
         {{is_shipped ? "Save as..." : "Save", save_first}, {"Discard", drop}, {"Cancel", [](AppState&) {}}}});
}

}  // namespace selvedge::editor

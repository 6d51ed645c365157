// selvedge edit [FILE]: the pattern editor, in a window, or run by a script without one.
#include "app/edit.h"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/arguments.h"
#include "app/commands.h"
#include "app/edit_loop.h"
#include "app/editor_services.h"
#include "app/fallback_fonts.h"
#include "app/options.h"
#include "app/picture.h"
#include "editor/ui/app_state.h"
#include "editor/ui/files.h"
#include "editor/ui/script.h"
#include "render/image/image.h"
#include "render/output/interface_fonts.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/printable.h"
#include "sim/pattern/named_file.h"

namespace selvedge::app {
namespace {

constexpr std::size_t kLargestScript = 16U << 20U;

struct EditArguments {
    std::string file;
    std::string script;
    std::string screenshot;
    std::string frame_times;
    std::string state;
    std::string size = "1280x800";
    std::optional<float> scale;
};

struct Size {
    int width = 0;
    int height = 0;
};

Size parse_window_size(const std::string& text) {
    constexpr int kSmallest = 200, kLargest = 8192;
    Size size;
    char rest = 0;
    const bool is_read = std::sscanf(text.c_str(), "%dx%d%c", &size.width, &size.height, &rest) == 2;
    const auto fits = [&](int side) { return side >= kSmallest && side <= kLargest; };
    if (!is_read || !fits(size.width) || !fits(size.height)) {
        throw sim::InputError("", "--size", "'" + text + "' is not WIDTHxHEIGHT, from 200x200 to 8192x8192");
    }
    return size;
}

constexpr const char* kNoState = "without a folder for state (--state): after a crash, nothing can be recovered";

// None if the user has no home, or none that we can write: then nothing is kept. A folder that is asked for must do.
std::optional<std::filesystem::path> state_of(const EditArguments& arguments) {
    if (!arguments.state.empty()) return arguments.state;
    const std::optional<std::filesystem::path> folder = state_folder();
    std::string why;
    if (folder) {
        try {
            JournalStore{*folder / "journals"};
            return folder;
        } catch (const sim::InputError& error) {
            why = std::string(": ") + error.what();
        }
    }
    std::fprintf(stderr, "selvedge: note: %s%s\n", kNoState, why.c_str());
    return {};
}

std::vector<std::filesystem::path> given(const EditArguments& arguments) {
    std::vector<std::filesystem::path> files{arguments.file, arguments.script};
    std::erase(files, std::filesystem::path());
    return files;
}

void open_at_start(editor::Editor& editor, const std::string& file) {
    if (file.empty()) return;
    if (editor.state().services.is_photo(file)) {
        editor.state().services.read_photo(file);  // likewise
        return lay_photo(editor.state(), file);
    }
    load_and_open(editor.state(), file);  // an invalid file ends the program
}

int run_window(const EditArguments& arguments) {
    const Size size = parse_window_size(arguments.size);
    if (!arguments.frame_times.empty()) {
        check_output(arguments.frame_times);
        check_distinct({arguments.frame_times}, given(arguments));
    }
    Window window({.width = size.width, .height = size.height, .scale = arguments.scale});
    std::unique_ptr<render::Renderer> fine;  // created when a picture is exported
    const auto render_full_quality = [&](const render::Scene& scene) {
        if (!fine) fine = std::make_unique<render::Renderer>(window.context());
        return fine->draw(scene, {.width_px = 2048, .height_px = 2048});
    };
    const std::optional<std::filesystem::path> state = state_of(arguments);
    editor::Editor editor(make_editor_services({.state = state, .render_full_quality = render_full_quality}),
                          {.fonts = read_fonts(), .find_fonts = find_fallback_fonts});
    if (!state) editor.state().workspace.messages.warn(std::string("The editor runs ") + kNoState);
    editor.set_clipboard(
        {[&] { return window.clipboard(); }, [&](const std::string& text) { window.set_clipboard(text); }});
    // What is wrong with the file is shown in the window.
    if (!arguments.file.empty()) take_dropped_file(editor.state(), arguments.file);
    EditorSurface surface(editor);
    try {
        run_edit_loop(surface, window,
                      {.frame_times = arguments.frame_times, .legend_font = render::read_legend_font()});
    } catch (const std::exception&) {  // main tells it
        if (state && editor.state().workspace.document->has_unsaved_changes())
            std::fprintf(stderr, "selvedge: note: the editor offers the unsaved changes when it is started again\n");
        throw;
    }
    return 0;
}

int run_script(const EditArguments& arguments) {
    const Size size = parse_window_size(arguments.size);
    EditorScript script{.file = arguments.file,
                        .name = arguments.script,
                        .state = state_of(arguments),
                        .width_px = size.width,
                        .height_px = size.height,
                        .scale = arguments.scale.value_or(1)};
    if (!arguments.script.empty()) script.text = sim::read_file(arguments.script, kLargestScript);
    if (!arguments.screenshot.empty()) {
        check_output(arguments.screenshot, kPictureExtensions);
        check_distinct({arguments.screenshot}, given(arguments));
    }
    const render::Image last = play_script(script);
    if (!arguments.screenshot.empty()) write_png(arguments.screenshot, last);
    return 0;
}

std::vector<std::filesystem::path> inputs_of(const editor::AppState& state, const EditorScript& script) {
    std::vector<std::filesystem::path> inputs{script.name, script.file, state.workspace.file};
    for (const std::string& file : named_files(state.workspace.document->pattern())) inputs.emplace_back(file);
    std::erase(inputs, std::filesystem::path());
    return inputs;
}

// What a script writes is not to be itself.
void keep_script(editor::Services& services, const std::string& script) {
    const auto check = [script](const std::string& file) { check_distinct({file}, {script}); };
    services.save = [check, save = services.save](const std::string& file, const std::string& text) {
        check(file);
        save(file, text);
    };
    services.print = [check, print = services.print](const sim::Pattern& pattern, const std::string& file,
                                                     const sim::PrintSettings& settings) {
        check(file);
        return print(pattern, file, settings);
    };
    services.write_export = [check, write = services.write_export](const editor::ExportRequest& request) {
        check(request.file);
        write(request);
    };
}

}  // namespace

render::Image play_script(const EditorScript& script) {
    const std::vector<editor::ScriptStep> steps = editor::parse_script(script.text, script.name);
    OffscreenEditLoop loop({.width_px = script.width_px,
                            .height_px = script.height_px,
                            .scale = script.scale,
                            .legend_font = render::read_legend_font()});
    const auto render_full_quality = [](const render::Scene&) -> render::Image {
        throw sim::InputError("", "export", "a script takes pictures by 'screenshot'");
    };
    editor::Services services =
        make_editor_services({.state = script.state, .render_full_quality = render_full_quality});
    services.load_settings = nullptr;  // a script's keys and colours are the editor's own, whatever the user chose
    services.save_settings = nullptr;
    if (!script.name.empty()) keep_script(services, script.name);
    editor::Editor editor(std::move(services), {.drive = sim::SessionDrive::Caller,
                                                .fonts = read_fonts(),
                                                .find_fonts = find_fallback_fonts,
                                                .is_steady = true});
    open_at_start(editor, script.file);
    EditorSurface surface(editor);
    const auto shoot = [&](const std::string& file) {
        check_distinct({file}, inputs_of(editor.state(), script));
        write_png(file, loop.screenshot());
    };
    const auto step = [&](const std::vector<editor::InputEvent>& events) { loop.step(surface, events); };
    const auto say = [](const std::string& text) { std::printf("%s\n", sim::printable(text).c_str()); };
    editor::ScriptPlayer player(editor, {step, shoot, say}, script.name);
    for (int i = 0; i < 3; ++i) loop.step(surface);
    // What a script leaves unsaved is nobody's work to recover.
    const struct EndOfJournal {
        editor::Editor& editor;
        ~EndOfJournal() { editor.state().services.end_journal(); }
    } end_of_journal{editor};
    player.play(steps);
    return loop.screenshot();
}

void add_edit_command(Command& app, int& exit_code) {
    auto arguments = std::make_shared<EditArguments>();
    Command& command = add_command(app, "edit", "Draw panels, sew them, place them and watch them drape");
    add_option(command, "FILE", arguments->file, "Garment file to open", {.type = "FILE"});
    add_option(command, "--script", arguments->script, "Plays this script without a window (docs/editor.md)",
               {.type = "FILE"});
    add_option(command, "--screenshot", arguments->screenshot, "Without a window: what is seen at the end",
               {.type = "PNG"});
    add_option(command, "--size", arguments->size, "Of the window in pixels (default 1280x800)", {.type = "WxH"});
    add_option(command, "--scale", arguments->scale, "Of letters and buttons, 0.5 to 4 (default the screen's)",
               {.range = Limits<float>{0.5F, 4.0F}});
    add_option(command, "--frame-times", arguments->frame_times, "Writes where each frame's time went",
               {.type = "CSV"});
    add_option(command, "--state", arguments->state, "Where journals and recent files are kept", {.type = "FOLDER"});
    set_footer(command,
               "Examples:\n"
               "  selvedge edit\n"
               "  selvedge edit patterns/tshirt.json\n"
               "  selvedge edit patterns/tshirt.json --screenshot editor.png");
    set_action(command, [arguments, &exit_code] {
        const bool has_window = arguments->script.empty() && arguments->screenshot.empty();
        exit_code = has_window ? run_window(*arguments) : run_script(*arguments);
    });
}

}  // namespace selvedge::app

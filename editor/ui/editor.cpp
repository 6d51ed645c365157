#include "editor/ui/editor.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "editor/frame/item.h"
#include "editor/frame/keyboard.h"
#include "editor/frame/theme.h"
#include "editor/inspectors/inspectors.h"
#include "editor/sheet/sheet_view.h"
#include "editor/tools/tool_host.h"
#include "editor/ui/actions.h"
#include "editor/ui/bars.h"
#include "editor/ui/fabric_files.h"
#include "editor/ui/files.h"
#include "editor/ui/help_windows.h"
#include "editor/ui/timeline.h"
#include "editor/ui/tool_bar.h"
#include "editor/ui/ui_input.h"
#include "editor/ui/widgets.h"
#include "editor/viewport3d/viewport.h"
#include "sim/pattern/field_visit.h"
#include "sim/pattern/pattern_fields.h"

namespace selvedge::editor {
namespace {

// Texture numbers, see editor/frame/frame.h.
constexpr UiTexture kSheetTexture = 1, kViewportTexture = kSheetTexture + kSheetTextures,
                    kLegendTexture = kViewportTexture + 1, kFirstFreeTexture = kLegendTexture + 1;

constexpr const char* kSheetWindow = "##sheet";

struct Rectangle {
    ImVec2 low;
    ImVec2 size;
};

// The regions of the window, px.
struct Regions {
    Rectangle tools, sheet, viewport, inspectors, status;
};

constexpr auto kRegionFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                              ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

Regions share_out(const WindowLayout& layout, float question_height) {
    const float unit = ImGui::GetFontSize();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float top = ImGui::GetFrameHeight() + question_height;
    const float status = ImGui::GetFrameHeight() + 0.3F * unit;
    const float height = std::max(unit, display.y - top - status);
    const float tools = layout.has_tools ? tool_bar_width(height) : 0;
    const float inspectors = layout.has_inspectors ? std::min(layout.inspector_width * unit, display.x * 0.5F) : 0;
    const float views = std::max(unit, display.x - tools - inspectors);
    const float share = !layout.has_viewport ? 1 : !layout.has_sheet ? 0 : layout.sheet_share;
    const float sheet = std::round(views * share);
    return {.tools = {{0, top}, {tools, height}},
            .sheet = {{tools, top}, {sheet, height}},
            .viewport = {{tools + sheet, top}, {views - sheet, height}},
            .inspectors = {{display.x - inspectors, top}, {inspectors, height}},
            .status = {{0, display.y - status}, {display.x, status}}};
}

bool begin_region(const char* name, const Rectangle& where, const ImVec2& padding, ImGuiWindowFlags more = 0) {
    ImGui::SetNextWindowPos(where.low);
    ImGui::SetNextWindowSize(where.size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    const bool is_open = ImGui::Begin(name, nullptr, kRegionFlags | more);
    ImGui::PopStyleVar(3);
    return is_open;
}

// A thin vertical bar between two regions that can be dragged. Returns the drag distance, px.
float splitter(AppState& state, const char* name, float x, const Rectangle& beside, FrameOutput& output) {
    const float half = 0.25F * ImGui::GetFontSize();
    begin_region(name, {{x - half, beside.low.y}, {2 * half, beside.size.y}}, {0, 0}, ImGuiWindowFlags_NoBackground);
    ImGui::InvisibleButton("##grip", {2 * half, beside.size.y});
    note_widget(state.widgets, name);
    const bool is_held = ImGui::IsItemActive();
    const bool is_lit = is_held || ImGui::IsItemHovered();
    if (is_lit) {
        output.cursor = MouseCursor::ResizeHorizontal;
        const ImU32 colour = ImGui::GetColorU32(ImGuiCol_SeparatorActive);
        ImGui::GetWindowDrawList()->AddLine({x, beside.low.y}, {x, beside.low.y + beside.size.y}, colour, half / 2);
    }
    ImGui::End();
    return is_held ? ImGui::GetIO().MouseDelta.x : 0;
}

bool is_pressed(const Chord& chord) {
    const ImGuiIO& io = ImGui::GetIO();
    const Modifiers held{.ctrl = io.KeyCtrl, .shift = io.KeyShift, .alt = io.KeyAlt};
    return held == chord.modifiers && is_key_pressed(chord.key);
}

// Keeps the last request of each texture.
template <class Request>
void keep_last(std::vector<Request>& requests) {
    std::vector<Request> kept;
    std::set<UiTexture> seen;
    for (auto request = requests.rbegin(); request != requests.rend(); ++request) {
        if (seen.insert(request->texture).second) kept.push_back(std::move(*request));
    }
    std::reverse(kept.begin(), kept.end());
    requests = std::move(kept);
}

using VisitText = std::function<void(std::string_view)>;

void visit_pattern(const sim::Pattern& pattern, const VisitText& visit) {
    visit_values(pattern, [&]<class T>(const auto&, const T& value) {
        if constexpr (std::is_same_v<T, std::string>) visit(value);
    });
}

void visit_drape(const Drape& drape, const VisitText& visit) {
    const CurrentBody& body = drape.current_body();
    visit(body.made().source);
    for (const std::string& note : body.made().notes) visit(note);
    for (const sim::Clip& clip : body.made().clips) visit(clip.name);
    for (const BodyJoint& joint : body.joints) visit(joint.title);
    for (const std::string& file : drape.pose_files()) visit(file);
    visit(drape.activity().motion);
    visit(drape.frame()->problem);
}

// The text on screen that is not the editor's own: names in the garment, of files, bodies and motions, and messages.
// Texts that a control holds while they are typed are not among them.
void visit_shown_text(const AppState& state, const VisitText& visit) {
    visit_pattern(state.workspace.document->pattern(), visit);
    visit_drape(state.workspace.drape, visit);
    visit(state.workspace.file);
    for (const std::string& file : state.workspace.fabrics.files()) visit(file);
    if (const Message* message = state.workspace.messages.shown()) visit(message->text);
    for (const Question& question : state.questions) visit(question.text);
    state.browser.visit_text(visit);
    if (!state.shows_start_page) return;
    for (const std::string& file : state.services.recent_files()) visit(file);
}

}  // namespace

AppState::AppState(Services given, sim::SessionDrive drive)
    : services(std::move(given)),
      workspace(empty_garment(), drive, services.make_body, services.find_motion, services.read_fabric),
      actions(make_actions()) {
    if (!services.load_settings) return;
    const UserSettings settings = services.load_settings();
    tools.key_map = settings.keys;
    is_dark = settings.is_dark;
}

struct Editor::Impl {
    Impl(Services services, EditorOptions given)
        : options(std::move(given)), state(std::move(services), options.drive), context(ImGui::CreateContext()) {
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.LogFilename = nullptr;
        io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
        io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
        io.ConfigInputTextCursorBlink = !options.is_steady;
        map_keys(io);
        state.shows_times = !options.is_steady;
        state.inspectors.boxes.gives_keys_back = true;  // the first keys are for the sheet
        begin_journal(state);
        offer_recovery(state);
    }
    ~Impl() { ImGui::DestroyContext(context); }

    void update_letters(const std::vector<InputEvent>& events);
    void set_size(const FrameSize& size);
    void build_frame(double seconds);
    void rebuild_fonts();
    void run_keys();
    void take_other_events(const std::vector<InputEvent>& events);
    void show_views(double seconds);
    void show_splitters(const Regions& regions);
    void show_sheet(const Rectangle& where);
    void show_viewport(const Rectangle& where, double seconds);
    void show_inspectors(const Rectangle& where);
    InspectorContext inspector_context();

    EditorOptions options;
    AppState state;
    ImGuiContext* context;
    UiInput input;
    SheetView sheet;
    Viewport viewport;
    MessageClock message_clock;
    FrameOutput output;
    std::vector<Key> used_keys;  // consumed by a view in this frame
    UiTexture next_texture = kFirstFreeTexture;
    float scale = 0;
    bool shown_dark = false;
    SheetColours sheet_colours;
    Letters letters;        // on screen so far, beyond the basic ones
    Letters asked_letters;  // for which fonts were looked for
    bool has_new_letters = false;
    int shown_document = 0;
    Clipboard clipboard;
    std::string clipboard_text;  // backing store of the text that ImGui reads
};

// Collects the letters of the text that the next frame shows.
void Editor::Impl::update_letters(const std::vector<InputEvent>& events) {
    constexpr std::size_t kMaxLetters = 3000;  // bounds the font atlas; further letters stay question marks
    const std::size_t before = letters.size();
    const auto add = [this](std::string_view text) {
        if (letters.size() < kMaxLetters) add_letters(text, letters);
    };
    visit_shown_text(state, add);
    for (const InputEvent& event : events) add(event.text);
    add(clipboard_text);
    has_new_letters = letters.size() != before;
}

// Letters that the own fonts lack are looked for once, and the atlas is built again if fonts were found.
void Editor::Impl::rebuild_fonts() {
    state.fonts = load_fonts(options.fonts, state.theme, scale, letters);
    Letters wanted;
    for (const char32_t letter : without_glyph(letters, *state.fonts.regular)) {
        if (asked_letters.insert(letter).second) wanted.insert(letter);
    }
    if (wanted.empty() || !options.find_fonts) return;
    std::vector<FallbackFont> found = options.find_fonts(wanted);
    if (found.empty()) return;
    std::move(found.begin(), found.end(), std::back_inserter(options.fonts.fallbacks));
    state.fonts = load_fonts(options.fonts, state.theme, scale, letters);
}

// Rebuilds the fonts if the scale changes, so that text stays sharp, and for new letters.
void Editor::Impl::set_size(const FrameSize& size) {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(size.width_px), static_cast<float>(size.height_px)};
    const float wanted = size.scale * state.user_scale;
    const bool has_new_scale = wanted != scale, has_new_theme = shown_dark != state.is_dark;
    scale = wanted;
    if (has_new_theme) {
        shown_dark = state.is_dark;
        state.theme = state.is_dark ? dark_theme() : Theme{};
        sheet_colours = state.is_dark ? dark_sheet_colours() : SheetColours{};
        viewport.set_colours(state.is_dark ? dark_viewport_colours() : ViewportColours{});
    }
    if (has_new_scale || has_new_theme) apply_theme(state.theme, scale);
    if (has_new_scale || has_new_letters) rebuild_fonts();
}

void Editor::Impl::take_other_events(const std::vector<InputEvent>& events) {
    for (const InputEvent& event : events) {
        if (event.kind == InputEvent::Kind::CloseRequest) close(state);
        for (const std::string& file : event.files) take_dropped_file(state, file);
    }
}

// A key without Ctrl or Alt goes to an active text field.
void Editor::Impl::run_keys() {
    if (state.finder.is_open()) return;
    const bool is_typing = ImGui::GetIO().WantTextInput;
    for (const Action& action : state.actions) {
        for (const Chord& chord : action.chords) {
            const bool is_plain = !chord.modifiers.ctrl && !chord.modifiers.alt && chord.key < Key::F1;
            if (is_typing && (is_plain || chord.key == key_of('C') || chord.key == key_of('V') ||
                              chord.key == key_of('Z') || chord.key == key_of('Y') || chord.key == key_of('A'))) {
                continue;
            }
            const bool is_used = std::find(used_keys.begin(), used_keys.end(), chord.key) != used_keys.end();
            if (!is_used && is_pressed(chord)) run_action(state, action);
        }
    }
    if (is_typing || !is_pressed({Key::Escape, {}})) return;
    state.workspace.messages.dismiss();
    state.shows_start_page = false;
}

void Editor::Impl::show_sheet(const Rectangle& where) {
    begin_region(kSheetWindow, where, {0, 0});
    SheetContext sheet_context{
        .host = tool_host_context(state.workspace),
        .tools = state.tools,
        .output = output,
        .first_texture = kSheetTexture,
        .ui_scale = static_cast<double>(scale),
        .takes_keys = !state.finder.is_open() && !state.browser.is_open(),
        .takes_text =
            !(state.tools.key_map == KeyMap::MarvelousDesigner && state.layout.has_viewport && viewport.is_over()),
        .colours = sheet_colours,
        .shows = state.sheet_shows,
        .underlay_picture =
            [this](const std::string& file) {
                return UnderlayPicture{state.underlays.find(file), state.underlays.size_px(file)};
            },
        .take_texture = [this] { return next_texture++; },
        .fabric_version = state.workspace.fabrics.version(),
        .lit_parts = state.workspace.lit.parts,
        .lit_cloth = lit_cloth(state.workspace.lit, state.workspace.drape.frame()->mesh).on_panels};
    const SheetResult answer = sheet.show(sheet_context);
    used_keys.insert(used_keys.end(), answer.used_keys.begin(), answer.used_keys.end());
    if (answer.wants_menu) open_sheet_menu(state);
    show_sheet_menu(state);
    ImGui::End();
}

InspectorContext Editor::Impl::inspector_context() {
    return {.workspace = state.workspace,
            .output = output,
            .state = state.inspectors,
            .theme = state.theme,
            .fonts = &state.fonts,
            .widgets = &state.widgets,
            .take_texture = [this] { return next_texture++; },
            .shows_times = state.shows_times,
            .open_body = [this] { browse_for_body(state); },
            .open_motion = [this] { browse_for_motion(state); },
            .open_pose = [this] { browse_for_pose(state); },
            .save_pose = [this] { browse_to_save_pose(state); },
            .open_picture = [this] { browse_for_picture(state); },
            .open_fabric = [this] { browse_to_open_fabric(state); },
            .open_fabric_picture = [this](const std::string& name) { browse_for_fabric_picture(state, name); },
            .save_fabric = [this](const std::string& name) { save_fabric(state, name); },
            .save_fabric_as = [this](const std::string& name) { browse_to_save_fabric(state, name); },
            .fit_photo =
                [this] {
                    if (const Action* action = find_action(state.actions, "edit.fit_photo")) run_action(state, *action);
                },
            .frame_selection = [this] { sheet.frame_selected(); },
            .show_timeline = [this] { state.layout.has_timeline = true; },
            .key_of =
                [this](std::string_view id) {
                    const Action* action = find_action(state.actions, id);
                    return action == nullptr ? std::string() : chord_text(*action);
                }};
}

void Editor::Impl::show_viewport(const Rectangle& where, double seconds) {
    const float unit = ImGui::GetFontSize();
    const float bar = viewport_bar_height(std::floor(where.size.x) - unit) + 0.6F * unit;
    begin_region("##viewport_bar", {where.low, {where.size.x, bar}}, {0.5F * unit, 0.3F * unit});
    show_viewport_bar(state);
    ImGui::End();
    const float timeline = state.layout.has_timeline ? timeline_height() : 0;
    const float height = std::max(1.0F, where.size.y - bar - timeline);
    begin_region("##viewport", {{where.low.x, where.low.y + bar}, {where.size.x, height}}, {0, 0});
    viewport.show({.workspace = state.workspace,
                   .output = output,
                   .texture = kViewportTexture,
                   .legend = kLegendTexture,
                   .seconds = static_cast<float>(seconds),
                   .scale = scale,
                   .choice = state.tools.info().picks_parts ? ClothChoice::Parts : ClothChoice::Panels,
                   .key_map = state.tools.key_map,
                   .may_refine = seconds > 0,
                   .widgets = &state.widgets,
                   .show_findings = [this] {
                       state.layout.has_inspectors = true;
                       state.layout.wanted_tab = InspectorTab::Drape;
                   }});
    ImGui::End();
    if (state.layout.has_timeline) {
        const Rectangle below{{where.low.x, where.low.y + bar + height}, {where.size.x, timeline}};
        begin_region("##timeline", below, {0.5F * unit, 0.3F * unit});
        show_timeline(state);
        ImGui::End();
    }
    state.viewport = {.scene = viewport.scene(), .camera = viewport.camera(), .light = viewport.light()};
}

void Editor::Impl::show_inspectors(const Rectangle& where) {
    constexpr std::array<std::pair<const char*, InspectorTab>, 7> tabs{{{"Edit", InspectorTab::Properties},
                                                                        {"Seams", InspectorTab::Seams},
                                                                        {"Cloth", InspectorTab::Cloth},
                                                                        {"Body", InspectorTab::Body},
                                                                        {"Drape", InspectorTab::Drape},
                                                                        {"History", InspectorTab::History},
                                                                        {"Objects", InspectorTab::Objects}}};
    constexpr std::array<void (*)(InspectorContext&), 7> draws{draw_properties, draw_seams,   draw_materials, draw_body,
                                                               draw_drape,      draw_history, draw_objects};
    const float unit = ImGui::GetFontSize();
    begin_region("##inspectors", where, {0.6F * unit, 0.4F * unit});
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.18F * unit, 0.3F * unit});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing, {0.1F * unit, 0.2F * unit});
    const bool has_tabs = ImGui::BeginTabBar("##tabs", ImGuiTabBarFlags_FittingPolicyScroll);
    if (has_tabs) {
        const std::optional<InspectorTab> wanted = std::exchange(state.layout.wanted_tab, std::nullopt);
        for (const auto& [title, tab] : tabs) {
            const auto flags = wanted == tab ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None;
            const bool is_open = ImGui::BeginTabItem(title, nullptr, flags);
            note_widget(state.widgets, std::string("tab.") + title);
            if (!is_open) continue;
            state.layout.tab = tab;
            ImGui::EndTabItem();
        }
        ImGui::EndTabBar();
    }
    ImGui::PopStyleVar(2);
    if (std::exchange(state.layout.focuses_inspector, false)) ImGui::SetNextWindowFocus();
    ImGui::BeginChild("##box");
    InspectorContext box = inspector_context();
    draws[static_cast<std::size_t>(state.layout.tab)](box);
    ImGui::EndChild();
    ImGui::End();
    // ImGui would leave the focus with the box, and its keyboard navigation would use the keys.
    if (std::exchange(state.inspectors.boxes.gives_keys_back, false)) ImGui::SetWindowFocus(kSheetWindow);
}

// Call before the views: of windows with a fixed order, ImGui draws the later ones below.
void Editor::Impl::show_splitters(const Regions& regions) {
    if (state.layout.has_sheet && state.layout.has_viewport) {
        const float views = regions.sheet.size.x + regions.viewport.size.x;
        const float by = splitter(state, "splitter.views", regions.viewport.low.x, regions.viewport, output);
        state.layout.sheet_share = std::clamp(state.layout.sheet_share + by / views, 0.15F, 0.85F);
    }
    if (state.layout.has_inspectors) {
        const float by = splitter(state, "splitter.inspectors", regions.inspectors.low.x, regions.inspectors, output);
        state.layout.inspector_width =
            std::clamp(state.layout.inspector_width - by / ImGui::GetFontSize(), 17.5F, 40.0F);
    }
}

void Editor::Impl::show_views(double seconds) {
    const float unit = ImGui::GetFontSize();
    const Regions regions = share_out(state.layout, show_question(state));
    if (state.layout.has_tools) {
        begin_region("##tools", regions.tools, {std::round(0.2F * unit), 0.3F * unit});
        show_tool_bar(state);
        ImGui::End();
    }
    show_splitters(regions);
    if (state.layout.has_sheet) show_sheet(regions.sheet);
    if (state.layout.has_viewport) show_viewport(regions.viewport, seconds);
    state.workspace.lit = {};  // by the rows of the inspectors, for the views of the next frame
    if (state.layout.has_inspectors) show_inspectors(regions.inspectors);
    begin_region("##status", regions.status, {0.6F * unit, 0.25F * unit});
    show_status_bar(state);
    ImGui::End();
}

Editor::Editor(Services services, EditorOptions options)
    : impl_(std::make_unique<Impl>(std::move(services), std::move(options))) {}
Editor::~Editor() = default;

// One frame of ImGui with as many of the waiting events as it can take. `seconds`: 0 for further frames of one picture.
void Editor::Impl::build_frame(double seconds) {
    output.cursor = MouseCursor::Arrow;
    output.is_animating = false;
    used_keys.clear();
    state.widgets.clear();
    ImGui::GetIO().DeltaTime = std::max(1e-4F, static_cast<float>(seconds));
    const std::vector<InputEvent> others = input.begin_frame(ImGui::GetIO());
    ImGui::NewFrame();
    take_other_events(others);
    if (shown_document != state.documents_opened || state.wants_whole_sheet) {
        shown_document = state.documents_opened;
        state.wants_whole_sheet = false;
        sheet.frame_all();
    }
    InspectorContext box = inspector_context();
    update_inspectors(box);
    show_menu_bar(state);
    show_views(seconds);
    show_start_page(state);
    show_help(state);
    state.browser.show(state);
    state.finder.show(state);
    run_keys();
    ImGui::Render();
}

FrameOutput Editor::frame(const std::vector<InputEvent>& events, const FrameSize& size, double seconds) {
    // A slow picture must not hold up what was typed meanwhile. The bound lets the user see where a long row of keys
    // leads: at 30 keys a second it is the input of half a second.
    constexpr int kFramesPerPicture = 32;
    Impl& impl = *impl_;
    AppState& state = impl.state;
    ImGui::SetCurrentContext(impl.context);
    impl.output = {};
    if (state.actions_map != state.tools.key_map) {
        state.actions_map = state.tools.key_map;
        state.actions = make_actions(state.actions_map);
    }
    impl.update_letters(events);
    impl.set_size(size);
    impl.input.add(events);
    state.workspace.drape.update(*state.workspace.document, state.workspace.messages);
    state.underlays.update(state.workspace.document->pattern().underlays, state.services.read_photo,
                           state.workspace.messages);
    report_journal_problem(state);
    impl.message_clock.update(state.workspace.messages, seconds);
    impl.build_frame(seconds);
    for (int i = 1; i < kFramesPerPicture && impl.input.has_more(); ++i) impl.build_frame(0);
    keep_last(impl.output.scenes);
    keep_last(impl.output.pictures);
    impl.output.window_title =
        document_name(state) + (state.workspace.document->has_unsaved_changes() ? "* - Selvedge" : " - Selvedge");
    impl.output.wants_to_close = state.wants_to_close;
    impl.output.is_animating = impl.output.is_animating || impl.input.has_more() ||
                               state.workspace.drape.frame()->is_running || state.workspace.drape.is_making_body() ||
                               state.workspace.drape.is_finding_motion();
    return std::move(impl.output);
}

void Editor::set_clipboard(Clipboard clipboard) {
    impl_->clipboard = std::move(clipboard);
    ImGui::SetCurrentContext(impl_->context);
    ImGuiIO& io = ImGui::GetIO();
    io.ClipboardUserData = impl_.get();
    io.GetClipboardTextFn = [](void* user) {
        Impl& impl = *static_cast<Impl*>(user);
        impl.clipboard_text = impl.clipboard.get();
        return impl.clipboard_text.c_str();
    };
    io.SetClipboardTextFn = [](void* user, const char* text) { static_cast<Impl*>(user)->clipboard.set(text); };
}

AppState& Editor::state() {
    return impl_->state;
}
const AppState& Editor::state() const {
    return impl_->state;
}

Vec2d Editor::sheet_to_px(const Vec2d& sheet) const {
    return to_px(impl_->sheet.camera(), sheet);
}

std::optional<Vec2d> Editor::world_to_px(const Vec3d& point) const {
    const auto px = impl_->viewport.world_to_px(point.cast<float>());
    return px ? std::optional<Vec2d>(px->cast<double>()) : std::nullopt;
}

bool Editor::has_more_input() const {
    return impl_->input.has_more();
}

}  // namespace selvedge::editor

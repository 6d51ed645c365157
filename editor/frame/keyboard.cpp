#include "editor/frame/keyboard.h"

#include <imgui.h>

#include <array>
#include <utility>

namespace selvedge::editor {
namespace {

// ImGui calls codes below 512, as all of ours are, the program's own.
ImGuiKey code_of(Key key) {
    return static_cast<ImGuiKey>(key);
}

#if IMGUI_VERSION_NUM < 18700
constexpr ImGuiKey kKeypadEnter = ImGuiKey_KeyPadEnter;
#else
constexpr ImGuiKey kKeypadEnter = ImGuiKey_KeypadEnter;
#endif

}  // namespace

void map_keys(ImGuiIO& io) {
    constexpr std::array<std::pair<ImGuiKey, Key>, 22> keys{
        {{ImGuiKey_Tab, Key::Tab},           {ImGuiKey_LeftArrow, Key::Left}, {ImGuiKey_RightArrow, Key::Right},
         {ImGuiKey_UpArrow, Key::Up},        {ImGuiKey_DownArrow, Key::Down}, {ImGuiKey_PageUp, Key::PageUp},
         {ImGuiKey_PageDown, Key::PageDown}, {ImGuiKey_Home, Key::Home},      {ImGuiKey_End, Key::End},
         {ImGuiKey_Insert, Key::Insert},     {ImGuiKey_Delete, Key::Delete},  {ImGuiKey_Backspace, Key::Backspace},
         {ImGuiKey_Space, Key::Space},       {ImGuiKey_Enter, Key::Enter},    {ImGuiKey_Escape, Key::Escape},
         {kKeypadEnter, Key::KeypadEnter},   {ImGuiKey_A, key_of('A')},       {ImGuiKey_C, key_of('C')},
         {ImGuiKey_V, key_of('V')},          {ImGuiKey_X, key_of('X')},       {ImGuiKey_Y, key_of('Y')},
         {ImGuiKey_Z, key_of('Z')}}};
    for (const auto& [theirs, ours] : keys) io.KeyMap[theirs] = static_cast<int>(ours);
#if IMGUI_VERSION_NUM >= 18700
    io.BackendUsingLegacyKeyArrays = 1;  // else it clears the modifiers until a first key was pressed
#endif
}

void set_key(ImGuiIO& io, Key key, bool is_down) {
    if (key != Key::None) io.KeysDown[static_cast<int>(key)] = is_down;
}

bool is_key_pressed(Key key) {
    return ImGui::IsKeyPressed(code_of(key), false);
}

bool is_key_repeated(Key key) {
    return ImGui::IsKeyPressed(code_of(key), true);
}

}  // namespace selvedge::editor

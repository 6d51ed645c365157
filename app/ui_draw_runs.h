#pragma once
// Cuts an ImGui draw command into runs of triangles that can be drawn in a cheaper way. A software renderer spends its
// time on pixels: large areas of one colour need neither texture nor, where they are opaque, blending.
#include <vector>

struct ImDrawCmd;
struct ImDrawList;

namespace selvedge {

enum class RunKind {
    Textured,  // as ImGui means it
    Blended,   // the texture is white there
    Opaque,    // and nothing shines through
};

struct UiRun {
    RunKind kind = RunKind::Textured;
    unsigned first_index = 0;  // in the command's indices
    unsigned count = 0;
};

// In their order, and all triangles. Only large triangles are told apart; px_per_unit: of ImGui's positions.
std::vector<UiRun> cut_into_runs(const ImDrawList& list, const ImDrawCmd& command, float px_per_unit);

struct PictureSize {
    int width_px = 0;
    int height_px = 0;
};

// Whether the command only lays a picture of that size on the screen, pixel on pixel and untinted: each can be taken as
// it is, with no mixing of neighbours.
bool lies_pixel_on_pixel(const ImDrawList& list, const ImDrawCmd& command, const PictureSize& size, float px_per_unit);

}  // namespace selvedge

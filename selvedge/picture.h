#pragma once
// Pictures: what the cloth looks like, how it is drawn, and PNG files.
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "selvedge/export.h"

namespace selvedge {

// What the cloth shows, in pictures and in textures of files. What is empty is the pattern's.
struct Looks {
    std::string tartan{};  // a shipped one (tartan_names()), or a threadcount such as "B/24 W4 B24 R/2"
    std::string design{};  // instead of a tartan: a colour "#RRGGBB", the file of a picture (PNG, JPEG), or "test"
    std::optional<double> sett_size{};                     // m, of a repeat of either
    std::optional<std::array<double, 2>> sett_position{};  // m, (weft, warp), where it begins
};

struct PictureOptions {
    int width_px = 1024;
    int height_px = 1024;
    std::string view = "front";   // front, back, left, right, three-quarter, ... as the command's --view
    std::string camera{};         // instead of the view: "azimuth,elevation[,zoom]" in degrees, or eye and target in m
    std::string frame = "all";    // what fills the picture: all, garment
    std::string show = "tartan";  // tartan, plain, edges, level, strain, clearance, panels, seams, ... as --show
    Looks looks{};
    std::string surface{};  // draws the cloth as a curved surface: flat, constant, linear, ... as --surface; empty: not
    int samples = 4;        // of edges, per pixel: 1, 2, 4 or, where the renderer can, 8
    int supersample = 1;    // draws so many times as large and averages, 1 to 4
    bool is_transparent = false;  // no backdrop
};

// sRGB with straight alpha.
struct Image {
    int width_px = 0;
    int height_px = 0;
    std::vector<std::array<std::uint8_t, 4>> pixels{};  // red, green, blue, alpha; row by row from the top left
};

// Writes a .png file, or gives its bytes. Equal images give equal bytes. Throws InputError for an image without pixels
// or with another number of them than width_px * height_px, and for a file that cannot be written.
SELVEDGE_API void write_png(const Image& image, const std::filesystem::path& file);
SELVEDGE_API std::string encode_png(const Image& image);

}  // namespace selvedge

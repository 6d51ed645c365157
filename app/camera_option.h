#pragma once
// --camera: where the picture is taken from, in numbers.
#include <array>
#include <optional>
#include <string>

#include "render/scene/camera.h"

namespace selvedge {

// Either a direction, in which the scene is framed and then magnified, or the eye and what it looks at.
struct CameraChoice {
    Direction direction;
    float zoom = 1;
    std::optional<std::array<Vec3f, 2>> eye_and_target;  // m
};

// "azimuth,elevation[,zoom]" in degrees, or "x,y,z,x,y,z" in metres. Throws InputError.
CameraChoice parse_camera(const std::string& text);

// All of `text` as finite numbers between commas, or none where it is anything else.
std::optional<std::vector<double>> parse_numbers(std::string_view text);

}  // namespace selvedge

#include "app/camera_option.h"

#include <charconv>
#include <cmath>

#include "sim/core/error.h"

namespace selvedge {
namespace {

constexpr double kDegree = 0.017453292519943295;

[[noreturn]] void fail(const std::string& problem) {
    throw InputError("", "--camera", problem);
}

CameraChoice by_direction(const std::vector<double>& numbers) {
    if (std::abs(numbers[0]) > 3600) fail("the azimuth must be within 3600 degrees");
    if (std::abs(numbers[1]) > 89) fail("the elevation must be from -89 to 89 degrees");
    CameraChoice choice;
    choice.direction = {.azimuth = static_cast<float>(numbers[0] * kDegree),
                        .elevation = static_cast<float>(numbers[1] * kDegree)};
    if (numbers.size() < 3) return choice;
    if (numbers[2] < 0.1 || numbers[2] > 100) fail("the zoom must be from 0.1 to 100");
    choice.zoom = static_cast<float>(numbers[2]);
    return choice;
}

CameraChoice by_points(const std::vector<double>& numbers) {
    const Vec3d eye(numbers[0], numbers[1], numbers[2]), target(numbers[3], numbers[4], numbers[5]);
    if (std::max(eye.cwiseAbs().maxCoeff(), target.cwiseAbs().maxCoeff()) > 1000) fail("must be within 1000 m");
    if ((eye - target).norm() < 0.01) fail("the eye must be at least 1 cm from what it looks at");
    CameraChoice choice;
    choice.eye_and_target = {eye.cast<float>(), target.cast<float>()};
    return choice;
}

}  // namespace

std::optional<std::vector<double>> parse_numbers(std::string_view text) {
    std::vector<double> numbers;
    const char *at = text.data(), *last = text.data() + text.size();
    while (true) {
        double value = 0;
        const auto [end, error] = std::from_chars(at, last, value);
        if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
        numbers.push_back(value);
        if (end == last) return numbers;
        if (*end != ',') return std::nullopt;
        at = end + 1;
    }
}

CameraChoice parse_camera(const std::string& text) {
    const auto numbers = parse_numbers(text);
    if (numbers && (numbers->size() == 2 || numbers->size() == 3)) return by_direction(*numbers);
    if (numbers && numbers->size() == 6) return by_points(*numbers);
    fail("'" + text + "' is neither AZIMUTH,ELEVATION[,ZOOM] in degrees nor EYE_X,Y,Z,TARGET_X,Y,Z in metres");
}

}  // namespace selvedge

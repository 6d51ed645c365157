#include "app/underlay_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>
#include <system_error>

#include "editor/geometry/panel_edit.h"
#include "render/image/photo.h"
#include "sim/core/error.h"
#include "sim/core/file.h"
#include "sim/core/file_path.h"
#include "sim/pattern/edge_shape.h"

namespace selvedge::app {
namespace {

std::string jpeg_of(const sim::DrawnPicture& picture) {
    constexpr int kQuality = 90;  // of 100: lines of one pixel stay sharp
    render::Image image(picture.width_px, picture.height_px);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = {picture.rgb[3 * i], picture.rgb[3 * i + 1], picture.rgb[3 * i + 2], 255};
    return encode_jpeg(image, kQuality);
}

std::string size_of_page(const sim::DrawnPicture& picture) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.1f x %.1f cm", 100 * picture.size.x(), 100 * picture.size.y());
    return text.data();
}

// Upper left of the first picture.
Vec2d free_corner(const sim::Pattern& pattern) {
    constexpr double kClear = 0.05;  // m, from the panels
    Eigen::AlignedBox2d taken;
    const std::vector<Vec2d> positions = editor::sheet_positions(pattern);
    for (std::size_t p = 0; p < positions.size(); ++p) {
        const Eigen::AlignedBox2d box = sim::outline_box(pattern.panels[p]);
        taken.extend(box.min() + positions[p]).extend(box.max() + positions[p]);
    }
    return taken.isEmpty() ? Vec2d(0, 0) : Vec2d(taken.max().x() + kClear, taken.max().y());
}

bool holds(const std::filesystem::path& path, const std::string& bytes) {
    try {
        return sim::read_file(path, bytes.size()) == bytes;
    } catch (const sim::InputError&) {  // it is larger, no file, or closed to us
        return false;
    }
}

// Throws InputError if a file is there that holds something else: the user did not name it, so it is not replaced.
void refuse_other_content(const std::vector<UnderlayFile>& files) {
    for (const UnderlayFile& file : files) {
        if (sim::file_exists(file.path) && !holds(file.path, file.bytes))
            throw sim::InputError(file.path.string(), "",
                                  "not replaced: a file of this name holds something else than page " +
                                      std::to_string(file.page) + "; move it, or give the garment another name");
    }
}

}  // namespace

std::vector<UnderlayFile> lay_pictures(sim::Pattern& pattern, const std::vector<sim::DrawnPicture>& pictures) {
    constexpr double kBetween = 0.02;  // m
    const auto in_row = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(pictures.size()))));
    const Vec2d start = free_corner(pattern);
    Vec2d corner = start;
    double depth = 0;  // m, of the row
    std::vector<UnderlayFile> files;
    for (const sim::DrawnPicture& picture : pictures) {
        if (!files.empty() && files.size() % in_row == 0) {
            corner = {start.x(), corner.y() - depth - kBetween};
            depth = 0;
        }
        const Vec2d size = picture.pixel_size * Vec2d(picture.width_px, picture.height_px);
        pattern.underlays.push_back(
            {.file = "", .position = corner + Vec2d(size.x(), -size.y()) / 2, .pixel_size = picture.pixel_size});
        files.push_back({.page = picture.number, .size = size_of_page(picture), .bytes = jpeg_of(picture)});
        corner.x() += size.x() + kBetween;
        depth = std::max(depth, size.y());
    }
    return files;
}

void name_beside(std::vector<UnderlayFile>& files, sim::Pattern& pattern, const std::filesystem::path& beside) {
    std::set<std::string> taken;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const std::string name = beside.stem().string() + "_page" + std::to_string(files[i].page);
        std::string free = name;  // two drawings of one garment may have the same page
        for (int number = 2; !taken.insert(free).second; ++number) free = name + "_" + std::to_string(number);
        files[i].path = sim::folder_of(beside) / (free + ".jpg");
        pattern.underlays[i].file = sim::canonical_path(files[i].path).string();
    }
}

WrittenUnderlays::WrittenUnderlays(const std::vector<UnderlayFile>& files) {
    refuse_other_content(files);
    try {
        for (const UnderlayFile& file : files) {
            if (sim::file_exists(file.path)) continue;
            added_.push_back(file.path);
            sim::write_file_atomically(file.path, file.bytes);
        }
    } catch (...) {
        remove_added();
        throw;
    }
}

WrittenUnderlays::~WrittenUnderlays() {
    remove_added();
}

void WrittenUnderlays::remove_added() {
    std::error_code error;
    for (const std::filesystem::path& path : added_) std::filesystem::remove(path, error);
}

}  // namespace selvedge::app

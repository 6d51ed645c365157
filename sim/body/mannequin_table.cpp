#include "sim/body/mannequin_table.h"

#include <cstddef>
#include <span>
#include <string>

#include "sim/core/assert.h"
#include "sim/core/embedded.h"
#include "sim/core/json.h"

namespace selvedge {

std::span<const EmbeddedFile> mannequin_files();

namespace {

constexpr double kUnit = 1e-4;  // the table counts tenths of millimetres

constexpr std::array<const char*, kCagePartCount> kPartNames{"torso", "crown",   "bridge", "leg",     "toecap",
                                                             "arm",   "handcap", "thumb",  "thumbcap"};

// Points of one part, section after section.
std::vector<Vec3d> read_part(const JsonView& sections) {
    std::vector<Vec3d> points;
    for (std::size_t s = 0; s < sections.size(); ++s) {
        const std::vector<double> figures = sections.at(s).numbers();
        for (std::size_t i = 0; i + 2 < figures.size(); i += 3) {
            points.emplace_back(kUnit * figures[i], kUnit * figures[i + 1], kUnit * figures[i + 2]);
        }
    }
    return points;
}

std::vector<Vec3d> read_points(const JsonView& parts, const Cage& cage) {
    std::array<std::vector<Vec3d>, kCagePartCount> points;
    for (std::size_t p = 0; p < points.size(); ++p) points[p] = read_part(parts.at(kPartNames[p]));
    std::array<std::size_t, kCagePartCount> taken{};
    std::vector<Vec3d> in_order;
    for (const CageVertex& vertex : cage.left) {
        const auto part = static_cast<std::size_t>(vertex.part);
        SELVEDGE_ASSERT(taken[part] < points[part].size());
        in_order.push_back(points[part][taken[part]++]);
    }
    for (std::size_t p = 0; p < points.size(); ++p) SELVEDGE_ASSERT(taken[p] == points[p].size());
    return in_order;
}

// The table lists the middle and the left side; a left joint is named there without its side.
Joints read_joints(const JsonView& view) {
    constexpr std::string_view kSide = "left_";
    Joints joints;
    for (std::size_t i = 0; i < kMiddleJoints + kSideJoints; ++i) {
        std::string_view name = joint_name(static_cast<Joint>(i));
        if (name.starts_with(kSide)) name.remove_prefix(kSide.size());
        const std::vector<double> x = view.at(name).numbers();
        SELVEDGE_ASSERT(x.size() == 3);
        joints.x[i] = kUnit * Vec3d(x[0], x[1], x[2]);
    }
    mirror_left_side(joints);
    return joints;
}

TrunkLevels read_levels(const JsonView& sex) {
    const JsonView levels = sex.at("landmarks_y");
    return {.bust = kUnit * levels.at("bust").number(),
            .underbust = kUnit * levels.at("underbust").number(),
            .waist = kUnit * levels.at("waist").number(),
            .high_hip = kUnit * levels.at("high_hip").number(),
            .hip = kUnit * levels.at("hip").number(),
            .crotch = kUnit * sex.at("crotch_y").number()};
}

}  // namespace

MannequinTable read_mannequin_table(Sex sex, const Cage& cage) {
    const EmbeddedFile& file = mannequin_files().front();
    const std::string name(file.name);
    const Json document = parse_json(file.text, name);
    const JsonView figures = JsonView(document, name).at(sex == Sex::Female ? "female" : "male");
    return {.left_points = read_points(figures.at("parts"), cage),
            .joints = read_joints(figures.at("joints")),
            .levels = read_levels(figures),
            .armpit = kUnit * figures.at("armpit_y").number()};
}

}  // namespace selvedge

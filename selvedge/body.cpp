#include "selvedge/body.h"

#include <utility>

#include "selvedge/content.h"
#include "sim/core/assert.h"
#include "sim/core/error.h"
#include "sim/exchange/mesh_file.h"
#include "sim/mannequin/mannequin.h"
#include "sim/repair/load_body.h"

namespace selvedge {
namespace {

Body body_of(sim::MadeBody made) {
    return Body(std::make_shared<const Body::Content>(std::move(made)));
}

static_assert(static_cast<int>(LengthUnit::Poser) == static_cast<int>(sim::LengthUnit::Poser) &&
              static_cast<int>(UpAxis::Z) == static_cast<int>(sim::UpAxis::Z));

template <class Inner, class Outer>
Inner value_of(Outer value, Outer last, const char* place) {
    if (static_cast<int>(value) < 0 || value > last) throw sim::InputError("", place, "is no value of its enumeration");
    return static_cast<Inner>(value);
}

}  // namespace

Body::Body(std::shared_ptr<const Content> content) : content_(std::move(content)) {
    SELVEDGE_ASSERT(content_ != nullptr);
}

Body::Body(const Body&) = default;

Body& Body::operator=(const Body&) = default;

Body::~Body() = default;

const std::string& Body::name() const {
    return content_->body().name;
}

std::vector<std::array<double, 3>> Body::positions() const {
    std::vector<std::array<double, 3>> positions;
    for (const Vec3d& x : content_->body().x) positions.push_back({x.x(), x.y(), x.z()});
    return positions;
}

std::vector<std::array<std::uint32_t, 3>> Body::triangles() const {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const auto& [a, b, c] : content_->body().triangles)
        triangles.push_back(
            {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
    return triangles;
}

std::map<std::string, double> Body::measures() const {
    std::map<std::string, double> measures;
    const std::optional<sim::MannequinReadings>& readings = content_->prepared->made().readings;
    if (!readings) return measures;
    for (const sim::MeasureReading& reading : readings->readings)
        measures.emplace(std::string(reading.name), reading.measured);
    return measures;
}

double Body::height() const {
    return height_range(content_->body()).high;
}

std::vector<std::string> Body::notes() const {
    return content_->prepared->made().notes;
}

Body make_mannequin(const MannequinOptions& options) {
    return for_caller([&] {
        sim::MannequinOptions asked{.sex = value_of<sim::Sex>(options.sex, Sex::Male, "sex"),
                                    .subdivisions = options.resolution,
                                    .stance = options.stance};
        for (const auto& [name, value] : options.measures) {
            std::optional<double>* measure = find_measure(asked.measures, name);
            if (measure == nullptr) throw sim::InputError("", name, "is no measure of a mannequin");
            *measure = value;
        }
        return body_of(sim::make_body(asked));
    });
}

Body make_body(const std::string& text) {
    return for_caller([&] {
        if (text.empty()) throw sim::InputError("", "body", "names no body");
        return body_of(sim::make_body(text, {.must_be_person = true}));
    });
}

Body load_body(const std::filesystem::path& file, const BodyFileOptions& options) {
    return for_caller([&] {
        if (!sim::is_body_file(file.string())) throw sim::InputError(file.string(), "", "names no file");
        return body_of(
            sim::make_body(file.string(), {.unit = value_of<sim::LengthUnit>(options.unit, LengthUnit::Poser, "unit"),
                                           .up = value_of<sim::UpAxis>(options.up, UpAxis::Z, "up"),
                                           .must_be_person = true}));
    });
}

void write_body(const Body& body, const std::filesystem::path& file) {
    for_caller([&] { sim::write_body(body.content().body(), file); });
}

}  // namespace selvedge

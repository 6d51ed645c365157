#include "tests/golden/drape_numbers.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>

#include "sim/core/file.h"
#include "sim/mannequin/mannequin.h"
#include "sim/pattern/pattern_file.h"
#include "tests/golden/golden.h"
#include "tests/support/checkout.h"

namespace selvedge::test {
namespace {

Vec3d centre_of_area(const sim::DrawMesh& mesh) {
    Vec3d sum = Vec3d::Zero();
    double area = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3d p = mesh.x[a].cast<double>(), q = mesh.x[b].cast<double>(), r = mesh.x[c].cast<double>();
        const double twice_area = (q - p).cross(r - p).norm();
        sum += twice_area * (p + q + r) / 3;
        area += twice_area;
    }
    return sum / area;
}

double lowest(const sim::DrawMesh& mesh) {
    float low = std::numeric_limits<float>::max();
    for (const Vec3f& x : mesh.x) low = std::min(low, x.y());
    return low;
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text.empty() ? "none" : text;
}

template <class T>
std::string both(const char* what, const T& reference, const T& now) {
    std::ostringstream text;
    text.precision(6);
    text << what << ": " << reference << " in the reference, now " << now;
    return text.str();
}

std::string point_text(const Vec3d& point) {
    std::ostringstream text;
    text << "(" << point.x() << ", " << point.y() << ", " << point.z() << ")";
    return text.str();
}

bool is_near(double reference, double now, double tolerance) {
    return std::abs(reference - now) <= tolerance;  // false for a NaN
}

}  // namespace

DrapeNumbers drape_numbers(const sim::DressedGarment& garment) {
    DrapeNumbers numbers{.base_triangles = garment.report.mesh.base_triangles,
                         .leaf_triangles = garment.report.mesh.leaf_triangles,
                         .settled = garment.report.settled,
                         .faults = {},
                         .warp_weft_p99 = garment.report.stretch.warp_weft_p99,
                         .hem_height = lowest(garment.mesh),
                         .centre = centre_of_area(garment.mesh)};
    for (const sim::DressFault& fault : garment.report.faults) numbers.faults.push_back(fault.kind);
    return numbers;
}

sim::Json to_json(const DrapeNumbers& numbers) {
    sim::Json json = sim::Json::object();
    json["base_triangles"] = numbers.base_triangles;
    json["leaf_triangles"] = numbers.leaf_triangles;
    json["settled"] = numbers.settled;
    json["faults"] = sim::Json::array();
    for (const std::string& kind : numbers.faults) json["faults"].push_back(kind);
    json["warp_weft_p99"] = numbers.warp_weft_p99;
    json["hem_height"] = numbers.hem_height;
    json["centre"] = sim::Json::array({numbers.centre.x(), numbers.centre.y(), numbers.centre.z()});
    return json;
}

DrapeNumbers parse_drape_numbers(const sim::JsonView& view) {
    DrapeNumbers numbers{.base_triangles = view.at("base_triangles").integer(),
                         .leaf_triangles = view.at("leaf_triangles").integer(),
                         .settled = view.at("settled").boolean(),
                         .faults = {},
                         .warp_weft_p99 = view.at("warp_weft_p99").number(),
                         .hem_height = view.at("hem_height").number()};
    const sim::JsonView faults = view.at("faults"), centre = view.at("centre");
    for (std::size_t i = 0; i < faults.size(); ++i) numbers.faults.push_back(faults.at(i).string());
    for (int i = 0; i < 3; ++i) numbers.centre[i] = centre.at(static_cast<std::size_t>(i)).number();
    return numbers;
}

std::vector<std::string> differences(const DrapeNumbers& reference, const DrapeNumbers& now,
                                     const DrapeTolerances& tolerances) {
    std::vector<std::string> found;
    const auto expect = [&found](bool is_kept, std::string difference) {
        if (!is_kept) found.push_back(std::move(difference));
    };
    expect(reference.base_triangles == now.base_triangles,
           both("base triangles", reference.base_triangles, now.base_triangles));
    expect(is_near(reference.leaf_triangles, now.leaf_triangles, tolerances.leaf_share * reference.leaf_triangles),
           both("leaf triangles", reference.leaf_triangles, now.leaf_triangles));
    expect(reference.settled == now.settled, both("settled", reference.settled, now.settled));
    expect(reference.faults == now.faults, both("faults", listed(reference.faults), listed(now.faults)));
    expect(is_near(reference.warp_weft_p99, now.warp_weft_p99, tolerances.strain),
           both("warp_weft_p99", reference.warp_weft_p99, now.warp_weft_p99));
    expect(is_near(reference.hem_height, now.hem_height, tolerances.length),
           both("height of the hem, m", reference.hem_height, now.hem_height));
    expect((reference.centre - now.centre).norm() <= tolerances.length,
           both("centre, m", point_text(reference.centre), point_text(now.centre)));
    return found;
}

testing::AssertionResult matches_numbers(const DrapeNumbers& numbers, const std::string& name) {
    const std::filesystem::path path = reference_path(name + ".json");
    if (is_to_be_renewed(name)) {
        sim::write_file_atomically(path, write_json(to_json(numbers)));
        return testing::AssertionSuccess() << "renewed: look at " << path;
    }
    if (!std::filesystem::exists(path)) {
        return testing::AssertionFailure() << "no reference " << path << "; now " << write_json(to_json(numbers));
    }
    const sim::Json json = sim::read_json(path);
    const auto found = differences(parse_drape_numbers(sim::JsonView(json, path.string())), numbers);
    if (found.empty()) return testing::AssertionSuccess();
    auto failure = testing::AssertionFailure() << name;
    for (const std::string& difference : found) failure << "\n  " << difference;
    return failure;
}

sim::Body coarse_mannequin() {
    return sim::make_mannequin(sim::parse_mannequin("mannequin:sex=female,resolution=1")).body;
}

sim::DressedGarment dress_shipped(const std::string& garment, const sim::DressOptions& options) {
    const auto path = std::filesystem::path(source_folder()) / "patterns" / (garment + ".json");
    return dress(sim::load_pattern(path).pattern, coarse_mannequin(), options);
}

}  // namespace selvedge::test

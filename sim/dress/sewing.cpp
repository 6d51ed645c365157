#include "sim/dress/sewing.h"

#include <algorithm>
#include <map>

#include "sim/body/body_collider.h"
#include "sim/cloth/step.h"
#include "sim/mesh/assemble.h"

namespace selvedge {
namespace {

constexpr float kSewingDamping = 12;  // 1/s: panels are carried, not thrown

float gap_of(const Cloth& cloth, const SeamLink& link) {
    return (cloth.x[static_cast<std::size_t>(link.a)] - cloth.x[static_cast<std::size_t>(link.b)]).norm();
}

float widest_gap(const Cloth& cloth, const std::vector<SeamLink>& links) {
    float widest = 0;
    for (const SeamLink& link : links) widest = std::max(widest, gap_of(cloth, link));
    return widest;
}

std::vector<SeamPull> pulls_of(const std::vector<SeamLink>& links) {
    std::vector<SeamPull> pulls;
    pulls.reserve(links.size());
    for (const SeamLink& link : links) {
        pulls.push_back({static_cast<std::uint32_t>(link.a), static_cast<std::uint32_t>(link.b)});
    }
    return pulls;
}

std::vector<OpenSeam> open_seams(const Cloth& cloth, const std::vector<SeamLink>& links, float closed_gap) {
    std::map<int, float> widest;
    for (const SeamLink& link : links) {
        const float gap = gap_of(cloth, link);
        if (!(gap <= closed_gap)) widest[link.seam] = std::max(widest[link.seam], gap);
    }
    std::vector<OpenSeam> open;
    for (const auto& [seam, gap] : widest) open.push_back({seam, gap});
    return open;
}

// The garment where the cloth now is, with only the closed links, merged.
GarmentMesh merge_closed(const GarmentMesh& unsewn, const Cloth& cloth, float closed_gap) {
    GarmentMesh moved = unsewn;
    for (std::size_t v = 0; v < moved.x.size(); ++v) moved.x[v] = cloth.x[v].head<3>().cast<double>();
    std::erase_if(moved.links, [&](const SeamLink& link) { return !(gap_of(cloth, link) <= closed_gap); });
    return merge_seams(moved).mesh;
}

}  // namespace

SewingResult sew_on_body(const GarmentMesh& unsewn, const std::vector<Fabric>& fabrics, const BodyCollider& body,
                         const SewingOptions& options, const Progress& progress) {
    GarmentMesh apart = unsewn;
    apart.links.clear();
    Cloth cloth = make_cloth(apart, fabrics, {.max_level = 0});
    refresh_contacts(cloth, options.contact);

    const std::vector<SeamPull> pulls = pulls_of(unsewn.links);
    StepOptions stepping{.gravity = Vec3f::Zero(), .extra_damping = kSewingDamping, .contact = options.contact};
    stepping.contact.friction_scale = 0;
    stepping.stretch_bias_rate = stepping.shear_bias_rate = 0;  // the seams pull harder than any load
    stepping.limit_rounds = 0;
    stepping.seams = pulls;
    const float start_gap = widest_gap(cloth, unsewn.links);
    const float step_time = step_seconds(cloth, stepping);
    const float limit = start_gap / options.closing_speed + options.patience;

    SewingResult result;
    float seconds = 0;
    while (seconds < limit) {
        seconds += step_time;
        stepping.seam_gap = std::max(0.0F, start_gap - options.closing_speed * seconds);
        stepping.seam_gap_rate = stepping.seam_gap > 0 ? options.closing_speed * cloth.substep : 0;
        step(cloth, body, stepping);
        report(progress, "sewing", std::min(1.0F, seconds / limit));
        result.bad_vertex = find_bad_vertex(cloth);
        if (result.bad_vertex) break;
        if (stepping.seam_gap <= 0 && widest_gap(cloth, unsewn.links) < options.closed_gap) break;
    }
    report(progress, "sewing", 1);
    result.simulated_seconds = seconds;
    result.open = open_seams(cloth, unsewn.links, options.closed_gap);
    result.sewn = merge_closed(unsewn, cloth, options.closed_gap);
    return result;
}

}  // namespace selvedge

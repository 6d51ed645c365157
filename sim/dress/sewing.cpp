#include "sim/dress/sewing.h"

#include <algorithm>
#include <map>

#include "sim/cloth/step.h"
#include "sim/collide/body_collider.h"
#include "sim/mesh/sew.h"

namespace selvedge::sim {
namespace {

constexpr float kSewingDamping = 12;  // 1/s: strong, so that panels do not swing

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

// The garment at the cloth's current position, merged at the closed links only.
GarmentMesh merge_closed(const GarmentMesh& unsewn, const Cloth& cloth, float closed_gap) {
    GarmentMesh moved = unsewn;
    for (std::size_t v = 0; v < moved.x.size(); ++v) moved.x[v] = cloth.x[v].head<3>().cast<double>();
    std::erase_if(moved.links, [&](const SeamLink& link) { return !(gap_of(cloth, link) <= closed_gap); });
    return merge_seams(moved).mesh;
}

Cloth apart(const GarmentMesh& unsewn, const std::vector<Fabric>& fabrics) {
    GarmentMesh panels = unsewn;
    panels.links.clear();
    return make_cloth(panels, fabrics, {.max_level = 0});
}

StepOptions stepping_for(const SewingOptions& options, const std::vector<SeamPull>& pulls) {
    StepOptions stepping{.gravity = Vec3f::Zero(), .extra_damping = kSewingDamping, .contact = options.contact};
    stepping.contact.friction_scale = 0;
    stepping.stretch_bias_rate = stepping.shear_bias_rate = 0;  // the seams pull harder than any load
    stepping.limit_iterations = 0;
    stepping.seams = pulls;
    return stepping;
}

}  // namespace

SewingRun::SewingRun(GarmentMesh unsewn, const std::vector<Fabric>& fabrics, const SewingOptions& options)
    : unsewn_(std::move(unsewn)),
      options_(options),
      cloth_(apart(unsewn_, fabrics)),
      pulls_(pulls_of(unsewn_.links)),
      start_gap_(widest_gap(cloth_, unsewn_.links)),
      limit_(start_gap_ / options.closing_speed + options.extra_pull_time) {
    refresh_contacts(cloth_, options.contact);
}

bool SewingRun::advance(const BodyCollider& body) {
    StepOptions stepping = stepping_for(options_, pulls_);
    seconds_ += step_seconds(cloth_, stepping);
    stepping.seam_gap = std::max(0.0F, start_gap_ - options_.closing_speed * seconds_);
    stepping.seam_gap_rate = stepping.seam_gap > 0 ? options_.closing_speed * cloth_.substep : 0;
    step(cloth_, body, stepping);
    bad_vertex_ = find_bad_vertex(cloth_);
    if (bad_vertex_) return false;
    if (stepping.seam_gap <= 0 && widest_gap(cloth_, unsewn_.links) < options_.closed_gap) return false;
    return seconds_ < limit_;
}

SewingResult SewingRun::result() const {
    return {.sewn = merge_closed(unsewn_, cloth_, options_.closed_gap),
            .open = open_seams(cloth_, unsewn_.links, options_.closed_gap),
            .simulated_seconds = seconds_,
            .bad_vertex = bad_vertex_};
}

SewingResult sew_on_body(const GarmentMesh& unsewn, const std::vector<Fabric>& fabrics, const BodyCollider& body,
                         const SewingOptions& options, const Progress& progress) {
    SewingRun run(unsewn, fabrics, options);
    bool goes_on = true;
    while (goes_on) {
        goes_on = run.advance(body);
        report(progress, "sewing", run.fraction());
    }
    report(progress, "sewing", 1);
    return run.result();
}

}  // namespace selvedge::sim

#include "sim/dress/sewing.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "sim/cloth/contact_surface.h"
#include "sim/cloth/solver_state.h"
#include "sim/cloth/step.h"
#include "sim/mesh/sew.h"

namespace selvedge::sim {
namespace {

constexpr float kSewingDamping = 12;  // 1/s: strong, so that panels do not swing, and what falls does not stretch

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

std::vector<OpenSeam> find_open_seams(const Cloth& cloth, const std::vector<SeamLink>& links, float sewn_gap) {
    std::map<int, float> widest;
    for (const SeamLink& link : links) {
        const float gap = gap_of(cloth, link);
        if (!(gap <= sewn_gap)) widest[link.seam] = std::max(widest[link.seam], gap);
    }
    std::vector<OpenSeam> open;
    open.reserve(widest.size());
    for (const auto& [seam, gap] : widest) open.push_back({seam, gap});
    return open;
}

StepOptions stepping_for(const SewingOptions& options, const std::vector<SeamPull>& pulls) {
    StepOptions stepping{.gravity = Vec3f::Zero(), .extra_damping = kSewingDamping, .contact = options.contact};
    stepping.contact.friction_scale = 0;
    stepping.stretch_bias_rate = stepping.shear_bias_rate = 0;  // the seams pull harder than any load
    stepping.limit_iterations = 0;
    stepping.self_contact = options.self_contact;
    stepping.seams = pulls;
    return stepping;
}

}  // namespace

SewingRun::SewingRun(GarmentMesh unsewn, const std::vector<Fabric>& fabrics, const SewingOptions& options)
    : mesh_(std::move(unsewn)),
      links_(std::exchange(mesh_.links, {})),
      options_(options),
      cloth_(make_cloth(mesh_, fabrics, {.max_level = 0})),
      pulls_(pulls_of(links_)),
      start_gap_(widest_gap(cloth_, links_)),
      limit_(start_gap_ / options.closing_speed + options.extra_pull_time) {
    options_.contact.floor = std::min(options.contact.floor, lowest_height(cloth_));
    refresh_contacts(cloth_, options_.contact);
    const std::vector<int> as_sewn = representatives_of_links(mesh_.x.size(), links_);
    cloth_.solver->self_contact->sewn.assign(as_sewn.begin(), as_sewn.end());
}

bool SewingRun::advance(const Collider& body) {
    StepOptions stepping = stepping_for(options_, pulls_);
    seconds_ += step_seconds(cloth_, stepping);
    stepping.seam_gap = std::max(0.0F, start_gap_ - options_.closing_speed * seconds_);
    stepping.seam_gap_rate = stepping.seam_gap > 0 ? options_.closing_speed * cloth_.substep : 0;
    stepping.self_contact = options_.self_contact;
    // Cloth grows thick while the seams close, so that what crosses is taken apart while it is small.
    if (stepping.self_contact && start_gap_ > 0) {
        stepping.self_contact->thickness_scale *= 1 - stepping.seam_gap / start_gap_;
    }
    step(cloth_, body, stepping);
    bad_vertex_ = find_bad_vertex(cloth_);
    if (bad_vertex_) return false;
    if (stepping.seam_gap <= 0 && is_closed()) return false;
    return seconds_ < limit_;
}

void SewingRun::forget_contacts() {
    selvedge::sim::forget_contacts(cloth_);
}

void SewingRun::keep_far_contacts(float by) {
    selvedge::sim::keep_far_contacts(cloth_, by);
}

bool SewingRun::is_closed() const {
    return widest_gap(cloth_, links_) < options_.closed_gap;
}

void SewingRun::fall(const Collider& body, float weight) {
    const StepOptions usual;
    StepOptions stepping = stepping_for(options_, pulls_);
    stepping.gravity = weight * options_.gravity;
    stepping.stretch_bias_rate = usual.stretch_bias_rate;
    stepping.shear_bias_rate = usual.shear_bias_rate;
    stepping.contact.friction_scale = options_.contact.friction_scale;
    stepping.limit_iterations = usual.limit_iterations;
    step_held(body, stepping);
}

void SewingRun::hold(const Collider& body) {
    step_held(body, stepping_for(options_, pulls_));
}

void SewingRun::step_held(const Collider& body, const StepOptions& stepping) {
    const std::vector<Vec4f> before = cloth_.x;
    const float seconds = step_seconds(cloth_, stepping);
    step(cloth_, body, stepping);
    seconds_ += seconds;
    rms_speed_ = selvedge::sim::rms_speed(cloth_, before, static_cast<double>(seconds));
    bad_vertex_ = find_bad_vertex(cloth_);
}

void SewingRun::meet_trunk_only(std::vector<bool> vertices) {
    if (!vertices.empty()) vertices.resize(cloth_.x.size() + 1, false);  // the cloth may have room for more vertices
    cloth_.solver->contacts.is_trunk_only = std::move(vertices);
    selvedge::sim::forget_contacts(cloth_);
}

GarmentMesh SewingRun::unsewn() const {
    GarmentMesh unsewn = mesh_;
    unsewn.links = links_;
    return unsewn;
}

SewingResult SewingRun::result() && {
    SewingResult result{.sewn = std::move(mesh_),
                        .open = find_open_seams(cloth_, links_, options_.sewn_gap),
                        .simulated_seconds = seconds_,
                        .bad_vertex = bad_vertex_};
    GarmentMesh& mesh = result.sewn;
    for (std::size_t v = 0; v < mesh.x.size(); ++v) mesh.x[v] = cloth_.x[v].head<3>().cast<double>();
    std::ranges::copy_if(links_, std::back_inserter(mesh.links),
                         [&](const SeamLink& link) { return gap_of(cloth_, link) <= options_.sewn_gap; });
    merge_seams(mesh);
    return result;
}

}  // namespace selvedge::sim

#include "sim/dress/sewing.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "sim/cloth/contact_surface.h"
#include "sim/cloth/solver_state.h"
#include "sim/dress/work_count.h"
#include "sim/mesh/sew.h"

namespace selvedge::sim {
namespace {

float gap_of(const Cloth& cloth, const auto& link) {
    return (cloth.x[static_cast<std::size_t>(link.a)] - cloth.x[static_cast<std::size_t>(link.b)]).norm();
}

float widest_gap(const Cloth& cloth, const auto& links) {
    float widest = 0;
    for (const auto& link : links) widest = std::max(widest, gap_of(cloth, link));
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

constexpr float kLongestTube = 0.5F;  // s of further pulling of the links that are closed first

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

}  // namespace

SewingRun::SewingRun(GarmentMesh unsewn, const std::vector<Fabric>& fabrics, const SewingOptions& options)
    : mesh_(std::move(unsewn)),
      links_(std::exchange(mesh_.links, {})),
      options_(options),
      simulation_(make_cloth(mesh_, fabrics, {.max_level = 0}), options.simulation),
      pulls_(pulls_of(links_)) {
    begin_to_close(widest_gap(cloth(), links_));
    SimulationOptions with_floor = options.simulation;
    with_floor.contact.floor = std::min(with_floor.contact.floor, lowest_height(cloth()));
    simulation_.set_options(with_floor);
    simulation_.set_constraints(options.constraints);
    refresh_contacts(simulation_.cloth(), simulation_.contact({}));
    const std::vector<int> as_sewn = representatives_of_links(mesh_.x.size(), links_);
    simulation_.cloth().solver->self_contact->sewn.assign(as_sewn.begin(), as_sewn.end());
}

void SewingRun::begin_to_close(float gap) {
    begun_ = seconds_;
    start_gap_ = gap;
    limit_ = begun_ + start_gap_ / options_.closing_speed + options_.extra_pull_time;
}

void SewingRun::close_first(const std::vector<bool>& links) {
    for (std::size_t i = 0; i < pulls_.size(); ++i) {
        if (!links[i]) continue;
        pulls_[i].is_held = true;
        first_.push_back(pulls_[i]);
        first_.back().is_held = false;
    }
    if (first_.empty()) return;
    begin_to_close(widest_gap(cloth(), first_));
    limit_ += kLongestTube - options_.extra_pull_time;
}

bool SewingRun::advance(const Collider& body) {
    const bool closes_first = !first_.empty();
    Schedule schedule = closing_seams(closes_first ? first_ : pulls_);
    seconds_ += simulation_.step_seconds(schedule);
    schedule.seam_gap = std::max(0.0F, start_gap_ - options_.closing_speed * (seconds_ - begun_));
    schedule.seam_gap_rate = schedule.seam_gap > 0 ? options_.closing_speed * cloth().substep : 0;
    // Cloth grows thick while the seams close, so that what crosses is taken apart while it is small.
    if (closes_first) {
        schedule.thickness = 0;
    } else if (start_gap_ > 0) {
        schedule.thickness = 1 - schedule.seam_gap / start_gap_;
    }
    step(body, schedule);
    if (bad_vertex_) return false;
    const float widest = closes_first ? widest_gap(cloth(), first_) : widest_gap(cloth(), links_);
    const bool is_over = (schedule.seam_gap <= 0 && widest < options_.closed_gap) || !(seconds_ < limit_);
    if (!closes_first) return !is_over;
    if (is_over) {
        first_.clear();
        begin_to_close(widest_gap(cloth(), links_));
    }
    return true;
}

void SewingRun::step(const Collider& body, const Schedule& schedule) {
    WorkCount counted(cloth());
    simulation_.step(body, schedule);
    work_ += counted.of_steps(cloth(), 1);
    bad_vertex_ = find_bad_vertex(cloth());
}

void SewingRun::forget_contacts() {
    selvedge::sim::forget_contacts(simulation_.cloth());
}

void SewingRun::keep_far_contacts(float by) {
    selvedge::sim::keep_far_contacts(simulation_.cloth(), by);
}

bool SewingRun::is_closed() const {
    return widest_gap(cloth(), links_) < options_.closed_gap;
}

void SewingRun::fall(const Collider& body, float weight) {
    step_held(body, falling_unsewn(pulls_, weight));
}

void SewingRun::hold(const Collider& body) {
    step_held(body, closing_seams(pulls_));
}

void SewingRun::step_held(const Collider& body, const Schedule& schedule) {
    const std::vector<Vec4f> before = cloth().x;
    const float seconds = simulation_.step_seconds(schedule);
    step(body, schedule);
    seconds_ += seconds;
    rms_speed_ = selvedge::sim::rms_speed(cloth(), before, static_cast<double>(seconds));
}

void SewingRun::meet_trunk_only(std::vector<bool> vertices) {
    Cloth& cloth = simulation_.cloth();
    if (!vertices.empty()) vertices.resize(cloth.x.size() + 1, false);  // the cloth may have room for more vertices
    cloth.solver->contacts.is_trunk_only = std::move(vertices);
    selvedge::sim::forget_contacts(cloth);
}

GarmentMesh SewingRun::unsewn() const {
    GarmentMesh unsewn = mesh_;
    unsewn.links = links_;
    return unsewn;
}

SewingResult SewingRun::result() && {
    SewingResult result{.sewn = std::move(mesh_),
                        .open = find_open_seams(cloth(), links_, options_.sewn_gap),
                        .simulated_seconds = seconds_,
                        .bad_vertex = bad_vertex_};
    GarmentMesh& mesh = result.sewn;
    for (std::size_t v = 0; v < mesh.x.size(); ++v) mesh.x[v] = cloth().x[v].head<3>().cast<double>();
    std::ranges::copy_if(links_, std::back_inserter(mesh.links),
                         [&](const SeamLink& link) { return gap_of(cloth(), link) <= options_.sewn_gap; });
    merge_seams(mesh);
    return result;
}

}  // namespace selvedge::sim

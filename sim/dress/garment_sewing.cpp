#include "sim/dress/garment_sewing.h"

#include <algorithm>
#include <iterator>

#include "sim/cloth/contact.h"
#include "sim/collide/body_collider.h"
#include "sim/core/assert.h"
#include "sim/dress/drape.h"
#include "sim/mesh/sew.h"
#include "sim/place/placement.h"

namespace selvedge::sim {
namespace {

// Some panels of a mesh, and its vertex for each vertex of theirs. Order is kept.
struct MeshPart {
    GarmentMesh mesh;
    std::vector<int> vertices;
};

MeshPart part_of(const GarmentMesh& whole, const std::vector<bool>& has_panel) {
    MeshPart part{.mesh = whole, .vertices = {}};
    GarmentMesh& mesh = part.mesh;
    std::erase_if(mesh.triangles,
                  [&](const GarmentTriangle& t) { return !has_panel[static_cast<std::size_t>(t.panel)]; });
    std::vector<int> in_part(whole.x.size(), -1);
    for (const GarmentTriangle& t : mesh.triangles) {
        for (const int v : t.vertices) in_part[static_cast<std::size_t>(v)] = 0;
    }
    mesh.x.clear();
    for (std::size_t v = 0; v < whole.x.size(); ++v) {
        if (in_part[v] < 0) continue;
        in_part[v] = static_cast<int>(mesh.x.size());
        mesh.x.push_back(whole.x[v]);
        part.vertices.push_back(static_cast<int>(v));
    }
    const auto rename = [&](int& vertex) { vertex = in_part[static_cast<std::size_t>(vertex)]; };
    for (GarmentTriangle& t : mesh.triangles) std::ranges::for_each(t.vertices, rename);
    for (SeamLink& link : mesh.links) {
        rename(link.a);
        rename(link.b);
    }
    std::erase_if(mesh.links, [](const SeamLink& link) { return link.a < 0 || link.b < 0; });
    std::ranges::for_each(mesh.pins, rename);
    std::erase(mesh.pins, -1);
    return part;
}

std::vector<bool> panels_of(const Garment& garment, std::size_t panels) {
    std::vector<bool> has(panels, false);
    for (const int p : garment.panels) has[static_cast<std::size_t>(p)] = true;
    return has;
}

}  // namespace

GarmentSewing::GarmentSewing(GarmentMesh unsewn, std::vector<Garment> garments, std::vector<Fabric> fabrics,
                             const BodyCollider& body, SewingOptions options, PlanLimbs plan_limbs,
                             std::optional<WornGarments> worn)
    : unsewn_(std::move(unsewn)),
      garments_(std::move(garments)),
      fabrics_(std::move(fabrics)),
      options_(std::move(options)),
      plan_limbs_(std::move(plan_limbs)),
      is_worn_(unsewn_.panel_names.size(), false),
      sewn_vertex_(unsewn_.x.size(), -1) {
    SELVEDGE_ASSERT(!garments_.empty());
    std::optional<SelfContactOptions>& self_contact = options_.simulation.self_contact;
    if (garments_.size() > 1 && !self_contact) self_contact.emplace();
    if (worn) take_worn(std::move(*worn));
    start_next(body);
}

void GarmentSewing::take_worn(WornGarments worn) {
    SELVEDGE_ASSERT(worn.count < garments_.size());
    for (; next_ < worn.count; ++next_) {
        for (const int p : garments_[next_].panels) is_worn_[static_cast<std::size_t>(p)] = true;
    }
    done_ = std::move(worn.result);
    map_sewn_vertices();
    for (std::size_t v = 0; v < sewn_vertex_.size(); ++v) {
        if (sewn_vertex_[v] >= 0) unsewn_.x[v] = done_.sewn.x[static_cast<std::size_t>(sewn_vertex_[v])];
    }
}

// Outside of what is worn. Returns the next garment's panels.
GarmentMesh GarmentSewing::place_next(const BodyCollider& body) {
    MeshPart next = part_of(unsewn_, panels_of(garments_[next_], is_worn_.size()));
    const GarmentMesh worn = part_of(unsewn_, is_worn_).mesh;
    ClearedPanels cleared = make_sewable(next.mesh, body, worn, options_.body.get());
    std::ranges::move(cleared.notes, std::back_inserter(notes_));
    std::ranges::move(cleared.stuck, std::back_inserter(stuck_));
    for (std::size_t v = 0; v < next.vertices.size(); ++v)
        unsewn_.x[static_cast<std::size_t>(next.vertices[v])] = next.mesh.x[v];
    return std::move(next.mesh);
}

// What is worn stays sewn where its seams closed. Seams between garments are closed with the outer one.
void GarmentSewing::start_next(const BodyCollider& body) {
    const GarmentMesh next = place_next(body);
    const std::vector<bool> was_worn = is_worn_;
    for (const int p : garments_[next_].panels) is_worn_[static_cast<std::size_t>(p)] = true;
    MeshPart all = part_of(unsewn_, is_worn_);
    if (next_ > 0) {
        const auto worn_as = [&](int v) {
            return sewn_vertex_[static_cast<std::size_t>(all.vertices[static_cast<std::size_t>(v)])];
        };
        std::vector<SeamLink> to_close;
        std::erase_if(all.mesh.links, [&](const SeamLink& link) {
            const int a = worn_as(link.a), b = worn_as(link.b);
            if (a < 0 || b < 0) to_close.push_back(link);
            return a < 0 || a != b;  // stays open
        });
        const std::vector<int> merged = merge_seams(all.mesh);
        for (SeamLink& link : to_close) {
            link.a = merged[static_cast<std::size_t>(link.a)];
            link.b = merged[static_cast<std::size_t>(link.b)];
        }
        all.mesh.links = std::move(to_close);
    }
    if (plan_limbs_) detour_ = plan_limbs_(next, all.mesh);
    ++next_;
    start_run(std::move(all.mesh));
}

void GarmentSewing::start_run(GarmentMesh unsewn) {
    if (detour_) {
        run_ = detour_->start(std::move(unsewn), fabrics_, options_);
    } else {
        run_.emplace(std::move(unsewn), fabrics_, options_);
    }
}

bool GarmentSewing::advance(const BodyCollider& body) {
    if (relaxing_) {
        relax(body);
        return true;
    }
    const bool is_endless = has_too_much_work();
    if (!is_endless && (detour_ ? detour_->advance(*run_) : run_->advance(body))) return true;
    if (sew_again(body)) return true;
    take_better(body, is_endless);
    detour_.reset();
    wear();
    if (is_last() || done_.bad_vertex) return false;
    relaxing_.emplace(make_cloth(done_.sewn, fabrics_, {.max_level = 0}), options_.simulation);
    relaxing_->set_constraints(options_.constraints);
    refresh_contacts(relaxing_->cloth(), relaxing_->contact({}));
    relaxed_ = 0;
    return true;
}

// Starts the run again, from where the panels were placed, if it closed seams through limbs.
bool GarmentSewing::sew_again(const BodyCollider& body) {
    if (detour_ || run_->has_bad_number() || options_.limbs == nullptr) return false;
    detour_ = plan_thin_limbs(*run_, body, *options_.limbs, options_.interrupt, options_.store);
    if (!detour_) return false;
    first_run_ = std::move(run_);
    start_run(first_run_->unsewn());
    return true;
}

// Where the cloth crumples, contact with itself takes ever more work: the run ends. One round thin limbs ends sooner,
// which has another to fall back on. Counted, not timed, so that it ends alike for any number of threads on one type of
// CPU.
bool GarmentSewing::has_too_much_work() const {
    constexpr double kPerTriangle = 2500, kPerTriangleAtFirst = 10'000;  // 300 to 1,000 are usual
    const double most = first_run_ ? kPerTriangle : kPerTriangleAtFirst;
    return run_->work() > most * static_cast<double>(run_->triangle_count());
}

// Thin limbs do not help where a seam cannot close anyway.
void GarmentSewing::take_better(const BodyCollider& body, bool is_endless) {
    if (!first_run_) return;
    const bool is_worse =
        is_endless || run_->has_bad_number() ||
        count_sewing_faults(*run_, body, *options_.limbs) > count_sewing_faults(*first_run_, body, *options_.limbs);
    if (is_worse) run_ = std::move(first_run_);
    first_run_.reset();
}

// Takes over what was sewn.
void GarmentSewing::wear() {
    SewingResult result = std::move(*run_).result();
    result.simulated_seconds += done_.simulated_seconds + relaxed_;
    result.open.insert(result.open.begin(), done_.open.begin(), done_.open.end());
    std::ranges::sort(result.open, {}, &OpenSeam::seam);
    done_ = std::move(result);
    map_sewn_vertices();
}

void GarmentSewing::map_sewn_vertices() {
    std::size_t sewn = 0;
    for (const GarmentTriangle& t : unsewn_.triangles) {
        if (!is_worn_[static_cast<std::size_t>(t.panel)]) continue;
        for (std::size_t k = 0; k < 3; ++k)
            sewn_vertex_[static_cast<std::size_t>(t.vertices[k])] = done_.sewn.triangles[sewn].vertices[k];
        ++sewn;
    }
    SELVEDGE_ASSERT(sewn == done_.sewn.triangles.size());
}

// Without gravity and friction, the tension of the seams relaxes. Then the next garment is placed.
void GarmentSewing::relax(const BodyCollider& body) {
    const Schedule schedule = relaxing();
    relaxing_->step(body, schedule);
    relaxed_ += static_cast<double>(relaxing_->step_seconds(schedule));
    if (relaxed_ < DrapeOptions{}.relax_time) return;
    for (std::size_t v = 0; v < sewn_vertex_.size(); ++v) {
        if (sewn_vertex_[v] < 0) continue;
        unsewn_.x[v] = relaxing_->cloth().x[static_cast<std::size_t>(sewn_vertex_[v])].head<3>().cast<double>();
    }
    start_next(body);
    relaxing_.reset();
}

double GarmentSewing::fraction() const {
    const double garments = static_cast<double>(garments_.size());
    const double now = relaxing_ ? 1 : run_->fraction();
    return (static_cast<double>(next_) - 1 + now) / garments;
}

std::span<const SeamLink> GarmentSewing::links() const {
    return relaxing_ ? std::span<const SeamLink>() : run_->links();
}

SewingResult GarmentSewing::result() && {
    return std::move(done_);
}

}  // namespace selvedge::sim

#include "sim/inspection/inspection.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "sim/adaptive/check.h"
#include "sim/cloth/contact_surface.h"
#include "sim/collide/body_collider.h"
#include "sim/collide/penetration.h"
#include "sim/core/math.h"
#include "sim/core/printable.h"
#include "sim/inspection/layer_order.h"
#include "sim/pattern/garments.h"
#include "sim/place/fit.h"
#include "sim/place/limbs.h"

namespace selvedge::sim {
namespace {

void add_fault(DressReport& report, std::string kind, std::string place, double value,
               std::optional<double> height = {}) {
    add_fault(report, DressFault{std::move(kind), std::move(place), value, "", height});
}

std::string describe_position(const Vec3f& x) {
    char text[96];
    std::snprintf(text, sizeof text, " at x %.3f y %.3f z %.3f m", static_cast<double>(x.x()),
                  static_cast<double>(x.y()), static_cast<double>(x.z()));
    return text;
}

std::string describe_seam(const Pattern& pattern, int seam) {
    const auto side = [&](const SeamSide& s) {
        return "'" + pattern.panels[static_cast<std::size_t>(s.panel)].name + "' edge " + std::to_string(s.edge);
    };
    const Seam& sewn = pattern.seams[static_cast<std::size_t>(seam)];
    return "seam " + std::to_string(seam) + ", " + side(sewn.first) + " to " + side(sewn.second);
}

void validate_mesh(const Cloth& cloth, DressReport& report) {
    report.mesh.leaf_triangles = static_cast<int>(cloth.mesh.leaf_triangles().size());
    report.mesh.leaf_vertices = static_cast<int>(cloth.mesh.leaf_vertices().size());
    report.mesh.by_level.assign(static_cast<std::size_t>(cloth.mesh.max_level()) + 1, 0);
    for (const LeafTriangle& t : cloth.mesh.leaf_triangles()) ++report.mesh.by_level[t.level];
    for (const std::string& broken : check(cloth.mesh)) add_fault(report, "broken_mesh", broken, 0);
}

// For example "the left ankle, 'pant_f_l' at x 0.113 y 0.071 z 0.029 m".
std::string describe_point(const BodyLimbs& limbs, const Pattern& pattern, std::uint16_t panel, const Vec3f& x) {
    const std::string part = place_on_body(limbs, x.cast<double>());
    const std::string beside = part.empty() ? "" : "the " + part + ", ";
    return beside + "'" + pattern.panels[panel].name + "'" + describe_position(x);
}

// For example "too small at the waist (y 1.02 m) by 36.5 cm".
std::string describe_too_small(const TightLevel& level, const std::string& part) {
    char where[96];
    std::snprintf(where, sizeof where, "(y %.2f m) by %.1f cm", level.y, shortfall(level) * 100);
    return "too small " + (part.empty() ? std::string() : "at the " + part + " ") + where;
}

FitOptions fit_options(const Cloth& cloth) {
    FitOptions fit;
    for (const Fabric& fabric : cloth.material.fabrics) fit.strain_limits.push_back(fabric.strain_limit);
    return fit;
}

float larger_of(const TriangleStrain& strain) {
    return std::max(strain.warp, strain.weft);
}

// Strain minus what the fabric and the tightness of the garment allow.
TriangleStrain beyond(const TriangleStrain& strain, double allowed) {
    const auto limit = static_cast<float>(allowed);
    return {.warp = strain.warp - limit, .weft = strain.weft - limit, .shear = strain.shear};
}

Vec3d middle_of(const Cloth& cloth, const LeafTriangle& t) {
    return ((cloth.x[t.v[0].value] + cloth.x[t.v[1].value] + cloth.x[t.v[2].value]) / 3.0F).head<3>().cast<double>();
}

StretchStatistics stretch_statistics(const std::vector<TriangleStrain>& strains) {
    std::vector<double> yarn_strains;
    std::vector<double> shears;
    StretchStatistics statistics;
    for (const TriangleStrain& strain : strains) {
        yarn_strains.push_back(strain.warp);
        yarn_strains.push_back(strain.weft);
        shears.push_back(strain.shear * 180 / std::numbers::pi);
        statistics.warp_weft_max = std::max(statistics.warp_weft_max, static_cast<double>(larger_of(strain)));
    }
    statistics.warp_weft_p50 = quantile(yarn_strains, 0.5);
    statistics.warp_weft_p99 = quantile(yarn_strains, 0.99);
    statistics.shear_deg_p99 = quantile(shears, 0.99);
    return statistics;
}

// For example "smaller than the body by up to 1.9 cm, from 1.14 to 1.26 m up: it stretches there". Pre: not empty.
std::string describe_tight(const std::vector<TightLevel>& tight) {
    double most = 0;
    for (const TightLevel& level : tight) most = std::max(most, shortfall(level));
    char where[64];
    const auto [lowest, highest] = std::ranges::minmax_element(tight, {}, &TightLevel::y);
    const double low = lowest->y, high = highest->y;
    if (low == high) {
        std::snprintf(where, sizeof where, "%.2f m up", low);
    } else {
        std::snprintf(where, sizeof where, "from %.2f to %.2f m up", low, high);
    }
    char text[160];
    std::snprintf(text, sizeof text, " up to %.1f cm, %s: it stretches there", most * 100, where);
    return std::string(kSmallerThanBody) + text;
}

// Cloth that passes through itself.
void validate_crossings(const Cloth& cloth, const Pattern& pattern, const FaultLimits& limits, DressReport& report) {
    const ContactSurface surface = contact_surface(cloth);
    const float* const points = cloth.x.front().data();
    const std::vector<TrianglePair> pairs = find_crossing_triangles(surface, points);
    if (pairs.empty()) return;
    ContactCounts& contact = report.contact;
    float highest = -std::numeric_limits<float>::infinity();
    for (const TrianglePair& pair : pairs)
        highest = std::max(highest, cloth.x[surface.triangles[pair.first].vertices[0]].y());
    contact.self_crossings = static_cast<int>(pairs.size());
    contact.self_crossing_m = contour_length(surface, points, pairs);
    contact.self_crossing_at =
        describe_place(cloth, pattern, VertexId{surface.triangles[pairs.front().first].vertices[0]});
    if (limits.may_cross_itself) return;
    add_fault(report, "self_crossing",
              count_text(pairs.size(), "pair") + " of triangles, one at " + contact.self_crossing_at,
              contact.self_crossing_m, static_cast<double>(highest));
}

// Panels of a higher layer that lie inside of those of a lower one.
void validate_layers(const Cloth& cloth, const Pattern& pattern, DressReport& report) {
    const LayerOrder order = measure_layer_order(cloth);
    report.contact.on_lower_layer = order.judged;
    report.contact.wrong_layer_order = order.wrong;
    if (order.wrong == 0) return;
    add_fault(report, "wrong_layer_order",
              (order.wrong == 1 ? "1 vertex lies" : std::to_string(order.wrong) + " vertices lie") +
                  " inside of a lower layer, one at " + describe_place(cloth, pattern, *order.wrong_vertex),
              order.wrong);
}

// Whether the cloth need not stretch there by more than its fabric does.
bool is_within_limit(const TightLevel& level) {
    return shortfall(level) == 0 || level.limit_girth >= level.body_girth;
}

// The limb that a point is nearest to, or the torso.
using BodyPart = std::optional<LimbKind>;

BodyPart part_at(const BodyLimbs& limbs, const Vec3d& x) {
    const auto position = nearest_on_limbs(limbs, x);
    return position ? position->limb : std::nullopt;
}

// What the garment is too small for.
struct SmallFor {
    std::optional<BodyLimbs> limbs;  // of the body; none if it is too small for nothing
    std::set<BodyPart> parts;
    std::vector<TightLevel> levels;  // the loops that are too small
    bool is_as_a_whole = false;      // so much that what is too small pulls at all the rest

    bool holds(const Vec3d& x) const {
        return limbs && (is_as_a_whole || parts.contains(part_at(*limbs, x)) || explained_strain(levels, x) > 0);
    }
};

// What stretches no more than its fabric does is noted; beyond, the garment does not fit. One fault for each limb and
// for the torso, where they are tightest. sewn: the too_small of validate().
SmallFor validate_fit(const std::vector<TightLevel>& tight, const std::optional<TightLevel>& sewn, const Body& body,
                      const Pattern& pattern, const FaultLimits& limits, DressReport& report) {
    SmallFor small;
    std::vector<TightLevel> noted;
    std::map<BodyPart, const TightLevel*> too_small;
    std::optional<BodyLimbs> limbs;
    const auto worst_there = [&](const TightLevel& level) -> const TightLevel*& {
        if (!limbs) limbs = find_limbs(body);
        return too_small[part_at(*limbs, (level.low + level.high) / 2)];
    };
    for (const TightLevel& level : tight) {
        if (shortfall(level) == 0) continue;
        if (is_within_limit(level)) {
            noted.push_back(level);
            continue;
        }
        small.levels.push_back(level);
        const TightLevel*& worst = worst_there(level);
        if (worst == nullptr || shortfall(level) > shortfall(*worst)) worst = &level;
    }
    if (!noted.empty()) report.notes.push_back(describe_tight(noted));
    if (sewn && too_small.empty()) worst_there(*sewn) = &*sewn;
    for (const auto& [part, level] : too_small) {
        const std::string place = place_on_body(*limbs, (level->low + level->high) / 2);
        add_fault(report, "does_not_fit", describe_too_small(*level, place), shortfall(*level));
        small.parts.insert(part);
        small.is_as_a_whole |= garments_of(pattern).size() == 1 && excess_stretch(*level) > limits.stretch_max;
    }
    small.limbs = std::move(limbs);
    return small;
}

// What could not close round the body cuts into it: a note where the garment is too small, beside the fault of fit.
void add_depth(DressFault fault, const Vec3f& at, const SmallFor& small, DressReport& report) {
    fault.height = static_cast<double>(at.y());
    if (small.holds(at.cast<double>())) {
        report.notes.push_back(cause_of(fault) + ", where it is too small");
    } else {
        add_fault(report, std::move(fault));
    }
}

// One fault for each part of the body through which edges pass, at its deepest edge: of fit, where what is round a limb
// is too small for it.
void add_passages(const std::vector<PassingEdge>& passing, const Cloth& cloth, const DrawMesh& mesh, const Body& body,
                  const BodyLimbs& limbs, const Pattern& pattern, const SmallFor& small, DressReport& report) {
    std::map<std::string, const PassingEdge*> deepest;
    for (const PassingEdge& edge : passing) {
        const PassingEdge*& known = deepest[place_on_body(limbs, edge.at.cast<double>())];
        if (known == nullptr || edge.depth > known->depth) known = &edge;
    }
    for (const auto& [part, edge] : deepest) {
        if (const auto tight = too_small_for_limb(mesh, body, limbs, edge->at.cast<double>(), fit_options(cloth))) {
            add_fault(report, "does_not_fit", describe_too_small(*tight, part), shortfall(*tight));
            continue;
        }
        const std::string point = describe_point(limbs, pattern, mesh.panel[edge->triangle], edge->at);
        add_depth({"through_body", "cloth passes through " + point, static_cast<double>(edge->depth)}, edge->at, small,
                  report);
    }
}

void validate_contact(const Cloth& cloth, const BodyCollider& body, const Pattern& pattern, const FaultLimits& limits,
                      const SmallFor& small, DressReport& report) {
    const DrawMesh mesh = draw_mesh(cloth, {});
    const Penetration found =
        find_penetration(mesh.x, mesh.triangles, body.surface(), {.depth = static_cast<float>(limits.depth)});
    ContactCounts& contact = report.contact;
    contact.inside = found.vertices;
    contact.deepest_m = static_cast<double>(found.deepest_vertex);
    contact.faces_in_body = found.faces;
    contact.edges_in_body = found.edges;
    if (found.faces == 0) return;
    const BodyLimbs limbs = find_limbs(body.body());
    contact.deepest_face_m = static_cast<double>(found.deepest);
    contact.deepest_face_at = describe_point(limbs, pattern, mesh.panel[found.triangle], found.at);
    add_passages(found.passing, cloth, mesh, body.body(), limbs, pattern, small, report);
    if (contact.deepest_m > limits.depth) {
        const VertexId deepest = cloth.mesh.leaf_vertices()[found.vertex];
        add_depth({"inside_body", describe_place(cloth, pattern, deepest), contact.deepest_m},
                  cloth.x[deepest.value].head<3>(), small, report);
    } else if (contact.deepest_face_m > limits.face_depth && found.passing.empty()) {
        add_depth({"inside_body", "a face at " + contact.deepest_face_at, contact.deepest_face_m}, found.at, small,
                  report);
    }
}

// Pre: the report has the faults of fit.
bool is_given_up_as_too_small(const DrapeResult& draped, const DressReport& report) {
    const auto does_not_fit = [](const DressFault& fault) { return class_of(fault) == FaultClass::DoesNotFit; };
    return draped.given_up == GiveUp::TooSmall && std::ranges::any_of(report.faults, does_not_fit);
}

// Whether it hung with its whole weight for as long as it would have to be at rest.
bool had_time_to_rest(const DrapeResult& draped) {
    const DrapeOptions usual;
    return draped.simulated_seconds >= usual.relax_time + usual.lowering_time + usual.rest_time;
}

void validate_rest(const Cloth& cloth, const Pattern& pattern, const DrapeResult& draped, DressReport& report) {
    if (draped.given_up == GiveUp::SlipsDown) {
        report.notes.emplace_back("its fall was ended early, because it slips down the body");
    } else if (is_given_up_as_too_small(draped, report)) {
        const long stretch = std::lround(100 * report.stretch.warp_weft_max);
        report.notes.push_back(
            "its fall was ended early, because it is too small for the body; it is stretched by up to " +
            std::to_string(stretch) + " %");
    } else if (!draped.settled) {
        const bool is_known = draped.fastest && !draped.bad_vertex;
        DressFault fault{"not_settled",
                         is_known ? describe_place(cloth, pattern, *draped.fastest) : std::string(kWholeGarment),
                         draped.fall_speed};
        if (is_known) fault.height = static_cast<double>(cloth.x[draped.fastest->value].y());
        // What was given up, had no time to fall, or has no finite positions tells nothing by being slow.
        if (draped.given_up || draped.bad_vertex || !had_time_to_rest(draped)) {
            report.faults.push_back(std::move(fault));
        } else {
            add_fault(report, std::move(fault));
        }
        if (draped.given_up == GiveUp::TooMuchWork)
            report.notes.emplace_back("its fall was ended early, because it took more work than a drape may");
    }
}

// What of the strains (per leaf triangle) is beyond the fabrics' limits and what tightness explains.
std::vector<TriangleStrain> unexplained_of(const std::vector<TriangleStrain>& strains, const Cloth& cloth,
                                           const std::vector<TightLevel>& tight) {
    std::vector<TriangleStrain> unexplained;
    for (std::size_t i = 0; i < strains.size(); ++i) {
        const LeafTriangle& leaf = cloth.mesh.leaf_triangles()[i];
        const double explained = explained_strain(tight, middle_of(cloth, leaf));
        unexplained.push_back(beyond(strains[i], cloth.material.fabrics[leaf.panel].strain_limit + explained));
    }
    return unexplained;
}

bool is_fault(const StretchStatistics& unexplained, const FaultLimits& limits) {
    return unexplained.warp_weft_p99 > limits.stretch_p99 || unexplained.warp_weft_max > limits.stretch_max;
}

// Stretch that is not explained is a fault, unless the garment was given up: then it is stretched because it is too
// small, or because it slips. Where it is too small for a part of the body, no drape can hold the strain limit there
// or near it, and nowhere if what is too small must stretch by more than a fault of stretch: this is a note beside the
// fault of fit.
SmallFor validate_stretch(const Cloth& cloth, const Body& body, const Pattern& pattern, const DrapeResult& draped,
                          const FaultLimits& limits, const std::optional<TightLevel>& too_small, DressReport& report) {
    const std::vector<TriangleStrain> strains = measure_strain(cloth);
    if (strains.empty()) return {};
    report.stretch = stretch_statistics(strains);
    const DrawMesh garment = draw_mesh(cloth, {});
    std::vector<TightLevel> tight = tight_levels(garment, body, fit_options(cloth));
    if (is_fault(stretch_statistics(unexplained_of(strains, cloth, tight)), limits))
        std::ranges::copy(tight_round_level_limbs(garment, body, find_limbs(body), fit_options(cloth)),
                          std::back_inserter(tight));
    SmallFor small = validate_fit(tight, too_small, body, pattern, limits, report);
    if (draped.given_up == GiveUp::SlipsDown || is_given_up_as_too_small(draped, report)) return small;
    std::vector<TriangleStrain> unexplained = unexplained_of(strains, cloth, tight);
    if (!small.parts.empty() && is_fault(stretch_statistics(unexplained), limits)) {
        float most = 0;
        for (std::size_t i = 0; i < unexplained.size(); ++i) {
            if (larger_of(unexplained[i]) <= 0 || !small.holds(middle_of(cloth, cloth.mesh.leaf_triangles()[i])))
                continue;
            unexplained[i] = {};
            most = std::max(most, larger_of(strains[i]));
        }
        if (most > 0)
            report.notes.push_back("stretched by up to " + std::to_string(std::lround(100 * most)) +
                                   " % where it is too small");
    }
    const auto worst =
        static_cast<std::size_t>(std::ranges::max_element(unexplained, {}, larger_of) - unexplained.begin());
    const StretchStatistics statistics = stretch_statistics(unexplained);
    const VertexId worst_vertex = cloth.mesh.leaf_triangles()[worst].v[0];
    const std::string place = describe_place(cloth, pattern, worst_vertex);
    const auto height = static_cast<double>(cloth.x[worst_vertex.value].y());
    if (statistics.warp_weft_p99 > limits.stretch_p99)
        add_fault(report, "overstretched", "99th percentile, worst at " + place, report.stretch.warp_weft_p99, height);
    if (statistics.warp_weft_max > limits.stretch_max)
        add_fault(report, "overstretched", place, static_cast<double>(larger_of(strains[worst])), height);
    return small;
}

}  // namespace

void validate(const Cloth& cloth, const BodyCollider& body, const Pattern& pattern,
              std::span<const OpenSeam> open_seams, const DrapeResult& draped, DressReport& report,
              const FaultLimits& limits, const std::optional<TightLevel>& too_small) {
    report.seams.open = static_cast<int>(open_seams.size());
    for (const OpenSeam& open : open_seams) add_fault(report, "open_seam", describe_seam(pattern, open.seam), open.gap);
    if (draped.bad_vertex) {
        add_fault(report, "not_finite", describe_place(cloth, pattern, *draped.bad_vertex), 0);
    } else {
        const SmallFor small = validate_stretch(cloth, body.body(), pattern, draped, limits, too_small, report);
        validate_contact(cloth, body, pattern, limits, small, report);
        validate_crossings(cloth, pattern, limits, report);
        validate_layers(cloth, pattern, report);
    }
    validate_rest(cloth, pattern, draped, report);
    validate_mesh(cloth, report);
}

namespace {

// Makes `cause` a fault, and notes, which begin with `what`, of the faults that follow from it.
template <class Follows>
void put_down_to(DressFault cause, const std::string& what, const Follows& follows, DressReport& report) {
    const std::vector<DressFault> faults = std::exchange(report.faults, {});
    add_fault(report, std::move(cause));
    for (const DressFault& fault : faults) {
        if (follows(fault)) {
            report.notes.push_back(what + ": " + cause_of(fault));
        } else {
            report.faults.push_back(fault);
        }
    }
}

}  // namespace

void blame_size(const TightLevel& as_placed, const BodyLimbs& limbs, DressReport& report) {
    const auto is_of_drape = [](const DressFault& fault) {
        return class_of(fault) == FaultClass::Defect && fault.kind != "not_finite" && fault.kind != "broken_mesh";
    };
    if (std::ranges::none_of(report.faults, is_of_drape)) return;
    const std::string place = place_on_body(limbs, (as_placed.low + as_placed.high) / 2);
    const auto follows = [&](const DressFault& fault) {
        return is_of_drape(fault) || class_of(fault) == FaultClass::DoesNotFit;
    };
    put_down_to({"does_not_fit", describe_too_small(as_placed, place), shortfall(as_placed)},
                "it cannot close round the body", follows, report);
}

void blame_length(double below_floor, double knees, DressReport& report) {
    const auto is_of_heap = [&](const DressFault& fault) {
        return class_of(fault) == FaultClass::Defect && fault.height && *fault.height < knees;
    };
    if (below_floor < kMuchTooLong || std::ranges::none_of(report.faults, is_of_heap)) return;
    const std::string by = in_centimetres(below_floor);
    put_down_to(
        {"does_not_fit", "too long for this body by " + by + ": its hem was placed below the floor", below_floor},
        "it lies in a heap on the floor", is_of_heap, report);
}

bool is_too_small(const Cloth& cloth, const Body& body) {
    return !std::ranges::all_of(tight_levels(draw_mesh(cloth, {}), body, fit_options(cloth)), is_within_limit);
}

bool is_overstretched(const Cloth& cloth, const FaultLimits& limits) {
    const std::vector<TriangleStrain> over = unexplained_of(measure_strain(cloth), cloth, {});
    return !over.empty() && stretch_statistics(over).warp_weft_p99 > limits.stretch_p99;
}

std::optional<TightLevel> fits_nowhere(const Cloth& cloth, const Body& body, const FaultLimits& limits) {
    std::optional<TightLevel> worst;
    double most = limits.stretch_p99;
    const LevelSections sections(body);
    for (const TightLevel& level : tight_levels(draw_mesh(cloth, {}), body, fit_options(cloth))) {
        if (excess_stretch(level) <= most) continue;
        const TightLevel slid = slid_to_narrowest(level, sections);
        if (excess_stretch(slid) <= most) continue;
        worst = slid;
        most = excess_stretch(slid);
    }
    return worst;
}

std::string describe_place(const Cloth& cloth, const Pattern& pattern, VertexId vertex) {
    std::string panels;
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
        const auto touches = [&](TriangleId t) { return cloth.mesh.triangle(t).panel == p; };
        bool found = false;
        for (const TriangleId t : cloth.mesh.triangles_at(vertex)) found = found || touches(t);
        if (found) panels += (panels.empty() ? "'" : " beside '") + pattern.panels[p].name + "'";
    }
    return panels + describe_position(cloth.x[vertex.value].head<3>());
}

}  // namespace selvedge::sim

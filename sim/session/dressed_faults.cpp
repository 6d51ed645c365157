#include "sim/session/dressed_faults.h"

#include <string>
#include <vector>

namespace selvedge::sim {

void report_faults(const Cloth& cloth, Dressing& dressing, const BodyCollider& collider, const DrapeResult& result,
                   const std::optional<TightLevel>& too_small, DressReport& report) {
    validate(cloth, collider, dressing.anchored(), dressing.open_seams(), result, report,
             {.may_cross_itself = !dressing.options().self_collision}, too_small);
    for (const std::string& stuck : dressing.stuck_panels()) {
        std::erase(report.notes, stuck);
        report.faults.push_back({.kind = "stuck_in_body", .place = stuck, .value = 1});
    }
}

}  // namespace selvedge::sim

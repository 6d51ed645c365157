#pragma once
// All points of a ClothPoints asked at every step, in the ways that cloth could ask.
#include <vector>

#include "bench/cloth_points.h"
#include "sim/body/collider.h"

namespace selvedge {

enum class ContactWay {
    OneByOne,   // contact() for each
    InBlocks,   // contacts(), sixteen at once
    WithSlack,  // the same for those only that may have come too near since they were asked last
};

// The points in the order that passes read them.
class PassPoints {
 public:
    explicit PassPoints(const ClothPoints& points);

    std::size_t count() const { return count_; }  // of one step
    const std::vector<std::vector<ContactBlock>>& steps() const { return steps_; }

 private:
    std::size_t count_ = 0;
    std::vector<std::vector<ContactBlock>> steps_;  // spare lanes of the last block repeat its last point
};

struct PassReport {
    double queries = 0;  // points times steps
    double asked = 0;    // of which the collider
};

// answers, if wanted: [step * count + point]; what slack spared is said to be at infinity.
PassReport run_pass(const PassPoints& points, const Collider& collider, ContactWay way, float offset,
                    std::vector<Contact>* answers = nullptr);

}  // namespace selvedge

#include "bench/contact_pass.h"

#include <algorithm>
#include <limits>

#include "bench/timing.h"

namespace selvedge {
namespace {

const Contact kSpared{std::numeric_limits<float>::infinity(), Vec3f::Zero()};

Contact answer_in(const ContactBlock& block, std::size_t lane) {
    return {block.distance[lane], {block.nx[lane], block.ny[lane], block.nz[lane]}};
}

// What is known of each point since it was asked last.
struct Known {
    explicit Known(std::size_t count) : x(count), y(count), z(count), slack(count, -1.0F) {}

    std::vector<float> x, y, z;  // where, m
    std::vector<float> slack;    // m it may move before it can touch

    bool spares(std::size_t i, const ContactBlock& block, std::size_t lane) const {
        const float dx = block.x[lane] - x[i];
        const float dy = block.y[lane] - y[i];
        const float dz = block.z[lane] - z[i];
        return (slack[i] > 0) & (dx * dx + dy * dy + dz * dz < slack[i] * slack[i]);
    }
    void learn(std::size_t i, const ContactBlock& block, std::size_t lane, float surely_free) {
        x[i] = block.x[lane];
        y[i] = block.y[lane];
        z[i] = block.z[lane];
        slack[i] = block.distance[lane] - surely_free;
    }
};

class Pass {
 public:
    Pass(const PassPoints& points, const Collider& collider, float offset)
        : points_(points),
          collider_(collider),
          offset_(offset),
          known_(points.count()),
          work_(points.count() / kContactLanes + 1),
          active_(points.count() + 1) {}

    void step_one_by_one(const std::vector<ContactBlock>& asked, Contact* answers) {
        for (std::size_t i = 0; i < points_.count(); ++i) {
            const Contact contact = collider_.contact(asked[i / kContactLanes].point(i % kContactLanes));
            keep(contact);
            if (answers) answers[i] = contact;
        }
    }

    void step_in_blocks(const std::vector<ContactBlock>& asked, Contact* answers) {
        for (std::size_t b = 0; b < asked.size(); ++b) {
            work_[b].x = asked[b].x;
            work_[b].y = asked[b].y;
            work_[b].z = asked[b].z;
        }
        collider_.contacts({work_.data(), asked.size()}, offset_);
        keep(work_);
        if (!answers) return;
        for (std::size_t i = 0; i < points_.count(); ++i)
            answers[i] = answer_in(work_[i / kContactLanes], i % kContactLanes);
    }

    // Returns how many were asked.
    std::size_t step_with_slack(const std::vector<ContactBlock>& asked, Contact* answers) {
        const std::size_t count = list_active(asked);
        for (std::size_t k = 0; k < count; ++k) {
            const Vec3f p = asked[active_[k] / kContactLanes].point(active_[k] % kContactLanes);
            work_[k / kContactLanes].set_point(k % kContactLanes, p);
        }
        collider_.contacts({work_.data(), (count + kContactLanes - 1) / kContactLanes}, offset_);
        const float surely_free = offset_ + collider_.max_error();
        for (std::size_t k = 0; k < count; ++k)
            known_.learn(active_[k], work_[k / kContactLanes], k % kContactLanes, surely_free);
        if (!answers) return count;
        std::fill_n(answers, points_.count(), kSpared);
        for (std::size_t k = 0; k < count; ++k)
            answers[active_[k]] = answer_in(work_[k / kContactLanes], k % kContactLanes);
        return count;
    }

 private:
    std::size_t list_active(const std::vector<ContactBlock>& asked) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < points_.count(); ++i) {
            active_[count] = std::uint32_t(i);
            count += !known_.spares(i, asked[i / kContactLanes], i % kContactLanes);
        }
        return count;
    }

    const PassPoints& points_;
    const Collider& collider_;
    float offset_;
    Known known_;
    std::vector<ContactBlock> work_;
    std::vector<std::uint32_t> active_;
};

}  // namespace

PassPoints::PassPoints(const ClothPoints& points) {
    for (const std::vector<Vec3f>& x : points.x) {
        count_ = x.size();
        std::vector<ContactBlock>& blocks = steps_.emplace_back((x.size() + kContactLanes - 1) / kContactLanes);
        for (std::size_t i = 0; i < blocks.size() * kContactLanes; ++i) {
            blocks[i / kContactLanes].set_point(i % kContactLanes, x[std::min(i, x.size() - 1)]);
        }
    }
}

PassReport run_pass(const PassPoints& points, const Collider& collider, ContactWay way, float offset,
                    std::vector<Contact>* answers) {
    Pass pass(points, collider, offset);
    if (answers) answers->assign(points.steps().size() * points.count(), kSpared);
    PassReport report;
    for (std::size_t step = 0; step < points.steps().size(); ++step) {
        Contact* to = answers ? &(*answers)[step * points.count()] : nullptr;
        const std::vector<ContactBlock>& asked = points.steps()[step];
        report.queries += double(points.count());
        report.asked += double(points.count());
        switch (way) {
            case ContactWay::OneByOne:
                pass.step_one_by_one(asked, to);
                break;
            case ContactWay::InBlocks:
                pass.step_in_blocks(asked, to);
                break;
            case ContactWay::WithSlack:
                report.asked -= double(points.count() - pass.step_with_slack(asked, to));
                break;
        }
    }
    return report;
}

}  // namespace selvedge

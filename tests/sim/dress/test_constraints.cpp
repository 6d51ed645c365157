// Constraints that are added to a dressing, from the first seam to a body that moves.
#include <gtest/gtest.h>
#include <memory>
#include <utility>
#include <vector>

#include "sim/dress/dressing.h"
#include "sim/dress/motion_run.h"
#include "tests/sim/dress/shapes.h"
#include "tests/support/bodies.h"

namespace selvedge::sim::test {
namespace {

class CountedConstraint : public ClothConstraint {
 public:
    explicit CountedConstraint(std::shared_ptr<int> solved) : solved_(std::move(solved)) {}
    std::unique_ptr<ClothConstraint> copy() const override { return std::make_unique<CountedConstraint>(*this); }
    void make(const Cloth&) override {}
    void solve(float*, const float*) override { ++*solved_; }

 private:
    std::shared_ptr<int> solved_;
};

TEST(Dressing, solves_an_added_constraint_while_it_sews_and_drapes_and_while_the_body_moves_and_lets_the_cloth_rest) {
    const auto solved = std::make_shared<int>(0);
    Dressing dressing;
    dressing.add_constraint(std::make_unique<CountedConstraint>(solved));
    dressing.set_options({.max_level = 1, .max_seconds = 60, .may_rest = true});
    const auto body = std::make_shared<const Body>(shapes::box(Vec3d(-0.1, 0, -0.06), Vec3d(0.1, 1.4, 0.06), 12));
    dressing.set_body(body);
    dressing.set_pattern(tube(0.36, 0.3, 0.8, 0.15));
    dressing.sew();
    while (dressing.stage() == DressingStage::Sew) dressing.advance();
    const int sewing = *solved;
    EXPECT_GT(sewing, 0);
    while (dressing.stage() != DressingStage::Done) dressing.advance();
    const int draping = *solved - sewing;
    EXPECT_GT(draping, 0);
    EXPECT_TRUE(dressing.result().settled);
    Simulation moving = dressing.drape().simulation;
    MotionRun run(moving, *body, [&](double, const Region&, std::vector<Vec3f>& x) {
        x.clear();
        for (const Vec3d& p : body->x) x.push_back(p.cast<float>());
    });
    run.advance_to(moving, 0.1);
    EXPECT_GT(*solved - sewing - draping, 0);
}

}  // namespace
}  // namespace selvedge::sim::test

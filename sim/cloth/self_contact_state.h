#pragma once
// Holds the contact of a cloth with itself within SolverState, so that who includes Cloth need not know it.
#include <memory>

namespace selvedge::sim {

struct SelfContactState;  // sim/cloth/contact_surface.h

// A value: copies are deep.
class SelfContactHolder {
 public:
    SelfContactHolder();
    SelfContactHolder(const SelfContactHolder& other);
    SelfContactHolder(SelfContactHolder&& other) noexcept;
    SelfContactHolder& operator=(const SelfContactHolder& other);
    SelfContactHolder& operator=(SelfContactHolder&& other) noexcept;
    ~SelfContactHolder();

    SelfContactState* operator->() { return state_.get(); }
    const SelfContactState* operator->() const { return state_.get(); }
    SelfContactState& operator*() { return *state_; }

 private:
    std::unique_ptr<SelfContactState> state_;  // null only after it was moved from
};

}  // namespace selvedge::sim

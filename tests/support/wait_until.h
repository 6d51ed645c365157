#pragma once
// Waits for what another CPU thread or another program does: polls a condition until a deadline. A test says what it
// waits for, so it takes no longer than necessary, and a slow machine does not make it fail.
#include <gtest/gtest.h>
#include <chrono>
#include <thread>

namespace selvedge {

// Whether `holds` returns true within the limit: EXPECT_TRUE(wait_until([&] { return ...; })).
template <class Condition>
[[nodiscard]] testing::AssertionResult wait_until(const Condition& holds,
                                                  std::chrono::milliseconds limit = std::chrono::seconds(90)) {
    const auto end = std::chrono::steady_clock::now() + limit;
    while (!holds()) {
        if (std::chrono::steady_clock::now() > end) {
            return testing::AssertionFailure() << "did not become true within " << limit.count() << " ms";
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return testing::AssertionSuccess();
}

}  // namespace selvedge
